"""Points before they become a figure: gaps filled and marked, jitter smoothed, the way up found."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.mocap.reports import Finding

LONGEST_GAP = 0.5  # seconds that are filled without more than a mark
_MARKED = 100  # gaps that are findings of their own
_ALONG, _OFTEN = 0.8, 0.5  # cosine of a body that stands along an axis, and the share of frames in which it has to
_ALWAYS = 0.9  # share of the frames in which a point at the origin belongs there
_ORDER = 2  # of the Butterworth filter, which runs forwards and backwards


def filled(points: np.ndarray, names: Sequence[str], fps: float) -> tuple[np.ndarray, list[Finding]]:
    """Points ``(n_frames, n_points, 3)`` without NaN, and findings that mark every stretch that was filled.

    A gap lies on the straight line between its neighbours; at either end the nearest frame is repeated. Stretches
    longer than LONGEST_GAP are said to be doubtful. Points that are never seen stay NaN.
    """
    lost = np.isnan(points).any(axis=2)
    if not lost.any():
        return points, []
    out = points.copy()
    at = np.arange(len(points))
    gaps: list[tuple[int, int, str]] = []
    for k in range(points.shape[1]):
        if not lost[:, k].any() or lost[:, k].all():
            continue
        there = np.flatnonzero(~lost[:, k])
        for axis in range(3):
            out[:, k, axis] = np.interp(at, there, points[there, k, axis])
        gaps += [(start, end, names[k]) for start, end in _stretches(lost[:, k])]
    return out, _findings(gaps, fps)


def _stretches(flags: np.ndarray) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    return [(int(start), int(end)) for start, end in zip(edges[::2], edges[1::2], strict=True)]


def _findings(gaps: list[tuple[int, int, str]], fps: float) -> list[Finding]:
    """A finding for each stretch of frames in which points are missing, those that overlap together."""
    together: list[tuple[int, int, list[str], int]] = []
    for start, end, name in sorted(gaps):
        if together and start <= together[-1][1]:
            first, last, names, longest = together.pop()
            names = names if name in names else [*names, name]
            together.append((first, max(last, end), names, max(longest, end - start)))
        else:
            together.append((start, end, [name], end - start))
    findings = []
    for start, end, names, longest in together[:_MARKED]:
        shown = ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")
        frames = f"frame {start}" if end - start == 1 else f"frames {start} to {end - 1}"
        if longest / fps > LONGEST_GAP:
            words = f"{frames}: {shown} not seen, for up to {longest / fps:.1f} s; what stands there is a guess"
            findings.append(Finding("gap", words, start, end))
        else:
            findings.append(Finding("filled", f"{frames}: {shown} not seen; filled from the frames around", start, end))
    if rest := together[_MARKED:]:
        words = f"{len(rest)} further gaps, filled from the frames around"
        findings.append(Finding("filled", words, rest[0][0], max(end for _, end, _, _ in rest)))
    return findings


def smoothed(points: np.ndarray, fps: float, cut_off: float) -> np.ndarray:
    """Points ``(n_frames, n_points, 3)`` without what is faster than ``cut_off`` Hz (Butterworth, without delay)."""
    if len(points) < 4 or cut_off >= 0.45 * fps:
        return points
    from scipy.signal import butter, sosfiltfilt  # takes longer to import than all of this package

    sections = butter(_ORDER, cut_off, fs=fps, output="sos")
    return np.asarray(sosfiltfilt(sections, points, axis=0, padlen=min(len(points) - 1, 3 * (2 * len(sections) + 1))))


def without_lost(points: np.ndarray) -> np.ndarray:
    """Points ``(n_frames, n_points, 3)`` with NaN where all numbers are exactly 0: how trackers say "not seen"."""
    zero = (points == 0).all(axis=2)
    rows = zero.all(axis=1, keepdims=True)
    lost = rows | (zero & (zero.mean(axis=0) < _ALWAYS))  # a root that always is at the origin is meant
    return np.where(lost[..., None], np.nan, points) if lost.any() and not rows.all() else points


def upward(line: np.ndarray) -> str:
    """The axis (``y``, ``z``, ``-x`` ...) along which a body stands, from lines ``(n_frames, 3)`` from feet to head.

    Y where no other is certain.
    """
    length = np.linalg.norm(line, axis=1, keepdims=True)
    unit = line[length[:, 0] > 1e-9] / length[length[:, 0] > 1e-9]
    if not len(unit):
        return "y"
    shares = {
        ("" if sign > 0 else "-") + "xyz"[axis]: float(np.mean(sign * unit[:, axis] > _ALONG))
        for axis in range(3)
        for sign in (1, -1)
    }
    best = max(shares, key=lambda name: (shares[name], name == "y"))
    return best if shares[best] > _OFTEN else "y"


def median_of(values: np.ndarray) -> float:
    """Median of the numbers ``(n,)`` that are none of NaN and infinite; 0 where all are."""
    finite = values[np.isfinite(values)]
    return float(np.median(finite)) if finite.size else 0.0
