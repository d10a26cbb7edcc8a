"""From recordings to a stored data set, clip by clip, so that a collection may be larger than memory."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path

from core.editing.repairs import Repair, repaired
from core.inspection import inspect_dataset
from core.mocap.clip import Clip, Label
from core.mocap.corrections import BodyCorrections, corrections_of
from core.mocap.dataset import (
    READ_AS_THEY_ARE,
    Dataset,
    FileReport,
    ImportReport,
    motion_digest,
    read_recordings,
)
from core.mocap.errors import RecordingError
from core.mocap.files import files_below
from core.mocap.label_files import find_labels, take_labels
from core.mocap.labels import read_labels
from core.mocap.other_files import LeftOut, in_words
from core.mocap.readers import is_recording
from core.mocap.reading import Change, Reading, read_again
from core.mocap.recordings import find_left_out
from core.mocap.reports import Verdict
from core.mocap.storage import load_dataset, save_dataset, writing_dataset
from core.mocap.text import recording_format
from core.progress import Report
from core.workspace.errors import WorkspaceError

Source = str | Path


@dataclass(frozen=True)
class Recordings:
    """What to import: files, or folders searched recursively, and how to read them.

    skeleton: .asf for .amc files without one. how: what was said beside the files (unit, way up, rate, bodies). clips:
    only these. labels: CSV file or folder; where not given, the label files in the source folders. before: the data set
    that these recordings are added to. replace_labels: its labels give way to those that come. also: reports of what
    happened to the files until now.
    """

    sources: Sequence[Source]
    skeleton: Source | None = None
    how: Reading = READ_AS_THEY_ARE
    clips: Iterable[str] | None = None
    labels: Source | None = None
    before: Dataset | None = field(default=None, repr=False)
    replace_labels: bool = False
    also: tuple[FileReport, ...] = ()


def store_recordings(folder: Path, name: str, what: Recordings, report: Report) -> None:
    """Reads recordings into ``folder``; a bad file among good ones stands in the report.

    Raises WorkspaceError where no file can be read or all are there already, RecordingError where there is nothing to
    read or the labels that were asked for are bad, OSError, Cancelled.
    """
    before = what.before or Dataset(name, ())
    arrivals = _Arrivals(before, what.sources)
    with writing_dataset(folder, name) as writer:
        for clip, digest in zip(before.clips, before.digests, strict=True):
            writer.add(clip, digest)
        how = _with_known_bodies(what.how, before)
        for file, recording in read_recordings(
            what.sources, skeleton=what.skeleton, how=how, clips=what.clips, report=report
        ):
            arrived = arrivals.take(file, recording)
            if arrived is not None:
                writer.add(arrived)
        labels, label_reports = labels_for(what, arrivals.frames, arrivals.names)
        if not arrivals.names and not (before.clips and labels):
            raise WorkspaceError(arrivals.why_none(what.also))
        left = left_out_reports(find_left_out(what.sources), what.sources)
        files = (*what.also, *arrivals.files, *left, *label_reports)
        writer.labels, writer.report = _together(before, what, labels, files)
    _inspect(folder, report)


def _with_known_bodies(how: Reading, before: Dataset) -> Reading:
    """What was said, and the corrections of bodies that the dataset has: they count for all clips of a rig."""
    known = corrections_of((clip.skeleton for clip in before.clips), only_corrected=True)
    if not known.rigs:
        return how
    said = how.body.rigs if how.body else ()
    return replace(how, body=BodyCorrections((*known.rigs, *said)))


class _Arrivals:
    """The clips of an import under the names they get. frames: clip name -> frames, those that were there included;
    names: name of a new clip's file -> its name in the data set."""

    def __init__(self, before: Dataset, sources: Sequence[Source]):
        self.files: list[FileReport] = []
        self.names: dict[str, str] = {}
        self.frames = {clip.name: clip.n_frames for clip in before.clips}
        self._before, self._sources = before, sources

    def take(self, file: FileReport | RecordingError, clip: Clip | None) -> Clip | None:
        """The clip under a name that is free; None where there is none, or the same one is there already."""
        file = _below_source(file, self._sources)
        if clip is not None and (there := self._there_already(clip)):
            reason = (f"left out: the same recording is there already, as {there}",)
            file, clip = replace(file, clip=None, verdict="warning", messages=reason), None
        elif clip is not None:
            was = clip.name
            clip, file = _with_free_name(clip, file, self.frames)
            self.names[was], self.frames[clip.name] = clip.name, clip.n_frames
        self.files.append(file)
        return clip

    def _there_already(self, clip: Clip) -> str:
        """The clip that was added under this name before and is the same recording."""
        names = (n for n in self._before.names if n == clip.name or n.startswith(f"{clip.name} ("))
        digest = motion_digest(clip)
        return next((name for name in names if motion_digest(self._before.clip(name)) == digest), "")

    def why_none(self, also: Sequence[FileReport]) -> str:
        """Why there is no clip among them, in words."""
        errors = [file for file in (*also, *self.files) if file.verdict == "error"]
        if self._before.clips and not errors:
            return f"Nothing was added: {self._before.name} has all of these recordings already."
        return _why_empty(errors, "be read")


def left_out_reports(groups: Sequence[LeftOut], sources: Sequence[Source]) -> tuple[FileReport, ...]:
    """A report for each format that was left out: a warning where it holds motion, with the way to convert it."""
    reports = []
    for group in groups:
        path = _below_source(FileReport(group.files[0], None, "ok"), sources).path
        more = f" and {len(group.files) - 1} more" if len(group.files) > 1 else ""
        verdict: Verdict = "warning" if group.advice else "ok"
        reports.append(FileReport(f"{path}{more}", None, verdict, (in_words([group]),)))
    return tuple(reports)


def left_out_words(folder: Path) -> list[str]:
    """What of a folder is not read, in one sentence; none where nothing is left out."""
    groups = find_left_out(folder)
    return [f"There is no recording among these files: {in_words(groups)}."] if groups else []


def labels_for(
    what: Recordings, frames: Mapping[str, int], names: Mapping[str, str]
) -> tuple[tuple[Label, ...], tuple[FileReport, ...]]:
    """The labels that were asked for, else those that lie beside the recordings, and a report of each label file.

    frames: clip name -> number of frames; names: what clips of these recordings are called here, where another had
    their name. Raises RecordingError where the labels that were asked for hold a fault.
    """
    meant = dict(frames) | {was: frames[now] for was, now in names.items()}
    if what.labels is not None:
        read_labels(what.labels)
        given = Path(what.labels)
        paths = [path for path in files_below(given) if path.suffix == ".csv"] if given.is_dir() else [given]
        taken = [take_labels(path, meant) for path in paths]
        labels, label_reports = tuple(label for some, _ in taken for label in some), tuple(file for _, file in taken)
    else:
        labels, label_reports = find_labels([source for source in what.sources if Path(source).is_dir()], meant)
    renamed = (label._replace(clip=names.get(label.clip, label.clip)) for label in labels)
    return tuple(dict.fromkeys(renamed)), tuple(_below_source(file, what.sources) for file in label_reports)


def _together(
    before: Dataset, what: Recordings, labels: Sequence[Label], files: Sequence[FileReport]
) -> tuple[tuple[Label, ...], ImportReport]:
    """Labels and report of what was there and what has come."""
    addition = before.report.last_addition + 1 if before.clips else 0
    kept = () if what.replace_labels and labels else before.labels
    came = tuple(replace(file, addition=addition) for file in files)
    return tuple(dict.fromkeys((*kept, *labels))), replace(before.report, files=(*before.report.files, *came))


def add_labels(before: Dataset, what: Recordings) -> tuple[tuple[Label, ...], ImportReport]:
    """Labels and report of the data set ``before`` with the label files of ``what.sources`` (files or folders).

    Raises WorkspaceError where no row fits its clips: which, and why.
    """
    frames = {clip.name: clip.n_frames for clip in before.clips}
    labels: list[Label] = []
    files = list(what.also)
    for source in map(Path, what.sources):
        some, label_reports = find_labels([source], frames) if source.is_dir() else take_labels(source, frames)
        labels += some
        files += label_reports if isinstance(label_reports, tuple) else [label_reports]
    files = [_below_source(file, what.sources) for file in files]
    if not labels:
        doubtful = [file for file in files if file.verdict != "ok"]
        raise WorkspaceError(_why_empty(doubtful, "be used") if doubtful else "There are no labels in these files.")
    return _together(before, what, labels, files)


def holds_recordings(folder: Path) -> bool:
    """Whether there is a recording in a folder or below it."""
    return any(map(is_recording, files_below(folder)))


def only_skeleton(folder: Path) -> Path | None:
    """The only .asf of a folder and all below it; None where there is none, or more."""
    skeletons = [path for path in files_below(folder) if recording_format(path)[1] == ".asf"]
    return skeletons[0] if len(skeletons) == 1 else None


def store_changed(folder: Path, before: Dataset, change: Change, chosen: Collection[str], report: Report) -> None:
    """Stores the data set ``before`` with what ``change`` says of the ``chosen`` clips, inspected anew.

    Corrections of a body count for all clips of the rig. Raises WorkspaceError where nothing changes, ParameterError
    for a correction that does not fit, OSError, Cancelled.
    """
    bodies = Change(Reading(body=change.how.body))
    changed = False
    with writing_dataset(folder, before.name) as writer:
        for k, (clip, digest) in enumerate(zip(before.clips, before.digests, strict=True)):
            report("Changing clips", k / len(before.clips))
            new = read_again(clip, change if clip.name in chosen else bodies)
            same = (new.skeleton, new.fps, new.up) == (clip.skeleton, clip.fps, clip.up)
            changed |= not same or new.notes != clip.notes
            writer.add(new, digest if same else None)
        writer.labels, writer.report = before.labels, _uninspected(before)
    if not changed:
        raise WorkspaceError("Nothing changes: the clips are read in this way already.")
    _inspect(folder, report)


def store_repaired(folder: Path, before: Dataset, repairs: Mapping[str, Sequence[Repair]], report: Report) -> None:
    """Stores the data set ``before`` with these repairs of its clips, by their names, inspected anew.

    Raises ParameterError for a repair that cannot be made, OSError, Cancelled.
    """
    labels = [label for label in before.labels if label.clip not in repairs]
    with writing_dataset(folder, before.name) as writer:
        for k, (clip, digest) in enumerate(zip(before.clips, before.digests, strict=True)):
            report("Repairing clips", k / len(before.clips))
            if clip.name in repairs:
                new, own = repaired(clip, before.labels, repairs[clip.name])
                labels += own
                writer.add(new)
            else:
                writer.add(clip, digest)
        writer.labels, writer.report = labels, _uninspected(before)
    _inspect(folder, report)


def _uninspected(dataset: Dataset) -> ImportReport:
    """The report without what was found in clips: they are inspected anew. What is said of files alone stays."""
    files = (
        replace(file, verdict="ok", messages=(), findings=()) if file.clip in dataset.names else file
        for file in dataset.report.files
    )
    return replace(dataset.report, files=tuple(files))


def store_dataset(folder: Path, dataset: Dataset, report: Report) -> None:
    """Stores a data set that is in memory, inspected; raises WorkspaceError where it has no clips, OSError."""
    if not dataset.clips:
        raise WorkspaceError("There are no clips to store.")
    save_dataset(folder, dataset)
    _inspect(folder, report)


def _why_empty(bad: Sequence[FileReport], what: str) -> str:
    """Why nothing could be taken from these files, in words."""
    reasons = "; ".join(_reason(file) for file in bad[:3])
    more = f"; and {len(bad) - 3} more" if len(bad) > 3 else ""
    if len(bad) == 1:
        return f"The file cannot {what}: {reasons}"
    return f"None of the {len(bad)} files can {what}: {reasons}{more}"


def _reason(file: FileReport) -> str:
    name, text = Path(file.path).name, "; ".join(file.messages)
    return text if text.startswith(name) else f"{name}: {text}"


def _inspect(folder: Path, report: Report) -> None:
    """Puts what inspection finds into the stored report."""
    inspected = inspect_dataset(load_dataset(folder), report)
    head = folder / "dataset.json"
    document = json.loads(head.read_text(encoding="utf-8")) | {"report": asdict(inspected)}
    head.write_text(json.dumps(document, ensure_ascii=False), encoding="utf-8")


def _below_source(file: FileReport | RecordingError, sources: Sequence[Source]) -> FileReport:
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
    note = f"a clip called {clip.name} was there already; this one is called {name}"
    return replace(clip, name=name), replace(file, clip=name, verdict="warning", messages=(note, *file.messages))
