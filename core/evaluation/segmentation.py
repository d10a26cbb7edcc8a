"""Agreement of a segmentation into terminals with labelled actions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.optimize import linear_sum_assignment

from core.errors import AnalysisError
from core.mocap.clip import Label, Segment

Interval = tuple[int, int]


class FrameAccuracy(NamedTuple):
    """Shares of the labelled frames, between 0 and 1, that get their own action.

    one_to_one: when every terminal stands for at most one action and every action for at most one terminal, assigned
    for the best. many_to_one: when every terminal stands for its most frequent action.
    """

    one_to_one: float
    many_to_one: float


class BoundaryScores(NamedTuple):
    """precision: share of the found boundaries that are right; recall: share of the true ones that are found; f1."""

    precision: float
    recall: float
    f1: float


def frame_accuracy(terminals: Sequence[Sequence[Segment]], labels: Iterable[Label]) -> FrameAccuracy:
    """Accuracy of terminals, each a sequence of segments, against labels, both in frames of the clips' own rates.

    Frames without a label do not count; of overlapping labels or segments the later counts; labelled frames in no
    segment count as wrong. Raises ValueError where there are no labels.
    """
    table, total = confusion(terminals, labels)
    rows, columns = linear_sum_assignment(-table)
    return FrameAccuracy(float(table[rows, columns].sum() / total), float(table.max(1, initial=0).sum() / total))


def confusion(terminals: Sequence[Sequence[Segment]], labels: Iterable[Label]) -> tuple[np.ndarray, int]:
    """Frames of each terminal with each action, ``(n_terminals, n_actions)``, actions by name, and all labelled frames.

    Raises AnalysisError where there are no labels.
    """
    labels = tuple(labels)
    if not labels:
        raise AnalysisError("there are no labels to compare the terminals with")
    actions = sorted({label.action for label in labels})
    ends: dict[str, int] = {}
    for label in labels:
        ends[label.clip] = max(ends.get(label.clip, 0), label.end)
    truth = {clip: np.full(end, -1) for clip, end in ends.items()}
    for label in labels:
        truth[label.clip][label.start : label.end] = actions.index(label.action)
    labelling = {clip: np.full(end, -1) for clip, end in ends.items()}
    for k, segments in enumerate(terminals):
        for clip, start, end in segments:
            if clip in labelling:
                labelling[clip][start:end] = k
    table = np.zeros((len(terminals), len(actions)), np.int64)
    for clip, is_action in truth.items():
        both = (is_action >= 0) & (labelling[clip] >= 0)
        np.add.at(table, (labelling[clip][both], is_action[both]), 1)
    return table, int(sum((is_action >= 0).sum() for is_action in truth.values()))


def boundaries_of(terminals: Sequence[Sequence[Segment]]) -> dict[str, tuple[int, ...]]:
    """Clip -> frames at which the terminal changes, in order; a clip's own ends are no boundaries."""
    pieces: dict[str, list[tuple[int, int]]] = {}
    for k, segments in enumerate(terminals):
        for segment in segments:
            pieces.setdefault(segment.clip, []).append((segment.start, k))
    boundaries = {}
    for clip, items in pieces.items():
        items.sort()
        boundaries[clip] = tuple(start for (_, before), (start, after) in pairwise(items) if before != after)
    return boundaries


def boundary_intervals(
    labels: Iterable[Label], tolerance: float, fps: Mapping[str, float]
) -> dict[str, list[Interval]]:
    """Clip -> intervals, both ends included, around the frames at which its action changes.

    tolerance: seconds to either side; fps: rate of each clip.
    """
    by_clip: dict[str, list[Label]] = {}
    for label in labels:
        by_clip.setdefault(label.clip, []).append(label)
    intervals: dict[str, list[Interval]] = {}
    for clip, items in by_clip.items():
        items.sort(key=lambda label: label.start)
        slack = round(tolerance * fps[clip])
        changes = [b.start for a, b in pairwise(items) if a.action != b.action]
        intervals[clip] = [(at - slack, at + slack) for at in changes]
    return intervals


def score_boundaries(found: Mapping[str, Sequence[int]], accepted: Mapping[str, Sequence[Interval]]) -> BoundaryScores:
    """Boundaries of each clip against the intervals, both ends included, in which a boundary counts as right.

    An interval takes at most one boundary and a boundary at most one interval, as many as can be matched; a clip
    without intervals does not count. Precision is 0 where nothing was found, recall 0 where there is nothing to find.
    """
    right = n_found = n_true = 0
    for clip, intervals in accepted.items():
        boundaries = sorted(found.get(clip, ()))
        n_found += len(boundaries)
        n_true += len(intervals)
        right += _matched(boundaries, intervals)
    precision, recall = right / max(n_found, 1), right / max(n_true, 1)
    return BoundaryScores(precision, recall, 2 * precision * recall / max(precision + recall, 1e-12))


def _matched(boundaries: Sequence[int], intervals: Sequence[Interval]) -> int:
    """The largest number of pairs: intervals by their ends, each takes the earliest boundary that is still free."""
    free, count = list(boundaries), 0
    for first, last in sorted(intervals, key=lambda interval: interval[1]):
        for k, at in enumerate(free):
            if first <= at <= last:
                del free[k]
                count += 1
                break
    return count
