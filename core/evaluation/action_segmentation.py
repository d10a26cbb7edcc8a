"""Scores of temporal action segmentation: MoF, Edit and F1@k, after classes are matched with labelled actions.

A method without labels finds classes, not actions. So each class first stands for an action: one to one (the assignment
of classes to actions that gets most frames right, Kuhn 1955) or many to one (each class for the action that covers most
of it). Then, as usual since Lea et al. (*Temporal Convolutional Networks for Action Segmentation and Detection*, CVPR
2017):

* MoF: the share of labelled frames that are right.
* Edit: 100 (1 - distance / the longer length), Levenshtein's distance of the two sequences of segments of a clip; the
  mean over clips.
* F1@k: a found segment is right if it overlaps a true segment of its action by k % of their union; each true segment
  counts once. Pooled over clips.

Frames without a label do not count and are left out before segments are formed. Frames in no class are wrong. A class
that stands for no action keeps a name of its own, so its segments are wrong.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import linear_sum_assignment

from core.errors import AnalysisError
from core.mocap.clip import Label, Segment

OVERLAPS = (10, 25, 50)
"""Percentages of overlap at which F1 is told."""

Run = tuple[int, int, int]
"""A class or action, the frame it starts at, the frame it ends before."""


class SegmentScores(NamedTuple):
    """All between 0 and 100. f1: one number for each of :data:`OVERLAPS`."""

    mof: float
    edit: float
    f1: tuple[float, ...]

    def to_json(self) -> dict[str, float]:
        """The scores under the names that publications use."""
        return {"mof": self.mof, "edit": self.edit} | {
            f"f1@{k}": value for k, value in zip(OVERLAPS, self.f1, strict=True)
        }


@dataclass(frozen=True)
class SegmentationScores:
    """Scores of one result.

    one_to_one, many_to_one: classes matched with actions over all clips together. clip_one_to_one, clip_many_to_one:
    matched anew for every clip. clips: clips with labels and at least one segment, which are those that count; missing:
    clips with labels and no segment; frames: labelled frames that count; actions, classes: how many occur in them.
    """

    one_to_one: SegmentScores
    many_to_one: SegmentScores
    clip_one_to_one: SegmentScores
    clip_many_to_one: SegmentScores
    clips: int
    missing: int
    frames: int
    actions: int
    classes: int

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: v.to_json() if isinstance(v, SegmentScores) else v for name, v in values.items()}


def score_segmentation(classes: Sequence[Sequence[Segment]], labels: Iterable[Label]) -> SegmentationScores:
    """Scores of classes, each a sequence of segments, against labels, both in frames of the clips' own rates.

    Of overlapping labels the later counts, of overlapping classes too. Raises AnalysisError where there are no labels,
    or no clip that has both labels and segments.
    """
    labels = tuple(labels)
    if not labels:
        raise AnalysisError("there are no labels to compare the result with")
    names = sorted({label.action for label in labels})
    truth = _frames(((label.clip, label.start, label.end), names.index(label.action)) for label in labels)
    found = _frames((segment, k) for k, segments in enumerate(classes) for segment in segments)
    both = sorted(truth.keys() & found.keys())
    if not both:
        raise AnalysisError("no clip has both labels and segments of the result")
    clips = [_labelled(found[clip], truth[clip]) for clip in both]
    n_actions = len(names)
    tables = [_confusion(x, y, len(classes), n_actions) for x, y in clips]
    together = np.sum(tables, axis=0)
    return SegmentationScores(
        one_to_one=_score(clips, [one_to_one(together)] * len(clips)),
        many_to_one=_score(clips, [many_to_one(together)] * len(clips)),
        clip_one_to_one=_score(clips, [one_to_one(table) for table in tables]),
        clip_many_to_one=_score(clips, [many_to_one(table) for table in tables]),
        clips=len(both),
        missing=len(truth) - len(both),
        frames=sum(len(y) for _, y in clips),
        actions=len({int(action) for _, y in clips for action in np.unique(y)}),
        classes=len({int(k) for x, _ in clips for k in np.unique(x[x >= 0])}),
    )


def one_to_one(table: np.ndarray) -> np.ndarray:
    """Action ``(n_classes,)`` of each class, every action given at most once, so that most frames are right.

    table: frames of each class with each action ``(n_classes, n_actions)``. A class that gets no action, or none of
    whose frames it has, gets its number plus n_actions.
    """
    n_classes, n_actions = table.shape
    means: np.ndarray = np.arange(n_classes) + n_actions
    rows, columns = linear_sum_assignment(-table)
    shared = table[rows, columns] > 0
    means[rows[shared]] = columns[shared]
    return means


def many_to_one(table: np.ndarray) -> np.ndarray:
    """Action ``(n_classes,)`` of each class: the one that covers most of it; otherwise as :func:`one_to_one`."""
    n_classes, n_actions = table.shape
    own: np.ndarray = np.where(table.any(1), table.argmax(1), np.arange(n_classes) + n_actions)
    return own


def levenshtein(a: Sequence[int], b: Sequence[int]) -> int:
    """The least number of insertions, deletions and replacements that turn ``a`` into ``b``."""
    row = list(range(len(b) + 1))
    for i, x in enumerate(a, 1):
        before, row = row, [i]
        for j, y in enumerate(b, 1):
            row.append(min(before[j] + 1, row[-1] + 1, before[j - 1] + (x != y)))
    return row[-1]


def edit_score(found: Sequence[int], true: Sequence[int]) -> float:
    """100 (1 - Levenshtein's distance / the longer length) of two sequences of actions; 0 where both are empty."""
    longer = max(len(found), len(true))
    return 100 * (1 - levenshtein(found, true) / longer) if longer else 0.0


def f1_counts(found: Sequence[Run], true: Sequence[Run], overlap: float) -> tuple[int, int, int]:
    """Right, wrong and missed segments of one clip; ``overlap``: share of the union that must be common."""
    taken = [False] * len(true)
    right = 0
    for action, start, end in found:
        shares = [
            max(0, min(end, last) - max(start, first)) / (max(end, last) - min(start, first))
            if action == other
            else 0.0
            for other, first, last in true
        ]
        best = int(np.argmax(shares)) if shares else -1
        if best >= 0 and shares[best] >= overlap and not taken[best]:
            taken[best] = True
            right += 1
    return right, len(found) - right, len(true) - right


def _overlap(start: int, end: int, first: int, last: int) -> float:
    """What two intervals have in common as a share of their union."""
    return max(0, min(end, last) - max(start, first)) / (max(end, last) - min(start, first))


def runs_of(frames: np.ndarray) -> list[Run]:
    """Stretches of equal values ``(n,)``; those of -1, which is nothing, are left out."""
    if not len(frames):
        return []
    edges = np.concatenate([[0], np.flatnonzero(np.diff(frames)) + 1, [len(frames)]])
    return [(int(frames[a]), int(a), int(b)) for a, b in pairwise(edges) if frames[a] >= 0]


def _score(clips: Sequence[tuple[np.ndarray, np.ndarray]], meanings: Sequence[np.ndarray]) -> SegmentScores:
    """clips: class and action of every labelled frame; meanings: for each clip the action of each class."""
    right, edits, counts = 0, [], np.zeros((len(OVERLAPS), 3), int)
    for (classes, actions), means in zip(clips, meanings, strict=True):
        said = np.where(classes >= 0, means[classes], -1)
        right += int((said == actions).sum())
        found, true = runs_of(said), runs_of(actions)
        edits.append(edit_score([run[0] for run in found], [run[0] for run in true]))
        counts += [f1_counts(found, true, k / 100) for k in OVERLAPS]
    frames = sum(len(actions) for _, actions in clips)
    f1 = tuple(100 * 2 * int(tp) / max(2 * int(tp) + int(fp) + int(fn), 1) for tp, fp, fn in counts)
    return SegmentScores(100 * right / frames, float(np.mean(edits)), f1)


def _frames(pieces: Iterable[tuple[tuple[str, int, int], int]]) -> dict[str, np.ndarray]:
    """Per clip the number of each frame up to the last that has one, -1 for those that have none."""
    by_clip: dict[str, list[tuple[int, int, int]]] = {}
    for (clip, start, end), number in pieces:
        by_clip.setdefault(clip, []).append((start, end, number))
    frames = {}
    for clip, items in by_clip.items():
        frames[clip] = np.full(max(end for _, end, _ in items), -1)
        for start, end, number in items:
            frames[clip][start:end] = number
    return frames


def _labelled(found: np.ndarray, truth: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Class and action of the labelled frames of a clip."""
    classes = np.full(len(truth), -1)
    n = min(len(found), len(truth))
    classes[:n] = found[:n]
    return classes[truth >= 0], truth[truth >= 0]


def _confusion(classes: np.ndarray, actions: np.ndarray, n_classes: int, n_actions: int) -> np.ndarray:
    table = np.zeros((n_classes, n_actions), np.int64)
    known = classes >= 0
    np.add.at(table, (classes[known], actions[known]), 1)
    return table
