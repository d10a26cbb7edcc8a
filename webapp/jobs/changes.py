"""Changes of a dataset (recordings or labels added, clips removed): started as jobs, announced when done, undone.

Their stores belong to the frame of the app, so the notice appears on any page.
"""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, dcc, html, no_update, set_props
from dash.development.base_component import Component

from core import analyses
from core.mocap.reports import ImportReport
from core.workspace import Job, Workspace, WorkspaceError
from webapp import jobs
from webapp.jobs import names
from webapp.shell.buttons import sends
from webapp.shell.messages import notice
from webapp.shell.names import AWAITED, JOB_STARTED, NOTICES

UNDO_SHOWN = 15000  # milliseconds


def stores() -> list[Component]:
    """The stores of changes, for the frame of the app."""
    return [
        dcc.Store(id=names.CHANGE_STARTED),  # {"job": id} of a change that was started here
        dcc.Store(id=names.CHANGES, data=[], storage_type="session"),  # ids of jobs whose end has not been announced
        dcc.Store(id=names.UNDO),  # {"revert": version}, {"restore": token of what is in the trash} or {"trash": name}
    ]


def start(workspace: Workspace, request: analyses.Request) -> Job:
    """Starts the job of a change, in a callback; a notice announces its end. Raises WorkspaceError, ParameterError."""
    job = jobs.start(workspace, request)
    set_props(JOB_STARTED, {"data": job.id})
    set_props(names.CHANGE_STARTED, {"data": {"job": job.id}})
    set_props(names.JOB_POKE, {"data": time.time()})
    return job


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callbacks that announce finished changes and undo them."""

    @app.callback(
        Output(names.CHANGES, "data"),
        Input(names.CHANGE_STARTED, "data"),
        Input(names.JOBS_FINISHED, "data"),
        State(names.CHANGES, "data"),
    )
    def announce(started, _finished, waiting):
        waiting = waiting if isinstance(waiting, list) else []
        before = [*waiting]
        if started and started.get("job") not in waiting:
            waiting = [*waiting, started["job"]]
            set_props(names.CHANGE_STARTED, {"data": None})
        jobs_by_id = {number: workspace.jobs.get(number) for number in waiting if isinstance(number, int)}
        done = [job for job in jobs_by_id.values() if job is not None and job.state == "done"]
        if done:
            set_props(NOTICES, {"sendNotifications": [change_notice(workspace, job) for job in done]})
        left = [number for number, job in jobs_by_id.items() if job is not None and job.alive]
        return left if left != before else no_update

    @app.callback(Input(names.UNDO, "data"), prevent_initial_call=True)
    def undo(request):
        try:
            message = undo_change(workspace, request or {})
        except WorkspaceError as error:
            message = notice("That did not work", str(error), "red")
        set_props(NOTICES, {"sendNotifications": [message]})
        set_props(names.JOB_POKE, {"data": time.time()})


def undo_change(workspace: Workspace, request: Mapping[str, object]) -> dict:
    """Undoes what the store "undo" asks for; returns the notice about it. Raises WorkspaceError."""
    if request.get("trash"):
        workspace.trash(str(request["trash"]))
        return notice("Undone", f"{request['trash']} is in the trash.")
    if request.get("restore"):
        info = workspace.restore(str(request["restore"]))
        set_props(AWAITED, {"data": info.name})
        return notice("Restored", f"{info.name} is back in the library.")
    info = workspace.revert(str(request.get("revert")))
    return notice("Undone", f"{info.name} is what it was before, and so are its results.")


def change_notice(workspace: Workspace, job: Job) -> dict:
    """The notice about a finished change, with its Undo button."""
    name, method = str(job.request["dataset"]), job.request["method"]
    into = job.request["parameters"].get("into", "") if method == "edit" else ""
    name = into or name
    try:
        report, undo = workspace.report(name), workspace.last_version(name)
    except WorkspaceError:  # renamed or deleted meanwhile
        return notice(job.title, "It is done.")
    if method == "remove":
        title, words = "Removed", f"{_count(len(json.loads(job.request['parameters']['clips'])), 'clip')} from {name}."
    elif method == "add":
        title, words = "Added", addition_summary(name, report)
    elif method == "edit":
        clips = [file.clip for file in report.files if file.clip and file.addition == report.last_addition]
        title, words = _count(len(clips), "new clip"), f"{clips[0]}{' and more' if len(clips) > 1 else ''} in {name}."
    else:
        title, words = "Done", f"{job.title}."
    buttons = [_see_report(name)] if method == "add" else [_see_clip(name, clips[0])] if method == "edit" else []
    undo_request = {"trash": into} if into else {"revert": undo} if undo else None
    return undo_notice(title, words, undo_request, *buttons) if undo_request else notice(title, words)


def addition_summary(name: str, report: ImportReport) -> str:
    """What the last addition brought to the dataset called ``name``, in one sentence."""
    files = [file for file in report.files if file.addition == report.last_addition]
    clips = sum(file.clip is not None for file in files)
    bad = sum(file.verdict == "error" for file in files)
    doubts = sum(file.verdict == "warning" for file in files)
    parts = [_count(clips, "clip") if clips else "labels", f"to {name}"]
    more = [f"{bad} not read"] if bad else []
    more += [_count(doubts, "warning")] if doubts else []
    return " ".join(parts) + (f"; {', '.join(more)}." if more else ".")


def undo_notice(title: str, words: str, undo: Mapping[str, str], *buttons: Component) -> dict:
    """A notice with a button that sends ``undo`` to the store of that name."""
    button = dmc.Button("Undo", size="compact-sm", variant="light", **sends(names.UNDO, undo, every_time=True))
    text = html.Span(words, className="ellipsis", title=words)
    return notice(title, dmc.Group([text, *buttons, button], gap=10, wrap="nowrap"), autoClose=UNDO_SHOWN)


def _see_report(name: str) -> Component:
    query = urlencode({"dataset": name, "tab": "report", "files": "added"})
    return dcc.Link("See the report", href=f"/library?{query}", className="text-link notice-link")


def _see_clip(name: str, clip: str) -> Component:
    query = urlencode({"dataset": name, "clip": clip})
    return dcc.Link("Show it", href=f"/clip?{query}", className="text-link notice-link")


def _count(number: int, what: str) -> str:
    return f"{number:,} {what}{'' if number == 1 else 's'}"
