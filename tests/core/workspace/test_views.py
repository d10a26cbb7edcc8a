"""Saved views: versions, conflicts, damage, and a database from before they existed."""

from __future__ import annotations

import sqlite3
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import pytest

from core.workspace import ConflictError, DocumentDamaged, DocumentGone, Workspace, WorkspaceError
from core.workspace.documents import Documents

ADDRESS = "/motifs?dataset=demo&kappa=60&motif=3"
OLD_TABLES = """
CREATE TABLE datasets (
    id TEXT PRIMARY KEY, name TEXT NOT NULL, fingerprint TEXT NOT NULL, folder TEXT NOT NULL,
    clips INTEGER NOT NULL, frames INTEGER NOT NULL, seconds REAL NOT NULL, labels INTEGER NOT NULL,
    warnings INTEGER NOT NULL, errors INTEGER NOT NULL, imported REAL NOT NULL, trashed REAL
);
INSERT INTO datasets VALUES ('aa', 'mine', 'ff', 'aa', 1, 10, 0.1, 0, 0, 0, 5.0, NULL);
CREATE TABLE notes (
    id INTEGER PRIMARY KEY AUTOINCREMENT, dataset TEXT NOT NULL, result TEXT NOT NULL, motif INTEGER NOT NULL,
    segments TEXT NOT NULL, name TEXT NOT NULL, tags TEXT NOT NULL, note TEXT NOT NULL, changed REAL NOT NULL,
    UNIQUE (dataset, result, motif)
);
"""


@pytest.fixture
def views(workspace):
    return workspace.views


def test_a_view_is_saved_with_all_that_is_said_of_it(views):
    saved = views.save(ADDRESS, " The\n jacks ", "both feet\nland", ["warm-up", "", "warm-up"], "ann")
    assert views.get(saved.id) == saved and views.all() == [saved]
    assert (saved.title, saved.note, saved.tags, saved.address) == (
        "The jacks",
        "both feet\nland",
        ("warm-up",),
        ADDRESS,
    )
    assert (saved.author, saved.version) == ("ann", 1) and saved.created == saved.updated > 0


def test_every_save_is_a_version_that_can_come_back(views):
    first = views.save(ADDRESS, "one", author="ann")
    second = views.save("/map?dataset=demo", "two", author="bob", id=first.id, expected_version=1)
    assert (second.version, second.created, views.get(first.id).title) == (2, first.created, "two")
    assert views.get(first.id, 1) == first
    again = views.restore(first.id, 1, "cleo")
    assert (again.title, again.address, again.version, again.author) == ("one", ADDRESS, 3, "cleo")
    assert [(c.version, c.author) for c in views.history(first.id)] == [(3, "cleo"), (2, "bob"), (1, "ann")]
    with pytest.raises(DocumentGone, match="version 9"):
        views.get(first.id, 9)


def test_who_saves_over_a_version_they_have_not_seen_is_told_and_nothing_is_lost(views):
    first = views.save(ADDRESS, "one", author="ann")
    views.save(ADDRESS, "two", author="bob", id=first.id, expected_version=1)
    with pytest.raises(ConflictError, match="bob has saved") as conflict:
        views.save(ADDRESS, "three", author="ann", id=first.id, expected_version=1)
    assert conflict.value.present == views.get(first.id) and conflict.value.author == "bob"
    assert views.get(first.id).title == "two" and views.get(first.id).version == 2


def test_a_deleted_view_comes_back_as_it_was(views):
    saved = views.save(ADDRESS, "one")
    views.delete(saved.id)
    assert views.all() == []
    for refused in (views.get, views.delete, views.version):
        with pytest.raises(DocumentGone, match="deleted"):
            refused(saved.id)
    assert views.undelete(saved.id) == saved and views.all() == [saved]
    with pytest.raises(DocumentGone):
        views.undelete("nothing")


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"address": "https://elsewhere.org/motifs"}, "page of this app"),
        ({"address": "//elsewhere.org"}, "page of this app"),
        ({"address": "/\\elsewhere.org"}, "page of this app"),
        ({"address": "/motifs?a=\n"}, "characters"),
        ({"address": "/" + "x" * 5000}, "too long"),
        ({"title": " "}, "title is empty"),
        ({"title": "x" * 500}, "at most 120 letters"),
        ({"note": "x" * 5000}, "at most 4,000 letters"),
        ({"tags": [str(i) for i in range(30)]}, "at most 20 tags"),
        ({"author": "x" * 100}, "at most 80 letters"),
    ],
)
def test_what_does_not_fit_is_refused_in_plain_words(views, wrong, message):
    with pytest.raises(WorkspaceError, match=message):
        views.save(**{"address": ADDRESS, "title": "one", **wrong})
    assert views.all() == []


def test_old_versions_go_when_there_are_very_many(views):
    saved = views.save(ADDRESS, "0")
    for number in range(1, Documents.kept_versions + 5):
        views.save(ADDRESS, str(number), id=saved.id)
    history = views.history(saved.id)
    assert len(history) == Documents.kept_versions and history[0].version == Documents.kept_versions + 5
    assert views.get(saved.id, history[-1].version).title == "5"


@pytest.mark.parametrize(
    "damage", ['{"title": ', "[]", '{"title": "x"}', "", '{"title":"x","note":"","tags":3,"address":"/"}']
)
def test_a_damaged_view_is_named_and_an_earlier_version_brings_it_back(workspace, damage):
    views = workspace.views
    other, saved = views.save("/map", "other"), views.save(ADDRESS, "one")
    views.save(ADDRESS, "two", id=saved.id)
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        table.execute("UPDATE document_versions SET document = ? WHERE id = ? AND version = 2", (damage, saved.id))
    assert views.all() == [other] and views.damaged() == [saved.id]
    with pytest.raises(DocumentDamaged, match="Restore an earlier version"):
        views.get(saved.id)
    with pytest.raises(DocumentDamaged):
        views.restore(saved.id, 2)
    assert views.restore(saved.id, 1, "ann").title == "one"
    assert views.damaged() == [] and [change.version for change in views.history(saved.id)] == [3, 2, 1]


def test_a_view_whose_version_is_missing_is_damaged_not_a_bug(workspace):
    saved = workspace.views.save(ADDRESS, "one")
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        table.execute("DELETE FROM document_versions")
    assert workspace.views.all() == [] and workspace.views.damaged() == [saved.id]
    with pytest.raises(DocumentDamaged):
        workspace.views.get(saved.id)


def test_a_database_from_before_there_were_views_gets_their_tables_and_keeps_the_rest(tmp_path):
    with sqlite3.connect(tmp_path / "workspace.sqlite") as table:
        table.executescript(OLD_TABLES)
    workspace = Workspace(tmp_path)
    assert [info.name for info in workspace.datasets()] == ["mine"]
    saved = workspace.views.save(ADDRESS, "one")
    board = workspace.boards.create("first")
    workspace.comments.add(f"board:{board.id}", "hello")
    workspace.close()
    again = Workspace(tmp_path)
    assert again.views.all() == [saved] and again.boards.all() == [board]
    again.close()


def save_many(arguments) -> int:
    """Saves the view until 20 saves went through, each on the version seen last; how many conflicts there were."""
    path, id, name = arguments
    views, conflicts, done = Workspace(path).views, 0, 0
    while done < 20:
        seen = views.get(id)
        try:
            views.save(ADDRESS, f"{seen.title} {name}", id=id, expected_version=seen.version, author=name)
            done += 1
        except ConflictError:
            conflicts += 1
    return conflicts


def test_two_processes_that_save_at_once_lose_nothing(workspace):
    saved = workspace.views.save(ADDRESS, "start")
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        list(pool.map(save_many, [(workspace.path, saved.id, "a"), (workspace.path, saved.id, "b")]))
    words = workspace.views.get(saved.id).title.split()
    assert words[0] == "start" and sorted(words[1:]) == ["a"] * 20 + ["b"] * 20
    assert workspace.views.version(saved.id) == 41
