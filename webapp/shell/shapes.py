"""Shapes of what comes from a browser: whether a JSON value is what a type says.

A shape is ``None``, ``bool``, ``int``, ``float``, ``str``, ``Any``, ``Literal[...]``, a union, ``list[shape]``,
``tuple[shape, ...]``, ``dict[str, shape]``, a ``TypedDict``, or ``Annotated[shape, Most(n)]`` for text and lists of at
most n letters or parts. Keys that a ``TypedDict`` does not name are ignored.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, NotRequired, Required, Union, get_args, get_origin, get_type_hints

MOST_LETTERS = 100_000  # of text without a Most of its own
_LARGEST = 2**53  # JavaScript cannot represent larger whole numbers exactly
_WORDS = {NoneType: "nothing", bool: "true or false", int: "a whole number", float: "a number", str: "text"}


@dataclass(frozen=True)
class Most:
    """How many letters or parts a value may have."""

    size: int


def problem(value: object, shape: Any, place: str = "it") -> str | None:
    """Why ``value`` is not of this shape, as a short phrase that begins with ``place``; None where it is."""
    if shape is Any:
        return None
    if shape is None or shape in _WORDS:
        return _plain(value, NoneType if shape is None else shape, place)
    origin, parts = get_origin(shape), get_args(shape)
    if origin is Annotated:
        most = next((extra.size for extra in parts[1:] if isinstance(extra, Most)), None)
        if most is not None and isinstance(value, str | list | dict) and len(value) > most:
            return f"{place} is too long"
        return None if most and parts[0] is str and isinstance(value, str) else problem(value, parts[0], place)
    if origin is Literal:
        fits = any(type(value) is type(word) and value == word for word in parts)
        return None if fits else f"{place} is none of {', '.join(map(str, parts))}"
    if origin in (Union, UnionType):
        problems = [problem(value, part, place) for part in parts]
        return None if None in problems else problems[0]
    if origin in (Required, NotRequired):
        return problem(value, parts[0], place)
    if origin in (list, tuple):
        return _sequence(value, origin, parts, place)
    return _mapping(value, shape, place)


def keys(shape: Any) -> tuple[dict[str, Any], frozenset[str]]:
    """The keys of a ``TypedDict``, each with its shape, and those of them that must be there."""
    return _keys(shape)


@cache
def _keys(shape: Any) -> tuple[dict[str, Any], frozenset[str]]:
    hints = get_type_hints(shape, include_extras=True)
    # from the hints: __required_keys__ is wrong where annotations are text
    marks = {key: get_origin(part) for key, part in hints.items()}
    total = shape.__total__
    required = (key for key, mark in marks.items() if mark is Required or (total and mark is not NotRequired))
    return hints, frozenset(required)


def _plain(value: object, shape: type, place: str) -> str | None:
    if shape is float:
        fits = isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
    elif shape is int:
        fits = isinstance(value, int) and not isinstance(value, bool) and abs(value) <= _LARGEST
    elif shape is str:
        fits = isinstance(value, str) and len(value) <= MOST_LETTERS
    else:
        fits = type(value) is shape
    return None if fits else f"{place} should be {_WORDS[shape]}"


def _sequence(value: object, kind: type, parts: tuple[Any, ...], place: str) -> str | None:
    if not isinstance(value, list | tuple):
        return f"{place} should be a list"
    if kind is tuple and len(value) != len(parts):
        return f"{place} should have {len(parts)} parts"
    shapes = parts if kind is tuple else parts * len(value)
    problems = (
        problem(part, shape, f"{place}[{k}]") for k, (part, shape) in enumerate(zip(value, shapes, strict=True))
    )
    return next((words for words in problems if words), None)


def _mapping(value: object, shape: Any, place: str) -> str | None:
    if not isinstance(value, Mapping):
        return f"{place} should have named parts"
    if get_origin(shape) is dict:
        problems = (problem(part, get_args(shape)[1], f"{place}.{key}") for key, part in value.items())
        return next((words for words in problems if words), None)
    declared, required = _keys(shape)
    if missing := required - value.keys():
        return f"{place} has no {min(missing)}"
    problems = (problem(value[key], part, f"{place}.{key}") for key, part in declared.items() if key in value)
    return next((words for words in problems if words), None)
