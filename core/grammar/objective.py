"""The objective of SYN section 4.1: F(C) = 1 / (w R + (1 - w) E')."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.grammar.pose_space import PoseSpace
from core.grammar.segment_distance import segment_distances


@dataclass(frozen=True, eq=False)
class Clustering:
    """A segmentation and its groups, in poses of a :class:`core.grammar.pose_space.PoseSpace`.

    spans: ``(n, 2)`` half-open, in order; medoids: ``(k,)`` indices of spans; labels: ``(n,)`` the group of each span,
    an index of medoids; distances: ``(n,)`` to the own medoid.
    """

    spans: np.ndarray
    medoids: np.ndarray
    labels: np.ndarray
    distances: np.ndarray

    @property
    def lengths(self) -> np.ndarray:
        """Poses of each span, ``(n,)``."""
        lengths: np.ndarray = self.spans[:, 1] - self.spans[:, 0]
        return lengths

    def objective(self, space: PoseSpace, weight: float) -> dict[str, float]:
        """``F``, ``R`` and ``E`` (the paper's E', from 0 to 1). F is infinite where there is nothing to lower."""
        repetition = float(self.lengths[self.medoids].sum() / space.n)
        error = float(self.lengths @ self.distances / space.n / space.largest)
        cost = weight * repetition + (1 - weight) * error
        return {"F": 1 / cost if cost > 0 else float("inf"), "R": repetition, "E": error}


def span_distances(space: PoseSpace, a: np.ndarray, b: np.ndarray | None = None) -> np.ndarray:
    """Distances ``(n_a, n_b)`` of spans, or among ``a`` alone; the smaller one of both images where these are the same.

    a, b: ``(n, 2)`` half-open intervals of poses.
    """
    distances = segment_distances(space.values, a, b)
    if space.mirrored is not None:
        np.minimum(distances, segment_distances(space.values, a, b, space.mirrored), out=distances)
    return distances


def clustering_of(spans: np.ndarray, medoids: np.ndarray, to_medoids: np.ndarray) -> Clustering:
    """Every span in the group of its nearest medoid.

    medoids: ``(k,)`` indices of spans; to_medoids: ``(n, k)`` distances of the spans to them.
    """
    to_medoids = to_medoids.copy()
    to_medoids[medoids, np.arange(len(medoids))] = -1  # a medoid is its own, even where another is a copy of it
    labels = to_medoids.argmin(1)
    return Clustering(spans, medoids, labels, np.maximum(to_medoids[np.arange(len(spans)), labels], 0))
