"""Roles: what viewers, editors, owners and guests of a board may do, checked where the workspace is changed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from core.demo import make_demo
from core.mocap.clip import Segment
from core.workspace import AccessRefused, Block, DocumentGone, Person, Workspace, WorkspaceError, acting_as

VIEWER, EDITOR, OWNER = (Person(role, role) for role in ("viewer", "editor", "owner"))
TEXT = Block("text", "text", settings={"markdown": "hello"})


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=1, seed=1)


@pytest.fixture
def workspace(tmp_path, demo):
    workspace = Workspace(tmp_path)
    workspace.add_dataset("mine", demo)
    workspace.add_dataset("yours", demo)
    yield workspace
    workspace.close()


@pytest.fixture
def board(workspace):
    view = workspace.views.save("/motifs?dataset=mine", "a view")
    graph = Block("graph", "graph", settings={"pinned": {"dataset": "mine", "fingerprint": "ff"}, "view": view.id})
    return workspace.boards.create("first", [TEXT, graph])


def changes(workspace, board):
    """Everything that changes a workspace, as it is now."""
    view, said = workspace.views.all()[0], workspace.comments.add(f"board:{board.id}", "hello")
    segments = [Segment("a", 0, 10)]
    mine = workspace.info("mine").id
    return {
        "submit": lambda: workspace.jobs.submit("k", {"dataset": "mine", "method": "motifs"}, "Motifs: mine"),
        "import": lambda: workspace.jobs.submit("k2", {"dataset": "new", "method": "import"}, "Import: new"),
        "note": lambda: workspace.notes.put(mine, "aa", 3, segments, name="x"),
        "rating": lambda: workspace.ratings.put_rating(mine, segments[0], segments[0], "parts", 1, 5),
        "clear": lambda: workspace.ratings.clear(mine),
        "save view": lambda: workspace.views.save("/map", "new"),
        "change view": lambda: workspace.views.save("/map", "new", id=view.id),
        "restore view": lambda: workspace.views.restore(view.id, 1),
        "delete view": lambda: workspace.views.delete(view.id),
        "undelete view": lambda: workspace.views.undelete(view.id),
        "board": lambda: workspace.boards.create("new"),
        "add block": lambda: workspace.boards.add_block(board.id, TEXT),
        "move": lambda: workspace.boards.move_blocks(board.id, {"text": (0, 0, 1, 1)}),
        "filters": lambda: workspace.boards.set_filters(board.id, {}),
        "rename board": lambda: workspace.boards.rename(board.id, "x"),
        "links": lambda: workspace.boards.renew_keys(board.id),
        "copy": lambda: workspace.boards.duplicate(board.id),
        "restore board": lambda: workspace.boards.restore(board.id, 1),
        "remove block": lambda: workspace.boards.remove_block(board.id, "text"),
        "delete board": lambda: workspace.boards.delete(board.id),
        "undelete board": lambda: workspace.boards.undelete(board.id),
        "comment": lambda: workspace.comments.add(f"board:{board.id}", "hello"),
        "comment on a motif": lambda: workspace.comments.add("motif:mine/aa/3", "hello"),
        "resolve": lambda: workspace.comments.resolve(said.id),
        "rename": lambda: workspace.rename("mine", "renamed"),
        "rename back": lambda: workspace.rename("renamed", "mine"),
        "trash": lambda: workspace.trash("mine"),
        "restore": lambda: workspace.restore(mine),
        "remove clips": lambda: workspace.remove_clips("mine", workspace.open("mine").names[:1]),
        "revert": lambda: workspace.revert(workspace.last_version("mine")),
        "add dataset": lambda: workspace.add_dataset("new", workspace.open("mine")),
    }


OWNERS_ONLY = {
    "empty trash": lambda workspace: workspace.empty_trash(),
    "add user": lambda workspace: workspace.users.add("zoe", None),
    "role": lambda workspace: workspace.users.set_role("zoe", "owner"),
    "password": lambda workspace: workspace.users.set_password("zoe", "longenough"),
    "remove user": lambda workspace: workspace.users.remove("zoe"),
}


def test_a_viewer_may_change_nothing_and_see_everything(workspace, board):
    everything = changes(workspace, board)
    workspace.remove_clips("yours", workspace.open("yours").names[:1])
    with acting_as(VIEWER):
        assert [info.name for info in workspace.datasets()] == ["mine", "yours"]
        assert workspace.boards.get(board.id) == board and workspace.views.all()
        for name, change in everything.items():
            if name in ("rename back", "restore", "revert"):
                continue  # what they would undo has not happened; the next test does them
            with pytest.raises(AccessRefused, match="viewer may not"):
                change()
        with pytest.raises(AccessRefused):
            workspace.revert(workspace.last_version("yours"))
    token = workspace.trash("yours")
    with acting_as(VIEWER), pytest.raises(AccessRefused):
        workspace.restore(token)
    assert workspace.boards.get(board.id) == board


def test_an_editor_may_change_everything_but_accounts_and_what_cannot_be_undone(workspace, board):
    everything = changes(workspace, board)
    with acting_as(EDITOR):
        for change in everything.values():
            change()
        for change in OWNERS_ONLY.values():
            with pytest.raises(AccessRefused, match="Only an owner"):
                change(workspace)
    with acting_as(OWNER):
        for change in OWNERS_ONLY.values():
            change(workspace)


def test_a_role_on_one_dataset_goes_before_the_role_on_the_workspace(workspace):
    mine = workspace.info("mine").id
    with acting_as(replace(VIEWER, roles={mine: "editor"})):
        workspace.rename("mine", "renamed")
        workspace.jobs.submit("k", {"dataset": "renamed", "method": "motifs"}, "t")
        for refused in (
            lambda: workspace.rename("yours", "x"),
            lambda: workspace.add_dataset("n", workspace.open("yours")),
        ):
            with pytest.raises(AccessRefused):
                refused()
    with acting_as(replace(EDITOR, roles={mine: "viewer"})):
        with pytest.raises(AccessRefused):
            workspace.trash("renamed")
        workspace.trash("yours")


def guest(board, role):
    views = frozenset(block.settings["view"] for block in board.blocks if "view" in block.settings)
    boards = frozenset({board.id}) if role == "editor" else frozenset()
    return Person("guest", "viewer", {}, boards, frozenset({board.id}), frozenset({"mine"}), views)


def test_a_guest_sees_one_board_and_what_it_shows(workspace, board):
    other, view = workspace.boards.create("other"), workspace.views.save("/map", "secret")
    elsewhere = workspace.comments.add(f"board:{other.id}", "secret")
    here = workspace.comments.add(f"board:{board.id}/block:text", "hello")
    job = workspace.jobs.submit("k", {"dataset": "yours", "method": "motifs"}, "Motifs: yours")
    with acting_as(guest(board, "viewer")):
        assert workspace.boards.all() == [board] and len(workspace.views.all()) == 1
        assert [info.name for info in workspace.datasets()] == ["mine"]
        assert workspace.open("mine").name == "mine" and workspace.comments.under(f"board:{board.id}") == [here]
        assert workspace.jobs.list() == [] and workspace.jobs.get(job.id) is None and workspace.trashed() == []
        assert workspace.comments.under(f"board:{other.id}") == []
        for refused in (
            lambda: workspace.boards.get(other.id),
            lambda: workspace.boards.version(other.id),
            lambda: workspace.boards.history(other.id),
            lambda: workspace.boards.by_key(other.read_key),
            lambda: workspace.views.get(view.id),
            lambda: workspace.comments.get(elsewhere.id),
        ):
            with pytest.raises(DocumentGone):
                refused()
        with pytest.raises(WorkspaceError, match="no dataset 'yours'") as error:
            workspace.open("yours")
        assert "mine" in str(error.value) and "yours." not in str(error.value)


def test_a_guest_with_a_read_link_changes_nothing(workspace, board):
    everything = changes(workspace, board)
    with acting_as(guest(board, "viewer")):
        for name, change in everything.items():
            if name not in ("rename back", "restore", "revert"):
                with pytest.raises(AccessRefused, match="This link does not let you"):
                    change()


def test_a_guest_with_an_edit_link_changes_this_board_only_and_brings_no_other_data_onto_it(workspace, board):
    allowed = {"add block", "move", "filters", "rename board", "restore board", "remove block", "comment"}
    everything = changes(workspace, board)
    with acting_as(guest(board, "editor")):
        for name, change in everything.items():
            if name in allowed:
                change()
            elif name not in ("rename back", "restore", "revert", "resolve"):
                with pytest.raises(AccessRefused):
                    change()
        for settings in (
            {"dataset": "yours"},
            {"pinned": {"dataset": "yours"}},
            {"deep": [{"datasets": ["mine", "yours"]}]},
            {"address": "/motifs?dataset=yours"},
            {"view": "another"},
        ):
            with pytest.raises(AccessRefused, match="does not show already"):
                workspace.boards.add_block(board.id, replace(TEXT, id="", settings=settings))
        with pytest.raises(AccessRefused):
            workspace.boards.set_filters(board.id, {"dataset": "yours"})
        workspace.boards.add_block(board.id, replace(TEXT, id="", settings={"dataset": "mine"}))


def test_comments_are_edited_and_deleted_by_their_author_or_an_owner(workspace):
    with acting_as(EDITOR):
        said = workspace.comments.add("motif:mine/aa/3", "hello", author="someone else")
    assert said.author == "editor"
    with acting_as(Person("ann", "editor")):
        with pytest.raises(AccessRefused, match="Only editor or an owner"):
            workspace.comments.edit(said.id, "mine now", 1)
        with pytest.raises(AccessRefused):
            workspace.comments.delete(said.id)
        workspace.comments.resolve(said.id)
    with acting_as(OWNER):
        workspace.comments.delete(said.id)


def test_changes_are_kept_under_the_name_of_who_is_signed_in(workspace):
    with acting_as(Person("ann", "editor")):
        board = workspace.boards.create("mine", [TEXT], author="bob")
        view = workspace.views.save("/map", "one", author="bob")
    assert (board.author, board.blocks[0].author, view.author) == ("ann", "ann", "ann")


def test_a_viewer_with_an_edit_link_may_change_that_board_too(workspace, board):
    other = workspace.boards.create("other")
    with acting_as(Person("ann", "viewer", boards=frozenset({board.id}))):
        workspace.boards.add_block(board.id, replace(TEXT, id="", settings={"dataset": "yours"}))
        workspace.comments.add(f"board:{board.id}", "hello")
        for refused in (lambda: workspace.boards.rename(other.id, "x"), lambda: workspace.boards.delete(board.id)):
            with pytest.raises(AccessRefused):
                refused()
