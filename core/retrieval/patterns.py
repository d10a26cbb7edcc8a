"""Motion patterns of one part of the body: adaptive k-means, library, dissimilarity map (PCR section 3.3)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import faiss
import numpy as np
from scipy.spatial import cKDTree

FIRST_K = 10
"""Clusters that adaptive k-means begins with (PCR section 3.3)."""

_GROWTH = 0.5  # new clusters a round, as a share of those that are there
_ROUNDS = 5  # steps of k-means between two looks at the error
_REFILLED = 20  # times at most that room is made so
_PERCENTILES = 1000
_SAMPLED = 4000  # segments whose distances say what is near and what is far


@dataclass(frozen=True, eq=False)
class PatternLibrary:
    """The patterns of one part.

    patterns: ``(k, length * d)`` float32, means of the segments in each cluster. scale: quantiles ``(1001,)`` float32
    of the distance between the patterns of two segments, 0 to 100 %, each pattern as often as it occurs.
    """

    patterns: np.ndarray
    scale: np.ndarray

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.patterns)

    def nearest(self, segments: np.ndarray) -> np.ndarray:
        """Index ``(n,)`` int32 of the pattern nearest to each segment ``(n, length * d)``, by the KD-tree."""
        if len(segments) == 0:
            return np.zeros(0, np.int32)
        return np.asarray(self._tree.query(np.asarray(segments, np.float64))[1], np.int32)

    def assign(self, segments: np.ndarray) -> np.ndarray:
        """As :meth:`nearest` for very many segments ``(n, length * d)``: all distances at once beat the tree."""
        return _assign(np.ascontiguousarray(segments, np.float32), self.patterns)[0].astype(np.int32)

    @cached_property
    def distances(self) -> np.ndarray:
        """The dissimilarity map: Euclidean distances of all pairs of patterns, ``(k, k)`` float32."""
        distances_between = distances(self.patterns, self.patterns)
        np.fill_diagonal(distances_between, 0)
        return distances_between

    @cached_property
    def by_maximum(self) -> np.ndarray:
        """The dissimilarity map ``(k, k)`` float32 as the printed algorithm needs it: 1 is the greatest distance."""
        return self.distances / max(float(self.distances.max()), 1e-12)

    @cached_property
    def by_percentile(self) -> np.ndarray:
        """The dissimilarity map ``(k, k)`` float32 in shares: how many pairs of segments are nearer than this pair."""
        return self.percentile(self.distances)

    def percentile(self, distance: np.ndarray) -> np.ndarray:
        """Share, 0 to 1, of pairs of segments that are nearer than a distance ``(...)``: float32 of that shape."""
        shares = np.interp(distance, self.scale, np.linspace(0, 1, len(self.scale)))
        return np.where(np.asarray(distance) <= 0, 0, shares).astype(np.float32)


def build_library(
    segments: np.ndarray, *, max_error: float, most: int, seed: int = 0, first_k: int = FIRST_K
) -> tuple[PatternLibrary, np.ndarray]:
    """The library of the normalised segments ``(n, length * d)`` of a part, and their pattern indices ``(n,)`` int32.

    Parameters and errors as :func:`adaptive_k_means`.
    """
    centres, labels = adaptive_k_means(segments, max_error=max_error, most=most, seed=seed, first_k=first_k)
    generator = np.random.default_rng(seed)
    a, b = (centres[labels[generator.integers(len(labels), size=_SAMPLED)]] for _ in range(2))
    apart = np.linalg.norm(a - b, axis=1)
    return PatternLibrary(centres, np.quantile(apart, np.linspace(0, 1, _PERCENTILES + 1)).astype(np.float32)), labels


def adaptive_k_means(
    segments: np.ndarray, *, max_error: float, most: int, seed: int = 0, first_k: int = FIRST_K
) -> tuple[np.ndarray, np.ndarray]:
    """Clusters of segments ``(n, d)``: centres ``(k, d)`` float32 and the cluster of each segment ``(n,)`` int32.

    k grows from ``first_k`` until no segment is farther from its centre than ``max_error`` times the root mean square
    distance of the segments to their mean (the paper's maximum error metric), or k is ``most``. New centres are the
    segments that fit worst, one a cluster. Deterministic. Raises ValueError for no segments, an error below 0 or
    fewer than one cluster.
    """
    segments = np.ascontiguousarray(segments, np.float32)
    if len(segments) == 0 or not max_error >= 0 or most < 1 or first_k < 1:
        raise ValueError("adaptive k-means needs segments, an error of at least 0 and at least one cluster")
    spread = float(np.sqrt(((segments - segments.mean(0)) ** 2).sum(1, dtype=np.float64).mean()))
    limit = max_error * spread
    generator = np.random.default_rng(seed)
    centres = segments[np.sort(generator.permutation(len(segments))[: min(first_k, most)])].copy()
    refilled = 0  # times that patterns without segments made room for others
    while True:
        for _ in range(_ROUNDS):
            labels, _ = _assign(segments, centres)
            centres = _means(segments, labels, centres)
        labels, errors = _assign(segments, centres)
        if errors.max() <= limit:
            break
        if len(centres) >= min(most, len(segments)):
            used = np.unique(labels)
            if len(used) == len(centres) or refilled == _REFILLED:
                break
            centres, refilled = centres[used], refilled + 1
            labels, errors = _assign(segments, centres)
        worst = np.argsort(-errors, kind="stable")[: max(1, int(_GROWTH * len(centres)))]
        worst = worst[errors[worst] > limit]
        worst = np.sort(worst[np.unique(labels[worst], return_index=True)[1]])
        centres = np.concatenate([centres, segments[worst]])[:most]
    used, labels = np.unique(labels, return_inverse=True)
    return centres[used], labels.astype(np.int32)


def distances(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Euclidean distances of rows ``(n, d)`` and ``(m, d)``: ``(n, m)`` float32; equal rows may be just above 0."""
    a, b = np.ascontiguousarray(a, np.float32), np.ascontiguousarray(b, np.float32)
    apart: np.ndarray = np.sqrt(np.maximum(faiss.pairwise_distances(a, b), 0))
    return apart


def _assign(x: np.ndarray, centres: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    squared, nearest = faiss.knn(x, centres, 1)
    return nearest[:, 0], np.sqrt(np.maximum(squared[:, 0], 0))


def _means(x: np.ndarray, labels: np.ndarray, centres: np.ndarray) -> np.ndarray:
    order = np.argsort(labels, kind="stable")
    used, first = np.unique(labels[order], return_index=True)
    new = centres.copy()
    new[used] = np.add.reduceat(x[order], first, axis=0) / np.bincount(labels)[used, None]
    return new
