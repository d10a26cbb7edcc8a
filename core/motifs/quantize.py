"""Vector quantisation of poses into letters (MMG section 3.2): a start on a sample of the poses, then Lloyd.

The start is either k-means++ (random) or a division of the poses that uses no random number (split), so that the same
motion always gives the same letters.
"""

from __future__ import annotations

import heapq
from typing import NamedTuple

import faiss
import numpy as np

from core.arrays import Float32Array, Float64Array, Int64Array
from core.compiled import njit
from core.motifs.adjacency import centre_distances
from core.progress import Report, silent
from core.sequences.ordering import ascending

STARTS = ("split", "random")


class Letters(NamedTuple):
    """A quantised set of poses.

    centres: ``(kappa, d)`` float32; labels: ``(n,)`` int32 letter of each pose; distances: ``(n,)`` float32 from a
    pose to the centre of its letter.
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
    start: str = "random",
    iterations: int = 25,
    sample: int = 20_000,
    tolerance: float = 1e-4,
    report: Report = silent,
) -> Letters:
    """Cluster poses ``(n, d)`` into at most ``kappa`` letters; same seed, same letters. Centres nobody uses are
    dropped.

    start: "random" = k-means++, "split" = :func:`split_start`, whatever the seed; on at most ``sample`` poses. Then
    Lloyd on all until the inertia falls by less than ``tolerance`` of itself.
    Exact, but by the triangle inequality a pose is compared only with centres nearer to its own centre than twice its
    distance: about ten instead of all. Raises ValueError where kappa is below 1 or there is no pose.
    """
    x = np.ascontiguousarray(poses, np.float32)
    if start not in STARTS:
        raise ValueError(f"start must be one of {', '.join(STARTS)}, not {start!r}")
    if kappa < 1 or len(x) == 0:
        raise ValueError(f"k-means needs at least one cluster and one pose, not kappa = {kappa} and {len(x)} poses")
    rng = np.random.default_rng(seed)
    report("quantisation", 0.0)
    if start == "split":
        centres = split_start(x[np.linspace(0, len(x) - 1, min(len(x), sample)).astype(np.int64)], kappa)
    else:
        part = x if len(x) <= sample else x[np.sort(rng.choice(len(x), sample, replace=False))]
        centres = _plus_plus(part, min(kappa, len(part)), rng.random(min(kappa, len(part))))
    labels = _nearest(x, centres)
    inertia = np.inf
    for i in range(iterations):
        report("quantisation", (i + 1) / (iterations + 1))
        centres = _means(x, labels, centres)
        order = np.argsort(labels, kind="stable")
        first = np.searchsorted(labels[order], np.arange(len(centres) + 1))
        squares = _reassign(x, centres, centre_distances(centres), labels, order, first)
        if (before := inertia) - (inertia := float(squares.sum(dtype=np.float64))) <= tolerance * before < np.inf:
            break
    used, labels = np.unique(labels, return_inverse=True)
    report("quantisation", 1.0)
    return Letters(centres[used], labels.astype(np.int32), np.sqrt(squares))


def split_start(x: np.ndarray, kappa: int) -> np.ndarray:
    """Centres ``(k, d)`` float32, at most ``kappa``, for poses ``(n, d)``: principal direction divisive partitioning.

    The group with the largest sum of squared distances from its mean is divided at its mean, across the direction in
    which it is widest, until there are so many groups or all poses of each are the same (Boley 1998; as a start of
    k-means: Su and Dy 2007). The centres are their means. No random number is used.
    """
    groups = [(-_spread(x), 0, np.arange(len(x)))]
    count = 1
    done: list[np.ndarray] = []
    while groups and len(groups) + len(done) < kappa:
        spread, _, members = heapq.heappop(groups)
        across = _widest(x[members])
        left, right = members[across <= 0], members[across > 0]
        if spread >= 0 or not len(left) or not len(right):
            done.append(members)
            continue
        for part in (left, right):
            heapq.heappush(groups, (-_spread(x[part]), count, part))
            count += 1
    everything = [*done, *(members for _, _, members in sorted(groups, key=lambda group: group[1]))]
    return np.array([x[members].mean(0, dtype=np.float64) for members in everything], np.float32)


def _spread(x: np.ndarray) -> float:
    """Sum of squared distances from the mean."""
    return float(x.var(0, dtype=np.float64).sum() * len(x))


def _widest(x: np.ndarray) -> np.ndarray:
    """Where poses ``(n, d)`` lie along the direction in which they differ most, ``(n,)``, from their mean.

    Its sign is that of its largest entry, so that it does not depend on the library that computes it.
    """
    apart = x.astype(np.float64) - x.mean(0, dtype=np.float64)
    direction = np.linalg.eigh(apart.T @ apart)[1][:, -1]
    along: np.ndarray = apart @ (direction * np.sign(direction[np.abs(direction).argmax()]))
    return along


@njit(nogil=True)
def _plus_plus(x: Float32Array, kappa: int, draws: Float64Array) -> Float32Array:
    """k-means++ seeding: the next centre is drawn with probability proportional to the squared distance to the others.

    A pose less than half as far from its centre as that is from the new one keeps it, unseen: scikit-learn's
    kmeans_plusplus, without this rule, takes about twenty times as long.
    """
    n = len(x)
    centres = np.empty((kappa, x.shape[1]), np.float32)
    nearest, owner = np.full(n, np.inf, np.float32), np.zeros(n, np.int64)
    between = np.zeros(kappa, np.float32)
    pick, n_chosen = min(int(draws[0] * n), n - 1), 0
    while n_chosen < kappa:
        for k in range(x.shape[1]):
            centres[n_chosen, k] = x[pick, k]
        for c in range(n_chosen):
            between[c] = _square(centres[c], x[pick]) * np.float32(0.25)
        total = 0.0
        for i in range(n):
            if n_chosen == 0 or nearest[i] > between[owner[i]] * np.float32(0.9999):
                square = _square(x[i], x[pick])
                if square < nearest[i]:
                    nearest[i], owner[i] = square, n_chosen
            total += nearest[i]
        n_chosen += 1
        if n_chosen == kappa or total <= 0:
            break
        target, pick, passed = draws[n_chosen] * total, -1, 0.0
        for i in range(n):
            passed += nearest[i]
            if nearest[i] > 0:
                pick = i
                if passed > target:
                    break
    return centres[:n_chosen]


@njit(nogil=True)
def _square(a: Float32Array, b: Float32Array) -> np.float32:
    total = np.float32(0)
    for k in range(len(a)):
        total += (a[k] - b[k]) * (a[k] - b[k])
    return total


def _nearest(x: np.ndarray, centres: np.ndarray) -> np.ndarray:
    nearest: np.ndarray = faiss.knn(x, centres, 1)[1][:, 0]
    return nearest.astype(np.int64)


@njit(nogil=True)
def _reassign(
    x: Float32Array,
    centres: Float32Array,
    between: Float32Array,
    labels: Int64Array,
    order: Int64Array,
    first: Int64Array,
) -> Float32Array:
    """Move each pose to its nearest centre, in place in ``labels``; the squared distances.

    order: poses by label; first: (kappa + 1,) where each label's poses begin in it.
    Centres are tried by their distance from the pose's present one; beyond twice the best distance none can be nearer.
    """
    squares = np.empty(len(x), np.float32)
    for a in range(len(centres)):
        members = order[first[a] : first[a + 1]]
        if len(members) == 0:
            continue
        furthest = np.float32(0)
        for i in members:
            squares[i] = _square(x[i], centres[a])
            furthest = max(furthest, squares[i])
        near, n = np.empty(len(centres), np.int64), 0
        for c in range(len(centres)):
            if between[a, c] * np.float32(0.9999) <= 2 * np.sqrt(furthest):
                near[n] = c
                n += 1
        near = near[:n]
        near = near[ascending(between[a][near])]
        for i in members:
            for c in near:
                if between[a, c] * np.float32(0.9999) > 2 * np.sqrt(squares[i]):
                    break
                square = _square(x[i], centres[c])
                if square < squares[i]:
                    squares[i], labels[i] = square, c
    return squares


@njit(nogil=True)
def _means(x: Float32Array, labels: Int64Array, centres: Float32Array) -> Float32Array:
    """Mean pose of each cluster; a cluster without poses keeps its centre."""
    total, count = np.zeros(centres.shape), np.zeros(len(centres))
    for i in range(len(x)):
        count[labels[i]] += 1
        for k in range(x.shape[1]):
            total[labels[i], k] += x[i, k]
    new = centres.copy()
    for c in range(len(centres)):
        for k in range(x.shape[1]):
            if count[c] > 0:
                new[c, k] = total[c, k] / count[c]
    return new
