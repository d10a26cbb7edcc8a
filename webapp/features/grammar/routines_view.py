"""The routines of the recordings, and how each is built: a tree whose parts play."""

from __future__ import annotations

from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.features.grammar import grammars, names
from webapp.shell import settings
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, VIEW


def layout() -> Component:
    """The list, and the place of the tree; assets/grammar/routines.mjs fills both."""
    return html.Div(
        className="routines-view",
        children=[
            html.P(
                "A routine is a stretch of a recording that obeys the rules as a whole. Choose one to see how it is "
                "built, and a part of the tree to play it.",
                className="muted view-hint",
            ),
            html.Ol(id=names.ROUTINE_LIST, className="card routine-list", **attributes(aria_label="Routines")),
            html.Div(
                className="card tree-card",
                children=[
                    html.Div(
                        [
                            html.H3(id=names.ROUTINE_TITLE),
                            html.Span(id=names.ROUTINE_COUNT, className="muted"),
                            html.Div(className="spacer"),
                            html.Button(
                                [icon("play", 14), "Play"],
                                id=names.ROUTINE_PLAY,
                                type="button",
                                className="walk-button",
                            ),
                            tree_link(names.ROUTINE_SVG, "SVG", "Save the tree as a drawing"),
                            html.Button(
                                [icon("download", 14), "PNG"],
                                type="button",
                                className="walk-button tree-png",
                                title="Save the tree as a picture",
                                **attributes(data_link=names.ROUTINE_SVG),
                            ),
                        ],
                        className="tree-head",
                    ),
                    html.Div(
                        id=names.ROUTINE_TREE,
                        className="tree",
                        role="group",
                        **attributes(aria_label="How it is built"),
                    ),
                ],
            ),
            dcc.Store(id=names.ROUTINE_DATA),
            dcc.Store(id=names.ROUTINE_DRAWN),
        ],
    )


def tree_link(identity: str, label: str, tip: str) -> Component:
    """A link that saves a tree; its address is set in the browser."""
    return html.A([icon("download", 14), label], id=identity, className="walk-button disabled", title=tip)


def register(app: Dash, workspace: Workspace) -> None:
    """The tree of the routine that the link names, drawn on the server."""

    @app.callback(
        Output(names.ROUTINE_DATA, "data"),
        Input(VIEW, "data"),
        Input(names.GRAMMAR_DATA, "data"),
        Input(names.ROUTINE_TREE, "id"),
        State(DATASET, "data"),
        State(names.ROUTINE_DATA, "data"),
    )
    def draw(view, _data, _place, name, before):
        if (view or {}).get("show") != "routines" or not name:
            return no_update
        learned, key = grammars.learned(workspace, name, view), settings.key_of(workspace, grammars.PAGE, name, view)
        if learned is None or key is None:
            return no_update
        notes = grammars.notes_of(workspace, name, view) or {}
        number = grammars.routine_number(learned, view)
        routine = grammars.routines(learned)[number]
        segments = [segment for _, segment in routine.pieces]
        svg = grammars.routine_svg(workspace.open(name), learned, routine.tree, segments, notes)
        data = {"key": key, "number": number, "svg": svg}
        return no_update if data == before else data

    app.clientside_callback(
        ClientsideFunction("grammar", "routine"),
        Output(names.ROUTINE_DRAWN, "data"),
        Input(names.ROUTINE_DATA, "data"),
        Input(names.GRAMMAR_DATA, "data"),
        Input(VIEW, "data"),
    )
