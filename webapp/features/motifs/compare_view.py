"""Comparing the result that is shown with another of the same data set: an earlier one, or one with other settings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.errors import MotionscapeError
from core.motifs.compare import Comparison, compare
from core.motifs.graph import MotifGraph
from core.motifs.neighbours import neighbours, other_seeds
from core.motifs.parameters import MotifParameters
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.features.motifs import names
from webapp.features.motifs.figures import compare as figure
from webapp.features.motifs.playing import comparing, mixing, stage_request
from webapp.features.motifs.recipes import compare_commands, compare_script
from webapp.jobs.names import JOBS_FINISHED, JOBS_SEEN
from webapp.jobs.running import running
from webapp.shell import results, settings
from webapp.shell.attributes import attributes
from webapp.shell.buttons import copies, sends
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, MOTIF_METHOD, NOTICES, SELECTION, VIEW, VIEW_CHANGE
from webapp.ui import tables
from webapp.ui.downloads import table_download
from webapp.ui.parameter_form import summary

DEFAULT = "default"  # how the default settings are written


def layout() -> Component:
    """The choice of the other result, and the places of everything else."""
    return html.Div(
        className="compare-view",
        children=[
            html.Div(
                className="compare-bar",
                children=[
                    html.Label("Compare with", htmlFor=names.COMPARE_OTHER, className="muted"),
                    dmc.Select(
                        id=names.COMPARE_OTHER,
                        placeholder="Choose another result",
                        data=[],
                        searchable=True,
                        nothingFoundMessage="No such result",
                        comboboxProps={"shadow": "md"},
                        maxDropdownHeight=320,
                        className="compare-other",
                    ),
                ],
            ),
            html.Div(id=names.COMPARE_STATUS),
            html.Div(id=names.COMPARE_RESULT, className="compare-result hidden", children=_result()),
            dcc.Store(id=names.COMPARE_STATUS_OF),
            dcc.Store(id=names.COMPARE_KEYS),  # of both results, where both are there
            dcc.Store(id=names.COMPARE_FLOW_DATA),
            dcc.Store(id=names.COMPARE_REQUEST),  # what the Stage is to play
            dcc.Store(id=names.COMPARE_FIND),  # the button that has the other result computed
            dcc.Store(id=names.COMPARE_STARTED),
            dcc.Store(id=names.COMPARE_DRAWN),
            dcc.Store(id=names.COMPARE_MARKED),
            dcc.Store(id=names.COMPARE_ROW_MARKED),
        ],
    )


def _result() -> list[Component]:
    control = dmc.SegmentedControl(
        id=names.COMPARE_FILTER,
        data=[{"value": "all", "label": "All"}],
        value="all",
        size="xs",
        className="compare-filter",
        **attributes(aria_label="Which changes to list"),
    )
    bar = html.Div(
        [
            control,
            html.Div(className="spacer"),
            html.Div(id=names.COMPARE_AGAIN, className="head-menus"),
            table_download(names.COMPARE_TABLE, "comparison"),
        ],
        className="table-bar",
    )
    heads = html.Div([html.Span("This result"), html.Span("The other result")], className="compare-heads muted")
    return [
        html.P(id=names.COMPARE_SENTENCE, className="compare-sentence", role="status"),
        html.Div([heads, html.Div(id=names.COMPARE_FLOW, className="compare-flow")], className="card compare-card"),
        bar,
        tables.grid(names.COMPARE_TABLE, figure.COLUMNS, [], "Motifs of both results"),
    ]


def register(app: Dash, workspace: Workspace) -> None:
    """All of the view's callbacks."""
    _choose(app, workspace)
    _show(app, workspace)
    _play(app, workspace)


def _choose(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.COMPARE_OTHER, "data"),
        Output(names.COMPARE_OTHER, "value"),
        Input(VIEW, "data"),
        Input(names.COMPARE_OTHER, "id"),
        Input(MOTIF_METHOD.result_key, "data"),
        Input(JOBS_FINISHED, "data"),
        State(DATASET, "data"),
        State(names.COMPARE_OTHER, "data"),
    )
    def offer(view, _id, key, _finished, name, before):
        graph = results.shown_graph(workspace, key, name, view) if _shown(view) else None
        if graph is None:
            return no_update, no_update
        other = view.get("other")
        offered = choices(workspace, name, view, graph, other)
        return (no_update if offered == before else offered), other

    @app.callback(
        Output(VIEW_CHANGE, "data", allow_duplicate=True),
        Input(names.COMPARE_OTHER, "value"),
        State(VIEW, "data"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def choose(value, view, name):
        if not value or not name or value == (view or {}).get("other"):
            return no_update  # the link's value
        _start(workspace, name, value)
        return {"other": value, "gained": ""}

    @app.callback(
        Output(names.COMPARE_STARTED, "data"),
        Input(names.COMPARE_FIND, "data"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def compute(computation, name):
        if computation and name:
            _start(workspace, name, str(computation.get("other", "")))
        return no_update


def _start(workspace: Workspace, name: str, other: str) -> None:
    """Starts the job of the other result where it has not been computed."""
    try:
        if results.motif_graph_key(workspace, name, read_other(other)) is None:
            job = jobs.start(workspace, settings.request_of(results.MOTIFS, name, read_other(other)))
            set_props(JOB_STARTED, {"data": job.id})
    except MotionscapeError as error:
        set_props(NOTICES, {"sendNotifications": [notice("Cannot find the other motifs", str(error), "red")]})


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.COMPARE_STATUS, "children"),
        Output(names.COMPARE_RESULT, "className"),
        Output(names.COMPARE_KEYS, "data"),
        Output(names.COMPARE_STATUS_OF, "data"),
        Input(VIEW, "data"),
        Input(JOBS_SEEN, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        Input(names.COMPARE_STATUS, "id"),
        State(DATASET, "data"),
        State(names.COMPARE_STATUS_OF, "data"),
    )
    def show_status(view, _seen, key, _id, name, before):
        if not _shown(view) or results.shown_graph(workspace, key, name, view) is None:
            return (no_update,) * 4
        other = view.get("other")
        if other and read_other(other) == _settings_shown(view):
            other = None  # a result is not compared with itself
        other_view = read_other(other) if other else None
        other_key = results.motif_graph_key(workspace, name, other_view) if other else None
        job = settings.latest_job(workspace, results.MOTIFS, name, other_view) if other and not other_key else None
        status_key = [key, other, other_key, job and [job.id, job.state, job.error]]
        if status_key == before:
            return (no_update,) * 4
        keys = [key, other_key] if other_key else None
        return status(other, job, bool(other_key)), "compare-result" if other_key else "hidden", keys, status_key

    @app.callback(
        Output(names.COMPARE_SENTENCE, "children"),
        Output(names.COMPARE_FLOW_DATA, "data"),
        Output(names.COMPARE_FILTER, "data"),
        Output(names.COMPARE_FILTER, "value"),
        Output(names.COMPARE_AGAIN, "children"),
        Input(names.COMPARE_KEYS, "data"),
        State(VIEW, "data"),
        State(DATASET, "data"),
    )
    def show_result(keys, view, name):
        compared = _compared(workspace, name, view) if keys else None
        if compared is None:
            return (no_update,) * 5
        comparison, motif_names = compared[2], _names(workspace, name, view)
        again = _again(workspace, name, view)
        return (
            figure.sentence(comparison),
            figure.flow(comparison, motif_names),
            figure.filters(comparison),
            "all",
            again,
        )

    @app.callback(
        Output(names.COMPARE_TABLE, "rowData"),
        Input(names.COMPARE_FILTER, "value"),
        Input(names.COMPARE_FILTER, "data"),
        State(VIEW, "data"),
        State(DATASET, "data"),
    )
    def list_rows(change, _counts, view, name):
        compared = _compared(workspace, name, view) if _shown(view) and name else None
        if compared is None:
            return no_update
        a, b, comparison = compared
        listed = figure.rows(comparison, a, b, workspace.open(name), _names(workspace, name, view))
        return [row for row in listed if change in ("all", row["change"])]

    app.clientside_callback(
        ClientsideFunction("compare", "draw"),
        Output(names.COMPARE_DRAWN, "data"),
        Input(names.COMPARE_FLOW_DATA, "data"),
        State(SELECTION, "data"),
        State(VIEW, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("compare", "mark"),
        Output(names.COMPARE_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(VIEW, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("tables", "mark"),
        Output(names.COMPARE_ROW_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(names.COMPARE_TABLE, "rowData"),
        State(names.COMPARE_TABLE, "id"),
    )


def _play(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.COMPARE_REQUEST, "data"),
        Input(SELECTION, "data"),
        Input(VIEW, "data"),
        Input(names.COMPARE_KEYS, "data"),
        State(DATASET, "data"),
    )
    def play(selection, view, keys, name):
        selection = selection or {}
        if not name or not comparing(view) or ("motif" not in selection and not (view or {}).get("gained")):
            return no_update
        if mixing(view) or "motion" in selection or "edge" in selection or "clip" in selection:
            return no_update  # the blend side plays its mixture, playback.py the rest
        try:
            dataset, compared = workspace.open(name), _compared(workspace, name, view)
            if compared is None:  # the other result does not exist yet
                graph = results.motif_graph(workspace, name, view)
                return stage_request(dataset, graph, selection) or no_update
            return figure.pair_request(dataset, *compared, selection, view.get("gained", "")) or no_update
        except WorkspaceError:
            return no_update

    app.clientside_callback(ClientsideFunction("compare", "play"), Input(names.COMPARE_REQUEST, "data"))


def _again(workspace: Workspace, name: str, view: Mapping[str, str]) -> list[Component]:
    """Buttons that copy recipes for the comparison."""
    both = [settings.request_of(results.MOTIFS, name, shown) for shown in (view, read_other(view["other"]))]
    commands = {
        "Copy as commands": compare_commands(workspace.path, *both),
        "Copy as Python": compare_script(workspace.path, *both),
    }
    return [dmc.Button(label, size="compact-sm", variant="default", **copies(text)) for label, text in commands.items()]


def _shown(view: Mapping[str, str] | None) -> bool:
    return (view or {}).get("view") == "compare"


def _settings_shown(view: Mapping[str, str] | None) -> dict[str, str]:
    """The settings of the result that is shown, as :func:`read_other` gives those of the other."""
    return settings.in_link(results.MOTIFS, settings.request_of(results.MOTIFS, "", view).parameters)


def _names(workspace: Workspace, name: str, view: Mapping[str, str] | None) -> dict[int, str]:
    return {motif: note.name for motif, note in results.motif_notes(workspace, name, view).items()}


def _compared(
    workspace: Workspace, name: str, view: Mapping[str, str] | None
) -> tuple[MotifGraph, MotifGraph, Comparison] | None:
    other = (view or {}).get("other")
    a = results.motif_graph(workspace, name, view)
    b = results.motif_graph(workspace, name, read_other(other)) if other else None
    return None if a is None or b is None else (a, b, compare(a, b))


def choices(
    workspace: Workspace, name: str, view: Mapping[str, str] | None, graph: MotifGraph, chosen: str | None
) -> list[dict[str, Any]]:
    """What the shown result may be compared with, in groups: earlier results, and settings a step away."""
    settings_here = MotifParameters(**settings.request_of(results.MOTIFS, name, view).parameters)
    shown = write_other(asdict(settings_here))
    past: dict[str, str] = {}
    for job, texts in settings.earlier(workspace, results.MOTIFS, name):
        text = write_other(job.request["parameters"])
        if text != shown:
            past.setdefault(text, summary(texts))
    if chosen and read_other(chosen) != _settings_shown(view):
        past.setdefault(chosen, summary(read_other(chosen)))
    near = other_seeds(settings_here, 1) | neighbours(settings_here, int(graph.parameters["kappa"]))
    steps = {write_other(asdict(p)): f"Same, {words}" for words, p in near.items()}
    steps = {text: label for text, label in steps.items() if text not in past and text != shown}
    groups = (("Earlier results", past), ("Neighbouring settings (computed when chosen)", steps))
    return [
        {"group": title, "items": [{"value": text, "label": label} for text, label in items.items()]}
        for title, items in groups
        if items
    ]


def write_other(values: Mapping[str, Any]) -> str:
    """The settings of the other result as they stand in a link: ``kappa:250,seed:1``, defaults left out."""
    return settings.write_list(results.MOTIFS, values) or DEFAULT


def read_other(text: str) -> dict[str, str]:
    """Settings back from :func:`write_other`, as a view holds them; what makes no sense is left out."""
    return settings.read_list(results.MOTIFS, text)


def status(other: str | None, job: Job | None, ready: bool) -> Component | None:
    """The message in place of a comparison that does not exist yet."""
    if ready:
        return None
    if not other:
        hint = "Choose another result of these recordings to see which motifs it has too, and which not."
        return html.Div(empty_state("graph", "Nothing to compare with yet", hint), className="card")
    if job is not None and job.alive:
        return html.Div(running(job, "Finding the other motifs", "graph"), className="card")
    again = dmc.Button(
        "Find its motifs", variant="light", **sends(names.COMPARE_FIND, {"other": other}, every_time=True)
    )
    title, hint = "The other result is not there yet", f"Its settings: {summary(read_other(other))}."
    if job is not None and job.state == "failed":
        title, hint = "Finding the other motifs failed", job.error
    return html.Div(empty_state("graph", title, hint, again), className="card")
