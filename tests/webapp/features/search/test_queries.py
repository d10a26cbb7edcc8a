"""Searches in links: there and back for any names; what is damaged is refused in words."""

from __future__ import annotations

import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.mocap.clip import Segment
from core.poses.body_parts import LEAVES, leaves_of
from webapp.features.search.queries import (
    Piece,
    escape,
    nodes_of,
    read_hit,
    read_query,
    read_weights,
    unescape,
    write_hit,
    write_query,
    write_weights,
)

NAMES = st.text(st.characters(exclude_categories=("Cs",)), min_size=1, max_size=20)
FRAMES = st.tuples(st.integers(0, 10**6), st.integers(1, 10**5))


@st.composite
def queries(draw) -> tuple[Piece, ...]:
    """One piece, or several that share the leaves among them."""
    owners = draw(st.lists(st.integers(0, 3), min_size=len(LEAVES), max_size=len(LEAVES)))
    pieces = []
    for owner in sorted(set(owners)):
        start, length = draw(FRAMES)
        leaves = tuple(leaf for leaf, own in zip(LEAVES, owners, strict=True) if own == owner)
        pieces.append(Piece(draw(NAMES), start, start + length, leaves, draw(st.one_of(st.just(""), NAMES))))
    return tuple(pieces)


@given(queries())
def test_a_query_comes_back_from_its_link(pieces):
    text = write_query(pieces)
    assert read_query(text) == pieces
    assert re.fullmatch(r"[-0-9A-Za-z.,:_~+ ]+", text)


@given(NAMES)
def test_any_name_survives(name):
    assert unescape(escape(name)) == name


@given(st.text(max_size=60))
def test_any_text_is_read_or_refused_in_words(text):
    try:
        read_query(text)
    except ValueError as error:
        assert "codec" not in str(error)
    read_hit(text)


def test_clips_whose_names_look_like_ranges_are_told_apart():
    assert read_query("10-20:3-9") == (Piece("10-20", 3, 9),)
    assert read_query("10-20:3-9:other") == (Piece("10-20", 3, 9, LEAVES, "other"),)
    assert read_query("lower_body:10-20:3-9") == (Piece("10-20", 3, 9, leaves_of("lower_body")),)


@pytest.mark.parametrize(
    "text", ["", "a", "a:9-3", "a:1-2:b:c:d", ":1-2", "tail:a:1-2", "head:a:1-2,head:b:1-2", "~:1-2"]
)
def test_what_is_no_query_is_refused(text):
    with pytest.raises(ValueError):
        read_query(text)


def test_leaves_are_named_by_the_fewest_nodes():
    assert nodes_of(LEAVES) == ("whole_body",)
    assert nodes_of(leaves_of("upper_body")) == ("upper_body",)
    assert nodes_of(("head", "left_arm", "left_hand", "right_leg")) == ("head", "left_arm_hand", "right_leg")


def test_weights_there_and_back():
    assert read_weights("") is None and read_weights(None) is None
    assert read_weights(write_weights({"left_arm": 35, "right_arm": 0, "legs": 0})) == {"left_arm": 35}
    assert read_weights("upper_body:2.5,head:1") == {"upper_body": 2.5, "head": 1}
    for bad in ("tail:3", "left_arm", "left_arm:-1", "left_arm:nan"):
        with pytest.raises(ValueError, match="look like"):
            read_weights(bad)
    with pytest.raises(ValueError, match="switched off"):
        read_weights("left_arm:0")


def test_a_hit_there_and_back():
    segment = Segment("folder/walk, slow", 3, 90)
    assert read_hit(write_hit(segment)) == segment
    assert read_hit("nonsense") is None
