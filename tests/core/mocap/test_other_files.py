"""Whatever is not read is named, with the way to convert it: in folders, zip files and uploads."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path

import pytest

from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.other_files import in_words, left_out_files, what_it_is
from core.mocap.readers import FORMATS
from core.mocap.recordings import find_left_out
from core.progress import silent
from core.workspace import Workspace, WorkspaceError
from core.workspace.archives import unpack_archives
from tests.core.mocap import samples
from webapp.cli import main


@pytest.fixture
def folder(tmp_path) -> Path:
    folder = tmp_path / "takes"
    (folder / "more").mkdir(parents=True)
    (folder / "walk.bvh").write_text(samples.BVH)
    for name in ("a.fbx", "b.FBX", "more/c.fbx", "dance.vmd", "more/notes.txt", ".hidden.fbx", "labels.csv", "a.asf"):
        (folder / name).write_bytes(b"x")
    return folder


def test_files_are_named_by_format_with_the_way_to_convert_them(folder):
    words = in_words(find_left_out(folder))
    assert words.startswith("3 FBX (a.fbx, b.FBX, c.fbx), 1 VMD (dance.vmd), 1 other file (notes.txt) left out: ")
    assert "FBX: open it in Blender and export BVH" in words and "VMD: " in words and "hidden" not in words
    assert in_words(()) == "" and find_left_out(folder / "walk.bvh") == ()
    many = left_out_files([f"{k}.abc.gz" for k in range(9)], FORMATS)
    assert in_words(many).startswith("9 Alembic (0.abc.gz, 1.abc.gz, 2.abc.gz, ...) left out")
    assert "this is pickle" in what_it_is("a.pkl") and what_it_is("a.xyz") == ""


def test_a_folder_is_read_and_what_is_left_out_stands_in_the_report(folder, tmp_path):
    (message,) = open_dataset(folder, labels=None, on_error="report").report.messages
    assert message.startswith("3 FBX") and "1 VMD" in message and "notes" not in message
    workspace = Workspace(tmp_path / "space")
    report = workspace.import_dataset("a", folder)
    left = {file.path: file for file in report.files if file.clip is None and "left out" in " ".join(file.messages)}
    assert left["a.fbx and 2 more"].verdict == left["dance.vmd"].verdict == "warning"
    assert left["more/notes.txt"].verdict == "ok"


def test_several_files_are_read_although_one_is_of_another_kind(folder):
    dataset = open_dataset([folder / "a.fbx", folder / "walk.bvh"])
    assert dataset.names == ("walk",) and "1 FBX" in dataset.report.messages[0]
    with pytest.raises(RecordingError, match=r"a\.fbx: not a recording: this is FBX; open it in Blender"):
        open_dataset(folder / "a.fbx")
    (folder / "walk.bvh").unlink()
    with pytest.raises(RecordingError, match=r"no recordings in this folder \(3 FBX"):
        open_dataset(folder)


def test_a_dataset_is_named_after_recordings(folder, tmp_path, capsys):
    space = str(tmp_path / "space")
    assert main.main(["import", space, str(folder / "a.fbx"), str(folder / "walk.bvh")]) == 0
    assert [info.name for info in Workspace(space).datasets()] == ["walk"]
    assert "1 FBX (a.fbx) left out: FBX: open it in Blender" in capsys.readouterr().err


def test_inspect_names_them_too(folder, capsys):
    assert main.main(["inspect", "--json", "--quiet", str(folder / "more"), str(folder / "walk.bvh")]) == 0
    document = json.loads(capsys.readouterr().out)
    assert [(group["format"], len(group["files"])) for group in document["left_out"]] == [("FBX", 1), ("", 1)]
    assert document["messages"][0].startswith("1 FBX (c.fbx), 1 other file (notes.txt) left out")
    assert main.main(["inspect", str(folder / "a.fbx")]) == 2
    assert "this is FBX" in capsys.readouterr().out
    assert main.main(["inspect", str(folder)]) == 2  # the skeleton a.asf is none
    assert "3 FBX (a.fbx" in capsys.readouterr().out


def test_zip_files_name_what_is_not_read(folder, tmp_path):
    upload = tmp_path / "upload"
    upload.mkdir()
    with zipfile.ZipFile(upload / "all.zip", "w") as archive:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                archive.write(path, path.relative_to(folder))
    (report,) = unpack_archives(upload, silent)
    assert report.verdict == "warning" and report.messages[0].startswith("3 FBX (a.fbx, b.FBX, c.fbx), 1 VMD")
    with zipfile.ZipFile(upload / "none.zip", "w") as archive:
        archive.writestr("scene.fbx", b"x")
    (report,) = unpack_archives(upload, silent)
    assert report.verdict == "error" and "FBX: open it in Blender" in report.messages[0]


def test_an_upload_without_recordings_says_what_it_holds(tmp_path):
    workspace = Workspace(tmp_path / "space")
    token = workspace.uploads.create()
    workspace.uploads.add(token, "scene.fbx", [b"x"])
    with pytest.raises(WorkspaceError, match="no recording among these files: 1 FBX"):
        workspace.import_upload("a", token)


def test_names_in_a_zip_that_are_not_utf_8(tmp_path):
    """Without the mark for UTF-8 they are read as old programs wrote them; with it the zip is refused in words."""
    content = samples.BVH.encode()
    with zipfile.ZipFile(tmp_path / "good.zip", "w") as archive:
        archive.writestr("gehen.bvh", content)
        archive.writestr("g\u00e4hen.bvh", content)
    raw = (tmp_path / "good.zip").read_bytes()
    broken = raw.replace("g\u00e4hen.bvh".encode(), b"g\xe4\xffhen.bvh")
    assert broken != raw and len(broken) == len(raw)
    (tmp_path / "good.zip").write_bytes(broken)
    (report,) = unpack_archives(tmp_path, silent)
    assert report.verdict == "error" and "not in UTF-8" in report.messages[0]
    plain = broken
    for signature, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        at = plain.find(signature)
        while at >= 0:
            plain = plain[: at + flags + 1] + bytes([plain[at + flags + 1] & ~8]) + plain[at + flags + 2 :]
            at = plain.find(signature, at + 4)
    (tmp_path / "old.zip").write_bytes(plain)
    (tmp_path / "good.zip").unlink()
    (report,) = unpack_archives(tmp_path, silent)
    assert report.verdict == "ok" and report.messages == ("2 files unpacked",)
    assert len(list((tmp_path / "old").glob("*.bvh"))) == 2
