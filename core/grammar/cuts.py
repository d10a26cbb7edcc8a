"""The best segmentation for given medoids: an exact dynamic programme over cuts.

E' of SYN section 4.1 is a sum over segments, so for fixed medoids the segmentation that minimises it is a shortest path
from a clip's first frame to its last. Pose distances to all frames of all medoids come from one matrix product; the
distance of a candidate to a medoid then is a sum of entries of that table.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.arrays import Float32Array, Int32Array, Int64Array
from core.compiled import njit

_BLOCK = 1024  # poses looked at together: their distances to the frames of one medoid stay in the cache


def pose_distances(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Squared Euclidean distances ``(n, m)`` float32 between poses ``(n, d)`` and ``(m, d)``."""
    # one product gives |x|^2 - 2 xy + |y|^2, each square beside a column of ones
    left = np.column_stack([-2 * x, np.einsum("nd,nd->n", x, x), np.ones(len(x), x.dtype)])
    right = np.column_stack([y, np.ones(len(y), y.dtype), np.einsum("md,md->m", y, y)])
    squared: np.ndarray = (left @ right.T).astype(np.float32, copy=False)
    np.maximum(squared, 0, out=squared)
    return squared


def best_cuts(
    x: np.ndarray, medoids: Sequence[np.ndarray], shortest: int, longest: int, price: float = 0.0
) -> tuple[np.ndarray, np.ndarray, float]:
    """Cuts ``(m + 1,)``, the medoid of each of the m segments ``(m,)``, and what they cost.

    x: poses of one clip ``(n, d)``; medoids: each ``(n_k, d)``. A segment costs its length times its distance to the
    nearest medoid, plus ``price``. Segments are ``shortest`` to ``longest`` poses long; where a clip cannot be cut like
    that, as it is too short, it stays whole. Raises ValueError where there are no poses or no medoids, or unless
    1 <= shortest <= longest.
    """
    if not len(x) or not medoids:
        raise ValueError("there must be poses and medoids")
    if not 1 <= shortest <= longest:
        raise ValueError(f"segments cannot be {shortest} to {longest} poses long")
    costs, nearest = candidate_costs(x, medoids, shortest, longest)
    cuts, total = _shortest_path(costs, shortest, float(price))
    if not len(cuts):
        whole = candidate_costs(x, medoids, len(x), len(x))
        return np.array([0, len(x)]), whole[1][:1, 0].astype(np.int64), float(whole[0][0, 0]) + price
    return cuts, nearest[np.diff(cuts) - shortest, cuts[:-1]].astype(np.int64), float(total)


def candidate_costs(
    x: np.ndarray, medoids: Sequence[np.ndarray], shortest: int, longest: int
) -> tuple[np.ndarray, np.ndarray]:
    """What each candidate costs, and its nearest medoid: ``(longest - shortest + 1, n)``, row: length, column: start.

    Arguments as of :func:`best_cuts`. Infinite where a candidate would reach beyond the end.
    """
    n, width = len(x), longest - shortest + 1
    costs, nearest = np.full((width, n), np.inf, np.float32), np.full((width, n), -1, np.int32)
    lengths = np.array([len(m) for m in medoids], np.int64)
    frames = np.ascontiguousarray(np.concatenate(medoids), np.float32)
    for start in range(0, n, _BLOCK):
        stop = min(start + _BLOCK, n)
        table = pose_distances(frames, np.asarray(x[start : min(stop + longest, n)], np.float32))
        _costs(table, lengths, shortest, costs[:, start:stop], nearest[:, start:stop])
    return costs, nearest


@njit(fastmath={"reassoc", "contract", "nsz"}, nogil=True)
def _costs(table: Float32Array, lengths: Int64Array, shortest: int, costs: Float32Array, nearest: Int32Array) -> None:
    """table: distances of the frames of all medoids, one medoid after the other (rows), to poses (columns).

    All starts go side by side, since what they add up for one medoid and one length lies side by side too, and four
    frames at a time, so that the totals are fetched and kept a quarter as often.
    """
    n, first = table.shape[1], 0
    totals = np.empty(costs.shape[1], np.float32)
    most = max(shortest + len(costs) - 1, lengths.max())
    rows, shifts = np.empty(most, np.int64), np.empty(most, np.int64)
    for k in range(len(lengths)):
        own = lengths[k]
        for c in range(len(costs)):
            length = shortest + c
            starts = min(costs.shape[1], n - length + 1)
            if starts <= 0:
                break
            longer = max(length, own)
            for m in range(longer):  # floor(m l' / l) of the longer and the shorter
                rows[m] = first + (m * own // length if length >= own else m)
                shifts[m] = m if length >= own else m * length // own
            totals[:starts] = 0
            whole = longer - longer % 4
            for m in range(0, whole, 4):
                line0, line1 = table[rows[m], shifts[m] :], table[rows[m + 1], shifts[m + 1] :]
                line2, line3 = table[rows[m + 2], shifts[m + 2] :], table[rows[m + 3], shifts[m + 3] :]
                for s in range(starts):
                    totals[s] += (line0[s] + line1[s]) + (line2[s] + line3[s])
            for m in range(whole, longer):
                line = table[rows[m], shifts[m] :]
                for s in range(starts):
                    totals[s] += line[s]
            share = np.float32(length) / np.float32(longer)
            for s in range(starts):
                if totals[s] * share < costs[c, s]:
                    costs[c, s] = totals[s] * share
                    nearest[c, s] = k
        first += own


@njit(nogil=True)
def _shortest_path(costs: Float32Array, shortest: int, price: float) -> tuple[Int64Array, float]:
    width, n = costs.shape
    best, back = np.full(n + 1, np.inf), np.full(n + 1, -1, np.int64)
    best[0] = 0.0
    for s in range(n):
        if best[s] == np.inf:
            continue
        for c in range(min(width, n - s - shortest + 1)):
            cost = best[s] + costs[c, s] + price
            if cost < best[s + shortest + c]:
                best[s + shortest + c], back[s + shortest + c] = cost, s
    if best[n] == np.inf:
        return np.empty(0, np.int64), float(best[n])
    count, at = 1, n
    while at > 0:
        at = back[at]
        count += 1
    cuts = np.empty(count, np.int64)
    at = n
    for i in range(count - 1, -1, -1):
        cuts[i] = at
        at = back[at]
    return cuts, float(best[n])
