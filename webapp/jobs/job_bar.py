"""The bar of jobs: what runs in this workspace, its progress, and buttons to stop or repeat it.

One interval polls the job table for the whole app: fast while something runs, slowly otherwise. The
same poll brings the revision of the dataset list and of finished jobs, so a second tab, a second person and a
restarted server all show the current state.
"""

from __future__ import annotations

import hashlib
import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from dash import Dash, Input, Output, State, dcc, html, no_update
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs as webapp_jobs
from webapp.jobs import names
from webapp.shell.advice import in_the_browser
from webapp.shell.attributes import attributes
from webapp.shell.messages import notice
from webapp.shell.names import NOTICES, REVISION

FAST, SLOW = 600, 4000  # milliseconds between two polls
FAILED_SHOWN = 600.0  # seconds a failed job stays in the bar
STAGES = {  # words for the stages that computations report
    "": "starting",
    "reading bodies": "looking at the bodies",
    "reading recordings": "reading recordings",
    "reading postures": "computing postures",
    "poses": "computing postures",
    "features": "computing features",
    "quantisation": "clustering postures",
    "matching": "looking for repetitions",
    "discovery": "choosing motifs",
    "joining": "joining leftovers",
    "alignment": "aligning motions",
    "graph": "building the graph",
    "opening": "opening the recordings",
    "demo": "making the demo",
    "postures": "computing postures",
    "samples": "choosing different postures",
    "map": "adapting the map",
    "runs": "placing the recordings",
    "random starts": "looking for actions",
    "recombination": "combining what was found",
    "genetic search": "looking for actions",
    "fine search": "cutting exactly",
    "fine tuning": "moving the cuts",
    "sentences": "dividing into routines",
    "grouping": "counting actions",
    "rules": "finding phrases",
    "held out": "testing held-out routines",
    "new motion": "making new motion",
}


@dataclass(frozen=True)
class Pulse:
    """The state of the workspace at one poll: what the bar shows, and marks that change when views must be updated."""

    jobs: tuple[Job, ...]
    revision: str
    finished: str

    @property
    def busy(self) -> bool:
        """Whether anything waits for a worker or runs."""
        return any(job.alive and not job.held for job in self.jobs)


def layout() -> Component:
    """The bar, empty, with its interval and stores."""
    return html.Footer(
        className="job-bar",
        children=[
            html.Div(id=names.JOB_LIST, role="status", **attributes(aria_live="polite", aria_label="Jobs")),
            dcc.Store(id=names.JOBS_SHOWN),  # the rows; assets/jobs/job_bar.mjs draws them
            dcc.Interval(id=names.JOB_TICK, interval=FAST),
            dcc.Store(id=names.JOB_POKE),  # written when a job was started: the bar then updates immediately
            dcc.Store(id=names.JOB_ACTION),  # {"action": "start" | "cancel" | "retry" | "dismiss", "job": id}
            dcc.Store(id=names.JOBS_SEEN, data={}),
            dcc.Store(id=names.JOBS_DISMISSED, data=[], storage_type="session"),
            dcc.Store(id=names.JOBS_FINISHED),  # changes when a job ends: results may have appeared
        ],
    )


def read_pulse(workspace: Workspace, dismissed: Iterable[int] = ()) -> Pulse:
    """What the bar shows now, by two small queries. dismissed: ids of failed jobs that are no longer shown."""
    jobs, now, hidden = workspace.jobs.list(50), time.time(), set(dismissed)
    shown = [job for job in jobs if job.alive or (_failed_lately(job, now) and job.id not in hidden)]
    newest = {job.key: job.id for job in reversed(jobs)}  # a failure is over once the same was tried again
    shown = [job for job in shown if job.alive or job.id == newest[job.key]]
    return Pulse(
        tuple(sorted(shown, key=lambda job: job.id)),
        revision_of(workspace),
        _mark(f"{job.id}{job.state}" for job in jobs if not job.alive),
    )


def revision_of(workspace: Workspace) -> str:
    """A mark of the list of datasets: it changes when one comes, goes, is renamed or gets new content or labels.

    It never returns to what it was, not even when a change is undone: a page that has read a change before it heard of
    it would else not hear that it is undone.
    """
    changes = workspace.audit.newest("dataset")
    return _mark([str(changes), *(f"{info.id}{info.name}{info.folder}" for info in workspace.datasets())])


def rows(jobs: Sequence[Job]) -> list[dict]:
    """The bar's rows, as assets/jobs/job_bar.mjs draws them; ``error`` is there where the job has failed."""
    return [_alive(job) if job.alive else _failed(job) for job in jobs]


def stage_words(job: Job) -> str:
    """The stage of a queued or running job, in words."""
    if job.cancelling:
        return "stopping"
    if job.held:
        return job.held
    if job.state == "queued":
        return "waiting for its turn"
    stage, mark, count = job.stage.partition(" (")  # "rough search (2 of 6)"
    return STAGES.get(stage, stage[:1].lower() + stage[1:]) + mark + count


def _alive(job: Job) -> dict:
    running = job.state == "running" and not job.cancelling
    percent = round(100 * job.fraction) if running else None  # None: the duration is unknown
    row = {"id": job.id, "title": job.title, "stage": stage_words(job), "percent": percent, "stopping": job.cancelling}
    return row | {"held": bool(job.held), "expected": expected_words(job.expected)}


def expected_words(expected: str) -> str:
    """What a job will take, with what it is; empty where nobody knows."""
    return f"expected: {expected}" if expected else ""


def _failed(job: Job) -> dict:
    return {
        "id": job.id,
        "title": job.title,
        "error": in_the_browser(job.error or "It failed for an unknown reason."),
    }


def marks_of(pulse: Pulse) -> dict[str, Any]:
    """What a browser has seen when it has shown a pulse; kept in the store "jobs-seen"."""
    return {
        "rows": _mark(map(str, rows(pulse.jobs))),
        "speed": FAST if pulse.busy else SLOW,
        "revision": pulse.revision,
        "finished": pulse.finished,
    }


def first_values(workspace: Workspace) -> dict[str, dict[str, Any]]:
    """What the first look at the workspace shows, for the layout: id of a component -> its properties.

    Rows are left to the first poll where there are any: only the browser knows which ones were dismissed.
    """
    pulse = read_pulse(workspace)
    marks = marks_of(pulse)
    if pulse.jobs:
        marks |= {"rows": "", "speed": FAST}
    return {
        names.JOB_TICK: {"interval": marks["speed"]},
        REVISION: {"data": pulse.revision},
        names.JOBS_FINISHED: {"data": pulse.finished},
        names.JOBS_SEEN: {"data": marks},
    }


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the poll, the rows of the bar and their buttons."""
    app.clientside_callback(ClientsideFunction("jobs", "show"), Input(names.JOBS_SHOWN, "data"))

    @app.callback(
        Output(names.JOBS_SHOWN, "data"),
        Output(names.JOB_TICK, "interval"),
        Output(REVISION, "data"),
        Output(names.JOBS_FINISHED, "data"),
        Output(names.JOBS_SEEN, "data"),
        Input(names.JOB_TICK, "n_intervals"),
        Input(names.JOB_POKE, "data"),
        Input(names.JOBS_DISMISSED, "data"),
        State(names.JOBS_SEEN, "data"),
        prevent_initial_call=True,
    )
    def poll(_ticks, _poke, dismissed, seen):
        pulse = read_pulse(workspace, dismissed or ())
        if any(job.died for job in pulse.jobs) and webapp_jobs.resume(workspace):
            pulse = read_pulse(workspace, dismissed or ())
        if pulse.busy:
            webapp_jobs.ensure_worker(workspace)  # a worker may have died, or the page that started the job may be gone
        shown, marks, seen = rows(pulse.jobs), marks_of(pulse), seen or {}

        def when_new(name, value):
            return no_update if seen.get(name) == marks[name] else value

        return (
            when_new("rows", shown),
            when_new("speed", marks["speed"]),
            when_new("revision", pulse.revision),
            when_new("finished", pulse.finished),
            no_update if seen == marks else marks,
        )

    @app.callback(
        Output(names.JOBS_DISMISSED, "data"),
        Output(names.JOB_POKE, "data"),
        Output(NOTICES, "sendNotifications", allow_duplicate=True),
        Input(names.JOB_ACTION, "data"),
        State(names.JOBS_DISMISSED, "data"),
        prevent_initial_call=True,
    )
    def act(request, dismissed):
        action, job_id = (request["action"], int(request["job"])) if request else ("", 0)
        try:
            if action == "cancel":
                workspace.jobs.cancel(job_id)
            elif action == "start":
                workspace.jobs.release(job_id)
                webapp_jobs.ensure_worker(workspace)
            elif action == "retry":
                webapp_jobs.restart(workspace, job_id)
            if action in ("retry", "dismiss"):  # a job that is tried again is no longer shown as failed
                dismissed = [*(dismissed or []), job_id][-50:]
        except WorkspaceError as error:
            return no_update, time.time(), [notice("That did not work", str(error), "red")]
        return dismissed, time.time(), no_update


def _failed_lately(job: Job, now: float) -> bool:
    return job.state == "failed" and now - (job.finished or now) < FAILED_SHOWN


def _mark(parts: Iterable[str]) -> str:
    return hashlib.blake2b("\n".join(parts).encode(), digest_size=8).hexdigest()
