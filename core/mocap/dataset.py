"""Dataset: a collection of clips with labels, and how a folder of recordings becomes one."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Literal

from joblib import Parallel, delayed

from core.errors import ParameterError
from core.mocap.asfamc import DEFAULT_FPS, AsfSkeleton, read_amc, read_asf
from core.mocap.clip import Clip, Label
from core.mocap.corrections import BodyCorrections, read_corrections
from core.mocap.errors import RecordingError
from core.mocap.label_files import find_label_files, find_labels
from core.mocap.labels import fit_labels, read_labels
from core.mocap.other_files import in_words
from core.mocap.points.naming import preset_called
from core.mocap.readers import read_clips
from core.mocap.reading import Change, Reading, read_again, settled
from core.mocap.recordings import Recording, Source, find_left_out, find_recordings, find_skeleton, name_recordings
from core.mocap.reports import FileReport, ImportReport, Verdict
from core.mocap.skeleton import Skeleton
from core.mocap.text import recording_format
from core.mocap.units import metres_of
from core.mocap.upright import axis_of
from core.progress import Report, silent

__all__ = ["Dataset", "FileReport", "ImportReport", "find_recordings", "open_dataset", "read_recordings"]
READ_AS_THEY_ARE = Reading()  # nothing was said
_BATCH = 8  # files read at a time: bounds what is in memory before the caller has stored it


@dataclass(frozen=True, eq=False)
class Dataset:
    """Clips in a fixed order, their labels and the report of their import.

    digests: of every clip's content, in the order of the clips; computed where not given. Raises ValueError where two
    clips have one name.
    """

    name: str
    clips: tuple[Clip, ...]
    labels: tuple[Label, ...] = ()
    report: ImportReport = field(default_factory=ImportReport)
    digests: tuple[str, ...] = field(default=(), repr=False)

    def __post_init__(self) -> None:
        if len(self._index) != len(self.clips):
            raise ValueError(f"{self.name}: two clips have the same name")
        if len(self.digests) != len(self.clips):
            object.__setattr__(self, "digests", tuple(map(clip_digest, self.clips)))

    @cached_property
    def _index(self) -> dict[str, int]:
        return {clip.name: k for k, clip in enumerate(self.clips)}

    @cached_property
    def fingerprint(self) -> str:
        """Hash of names, skeletons, rates and joint data; the same wherever and whenever the same files are read."""
        return hashlib.blake2b("\n".join(self.digests).encode(), digest_size=16).hexdigest()

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the clips, in order."""
        return tuple(self._index)

    @property
    def n_frames(self) -> int:
        """Frames of all clips together, each at its own rate."""
        return sum(clip.n_frames for clip in self.clips)

    @property
    def seconds(self) -> float:
        """Duration of all clips together."""
        return sum(clip.seconds for clip in self.clips)

    def clip(self, name: str) -> Clip:
        """The clip called ``name``; raises KeyError where there is none."""
        try:
            return self.clips[self._index[name]]
        except KeyError:
            raise KeyError(f"no clip {name!r} in {self.name}") from None

    def select(self, names: Iterable[str]) -> Dataset:
        """Only these clips and their labels, in this dataset's order; raises KeyError for a name that is not here."""
        keep = sorted({self._index[self.clip(name).name] for name in names})
        chosen = {self.clips[k].name for k in keep}
        files = tuple(f for f in self.report.files if f.clip in chosen)
        return replace(
            self,
            clips=tuple(self.clips[k] for k in keep),
            labels=tuple(label for label in self.labels if label.clip in chosen),
            report=replace(self.report, files=files),
            digests=tuple(self.digests[k] for k in keep),
        )


def clip_digest(clip: Clip) -> str:
    """Hash of a clip's name and motion."""
    return hashlib.blake2b(f"{clip.name}\n{motion_digest(clip)}".encode(), digest_size=16).hexdigest()


def motion_digest(clip: Clip) -> str:
    """Hash of a clip's skeleton, frame rate and motion, whatever its name."""
    digest = hashlib.blake2b(repr((clip.skeleton.fingerprint, clip.fps)).encode(), digest_size=16)
    for part in (clip.root_positions, clip.rotations):
        digest.update(part.tobytes())
    for joint in sorted(clip.translations):
        digest.update(str(joint).encode() + clip.translations[joint].tobytes())
    return digest.hexdigest()


def open_dataset(
    source: Source,
    *,
    name: str | None = None,
    skeleton: str | Path | None = None,
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
    body: str | Path | BodyCorrections | None = None,
    points: str | None = None,
    smooth: float | None = None,
    clips: Iterable[str] | str | None = None,
    labels: str | Path | None = None,
    on_error: Literal["raise", "report"] = "raise",
    report: Report = silent,
) -> Dataset:
    """Read a folder of recordings (and all below), one file, or several of either.

    skeleton: .asf for .amc files that have none beside them. unit: of length in the files (a name of
    core.mocap.units.UNITS, or metres); up: the axis that points up in them; both are found out from the body where not
    given. fps: frame rate of all recordings, in place of what they say (AMC says nothing: 120 where not given). body:
    corrections of bodies, or the JSON file that holds them. points: the list of joints that files of points
    have (a name of core.mocap.points.presets.PRESETS); smooth: cut-off in Hz of what they are smoothed with.
    clips: names of the clips to read (or one string, with commas); all others are left alone. labels: CSV file or
    folder; where not given, the label files of the source folders (see label_files). on_error "report": what cannot be
    read stands in the report instead of raising. Raises RecordingError for the first file that cannot be read, where
    there is nothing to read or a clip of ``clips`` does not exist, ValueError where fps is not positive.
    """
    read, files = [], []
    how = reading(unit, up, fps, body, points, smooth)
    for file, clip in read_recordings(source, skeleton=skeleton, how=how, clips=clips, report=report):
        if isinstance(file, RecordingError):
            if on_error == "raise":
                raise file
            file = FileReport(file.path, None, "error", (str(file),))
        files.append(file)
        if clip is not None:
            read.append(clip)
    sources = [Path(one) for one in ([source] if isinstance(source, str | os.PathLike) else source)]
    fitted, label_report = _labels(sources, labels, {clip.name: clip.n_frames for clip in read}, on_error)
    first = sources[0]
    return Dataset(
        name or (first.resolve().name if first.is_dir() else recording_format(first)[0]),
        tuple(read),
        fitted,
        ImportReport((*files, *label_report.files), (*label_report.messages, *filter(None, [left_out_words(source)]))),
    )


def reread(dataset: Dataset, change: Change) -> Dataset:
    """The dataset as it would be had its files been read with ``change``. Raises ParameterError for a correction that
    does not fit."""
    return replace(dataset, clips=tuple(read_again(clip, change) for clip in dataset.clips), digests=())


def left_out_words(source: Source) -> str:
    """Which files of ``source`` hold motion that is not read, and how to convert it; empty where there is none."""
    return in_words([group for group in find_left_out(source) if group.advice])


def _labels(
    sources: list[Path], labels: str | Path | None, frames: dict[str, int], on_error: str
) -> tuple[tuple[Label, ...], ImportReport]:
    """The labels that were asked for, else those that lie in the sources; and what is to be said of them."""
    if labels is not None:
        fitted, messages = fit_labels(read_labels(labels), frames)
        return fitted, ImportReport(messages=messages)
    folders = [source for source in sources if source.is_dir()]
    if on_error == "raise":  # a file that is called labels and holds faults is no accident
        for file in (file for folder in folders for file in find_label_files(folder) if file.named):
            read_labels(file.path)
    fitted, files = find_labels(folders, frames)
    return fitted, ImportReport(files)


def read_recordings(
    source: Source,
    *,
    skeleton: str | Path | None = None,
    how: Reading = READ_AS_THEY_ARE,
    clips: Iterable[str] | str | None = None,
    report: Report = silent,
) -> Iterator[tuple[FileReport | RecordingError, Clip | None]]:
    """Read recordings one after another (two at a time behind the scenes), in the order of their paths.

    Yields for each file its report and clip, or the RecordingError and None; parameters as in :func:`open_dataset`.
    how: what was said beside the files. Clips of equal skeletons share one. Raises RecordingError where there is
    nothing to read.
    """
    recordings = name_recordings(source, clips)
    if not recordings:
        raise RecordingError(source if isinstance(source, str | os.PathLike) else source[0], "no clip is chosen")
    skeletons: dict[Path, AsfSkeleton | RecordingError] = {}
    jobs = [(r, _skeleton_of(r.path, skeleton, skeletons)) for r in recordings]
    shared: dict[tuple[Skeleton, float], Skeleton] = {}  # equal ones may come in different units
    # Threads: the scanners let go of the interpreter's lock, and nothing has to be copied between processes.
    with Parallel(n_jobs=min(os.cpu_count() or 1, 8), prefer="threads") as parallel:
        for start in range(0, len(jobs), _BATCH):
            report("Reading recordings", start / len(jobs))
            batch = jobs[start : start + _BATCH]
            read: list[tuple[Clip, ...] | RecordingError] = parallel(delayed(_read)(*job, how) for job in batch)
            for (recording, _), one in zip(batch, read, strict=True):
                yield from _reported(recording, one, shared)
    report("Reading recordings", 1.0)


def _reported(
    recording: Recording, read: tuple[Clip, ...] | RecordingError, shared: dict[tuple[Skeleton, float], Skeleton]
) -> Iterator[tuple[FileReport | RecordingError, Clip | None]]:
    if isinstance(read, RecordingError):
        yield read, None
        return
    for clip in read:
        # A file of several skeletons has several clips: what is added to the file's name stays.
        stem = recording_format(recording.path)[0]
        name = recording.clip + clip.name.removeprefix(stem if clip.name.startswith(stem) else read[0].name)
        skeleton = shared.setdefault((clip.skeleton, clip.skeleton.unit), clip.skeleton)
        clip = replace(clip, name=name, skeleton=skeleton)
        doubts = (*clip.warnings, *filter(None, [recording.message]))
        verdict: Verdict = "warning" if doubts else "ok"
        yield FileReport(str(recording.path), name, verdict, (*doubts, *clip.notes), findings=clip.findings), clip


def _skeleton_of(
    path: Path, skeleton: str | Path | None, cache: dict[Path, AsfSkeleton | RecordingError]
) -> AsfSkeleton | RecordingError | None:
    if recording_format(path)[1] != ".amc":
        return None
    try:
        asf = find_skeleton(path, skeleton)
    except RecordingError as error:
        return error
    if asf not in cache:
        try:
            cache[asf] = read_asf(asf)
        except RecordingError as error:
            cache[asf] = error
    return cache[asf]


def _read(
    recording: Recording, asf: AsfSkeleton | RecordingError | None, how: Reading
) -> tuple[Clip, ...] | RecordingError:
    if isinstance(asf, RecordingError):
        return asf
    try:
        if asf is None:
            clips = read_clips(recording.path, how)
        else:
            clips = (read_amc(recording.path, asf, how.fps or DEFAULT_FPS),)
        return tuple(settled(clip, how) for clip in clips)
    except RecordingError as error:
        return error
    except ParameterError as error:  # a correction that does not fit
        return RecordingError(recording.path, str(error))


def reading(
    unit: str | float | None = None,
    up: str | None = None,
    fps: float | None = None,
    body: str | Path | BodyCorrections | None = None,
    points: str | None = None,
    smooth: float | None = None,
) -> Reading:
    """What was said about recordings, from the words it was said with. Raises ParameterError, FormatError, OSError."""
    metres = metres_of(unit) if isinstance(unit, str) else unit
    corrections = read_corrections(body) if isinstance(body, str | Path) else body
    if points and points != "auto":
        preset_called(points)
    return Reading(metres, axis_of(up) if up else None, fps, corrections, _unless_auto(points), smooth)


def _unless_auto(word: str | None) -> str | None:
    return None if not word or word == "auto" else word
