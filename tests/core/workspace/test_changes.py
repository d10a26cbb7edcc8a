"""Recordings and labels that come to a data set later, clips that go, and how each change is undone."""

from __future__ import annotations

import io
import json
import stat
import zipfile
from pathlib import Path

import pytest

from core import analyses
from core.mocap.bvh import write_bvh
from core.mocap.clip import Label
from core.progress import Cancelled
from core.workspace import Workspace, WorkspaceError, archives
from core.workspace.datasets import is_version
from tests.toy_method import make_dataset, request


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    """A workspace with the data set "toy": clips walk_0 and walk_1, one label."""
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset())
    return workspace


@pytest.fixture
def recordings(tmp_path: Path) -> Path:
    """A folder with walk_0.bvh and walk_1.bvh, other motions than those of "toy"."""
    folder = tmp_path / "recordings"
    folder.mkdir()
    for clip in make_dataset(seed=5).clips:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    return folder


def upload(workspace: Workspace, **files: bytes) -> str:
    """An upload of these files; double underscores stand for dots."""
    token = workspace.uploads.create()
    for name, content in files.items():
        workspace.uploads.add(token, name.replace("__", "."), [content])
    return token


def packed(**files: bytes | str) -> bytes:
    """A zip of files; in their names double underscores stand for dots."""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name.replace("__", "."), content)
    return memory.getvalue()


def files_of(workspace: Workspace) -> set[str]:
    """Names of the data set folders on disk."""
    return {path.name for path in (workspace.path / "datasets").iterdir()}


def test_removed_clips_come_back_with_their_results(workspace):
    before = workspace.info("toy")
    result = analyses.run(workspace, request())
    assert workspace.last_version("toy") is None
    undo = workspace.version("toy")
    workspace.remove_clips("toy", ["walk_0"])
    assert workspace.last_version("toy") == undo
    left = workspace.open("toy")
    assert left.names == ("walk_1",) and left.labels == ()
    assert [file.clip for file in left.report.files] == ["walk_1"]
    assert analyses.stored(workspace, request()) is None  # of other content
    (version,) = workspace.trashed()
    assert is_version(version) and version.id == undo and version.fingerprint == before.fingerprint
    assert workspace.open_fingerprint(before.fingerprint).names == ("walk_0", "walk_1")  # for jobs that still run
    workspace.revert(undo)
    assert workspace.open("toy").names == ("walk_0", "walk_1") and workspace.open("toy").labels
    assert workspace.info("toy").id == before.id and analyses.stored(workspace, request()) == result
    (version,) = workspace.trashed()
    workspace.revert(version.id)  # and undone is undone
    assert workspace.open("toy").names == ("walk_1",)


def test_only_the_last_version_is_kept_and_can_become_a_data_set(workspace, recordings):
    workspace.add_files("toy", recordings)
    first = workspace.trashed()[0].id
    workspace.rename("toy", "grown")
    workspace.remove_clips("grown", ["walk_0 (2)"])
    (version,) = workspace.trashed()
    assert version.name == "grown" and version.clips == 4 and len(files_of(workspace)) == 2
    with pytest.raises(WorkspaceError, match="no longer there"):
        workspace.revert(first)
    assert workspace.restore(version.id).name == "grown 2"
    assert not is_version(workspace.info("grown 2"))
    workspace.trash("grown 2")
    workspace.remove_clips("grown", ["walk_1 (2)"])
    assert sorted(info.clips for info in workspace.trashed()) == [3, 4]  # a data set of its own stays
    workspace.trash("grown")
    with pytest.raises(WorkspaceError, match="no longer there"):
        workspace.revert(next(info.id for info in workspace.trashed() if is_version(info)))
    assert workspace.empty_trash() == 3 and files_of(workspace) == set()


def test_versions_are_known_when_the_table_is_lost(workspace):
    undo = workspace.version("toy")
    workspace.remove_clips("toy", ["walk_0"])
    before = workspace.datasets(), workspace.trashed()
    workspace.close()
    for path in workspace.path.glob("workspace.sqlite*"):
        path.unlink()
    again = Workspace(workspace.path)
    assert (again.datasets(), again.trashed()) == before
    assert again.revert(undo).clips == 2


def test_of_two_changes_at_once_one_is_refused(workspace, recordings):
    def meanwhile(stage, _fraction):
        if stage == "Inspecting" and workspace.info("toy").clips == 2:
            workspace.remove_clips("toy", ["walk_0"])

    with pytest.raises(WorkspaceError, match="changed or deleted meanwhile"):
        workspace.add_files("toy", recordings, report=meanwhile)
    assert workspace.open("toy").names == ("walk_1",) and len(files_of(workspace)) == 2


def test_added_twice_is_there_once(workspace, recordings):
    workspace.add_files("toy", recordings)
    first = workspace.report("toy")
    assert first.last_addition == 1
    came = {"walk_0": 0, "walk_1": 0, "walk_0 (2)": 1, "walk_1 (2)": 1}
    assert {file.clip: file.addition for file in first.files} == came
    clip = make_dataset(seed=6).clips[0]
    with pytest.raises(WorkspaceError, match="Nothing was added: toy has all of these"):
        workspace.add_files("toy", recordings)
    write_bvh(recordings / "new.bvh", clip)
    report = workspace.add_files("toy", recordings)
    assert set(workspace.open("toy").names) == {"walk_0", "walk_1", "walk_0 (2)", "walk_1 (2)", "new"}
    came = {file.path: file for file in report.files if file.addition == 2}
    assert "left out" in came["walk_0.bvh"].messages[0] and came["new.bvh"].clip == "new"


def test_labels_beside_added_recordings_are_meant_for_them(workspace, recordings):
    (recordings / "any name.csv").write_text("clip,start_frame,end_frame,action\nwalk_0,0,5,jump\ntoy,1,2,x\n")
    report = workspace.add_files("toy", recordings)
    assert set(workspace.open("toy").labels) == {Label("walk_0", 0, 10, "walk"), Label("walk_0 (2)", 0, 5, "jump")}
    (told,) = [file for file in report.files if file.path == "any name.csv"]
    assert told.verdict == "warning" and "toy (line 3)" in told.messages[1]


@pytest.mark.parametrize("replace", [False, True])
def test_labels_alone_change_no_content(workspace, tmp_path, replace):
    result = analyses.run(workspace, request())
    before, undo = workspace.info("toy"), workspace.version("toy")
    folder = workspace.path / "datasets" / before.folder
    (tmp_path / "a.csv").write_text(
        "clip,start_frame,end_frame,action\nwalk_0,0,10,walk\nwalk_1,3,400,sit\nwalk_1,90,95,x\ngone,1,2,x\nwalk_1,a,3,x\n"
    )
    report = workspace.add_labels("toy", tmp_path / "a.csv", replace=replace)
    after = workspace.info("toy")
    assert after.fingerprint == before.fingerprint and analyses.stored(workspace, request()) == result
    assert (workspace.path / "datasets" / after.folder / "motion.npy").samefile(folder / "motion.npy")
    assert workspace.open("toy").labels == (Label("walk_0", 0, 10, "walk"), Label("walk_1", 3, 41, "sit"))
    (told,) = [file for file in report.files if file.addition]
    assert told.path == "a.csv" and told.verdict == "warning"
    words = " ".join(told.messages)
    assert "2 labels of 2 clips" in words and "a.csv:3: sit in walk_1 ends at frame 400 of 41: cut" in words
    assert "a.csv:4: x in walk_1 starts at frame 90" in words and "gone (line 5)" in words and "a.csv:6: 'a'" in words
    (tmp_path / "b.csv").write_text("clip,action\nwalk_1,dance\n")
    workspace.add_labels("toy", tmp_path / "b.csv", replace=replace)
    assert len(workspace.open("toy").labels) == (1 if replace else 3)
    assert workspace.empty_trash() == 1
    assert workspace.open("toy").clip("walk_1").rotations[5, 0, 0] == 1  # the numbers are still there
    with pytest.raises(WorkspaceError, match="no longer there"):
        workspace.revert(undo)


def test_a_data_set_stored_by_an_older_version_is_read_and_changed(workspace, tmp_path):
    head = workspace.path / "datasets" / workspace.info("toy").folder / "dataset.json"
    document = json.loads(head.read_text())
    for file in document["report"]["files"]:
        del file["addition"]
    head.write_text(json.dumps(document))
    (tmp_path / "a.csv").write_text("clip,action\nwalk_1,sit\n")
    again = Workspace(workspace.path)
    assert [file.addition for file in again.report("toy").files] == [0, 0]
    assert again.add_labels("toy", tmp_path / "a.csv").last_addition == 1


def test_labels_that_do_not_fit_change_nothing(workspace, tmp_path):
    (tmp_path / "a.csv").write_text("clip,start_frame,end_frame,action\nother,0,10,walk\n")
    (tmp_path / "b.csv").write_text("x,y\n1,2\n")
    none = r"cannot be used: a\.csv: no label in it fits these clips; one clip .*other \(line 2\)"
    for name, words in (("a.csv", none), ("b.csv", "cannot be used: b.csv:1: columns 'x, y'")):
        with pytest.raises(WorkspaceError, match=words):
            workspace.add_labels("toy", tmp_path / name)
    assert len(files_of(workspace)) == 1 and len(workspace.open("toy").labels) == 1


def test_an_upload_adds_recordings_labels_or_both(workspace, recordings):
    labels = b"clip,start_frame,end_frame,action\nwalk_1,0,3,turn\n"
    token = upload(workspace, labels__csv=labels)
    workspace.add_upload("toy", token)
    assert workspace.info("toy").labels == 2
    token = upload(
        workspace, fresh__bvh=(recordings / "walk_1.bvh").read_bytes(), more__csv=b"clip,action\nfresh,run\n"
    )
    workspace.add_upload("toy", token, replace_labels=True)
    dataset = workspace.open("toy")
    assert dataset.names[-1] == "fresh" and [label.action for label in dataset.labels] == ["run"]
    assert list((workspace.path / "uploads").iterdir()) == []
    with pytest.raises(WorkspaceError, match="no labels in these files"):
        workspace.add_upload("toy", upload(workspace, bones__asf=b"x"))
    with pytest.raises(WorkspaceError, match="no recording among these files"):
        workspace.import_upload("new", upload(workspace, labels__csv=labels))


def test_a_zip_is_unpacked_and_told(workspace, recordings):
    good = (recordings / "walk_0.bvh").read_bytes()
    content = packed(
        **{"in/a__bvh": good, "in/b__bvh": b"nonsense", "in/index__csv": "clip,content,take\na,stroll,1\n"},
        **{"__MACOSX/._a__bvh": b"x", "readme__pdf": "hello", "more__zip": b"PK", "../evil__bvh": good},
    )
    report = workspace.import_upload("zipped", upload(workspace, walks__zip=content))
    told = {file.path: file for file in report.files}
    assert set(told) == {"walks.zip", "walks/in/a.bvh", "walks/in/b.bvh", "walks/in/index.csv"}
    assert told["walks/in/b.bvh"].verdict == "error"
    words = " ".join(told["walks.zip"].messages)
    assert "3 files unpacked" in words and "more.zip" in words and "../evil.bvh" in words
    assert workspace.open("zipped").labels == (Label("a", 0, 40, "stroll"),)
    assert not list(workspace.path.parent.rglob("evil.bvh"))


def test_names_that_become_equal_do_not_hide_one_another(workspace, recordings):
    good = [(recordings / f"walk_{k}.bvh").read_bytes() for k in (0, 1)]
    workspace.import_upload("zipped", upload(workspace, a__zip=packed(**{"a*b__bvh": good[0], "A?b__bvh": good[1]})))
    assert workspace.info("zipped").clips == 2


def test_links_are_never_followed(workspace, recordings, tmp_path):
    (tmp_path / "secret.bvh").write_bytes((recordings / "walk_0.bvh").read_bytes())
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w") as archive:
        link = zipfile.ZipInfo("link.bvh")
        link.external_attr = (stat.S_IFLNK | 0o777) << 16
        archive.writestr(link, str(tmp_path / "secret.bvh"))
        archive.writestr("a.bvh", (recordings / "walk_1.bvh").read_bytes())
    report = workspace.import_upload("zipped", upload(workspace, a__zip=memory.getvalue()))
    assert workspace.open("zipped").names == ("a",) and "links: link.bvh" in " ".join(report.files[0].messages)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"PK\x03\x04 no zip", "archive is damaged"),
        (packed(a__pdf="x"), "no recording, skeleton or CSV file in it"),
        (packed(**{f"{k}__bvh": "x" for k in range(4)}), "holds 4 recordings; an upload takes at most 3"),
        (packed(a__bvh="0" * 3_000_000), "grows beyond 1 MB"),
        (packed(a__bvh="HIERARCHY" * 9)[:-40].replace(b"HIER", b"XIER"), "damaged"),
    ],
    ids=("no zip", "no recording", "many", "large", "cut"),  # the bytes hold the time of day
)
def test_bad_archives_are_refused_in_plain_words(workspace, monkeypatch, content, words):
    monkeypatch.setattr(archives, "MAX_FILES", 3)
    monkeypatch.setattr(archives, "_FREE", 1 << 20)
    monkeypatch.setattr(archives, "_TIMES", 1)
    token = upload(workspace, a__zip=content)
    with pytest.raises(WorkspaceError, match=words):
        workspace.import_upload("zipped", token)
    assert [path.name for path in workspace.uploads.path(token).iterdir()] == ["a.zip"]
    assert len(workspace.datasets()) == 1


def test_a_locked_archive_is_said(workspace):
    content = bytearray(packed(a__bvh="x"))
    for mark, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        content[content.index(mark) + flags] |= 1
    with pytest.raises(WorkspaceError, match="password"):
        workspace.import_upload("zipped", upload(workspace, a__zip=bytes(content)))


def test_unpacking_can_be_cancelled(workspace, recordings):
    content = packed(**{f"{k}__bvh": (recordings / "walk_0.bvh").read_bytes() for k in range(3)})

    def cancel(stage, fraction):
        if stage == "Unpacking" and fraction > 0:
            raise Cancelled

    with pytest.raises(Cancelled):
        workspace.import_upload("zipped", upload(workspace, a__zip=content), report=cancel)
    assert len(workspace.datasets()) == 1
