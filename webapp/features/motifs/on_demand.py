"""A part of a view that is computed on demand: its request, its job and its result."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, no_update, set_props
from dash.development.base_component import Component

from core import analyses
from core.errors import ParameterError
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.features.motifs.names import OnDemandNames
from webapp.jobs.names import JOBS_FINISHED
from webapp.jobs.running import running
from webapp.shell import results, settings
from webapp.shell.buttons import sends
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, MOTIF_METHOD, NOTICES, THEME, VIEW


class OnDemand(NamedTuple):
    """The name and the texts of such a part; ``name`` is its view, ``ids`` are those of its elements and stores."""

    name: str
    method: str
    ids: OnDemandNames
    symbol: str
    doing: str  # "Making the report"
    missing: str  # "No report yet"
    hint: str
    button: str
    refused: str  # "Cannot make the report"
    frame: Callable[[Component], Any]  # around the message shown until there is a result

    def request(self, dataset: str, view: Mapping[str, Any] | None) -> analyses.Request:
        """The request for it, on the motif graph that ``view`` shows."""
        return analyses.Request(dataset, self.method, settings.request_of(results.MOTIFS, dataset, view).parameters)

    def stores(self) -> list[Component]:
        """For the view's skeleton."""
        return [dcc.Store(id=store) for store in (self.ids.find, self.ids.job, self.ids.shown)]

    def waiting(self, job: Job | None, expected: str = "") -> Component:
        """The content while there is no result: progress, or an invitation to compute it, which will take what
        ``expected`` says."""
        if job is not None and job.alive:
            return running(job, self.doing, self.symbol)
        title, words = self.missing, f"{self.hint} It takes {expected}." if expected else self.hint
        if job is not None and job.state == "failed":
            title, words = f"{self.doing} failed", job.error
        elif job is not None and job.state == "cancelled":
            title, words = f"{self.doing} was cancelled", "No result was stored."
        asks = sends(self.ids.find, {"find": True}, every_time=True)
        return empty_state(self.symbol, title, words, dmc.Button(self.button, variant="light", **asks))


Body = Callable[[Any, str, Mapping[str, Any] | None, str | None], Any]  # (result, dataset, view, colour scheme)


def register(app: Dash, workspace: Workspace, part: OnDemand, body: Body) -> None:
    """Registers the callbacks that start the job of ``part``, follow it, and show the ``body`` of its result."""

    @app.callback(
        Output(part.ids.job, "data"),
        Input(part.ids.find, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        prevent_initial_call=True,
    )
    def ask(_clicked, name, view):
        try:
            job = jobs.start(workspace, part.request(name, view))
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice(part.refused, str(error), "red")]})
            return no_update
        set_props(JOB_STARTED, {"data": job.id})
        return job.id

    @app.callback(
        Output(part.ids.place, "children"),
        Output(part.ids.shown, "data"),
        Input(VIEW, "data"),
        Input(part.ids.place, "id"),
        Input(part.ids.job, "data"),
        Input(JOBS_FINISHED, "data"),
        Input(THEME, "data"),
        State(part.ids.shown, "data"),
        State(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
    )
    def show(view, _place, _job, _finished, scheme, shown, graph_key, name):
        if (view or {}).get("view") != part.name or results.shown_graph(workspace, graph_key, name, view) is None:
            return no_update, no_update
        request = part.request(name, view)
        result = analyses.stored(workspace, request)
        job = None if result else workspace.jobs.latest(analyses.key(workspace, request))
        now = [graph_key, scheme, "there" if result else job.state if job else "", job.id if job else 0]
        if now == shown:
            return no_update, no_update
        return part.frame(part.waiting(job, analyses.expected_words(workspace, request))) if result is None else body(
            result, name, view, scheme
        ), now
