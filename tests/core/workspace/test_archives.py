"""Hostile and damaged zip files: what they cost, and what is still taken from them."""

import time
import warnings
import zipfile

import pytest

from core.progress import silent
from core.workspace.archives import unpack_archives


def packed(path, names, content=b"x"):
    with zipfile.ZipFile(path, "w") as archive:
        for name in names:
            archive.writestr(name, content)


def test_the_files_of_an_archive_cost_microseconds_before_they_are_unpacked(tmp_path):
    for name, names in {"many.zip": (f"{k}.bvh" for k in range(20_000)), "same.zip": ["a.bvh"] * 20_000}.items():
        with warnings.catch_warnings(action="ignore"):
            packed(tmp_path / name, names)
    begin = time.process_time()
    reports = unpack_archives(tmp_path, silent)
    assert time.process_time() - begin < 20  # it were minutes where each name cost a list of all numbers
    assert all("at most" in report.messages[0] for report in reports)


def test_files_of_one_name_get_numbered_folders(tmp_path):
    with pytest.warns(UserWarning):
        packed(tmp_path / "a.zip", ["x.bvh", "x.bvh", "2/x.bvh", "X.bvh"])
    unpack_archives(tmp_path, silent)
    assert {p.relative_to(tmp_path / "a").as_posix() for p in (tmp_path / "a").rglob("*.*")} == {
        *("x.bvh", "2/x.bvh", "2/2/x.bvh", "3/X.bvh")
    }


def test_the_good_files_of_a_damaged_archive_are_taken(tmp_path):
    packed(tmp_path / "a.zip", ["one.bvh", "two.bvh", "three.bvh"], b"CONTENT" * 10)
    data = bytearray((tmp_path / "a.zip").read_bytes())
    data[data.index(b"CONTENT", data.index(b"two.bvh"))] ^= 0xFF  # one byte of the second file
    (tmp_path / "a.zip").write_bytes(data)
    (report,) = unpack_archives(tmp_path, silent)
    assert report.verdict == "warning" and any("two.bvh" in message for message in report.messages)
    assert "2 files unpacked" in report.messages
    assert sorted(path.name for path in (tmp_path / "a").iterdir()) == ["one.bvh", "three.bvh"]


def test_an_archive_without_a_whole_file_is_refused(tmp_path):
    packed(tmp_path / "a.zip", ["one.bvh"], b"CONTENT" * 10)
    data = bytearray((tmp_path / "a.zip").read_bytes())
    data[data.index(b"CONTENT")] ^= 0xFF
    (tmp_path / "a.zip").write_bytes(data)
    (report,) = unpack_archives(tmp_path, silent)
    assert report.verdict == "error" and "damaged" in report.messages[0]
    assert not (tmp_path / "a").exists()
