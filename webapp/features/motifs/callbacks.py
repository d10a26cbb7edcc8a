"""The Motifs page's callbacks: show the graph, its motifs and their motions."""

from __future__ import annotations

from collections.abc import Mapping
from urllib.parse import urlencode

from dash import Dash, Input, Output, State, ctx, dcc, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import graph_parts, layout, names, stability_marks, views
from webapp.features.motifs.figures import graph as graph_figure
from webapp.features.motifs.graph_drawing import graph_elements
from webapp.shell import results, settings
from webapp.shell.feature import Values
from webapp.shell.names import DATASET, MOTIF_METHOD, SELECTION, THEME, VIEW
from webapp.ui import method_page, tables


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    method_page.register(app, workspace, layout.METHOD)
    _show(app, workspace)
    _browse(app, workspace)
    views.BELOW.register(app, workspace)
    views.BESIDE.register(app, workspace)
    stability_marks.register(app, workspace)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.MOTIF_RESULT, "children"),
        Output(names.MOTIF_MENUS, "children"),
        Output(names.MOTIFS_DRAWN, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        State(THEME, "data"),
        State(names.MOTIFS_DRAWN, "data"),
    )
    def show_result(key, name, view, scheme, drawn):
        if key and key == drawn:  # it came with the page
            return (no_update,) * 3
        return *result(workspace, key, name, view, scheme), key


def first_values(workspace: Workspace, dataset: str, view: Mapping[str, str]) -> Values:
    """The page with its graph, for the layout that the browser gets first; nothing where there is no result."""
    key = settings.key_of(workspace, results.MOTIFS, dataset, view)
    if key is None:
        return {}
    children, menus = result(workspace, key, dataset, view, None)
    return {
        MOTIF_METHOD.result_key: {"data": key},
        names.MOTIF_RESULT: {"children": children},
        names.MOTIF_MENUS: {"children": menus},
        names.MOTIFS_DRAWN: {"data": key},
    }


def result(
    workspace: Workspace, key: str | None, name: str | None, view: Mapping[str, str] | None, scheme: str | None
) -> tuple[Component | list[Component], list[Component]]:
    """What the page shows of the result with this key, and its menus. Raises WorkspaceError."""
    graph = results.motif_graph(workspace, name, view) if key and name else None
    menus = method_page.earlier_menu(workspace, layout.METHOD, name, graph is not None)
    if not (key and name and graph):
        return [], menus
    query = urlencode({"dataset": name, **settings.texts(results.MOTIFS, view)})
    menus += layout.download_menu(graph, query, method_page.copy_items(workspace, layout.METHOD, name, view))
    dataset = workspace.open(name)
    return layout.result(graph, dataset, graph_elements(dataset, key, graph), scheme or "light"), menus


def _browse(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.MOTIF_TABLE_PLACE, "children"),
        Input(names.MOTIF_TABLE_PLACE, "id"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def show_table(_place, key, name, view):
        graph = results.motif_graph(workspace, name, view) if key and name else None
        if graph is None:
            return []
        dataset = workspace.open(name)
        columns, rows = (
            tables.motif_columns(dataset),
            tables.motif_rows(graph, dataset, results.motif_notes(workspace, name, view)),
        )
        # these outputs are beside the table: without a table, Dash does not call them
        beside = [dcc.Store(id=name) for name in (names.MOTIFS_MARKED, names.MOTIFS_SEARCHED, names.STABILITY_LISTED)]
        return [tables.grid(names.MOTIF_TABLE, columns, rows, "All motifs"), *beside]

    @app.callback(
        Output(names.MOTIF_SELECTION, "children"),
        Output(names.MOTIONS, "data"),
        Input(SELECTION, "data"),
        Input(names.MOTIF_GRAPH, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def show_selection(selection, _graph, name, view):
        try:
            graph = results.motif_graph(workspace, name, view)
            if graph is None:
                return [], {}
            dataset, chosen = workspace.open(name), selection or {}
            notes = results.motif_notes(workspace, name, view)
            return layout.selection_panel(graph, chosen, notes), layout.motion_list(dataset, graph, chosen)
        except WorkspaceError:
            return [], {}

    @app.callback(
        Output(names.MOTIF_GRAPH, "elements"),
        Output(names.GRAPH_PART, "value"),
        Output(names.GRAPH_PART_SHOWN, "data"),
        Output(names.GRAPH_PART_WORDS, "children"),
        Output(names.EDGE_THRESHOLD, "value"),
        Input(names.GRAPH_PART, "value"),
        Input(names.GRAPH_SOUGHT, "data"),
        State(names.GRAPH_PART_SHOWN, "data"),
        State(SELECTION, "data"),
        State(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def draw_part(part, _sought, shown, selection, key, name, view):
        graph = results.motif_graph(workspace, name, view) if key and name else None
        if graph is None or not shown:
            return (no_update,) * 5
        centre = graph_parts.chosen_motif(graph, selection)
        if ctx.triggered_id == names.GRAPH_SOUGHT and centre is not None:
            part = graph_parts.AROUND  # what was chosen is to be seen
        now = {"part": part, "centre": centre if part == graph_parts.AROUND else None}
        if now == shown:
            return (no_update,) * 5
        ids = graph_parts.ids_of_part(graph, part, centre)
        elements = graph_elements(workspace.open(name), key, graph, part, centre)
        threshold = graph_figure.first_threshold(graph_figure.counts_of(elements))
        return elements, part, now, graph_parts.words_of(graph, ids), threshold

    app.clientside_callback(ClientsideFunction("motions", "list"), Input(names.MOTIONS, "data"))

    app.clientside_callback(
        ClientsideFunction("graph", "tapped"),
        Output(names.GRAPH_TAPPED, "data"),
        Input(names.MOTIF_GRAPH, "tapNodeData"),
        Input(names.MOTIF_GRAPH, "tapEdgeData"),
    )
    app.clientside_callback(
        ClientsideFunction("graph", "mark"),
        Output(names.GRAPH_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(names.EDGE_THRESHOLD, "value"),
        Input(names.MOTIF_GRAPH, "elements"),
    )
    app.clientside_callback(
        ClientsideFunction("graph", "tool"), Input(names.GRAPH_TOOL, "data"), State(DATASET, "data")
    )
    app.clientside_callback(
        ClientsideFunction("tables", "mark"),
        Output(names.MOTIFS_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(names.MOTIF_TABLE, "rowData"),
        State(names.MOTIF_TABLE, "id"),
    )

    @app.callback(Output(names.MOTIF_GRAPH, "stylesheet"), Input(THEME, "data"), prevent_initial_call=True)
    def restyle(scheme):
        return graph_figure.stylesheet(scheme or "light")
