"""The doctor finds every kind of damage, repairs what can be repaired, and leaves what is whole."""

from __future__ import annotations

import os
import sqlite3
import time
from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace, WorkspaceError
from core.workspace.doctor import examine
from tests.toy_method import make_dataset, request

REQUEST = replace(request(), dataset="one")


@pytest.fixture
def space(tmp_path):
    """A workspace with two datasets, a result, a note, a view and a board."""
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("one", make_dataset())
    workspace.add_dataset("two", make_dataset(seed=1))
    analyses.run(workspace, REQUEST)
    workspace.users.add("ann", "correct horse")
    workspace.close()
    return workspace


def again(space):
    """The words of a second look, after a repair."""
    return [problem.words for problem in examine(space.path)]


def repaired(space, words):
    """Checks that the damage is found, that looking changes nothing, and that it is repaired; how."""
    (found,) = examine(space.path)
    assert words in found.what and not found.done and found.advice
    assert again(space) == [found.words]
    (mended,) = examine(space.path, repair=True)
    assert mended.done and again(space) == []
    return mended.done


def folder(space, name):
    return space.path / "datasets" / space.info(name).folder


def test_a_whole_workspace_has_no_problem(space):
    assert examine(space.path) == []
    space.add_dataset("demo", make_demo(minutes=0.5))  # motion as analyses see it is what lies on the disk
    space.trash("two")
    space.close()
    files = {path: path.stat().st_mtime_ns for path in space.path.rglob("*.npy")}
    assert examine(space.path, repair=True) == []
    assert {path: path.stat().st_mtime_ns for path in space.path.rglob("*.npy")} == files


def test_what_is_no_workspace_is_refused(tmp_path):
    with pytest.raises(WorkspaceError, match="no workspace"):
        examine(tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("damage", ["bytes", "cut", "no database"])
def test_a_damaged_job_table_is_made_anew_from_what_is_on_disk(space, damage):
    file = space.path / "workspace.sqlite"
    content = bytearray(file.read_bytes())
    assert not (space.path / "workspace.sqlite-wal").exists()
    if damage == "bytes":
        content[len(content) // 2 : len(content) // 2 + 3000] = b"\xff" * 3000
    elif damage == "cut":
        del content[len(content) // 2 :]
    file.write_bytes(b"rubbish" * 1000 if damage == "no database" else content)
    assert "2 datasets were found" in repaired(space, "workspace.sqlite")
    now = Workspace(space.path)
    assert [info.name for info in now.datasets()] == ["one", "two"]
    assert analyses.stored(now, REQUEST)["frames"] == 81
    assert len(list(space.path.glob("workspace.sqlite.damaged-*"))) >= 1


def test_accounts_and_views_are_kept_where_their_pages_are_whole(space):
    file = space.path / "workspace.sqlite"
    with sqlite3.connect(file) as table:
        page = table.execute("SELECT rootpage FROM sqlite_master WHERE name = 'jobs'").fetchone()[0]
        size = table.execute("PRAGMA page_size").fetchone()[0]
        table.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    table.close()
    content = bytearray(file.read_bytes())
    content[(page - 1) * size : page * size] = b"\xff" * size
    file.write_bytes(content)
    repaired(space, "workspace.sqlite")
    assert [account.name for account in Workspace(space.path).users.list()] == ["ann"]


def test_a_data_set_that_cannot_be_opened_goes_into_the_trash(space):
    motion = folder(space, "one") / "motion.npy"
    os.truncate(motion, 300)
    assert "trash" in repaired(space, "'one' cannot be opened")
    assert [info.name for info in Workspace(space.path).trashed()] == ["one"]


def test_clips_that_are_not_what_was_imported_are_removed(space):
    motion = folder(space, "one") / "motion.npy"
    numbers = np.load(motion)
    numbers[-1] += 0.5  # of the second clip
    np.save(motion, numbers)
    repaired(space, "1 of 2 clips of 'one'")
    now = Workspace(space.path)
    assert now.open("one").names == ("walk_0",) and now.last_version("one")


def test_a_data_set_that_is_in_no_list_is_found(space):
    with sqlite3.connect(space.path / "workspace.sqlite") as table:
        table.execute("DELETE FROM datasets WHERE name = 'two'")
    table.close()
    assert "'two'" in repaired(space, "is in no list")
    assert Workspace(space.path).open("two").n_frames == 81


def test_a_damaged_result_is_removed(space):
    (result,) = (path for path in space.path.glob("results/*/*") if path.is_file())
    result.write_bytes(result.read_bytes()[:10])
    assert "computed again" in repaired(space, "is damaged")
    assert not result.exists()


def test_files_of_processes_that_were_ended_are_removed_but_not_of_those_that_run(space):
    old, fresh = space.path / "datasets" / ".tmp-old", space.path / "datasets" / ".tmp-fresh"
    for path in (old, fresh):
        path.mkdir()
        (path / "motion.npy").write_bytes(b"half")
    os.utime(old, (time.time() - 7200,) * 2)
    repaired(space, "1 temporary or damaged files")
    assert fresh.exists() and not old.exists()
