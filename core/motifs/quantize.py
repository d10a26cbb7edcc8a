"""Vector quantisation of poses into letters (MMG section 3.2): k-means++ on a sample, then Lloyd."""

from __future__ import annotations

from typing import NamedTuple

import faiss
import numpy as np
from numba import njit, prange

from core.progress import Report, silent


class Letters(NamedTuple):
    """A quantised set of poses.

    centres: ``(kappa, d)`` float32; labels: ``(n,)`` int32 letter of each pose; distances: ``(n,)`` float32 from a pose to
    the centre of its letter.
    """

    centres: np.ndarray
    labels: np.ndarray
    distances: np.ndarray


def automatic_kappa(poses: np.ndarray, fps: float = 30) -> int:
    """Our rule for the number of letters, where the paper chooses by hand: 50 sqrt(variety), for poses ``(n, d)``.

    variety: length of the path through pose space, over the mean distance to the average pose; seen ten times a second,
    so that neither frame rate nor noise nor standing still raises it. The factor gave the best agreement with labelled
    exercises (anything from half to twice as many letters does nearly as well). Between 2 and 4000, and no more than a
    quarter of the frames, so that a letter is a kind of pose and not a frame.
    """
    if len(poses) < 8:
        return 2
    sparse = poses[:: max(1, round(fps / 10))].astype(np.float64)
    length = np.linalg.norm(np.diff(sparse, axis=0), axis=1).sum()
    spread = np.linalg.norm(poses - poses.mean(0), axis=1).mean()
    kappa = 50 * np.sqrt(length / spread) if spread > 0 else 2
    return int(np.clip(round(kappa), 2, min(4000, len(poses) // 4)))


def k_means(
    poses: np.ndarray,
    kappa: int,
    seed: int = 0,
    *,
    iterations: int = 25,
    sample: int = 20_000,
    tolerance: float = 1e-4,
    report: Report = silent,
) -> Letters:
    """Cluster poses ``(n, d)`` into at most ``kappa`` letters; same seed, same letters. Centres nobody uses are dropped.

    k-means++ seeds on at most ``sample`` poses, then Lloyd on all until the inertia falls by less than ``tolerance`` of
    itself. Raises ValueError where kappa is below 1 or there is no pose.
    """
    x = np.ascontiguousarray(poses, np.float32)
    if kappa < 1 or len(x) == 0:
        raise ValueError(f"k-means needs at least one cluster and one pose, not kappa = {kappa} and {len(x)} poses")
    rng = np.random.default_rng(seed)
    part = x if len(x) <= sample else x[np.sort(rng.choice(len(x), sample, replace=False))]
    centres = _plus_plus(part, min(kappa, len(part)), rng.random(min(kappa, len(part))))
    inertia = np.inf
    for i in range(iterations):
        squares, labels = _nearest(x, centres)
        centres = _means(x, labels, centres)
        report("quantisation", (i + 1) / iterations)
        if (before := inertia) - (inertia := float(squares.sum(dtype=np.float64))) <= tolerance * before < np.inf:
            break
    squares, labels = _nearest(x, centres)
    used, labels = np.unique(labels, return_inverse=True)
    report("quantisation", 1.0)
    return Letters(centres[used], labels.astype(np.int32), np.sqrt(np.maximum(squares, 0)))


@njit(cache=True)
def _plus_plus(x, kappa, draws):
    """k-means++ seeding: each next centre is drawn with probability proportional to the squared distance to the others."""
    n, d = x.shape
    centres = np.empty((kappa, d), np.float32)
    nearest = np.full(n, np.inf, np.float32)
    pick, found = int(draws[0] * n), 0
    while found < kappa:
        centres[found] = x[pick]
        found += 1
        total = 0.0
        for i in range(n):
            s = np.float32(0)
            for k in range(d):
                e = x[i, k] - x[pick, k]
                s += e * e
            nearest[i] = min(nearest[i], s)
            total += nearest[i]
        if found == kappa or total <= 0:
            break
        target, pick, s = draws[found] * total, -1, 0.0
        for i in range(n):
            s += nearest[i]
            if nearest[i] > 0:
                pick = i
                if s > target:
                    break
    return centres[:found]


def _nearest(x, centres):
    squares, labels = faiss.knn(x, centres, 1)
    return squares[:, 0], labels[:, 0]


@njit(cache=True)
def _means(x, labels, centres):
    """Mean pose of each cluster; a cluster without poses keeps its centre."""
    total, count = np.zeros(centres.shape), np.zeros(len(centres))
    for i in range(len(x)):
        count[labels[i]] += 1
        for k in range(x.shape[1]):
            total[labels[i], k] += x[i, k]
    new = centres.copy()
    for c in range(len(centres)):
        if count[c] > 0:
            new[c] = (total[c] / count[c]).astype(np.float32)
    return new
