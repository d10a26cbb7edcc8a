"""Recordings with labels in which several actions follow one another, on which segmentations are judged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from benchmarks.labelled import bandai_namco
from benchmarks.recordings import asfamc, exercises
from core.demo import make_demo
from core.mocap.clip import Clip, Label, Segment
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.labels import read_labels
from core.synthesis.stitching import stitch

CLIPS_A_TAKE = 12


def labelled_exercises() -> Dataset | None:
    """The five CMU exercise clips with their labels; None where they are not here."""
    dataset = exercises()
    folder = asfamc()
    return replace(dataset, labels=read_labels(folder.parents[1] / "labels" / "mocap6")) if dataset and folder else None


def cmu86() -> Dataset | None:
    """CMU 86_01 and 86_09 with their labels; None where they are not here."""
    folder = asfamc()
    labels = folder and folder.parents[1] / "labels" / "cmu86"
    return open_dataset(folder / "86", clips=("86_01", "86_09"), labels=labels) if folder else None


def demo(seed: int = 100, minutes: float = 8) -> Dataset:
    """A made-up recording, see :mod:`core.demo`."""
    return make_demo(minutes, seed)


def concatenated(name: str, seed: int = 0) -> Dataset | None:
    """Clips of one action each joined into takes of twelve, one style a take, in random order; None where not here.

    Neighbours pass into one another in a cross-fade of .4 s, in the middle of which the label changes.
    """
    collection = bandai_namco(name)
    if collection is None:
        return None
    dataset, labels = collection
    rng = np.random.default_rng(seed)
    styles: dict[str, list[str]] = {}
    for clip in dataset.names:
        styles.setdefault(labels.style[clip], []).append(clip)
    takes = []
    for style, names in sorted(styles.items()):
        order = [names[k] for k in rng.permutation(len(names))]
        parts = np.array_split(np.array(order), max(1, round(len(order) / CLIPS_A_TAKE)))
        takes += [_take(dataset, labels.content, part.tolist(), f"{style}_{k:02d}") for k, part in enumerate(parts)]
    clips, rows = zip(*takes, strict=True)
    return replace(dataset, clips=clips, labels=tuple(label for own in rows for label in own), digests=())


def _take(dataset: Dataset, content: dict[str, str], names: Sequence[str], name: str) -> tuple[Clip, tuple[Label, ...]]:
    """One clip of several, and its labels."""
    pieces = [Segment(clip, 0, dataset.clip(clip).n_frames) for clip in names]
    made = stitch(dataset, pieces, keep_feet=False, name=name)
    seams = [round((start + end) / 2) for start, end in made.timeline.seams]
    edges = [0, *seams, made.clip.n_frames]
    return made.clip, tuple(
        Label(name, start, end, content[clip]) for clip, start, end in zip(names, edges[:-1], edges[1:], strict=True)
    )


COLLECTIONS = {
    "exercises": labelled_exercises,
    "CMU 86": cmu86,
    "demo": demo,
    "bandai_namco_2_part, joined": lambda: concatenated("bandai_namco_2_part"),
}
"""What is reported, by name."""
