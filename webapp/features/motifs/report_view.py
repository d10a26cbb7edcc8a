"""The coverage report: near-duplicates, rare postures, and which clips to keep."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, dcc, html
from dash.development.base_component import Component

from core.motifs.graph import MotifGraph
from core.motifs.redundancy import Redundancy
from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import names, on_demand
from webapp.features.motifs.figures.redundancy import CLIP_COLUMNS, clip_rows, copy_entries, kept_chart, rare_entries
from webapp.shell import recipes, results
from webapp.shell.buttons import copies, sends
from webapp.shell.names import SELECTION
from webapp.ui import charts
from webapp.ui.downloads import chart_menu, table_download
from webapp.ui.tables import grid

MOST_GROUPS = 40
REPORT = on_demand.OnDemand(
    name="report",
    method="redundancy",
    ids=names.REPORT,
    symbol="graph",
    doing="Making the report",
    missing="No report yet",
    hint="It lists near-duplicates, rare postures, and the clips to keep.",
    button="Make the report",
    refused="Cannot make the report",
    frame=lambda waiting: html.Div(waiting, className="card"),
)


def layout() -> Component:
    """The place of the report."""
    return html.Div([html.Div(id=REPORT.ids.place), *REPORT.stores()], className="report-view")


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that start the job of the report, follow it and show the report."""

    def shown(report: Redundancy, name: str, view: Mapping[str, Any] | None, scheme: str | None) -> Component:
        recipe = recipes.script(workspace.path, REPORT.request(name, view))
        graph = results.motif_graph(workspace, name, view)
        if graph is None:
            raise WorkspaceError("The motifs of this report are no longer there; find them again.")
        return body(report, graph, workspace.open(name), scheme, recipe)

    on_demand.register(app, workspace, REPORT, shown)


def body(report: Redundancy, graph: MotifGraph, dataset: Any, scheme: str | None, recipe: str = "") -> Component:
    """The report in full; recipe: the Python script that makes it again."""
    chart = kept_chart(report, scheme)
    return html.Div(
        [
            html.P(sentence(report), className="report-sentence"),
            dmc.Button("Copy as Python", variant="default", size="compact-sm", mb="sm", **copies(recipe)),
            html.Div(
                [
                    html.Div(
                        [html.H3("What the clips hold"), chart_menu(names.REPORT_CHART, "keep-list")],
                        className="chart-head",
                    ),
                    dcc.Graph(id=names.REPORT_CHART, figure=chart, config=charts.CONFIG, style=charts.tall(chart)),
                ],
                className="card chart-card",
            ),
            html.Div(
                [html.H3("Keep-list"), html.Div(className="spacer"), table_download("report-clips", "keep-list")],
                className="chart-head",
            ),
            grid("report-clips", CLIP_COLUMNS, clip_rows(report), "Clips, those that add most first", row_height=34),
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
        return html.P("No two motions of a motif are near-duplicates.", className="muted")
    rows = [
        html.Div(
            [
                html.Img(src=entry["strip"], className="filmstrip", alt=""),
                html.Span(f"Motif {entry['motif']}", className="copies-motif"),
                html.Div(
                    [
                        html.Button(text, type="button", className="copy-chip", **sends(SELECTION, selection))
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
        **sends(SELECTION, entry["selection"]),
    )
