"""The coverage report: what is there twice, what only once, and which clips to keep."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.development.base_component import Component

from core import analyses
from core.motifs.graph import MotifGraph
from core.motifs.redundancy import Redundancy
from core.parameters import ParameterError
from core.workspace import Workspace, WorkspaceError
from webapp import jobs, recipes, results
from webapp.components.actions import copies, sends
from webapp.components.downloads import chart_menu, table_download
from webapp.components.errors import empty_state, notice
from webapp.components.running import running
from webapp.figures import charts
from webapp.figures.redundancy import CLIP_COLUMNS, clip_rows, copy_entries, kept_chart, rare_entries
from webapp.figures.tables import grid

MOST_GROUPS = 40
METHOD = "redundancy"


def layout() -> Component:
    """The place of the report."""
    return html.Div(
        [html.Div(id="report-body"), dcc.Store(id="report-asked"), dcc.Store(id="report-shown")],
        className="report-view",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Ask for the report, follow its job, show it."""

    @app.callback(
        Output("report-asked", "data"),
        Input("report-find", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
        prevent_initial_call=True,
    )
    def ask(_clicked, name, parameters):
        try:
            job = jobs.start(workspace, report_request(name, parameters))
        except (ParameterError, WorkspaceError) as error:
            set_props("notices", {"sendNotifications": [notice("Cannot make the report", str(error), "red")]})
            return no_update
        set_props("job-started", {"data": job.id})
        return job.id

    @app.callback(
        Output("report-body", "children"),
        Output("report-shown", "data"),
        Input("view", "data"),
        Input("report-body", "id"),
        Input("report-asked", "data"),
        Input("jobs-finished", "data"),
        Input("theme", "data"),
        State("report-shown", "data"),
        State("graph-key", "data"),
        State("dataset", "data"),
        State("parameters", "data"),
    )
    def show(view, _body, _asked, _finished, scheme, shown, graph_key, name, parameters):
        if (view or {}).get("view") != "report" or not graph_key or not name:
            return no_update, no_update
        request = report_request(name, parameters)
        report = analyses.stored(workspace, request)
        job = None if report else workspace.jobs.latest(analyses.key(workspace, request))
        now = [graph_key, scheme, "there" if report else job.state if job else "", job.id if job else 0]
        if now == shown:
            return no_update, no_update
        if report is None:
            return _waiting(job), now
        graph = results.motif_graph(workspace, name, parameters)
        return body(report, graph, workspace.open(name), scheme, recipes.script(workspace.path, request)), now


def report_request(dataset: str, parameters: Mapping[str, Any] | None) -> analyses.Request:
    """The request for the report on the motif graph with these parameters."""
    return analyses.Request(dataset, METHOD, results.motif_request(dataset, parameters).parameters)


def _waiting(job: Any) -> Component:
    if job is not None and job.alive:
        return html.Div(running(job, "Making the report", "graph"), className="card")
    title, words = "No report yet", "It tells what is there twice, what only once, and which clips to keep."
    if job is not None and job.state == "failed":
        title, words = "Making the report failed", job.error
    elif job is not None and job.state == "cancelled":
        title, words = "Making the report was cancelled", "Nothing was kept of it."
    button = dmc.Button("Make the report", variant="light", **sends("report-find", {"find": True}, every_time=True))
    return html.Div(empty_state("graph", title, words, button), className="card")


def body(report: Redundancy, graph: MotifGraph, dataset: Any, scheme: str | None, recipe: str = "") -> Component:
    """The report in full; recipe: the Python script that makes it again."""
    return html.Div(
        [
            html.P(sentence(report), className="report-sentence"),
            dmc.Button("Copy as Python", variant="default", size="compact-sm", mb="sm", **copies(recipe)),
            html.Div(
                [
                    html.Div(
                        [html.H3("What the clips hold"), chart_menu("report-chart", "keep-list")],
                        className="chart-head",
                    ),
                    dcc.Graph(id="report-chart", figure=kept_chart(report, scheme), config=charts.CONFIG),
                ],
                className="card chart-card",
            ),
            html.Div(
                [html.H3("Keep-list"), html.Div(className="spacer"), table_download("report-clips", "keep-list")],
                className="chart-head",
            ),
            grid("report-clips", CLIP_COLUMNS, clip_rows(report), "Clips, the most telling first", row_height=34),
            html.H3("Near-duplicate motions"),
            _copies(copy_entries(report, graph, dataset)),
            html.H3("Rare postures"),
            html.P("How many times farther than usual the nearest posture of another occasion is.", className="muted"),
            html.Div([_rare(entry) for entry in rare_entries(report, dataset)], className="rare-postures"),
        ]
    )


def sentence(report: Redundancy) -> str:
    """The report in a sentence or two."""
    m = report.metrics
    unique = sum(clip.share < 0.25 for clip in report.clips)
    lines = [
        f"{100 * m['coverage']:.0f} % of all frames are in motifs;",
        f"{100 * m['copies']:.0f} % are near-duplicates of a motion kept.",
        f"{m['kept_clips']:.0f} of {len(report.clips)} clips ({m['kept_seconds']:.0f} of {m['seconds']:.0f} s)",
        "hold 95 % of what is distinct.",
        f"{unique or 'No'} clip{'s are' if unique != 1 else ' is'} mostly unique.",
    ]
    return " ".join(lines)


def _copies(entries: list[dict[str, Any]]) -> Component:
    if not entries:
        return html.P("No two motions of a motif are as alike as copies.", className="muted")
    rows = [
        html.Div(
            [
                html.Img(src=entry["strip"], className="filmstrip", alt=""),
                html.Span(f"Motif {entry['motif']}", className="copies-motif"),
                html.Div(
                    [
                        html.Button(text, type="button", className="copy-chip", **sends("selection", selection))
                        for text, selection in entry["motions"]
                    ],
                    className="copy-chips",
                ),
            ],
            className="copies-row",
        )
        for entry in entries[:MOST_GROUPS]
    ]
    more = len(entries) - MOST_GROUPS
    hint = html.P("Of each group the first is the one to keep.", className="muted")
    return html.Div([hint, *rows, html.P(f"and {more} more groups", className="muted") if more > 0 else None])


def _rare(entry: dict[str, Any]) -> Component:
    return html.Button(
        [
            *(html.Img(src=src, alt="", className=f"only-{scheme}") for scheme, src in entry["icons"].items()),
            html.Span(entry["times"], className="number"),
            html.Span(entry["where"], className="muted ellipsis"),
        ],
        type="button",
        className="rare-posture",
        title=f"Play {entry['where']}",
        **sends("selection", entry["selection"]),
    )
