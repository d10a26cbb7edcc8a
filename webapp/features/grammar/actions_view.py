"""The actions as cards, and the occurrences of the chosen one: which a click plays and a field names."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.development.base_component import Component

from core.workspace import MotifNote, Workspace, WorkspaceError
from core.workspace.notes import LONGEST_NAME
from webapp.features.grammar import grammars, names
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import DATASET, SELECTION, VIEW

ORDERS = (("id", "By number"), ("count", "Most frequent first"), ("seconds", "Longest first"), ("name", "By name"))
CARRIED = "Carried over from an earlier result that has most of these frames."


def layout() -> Component:
    """Cards on the left, the chosen action on the right; assets/grammar/actions.mjs fills both."""
    return html.Div(
        className="actions-view",
        children=[
            html.Div(
                [
                    dmc.Select(
                        id=names.ACTION_ORDER,
                        data=[{"value": value, "label": label} for value, label in ORDERS],
                        value="id",
                        size="xs",
                        w=190,
                        allowDeselect=False,
                        **attributes(aria_label="Order of the actions"),
                    ),
                    html.Div(id=names.ACTION_CARDS, className="action-cards"),
                ],
                className="actions-all",
            ),
            html.Div(className="card actions-one", children=_one()),
        ],
    )


def _one() -> list[Component]:
    return [
        html.Div(
            [
                html.Div(icon("play", 26), className="empty-icon"),
                html.P("Choose an action to see all its occurrences play together.", className="muted"),
            ],
            id=names.ACTION_HINT,
            className="selection-hint",
        ),
        html.Div(
            id=names.ACTION_DETAIL,
            className="hidden",
            children=[
                html.Div(
                    [
                        html.H2(id=names.ACTION_TITLE),
                        html.Span(id=names.ACTION_COUNT, className="muted"),
                        html.Div(className="spacer"),
                        html.Button(
                            [icon("play", 14), "Play all"], id=names.ACTION_ALL, type="button", className="walk-button"
                        ),
                    ],
                    className="section-head",
                ),
                dmc.TextInput(
                    id=names.ACTION_NAME,
                    className="for-editors-to-change",
                    label="Name",
                    placeholder="side step",
                    debounce=True,
                    attributes={"input": {"maxLength": LONGEST_NAME, "autoComplete": "off"}},
                ),
                html.Div(id=names.ACTION_NAME_STATUS, className="muted notes-status", role="status"),
                html.Div(id=names.OCCURRENCES, className="occurrences"),
                dcc.Store(id=names.ACTION_NAMED),  # the action that the field names
            ],
        ),
    ]


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that fill the field with the name and save what is typed."""

    @app.callback(
        Output(names.ACTION_NAME, "value"),
        Output(names.ACTION_NAMED, "data"),
        Output(names.ACTION_NAME_STATUS, "children"),
        Input(SELECTION, "data"),
        Input(names.ACTION_NAME, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def fill(selection, _field, name, view):
        action = (selection or {}).get("action")
        notes = grammars.notes_of(workspace, name, view) if name and action is not None else None
        if notes is None or action is None:
            return "", None, ""
        note = notes.get(int(action), MotifNote())
        return note.name, int(action), CARRIED if note.carried and note.name else ""

    @app.callback(
        Output(names.ACTION_NAME_STATUS, "children", allow_duplicate=True),
        Output(names.GRAMMAR_NAMES, "data", allow_duplicate=True),
        Input(names.ACTION_NAME, "value"),
        State(names.ACTION_NAMED, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def save(text, action, name, view):
        if action is None or not name:
            return no_update, no_update
        try:
            saved = grammars.name_action(workspace, name, view, action, text or "")
        except WorkspaceError as error:
            return html.Span(str(error), className="error-text"), no_update
        return ("Saved.", grammars.names_mark(workspace, name, view)) if saved else (no_update, no_update)
