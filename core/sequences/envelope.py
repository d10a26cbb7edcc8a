"""Thinning a long curve for a chart so that no peak is lost."""

from __future__ import annotations

import numpy as np


def envelope(values: np.ndarray, most: int) -> np.ndarray:
    """Which points of a curve ``(n,)`` to draw: rising indices ``(k,)``, k at most about ``most``.

    The curve falls into equal stretches, of each the least and the greatest value stay (and both ends of the curve), so
    on a chart with ``most / 2`` pixels it looks as if every point were drawn. All stay where there are no more than
    ``most``. Raises ValueError where ``most`` is below 4.
    """
    if most < 4:
        raise ValueError(f"at least 4 points must be left of a curve, not {most}")
    n = len(values)
    if n <= most:
        return np.arange(n)
    width = -(-2 * n // most)
    whole = n - n % width
    stretches = np.asarray(values[:whole]).reshape(-1, width)
    starts = np.arange(len(stretches)) * width
    kept = [[0, n - 1], starts + stretches.argmin(1), starts + stretches.argmax(1)]
    if whole < n:
        tail = np.asarray(values[whole:])
        kept.append([whole + tail.argmin(), whole + tail.argmax()])
    return np.unique(np.concatenate(kept).astype(np.int64))
