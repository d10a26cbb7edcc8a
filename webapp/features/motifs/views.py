"""What the Motifs page shows below and beside its graph: one view and one side at a time, chosen in the store "view".

A view is a module with ``layout()``, its skeleton, and ``register(app, workspace)``, its callbacks. The skeletons come
into the page with each graph; a view's callbacks do nothing unless :func:`is_shown`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, html
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.features.motifs import (
    blend_side,
    compare_view,
    compression_view,
    names,
    notes_side,
    report_view,
    timeline_view,
    walk_side,
)
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import VIEW
from webapp.ui.downloads import table_download


class Part(NamedTuple):
    """One view: its value in the store, its name for people, its skeleton and its callbacks."""

    value: str
    label: str
    layout: Callable[[], Component]
    register: Callable[[Dash, Workspace], None]


def _motions() -> Component:
    return html.Div(
        [html.Div(id=names.MOTIF_SELECTION), html.Div(id=names.MOTION_LIST, className="motion-list")],
        className="side-motions",
    )


def _table() -> Component:
    search = dmc.TextInput(
        id=names.MOTIF_SEARCH,
        placeholder="Search names, tags, notes, labels",
        leftSection=icon("search", 14),
        size="xs",
        className="motif-search",
        **attributes(aria_label="Search motifs"),
    )
    bar = html.Div(
        [search, html.Div(className="spacer"), table_download(names.MOTIF_TABLE, "motifs")], className="table-bar"
    )
    return html.Div([bar, html.Div(id=names.MOTIF_TABLE_PLACE)])


def _nothing(app: Dash, workspace: Workspace) -> None:
    """Its callbacks stand in callbacks.py."""


PARTS: dict[str, tuple[Part, ...]] = {
    "view": (
        Part("table", "All motifs", _table, _nothing),
        Part("timeline", "Timeline", timeline_view.layout, timeline_view.register),
        Part("report", "Coverage report", report_view.layout, report_view.register),
        Part("compare", "Compare", compare_view.layout, compare_view.register),
        Part("compression", "Compression", compression_view.layout, compression_view.register),
    ),
    "side": (
        Part("motions", "Motions", _motions, _nothing),
        Part("blend", "Blend", blend_side.layout, blend_side.register),
        Part("walk", "Walk", walk_side.layout, walk_side.register),
        Part("notes", "Notes", notes_side.layout, notes_side.register),
    ),
}


def register(app: Dash, workspace: Workspace) -> None:
    """The switches, and the callbacks of every part."""
    for key, parts in PARTS.items():
        for part in parts:
            part.register(app, workspace)
        app.clientside_callback(
            ClientsideFunction("views", "chosen"), Input(names.SWITCHES[key], "value"), State(VIEW, "data")
        )
        app.clientside_callback(
            ClientsideFunction("views", "show"),
            Output(names.SWITCHES[key], "value"),
            Input(VIEW, "data"),
            Input(names.SWITCHES[key], "id"),
        )


def is_shown(view: Mapping[str, str] | None, key: str, value: str) -> bool:
    """Whether ``value`` is the part of ``key`` ("view" or "side") that people see now."""
    return ((view or {}).get(key) or PARTS[key][0].value) == value


def switch(key: str, label: str) -> Component:
    """The control that chooses among the parts of ``key``; nothing where there is no choice."""
    return dmc.SegmentedControl(
        id=names.SWITCHES[key],
        data=[{"value": part.value, "label": part.label} for part in PARTS[key]],
        value=PARTS[key][0].value,
        size="xs",
        className="view-switch" + ("" if len(PARTS[key]) > 1 else " hidden"),
        attributes={"root": {"data-key": key}},
        **attributes(aria_label=label),
    )


def panels(key: str) -> list[Component]:
    """The skeletons of all parts of ``key``; all but the first hidden until chosen (assets/shell/views.mjs)."""
    return [
        html.Div(
            part.layout(),
            className="view-panel" + (" hidden" if number else ""),
            **attributes(data_key=key, data_value=part.value),
        )
        for number, part in enumerate(PARTS[key])
    ]
