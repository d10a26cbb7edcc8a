"""From recordings to a stored data set, clip by clip, so that a collection may be larger than memory."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from core.inspection import inspect_dataset
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset, FileReport, ImportReport, read_recordings
from core.mocap.errors import RecordingError
from core.mocap.labels import fit_labels, read_labels
from core.mocap.storage import load_dataset, save_dataset, writing_dataset
from core.progress import Report
from core.workspace.errors import WorkspaceError

Source = str | os.PathLike


@dataclass(frozen=True)
class Recordings:
    """What to import: files, or folders searched recursively, and how to read them.

    skeleton: .asf for .amc files without one. fps: frames per second of AMC files (120 where not given). clips: only
    these. labels: CSV file or folder; where not given, ``labels.csv`` or ``labels/`` of a source folder.
    """

    sources: Sequence[Source]
    skeleton: Source | None = None
    fps: float | None = None
    clips: Iterable[str] | None = None
    labels: Source | None = None
    before: Dataset | None = field(default=None, repr=False)  # clips that are there already and stay


def store_recordings(folder: Path, name: str, what: Recordings, report: Report) -> None:
    """Reads recordings into ``folder``; a bad file among good ones stands in the report.

    Raises WorkspaceError where no file can be read, RecordingError where there is nothing to read or the labels that
    were asked for are bad, OSError, Cancelled.
    """
    before = what.before or Dataset(name, ())
    files, frames = [], {clip.name: clip.n_frames for clip in before.clips}
    with writing_dataset(folder, name) as writer:
        for clip, digest in zip(before.clips, before.digests, strict=True):
            writer.add(clip, digest)
        reading = read_recordings(what.sources, skeleton=what.skeleton, fps=what.fps, clips=what.clips, report=report)
        for file, clip in reading:
            files.append(_file_report(file, what.sources))
            if clip is not None:
                clip, files[-1] = _with_free_name(clip, files[-1], frames)
                frames[clip.name] = clip.n_frames
                writer.add(clip)
        if len(frames) == len(before.clips):
            raise WorkspaceError(why_empty(files))
        labels, messages = _labels(what, {name: n for name, n in frames.items() if name not in before.names})
        writer.labels = (*before.labels, *labels)
        writer.report = ImportReport((*before.report.files, *files), (*before.report.messages, *messages))
    _inspect(folder, report)


def store_dataset(folder: Path, dataset: Dataset, report: Report) -> None:
    """Stores a data set that is in memory, inspected; raises WorkspaceError where it has no clips, OSError."""
    if not dataset.clips:
        raise WorkspaceError("There are no clips to store.")
    save_dataset(folder, dataset)
    _inspect(folder, report)


def why_empty(files: Sequence[FileReport]) -> str:
    """Why nothing could be imported, in words."""
    bad = [file for file in files if file.verdict == "error"]
    reasons = "; ".join(" ".join(file.messages) or file.path for file in bad[:3])
    more = f"; and {len(bad) - 3} more" if len(bad) > 3 else ""
    if len(bad) == 1:
        return f"The file cannot be read: {reasons}"
    return f"None of the {len(bad)} files can be read: {reasons}{more}"


def _inspect(folder: Path, report: Report) -> None:
    """Puts what inspection finds into the stored report."""
    found = inspect_dataset(load_dataset(folder), report)
    head = folder / "dataset.json"
    document = json.loads(head.read_text(encoding="utf-8")) | {"report": asdict(found)}
    head.write_text(json.dumps(document, ensure_ascii=False), encoding="utf-8")


def _file_report(file: FileReport | RecordingError, sources: Sequence[Source]) -> FileReport:
    """The report with the path below its source: where the source lies on this machine is nobody's business."""
    if isinstance(file, RecordingError):
        file = FileReport(file.path, None, "error", (str(file),))
    path = Path(file.path)
    folders = (Path(source) for source in sources)
    below = next((path.relative_to(f) for f in folders if path != f and path.is_relative_to(f)), Path(path.name))
    return replace(file, path=below.as_posix())


def _with_free_name(clip: Clip, file: FileReport, taken: Iterable[str]) -> tuple[Clip, FileReport]:
    if clip.name not in taken:
        return clip, file
    name = next(n for n in (f"{clip.name} ({k})" for k in range(2, 100_000)) if n not in taken)
    said = f"a clip called {clip.name} was there already; this one is called {name}"
    return replace(clip, name=name), replace(file, clip=name, verdict="warning", messages=(said, *file.messages))


def _labels(what: Recordings, frames: dict[str, int]) -> tuple[tuple[Label, ...], tuple[str, ...]]:
    if what.labels is not None:
        return fit_labels(read_labels(what.labels), frames)
    folders = [Path(source) for source in what.sources]
    beside = [folder / name for folder in folders if folder.is_dir() for name in ("labels.csv", "labels")]
    labels: list[Label] = []
    faults: list[str] = []
    for path in beside:
        try:
            labels += read_labels(path) if path.exists() else ()
        except RecordingError as error:  # nobody asked for them: the recordings are still welcome
            faults.append(f"no labels were taken: {error}")
    fitted, messages = fit_labels(labels, frames)
    return fitted, (*faults, *messages)
