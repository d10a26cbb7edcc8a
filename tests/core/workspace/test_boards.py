"""Boards: blocks that several people change at once, keys that admit to one board, results that are pinned."""

from __future__ import annotations

import json
import sqlite3
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context

import pytest

from core.workspace import (
    Block,
    ConflictError,
    DocumentDamaged,
    DocumentGone,
    Workspace,
    WorkspaceError,
    pinned_state,
)
from core.workspace.boards import MOST_BLOCKS

TEXT = Block("text", "text", 0, 0, 4, 2, {"markdown": "# hello"})
GRAPH = Block("graph", "graph", 4, 0, 8, 6, {"pinned": {"dataset": "demo", "fingerprint": "ff", "key": "aa"}})


@pytest.fixture
def boards(workspace):
    return workspace.boards


@pytest.fixture
def board(boards):
    return boards.create("Overview", [TEXT, GRAPH], "ann")


def test_a_board_is_kept_as_it_was_made(boards, board):
    assert boards.get(board.id) == board and boards.all() == [board]
    assert (board.title, board.version, board.author, dict(board.filters)) == ("Overview", 1, "ann", {})
    assert board.blocks == (replace(TEXT, version=1, author="ann"), replace(GRAPH, version=1, author="ann"))
    json.dumps(board.blocks[1].settings)


def test_changes_of_different_blocks_never_conflict(boards, board):
    text, graph = board.blocks
    one = boards.change_block(board.id, replace(text, settings={"markdown": "new"}), text.version, "ann")
    two = boards.change_block(board.id, replace(graph, settings={"kappa": 60}), graph.version, "bob")
    assert [block.settings for block in two.blocks] == [{"markdown": "new"}, {"kappa": 60}]
    assert [(block.version, block.author) for block in two.blocks] == [(2, "ann"), (3, "bob")]
    assert (one.version, two.version, boards.version(board.id)) == (2, 3, 3)


def test_the_second_change_of_one_block_is_refused_and_shows_what_is_there(boards, board):
    text = board.blocks[0]
    changed = boards.change_block(board.id, replace(text, settings={"markdown": "bob's"}), text.version, "bob")
    with pytest.raises(ConflictError, match="bob has changed this block") as conflict:
        boards.change_block(board.id, replace(text, settings={"markdown": "ann's"}), text.version, "ann")
    assert conflict.value.present == changed.block("text") and conflict.value.author == "bob"
    with pytest.raises(ConflictError):
        boards.remove_block(board.id, "text", "ann", expected_version=text.version)
    assert boards.get(board.id) == changed


def test_a_change_of_a_removed_block_is_a_conflict_with_nothing_there(boards, board):
    boards.remove_block(board.id, "text", "bob", expected_version=1)
    with pytest.raises(ConflictError, match="removed") as conflict:
        boards.change_block(board.id, TEXT, 1, "ann")
    assert conflict.value.present is None and conflict.value.author == "bob"
    assert [block.id for block in boards.get(board.id).blocks] == ["graph"]


def test_moving_blocks_conflicts_with_no_change_of_what_they_show(boards, board):
    moved = boards.move_blocks(board.id, {"text": (2, 3, 5, 6), "gone": (0, 0, 1, 1)}, "ann")
    block = moved.block("text")
    assert (block.x, block.y, block.w, block.h, block.version) == (2, 3, 5, 6, 1)
    changed = boards.change_block(board.id, replace(TEXT, settings={"markdown": "new"}), 1, "bob").block("text")
    assert (changed.x, changed.w, changed.settings) == (2, 5, {"markdown": "new"})


def test_an_added_block_whose_id_is_taken_gets_another(boards, board):
    added = boards.add_block(board.id, TEXT, "bob").blocks[-1]
    assert added.id != "text" and (added.version, added.author, added.settings) == (2, "bob", TEXT.settings)
    assert boards.add_block(board.id, replace(TEXT, id="")).blocks[-1].id


def test_filters_title_and_note(boards, board):
    boards.set_filters(board.id, {"dataset": "demo", "labels": ("walk", "run")}, "ann")
    renamed = boards.rename(board.id, "Report", "for Tuesday", "bob")
    assert (renamed.title, renamed.note, renamed.author) == ("Report", "for Tuesday", "bob")
    assert boards.rename(board.id, "Report 2").note == "for Tuesday"
    assert boards.get(board.id).filters == {"dataset": "demo", "labels": ["walk", "run"]}
    assert [change.what for change in boards.history(board.id)] == ["renamed", "renamed", "filters changed", "made"]


def test_a_key_opens_its_board_only_and_says_whether_to_read_or_to_edit(boards, board):
    other = boards.create("Other")
    assert len({board.read_key, board.edit_key, other.read_key, other.edit_key}) == 4
    assert boards.by_key(board.read_key) == (board, "read") and boards.by_key(other.edit_key) == (other, "edit")
    mixed = f"{other.id}-{board.edit_key.partition('-')[2]}"
    for wrong in ("", board.id, f"{board.id}-", board.edit_key[:-1], board.edit_key + "x", "ä", mixed):
        with pytest.raises(DocumentGone, match="opens no board"):
            boards.by_key(wrong)
    renewed = boards.renew_keys(board.id, "ann")
    assert renewed.read_key != board.read_key and boards.by_key(renewed.read_key)[1] == "read"
    with pytest.raises(DocumentGone, match="renewed"):
        boards.by_key(board.read_key)


def test_a_copy_has_blocks_and_filters_and_its_own_keys(boards, board):
    boards.set_filters(board.id, {"dataset": "demo"})
    copy = boards.duplicate(board.id, author="bob")
    assert (copy.title, copy.filters, copy.author, copy.version) == ("Overview (copy)", {"dataset": "demo"}, "bob", 1)
    assert [block.settings for block in copy.blocks] == [block.settings for block in board.blocks]
    assert {copy.read_key, copy.edit_key}.isdisjoint({board.read_key, board.edit_key})


def test_restoring_keeps_the_keys_and_counts_as_a_change_of_the_blocks_that_differ(boards, board):
    boards.change_block(board.id, replace(TEXT, settings={}), 1, "bob")
    boards.remove_block(board.id, "graph", "bob")
    renewed = boards.renew_keys(board.id)
    again = boards.restore(board.id, 1, "ann")
    assert [block.settings for block in again.blocks] == [block.settings for block in board.blocks]
    assert [block.version for block in again.blocks] == [again.version] * 2 == [5, 5]
    assert (again.read_key, again.edit_key) == (renewed.read_key, renewed.edit_key)
    with pytest.raises(ConflictError):
        boards.change_block(board.id, TEXT, 1, "bob")
    assert [block.version for block in boards.restore(board.id, 1).blocks] == [5, 5]


def test_a_deleted_board_opens_by_no_key_until_it_is_back(boards, board):
    boards.delete(board.id)
    for refused in (
        lambda: boards.get(board.id),
        lambda: boards.by_key(board.edit_key),
        lambda: boards.version(board.id),
    ):
        with pytest.raises(DocumentGone):
            refused()
    assert boards.all() == [] and boards.undelete(board.id) == board


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"settings": {"a": float("nan")}}, "finite"),
        ({"settings": {"a": {1, 2}}}, "finite"),
        ({"settings": {1: 2}}, "mapping"),
        ({"settings": {"a": "x" * 70_000}}, "too large"),
        ({"w": 0}, "place"),
        ({"x": -1}, "place"),
        ({"x": 1.5}, "place"),
        ({"y": 10**9}, "place"),
        ({"kind": "<script>"}, "characters"),
        ({"id": "a/b"}, "characters"),
    ],
)
def test_a_block_that_does_not_fit_is_refused(boards, board, wrong, message):
    with pytest.raises(WorkspaceError, match=message):
        boards.add_block(board.id, replace(TEXT, **{"id": "", **wrong}))
    assert boards.version(board.id) == 1


def test_settings_nested_without_end_are_refused(boards, board):
    endless: dict[str, object] = {}
    endless["again"] = endless
    with pytest.raises(WorkspaceError, match="deeply"):
        boards.change_block(board.id, replace(TEXT, settings=endless), 1)


def test_a_board_has_room_for_so_many_blocks_and_no_more(boards):
    board = boards.create("full", [replace(TEXT, id="")] * MOST_BLOCKS)
    with pytest.raises(WorkspaceError, match="at most"):
        boards.add_block(board.id, TEXT)
    with pytest.raises(WorkspaceError, match="at most"):
        boards.create("too full", [replace(TEXT, id="")] * (MOST_BLOCKS + 1))


@pytest.mark.parametrize(
    "damage", ['{"x"', '{"blocks": []}', '{"title":"","note":"","filters":{},"blocks":[{"id":"a"}]}']
)
def test_a_damaged_board_is_named_and_an_earlier_version_brings_it_back(workspace, board, damage):
    workspace.boards.rename(board.id, "two")
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        table.execute("UPDATE document_versions SET document = ? WHERE version = 2", (damage,))
    assert workspace.boards.all() == [] and workspace.boards.damaged() == [board.id]
    for refused in (lambda: workspace.boards.get(board.id), lambda: workspace.boards.rename(board.id, "three")):
        with pytest.raises(DocumentDamaged, match="earlier version"):
            refused()
    again = workspace.boards.restore(board.id, 1)
    assert (again.title, again.version, again.edit_key) == ("Overview", 3, board.edit_key)


@pytest.mark.parametrize(
    ("settings", "state"),
    [
        ({}, "not pinned"),
        ({"pinned": "demo"}, "not pinned"),
        ({"pinned": {"dataset": "demo", "fingerprint": "ff"}}, "unchanged"),
        ({"pinned": {"dataset": "demo", "fingerprint": "ee"}}, "changed"),
        ({"pinned": {"dataset": "old", "fingerprint": "ff"}}, "gone"),
    ],
)
def test_a_pinned_result_says_whether_its_data_has_changed(settings, state):
    assert pinned_state(settings, {"demo": "ff"}) == state


def change_many(arguments) -> None:
    """Changes one block 20 times, as one person of several who are on the board."""
    path, board, block = arguments
    boards = Workspace(path).boards
    for number in range(20):
        present = boards.get(board).block(block)
        boards.change_block(board, replace(present, settings={"number": number}), present.version, block)


def test_two_processes_that_change_two_blocks_at_once_lose_nothing(workspace, board):
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        list(pool.map(change_many, [(workspace.path, board.id, id) for id in ("text", "graph")]))
    after = workspace.boards.get(board.id)
    assert [block.settings for block in after.blocks] == [{"number": 19}] * 2 and after.version == 41
    assert [block.author for block in after.blocks] == ["text", "graph"]
