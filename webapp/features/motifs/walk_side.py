"""A walk through the motif graph: its path, how it is found, and how well it was made (by assets/motifs/walk.mjs)."""

from __future__ import annotations

from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import names, walks
from webapp.features.motifs.playing import walking
from webapp.shell import results
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, MOTIF_METHOD, SELECTION, VIEW

MOST_SECONDS = 300  # longest random walk


def layout() -> Component:
    """The controls; their content comes with the walk."""
    return html.Div(
        className="walk-side",
        children=[
            html.Div(
                [html.H2("Walk", id=names.WALK_TITLE), html.Span(id=names.WALK_LENGTH, className="muted")],
                className="section-head",
            ),
            html.P(id=names.WALK_HINT, className="muted walk-hint"),
            html.Ol(id=names.WALK_PATH, className="walk-path", **attributes(aria_label="Path of the walk")),
            html.Div(id=names.WALK_ERROR, className="walk-error hidden", role="alert"),
            html.Div(id=names.WALK_METERS, className="walk-meters hidden"),
            html.Div(_buttons(), className="walk-buttons", role="group", **attributes(aria_label="The walk")),
            html.Div(id=names.WALK_NOTES, className="walk-notes muted"),
            html.Hr(className="walk-rule"),
            html.Div(_add(), className="walk-row"),
            html.Div(_between(), className="walk-row"),
            html.Div(_random(), className="walk-row"),
            html.Div(_choices(), className="walk-choices"),
            html.P(id=names.WALK_WAYS, className="muted walk-ways"),
            dcc.Store(id=names.WALK_DATA),
            dcc.Store(id=names.WALK_DRAWN),
        ],
    )


def _buttons() -> list[Component]:
    return [
        _button([icon("play", 14), "Play"], "play", "Play the walk from its start"),
        html.A(
            [icon("download", 14), "BVH"],
            id=names.WALK_BVH,
            className="walk-button",
            title="Save the walk as a BVH file",
        ),
        html.A(
            [icon("download", 14), "JSON"],
            id=names.WALK_JSON,
            className="walk-button",
            title="Save the source of every frame, and the quality measures",
        ),
        *(html.Button(label, type="button", className="walk-button walk-recipe") for label in ("Command", "Python")),
        _button("Clear", "clear", "Begin a new path"),
    ]


def _add() -> list[Component]:
    return [
        html.Label("Add", htmlFor=names.WALK_ADD, className="walk-label"),
        html.Select(id=names.WALK_ADD, className="walk-select"),
    ]


def _between() -> list[Component]:
    return [
        html.Label("From", htmlFor=names.WALK_FROM, className="walk-label"),
        html.Select(id=names.WALK_FROM, className="walk-select"),
        html.Label("to", htmlFor=names.WALK_TO),
        html.Select(id=names.WALK_TO, className="walk-select"),
        _button("Fewest steps", "fewest", "The way with the fewest motifs"),
        _button("Most used", "used", "The way along the edges that were seen most often"),
    ]


def _random() -> list[Component]:
    number: dict[str, Any] = {"type": "number", "className": "walk-number"}
    return [
        html.Span("Random", className="walk-label"),
        dcc.Input(id=names.WALK_SECONDS, value=30, min=1, max=MOST_SECONDS, step=1, **number),
        html.Label("s, seed", htmlFor=names.WALK_SEED),
        dcc.Input(id=names.WALK_SEED, value=1, min=0, max=999999999, step=1, **number),
        _button([icon("dice", 16), "Roll"], "random", "A random walk; each roll takes the next seed"),
    ]


def _choices() -> list[Component]:
    return [
        dmc.Switch(id=names.WALK_EXTRA, label="Further transition points", size="xs"),
        dmc.Switch(id=names.WALK_BRIDGE, label="Bridge gaps by a blend", size="xs"),
        dmc.Switch(id=names.WALK_STOP, label="Random walks stop at dead ends", size="xs"),
        dmc.Switch(id=names.WALK_FEET, label="Keep feet where they stand", size="xs", checked=True),
    ]


def _button(label, action: str, tip: str) -> Component:
    return html.Button(label, type="button", className="walk-button", title=tip, **attributes(data_walk=action))


def register(app: Dash, workspace: Workspace) -> None:
    """The walk of the link is made on the server; everything else happens in the browser."""

    @app.callback(
        Output(names.WALK_DATA, "data"),
        Input(VIEW, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        Input(names.WALK_PATH, "id"),
        Input(names.NOTES_NAMES, "data"),
        State(DATASET, "data"),
        State(names.WALK_DATA, "data"),
    )
    def make(view, key, _path, _names, name, before):
        if not walking(view) or not key or not name:
            return no_update
        try:
            dataset = workspace.open(name)
            graph = results.shown_graph(workspace, key, name, view)
            if graph is None:
                return no_update
            motif_names = {m: note.name for m, note in results.motif_notes(workspace, name, view).items() if note.name}
            data = walks.walk_data(workspace, dataset, graph, key, view, motif_names)
        except WorkspaceError as error:
            data = {"key": key, "inputs": walks.link_keys_of(view), "error": str(error)}
        return no_update if data == before else data

    app.clientside_callback(
        ClientsideFunction("walk", "draw"),
        Output(names.WALK_DRAWN, "data"),
        Input(names.WALK_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.WALK_PATH, "id"),
        Input(names.MOTIF_GRAPH, "elements"),
        State(SELECTION, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("walk", "option"),
        Input(names.WALK_EXTRA, "checked"),
        Input(names.WALK_BRIDGE, "checked"),
        Input(names.WALK_STOP, "checked"),
        Input(names.WALK_FEET, "checked"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
