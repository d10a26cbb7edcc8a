"""Weighted k-medoids: swaps that lower the objective itself, in the eager order of FasterPAM.

FasterPAM (Schubert and Rousseeuw, Information Systems 101, 2021) minimises the sum of distances. Here every object has
a weight and every medoid a price, as in the objective of SYN section 4.1, where a segment counts by its length and a
medoid's length is R.
"""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array, Float64Array, Int64Array
from core.compiled import njit


def seed_medoids(distances: np.ndarray, weights: np.ndarray, k: int, rng: np.random.Generator) -> np.ndarray:
    """Indices ``(k,)`` of objects far from one another, drawn as k-means++ draws centres, by weight and distance.

    distances: ``(n, n)``, row: object, column: possible medoid; weights: ``(n,)``. Raises ValueError unless
    1 <= k <= n.
    """
    n = len(weights)
    if not 1 <= k <= n:
        raise ValueError(f"cannot choose {k} medoids among {n} segments")
    chosen = [int(rng.choice(n, p=weights / weights.sum()))]
    nearest = distances[:, chosen[0]].astype(np.float64)
    while len(chosen) < k:
        mass = weights * nearest
        mass[chosen] = 0
        if mass.sum() <= 0:  # only copies are left
            mass = np.ones(n)
            mass[chosen] = 0
        # of a few draws the one that helps most
        drawn = rng.choice(n, 4, p=mass / mass.sum())
        better = np.minimum(nearest[:, None], distances[:, drawn])
        best = int(drawn[(weights @ better).argmin()])
        chosen.append(best)
        nearest = np.minimum(nearest, distances[:, best])
    return np.array(chosen, np.int64)


def swap_medoids(
    distances: np.ndarray, weights: np.ndarray, prices: np.ndarray, medoids: np.ndarray, most: int = 50
) -> np.ndarray:
    """Medoids ``(k,)`` that no single swap with another object improves (or the best after ``most`` passes).

    What is lowered: sum of weights times distance to the nearest medoid, plus the prices of the medoids. distances
    ``(n, n)`` as in :func:`seed_medoids`; weights, prices: ``(n,)``. Raises ValueError where shapes do not agree.
    """
    distances = np.ascontiguousarray(distances, np.float32)
    n = len(distances)
    if distances.shape != (n, n) or len(weights) != n or len(prices) != n:
        raise ValueError(f"expected {n} x {n} distances, {n} weights and {n} prices")
    return _swaps(
        np.ascontiguousarray(distances.T),
        np.asarray(weights, np.float64),
        np.asarray(prices, np.float64),
        np.array(medoids, np.int64),
        most,
    )


@njit(nogil=True)
def _nearest(columns: Float32Array, medoids: Int64Array, first: Int64Array, d1: Float64Array, d2: Float64Array) -> None:
    """Nearest medoid of each object and the distances to it and to the second nearest."""
    for o in range(columns.shape[1]):
        d1[o], d2[o] = np.inf, np.inf
        for i in range(len(medoids)):
            d = columns[medoids[i], o]
            if d < d1[o]:
                d1[o], d2[o], first[o] = d, d1[o], i
            elif d < d2[o]:
                d2[o] = d


@njit(nogil=True)
def _swaps(
    columns: Float32Array, weights: Float64Array, prices: Float64Array, medoids: Int64Array, most: int
) -> Int64Array:
    """columns: the distances transposed, so that the distances to one candidate lie side by side."""
    n, k = columns.shape[1], len(medoids)
    if k < 2:
        return _best_one(columns, weights, prices)
    first, d1, d2 = np.empty(n, np.int64), np.empty(n), np.empty(n)
    is_medoid = np.zeros(n, np.bool_)
    is_medoid[medoids] = True
    _nearest(columns, medoids, first, d1, d2)
    change = np.empty(k)
    since, j = 0, -1
    for _ in range(most * n):
        j = (j + 1) % n
        since += 1
        if since > n:
            break
        if is_medoid[j]:
            continue
        for i in range(k):
            change[i] = -prices[medoids[i]]
        gain = prices[j]
        for o in range(n):
            d = columns[j, o]
            if d < d1[o]:
                gain += weights[o] * (d - d1[o])
            else:
                change[first[o]] += weights[o] * (min(d, d2[o]) - d1[o])
        best = np.argmin(change)
        if gain + change[best] < -1e-12:
            is_medoid[medoids[best]] = False
            is_medoid[j] = True
            medoids[best] = j
            _nearest(columns, medoids, first, d1, d2)
            since = 0
    return medoids


@njit(nogil=True)
def _best_one(columns: Float32Array, weights: Float64Array, prices: Float64Array) -> Int64Array:
    best, least = 0, np.inf
    for j in range(len(columns)):
        cost = prices[j] + (weights * columns[j]).sum()
        if cost < least:
            best, least = j, cost
    return np.array([best])
