"""Which maps there are in a workspace: those of other clips, on whose postures these clips can be laid."""

from __future__ import annotations

from datetime import datetime
from typing import NamedTuple

from core.workspace import Workspace, WorkspaceError
from webapp.shell.settings import not_default
from webapp.ui.parameter_form import summary

MOST = 12


class OtherMap(NamedTuple):
    """A map that was made of other clips: key of its result, name of its data set then, its settings, when."""

    key: str
    dataset: str
    summary: str
    when: str


def other_maps(workspace: Workspace, dataset: str | None) -> list[OtherMap]:
    """Maps of other content than ``dataset`` has now that are still there, newest first, its own earlier ones first."""
    try:
        fingerprint = workspace.info(dataset).fingerprint if dataset else None
    except WorkspaceError:
        return []
    maps: dict[str, OtherMap] = {}
    for job in workspace.jobs.list(200) if fingerprint else ():
        request = job.request
        if job.state != "done" or request.get("method") != "map" or request.get("fingerprint") == fingerprint:
            continue
        if request["parameters"].get("model") or job.key in maps or not workspace.results.has(job.key):
            continue
        when = datetime.fromtimestamp(job.finished).strftime("%d %b, %H:%M") if job.finished else ""
        text = summary(not_default("map", request["parameters"]))
        maps[job.key] = OtherMap(job.key, str(request["dataset"]), text, when)
    return sorted(maps.values(), key=lambda other: other.dataset != dataset)[:MOST]
