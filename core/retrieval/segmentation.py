"""Where one part of the body begins something new, and segments brought to one length (PCR section 3.2).

The test is that of Barbic et al. (Segmenting Motion Capture Data into Distinct Behaviors, Graphics Interface 2004,
section 3.2): a Gaussian (probabilistic PCA) is fitted to the first ``window`` frames of a segment, and the frames that
follow are measured against it. As the fitted frames grow in number the measure falls, and rises when something new
comes. A peak after a valley that lies more than ``threshold`` (PCR's R) below it ends the segment there.

How large the measure is depends on the part and on the length of the windows, and the paper prints neither windows nor
a unit of R. Here motions are cut at one rate, whatever rate they are looked at (:data:`RATE`), and R is a multiple of
the part's own median measure (:func:`median_surprise`).
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import numpy as np
from scipy.interpolate import CubicSpline

from core.arrays import Float64Array, Int64Array
from core.compiled import njit

ENERGY = 0.95
"""Share of the variance that the principal axes keep (Barbic et al. 2004)."""

RATE = 30.0
"""Frames a second at which motions are cut, so that the windows last equally long at all rates."""

LEAST = 1.0
"""Measure of frames that differ by as much as angles are uncertain."""

WINDOW, AHEAD, SHORTEST = 3, 2, 3
"""Frames, at :data:`RATE`, that a segment's first model is fitted to, that are measured against it, and of the shortest
segment: about a tenth of a second each."""

FLOOR = 1e-4
"""Least variance of a direction, (radians)^2: half a degree. Below it angles are noise of the recording."""


def cuts_at(values: np.ndarray, fps: float, threshold: float) -> np.ndarray:
    """As :func:`ppca_cuts` for values ``(n, d)`` of any rate, which are cut at :data:`RATE`: ``(n_segments + 1,)``.

    The cuts are in frames of the values. Raises ValueError as that does.
    """
    values = np.atleast_2d(values)
    cuts = ppca_cuts(at_rate(values, fps), threshold)
    frames = np.rint(cuts[:-1] * (fps / RATE)).astype(np.int64)
    return np.append(np.unique(frames[frames < len(values)]), len(values))


def at_rate(values: np.ndarray, fps: float) -> np.ndarray:
    """Values ``(n, d)`` of ``fps`` frames a second at :data:`RATE`, from the first frame to the last: ``(m, d)``,
    by a cubic spline."""
    if fps == RATE or len(values) < 2:
        return values
    at = np.arange(int((len(values) - 1) * RATE / fps + 1e-6) + 1) * (fps / RATE)
    between: np.ndarray = CubicSpline(np.arange(len(values)), values, axis=0)(at)
    return between


def median_surprise(tracks: Iterable[np.ndarray], fps: float, step: int = 3) -> float:
    """Median measure of a part over many motions ``(n, d)``, at every ``step``-th frame of :data:`RATE`: the unit of R.

    At least :data:`LEAST`, so that the noise of a part that keeps still is no motion.
    """
    tracks = [np.ascontiguousarray(at_rate(track, fps), np.float64) for track in tracks]
    measured = [_surprises(track, WINDOW, AHEAD, step, ENERGY, FLOOR) for track in tracks]
    found = np.concatenate([np.zeros(0), *measured])
    return max(float(np.median(found)), LEAST) if len(found) else LEAST


def ppca_cuts(
    values: np.ndarray,
    threshold: float,
    *,
    window: int = WINDOW,
    ahead: int = AHEAD,
    shortest: int = SHORTEST,
    energy: float = ENERGY,
) -> np.ndarray:
    """Frames at which the segments of one part of one clip begin, and the end: ``(n_segments + 1,)`` int64 from 0 to n.

    values: ``(n, d)``, radians. window: frames the first model of a segment is fitted to; ahead: frames that are
    measured against it, by their mean squared Mahalanobis distance; shortest: least frames of a segment (a clip that
    is shorter is one). Raises ValueError for no frames, a threshold below 0 or windows too short.
    """
    values = np.ascontiguousarray(np.atleast_2d(values), np.float64)
    if len(values) == 0 or values.shape[1] == 0:
        raise ValueError("there are no frames to cut into segments")
    if not threshold >= 0 or window < 2 or ahead < 1 or shortest < 1 or not 0 < energy <= 1:
        raise ValueError("threshold must not be negative, window at least 2, ahead and shortest at least 1")
    return _cuts(values, float(threshold), int(window), int(ahead), int(shortest), float(energy), FLOOR)


@njit(nogil=True)
def _cuts(
    x: Float64Array, threshold: float, window: int, ahead: int, shortest: int, energy: float, floor: float
) -> Int64Array:
    n, d = x.shape
    cuts = [0]
    start = 0
    total, moments = np.zeros(d), np.zeros((d, d))
    while n - start >= window + ahead:
        total[:] = 0.0
        moments[:] = 0.0
        filled, size = 0, window
        valley, peak, at = np.inf, -1.0, -1
        cut = -1
        while start + size + ahead <= n:
            while filled < size:
                _count(x, start, start + filled, total, moments)
                filled += 1
            distance = _surprise(x, start, size, ahead, total, moments, energy, floor)
            if peak < 0:
                valley = min(valley, distance)
                if distance - valley > threshold:
                    peak, at = distance, size
            elif distance > peak:
                peak, at = distance, size
            else:
                cut = start + at
                break
            size += 1
        if cut < 0:
            break
        cut = max(cut, start + shortest)
        if n - cut < shortest:
            break
        cuts.append(cut)
        start = cut
    cuts.append(n)
    return np.array(cuts, dtype=np.int64)


@njit(nogil=True)
def _surprises(x: Float64Array, window: int, ahead: int, step: int, energy: float, floor: float) -> Float64Array:
    """The measure after each ``step``-th stretch of ``window`` frames, for a model of those alone."""
    n, d = x.shape
    starts = np.arange(0, n - window - ahead + 1, step)
    found = np.empty(len(starts))
    total, moments = np.zeros(d), np.zeros((d, d))
    for k, start in enumerate(starts):
        total[:] = 0.0
        moments[:] = 0.0
        for f in range(start, start + window):
            _count(x, start, f, total, moments)
        found[k] = _surprise(x, start, window, ahead, total, moments, energy, floor)
    return found


@njit(nogil=True)
def _count(x: Float64Array, start: int, frame: int, total: Float64Array, moments: Float64Array) -> None:
    """Adds a frame to the running sums about the segment's first frame, which keeps them small."""
    for a in range(len(total)):
        u = x[frame, a] - x[start, a]
        total[a] += u
        for b in range(a + 1):
            moments[a, b] += u * (x[frame, b] - x[start, b])


@njit(nogil=True)
def _surprise(
    x: Float64Array,
    start: int,
    size: int,
    ahead: int,
    total: Float64Array,
    moments: Float64Array,
    energy: float,
    floor: float,
) -> float:
    """Mean squared Mahalanobis distance of the ``ahead`` frames after ``size`` ones to the model of those."""
    d = len(total)
    covariance = np.empty((d, d))
    for a in range(d):
        for b in range(a + 1):
            covariance[a, b] = (moments[a, b] - total[a] * total[b] / size) / (size - 1)
            covariance[b, a] = covariance[a, b]
    variances, axes = np.linalg.eigh(covariance)
    whole = variances.sum()
    kept, share = 0, 0.0
    while kept < d and share < energy * whole:
        kept += 1
        share += max(variances[d - kept], 0.0)
    rest = 0.0  # PPCA: the mean variance of the axes left out stands for each of them
    for k in range(d - kept):
        rest += max(variances[k], 0.0)
    rest = max(rest / (d - kept), floor) if kept < d else floor
    distance = 0.0
    for k in range(d):
        variance = max(variances[k], rest) if k >= d - kept else rest
        for f in range(start + size, start + size + ahead):
            along = 0.0
            for a in range(d):
                along += axes[a, k] * (x[f, a] - x[start, a] - total[a] / size)
            distance += along * along / variance
    return distance / ahead


def normalise_segments(values: np.ndarray, starts: np.ndarray, ends: np.ndarray, length: int) -> np.ndarray:
    """Segments ``[starts, ends)`` of ``values`` (n, d), each brought to ``length`` frames by a cubic spline.

    Gives ``(n_segments, length, d)`` float32; starts, ends: ``(n_segments,)``. Segments of fewer than four frames,
    which no cubic fits, take the polynomial through their frames. Raises ValueError for an empty segment or a length
    below 1.
    """
    starts, ends = np.asarray(starts, np.int64), np.asarray(ends, np.int64)
    if length < 1 or (ends <= starts).any():
        raise ValueError("segments need at least one frame, and so does the length they are brought to")
    result = np.empty((len(starts), length, values.shape[1]), np.float32)
    for frames in np.unique(ends - starts):
        chosen = np.flatnonzero(ends - starts == frames)
        rows = np.asarray(values)[starts[chosen, None] + np.arange(frames)]
        if frames == 1:
            result[chosen] = rows
            continue
        result[chosen] = np.einsum("tf,sfd->std", _spline(int(frames), int(length)), rows)
    return result


@lru_cache(maxsize=4096)
def _spline(frames: int, length: int) -> np.ndarray:
    """A spline is linear in its data: one small matrix (length, frames) serves all segments of this many frames."""
    at = np.linspace(0, frames - 1, length) if length > 1 else np.array([(frames - 1) / 2])
    return CubicSpline(np.arange(frames), np.eye(frames), axis=0)(at).astype(np.float32)
