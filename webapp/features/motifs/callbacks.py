"""The Motifs page's callbacks: show the graph, its motifs and their motions."""

from __future__ import annotations

from urllib.parse import urlencode

from dash import Dash, Input, Output, State, dcc
from dash.dependencies import ClientsideFunction

from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import layout, stability_marks, views
from webapp.features.motifs.figures import graph as graph_figure
from webapp.features.motifs.graph_drawing import graph_elements
from webapp.shell import results, settings
from webapp.ui import method_page, tables


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    method_page.register(app, workspace, layout.METHOD)
    _show(app, workspace)
    _browse(app, workspace)
    views.register(app, workspace)
    stability_marks.register(app, workspace)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("motif-result", "children"),
        Output("motif-menus", "children"),
        Input("motifs-result-key", "data"),
        State("dataset", "data"),
        State("view", "data"),
        State("theme", "data"),
    )
    def show_result(key, name, view, scheme):
        graph = results.motif_graph(workspace, name, view) if key and name else None
        menus = method_page.earlier_menu(workspace, layout.METHOD, name, graph is not None)
        if graph is None:
            return [], menus
        query = urlencode({"dataset": name, **settings.texts(results.MOTIFS, view)})
        menus += layout.download_menu(graph, query, method_page.copy_items(workspace, layout.METHOD, name, view))
        dataset = workspace.open(name)
        elements = graph_elements(dataset, key, graph)
        return layout.result(graph, dataset, elements, scheme or "light"), menus


def _browse(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("motif-table-place", "children"),
        Input("motif-table-place", "id"),
        Input("motifs-result-key", "data"),
        State("dataset", "data"),
        State("view", "data"),
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
        # what is done to the table has its outputs beside it: where there is no table, Dash does not ask for it
        beside = [dcc.Store(id=name) for name in ("motifs-marked", "motifs-searched", "stability-listed")]
        return [tables.grid("motif-table", columns, rows, "All motifs"), *beside]

    @app.callback(
        Output("motif-selection", "children"),
        Output("motions", "data"),
        Input("selection", "data"),
        Input("motif-graph", "id"),
        State("dataset", "data"),
        State("view", "data"),
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

    app.clientside_callback(ClientsideFunction("motions", "list"), Input("motions", "data"))

    app.clientside_callback(
        ClientsideFunction("graph", "tapped"),
        Output("graph-tapped", "data"),
        Input("motif-graph", "tapNodeData"),
        Input("motif-graph", "tapEdgeData"),
    )
    app.clientside_callback(
        ClientsideFunction("graph", "mark"),
        Output("graph-marked", "data"),
        Input("selection", "data"),
        Input("edge-threshold", "value"),
        Input("motif-graph", "elements"),
    )
    app.clientside_callback(ClientsideFunction("graph", "tool"), Input("graph-tool", "data"), State("dataset", "data"))
    app.clientside_callback(
        ClientsideFunction("tables", "mark"),
        Output("motifs-marked", "data"),
        Input("selection", "data"),
        Input("motif-table", "rowData"),
        State("motif-table", "id"),
    )

    @app.callback(Output("motif-graph", "stylesheet"), Input("theme", "data"), prevent_initial_call=True)
    def restyle(scheme):
        return graph_figure.stylesheet(scheme or "light")
