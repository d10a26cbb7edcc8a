"""What a feature is, and the list of all features.

A feature is one page with all that belongs to it: a folder of ``webapp/features`` whose ``__init__`` defines a
:class:`Feature`. The shell, the Stage and the command line use features through this module and import none of
them. Nothing heavy is imported here, so that the command line starts quickly.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple, get_type_hints

from webapp.shell.names import StageRequest
from webapp.shell.rights import Rights

if TYPE_CHECKING:
    from pathlib import Path

    from dash import Dash
    from dash.development.base_component import Component
    from flask import Blueprint

    from core.analyses import Request
    from core.mocap.dataset import Dataset
    from core.workspace import Workspace

Values = dict[str, dict[str, Any]]
"""Id of a component -> its properties."""

NOTHING: Mapping[str, Any] = MappingProxyType({})


def later(place: str) -> Callable[..., Any]:
    """The function at ``"module:name"``, whose module is imported when the function is first called."""
    module, _, name = place.partition(":")

    def call(*arguments: Any, **options: Any) -> Any:
        return getattr(import_module(module), name)(*arguments, **options)

    return call


@dataclass(frozen=True)
class Command:
    """A command of ``motionscape``: what --help says of it, its arguments, and what it does (the exit code)."""

    help: str
    arguments: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], int]


@dataclass(frozen=True)
class SelectionKind:
    """A kind of thing that can be selected, such as ``{"motif": 3, "motion": 1}``.

    key: names it in a link and in the store "selection"; its value is a whole number, or text of the form ``pattern``,
    of which ``example`` is one. numbers: keys of whole numbers that may stand beside it.
    """

    key: str
    numbers: tuple[str, ...] = ()
    pattern: str = ""
    example: str = ""


@dataclass(frozen=True)
class LinkKeys:
    """The keys of a link that belong to a page: what it shows beside the selection, kept in the store "view".

    names: all of them. of_dataset: those that mean nothing with another data set. free_text: those that may hold any
    printable text, such as names of clips. patterns: regular expressions that values must match, by key.
    """

    names: tuple[str, ...] = ()
    of_dataset: tuple[str, ...] = ()
    free_text: tuple[str, ...] = ()
    patterns: Mapping[str, str] = field(default_factory=lambda: NOTHING)


@dataclass(frozen=True)
class LinkKey:
    """What is special about a key of a link, as an annotation in the page's ``View``; see :class:`LinkKeys`."""

    of_dataset: bool = False
    free_text: bool = False
    pattern: str = ""


def link_keys(view: type) -> LinkKeys:
    """The keys that a page's ``View`` declares, a ``TypedDict`` of text in the order in which links have them."""
    marks = {key: _mark(hint) for key, hint in get_type_hints(view, include_extras=True).items()}
    return LinkKeys(
        names=tuple(marks),
        of_dataset=tuple(key for key, mark in marks.items() if mark.of_dataset),
        free_text=tuple(key for key, mark in marks.items() if mark.free_text),
        patterns={key: mark.pattern for key, mark in marks.items() if mark.pattern},
    )


def _mark(hint: Any) -> LinkKey:
    return next((mark for mark in getattr(hint, "__metadata__", ()) if isinstance(mark, LinkKey)), LinkKey())


class Shown(NamedTuple):
    """What is on the screen when something is selected: name of the dataset, and the rest as a link has it."""

    dataset: str
    selection: Mapping[str, Any]
    view: Mapping[str, str]


@dataclass(frozen=True)
class Block:
    """A part of a board or a report: some of what a page shows, as data that ``assets/blocks/KIND.mjs`` draws.

    label, symbol: in the list of blocks to add. content: (workspace, data set, view, options) -> what is drawn, as
    JSON, or None where the result behind it has not been computed; raises MotionscapeError in plain words.
    method: name of the settings that the content depends on (see ``Feature.methods``), "" where on none.
    segments: what is played of a content, most important first, as (clip, start, end).
    keys: of links, beside those settings, that the content depends on as well.
    options: keys that ``content`` reads, each with what it means. size: columns (of 12) and rows it begins with.
    lasting: the content depends on the dataset, its notes, the result and the options alone, so that it can be kept.
    """

    label: str
    symbol: str
    content: Callable[[Workspace, Dataset, Mapping[str, str], Mapping[str, str]], dict[str, Any] | None]
    method: str = ""
    segments: Callable[[Mapping[str, Any]], Iterable[tuple[str, int, int]]] = lambda content: ()
    keys: tuple[str, ...] = ()
    options: Mapping[str, str] = field(default_factory=lambda: NOTHING)
    size: tuple[int, int] = (6, 5)
    lasting: bool = True


@dataclass(frozen=True)
class Place:
    """Something with a name that can be opened by its link.

    about: what it is, in a few words. opens: id of a folded part of that page which is opened as well.
    """

    name: str
    about: str
    address: str
    opens: str = ""


@dataclass(frozen=True)
class Feature:
    """A page and all that belongs to it.

    path: of the page in the address. label, symbol: its entry in the navigation.
    page: makes the page before any data is loaded. register: adds its callbacks to the app.
    shows: what it begins with, of "table", "chart" and "graph": their libraries are fetched with the page (loading.py).
    first_values: what the page shows of a dataset and a view (data of the stores), for the HTML that the browser gets
    first: id of a component -> its properties. Callbacks that fill the same places must then leave them as they are.
    drawings: id of a component that a library draws -> how the page's first picture draws it (first_picture.py).
    places: what of a workspace can be found by name on this page, for what a link shows (:mod:`webapp.shell.places`).
    keys: of its links. methods: name of the settings in the link -> the method they belong to; ``<name>-<parameter>``.
    on_every_page: those of these names whose settings stand in the links of all pages, as ``<parameter>`` alone.
    routes: the blueprints it serves. stores: components that stay when another page is opened.
    commands: its commands. recipes: method -> the commands that compute a result again.
    selections: what can be selected on it; clip_colours: values of "as" in the selection of a clip that it answers.
    plays: what the Stage plays for such a selection, None where nothing does. missing: what such a selection names
    that is not there, as a sentence. replay_on: stores whose change makes the selection play again.
    rights: what its routes and callbacks do to the workspace; those it does not name are for editors only.
    motion_kinds: made-up motion: kind -> opener of the data set ``~kind~...`` (see ``shell/virtual.py``).
    blocks: what boards and reports can show of it, by kind.
    """

    path: str
    label: str
    symbol: str
    page: Callable[[], Component]
    register: Callable[[Dash, Workspace], None]
    shows: tuple[str, ...] = ()
    first_values: Callable[[Workspace, str, Mapping[str, str]], Values] = lambda workspace, dataset, view: {}
    drawings: Mapping[str, Callable[[Mapping[str, Any], str], str]] = field(default_factory=lambda: NOTHING)
    places: Callable[[Workspace, Any], Iterable[Place]] = lambda workspace, shown: ()
    keys: LinkKeys = LinkKeys()
    methods: Mapping[str, str] = field(default_factory=lambda: NOTHING)
    on_every_page: tuple[str, ...] = ()
    routes: Callable[[Workspace], Sequence[Blueprint]] = lambda workspace: ()
    stores: Callable[[], list[Component]] = lambda: []
    header: Callable[[], list[Component]] = lambda: []
    commands: Mapping[str, Command] = field(default_factory=lambda: NOTHING)
    recipes: Mapping[str, Callable[[Path, Request], str]] = field(default_factory=lambda: NOTHING)
    selections: tuple[SelectionKind, ...] = ()
    clip_colours: tuple[str, ...] = ()
    plays: Callable[[Workspace, Dataset, Shown], StageRequest | None] = lambda workspace, dataset, shown: None
    missing: Callable[[Workspace, Shown], str | None] = lambda workspace, shown: None
    replay_on: tuple[str, ...] = ()
    motion_kinds: Mapping[str, Callable[[Workspace, str], Dataset]] = field(default_factory=lambda: NOTHING)
    blocks: Mapping[str, Block] = field(default_factory=lambda: NOTHING)
    rights: Rights = field(default_factory=Rights)


def register(feature: Feature) -> None:
    """Adds a feature; the navigation has them in the order in which they were added."""
    _features[feature.path] = feature


def unregister(path: str) -> None:
    """Takes a feature out again."""
    _features.pop(path, None)


def features() -> tuple[Feature, ...]:
    """All features, in the order of the navigation."""
    return tuple(_features.values())


def blocks() -> dict[str, Block]:
    """The blocks of all features, by kind."""
    return {kind: block for feature in features() for kind, block in feature.blocks.items()}


_features: dict[str, Feature] = {}
