"""Comments: kept at their place, answered, resolved, edited by two people, deleted and brought back."""

from __future__ import annotations

import sqlite3

import pytest

from core.workspace import ConflictError, DocumentGone, WorkspaceError
from core.workspace.comments import mentions

BLOCK, OTHER = "board:b1/block:one", "board:b1/block:two"


@pytest.fixture
def comments(workspace):
    return workspace.comments


def test_a_comment_is_found_at_its_place_with_the_people_it_mentions(comments):
    said = comments.add(BLOCK, " @bob look,\nand @cleo.k too. ", "ann")
    assert comments.at(BLOCK) == [said] and comments.get(said.id) == said
    assert (said.text, said.author, said.mentions) == ("@bob look,\nand @cleo.k too.", "ann", ("bob", "cleo.k"))
    assert (said.resolved, said.parent, said.version) == (False, None, 1)
    assert comments.at(OTHER) == []


def test_a_board_has_the_comments_of_its_blocks_and_no_other_boards(comments):
    on_board = comments.add("board:b1", "all of it")
    on_block = comments.add(BLOCK, "this")
    for elsewhere in ("board:b10", "board:b1x/block:one", "board:b", "motif:b1/aa/3"):
        comments.add(elsewhere, "elsewhere")
    assert comments.under("board:b1") == [on_board, on_block] == comments.under("board:b1/")
    moment = comments.add("moment:demo/walk/a 1/120", "here")
    assert comments.under("moment:demo/walk/a 1") == [moment]


def test_the_state_of_a_place_changes_with_every_change_below_it(comments):
    seen = [comments.state("board:b1")]
    said = comments.add(BLOCK, "this")
    seen.append(comments.state("board:b1"))
    steps = [
        lambda: comments.add(OTHER, "and this", parent=None),
        lambda: comments.edit(said.id, "that", 1),
        lambda: comments.resolve(said.id),
        lambda: comments.reopen(said.id),
        lambda: comments.delete(said.id),
        lambda: comments.undelete(said.id),
    ]
    for step in steps:
        step()
        seen.append(comments.state("board:b1"))
    assert len(set(seen)) == len(seen)
    comments.add("board:b2", "elsewhere")
    assert comments.state("board:b1") == seen[-1]


def test_answers_stay_with_the_place_of_what_they_answer(comments):
    said = comments.add(BLOCK, "this?")
    answer = comments.add(BLOCK, "yes", "bob", parent=said.id)
    assert answer.parent == said.id
    with pytest.raises(WorkspaceError, match="place"):
        comments.add(OTHER, "no", parent=said.id)
    comments.delete(said.id)
    with pytest.raises(DocumentGone):
        comments.add(BLOCK, "late", parent=said.id)
    assert comments.at(BLOCK) == [answer]


def test_resolving_and_reopening(comments):
    said = comments.add(BLOCK, "this?")
    assert comments.resolve(said.id).resolved and comments.get(said.id).resolved
    assert not comments.reopen(said.id).resolved


def test_the_second_edit_of_one_text_is_told(comments):
    said = comments.add(BLOCK, "one", "ann")
    edited = comments.edit(said.id, "two @bob", said.version)
    assert (edited.text, edited.version, edited.mentions) == ("two @bob", 2, ("bob",))
    with pytest.raises(ConflictError) as conflict:
        comments.edit(said.id, "three", said.version)
    assert conflict.value.present == edited and comments.get(said.id).text == "two @bob"


def test_a_deleted_comment_comes_back(comments):
    said = comments.add(BLOCK, "one")
    comments.delete(said.id)
    assert comments.at(BLOCK) == []
    for refused in (comments.get, comments.delete, lambda id: comments.edit(id, "x", 2)):
        with pytest.raises(DocumentGone, match="deleted"):
            refused(said.id)
    assert comments.undelete(said.id).text == "one" and len(comments.at(BLOCK)) == 1
    with pytest.raises(DocumentGone):
        comments.undelete("nothing")


@pytest.mark.parametrize(
    ("place", "text", "message"),
    [
        ("somewhere", "x", "belongs to a place"),
        ("page:1", "x", "belongs to a place"),
        ("board:", "x", "belongs to a place"),
        ("board:b1/", "x", "belongs to a place"),
        ("board:" + "x" * 500, "x", "at most 400"),
        (BLOCK, " \n", "empty"),
        (BLOCK, "x" * 5000, "at most 4,000"),
    ],
)
def test_what_does_not_fit_is_refused_in_plain_words(comments, place, text, message):
    with pytest.raises(WorkspaceError, match=message):
        comments.add(place, text)
    assert comments.under("board:b1") == []


def test_a_damaged_row_does_not_hide_the_others(workspace):
    said, other = workspace.comments.add(BLOCK, "one"), workspace.comments.add(BLOCK, "two")
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        table.execute("UPDATE comments SET text = x'ff00', author = 3, parent = 'nobody' WHERE id = ?", (said.id,))
    assert workspace.comments.at(BLOCK)[1] == other and len(workspace.comments.at(BLOCK)) == 2


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("@ann", ("ann",)),
        ("mail ann@site.org", ()),
        ("(@ann), @bob. @ann", ("ann", "bob")),
        ("@ @- @@x", ()),
        ("@Zoë", ("Zoë",)),
    ],
)
def test_names_behind_an_at_sign_are_mentions(text, names):
    assert mentions(text) == names
