"""Sorting inside jitted kernels: numba's own sorts take seconds to compile wherever they are used; this does not."""

from __future__ import annotations

import numpy as np

from core.compiled import njit


@njit(nogil=True)
def ascending(values: np.ndarray) -> np.ndarray:
    """Indices ``(n,)`` int64 that sort ``values`` ``(n,)``; equal values keep their order. Bottom-up merge sort."""
    n = len(values)
    order, other = np.empty(n, np.int64), np.empty(n, np.int64)
    for i in range(n):
        order[i] = i
    width = 1
    while width < n:
        for low in range(0, n, 2 * width):
            a, b = low, min(low + width, n)
            middle, high = b, min(low + 2 * width, n)
            for k in range(low, high):
                if a < middle and (b >= high or values[order[a]] <= values[order[b]]):
                    other[k] = order[a]
                    a += 1
                else:
                    other[k] = order[b]
                    b += 1
        order, other = other, order
        width *= 2
    return order
