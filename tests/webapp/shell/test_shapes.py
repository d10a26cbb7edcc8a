"""Shapes: what fits them, what does not and why, and callbacks that get only what fits."""

from __future__ import annotations

import string
from typing import Annotated, Any, Literal, NotRequired, TypedDict

import pytest
from dash import Input, State
from hypothesis import given
from hypothesis import strategies as st

from webapp.shell import stores
from webapp.shell.identifiers import Store
from webapp.shell.shapes import Most, problem


class Piece(TypedDict):
    clip: Annotated[str, Most(5)]
    start: int
    weight: NotRequired[float | None]
    children: NotRequired[list[Piece]]


RUBBISH = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(string.ascii_lowercase, max_size=6), inner),
    max_leaves=8,
)


@pytest.mark.parametrize(
    ("value", "shape"),
    [
        (None, None),
        (3, int),
        (3, float),
        ("up", Literal["up", "down"]),
        ([1, "a"], tuple[int, str]),
        ({"a": 1.5}, dict[str, float]),
        ({"clip": "walk", "start": 3}, Piece),
        ({"clip": "walk", "start": 3, "weight": None, "children": [{"clip": "b", "start": 0}]}, Piece),
        ({"clip": "walk", "start": 3, "more": []}, Piece),
        ([object()], Any),
    ],
)
def test_what_fits(value, shape):
    assert problem(value, shape) is None


@pytest.mark.parametrize(
    ("value", "shape", "words"),
    [
        (True, int, "it should be a whole number"),
        (2**60, int, "it should be a whole number"),
        (float("nan"), float, "it should be a number"),
        (1, bool, "it should be true or false"),
        ("x" * 200_000, str, "it should be text"),
        ("left", Literal["up", "down"], "it is none of up, down"),
        ([1], tuple[int, str], "it should have 2 parts"),
        ("text", list[str], "it should be a list"),
        ([1, None], list[int], "it[1] should be a whole number"),
        ({"a": "b"}, dict[str, float], "it.a should be a number"),
        ([], Piece, "it should have named parts"),
        ({"clip": "walk"}, Piece, "it has no start"),
        ({"clip": "walking", "start": 1}, Piece, "it.clip is too long"),
        ({"clip": "a", "start": 1, "children": [{"clip": 1, "start": 0}]}, Piece, "it.children[0].clip should be text"),
    ],
)
def test_what_does_not_fit_and_why(value, shape, words):
    assert problem(value, shape) == words


@given(RUBBISH)
def test_whatever_fits_a_shape_is_what_the_shape_says(value):
    if problem(value, Piece) is None:
        assert type(value["clip"]) is str and type(value["start"]) is int
        assert all(type(child["clip"]) is str for child in value.get("children", ()))


def test_a_callback_gets_nothing_in_place_of_what_does_not_fit(monkeypatch):
    notices = []
    monkeypatch.setattr(stores, "set_props", lambda store, properties: notices.append(properties))
    number, piece = Store("number", int), Store("piece", Piece)
    taken = [Input(number, "data"), {"a": State(piece, "data")}, State("plain", "data"), Input(number, "modified")]
    call = stores.checked(lambda *values: values, taken)
    good = (3, {"a": {"clip": "a", "start": 1}}, {"any": "thing"}, "not data")
    assert call(*good) == good and not notices
    assert call("3", {"a": {"clip": "a"}}, 4, 5) == (None, {"a": None}, 4, 5)
    assert len(notices) == 1 and "left out" in str(notices)
