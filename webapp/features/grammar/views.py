"""The views below the recordings: one at a time, chosen under "show" in the store "view" (assets/shell/views.mjs)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, html
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.features.grammar import actions_view, compare_view, compose_view, names, routines_view, tune_view
from webapp.shell.attributes import attributes
from webapp.shell.names import VIEW


class Part(NamedTuple):
    """One view: its value in the store, its name for people, its skeleton and its callbacks."""

    value: str
    label: str
    layout: Callable[[], Component]
    register: Callable[[Dash, Workspace], None]


def _rules() -> Component:
    return html.Div(id=names.GRAMMAR_RULES, className="grammar-rules", **attributes(aria_label="Rules"))


def _nothing(app: Dash, workspace: Workspace) -> None:
    """Nothing to register: its callbacks are in callbacks.py."""


PARTS = (
    Part("actions", "Actions", actions_view.layout, actions_view.register),
    Part("rules", "What follows what", _rules, _nothing),
    Part("routines", "Routines", routines_view.layout, routines_view.register),
    Part("compose", "Compose", compose_view.layout, compose_view.register),
    Part("tune", "How many actions", tune_view.layout, tune_view.register),
    Part("compare", "Compare", compare_view.layout, compare_view.register),
)


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the switch and the callbacks of every view."""
    for part in PARTS:
        part.register(app, workspace)
    app.clientside_callback(
        ClientsideFunction("views", "chosen"), Input(names.GRAMMAR_SHOW, "value"), State(VIEW, "data")
    )
    app.clientside_callback(
        ClientsideFunction("views", "show"),
        Output(names.GRAMMAR_SHOW, "value"),
        Input(VIEW, "data"),
        Input(names.GRAMMAR_SHOW, "id"),
    )


def is_shown(view: Mapping[str, str] | None, value: str) -> bool:
    """Whether ``value`` is the view that people see now."""
    return ((view or {}).get("show") or PARTS[0].value) == value


def switch() -> Component:
    """The control that chooses among the views."""
    return dmc.SegmentedControl(
        id=names.GRAMMAR_SHOW,
        data=[{"value": part.value, "label": part.label} for part in PARTS],
        value=PARTS[0].value,
        size="xs",
        className="view-switch",
        **attributes(aria_label="What to look at"),
    )


def panels() -> list[Component]:
    """The skeletons of all views; all but the first hidden until chosen."""
    return [
        html.Div(
            part.layout(),
            className="view-panel" + (" hidden" if number else ""),
            **attributes(data_key="show", data_value=part.value),
        )
        for number, part in enumerate(PARTS)
    ]
