"""The rules compared with three simpler ways of making motion: a table, a chart, and motions side by side."""

from __future__ import annotations

import json

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.development.base_component import Component

from core.errors import ParameterError
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.features.grammar import bakeoffs, names
from webapp.features.grammar.figures import bakeoff as figures
from webapp.jobs.names import JOBS_FINISHED
from webapp.jobs.running import running
from webapp.shell import recipes
from webapp.shell.attributes import attributes
from webapp.shell.buttons import copies, sends
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, NOTICES, STAGE_REQUEST, THEME, VIEW
from webapp.ui import tables
from webapp.ui.charts import CONFIG
from webapp.ui.downloads import chart_menu, table_download

HINT = (
    "Routines are held out to see whether the rules, learned from the others, could have made them, and shuffled ones "
    "to see whether they refuse nonsense. A chain of neighbours, repeated strings and walks on the motif graph do the "
    "same, and all of them make new motion to look at."
)


def layout() -> Component:
    """The container of the figures, or of a message until they are computed."""
    return html.Div(
        [
            html.Div(id=names.BAKEOFF_PLACE),
            *(
                dcc.Store(id=store)
                for store in (names.BAKEOFF_RUN, names.BAKEOFF_JOB, names.BAKEOFF_SHOWN, names.BAKEOFF_PLAY)
            ),
        ],
        className="bakeoff-view",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that start the job, follow it, show the result and play its motions."""

    @app.callback(
        Output(names.BAKEOFF_JOB, "data"),
        Input(names.BAKEOFF_RUN, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def ask(_clicked, name, view):
        try:
            job = jobs.start(workspace, bakeoffs.request(name, view))
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot compare", str(error), "red")]})
            return no_update
        set_props(JOB_STARTED, {"data": job.id})
        return job.id

    @app.callback(
        Output(names.BAKEOFF_PLACE, "children"),
        Output(names.BAKEOFF_SHOWN, "data"),
        Input(VIEW, "data"),
        Input(names.BAKEOFF_JOB, "data"),
        Input(JOBS_FINISHED, "data"),
        Input(THEME, "data"),
        Input(names.BAKEOFF_PLACE, "id"),
        State(names.BAKEOFF_SHOWN, "data"),
        State(DATASET, "data"),
    )
    def show(view, _job, _finished, scheme, _place, shown, name):
        if (view or {}).get("show") != "compare" or not name:
            return no_update, no_update
        comparison = bakeoffs.find(workspace, name, view)
        job = None if comparison else bakeoffs.latest_job(workspace, name, view)
        now = [name, scheme, comparison[1] if comparison else "", [job.id, job.state] if job else None]
        if now == shown:
            return no_update, no_update
        if comparison is None:
            return html.Div(_waiting(job), className="card"), now
        again = recipes.texts(workspace.path, bakeoffs.request(name, view))
        return _result(*comparison, scheme, again), now

    @app.callback(
        Output(STAGE_REQUEST, "data", allow_duplicate=True),
        Input(names.BAKEOFF_PLAY, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def play(play_request, name, view):
        comparison = (
            bakeoffs.find(workspace, name, view) if play_request else None
        )  # it is called when the view appears, too
        return bakeoffs.stage_request(*comparison, play_request.get("only")) if comparison else no_update


def _waiting(job: Job | None) -> Component:
    if job is not None and job.alive:
        return running(job, "Comparing four ways", "branches")
    title, words = "Not compared yet", HINT
    if job is not None and job.state == "failed":
        title, words = "Comparing failed", job.error
    elif job is not None and job.state == "cancelled":
        title, words = "Comparing was cancelled", "No result was stored."
    asks = sends(names.BAKEOFF_RUN, {"ask": True}, every_time=True)
    return empty_state("branches", title, words, dmc.Button("Compare four ways", variant="light", **asks))


def _result(result, key: str, scheme: str | None, again: dict[str, str]) -> list[Component]:
    clips = [clip.name for clip in result.clips]
    plays = [_play("All side by side", {})] + [_play(figures.NAMES.get(n, n), {"only": n}) for n in clips]
    grid = tables.grid(
        names.BAKEOFF_TABLE,
        figures.columns(),
        figures.rows(result.contenders),
        "Four ways of making motion",
        row_height=36,
        headerHeight=50,
    )
    explanation = f"{result.sentences} routines were held out in turn, and {result.shuffles} shuffles of them tried."
    return [
        html.Div(plays, className="compose-bar", role="group", **attributes(aria_label="Play")),
        html.P(
            [explanation, *(f" {note[:1].upper()}{note[1:]}." for note in result.notes)], className="muted view-hint"
        ),
        html.Div(
            [
                html.Div(
                    [html.H3("How they compare"), chart_menu(names.BAKEOFF_CHART, "four ways")], className="chart-head"
                ),
                dcc.Graph(
                    id=names.BAKEOFF_CHART,
                    figure=figures.chart(result.contenders, scheme),
                    config=CONFIG,
                    style={"height": "470px"},
                ),
            ],
            className="card chart-card compare-charts",
        ),
        html.Div(
            [
                html.H2("All figures"),
                html.Div(className="spacer"),
                *(
                    html.Button(label, type="button", className="walk-button", **copies(text))
                    for label, text in again.items()
                ),
                html.A(
                    [icon("download", 14), "JSON"],
                    href=f"/api/bakeoff/{key}.json",
                    className="walk-button",
                    download="",
                ),
                table_download(names.BAKEOFF_TABLE, "four ways"),
            ],
            className="section-head section",
        ),
        grid,
    ]


def _play(label: str, value: dict[str, str]) -> Component:
    return html.Button(
        [icon("play", 14), label],
        type="button",
        className="walk-button",
        **attributes(data_store=names.BAKEOFF_PLAY, data_value=json.dumps(value), data_stamp="yes"),
    )
