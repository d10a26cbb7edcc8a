"""How far segments are apart: mean pose distance along a uniform time warp (SYN section 4.1, equation 1)."""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array, Int64Array
from core.compiled import njit


def segment_distances(
    x: np.ndarray, a: np.ndarray, b: np.ndarray | None = None, y: np.ndarray | None = None
) -> np.ndarray:
    """Distances ``(n_a, n_b)`` float32 of segments ``a`` to segments ``b``, to one another where b is None.

    x: poses ``(n, d)``, whose squared Euclidean distance is the pose distance; a, b: half-open intervals ``(n, 2)`` of
    rows of x; y: the poses of ``b`` where they are others: the mirror images of x (whose own mirror image is x, so that
    the distances among ``a`` are symmetric). Frame m of the longer of two intervals stands beside frame
    floor(m l' / l) of the shorter. Raises ValueError for an interval out of range.
    """
    a, other = _spans(x, a), x if y is None else y
    second = a if b is None else _spans(other, b)
    x, other = np.ascontiguousarray(x, np.float32), np.ascontiguousarray(other, np.float32)
    return _distances(x, other, a, second, b is None)


def _spans(x: np.ndarray, spans: np.ndarray) -> np.ndarray:
    spans = np.ascontiguousarray(spans, np.int64).reshape(-1, 2)
    if len(spans) and not (spans[:, 0].min() >= 0 and (spans[:, 0] < spans[:, 1]).all() and spans.max() <= len(x)):
        raise ValueError(f"segments must be non-empty intervals of the {len(x)} poses")
    return spans


@njit(fastmath={"reassoc", "contract", "nsz"}, nogil=True)
def _distances(x: Float32Array, y: Float32Array, a: Int64Array, b: Int64Array, symmetric: bool) -> Float32Array:
    d = x.shape[1]
    out = np.empty((len(a), len(b)), np.float32)
    for i in range(len(a)):
        n = a[i, 1] - a[i, 0]
        for j in range(i if symmetric else 0, len(b)):
            k = b[j, 1] - b[j, 0]
            total = np.float32(0)
            longer = max(n, k)
            for m in range(longer):
                p = a[i, 0] + (m if n >= k else m * n // k)
                q = b[j, 0] + (m if k >= n else m * k // n)
                for c in range(d):
                    e = x[p, c] - y[q, c]
                    total += e * e
            out[i, j] = total / np.float32(longer)
            if symmetric:
                out[j, i] = out[i, j]
    return out
