"""Files and folders that appear whole or not at all."""

from __future__ import annotations

import os

import pytest

from core.mocap.files import atomic_file, replacing, sweep_abandoned


def test_a_file_takes_its_place_only_when_whole(tmp_path):
    path = tmp_path / "deep" / "one.txt"
    with atomic_file(path) as file:
        file.write(b"first")
        assert not path.exists()
    with pytest.raises(RuntimeError), atomic_file(path) as file:
        file.write(b"second")
        raise RuntimeError
    assert path.read_bytes() == b"first"
    assert list(path.parent.iterdir()) == [path]


def test_a_folder_takes_the_place_of_another(tmp_path):
    path = tmp_path / "clips"
    for name in ("a", "b"):
        with replacing(path) as folder:
            folder.mkdir()
            (folder / name).touch()
    with pytest.raises(RuntimeError), replacing(path) as folder:
        folder.mkdir()
        raise RuntimeError
    assert names(path) == ["b"] and names(tmp_path) == ["clips"]


def test_a_pipe_and_a_link_stay_what_they_are(tmp_path):
    pipe, link = tmp_path / "pipe", tmp_path / "link"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    with atomic_file(pipe) as file:
        file.write(b"through")
    assert os.read(reader, 20) == b"through" and pipe.is_fifo()
    os.close(reader)
    link.symlink_to(tmp_path / "aim")
    with atomic_file(link) as file:
        file.write(b"behind")
    assert link.is_symlink() and (tmp_path / "aim").read_bytes() == b"behind"


def test_an_error_names_the_file_that_was_asked_for(tmp_path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(OSError, match="Is a directory") as told, atomic_file(tmp_path / "taken") as file:
        file.write(b"x")
    assert told.value.filename == str(tmp_path / "taken")
    assert names(tmp_path) == ["taken"]


def test_what_a_killed_writer_left_is_swept(tmp_path):
    writers = [replacing(tmp_path / kind) for kind in ("file", "folder")]
    file, folder = (writer.__enter__() for writer in writers)
    file.touch()
    folder.mkdir()
    assert sweep_abandoned(tmp_path) == 0 and len(names(tmp_path)) == 2
    assert sweep_abandoned(tmp_path, older_than=-1) == 2 and names(tmp_path) == []


def names(folder):
    return sorted(path.name for path in folder.iterdir())
