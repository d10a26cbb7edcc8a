"""Resamples motions at equal steps of the path of the posture, not at equal times (docs/methods/search.md).

A slow and a fast performance of one action then have the same samples, and standing still takes no room.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array, Int8Array, Int64Array
from core.compiled import njit

STILL = 1e-3
"""Added to the way of every frame step, so that a motion that stands still is read at equal steps of time."""


class Samples(NamedTuple):
    """Stretches read at equal steps of their way.

    values: ``(n_stretches, n_samples, d)`` float32. steps: ``(n_stretches, n_groups)`` mean way of each group of
    columns from one frame to the next. means: ``(n_stretches, d)`` mean over the frames.
    """

    values: np.ndarray
    steps: np.ndarray
    means: np.ndarray


def path_lengths(values: np.ndarray) -> np.ndarray:
    """Way that a motion ``(n, d)`` has gone at each frame: ``(n,)`` float64, from 0, growing by at least STILL."""
    steps = np.sqrt((np.diff(np.asarray(values, np.float64), axis=0) ** 2).sum(1)) + STILL
    return np.concatenate([[0.0], np.cumsum(steps)])


def at_shares(values: np.ndarray, lengths: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """The frames ``(n, d)``, linearly interpolated, at shares ``(k,)`` (0 to 1) of their way ``(n,)``: ``(k, d)``."""
    at = np.interp(np.asarray(shares) * lengths[-1], lengths, np.arange(len(lengths)))
    low = at.astype(np.int64)
    high = np.minimum(low + 1, len(values) - 1)
    rest = (at - low).astype(np.float32)[:, None]
    read: np.ndarray = values[low] * (1 - rest) + values[high] * rest
    return read


def sample_all(
    codes: np.ndarray,
    columns: np.ndarray,
    scales: np.ndarray,
    groups: np.ndarray,
    starts: np.ndarray,
    ends: np.ndarray,
    n_samples: int,
) -> Samples:
    """Each stretch ``[start, end)`` of ``codes`` (n, width) int8 as ``n_samples`` frames at equal steps of its way.

    columns: ``(d,)`` those that are read; scales: ``(d,)`` what a code of each stands for; groups: ``(d,)`` the group
    that each belongs to, from 0, in blocks; those of group -1, at the end, are no part of the way. Raises ValueError
    for a stretch that is empty or not there.
    """
    starts, ends, columns = (np.asarray(values, np.int64) for values in (starts, ends, columns))
    groups = np.asarray(groups, np.int64)
    if len(starts) and (starts.min() < 0 or ends.max() > len(codes) or (ends <= starts).any()):
        raise ValueError("a stretch is empty or lies outside the frames")
    if n_samples < 2:
        raise ValueError("at least 2 samples are needed")
    way = int((groups >= 0).sum())
    bounds = np.searchsorted(groups[:way], np.arange(groups.max() + 2))
    return Samples(*_sample_all(codes, columns, np.asarray(scales, np.float32), bounds, starts, ends, n_samples))


@njit(nogil=True, fastmath=True)
def _sample_all(
    codes: Int8Array,
    columns: Int64Array,
    scales: Float32Array,
    bounds: Int64Array,
    starts: Int64Array,
    ends: Int64Array,
    n_samples: int,
) -> tuple[Float32Array, Float32Array, Float32Array]:
    d, n_groups = len(columns), len(bounds) - 1
    values = np.empty((len(starts), n_samples, d), np.float32)
    steps = np.zeros((len(starts), n_groups), np.float32)
    means = np.zeros((len(starts), d), np.float32)
    longest = 1
    for c in range(len(starts)):
        longest = max(longest, ends[c] - starts[c])
    lengths = np.empty(longest, np.float32)
    here, before = np.empty(d, np.float32), np.empty(d, np.float32)
    for c in range(len(starts)):
        first, n = starts[c], ends[c] - starts[c]
        for f in range(n):
            for e in range(d):
                before[e] = here[e]
                here[e] = np.float32(codes[first + f, columns[e]]) * scales[e]
                means[c, e] += here[e]
            if f == 0:
                lengths[0] = 0.0
                continue
            total = np.float32(0.0)
            for g in range(n_groups):
                part = np.float32(0.0)
                for e in range(bounds[g], bounds[g + 1]):
                    apart = here[e] - before[e]
                    part += apart * apart
                steps[c, g] += np.sqrt(part)
                total += part
            lengths[f] = lengths[f - 1] + np.sqrt(total) + np.float32(STILL)
        means[c] /= n
        steps[c] /= max(n - 1, 1)
        f = 0
        for k in range(n_samples):
            aim = lengths[n - 1] * np.float32(k / (n_samples - 1))
            while f < n - 2 and lengths[f + 1] < aim:
                f += 1
            other = min(f + 1, n - 1)
            gap = lengths[other] - lengths[f]
            rest = min(np.float32(1.0), max(np.float32(0.0), (aim - lengths[f]) / gap)) if gap > 0 else np.float32(0.0)
            for e in range(d):
                low = np.float32(codes[first + f, columns[e]])
                high = np.float32(codes[first + other, columns[e]])
                values[c, k, e] = (low + (high - low) * rest) * scales[e]
    return values, steps, means
