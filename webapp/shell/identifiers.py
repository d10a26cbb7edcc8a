"""Ids of components and stores, declared once in the ``names`` module of the part that owns them.

``names.MAP_GRAPH = Id("map-graph")`` is a component, ``names.MAP_LOOK = Store("map-look", Look)`` a ``dcc.Store`` whose
content has the shape ``Look`` (see :mod:`webapp.shell.shapes`). Both are text, so Dash takes them as they are.
``scripts/generate_ids.py`` writes the same names and shapes for the modules of the browser.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from types import ModuleType
from typing import Any


class Id(str):
    """The id of a component."""

    __slots__ = ()


class Store(Id):
    """The id of a store, and the shape of what it holds when it is not empty."""

    content: Any

    def __new__(cls, value: str, content: Any) -> Store:
        """content: a type that :func:`webapp.shell.shapes.problem` understands."""
        store = super().__new__(cls, value)
        store.content = content
        return store


class Pattern:
    """Ids of components that Dash matches by a pattern: ``DEMO("empty")`` is ``{"type": "demo", "at": "empty"}``."""

    def __init__(self, kind: str, key: str):
        self.kind, self.key = kind, key

    def __call__(self, value: Any) -> dict[str, Any]:
        """The id with this value, or the pattern where it is ``dash.ALL`` or ``dash.MATCH``."""
        return {"type": self.kind, self.key: value}


class Prefix(str):
    """How ids begin whose rest is known only while the app runs: ``NAV("map")`` is the id ``nav-map``."""

    __slots__ = ()

    def __call__(self, rest: object) -> Id:
        """The id that ends in ``rest``."""
        return Id(f"{self}{rest}")


class Family(dict[str, Id]):
    """Ids that differ in one word: ``Family("sweep-{}-name", ("x", "y"))["x"]`` is the id ``sweep-x-name``.

    content: they are stores of this shape.
    """

    def __init__(self, form: str, words: Iterable[str], content: Any = None):
        texts = (form.format(word) for word in words)
        ids = (Id(text) if content is None else Store(text, content) for text in texts)
        super().__init__(zip(words, ids, strict=True))


class Group:
    """Ids of parts that several pages have, as attributes: a subclass sets them in its ``__init__``."""


Identifier = Id | Prefix | Pattern


def constant(identifier: Id | Prefix) -> str:
    """The name that the constant of an id has: ``MAP_GRAPH`` for ``map-graph``."""
    return identifier.strip("-").replace("-", "_").upper()


def declared(module: ModuleType) -> Iterator[tuple[str, Identifier]]:
    """All ids that a ``names`` module declares, in its order, each with the name that leads to it."""
    for name, value in vars(module).items():
        if isinstance(value, Identifier):
            yield name, value
        elif isinstance(value, Family):
            yield from ((name, part) for part in value.values())
        elif isinstance(value, Group):
            yield from ((name, part) for part in vars(value).values() if isinstance(part, Identifier))
