"""What people say of a motif: its name, tags and a note; saved as one leaves a field."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import MotifNote, Workspace, WorkspaceError
from core.workspace.notes import LONGEST_NAME, MOST_TAGS
from webapp.shell import results
from webapp.shell.results import find_motif
from webapp.ui.tables import motif_rows

CARRIED = "Carried over from an earlier result, whose motif had most of these frames."


def layout() -> Component:
    """The form, and the message in its place while no motif is chosen."""
    return html.Div(
        className="notes-side",
        children=[
            html.P("Choose a motif to name it, tag it, or write a note.", id="notes-hint", className="muted"),
            html.Div(
                id="notes-form",
                className="notes-form hidden",
                children=[
                    html.Div(html.H2(id="notes-title"), className="section-head"),
                    dmc.TextInput(
                        id="notes-name",
                        label="Name",
                        placeholder="jumping jack",
                        debounce=True,
                        attributes={"input": {"maxLength": LONGEST_NAME}},
                    ),
                    dmc.TagsInput(
                        id="notes-tags",
                        label="Tags",
                        placeholder="Type one, then Enter",
                        maxTags=MOST_TAGS,
                        clearable=True,
                    ),
                    dmc.Textarea(id="notes-text", label="Note", autosize=True, minRows=3, maxRows=10, debounce=True),
                    html.Div(id="notes-status", className="muted notes-status", role="status"),
                ],
            ),
            dcc.Store(id="notes-motif"),
            dcc.Store(id="notes-names"),
            dcc.Store(id="notes-drawn"),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Fill the form, save it, and show the names everywhere."""

    @app.callback(
        Output("notes-hint", "className"),
        Output("notes-form", "className"),
        Output("notes-title", "children"),
        Output("notes-name", "value"),
        Output("notes-tags", "value"),
        Output("notes-text", "value"),
        Output("notes-motif", "data"),
        Output("notes-status", "children"),
        Input("selection", "data"),
        Input("notes-form", "id"),
        State("dataset", "data"),
        State("view", "data"),
    )
    def fill(selection, _form, name, view):
        graph = results.motif_graph(workspace, name, view) if name else None
        motif = find_motif(graph, (selection or {}).get("motif")) if graph else None
        if motif is None:
            return "muted", "notes-form hidden", "", "", [], "", None, ""
        note = results.motif_notes(workspace, name, view).get(motif.id, MotifNote())
        status = CARRIED if note.carried else ""
        return "hidden", "notes-form", f"Motif {motif.id}", note.name, list(note.tags), note.note, motif.id, status

    @app.callback(
        Output("notes-status", "children", allow_duplicate=True),
        Input("notes-name", "value"),
        Input("notes-tags", "value"),
        Input("notes-text", "value"),
        State("notes-motif", "data"),
        State("dataset", "data"),
        State("view", "data"),
        prevent_initial_call=True,
    )
    def save(name, tags, text, motif, dataset, view):
        if motif is None or not dataset:
            return no_update
        try:
            before = results.motif_notes(workspace, dataset, view).get(motif, MotifNote())
            note = (name or "", tuple(tags or ()), text or "")
            if note == (before.name, before.tags, before.note):
                return no_update
            graph = results.motif_graph(workspace, dataset, view)
            key = results.motif_graph_key(workspace, dataset, view)
            chosen = find_motif(graph, motif) if graph else None
            if key is None or chosen is None:
                return no_update
            dataset_id = workspace.info(dataset).id
            workspace.notes.put(dataset_id, key, motif, chosen.segments, name=note[0], tags=note[1], note=note[2])
        except WorkspaceError as error:
            return html.Span(str(error), className="error-text")
        return "Saved."

    @app.callback(
        Output("notes-names", "data"),
        Input("notes-status", "children"),
        Input("notes-form", "id"),
        State("notes-names", "data"),
        State("dataset", "data"),
        State("view", "data"),
    )
    def collect(_status, _form, before, name, view):
        now = said(results.motif_notes(workspace, name, view)) if name else {}
        return no_update if now == before else now

    @app.callback(
        Output("motif-table", "rowData"),
        Input("notes-names", "data"),
        State("dataset", "data"),
        State("view", "data"),
        prevent_initial_call=True,
    )
    def rows(_names, name, view):
        graph = results.motif_graph(workspace, name, view) if name else None
        if graph is None:
            return no_update
        return motif_rows(graph, workspace.open(name), results.motif_notes(workspace, name, view))

    app.clientside_callback(
        ClientsideFunction("names", "draw"),
        Output("notes-drawn", "data"),
        Input("notes-names", "data"),
        Input("motif-graph", "elements"),
    )
    app.clientside_callback(
        ClientsideFunction("names", "search"),
        Output("motifs-searched", "data"),
        Input("motif-search", "value"),
        Input("motif-table", "rowData"),
    )


def said(notes: Mapping[int, MotifNote]) -> dict[str, Any]:
    """Motif id -> [name, tags, note], for the boxes of the graph and the table."""
    return {str(motif): [note.name, list(note.tags), note.note] for motif, note in notes.items()}
