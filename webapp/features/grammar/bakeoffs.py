"""The comparison of four ways to make motion, in the app: its request, its motions, and how the Stage plays them.

``~bakeoff~KEY`` holds a clip for each way that made one, with the name of the way; KEY is that of the result.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from core import analyses
from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.workspace import Job, Workspace, WorkspaceError
from webapp.features.grammar import grammars
from webapp.features.grammar.figures.bakeoff import NAMES
from webapp.shell import settings
from webapp.shell.virtual import virtual_name

if TYPE_CHECKING:
    from core.synthesis.bakeoff import Bakeoff

BAKEOFF = "bakeoff"
View = Mapping[str, str] | None


def request(dataset: str, view: View) -> analyses.Request:
    """The comparison for the grammar that a view shows."""
    return analyses.Request(dataset, BAKEOFF, settings.request_of(grammars.PAGE, dataset, view).parameters)


def find(workspace: Workspace, dataset: str | None, view: View) -> tuple[Bakeoff, str] | None:
    """The comparison and its key where it has been made."""
    try:
        analysis_request = request(dataset or "", view)
        result = analyses.stored(workspace, analysis_request) if dataset else None
        return None if result is None else (result, analyses.key(workspace, analysis_request))
    except (ParameterError, WorkspaceError):
        return None


def latest_job(workspace: Workspace, dataset: str, view: View) -> Job | None:
    """The newest job for it, or None."""
    try:
        return workspace.jobs.latest(analyses.key(workspace, request(dataset, view)))
    except (ParameterError, WorkspaceError):
        return None


def kept_bakeoff(workspace: Workspace, key: str) -> Bakeoff | None:
    """A comparison that has been made, or None."""
    return analyses.kept(workspace, BAKEOFF, key) if re.fullmatch(r"[0-9a-f]{8,64}", key) else None


def open_bakeoff(workspace: Workspace, key: str) -> Dataset:
    """The made-up data set of a kept comparison. Raises WorkspaceError where there is none."""
    result = kept_bakeoff(workspace, key)
    if result is None or not result.clips:
        raise WorkspaceError("This comparison is no longer there; make it again on the Grammar page.")
    return Dataset(virtual_name(BAKEOFF, key), tuple(result.clips))


def stage_request(result: Bakeoff, key: str, only: str | None = None) -> dict[str, Any]:
    """The motions of all ways side by side, or of one alone."""
    clips = [clip for clip in result.clips if only in (None, clip.name)]
    items = [
        {"clip": clip.name, "start": 0, "end": clip.n_frames, "label": NAMES.get(clip.name, clip.name)}
        for clip in clips
    ]
    title = NAMES.get(only, only) if only else f"{len(items)} ways side by side"
    layout = "overlay" if only else "side"
    return {"dataset": virtual_name(BAKEOFF, key), "title": title, "items": items, "layout": layout, "sync": "start"}
