"""The Motifs page's callbacks: read the form, ask for the work, show what is there."""

from __future__ import annotations

from urllib.parse import urlencode

from dash import ALL, Dash, Input, Output, State, ctx, dcc, no_update, set_props
from dash.dependencies import ClientsideFunction

from core import analyses
from core.errors import ParameterError
from core.workspace import Workspace, WorkspaceError
from webapp import jobs
from webapp.features.motifs import layout, stability_marks, views
from webapp.features.motifs.figures import graph as graph_figure
from webapp.features.motifs.graph_drawing import graph_elements
from webapp.shell import recipes, results
from webapp.shell.identifiers import Pattern
from webapp.shell.messages import notice
from webapp.ui import tables
from webapp.ui.parameter_form import parameter_form, read_form, summary


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    _ask(app, workspace)
    _show(app, workspace)
    _browse(app, workspace)
    views.register(app, workspace)
    stability_marks.register(app, workspace)


def _ask(app: Dash, workspace: Workspace) -> None:
    @app.callback(Output("motif-form", "children"), Output("settings-summary", "children"), Input("parameters", "data"))
    def show_form(parameters):
        values = results.motif_request("", parameters).parameters
        form = parameter_form(analyses.parameters(results.MOTIFS), values, Pattern("parameter", "name"))
        return form, summary(results.not_default(values))

    @app.callback(
        Output({"type": "parameter", "name": ALL}, "error"),
        Input("find-motifs", "n_clicks"),
        Input("find-again", "data"),
        State({"type": "parameter", "name": ALL}, "value"),
        State({"type": "parameter", "name": ALL}, "id"),
        State("dataset", "data"),
        prevent_initial_call=True,
    )
    def find(_clicks, _again, values, ids, dataset):
        taken, problems = read_form(analyses.parameters(results.MOTIFS), ids, values)
        if problems:
            set_props("settings", {"value": "form"})
            return [problems.get(component["name"]) for component in ids]
        try:
            if not dataset:
                raise WorkspaceError("Choose a dataset first; the library has none yet.")
            request = analyses.normalise(analyses.Request(dataset, results.MOTIFS, taken))
            if analyses.stored(workspace, request) is None:
                set_props("job-started", {"data": jobs.start(workspace, request).id})
            set_props("parameters", {"data": results.not_default(request.parameters)})
        except (ParameterError, WorkspaceError) as error:
            set_props("notices", {"sendNotifications": [notice("Cannot find motifs", str(error), "red")]})
        return [None] * len(ids)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("graph-key", "data"),
        Input("dataset", "data"),
        Input("parameters", "data"),
        Input("jobs-finished", "data"),
        Input("revision", "data"),
        State("graph-key", "data"),
    )
    def find_graph(dataset, parameters, _finished, _revision, current):
        key = results.motif_graph_key(workspace, dataset, parameters) if dataset else None
        return no_update if key == current and ctx.triggered_id in ("jobs-finished", "revision") else key

    @app.callback(
        Output("motif-status", "children"),
        Output("motif-status-of", "data"),
        Input("jobs-seen", "data"),
        Input("graph-key", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
        State("motif-status-of", "data"),
    )
    def show_status(_seen, key, dataset, parameters, current):
        job = results.latest_job(workspace, dataset, parameters) if dataset and not key else None
        of = [key, dataset, job and [job.id, job.state, job.error]]
        return (no_update, no_update) if of == current else (layout.status(dataset, job, bool(key)) or [], of)

    @app.callback(
        Output("motif-result", "children"),
        Output("motif-menus", "children"),
        Input("graph-key", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
        State("theme", "data"),
    )
    def show_result(key, name, parameters, scheme):
        graph = results.motif_graph(workspace, name, parameters) if key and name else None
        past = [
            (job, results.not_default(job.request["parameters"]))
            for job in (results.earlier(workspace, name) if name else [])
        ]
        query = urlencode({"dataset": name or "", **(parameters or {})})
        again = recipes.both(workspace.path, results.motif_request(name, parameters)) if graph else {}
        shown = layout.menus(name or "", graph, past, query, again)
        if graph is None:
            return [], shown
        dataset = workspace.open(name)
        elements = graph_elements(dataset, key, graph)
        return layout.result(graph, dataset, elements, scheme or "light"), shown


def _browse(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("motif-table-place", "children"),
        Input("motif-table-place", "id"),
        Input("graph-key", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
    )
    def show_table(_place, key, name, parameters):
        graph = results.motif_graph(workspace, name, parameters) if key and name else None
        if graph is None:
            return []
        dataset = workspace.open(name)
        columns, rows = (
            tables.motif_columns(dataset),
            tables.motif_rows(graph, dataset, results.motif_notes(workspace, name, parameters)),
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
        State("parameters", "data"),
    )
    def show_selection(selection, _graph, name, parameters):
        try:
            graph = results.motif_graph(workspace, name, parameters)
            if graph is None:
                return [], {}
            dataset, chosen = workspace.open(name), selection or {}
            notes = results.motif_notes(workspace, name, parameters)
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
