"""What is done to data sets as jobs: importing an upload, adding one to a data set, removing clips, editing one.

Parameters are plain values, as they stand in the job table; each function does one job in a worker.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from core.progress import Report
from core.workspace.errors import WorkspaceError
from core.workspace.workspace import Workspace

if TYPE_CHECKING:
    from core.editing.edits import Edited
    from core.mocap.corrections import BodyCorrections
    from core.mocap.dataset import Dataset


@dataclass(frozen=True)
class ImportParameters:
    """An import of an upload.

    skeleton, labels: files of it. points: the list of joints that files of points have; smooth: cut-off in Hz of what
    they are smoothed with. The rest as in :class:`RereadParameters`.
    """

    upload: str
    skeleton: str = ""
    labels: str = ""
    fps: float | None = field(default=None, metadata={"min": 1, "max": 1000})
    unit: str = ""
    up: str = ""
    body: str = ""
    points: str = ""
    smooth: float | None = field(default=None, metadata={"min": 0.1, "max": 1000})


@dataclass(frozen=True)
class AddParameters:
    """An upload that is added to a data set. ``labels``: those that come are added, or replace those that are there;
    the rest as in :class:`ImportParameters`."""

    upload: str
    labels: str = field(default="add", metadata={"choices": ("add", "replace")})
    fps: float | None = field(default=None, metadata={"min": 1, "max": 1000})
    unit: str = ""
    up: str = ""
    body: str = ""
    points: str = ""
    smooth: float | None = field(default=None, metadata={"min": 0.1, "max": 1000})


@dataclass(frozen=True)
class RereadParameters:
    """How clips of a data set are to be read instead.

    clips: their names as a JSON list, all where empty. fps: frames per second. unit: of length in their files (m, cm,
    ..., auto); up: the axis that points up in them (y, z, ..., auto); body: corrections of bodies as JSON text, see
    core.mocap.corrections; nothing changes where empty.
    """

    clips: str = ""
    fps: float | None = field(default=None, metadata={"min": 1, "max": 1000})
    unit: str = ""
    up: str = ""
    body: str = ""


@dataclass(frozen=True)
class RepairParameters:
    """Repairs of clips of a data set.

    repairs: a JSON list of ``{"clip", "action", "start", "end", "value"}``, see core.editing.repairs.Repair. Or clips:
    a JSON list of names, and kinds: a JSON list of kinds of findings (all where empty); each of these findings gets its
    usual repair. version: the fingerprint of the data set whose frames are meant, any where empty.
    """

    repairs: str = ""
    clips: str = ""
    kinds: str = ""
    version: str = ""


@dataclass(frozen=True)
class RemoveParameters:
    """Clips that are removed from a data set: their names as a JSON list."""

    clips: str


@dataclass(frozen=True)
class EditParameters:
    """What to do to ``clip``: one of ``action``; the rest is what it needs.

    start, end: frames to keep (trim). fps: the new rate. frame: the first of the second part (split).
    into: name of a new data set for what comes of it; into the clip's own where empty.
    """

    clip: str
    action: str = field(metadata={"choices": ("trim", "mirror", "rate", "split", "labels")})
    start: int = field(default=0, metadata={"min": 0})
    end: int = field(default=0, metadata={"min": 0})
    fps: float = field(default=0.0, metadata={"min": 0, "max": 1000})
    frame: int = field(default=0, metadata={"min": 0})
    into: str = ""


@dataclass(frozen=True)
class DemoParameters:
    """The embedded data set: its length, and the seed it grows from."""

    minutes: float = field(default=6.0, metadata={"min": 0.5, "max": 600})
    seed: int = field(default=0, metadata={"min": 0, "max": 2**31})


@dataclass(frozen=True)
class ReportParameters:
    """A report that the app writes: html or pdf; the id of its board, "" for one of the dataset."""

    form: str = "html"
    board: str = ""


def import_upload(workspace: Workspace, name: str, values: ImportParameters, report: Report) -> None:
    """Imports an upload as the data set ``name``; raises as Workspace.import_upload."""
    workspace.import_upload(
        name,
        values.upload,
        skeleton=values.skeleton,
        labels=values.labels,
        unit=values.unit,
        up=values.up,
        fps=values.fps,
        body=_corrections(values.body),
        points=values.points,
        smooth=values.smooth,
        report=report,
    )


def add_upload(workspace: Workspace, name: str, values: AddParameters, report: Report) -> None:
    """Adds an upload to the data set ``name``; raises as Workspace.add_upload."""
    workspace.add_upload(
        name,
        values.upload,
        unit=values.unit,
        up=values.up,
        fps=values.fps,
        body=_corrections(values.body),
        points=values.points,
        smooth=values.smooth,
        replace_labels=values.labels == "replace",
        report=report,
    )


def reread_clips(workspace: Workspace, name: str, values: RereadParameters, report: Report) -> None:
    """Changes how clips of the data set ``name`` are read; raises as Workspace.change_reading."""
    from core.mocap.dataset import reading
    from core.mocap.reading import Change

    how = reading(values.unit or None, values.up or None, values.fps, _corrections(values.body))
    change = Change(how, guess_up=values.up == "auto", guess_unit=values.unit == "auto")
    workspace.change_reading(name, change, _names(values.clips) if values.clips else None, report)


def repair_clips(workspace: Workspace, name: str, values: RepairParameters, report: Report) -> None:
    """Repairs clips of the data set ``name``; raises as Workspace.repair, and where it is not what was meant."""
    from core.editing.repairs import Repair, usual_repairs

    dataset = workspace.open(name)
    if values.version and values.version != dataset.fingerprint:
        raise WorkspaceError(f"{name} has changed meanwhile; look at it again and choose once more.")
    repairs: dict[str, list[Repair]] = {}
    if values.repairs:
        try:
            for entry in json.loads(values.repairs):
                frames = int(entry.get("start") or 0), int(entry.get("end") or 0)
                repair = Repair(str(entry["action"]), *frames, str(entry.get("value") or ""))
                repairs.setdefault(str(entry["clip"]), []).append(repair)
        except (ValueError, TypeError, KeyError, AttributeError):
            raise WorkspaceError("Which repairs are meant is not clear; choose them again.") from None
    else:
        findings, kinds = dataset.report.findings_by_clip(), _names(values.kinds) if values.kinds else ()
        for clip in set(_names(values.clips)).intersection(findings, dataset.names):
            repairs[clip] = usual_repairs(dataset.clip(clip), findings[clip], kinds)
    workspace.repair(name, {clip: what for clip, what in repairs.items() if what}, report)


def _corrections(text: str) -> BodyCorrections | None:
    from core.errors import FormatError
    from core.mocap.corrections import from_json

    if not text:
        return None
    try:
        return from_json(json.loads(text))
    except (ValueError, RecursionError) as error:
        raise error if isinstance(error, FormatError) else FormatError("body corrections are JSON text") from None


def _names(text: str) -> list[str]:
    """Clip names from a JSON list. Raises WorkspaceError."""
    try:
        return [str(clip) for clip in json.loads(text)]
    except (ValueError, TypeError):
        raise WorkspaceError("Which clips are meant is not clear; choose them again.") from None


def names_of_clips(names: Iterable[str]) -> str:
    """Clip names as RemoveParameters takes them."""
    return json.dumps(sorted(names), ensure_ascii=False)


def remove_clips(workspace: Workspace, name: str, values: RemoveParameters, report: Report) -> None:
    """Removes clips from the data set ``name``; raises as Workspace.remove_clips."""
    workspace.remove_clips(name, _names(values.clips), report)


def edit_clip(workspace: Workspace, name: str, values: EditParameters, report: Report) -> None:
    """Edits a clip of the data set ``name``; the clip itself stays as it is, what comes of it is added.

    Raises WorkspaceError where there is no such clip, ValueError where the edit cannot be made.
    """
    from core.editing import edits
    from core.mocap.dataset import Dataset
    from core.mocap.reports import FileReport, ImportReport

    dataset = workspace.open(name)
    if values.clip not in dataset.names:
        raise WorkspaceError(f"There is no clip {values.clip[:80]!r} in {name!r}.")
    report("Editing", 0.0)
    taken = set() if values.into else set(dataset.names)
    made = []
    for edited in _edits(dataset, values):
        edited = edits.renamed(edited, edits.free_name(edited.clip.name, taken))
        taken.add(edited.clip.name)
        made.append(edited)
    files = tuple(FileReport(edited.clip.name, edited.clip.name, "ok", (edited.summary,)) for edited in made)
    labels = tuple(label for edited in made for label in edited.labels)
    more = Dataset(values.into or name, tuple(edited.clip for edited in made), labels, ImportReport(files))
    if values.into:
        workspace.add_dataset(values.into, more, report)
    else:
        workspace.add_clips(name, more, report)


def _edits(dataset: Dataset, values: EditParameters) -> Sequence[Edited]:
    from core.editing import edits
    from core.poses.body_frames import body_frames

    clip = dataset.clip(values.clip)
    labels = [label for label in dataset.labels if label.clip == clip.name]
    if values.action == "trim":
        return [edits.trim(clip, labels, values.start, values.end)]
    if values.action == "mirror":
        return [edits.mirrored(clip, labels, body_frames([c for c in dataset.clips if c.skeleton == clip.skeleton]))]
    if values.action == "rate":
        return [edits.at_rate(clip, labels, values.fps)]
    return edits.split(clip, labels, [values.frame] if values.action == "split" else edits.label_cuts(clip, labels))
