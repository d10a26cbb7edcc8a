"""Edit distance of real-valued sequences with a bounded price of a replacement (edit distance on real sequences)."""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array
from core.compiled import njit


def bounded_edit_distances(
    a: np.ndarray, many: np.ndarray, cap: float, gap: float, band: int | None = None
) -> np.ndarray:
    """Distance of ``a`` (n, d) to each of ``many`` (k, m, d), ``(k,)`` float32, per sample of the longer sequence.

    Replacing a sample costs ``min(1, |x - y| / cap)``, leaving one out ``gap``. band: how far sample i may be from
    sample j; None: anywhere; it is widened where the lengths differ by more. A result lies between 0 and
    ``min(1, 2 gap)`` for equal lengths. Raises ValueError for empty sequences, unlike dimensions, or a cap or gap that
    is not positive.
    """
    a, many = np.ascontiguousarray(a, np.float32), np.ascontiguousarray(many, np.float32)
    if a.ndim != 2 or many.ndim != 3 or a.shape[1] != many.shape[2] or len(a) == 0 or many.shape[1] == 0:
        raise ValueError(f"cannot compare sequences of shapes {a.shape} and {many.shape}")
    if not cap > 0 or not gap > 0 or (band is not None and band < 0):
        raise ValueError("cap and gap must be positive, the band at least 0")
    n, m = len(a), many.shape[1]
    reach = max(n, m) if band is None else max(band, abs(n - m))
    return _distances(a, many, np.float32(cap), np.float32(gap), reach)


@njit(nogil=True, fastmath=True)
def _distances(a: Float32Array, many: Float32Array, cap: np.float32, gap: np.float32, reach: int) -> Float32Array:
    n, (k, m, d) = len(a), many.shape
    distances = np.empty(k, np.float32)
    turned = np.empty((d, m), np.float32)  # samples side by side: a row of costs at a time, without sums across
    row, price = np.empty(m + 1, np.float32), np.empty(m, np.float32)
    far, scale = np.float32(1e9), np.float32(1.0) / cap
    for c in range(k):
        for j in range(m):
            for e in range(d):
                turned[e, j] = many[c, j, e]
        for j in range(m + 1):
            row[j] = np.float32(j) * gap if j <= reach else far
        for i in range(n):
            low, high = max(0, i - reach), min(m, i + reach + 1)
            here = price[: high - low]  # slices: counting from zero, the compiler makes vectors of the loops
            for j in range(high - low):
                here[j] = np.float32(0.0)
            for e in range(d):
                mine, theirs = a[i, e], turned[e, low:high]
                for j in range(high - low):
                    apart = mine - theirs[j]
                    here[j] += apart * apart
            for j in range(high - low):
                here[j] = min(np.float32(1.0), np.sqrt(here[j]) * scale)
            diagonal, left = row[low], np.float32(i + 1) * gap if i + 1 <= reach else far
            row[low] = left
            for j in range(low, high):
                above = row[j + 1]
                left = min(diagonal + here[j - low], min(above, left) + gap)
                row[j + 1] = left
                diagonal = above
            if high < m:
                row[high + 1] = far
        distances[c] = row[m] / max(n, m)
    return distances
