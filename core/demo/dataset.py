"""The demo as a dataset, and as files."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from core.demo.routines import routines
from core.errors import ParameterError
from core.mocap.bvh import write_bvh
from core.mocap.clip import Clip, Label
from core.mocap.dataset import Dataset
from core.mocap.labels import write_labels
from core.progress import Report, silent


def make_demo(minutes: float = 6, seed: int = 0, report: Report = silent) -> Dataset:
    """The demo as a :class:`core.mocap.dataset.Dataset`: at least ``minutes`` of labelled motion, 60 frames a second.

    Same seed, same data set. Raises ValueError where minutes is not positive.
    """
    clips: list[Clip] = []
    labels: list[Label] = []
    for clip, clip_labels in _checked(minutes, seed, report):
        clips.append(clip)
        labels.extend(clip_labels)
    return Dataset(name="demo", clips=tuple(clips), labels=tuple(labels))


def write_demo(folder: str | Path, minutes: float = 6, seed: int = 0, report: Report = silent) -> list[Path]:
    """Write the demo as BVH files and ``labels.csv`` into ``folder``; the files written, labels last.

    Routines are made and written one by one, so hours need no more memory than minutes. Same seed, same bytes.
    Raises ValueError where minutes is not positive, OSError where the folder cannot be written.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    written: list[Path] = []
    labels: list[Label] = []
    for clip, clip_labels in _checked(minutes, seed, report):
        written.append(folder / f"{clip.name}.bvh")
        write_bvh(written[-1], clip)
        labels.extend(clip_labels)
    written.append(folder / "labels.csv")
    write_labels(written[-1], labels)
    return written


def _checked(minutes: float, seed: int, report: Report) -> Iterator[tuple[Clip, tuple[Label, ...]]]:
    if not minutes > 0:
        raise ParameterError(f"the demo needs a positive number of minutes, not {minutes}")
    seconds = 0.0
    for clip, labels in routines(minutes, seed):
        seconds += clip.seconds
        yield clip, labels
        report("demo", min(1.0, seconds / (60 * minutes)))
