"""The bar of jobs: what runs in this workspace, how far it is, and how to stop or repeat it.

ONE interval polls the job table for the whole app: fast while something runs, slowly otherwise. From the same look at
the workspace come the revision of the dataset list and of finished jobs, so a second tab, a second person and a
restarted server all show what is there.
"""

from __future__ import annotations

import hashlib
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.development.base_component import Component

from core.workspace import DatasetInfo, Job, Workspace, WorkspaceError
from webapp import jobs as webapp_jobs
from webapp.components.actions import sends
from webapp.components.errors import notice
from webapp.components.icons import icon

FAST, SLOW = 600, 4000  # milliseconds between two looks
FAILED_SHOWN = 600.0  # seconds a failed job stays in the bar
STAGES = {  # words for the stages that computations report
    "": "starting",
    "poses": "computing postures",
    "quantisation": "clustering postures",
    "matching": "looking for repetitions",
    "discovery": "choosing motifs",
    "joining": "joining leftovers",
    "alignment": "aligning motions",
    "graph": "building the graph",
    "opening": "opening the recordings",
    "demo": "making the demo",
}


@dataclass(frozen=True)
class Pulse:
    """One look at the workspace: what the bar shows, and marks that change when other views must look again."""

    jobs: tuple[Job, ...]
    revision: str
    finished: str

    @property
    def busy(self) -> bool:
        """Whether anything waits or runs."""
        return any(job.alive for job in self.jobs)


def layout() -> Component:
    """The bar, empty, with its interval and stores."""
    return html.Footer(
        className="job-bar",
        children=[
            html.Div(id="job-list", role="status", **{"aria-live": "polite", "aria-label": "Jobs"}),
            dcc.Interval(id="job-tick", interval=FAST),
            dcc.Store(id="job-poke"),  # written when a job was just asked for: look now
            dcc.Store(id="job-action"),  # {"action": "cancel" | "retry" | "dismiss", "job": id}
            dcc.Store(id="jobs-seen", data={}),
            dcc.Store(id="jobs-dismissed", data=[], storage_type="session"),
            dcc.Store(id="jobs-finished"),  # changes when a job ends: results may have appeared
        ],
    )


def look(workspace: Workspace, dismissed: Iterable[int] = ()) -> Pulse:
    """A cheap look: two small queries."""
    jobs, now, hidden = workspace.jobs.list(50), time.time(), set(dismissed)
    shown = [job for job in jobs if job.alive or (_failed_lately(job, now) and job.id not in hidden)]
    superseded = {job.key for job in jobs if job.alive or job.state == "done"}
    shown = [job for job in shown if job.alive or job.key not in superseded]
    return Pulse(
        tuple(sorted(shown, key=lambda job: job.id)),
        revision_of(workspace.datasets()),
        _mark(f"{job.id}{job.state}" for job in jobs if not job.alive),
    )


def revision_of(datasets: Sequence[DatasetInfo]) -> str:
    """A mark of the list of datasets: it changes when one comes, goes, is renamed or gets new content."""
    return _mark(f"{info.id}{info.name}{info.fingerprint}" for info in datasets)


def rows(jobs: Sequence[Job]) -> list[Component]:
    """The bar's rows."""
    return [_alive(job) if job.alive else _failed(job) for job in jobs]


def stage_words(job: Job) -> str:
    """What a living job is doing, in words."""
    if job.cancelling:
        return "stopping"
    if job.state == "queued":
        return "waiting for its turn"
    return STAGES.get(job.stage, job.stage[:1].lower() + job.stage[1:])


def _alive(job: Job) -> Component:
    percent, running = round(100 * job.fraction), job.state == "running" and not job.cancelling
    return html.Div(
        className="job",
        children=[
            html.Span(className="spinner", **{"aria-hidden": "true"}),
            html.Span(job.title, className="job-title ellipsis"),
            dmc.Progress(
                value=percent if running else 100,
                striped=not running,
                animated=not running,
                size="sm",
                color="accent" if running else "gray",
                **{"aria-label": f"Progress of {job.title}"},
            ),
            html.Span(
                f"{stage_words(job)}{f' {percent} %' if running and percent else ''}", className="job-stage number"
            ),
            html.Div(
                dmc.Button(
                    "Cancel",
                    size="compact-sm",
                    variant="default",
                    disabled=job.cancelling,
                    **sends("job-action", {"action": "cancel", "job": job.id}, every_time=True),
                ),
                className="job-actions",
            ),
        ],
    )


def _failed(job: Job) -> Component:
    retry = sends("job-action", {"action": "retry", "job": job.id}, every_time=True)
    dismiss = sends("job-action", {"action": "dismiss", "job": job.id}, every_time=True)
    return html.Div(
        className="job job-failed",
        children=[
            html.Span(icon("error"), className="job-mark-failed"),
            html.Span(job.title, className="job-title ellipsis"),
            html.Span(job.error or "It failed for a reason we do not know.", className="job-message"),
            html.Div(
                className="job-actions",
                children=[
                    dmc.Button("Try again", size="compact-sm", variant="default", **retry),
                    dmc.ActionIcon(
                        icon("close", 16),
                        variant="subtle",
                        color="gray",
                        size=26,
                        **dismiss,
                        **{"aria-label": "Dismiss"},
                    ),
                ],
            ),
        ],
    )


def register(app: Dash, workspace: Workspace) -> None:
    """The poll, and the bar's buttons."""

    @app.callback(
        Output("job-list", "children"),
        Output("job-tick", "interval"),
        Output("revision", "data"),
        Output("jobs-finished", "data"),
        Output("jobs-seen", "data"),
        Input("job-tick", "n_intervals"),
        Input("job-poke", "data"),
        Input("jobs-dismissed", "data"),
        State("jobs-seen", "data"),
    )
    def poll(_ticks, _poke, dismissed, seen):
        pulse = look(workspace, dismissed or ())
        if pulse.busy:
            webapp_jobs.tend(workspace)  # a worker may have died, or the one who asked may have gone
        marks = {
            "rows": _mark(f"{j.id}{j.state}{j.stage}{round(100 * j.fraction)}{j.cancelling}" for j in pulse.jobs),
            "speed": FAST if pulse.busy else SLOW,
            "revision": pulse.revision,
            "finished": pulse.finished,
        }
        seen = seen or {}

        def when_new(name, value):
            return no_update if seen.get(name) == marks[name] else value

        return (
            when_new("rows", rows(pulse.jobs)),
            when_new("speed", marks["speed"]),
            when_new("revision", pulse.revision),
            when_new("finished", pulse.finished),
            no_update if seen == marks else marks,
        )

    @app.callback(
        Output("jobs-dismissed", "data"),
        Output("job-poke", "data"),
        Output("notices", "sendNotifications", allow_duplicate=True),
        Input("job-action", "data"),
        State("jobs-dismissed", "data"),
        prevent_initial_call=True,
    )
    def act(request, dismissed):
        action, job_id = (request or {}).get("action"), (request or {}).get("job")
        try:
            if action == "cancel":
                workspace.jobs.cancel(int(job_id))
            elif action == "retry":
                webapp_jobs.restart(workspace, int(job_id))
            if action in ("retry", "dismiss"):  # what is tried again no longer stands there as failed
                dismissed = [*(dismissed or []), int(job_id)][-50:]
        except (WorkspaceError, TypeError, ValueError) as error:
            return no_update, time.time(), [notice("That did not work", str(error), "red")]
        return dismissed, time.time(), no_update


def _failed_lately(job: Job, now: float) -> bool:
    return job.state == "failed" and now - (job.finished or now) < FAILED_SHOWN


def _mark(parts: Iterable[str]) -> str:
    return hashlib.blake2b("\n".join(parts).encode(), digest_size=8).hexdigest()
