"""A walk through the motif graph: its path, how it is found, and how well it was made (by assets/motifs/walk.mjs)."""

from __future__ import annotations

from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import walks
from webapp.features.motifs.playing import walking
from webapp.shell import results
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon

MOST_SECONDS = 300  # of a random walk that one asks for here


def layout() -> Component:
    """The controls; what they stand for comes with the walk."""
    return html.Div(
        className="walk-side",
        children=[
            html.Div(
                [html.H2("Walk", id="walk-title"), html.Span(id="walk-length", className="muted")],
                className="section-head",
            ),
            html.P(id="walk-hint", className="muted walk-hint"),
            html.Ol(id="walk-path", className="walk-path", **attributes(aria_label="Path of the walk")),
            html.Div(id="walk-error", className="walk-error hidden", role="alert"),
            html.Div(id="walk-meters", className="walk-meters hidden"),
            html.Div(_buttons(), className="walk-buttons", role="group", **attributes(aria_label="The walk")),
            html.Div(id="walk-notes", className="walk-notes muted"),
            html.Hr(className="walk-rule"),
            html.Div(_add(), className="walk-row"),
            html.Div(_between(), className="walk-row"),
            html.Div(_random(), className="walk-row"),
            html.Div(_choices(), className="walk-choices"),
            html.P(id="walk-ways", className="muted walk-ways"),
            *(dcc.Store(id=f"walk-{name}") for name in ("data", "drawn")),
        ],
    )


def _buttons() -> list[Component]:
    return [
        _button([icon("play", 14), "Play"], "play", "Play the walk from its start"),
        html.A(
            [icon("download", 14), "BVH"], id="walk-bvh", className="walk-button", title="Save the walk as a BVH file"
        ),
        html.A(
            [icon("download", 14), "JSON"],
            id="walk-json",
            className="walk-button",
            title="Save where every frame comes from, and the meters",
        ),
        *(html.Button(label, type="button", className="walk-button walk-recipe") for label in ("Command", "Python")),
        _button("Clear", "clear", "Begin a new path"),
    ]


def _add() -> list[Component]:
    return [
        html.Label("Add", htmlFor="walk-add", className="walk-label"),
        html.Select(id="walk-add", className="walk-select"),
    ]


def _between() -> list[Component]:
    return [
        html.Label("From", htmlFor="walk-from", className="walk-label"),
        html.Select(id="walk-from", className="walk-select"),
        html.Label("to", htmlFor="walk-to"),
        html.Select(id="walk-to", className="walk-select"),
        _button("Fewest steps", "fewest", "The way with the fewest motifs"),
        _button("Most used", "used", "The way along the edges that were seen most often"),
    ]


def _random() -> list[Component]:
    number: dict[str, Any] = {"type": "number", "className": "walk-number"}
    return [
        html.Span("Random", className="walk-label"),
        dcc.Input(id="walk-seconds", value=30, min=1, max=MOST_SECONDS, step=1, **number),
        html.Label("s, seed", htmlFor="walk-seed"),
        dcc.Input(id="walk-seed", value=1, min=0, max=999999999, step=1, **number),
        _button([icon("dice", 16), "Roll"], "random", "A random walk; each roll takes the next seed"),
    ]


def _choices() -> list[Component]:
    return [
        dmc.Switch(id="walk-extra", label="Further transition points", size="xs"),
        dmc.Switch(id="walk-bridge", label="Bridge gaps by a blend", size="xs"),
        dmc.Switch(id="walk-stop", label="Random walks stop at dead ends", size="xs"),
        dmc.Switch(id="walk-feet", label="Keep feet where they stand", size="xs", checked=True),
    ]


def _button(label, action: str, tip: str) -> Component:
    return html.Button(label, type="button", className="walk-button", title=tip, **attributes(data_walk=action))


def register(app: Dash, workspace: Workspace) -> None:
    """The walk of the link is made on the server; everything else happens in the browser."""

    @app.callback(
        Output("walk-data", "data"),
        Input("view", "data"),
        Input("motifs-result-key", "data"),
        Input("walk-path", "id"),
        Input("notes-names", "data"),
        State("dataset", "data"),
        State("walk-data", "data"),
    )
    def make(view, key, _path, _names, name, before):
        if not walking(view) or not key or not name:
            return no_update
        try:
            dataset = workspace.open(name)
            graph = results.shown_graph(workspace, key, name, view)
            if graph is None:
                return no_update
            names = {m: note.name for m, note in results.motif_notes(workspace, name, view).items() if note.name}
            data = walks.walk_data(workspace, dataset, graph, key, view, names)
        except WorkspaceError as error:
            data = {"key": key, "asked": walks.link_keys_of(view), "error": str(error)}
        return no_update if data == before else data

    app.clientside_callback(
        ClientsideFunction("walk", "draw"),
        Output("walk-drawn", "data"),
        Input("walk-data", "data"),
        Input("view", "data"),
        Input("walk-path", "id"),
        Input("motif-graph", "elements"),
        State("selection", "data"),
    )
    app.clientside_callback(
        ClientsideFunction("walk", "option"),
        Input("walk-extra", "checked"),
        Input("walk-bridge", "checked"),
        Input("walk-stop", "checked"),
        Input("walk-feet", "checked"),
        State("view", "data"),
        prevent_initial_call=True,
    )
