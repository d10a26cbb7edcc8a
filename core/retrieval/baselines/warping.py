"""Distances of whole motions by dynamic programming: time warping and edit distance, for all pairs of clips."""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

import numpy as np

from core.arrays import Float32Array, Int64Array
from core.compiled import njit
from core.progress import Report


def warping_distance(a: np.ndarray, b: np.ndarray) -> float:
    """Mean cost of a pair on the cheapest warping path between ``(n, d)`` and ``(m, d)``, ends beside ends.

    Steps go on by one in either or both; Euclidean distances are summed and divided by ``n + m``, a diagonal step
    counting twice (the symmetric form of Sakoe and Chiba 1978). Raises ValueError for empty or unlike sequences.
    """
    a, b = _checked(a, b)
    return float(_warping(a, b))


def edit_distance(a: np.ndarray, b: np.ndarray, prices: np.ndarray, gap: float) -> float:
    """Edit distance of two lists of symbols ``(n,)`` and ``(m,)`` over the longer one's length.

    prices: ``(k, k)`` of putting one symbol for another; gap: of leaving one out. Raises ValueError for empty lists.
    """
    if len(a) == 0 or len(b) == 0:
        raise ValueError("there is nothing to compare in an empty list")
    return float(_edit(np.asarray(a, np.int64), np.asarray(b, np.int64), np.asarray(prices, np.float32), gap))


def all_warping_distances(values: np.ndarray, starts: np.ndarray, report: Report) -> np.ndarray:
    """:func:`warping_distance` of all pairs of clips ``values[starts[i]:starts[i + 1]]``: ``(n, n)``."""
    values = np.ascontiguousarray(values, np.float32)
    clips = [values[i:j] for i, j in pairwise(starts)]
    return _pairs(len(clips), lambda i, j: _warping(clips[i], clips[j]), report)


def all_edit_distances(
    symbols: np.ndarray, starts: np.ndarray, prices: np.ndarray, gap: float, report: Report
) -> np.ndarray:
    """:func:`edit_distance` of all pairs of lists ``symbols[starts[i]:starts[i + 1]]``: ``(n, n)``."""
    symbols, prices = np.ascontiguousarray(symbols, np.int64), np.ascontiguousarray(prices, np.float32)
    lists = [symbols[i:j] for i, j in pairwise(starts)]
    return _pairs(len(lists), lambda i, j: _edit(lists[i], lists[j], prices, gap), report)


def _pairs(n: int, distance: Callable[[int, int], float], report: Report) -> np.ndarray:
    distances = np.zeros((n, n))
    for i in range(n):
        for j in range(i + 1, n):
            distances[i, j] = distances[j, i] = distance(i, j)
        report("comparing clips", (i + 1) / n)
    return distances


def _checked(a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    a, b = (np.ascontiguousarray(np.atleast_2d(x), np.float32) for x in (a, b))
    if len(a) == 0 or len(b) == 0 or a.shape[1] != b.shape[1]:
        raise ValueError(f"cannot compare sequences of shapes {a.shape} and {b.shape}")
    return a, b


@njit(nogil=True)
def _warping(a: Float32Array, b: Float32Array) -> float:
    n, m = len(a), len(b)
    row = np.full(m + 1, np.inf)
    row[0] = 0.0
    for i in range(n):
        diagonal = row[0]
        row[0] = np.inf
        for j in range(m):
            distance = np.float32(0)
            for k in range(a.shape[1]):
                apart = a[i, k] - b[j, k]
                distance += apart * apart
            cost = np.sqrt(distance)
            above = row[j + 1]
            row[j + 1] = min(min(above, row[j]) + cost, diagonal + 2 * cost)
            diagonal = above
    mean: float = row[m] / (n + m)
    return mean


@njit(nogil=True)
def _edit(a: Int64Array, b: Int64Array, prices: Float32Array, gap: float) -> float:
    n, m = len(a), len(b)
    row = np.arange(m + 1) * gap
    for i in range(n):
        diagonal = row[0]
        row[0] = (i + 1) * gap
        for j in range(m):
            above = row[j + 1]
            row[j + 1] = min(diagonal + prices[a[i], b[j]], min(above, row[j]) + gap)
            diagonal = above
    share: float = row[m] / max(n, m)
    return share
