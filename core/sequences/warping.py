"""Dynamic time warping of two sequences of vectors."""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array, Int64Array, UInt8Array
from core.compiled import njit


def warp_path(a: np.ndarray, b: np.ndarray, band: float | None = None) -> np.ndarray:
    """Cheapest alignment of ``a`` (n, d) with ``b`` (m, d): pairs of indices ``(k, 2)``, from (0, 0) to (n - 1, m - 1).

    Cost: sum of Euclidean distances; steps advance one or both sequences by one; ties go to the diagonal.
    band: how far, as a share of the longer sequence, the path may leave the straight line (Sakoe-Chiba); None:
    anywhere. Raises ValueError for empty sequences, unlike dimensions or a band outside 0 to 1.
    """
    a, b = np.atleast_2d(np.asarray(a, np.float32)), np.atleast_2d(np.asarray(b, np.float32))
    if len(a) == 0 or len(b) == 0 or a.shape[1] != b.shape[1]:
        raise ValueError(f"cannot align sequences of shapes {a.shape} and {b.shape}")
    if band is not None and not 0 <= band <= 1:
        raise ValueError(f"band must be between 0 and 1, not {band}")
    # the straight line moves max(1, m / n) columns a row: a narrower band would cut it
    reach = max(len(a), len(b)) if band is None else max(band * max(len(a), len(b)), 1, len(b) / len(a))
    return _trace(_steps(a, b, float(reach)))


def registration(path: np.ndarray, n: int) -> np.ndarray:
    """For each of the ``n`` frames of the first sequence its mean partner in the second: ``(n,)`` float64.

    path: ``(k, 2)`` from :func:`warp_path`; the result never decreases.
    """
    total, count = np.zeros(n), np.zeros(n)
    np.add.at(total, path[:, 0], path[:, 1])
    np.add.at(count, path[:, 0], 1)
    return total / np.maximum(count, 1)


@njit(nogil=True)
def _steps(a: Float32Array, b: Float32Array, reach: float) -> UInt8Array:
    """Last step of the best path into each cell: 0 both, 1 first sequence only, 2 second only."""
    n, m = len(a), len(b)
    steps = np.zeros((n, m), np.uint8)
    before, here = np.full(m + 1, np.inf), np.full(m + 1, np.inf)
    before[0] = 0.0
    for i in range(n):
        line = i * (m - 1) / max(n - 1, 1)
        low, high = max(0, int(np.ceil(line - reach))), min(m, int(line + reach) + 1)
        here[:] = np.inf
        for j in range(low, high):
            distance = 0.0
            for k in range(a.shape[1]):
                distance += (a[i, k] - b[j, k]) ** 2
            best = before[j]
            if before[j + 1] < best:
                best, steps[i, j] = before[j + 1], 1
            if here[j] < best:
                best, steps[i, j] = here[j], 2
            here[j + 1] = best + np.sqrt(distance)
        before, here = here, before
    return steps


@njit(nogil=True)
def _trace(steps: UInt8Array) -> Int64Array:
    i, j = steps.shape[0] - 1, steps.shape[1] - 1
    path = np.empty((i + j + 1, 2), np.int64)
    k = len(path)
    while True:
        k -= 1
        path[k, 0], path[k, 1] = i, j
        if i == 0 and j == 0:
            return path[k:]
        if steps[i, j] == 0:
            i, j = i - 1, j - 1
        elif steps[i, j] == 1:
            i -= 1
        else:
            j -= 1
