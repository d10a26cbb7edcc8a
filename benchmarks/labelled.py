"""Labelled collections on which search is judged: clips of one action each, by several people or in several styles."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from benchmarks.recordings import SHARED, exercises
from core.demo import make_demo
from core.evaluation.ranking import ClipLabels
from core.mocap.clip import Label
from core.mocap.dataset import Dataset, open_dataset
from core.retrieval.frames import FrameStore

Collection = tuple[Dataset, ClipLabels]


def bandai_namco(name: str) -> Collection | None:
    """A collection whose names say content and style: ``dataset-1_walk_angry_001``; None where it is not here."""
    folder = SHARED / "data" / name
    if not folder.is_dir():
        return None
    dataset = open_dataset(folder)
    words = {clip: clip.split("_") for clip in dataset.names}
    return dataset, ClipLabels({c: w[1] for c, w in words.items()}, {c: w[2] for c, w in words.items()})


def demo_cuts(minutes: float = 15) -> Collection:
    """The actions of the demo; a performer is a style."""
    demo = make_demo(minutes=minutes)
    return _cuts(demo, [(label, label.clip.split("_")[0]) for label in demo.labels])


def exercise_cuts() -> Collection | None:
    """The labelled stretches of five CMU clips; a clip is a style. None where they are not here."""
    dataset = exercises()
    if dataset is None:
        return None
    labels = []
    for path in sorted((SHARED / "data" / "labels" / "mocap6").glob("*.csv")):
        with path.open(newline="") as file:
            for row in csv.DictReader(file):
                label = Label(row["clip"], int(row["start_frame"]), int(row["end_frame"]), row["action"])
                labels.append((label, label.clip))
    return _cuts(dataset, labels)


COLLECTIONS: dict[str, Callable[[], Collection | None]] = {
    "bandai_namco_1": lambda: bandai_namco("bandai_namco_1"),
    "bandai_namco_2_part": lambda: bandai_namco("bandai_namco_2_part"),
    "demo": demo_cuts,
    "CMU exercises": exercise_cuts,
}


def collections() -> dict[str, Collection]:
    """All collections that are here, by name."""
    return {name: found for name, make in COLLECTIONS.items() if (found := make()) is not None}


def some_clips(store: FrameStore, which: np.ndarray) -> FrameStore:
    """A store of the clips numbered ``(k,)`` alone."""
    codes = [store.of(int(k)) for k in which]
    starts = np.concatenate([[0], np.cumsum([len(c) for c in codes])]).astype(np.int64)
    clips = tuple(store.clips[k] for k in which)
    return replace(store, clips=clips, codes=np.concatenate(codes), starts=starts, has=store.has[which])


def _cuts(dataset: Dataset, labels: list[tuple[Label, str]]) -> Collection:
    content, style, clips = {}, {}, []
    for label, manner in labels:
        clip = dataset.clip(label.clip)
        end = min(label.end, clip.n_frames)
        if end - label.start < clip.fps / 4:
            continue
        name = f"{label.clip}_{label.start:06d}"
        clips.append(clip.cut(label.start, end, name))
        content[name], style[name] = label.action, manner
    return replace(dataset, clips=tuple(clips), labels=(), digests=()), ClipLabels(content, style)
