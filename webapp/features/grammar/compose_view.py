"""New routines: random ones, whose parts can then be changed (drawn by assets/grammar/compose.mjs)."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace, WorkspaceError
from webapp.features.grammar import compositions, names
from webapp.features.grammar.routines_view import tree_link
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, SELECTION, VIEW


def layout() -> Component:
    """The controls; their content comes with the routine."""
    return html.Div(
        className="compose-view",
        children=[
            html.Div(_buttons(), className="compose-bar", role="group", **attributes(aria_label="The new routine")),
            html.Div(id=names.COMPOSE_ERROR, className="walk-error hidden", role="alert"),
            html.P(id=names.COMPOSE_STATUS, className="muted view-hint", role="status"),
            html.Ol(
                id=names.COMPOSE_STRING,
                className="compose-string",
                **attributes(aria_label="Actions of the new routine"),
            ),
            html.Div(_chosen(), className="compose-bar", role="group", **attributes(aria_label="The chosen part")),
            html.Div(id=names.COMPOSE_OTHERS, className="compose-others hidden"),
            html.Div(
                html.Div(
                    id=names.COMPOSE_TREE, className="tree", role="group", **attributes(aria_label="How it is built")
                ),
                className="card tree-card",
            ),
            html.Div(
                [
                    html.Div(id=names.COMPOSE_METERS, className="walk-meters hidden"),
                    html.Div(_save(), className="compose-save"),
                ],
                className="compose-foot",
            ),
            html.Div(id=names.COMPOSE_WARNINGS, className="walk-notes muted"),
            dcc.Store(id=names.COMPOSE_DATA),
            dcc.Store(id=names.COMPOSE_DRAWN),
            dcc.Store(id=names.COMPOSE_OTHER_DATA),
            dcc.Store(id=names.COMPOSE_OTHER_DRAWN),
        ],
    )


def _buttons() -> list[Component]:
    return [
        _button([icon("dice", 16), "New routine"], "new", "Random routine"),
        html.Label("at most", htmlFor=names.COMPOSE_MOST, className="compose-most"),
        dcc.Input(
            id=names.COMPOSE_MOST,
            type="number",
            className="walk-number",
            value=compositions.USUAL_LENGTH,
            min=1,
            max=compositions.MOST_LENGTH,
            step=1,
        ),
        html.Span("actions"),
        _button([icon("restore", 14), "Undo"], "undo", "Back to the routine before (Ctrl+Z)"),
        _button([icon("retry", 14), "Redo"], "redo", "Forward again (Ctrl+Shift+Z)"),
        html.Div(className="spacer"),
        _button([icon("play", 14), "Play"], "play", "Play the routine from its start"),
        html.A(
            [icon("download", 14), "BVH"], id=names.COMPOSE_BVH, className="walk-button", title="Save the motion as BVH"
        ),
        tree_link(names.COMPOSE_JSON, "JSON", "Save the source of every frame, and the quality measures"),
        *(
            html.Button(label, type="button", className="walk-button compose-recipe", **attributes(data_recipe=words))
            for label, words in (("Command", "Copy as commands"), ("Python", "Copy as Python"))
        ),
    ]


def _chosen() -> list[Component]:
    return [
        html.Div(id=names.COMPOSE_CHOSEN, className="compose-chosen muted", role="status"),
        html.Div(className="spacer"),
        _button([icon("plus", 14), "Larger"], "larger", "Take in more: the phrase around it"),
        _button([icon("minus", 14), "Smaller"], "smaller", "Take in less: the phrase within it"),
        _button([icon("dice", 14), "Four others"], "others", "Show four other ways for the chosen part, side by side"),
        tree_link(names.COMPOSE_SVG, "Tree", "Save the tree as a drawing (SVG)"),
        html.Button(
            [icon("download", 14), "PNG"],
            type="button",
            className="walk-button tree-png",
            title="Save the tree as a picture",
            **attributes(data_link=names.COMPOSE_SVG),
        ),
    ]


def _save() -> list[Component]:
    return [
        dmc.TextInput(
            id=names.COMPOSE_NAME,
            label="Keep it in the library",
            placeholder="a name",
            size="xs",
            attributes={"input": {"maxLength": 60, "autoComplete": "off"}},
        ),
        html.Button(
            [icon("check", 14), "Keep"], id=names.COMPOSE_SAVE, type="button", className="walk-button for-editors"
        ),
        html.Div(id=names.COMPOSE_SAVE_STATUS, className="muted", role="status"),
    ]


def _button(label, action: str, tip: str) -> Component:
    return html.Button(label, type="button", className="walk-button", title=tip, **attributes(data_compose=action))


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks: the server makes routines and alternatives, the browser does the rest."""

    @app.callback(
        Output(names.COMPOSE_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.GRAMMAR_DATA, "data"),
        Input(names.COMPOSE_TREE, "id"),
        State(DATASET, "data"),
        State(names.COMPOSE_DATA, "data"),
    )
    def make(view, _data, _place, name, before):
        if not compositions.is_composing(view) or not name or not (view or {}).get("sentence"):
            return no_update
        data = compositions.composed(workspace, name, view)
        return no_update if data is None or data == before else data

    @app.callback(
        Output(names.COMPOSE_OTHER_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.COMPOSE_DATA, "data"),
        State(DATASET, "data"),
        State(names.COMPOSE_OTHER_DATA, "data"),
    )
    def others(view, _data, name, before):
        if not compositions.is_composing(view) or not name or not (view or {}).get("alt"):
            return no_update
        data = compositions.alternatives(workspace, name, view)
        return no_update if data is None or data == before else data

    @app.callback(
        Output(names.COMPOSE_SAVE_STATUS, "children"),
        Input(names.COMPOSE_SAVE, "n_clicks"),
        State(names.COMPOSE_NAME, "value"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def keep(_clicks, text, name, view):
        try:
            return compositions.keep(workspace, name, view, text or "")
        except WorkspaceError as error:
            return html.Span(str(error), className="error-text")

    app.clientside_callback(
        ClientsideFunction("grammar", "compose"),
        Output(names.COMPOSE_DRAWN, "data"),
        Input(names.COMPOSE_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.GRAMMAR_DATA, "data"),
        State(SELECTION, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("grammar", "others"),
        Output(names.COMPOSE_OTHER_DRAWN, "data"),
        Input(names.COMPOSE_OTHER_DATA, "data"),
        Input(VIEW, "data"),
    )
