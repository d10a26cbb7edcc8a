"""A page that shows the result of one method: its settings, the button that computes, progress, and what is there.

A page P has :func:`settings_fold` and :func:`status_place` in its layout, and calls :func:`register`. The store
``P-settings`` then holds the settings (``{"P-grid": "31x31"}``, defaults left out), and ``P-result-key`` the key of
their result, None where it has not been computed. Both stores stand in the frame of the app (:func:`stores`) where
other pages show the result too.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import dash_mantine_components as dmc
from dash import ALL, Dash, Input, Output, State, ctx, dcc, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.errors import ParameterError
from core.methods import METHODS
from core.mocap.rigs import kinds_in_words, left_out
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.jobs.names import JOBS_FINISHED, JOBS_SEEN
from webapp.jobs.running import running
from webapp.shell import recipes, settings
from webapp.shell.buttons import copies, sends
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, NOTICES, REVISION, SETTINGS_KEYS, VIEW, VIEW_CHANGE, MethodNames
from webapp.ui.parameter_form import parameter_form, read_form, summary


@dataclass(frozen=True)
class MethodPage:
    """The texts and settings of a page for its method.

    page: its name, as in Feature.methods; title: what the result is called ("Motion map"); action: what the button
    says ("Build map"); doing: what the job does ("Building the map"); hint: what the result shows, one sentence;
    without: parameters that the page sets in another way; refused: title of the notice where the job cannot start;
    run_symbol: the button's icon where it is not ``symbol``; everywhere: whether other pages show the result too (see
    :func:`stores`).
    """

    page: str
    title: str
    action: str
    doing: str
    symbol: str
    hint: str
    without: Collection[str] = ()
    refused: str = ""
    run_symbol: str = ""
    everywhere: bool = False

    @property
    def names(self) -> MethodNames:
        """Ids of its parts."""
        return MethodNames(self.page)

    @property
    def shown(self) -> list[analyses.Parameter]:
        """The parameters in the form."""
        return [p for p in settings.parameters(self.page) if p.name not in self.without]


def run_button(method: MethodPage) -> Component:
    """The button in the page's head that computes the result, with what that will take."""
    button = dmc.Button(method.action, id=method.names.run, leftSection=icon(method.run_symbol or method.symbol, 16))
    expected = html.Span(id=method.names.estimate, className="run-estimate muted number")
    return html.Div([expected, button], className="run-with-estimate")


def settings_fold(method: MethodPage) -> Component:
    """The settings, folded; the line that is always visible lists those that differ from the defaults. Below it stands
    which clips the method leaves out, where there are any."""
    head = [html.Span("Settings", className="settings-title"), html.Span(id=method.names.summary, className="muted")]
    fold = dmc.Accordion(
        id=method.names.fold,
        variant="contained",
        className="settings",
        value=None,
        children=dmc.AccordionItem(
            value="form",
            children=[dmc.AccordionControl(head), dmc.AccordionPanel(html.Div(id=method.names.form))],
        ),
    )
    return html.Div([fold, html.Div(id=method.names.left_out, className="left-out muted", role="note")])


def status_place(method: MethodPage) -> Component:
    """The place of the message shown while there is no result (see :func:`status`), and the page's stores."""
    page_stores = [dcc.Store(id=store) for store in (method.names.status_of, method.names.again)]
    return html.Div([html.Div(id=method.names.status), *page_stores, *([] if method.everywhere else stores(method))])


def stores(method: MethodPage) -> list[Component]:
    """The stores of the settings and the result key; in the frame of the app where ``method.everywhere``."""
    return [dcc.Store(id=store) for store in (method.names.settings, method.names.result_key)]


def register(app: Dash, workspace: Workspace, method: MethodPage) -> None:
    """The callbacks of the settings, the button and the status."""
    _form(app, method)
    _run(app, workspace, method)
    _expect(app, workspace, method)
    _look(app, workspace, method)
    _kinds(app, workspace, method)


def _form(app: Dash, method: MethodPage) -> None:
    app.clientside_callback(
        ClientsideFunction("settings", "pick"),
        Output(method.names.settings, "data"),
        Input(VIEW, "data"),
        State(method.names.settings, "data"),
        State(method.names.settings, "id"),
        State(SETTINGS_KEYS, "data"),
    )

    @app.callback(
        Output(method.names.form, "children"),
        Output(method.names.summary, "children"),
        Input(method.names.settings, "data"),
    )
    def show_form(view):
        values = settings.request_of(method.page, "", view).parameters
        return parameter_form(method.shown, values, method.names.control), summary(
            settings.not_default(method.page, values)
        )


def _run(app: Dash, workspace: Workspace, method: MethodPage) -> None:
    control = method.names.control(ALL)

    @app.callback(
        Output(method.names.fold, "value"),
        Output(control, "error"),
        Input(method.names.run, "n_clicks"),
        Input(method.names.again, "data"),
        State(control, "value"),
        State(control, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def run(_clicks, _again, values, ids, dataset, view):
        form_values, problems = chosen_values(method, ids, values, view)
        if problems:
            return "form", [problems.get(component["name"]) for component in ids]
        try:
            ask(workspace, method.page, dataset, form_values)
        except (ParameterError, WorkspaceError) as error:
            title = method.refused or f"Cannot do that: {method.title}"
            set_props(NOTICES, {"sendNotifications": [notice(title, str(error), "red")]})
        return no_update, [None] * len(ids)


def chosen_values(
    method: MethodPage, ids: list[dict[str, str]], values: list[Any], view: Mapping[str, str] | None
) -> tuple[dict[str, Any], dict[str, str]]:
    """The parameters that form and link stand for, and what is wrong with the form, as :func:`read_form` has it."""
    link_values = dict(settings.request_of(method.page, "", view).parameters)
    if not ids:  # the form has not come yet; it will show the settings of the link
        return link_values, {}
    form_values, problems = read_form(method.shown, ids, values)
    return form_values | {name: value for name, value in link_values.items() if name in method.without}, problems


def _expect(app: Dash, workspace: Workspace, method: MethodPage) -> None:
    control = method.names.control(ALL)

    @app.callback(
        Output(method.names.estimate, "children"),
        Input(DATASET, "data"),
        Input(method.names.settings, "data"),
        Input(control, "value"),
        Input(JOBS_FINISHED, "data"),
        State(control, "id"),
        State(VIEW, "data"),
    )
    def show_estimate(dataset, _settings, values, _finished, ids, view):
        form_values, problems = chosen_values(method, ids, values, view)
        shown = {} if problems else settings.view_of(method.page, form_values)
        return expected_words(workspace, method.page, dataset, {**(view or {}), **shown})


def _kinds(app: Dash, workspace: Workspace, method: MethodPage) -> None:
    @app.callback(Output(method.names.left_out, "children"), Input(DATASET, "data"), Input(REVISION, "data"))
    def show_left_out(dataset, _revision):
        return left_out_words(workspace, method.page, dataset)


def left_out_words(workspace: Workspace, page: str, dataset: str | None) -> str:
    """Which clips of a data set the method of a page leaves out, because their bodies cannot be compared."""
    try:
        there = workspace.open(dataset) if dataset else None
    except WorkspaceError:
        there = None
    if there is None:
        return ""
    every_kind = METHODS[settings.methods()[page]].all_kinds
    words = kinds_in_words(there) if every_kind else left_out(there, _ADVICE)
    return f"{words[:1].upper()}{words[1:]}." if words else ""


_ADVICE = "in a dataset of their own they are analysed among their own kind"


def expected_words(workspace: Workspace, page: str, dataset: str | None, view: Mapping[str, Any] | None) -> str:
    """What the result that a view stands for will take; empty where it is there, or nobody knows."""
    if not dataset or settings.key_of(workspace, page, dataset, view):
        return ""
    return analyses.expected_words(workspace, settings.request_of(page, dataset, view))


def ask(workspace: Workspace, page: str, dataset: str | None, values: Mapping[str, object]) -> None:
    """Starts the job of a result unless it exists, and writes its settings into the link, which shows it.

    To be called in a callback. Raises ParameterError, WorkspaceError in plain words.
    """
    if not dataset:
        raise WorkspaceError("Choose a dataset first; the library has none yet.")
    request = analyses.normalise(analyses.Request(dataset, settings.methods()[page], dict(values)))
    if analyses.stored(workspace, request) is None:
        set_props(JOB_STARTED, {"data": jobs.start(workspace, request).id})
    set_props(VIEW_CHANGE, {"data": settings.view_of(page, request.parameters)})


def _look(app: Dash, workspace: Workspace, method: MethodPage) -> None:
    @app.callback(
        Output(method.names.result_key, "data"),
        Input(DATASET, "data"),
        Input(method.names.settings, "data"),
        Input(JOBS_FINISHED, "data"),
        Input(REVISION, "data"),
        State(method.names.result_key, "data"),
    )
    def find_result(dataset, view, _finished, _revision, current):
        key = settings.key_of(workspace, method.page, dataset, view)
        return no_update if key == current and ctx.triggered_id in (JOBS_FINISHED, REVISION) else key

    @app.callback(
        Output(method.names.status, "children"),
        Output(method.names.status_of, "data"),
        Input(JOBS_SEEN, "data"),
        Input(method.names.result_key, "data"),
        State(DATASET, "data"),
        State(method.names.settings, "data"),
        State(method.names.status_of, "data"),
    )
    def show_status(_seen, key, dataset, view, current):
        job = settings.latest_job(workspace, method.page, dataset, view) if not key else None
        now = [key, dataset, job and [job.id, job.state, job.error]]
        return (no_update, no_update) if now == current else (status(method, dataset, job, bool(key)) or [], now)


def status(method: MethodPage, dataset: str | None, job: Job | None, ready: bool) -> Component | None:
    """The message in place of a result that does not exist yet; None where it exists."""
    if ready:
        return None
    if not dataset:
        link = dcc.Link("Go to the library", href="/library", className="text-link")
        return _card(empty_state("person", "No dataset yet", "Add recordings, or make the demo, in the library.", link))
    if job is not None and job.alive:
        return _card(running(job, method.doing, method.symbol))
    if job is not None and job.state == "failed":
        return _card(empty_state("error", f"{method.doing} failed", job.error, _again(method, "Try again")))
    if job is not None and job.state == "cancelled":
        words = f"{method.doing} was cancelled"
        return _card(empty_state(method.symbol, words, "No result was stored.", _again(method, method.action)))
    words = f"Press {method.action}. {method.hint}"
    return _card(
        empty_state(
            method.symbol, f"No {method.title[:1].lower()}{method.title[1:]} yet", words, _again(method, method.action)
        )
    )


def _again(method: MethodPage, label: str) -> Component:
    return dmc.Button(label, variant="light", **sends(method.names.again, {"run": True}, every_time=True))


def _card(child: Component) -> Component:
    return html.Div(child, className="card section")


def earlier_menu(workspace: Workspace, method: MethodPage, dataset: str | None, ready: bool) -> list[Component]:
    """A menu of the results with other settings; empty where there are none."""
    past = settings.earlier(workspace, method.page, dataset)
    if len(past) <= (1 if ready else 0):
        return []
    items = [
        dmc.MenuItem(
            [
                html.Div(summary(values_shown), className="menu-title"),
                html.Div(_when(job.finished), className="muted menu-note"),
            ],
            **sends(VIEW_CHANGE, settings.view_of(method.page, job.request["parameters"]), every_time=True),
        )
        for job, values_shown in past[:15]
    ]
    target = dmc.Button("Earlier results", variant="default", rightSection=icon("chevron", 14))
    children = [dmc.MenuTarget(target), dmc.MenuDropdown(items, className="menu-long")]
    return [dmc.Menu(shadow="md", position="bottom-end", children=children)]


def copy_items(
    workspace: Workspace, method: MethodPage, dataset: str, view: Mapping[str, str] | None
) -> list[Component]:
    """Menu items that copy the result shown as a command and as Python."""
    request = settings.request_of(method.page, dataset, view)
    return [dmc.MenuItem(label, **copies(text)) for label, text in recipes.texts(workspace.path, request).items()]


def _when(moment: float | None) -> str:
    return datetime.fromtimestamp(moment).strftime("%d %b, %H:%M") if moment else ""
