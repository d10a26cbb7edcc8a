"""What is done to data sets as jobs: importing an upload, adding one to a data set, removing clips.

Parameters are plain values, as they stand in the job table; each function does one job in a worker.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass, field

from core.progress import Report
from core.workspace.errors import WorkspaceError
from core.workspace.workspace import Workspace


@dataclass(frozen=True)
class ImportParameters:
    """An import of an upload. ``skeleton``, ``labels``: files of it; ``fps``: frames per second of AMC files."""

    upload: str
    skeleton: str = ""
    labels: str = ""
    fps: float | None = field(default=None, metadata={"min": 1, "max": 1000})


@dataclass(frozen=True)
class AddParameters:
    """An upload that is added to a data set. ``labels``: those that come are added, or replace those that are there."""

    upload: str
    labels: str = field(default="add", metadata={"choices": ("add", "replace")})
    fps: float | None = field(default=None, metadata={"min": 1, "max": 1000})


@dataclass(frozen=True)
class RemoveParameters:
    """Clips that are removed from a data set: their names as a JSON list."""

    clips: str


def import_upload(workspace: Workspace, name: str, values: ImportParameters, report: Report) -> None:
    """Imports an upload as the data set ``name``; raises as Workspace.import_upload."""
    workspace.import_upload(
        name, values.upload, skeleton=values.skeleton, labels=values.labels, fps=values.fps, report=report
    )


def add_upload(workspace: Workspace, name: str, values: AddParameters, report: Report) -> None:
    """Adds an upload to the data set ``name``; raises as Workspace.add_upload."""
    workspace.add_upload(name, values.upload, fps=values.fps, replace_labels=values.labels == "replace", report=report)


def names_of_clips(names: Iterable[str]) -> str:
    """Clip names as RemoveParameters takes them."""
    return json.dumps(sorted(names), ensure_ascii=False)


def remove_clips(workspace: Workspace, name: str, values: RemoveParameters, report: Report) -> None:
    """Removes clips from the data set ``name``; raises as Workspace.remove_clips."""
    try:
        clips = [str(clip) for clip in json.loads(values.clips)]
    except (ValueError, TypeError):
        raise WorkspaceError("Which clips to remove is not clear; choose them again.") from None
    workspace.remove_clips(name, clips, report)
