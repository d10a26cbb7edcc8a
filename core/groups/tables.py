"""What is counted of each unit: how often and how long it does something, and what it does next."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from core.arrays import FloatArray
from core.groups.design import Design
from core.mocap.clip import Segment

MEASURES = (("share", "% of time"), ("rate", "times a minute"), ("duration", "s each"))
"""Name and unit of what :func:`use_table` counts."""


@dataclass(frozen=True)
class Item:
    """Something that happens in clips: a motif, an action or a label. kind: which; segments: where, at own rates."""

    kind: str
    id: str
    name: str
    segments: tuple[Segment, ...]


Clips = Mapping[str, tuple[int, float]]
"""Name of a clip -> its frames and frame rate."""


def use_table(design: Design, items: Sequence[Item], clips: Clips) -> FloatArray:
    """Share of time in per cent, times a minute and mean seconds of each item, ``(n_units, n_items, 3)``.

    The mean duration of what a unit never does is nan. Frames in several segments of an item count once.
    """
    counts, seconds = _counted(items, clips)
    table = np.full((len(design.units), len(items), 3), np.nan)
    for row, unit in enumerate(design.units):
        length = sum(clips[clip][0] / clips[clip][1] for clip in unit.clips)
        number = sum((counts[clip] for clip in unit.clips if clip in counts), np.zeros(len(items)))
        spent = sum((seconds[clip] for clip in unit.clips if clip in seconds), np.zeros(len(items)))
        table[row, :, 0] = 100 * spent / length
        table[row, :, 1] = 60 * number / length
        table[row, :, 2] = np.divide(spent, number, out=np.full(len(items), np.nan), where=number > 0)
    return table


def _counted(items: Sequence[Item], clips: Clips) -> tuple[dict[str, FloatArray], dict[str, FloatArray]]:
    """Of each clip how often every item occurs and for how many seconds."""
    counts: dict[str, FloatArray] = {}
    seconds: dict[str, FloatArray] = {}
    for k, item in enumerate(items):
        ends: dict[str, int] = {}
        for clip, start, end in sorted(item.segments):
            if clip not in clips:
                continue
            counts.setdefault(clip, np.zeros(len(items)))[k] += 1
            fresh = max(0, end - max(start, ends.get(clip, 0)))
            seconds.setdefault(clip, np.zeros(len(items)))[k] += fresh / clips[clip][1]
            ends[clip] = max(ends.get(clip, 0), end)
    return counts, seconds


def transitions(design: Design, items: Sequence[Item]) -> tuple[list[tuple[int, int]], FloatArray, np.ndarray]:
    """What follows what: pairs of items (source, target), the probability that target follows source in each unit,
    ``(n_units, n_pairs)``, nan where the unit has nothing after source, and how often it was, ``(n_units, n_pairs)``.

    The next item is the next that begins in the same clip; the last of a clip has none.
    """
    by_clip: dict[str, list[tuple[int, int]]] = {}
    for k, item in enumerate(items):
        for clip, start, _ in item.segments:
            by_clip.setdefault(clip, []).append((start, k))
    found = np.zeros((len(design.units), len(items), len(items)), np.int64)
    for row, unit in enumerate(design.units):
        for clip in unit.clips:
            for (_, source), (_, target) in pairwise(sorted(by_clip.get(clip, ()))):
                found[row, source, target] += 1
    pairs = [(int(s), int(t)) for s, t in zip(*np.nonzero(found.sum(0)), strict=True)]
    leaving = found.sum(2)
    sources, targets = (np.array([pair[k] for pair in pairs], int) for k in (0, 1))
    counts = found[:, sources, targets]
    shares = np.divide(counts, leaving[:, sources], out=np.full(counts.shape, np.nan), where=leaving[:, sources] > 0)
    return pairs, shares, counts
