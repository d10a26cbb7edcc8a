"""Agreement of motifs with labelled actions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.optimize import linear_sum_assignment

from core.errors import AnalysisError
from core.mocap.clip import Label, Segment


class MotifScores(NamedTuple):
    """All between 0 and 1.

    coverage: share of the labelled frames that lie in a motif. purity: share of those that carry the label most
    frequent
    in their motif. pure: share of motifs whose motions all have the same most frequent label. f1_majority: mean over
    actions of the frame F1 when every motif stands for its most frequent label; f1_one_to_one: the same under the best
    assignment of one motif to one action.
    """

    coverage: float
    purity: float
    pure: float
    f1_majority: float
    f1_one_to_one: float


def score_motifs(motifs: Sequence[Sequence[Segment]], labels: Iterable[Label]) -> MotifScores:
    """Scores of motifs, each a sequence of segments, against labels, both in frames of the clips' own rates.

    Frames without a label do not count; of overlapping labels the later counts, of overlapping motions the earlier.
    Raises AnalysisError where there are no labels.
    """
    labels = tuple(labels)
    if not labels:
        raise AnalysisError("there are no labels to compare the motifs with")
    actions = sorted({label.action for label in labels})
    truth = _frames_of_labels(labels, actions)
    predicted = {clip: np.full(len(frames), -1) for clip, frames in truth.items()}
    one_label = []
    for number, motif in enumerate(motifs):
        majorities = set()
        for clip, start, end in (s for s in motif if s.clip in truth):
            part, seen = predicted[clip][start:end], truth[clip][start:end]
            part[part < 0] = number
            if (seen >= 0).any():
                majorities.add(int(np.bincount(seen[seen >= 0]).argmax()))
        if majorities:
            one_label.append(len(majorities) == 1)
    table, sizes = _confusion(truth, predicted, len(motifs), len(actions))
    in_motifs = table.sum()
    return MotifScores(
        coverage=float(in_motifs / max(sizes.sum(), 1)),
        purity=float(table.max(1).sum() / max(in_motifs, 1)),
        pure=float(np.mean(one_label)) if one_label else 0.0,
        f1_majority=_f1_majority(table, sizes),
        f1_one_to_one=_f1_one_to_one(table, sizes),
    )


def _frames_of_labels(labels: tuple[Label, ...], actions: list[str]) -> dict[str, np.ndarray]:
    """Per clip the action of each frame, -1 where there is none."""
    length: dict[str, int] = {}
    for label in labels:
        length[label.clip] = max(length.get(label.clip, 0), label.end)
    frames = {clip: np.full(n, -1) for clip, n in length.items()}
    for label in labels:
        frames[label.clip][label.start : label.end] = actions.index(label.action)
    return frames


def _confusion(
    truth: Mapping[str, np.ndarray], found: Mapping[str, np.ndarray], n_motifs: int, n_actions: int
) -> tuple[np.ndarray, np.ndarray]:
    """Frames of each motif with each action, ``(n_motifs, n_actions)``, and frames of each action, ``(n_actions,)``."""
    table, sizes = np.zeros((max(n_motifs, 1), n_actions), np.int64), np.zeros(n_actions, np.int64)
    for clip, actions in truth.items():
        sizes += np.bincount(actions[actions >= 0], minlength=n_actions)
        covered = (actions >= 0) & (found[clip] >= 0)
        np.add.at(table, (found[clip][covered], actions[covered]), 1)
    return table, sizes


def _f1_majority(table: np.ndarray, sizes: np.ndarray) -> float:
    merged = np.zeros((table.shape[1],) * 2)
    np.add.at(merged, table.argmax(1), table)
    used = sizes > 0
    return float((2 * merged.diagonal() / np.maximum(sizes + merged.sum(1), 1))[used].mean())


def _f1_one_to_one(table: np.ndarray, sizes: np.ndarray) -> float:
    f1 = 2 * table / np.maximum(sizes + table.sum(1, keepdims=True), 1)
    rows, columns = linear_sum_assignment(-f1)
    return float(f1[rows, columns].sum() / (sizes > 0).sum())
