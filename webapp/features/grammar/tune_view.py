"""How many actions to distinguish: a table and charts of each number's result, filled as they are computed."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.errors import ParameterError
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.features.grammar import action_counts, grammars, names
from webapp.features.grammar.figures import table as grammar_table
from webapp.jobs.names import JOBS_FINISHED, JOBS_SEEN
from webapp.jobs.running import running
from webapp.shell import settings
from webapp.shell.icons import icon
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, JOB_STARTED, NOTICES, THEME, VIEW, VIEW_CHANGE
from webapp.ui import method_page, tables
from webapp.ui.charts import CONFIG, empty
from webapp.ui.downloads import chart_menu, table_download

EXPLAINED = (
    "More actions look more alike within each, but recur less, so that less can be learned about their order. "
    "Find the number after which more of them no longer bring much."
)


def layout() -> Component:
    """Two sliders, the numbers to try, the charts and the table."""
    return html.Div(
        className="tune-view",
        children=[
            html.Div(_sliders(), className="card tune-bar tune-sliders"),
            html.Div(
                className="card tune-bar",
                children=[
                    dmc.TextInput(
                        id=names.TUNE_COUNTS,
                        label="Numbers of actions to compare",
                        debounce=500,
                        size="sm",
                        w=300,
                        attributes={"input": {"autoComplete": "off"}},
                    ),
                    html.Button(
                        [icon("sweep", 14), "Compare them"],
                        id=names.TUNE_RUN,
                        type="button",
                        className="walk-button tall",
                    ),
                    html.Div(id=names.TUNE_PLAN, className="muted number", role="status"),
                ],
            ),
            html.P(EXPLAINED, className="muted tune-note"),
            html.Div(id=names.TUNE_STATUS),
            dcc.Store(id=names.TUNE_STATUS_OF),
            dcc.Store(id=names.TUNE_SEEN),
            html.Div(
                id=names.TUNE_RESULT,
                className="hidden",
                children=[
                    html.Div(
                        [
                            _chart(names.TUNE_QUALITY, "How good the actions are", "actions quality"),
                            _chart(names.TUNE_RULES, "How many rules", "actions rules"),
                        ],
                        className="tune-charts",
                    ),
                    html.Div(
                        [
                            html.H2("All of them"),
                            html.Div(className="spacer"),
                            table_download(names.TUNE_TABLE, "actions"),
                        ],
                        className="section-head section",
                    ),
                    html.Div(id=names.TUNE_TABLE_PLACE),
                ],
            ),
        ],
    )


USUAL_NUMBER = 20


def _number(actions: int | str) -> int:
    """The number of actions that the slider shows; the middle of the usual ones where it is chosen automatically."""
    return USUAL_NUMBER if isinstance(actions, str) else actions


def _sliders() -> list[Component]:
    count, weight = (
        next(p for p in settings.parameters(grammars.PAGE) if p.name == name) for name in ("n_terminals", "weight")
    )
    return [
        _slider(names.TUNE_ACTIONS, "Number of actions", 2, 60, 1, _number(count.default), ""),
        _slider(names.TUNE_WEIGHT, "Alike … repeated", 0, 1, 0.01, weight.default, "wide"),
        html.Button(
            [icon("spark", 14), "Learn with these"], id=names.TUNE_LEARN, type="button", className="walk-button tall"
        ),
    ]


def _slider(identity: str, label: str, low: float, high: float, step: float, value: float, kind: str) -> Component:
    return html.Div(
        [
            html.Div(label, className="tune-label", id=names.TUNE_LABELS[identity]),
            dmc.Slider(
                id=identity,
                min=low,
                max=high,
                step=step,
                value=value,
                size="sm",
                labelAlwaysOn=True,
                thumbLabel=label,
                marks=[{"value": at, "label": f"{at:g}"} for at in (low, (low + high) / 2, high)],
            ),
        ],
        className=f"tune-slider {kind}",
    )


def _chart(identity: str, title: str, name: str) -> Component:
    return html.Div(
        [
            html.Div([html.H3(title), chart_menu(identity, name)], className="chart-head"),
            dcc.Graph(id=identity, figure=empty(), config=CONFIG, style={"height": "400px"}),
        ],
        className="card chart-card",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that fill the form, start the job, follow it and draw the results."""
    _fill(app, workspace)
    _ask(app, workspace)
    _follow(app, workspace)
    _draw(app, workspace)


def _fill(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.TUNE_COUNTS, "value"),
        Output(names.TUNE_ACTIONS, "value"),
        Output(names.TUNE_WEIGHT, "value"),
        Input(VIEW, "data"),
        Input(names.TUNE_RUN, "id"),
    )
    def fill(view, _run_button):
        values = analyses.normalise(settings.request_of(grammars.PAGE, "", view)).parameters
        return action_counts.counts_text(view), _number(values["n_terminals"]), values["weight"]

    @app.callback(
        Output(names.TUNE_PLAN, "children"),
        Output(names.TUNE_COUNTS, "error"),
        Input(names.TUNE_COUNTS, "value"),
        Input(names.TUNE_SEEN, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def plan(text, _seen, name, view):
        try:
            points = action_counts.points(workspace, name, {**(view or {}), "counts": text or ""})
        except (ParameterError, WorkspaceError) as error:
            return "", str(error)
        there, total = sum(point is not None for point in points), len(points)
        return f"{total} numbers" + (f", {there} of them computed" if there else ""), None


def _ask(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.TUNE_RUN, "disabled"),
        Input(names.TUNE_RUN, "n_clicks"),
        State(names.TUNE_COUNTS, "value"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def run(_clicks, text, name, view):
        if text is None:  # the form has not come yet; it will show the numbers of the link
            text = action_counts.counts_text(view)
        comparison_view = {**(view or {}), "counts": text}
        try:
            if not name:
                raise WorkspaceError("Choose a dataset first; the library has none yet.")
            if any(point is None for point in action_counts.points(workspace, name, comparison_view)):
                set_props(JOB_STARTED, {"data": jobs.start(workspace, action_counts.request(name, comparison_view)).id})
            set_props(VIEW_CHANGE, {"data": {"counts": action_counts.counts_change(text)}})
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot compare these", str(error), "red")]})
        return False

    @app.callback(
        Output(names.TUNE_LEARN, "disabled"),
        Input(names.TUNE_LEARN, "n_clicks"),
        State(names.TUNE_ACTIONS, "value"),
        State(names.TUNE_WEIGHT, "value"),
        State(names.TUNE_COUNTS, "value"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def learn(_clicks, count, weight, text, name, view):
        values = dict(settings.request_of(grammars.PAGE, name or "", view).parameters)
        if text is not None:  # else the form has not come yet; it will show the settings of the link
            values |= {"n_terminals": count, "weight": weight}
        try:
            method_page.ask(workspace, grammars.PAGE, name, values)
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot learn with these", str(error), "red")]})
        return False


def _follow(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.TUNE_STATUS, "children"),
        Output(names.TUNE_STATUS_OF, "data"),
        Output(names.TUNE_SEEN, "data"),
        Output(names.TUNE_RESULT, "className"),
        Input(VIEW, "data"),
        Input(DATASET, "data"),
        Input(JOBS_SEEN, "data"),
        Input(JOBS_FINISHED, "data"),
        Input(names.TUNE_RUN, "id"),
        State(names.TUNE_STATUS_OF, "data"),
        State(names.TUNE_SEEN, "data"),
    )
    def look(view, name, _seen, _finished, _run_button, shown_status, seen):
        if (view or {}).get("show") != "tune" or not name:
            return (no_update,) * 4
        try:
            points = action_counts.points(workspace, name, view)
            job = workspace.jobs.latest(analyses.key(workspace, action_counts.request(name, view)))
        except (ParameterError, WorkspaceError):
            return [], None, None, "hidden"
        ready = [point.key for point in points if point is not None]
        now = [name, job.id, job.state] if job is not None else [name]
        if job is not None and job.alive:
            strip: Component | list[Component] = running(job, "Comparing", "sweep", "card sweep-running section")
        else:
            strip = _ended(job)
        return (
            no_update if now == shown_status else strip,
            no_update if now == shown_status else now,
            no_update if ready == seen else ready,
            "" if ready else "hidden",
        )


def _ended(job: Job | None) -> Component | list[Component]:
    if job is None or job.state not in ("failed", "cancelled"):
        return []
    words = {"failed": f"Comparing failed: {job.error}", "cancelled": "Comparing was cancelled."}[job.state]
    words += " What is there stays; Compare them computes the others."
    return html.Div([icon("info", 16), html.Span(words)], className="card sweep-note section", role="status")


def _draw(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.TUNE_QUALITY, "figure"),
        Output(names.TUNE_RULES, "figure"),
        Output(names.TUNE_TABLE_PLACE, "children"),
        Input(names.TUNE_SEEN, "data"),
        Input(THEME, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def draw(seen, scheme, name, view):
        if not seen or not name:
            return (no_update,) * 3
        try:
            points = [p for p in action_counts.points(workspace, name, view) if p is not None]
        except (ParameterError, WorkspaceError):
            return (no_update,) * 3
        shown = _number(analyses.normalise(settings.request_of(grammars.PAGE, name, view)).parameters["n_terminals"])
        table = tables.grid(
            names.TUNE_TABLE, grammar_table.COLUMNS, grammar_table.rows(points), "Numbers of actions", row_height=34
        )
        return grammar_table.quality(points, scheme, shown), grammar_table.counts(points, scheme, shown), table

    for chart in (names.TUNE_QUALITY, names.TUNE_RULES):
        app.clientside_callback(ClientsideFunction("grammar", "open"), Input(chart, "clickData"))
