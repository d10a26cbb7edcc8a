"""Data sets of a workspace: import, names, trash, changes, what happens to damaged ones."""

import multiprocessing
import os
import shutil
from dataclasses import replace

import numpy as np
import pytest

from core.mocap.bvh import write_bvh
from core.mocap.errors import RecordingError
from core.progress import Cancelled
from core.workspace import NameRefused, Workspace, WorkspaceError, is_workspace, shared_workspace
from tests.toy_method import make_dataset


@pytest.fixture
def workspace(tmp_path):
    return Workspace(tmp_path / "space")


@pytest.fixture
def recordings(tmp_path):
    folder = tmp_path / "recordings"
    (folder / "sub").mkdir(parents=True)
    for clip in make_dataset().clips:
        write_bvh(folder / "sub" / f"{clip.name}.bvh", clip)
    return folder


def test_a_workspace_is_a_folder_with_its_parts(workspace, tmp_path):
    parts = {path.name for path in workspace.path.iterdir()}
    assert {"datasets", "results", "uploads", "trash", "workspace.sqlite"} <= parts
    assert is_workspace(workspace.path) and not is_workspace(tmp_path)
    assert shared_workspace(workspace.path) is shared_workspace(str(workspace.path) + "/../space")
    (tmp_path / "file").write_text("x")
    with pytest.raises(WorkspaceError, match="is a file"):
        Workspace(tmp_path / "file")
    with pytest.raises(WorkspaceError, match="no workspace"):
        Workspace(tmp_path, create=False)


def test_an_import_reads_what_it_can_and_keeps_its_report(workspace, recordings):
    (recordings / "bad.bvh").write_text("HIERARCHY\nnonsense")
    (recordings / "labels.csv").write_text("clip,start_frame,end_frame,action\nwalk_0,0,10,walk\n")
    stages = set()
    report = workspace.import_dataset("Läufe", recordings, report=lambda stage, _: stages.add(stage))
    verdicts = {file.path: file.verdict for file in report.files}
    assert verdicts["bad.bvh"] == "error" and set(verdicts) == {
        *("bad.bvh", "labels.csv", "sub/walk_0.bvh", "sub/walk_1.bvh")
    }
    assert stages
    (info,) = workspace.datasets()
    assert (info.name, info.clips, info.frames, info.labels, info.errors) == ("Läufe", 2, 81, 1, 1)
    assert info.seconds == pytest.approx(81 / 30, rel=1e-3)
    again = Workspace(workspace.path)
    assert again.report("Läufe") == report
    dataset = again.open("Läufe")
    assert dataset.fingerprint == info.fingerprint and dataset.name == "Läufe"
    assert again.open_fingerprint(info.fingerprint).names == dataset.names


def test_what_is_opened_twice_is_mapped_once(workspace):
    workspace.add_dataset("one", make_dataset())
    first, second = workspace.open("one"), workspace.open("one")
    assert np.shares_memory(first.clips[0].rotations, second.clips[0].rotations)


def test_nothing_is_left_where_no_file_can_be_read(workspace, tmp_path):
    bad = tmp_path / "bad"
    bad.mkdir()
    (bad / "a.bvh").write_bytes(b"")
    (bad / "b.bvh").write_bytes(b"\0" * 100)
    with pytest.raises(WorkspaceError, match=r"None of the 2 files can be read: a\.bvh"):
        workspace.import_dataset("bad", bad)
    (tmp_path / "empty").mkdir()
    with pytest.raises((WorkspaceError, RecordingError)):
        workspace.import_dataset("bad", tmp_path / "empty")
    with pytest.raises(WorkspaceError, match="Nothing to import"):
        workspace.import_dataset("bad", [])
    with pytest.raises(WorkspaceError, match="no clips"):
        workspace.add_dataset("bad", replace(make_dataset(), clips=(), labels=(), digests=()))
    assert workspace.datasets() == [] and list((workspace.path / "datasets").iterdir()) == []


def test_an_import_that_is_cancelled_leaves_nothing(workspace, recordings):
    def cancel(_stage, _fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        workspace.import_dataset("one", recordings, report=cancel)
    assert workspace.datasets() == [] and list((workspace.path / "datasets").iterdir()) == []


@pytest.mark.parametrize("name", ["../x", "/etc", "a\0b", "", "a/b", "CON"])
def test_a_data_set_is_never_stored_under_a_bad_name(workspace, name):
    with pytest.raises(NameRefused):
        workspace.add_dataset(name, make_dataset())
    workspace.add_dataset("good", make_dataset())
    with pytest.raises(NameRefused):
        workspace.rename("good", name)
    for use in (workspace.open, workspace.info, workspace.report, workspace.trash, workspace.open_fingerprint):
        with pytest.raises(WorkspaceError):
            use(name)
    with pytest.raises(WorkspaceError):
        workspace.restore(name)


def test_names_are_unique_also_when_two_are_stored_at_once(workspace, monkeypatch):
    workspace.add_dataset("one", make_dataset())
    with pytest.raises(NameRefused, match="already"):
        workspace.add_dataset("one", make_dataset(seed=1))
    first_look = iter(["two"])
    real = workspace._datasets.check_free
    monkeypatch.setattr(workspace._datasets, "check_free", lambda name: next(first_look, None) or real(name))
    Workspace(workspace.path).add_dataset("two", make_dataset(seed=2))
    with pytest.raises(NameRefused, match="already"):
        workspace.add_dataset("two", make_dataset(seed=3))
    assert len(list((workspace.path / "datasets").iterdir())) == 2
    assert workspace.free_name("two") == "two 2" and workspace.free_name("../x") == "_x"


def test_renaming_moves_no_data_and_keeps_the_fingerprint(workspace):
    workspace.add_dataset("old", make_dataset())
    before = workspace.info("old")
    opened = workspace.open("old")
    after = workspace.rename("old", "new")
    assert replace(after, name="old") == before
    assert workspace.open("new").clips[0].rotations[3, 1, 0] == opened.clips[0].rotations[3, 1, 0]
    with pytest.raises(WorkspaceError, match=r"no dataset 'old'.*new"):
        workspace.open("old")


def test_trash_can_be_undone_and_emptied(workspace):
    workspace.add_dataset("one", make_dataset())
    opened = workspace.open("one")
    token = workspace.trash("one")
    assert workspace.datasets() == [] and [info.id for info in workspace.trashed()] == [token]
    workspace.add_dataset("one", make_dataset(seed=1))
    assert workspace.restore(token).name == "one 2"
    with pytest.raises(WorkspaceError, match="no longer in the trash"):
        workspace.restore(token)
    workspace.trash("one 2")
    assert workspace.empty_trash() == 1 and workspace.trashed() == []
    assert len(list((workspace.path / "datasets").iterdir())) == 1
    assert list((workspace.path / "trash").iterdir()) == []
    assert np.isfinite(opened.clips[0].root_positions).all()  # who had it open still reads it


def test_clips_can_be_added_and_removed(workspace, recordings):
    workspace.add_dataset("one", make_dataset())
    before = workspace.info("one")
    workspace.add_files("one", recordings)
    grown = workspace.info("one")
    assert set(workspace.open("one").names) == {"walk_0", "walk_1", "walk_0 (2)", "walk_1 (2)"}
    assert grown.id == before.id and grown.fingerprint != before.fingerprint and grown.imported == before.imported
    workspace.remove_clips("one", ["walk_0 (2)", "walk_1 (2)"])
    assert workspace.info("one").fingerprint == before.fingerprint
    assert [label.action for label in workspace.open("one").labels] == ["walk"]
    with pytest.raises(WorkspaceError, match="no clip 'x'"):
        workspace.remove_clips("one", ["x"])
    with pytest.raises(WorkspaceError, match="delete the dataset"):
        workspace.remove_clips("one", ["walk_0", "walk_1"])
    assert len(list((workspace.path / "datasets").iterdir())) == 2  # and what it was before the last change


def test_a_damaged_data_set_is_said_plainly(workspace):
    workspace.add_dataset("one", make_dataset())
    folder = workspace.path / "datasets" / workspace.info("one").folder
    (folder / "motion.npy").write_bytes(b"short")
    with pytest.raises(WorkspaceError, match="import it again"):
        Workspace(workspace.path).open("one")
    shutil.rmtree(folder)
    with pytest.raises(WorkspaceError, match="import it again"):
        Workspace(workspace.path).open("one")


def test_a_data_set_that_is_cut_off_while_it_is_open_ends_no_process(workspace):
    """To read numbers that a mapped file has lost is SIGBUS."""
    workspace.add_dataset("one", make_dataset())
    assert workspace.open("one").n_frames == 81
    motion = workspace.path / "datasets" / workspace.info("one").folder / "motion.npy"
    content = motion.read_bytes()
    os.truncate(motion, 200)
    with pytest.raises(WorkspaceError, match="import it again"):
        workspace.open("one")
    motion.write_bytes(content)
    assert workspace.open("one").n_frames == 81


@pytest.mark.parametrize("damage", ["nan", "deep", "no object"])
def test_a_data_set_of_what_is_no_motion_is_said_plainly(workspace, damage):
    workspace.add_dataset("one", make_dataset())
    folder = workspace.path / "datasets" / workspace.info("one").folder
    if damage == "nan":
        numbers = np.load(folder / "motion.npy")
        numbers[7] = np.nan
        np.save(folder / "motion.npy", numbers)
    else:
        (folder / "dataset.json").write_text("[" * 200_000 + "]" * 200_000 if damage == "deep" else "[]")
    with pytest.raises(WorkspaceError, match="import it again"):
        Workspace(workspace.path).open("one")


def test_data_sets_are_found_again_when_the_table_is_lost(workspace):
    workspace.add_dataset("one", make_dataset())
    workspace.add_dataset("two", make_dataset(seed=1))
    workspace.rename("one", "eins")
    workspace.trash("two")
    before = workspace.datasets(), workspace.trashed()
    workspace.close()
    for path in workspace.path.glob("workspace.sqlite*"):
        path.unlink()
    again = Workspace(workspace.path)
    assert (again.datasets(), again.trashed()) == before


def test_a_data_set_folder_that_is_a_link_is_not_followed(workspace, tmp_path):
    workspace.add_dataset("one", make_dataset())
    folder = workspace.path / "datasets" / workspace.info("one").folder
    shutil.move(folder, tmp_path / "outside")
    folder.symlink_to(tmp_path / "outside")
    with pytest.raises(WorkspaceError):
        Workspace(workspace.path).open("one")
    workspace.trash("one")
    assert workspace.empty_trash() == 1
    assert (tmp_path / "outside" / "motion.npy").is_file()


def test_an_upload_is_imported_and_then_gone(workspace, recordings):
    token = workspace.uploads.create()
    for path in sorted(recordings.rglob("*.bvh")):
        workspace.uploads.add(token, f"a/{path.name}", [path.read_bytes()])
    workspace.uploads.add(token, "my labels.csv", [b"clip,action\nwalk_1,walk\n"])
    with pytest.raises(NameRefused):
        workspace.import_upload("one", token, labels="../../x.csv")
    with pytest.raises(WorkspaceError, match="no file"):
        workspace.import_upload("one", token, skeleton="x.asf")
    report = workspace.import_upload("one", token, labels="my labels.csv")
    assert [file.path for file in report.files] == ["a/walk_0.bvh", "a/walk_1.bvh", "my labels.csv"]
    assert str(workspace.path) not in repr(report)
    assert workspace.info("one").labels == 1
    with pytest.raises(WorkspaceError, match="no longer here"):
        workspace.uploads.path(token)


def _add(path, start, name, seed, failures):
    start.wait()
    try:
        Workspace(path).add_dataset(name, make_dataset(seed=seed))
    except Exception as error:
        failures.put(type(error).__name__)


def test_processes_may_import_at_once_and_one_gets_a_name(workspace):
    context = multiprocessing.get_context("spawn")
    start, failures = context.Event(), context.Queue()
    names = ["same", "same", "other"]
    adders = [context.Process(target=_add, args=(workspace.path, start, n, k, failures)) for k, n in enumerate(names)]
    for adder in adders:
        adder.start()
    start.set()
    for adder in adders:
        adder.join(100)
    assert failures.get(timeout=60) == "NameRefused" and failures.empty()
    assert [info.name for info in workspace.datasets()] == ["other", "same"]
