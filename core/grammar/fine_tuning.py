"""The paper's fine tuning: single segments slide or change their length, groups follow (SYN section 4.3).

The paper calls this simulated annealing, yet takes a step only if it raises F. True annealing, which sometimes takes a
worse one, is an option of ours.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from core.errors import AnalysisError
from core.grammar.genetic import pam
from core.grammar.objective import Clustering, span_distances
from core.grammar.pose_space import PoseSpace
from core.progress import Report, silent

_HEAT = 0.003  # share by which a step may raise the cost 1 / F at first, with even odds within a factor of e


class _State:
    """Spans, groups, and the distances that follow them."""

    def __init__(self, space: PoseSpace, spans: np.ndarray, k: int, weight: float, limits: tuple[int, int]):
        self.space, self.weight, self.limits = space, weight, limits
        self.spans = spans.copy()
        self.distances = span_distances(space, spans)
        self.medoids = pam(self.distances, k)
        self.labels = self.distances[:, self.medoids].argmin(1)
        self.labels[self.medoids] = np.arange(len(self.medoids))
        self.cost = self.measure()

    def measure(self) -> float:
        """1 / F of the groups as they are."""
        return 1 / self.clustering().objective(self.space, self.weight)["F"]

    def clustering(self) -> Clustering:
        own = self.distances[np.arange(len(self.spans)), self.medoids[self.labels]]
        return Clustering(self.spans.copy(), self.medoids.copy(), self.labels.copy(), own)

    def moved(self, i: int, step: int, slide: bool) -> dict[int, tuple[int, int]] | None:
        """Spans that change when span ``i`` slides or ends elsewhere; None where that cannot be."""
        last = i + 1 < len(self.spans) and self.spans[i + 1, 0] not in self.space.clip_starts
        start, end = self.spans[i]
        if not last or (slide and start in self.space.clip_starts):
            return None
        changed = {i: (start + step if slide else start, end + step), i + 1: (end + step, self.spans[i + 1, 1])}
        if slide:
            changed[i - 1] = (self.spans[i - 1, 0], start + step)
        fits = all(self.limits[0] <= b - a <= self.limits[1] for a, b in changed.values())
        return changed if fits else None

    def apply(self, changed: dict[int, tuple[int, int]]) -> tuple[Any, ...] | None:
        """Change spans, put them into the groups of the nearest medoids as these were, choose new medoids of the groups
        that changed. What it takes to undo it; None, with nothing changed, where a group would be left empty."""
        rows = np.array(sorted(changed))
        new = np.array([changed[i] for i in sorted(changed)], np.int64)
        labels = self.labels.copy()
        labels[rows] = span_distances(self.space, new, self.spans[self.medoids]).argmin(1)
        touched = np.unique(np.concatenate([self.labels[rows], labels[rows]]))
        if (np.bincount(labels, minlength=len(self.medoids))[touched] == 0).any():
            return None
        before = rows, self.spans[rows].copy(), self.distances[rows].copy(), self.labels, self.medoids.copy(), self.cost
        self.spans[rows], self.labels = new, labels
        self._fill(rows, span_distances(self.space, new, self.spans))
        for group in touched:
            members = np.flatnonzero(labels == group)
            sums = self.distances[np.ix_(members, members)].sum(0)
            self.medoids[group] = members[sums.argmin()]
        self.cost = self.measure()
        return before

    def undo(self, before: tuple[Any, ...]) -> None:
        rows, self.spans[rows], distances, self.labels, self.medoids, self.cost = before
        self._fill(rows, distances)

    def _fill(self, rows: np.ndarray, distances: np.ndarray) -> None:
        self.distances[rows] = distances
        self.distances[:, rows] = distances.T


def fine_tune(
    space: PoseSpace,
    spans: np.ndarray,
    k: int,
    weight: float,
    limits: tuple[int, int],
    rng: np.random.Generator,
    *,
    iterations: int = 1000,
    furthest: int = 15,
    annealing: bool = False,
    report: Report = silent,
) -> Clustering:
    """The best clustering met on the way from ``spans (n, 2)``, clustered by PAM.

    iterations: of slide or resize; the poses by which they move fall from ``furthest`` to 1. limits: poses of the
    shortest and the longest segment. annealing: worse steps are taken too, more rarely as time goes on. Raises
    AnalysisError where there are fewer than ``k`` spans.
    """
    if len(spans) < k:
        raise AnalysisError(f"there are only {len(spans)} segments for {k} terminals; ask for fewer, or shorter pieces")
    state = _State(space, spans, k, weight, limits)
    best, least = state.clustering(), state.cost
    for iteration in range(iterations):
        if iteration % 20 == 0:
            report("fine tuning", iteration / iterations)
        left = 1 - iteration / iterations
        reach = max(1, round(furthest * left))
        step = int(rng.integers(1, reach + 1)) * (1 if rng.uniform() < 0.5 else -1)
        changed = state.moved(int(rng.integers(len(spans))), step, bool(rng.uniform() < 0.5))
        now = state.cost
        before = state.apply(changed) if changed else None
        if before is None:
            continue
        worse = (state.cost - now) / now
        if worse >= 0 and not (annealing and rng.uniform() < np.exp(-worse / (_HEAT * left))):
            state.undo(before)
        elif state.cost < least:
            best, least = state.clustering(), state.cost
    return best
