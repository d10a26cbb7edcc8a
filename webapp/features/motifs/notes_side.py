"""People's notes on a motif: its name, tags and a note, saved when a field loses the focus."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import MotifNote, Workspace, WorkspaceError
from core.workspace.notes import LONGEST_NAME, MOST_TAGS
from webapp.features.motifs import names
from webapp.shell import results
from webapp.shell.names import DATASET, SELECTION, VIEW
from webapp.shell.results import find_motif
from webapp.ui.tables import motif_rows

CARRIED = "Carried over from an earlier result, whose motif had most of these frames."


def layout() -> Component:
    """The form, and the message in its place while no motif is chosen."""
    return html.Div(
        className="notes-side",
        children=[
            html.P("Choose a motif to name it, tag it, or write a note.", id=names.NOTES_HINT, className="muted"),
            html.Div(
                id=names.NOTES_FORM,
                className="notes-form for-editors-to-change hidden",
                children=[
                    html.Div(html.H2(id=names.NOTES_TITLE), className="section-head"),
                    dmc.TextInput(
                        id=names.NOTES_NAME,
                        label="Name",
                        placeholder="jumping jack",
                        debounce=True,
                        attributes={"input": {"maxLength": LONGEST_NAME}},
                    ),
                    dmc.TagsInput(
                        id=names.NOTES_TAGS,
                        label="Tags",
                        placeholder="Type one, then Enter",
                        maxTags=MOST_TAGS,
                        clearable=True,
                    ),
                    dmc.Textarea(
                        id=names.NOTES_TEXT, label="Note", autosize=True, minRows=3, maxRows=10, debounce=True
                    ),
                    html.Div(id=names.NOTES_STATUS, className="muted notes-status", role="status"),
                ],
            ),
            dcc.Store(id=names.NOTES_MOTIF),
            dcc.Store(id=names.NOTES_NAMES),
            dcc.Store(id=names.NOTES_DRAWN),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Fill the form, save it, and show the names everywhere."""

    @app.callback(
        Output(names.NOTES_HINT, "className"),
        Output(names.NOTES_FORM, "className"),
        Output(names.NOTES_TITLE, "children"),
        Output(names.NOTES_NAME, "value"),
        Output(names.NOTES_TAGS, "value"),
        Output(names.NOTES_TEXT, "value"),
        Output(names.NOTES_MOTIF, "data"),
        Output(names.NOTES_STATUS, "children"),
        Input(SELECTION, "data"),
        Input(names.NOTES_FORM, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def fill(selection, _form, name, view):
        graph = results.motif_graph(workspace, name, view) if name else None
        motif = find_motif(graph, (selection or {}).get("motif")) if graph else None
        if motif is None:
            return "muted", "notes-form for-editors-to-change hidden", "", "", [], "", None, ""
        note = results.motif_notes(workspace, name, view).get(motif.id, MotifNote())
        status = CARRIED if note.carried else ""
        return (
            "hidden",
            "notes-form for-editors-to-change",
            f"Motif {motif.id}",
            note.name,
            list(note.tags),
            note.note,
            motif.id,
            status,
        )

    @app.callback(
        Output(names.NOTES_STATUS, "children", allow_duplicate=True),
        Input(names.NOTES_NAME, "value"),
        Input(names.NOTES_TAGS, "value"),
        Input(names.NOTES_TEXT, "value"),
        State(names.NOTES_MOTIF, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
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
        Output(names.NOTES_NAMES, "data"),
        Input(names.NOTES_STATUS, "children"),
        Input(names.NOTES_FORM, "id"),
        State(names.NOTES_NAMES, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def collect(_status, _form, before, name, view):
        now = names_data(results.motif_notes(workspace, name, view)) if name else {}
        return no_update if now == before else now

    @app.callback(
        Output(names.MOTIF_TABLE, "rowData"),
        Input(names.NOTES_NAMES, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def rows(_names, name, view):
        graph = results.motif_graph(workspace, name, view) if name else None
        if graph is None:
            return no_update
        return motif_rows(graph, workspace.open(name), results.motif_notes(workspace, name, view))

    app.clientside_callback(
        ClientsideFunction("names", "draw"),
        Output(names.NOTES_DRAWN, "data"),
        Input(names.NOTES_NAMES, "data"),
        Input(names.MOTIF_GRAPH, "elements"),
    )
    app.clientside_callback(
        ClientsideFunction("names", "search"),
        Output(names.MOTIFS_SEARCHED, "data"),
        Input(names.MOTIF_SEARCH, "value"),
        Input(names.MOTIF_TABLE, "rowData"),
    )


def names_data(notes: Mapping[int, MotifNote]) -> dict[str, Any]:
    """Motif id -> [name, tags, note], for the boxes of the graph and the table."""
    return {str(motif): [note.name, list(note.tags), note.note] for motif, note in notes.items()}
