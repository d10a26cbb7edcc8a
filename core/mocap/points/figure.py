"""Points become a clip: with a preset a body, without one a cloud of markers that keeps every point where it is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.points import cleaning
from core.mocap.points.roles import ROLES, direction_of, parent_among
from core.mocap.points.solving import solve
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.text import LARGEST
from core.mocap.units import guess_unit, in_words
from core.mocap.upright import TO_Y

MOST_POINTS = 2000
_FEWEST_PARTS = 6  # parts of a body that make a figure
_POOR_FIT = 0.06  # metres, the median: what fits no better is said to be doubtful
_FITS = 95  # percentile that is told beside the median
LEAST_SEEN = 0.02  # share of the frames: points seen less often are left out


@dataclass(frozen=True, eq=False)
class Points:
    """Positions as a file gives them, in its unit and axes.

    values: (n_frames, n_points, 3), NaN where a point was not seen. unit: metres per unit, None where the file does not
    say. parts: role (core.mocap.points.roles) -> indices of the points whose mean it is; empty for markers that are
    nobody's. notes, findings: what the reader has to say.
    """

    path: Path
    name: str
    names: tuple[str, ...]
    values: np.ndarray
    fps: float
    unit: float | None = None
    parts: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    findings: tuple[Finding, ...] = ()


def clip_of(points: Points, smooth: float | None = None) -> Clip:
    """The clip that points are. smooth: cut-off in Hz, None for points as they are.

    Raises RecordingError where there is nothing to see.
    """
    if not points.fps > 0 or not np.isfinite(points.fps):
        raise RecordingError(points.path, f"{points.fps:g} frames per second", "a positive rate; give one with --fps")
    if points.values.ndim != 3 or points.values.shape[2] != 3 or not points.values.size:
        raise RecordingError(points.path, "no points in it", "at least one point and one frame")
    points = _seen(replace(points, values=cleaning.without_lost(np.asarray(points.values, float))))
    values, marks = cleaning.filled(points.values, points.names, points.fps)
    notes = list(points.notes)
    if smooth:
        values = cleaning.smoothed(values, points.fps, smooth)
        notes.append(f"smoothed: what is faster than {smooth:g} Hz was taken out")
    points = replace(points, values=values, findings=(*points.findings, *marks), notes=tuple(notes))
    return _figure(points) if len(points.parts) >= _FEWEST_PARTS and "pelvis" in points.parts else _cloud(points)


def _seen(points: Points) -> Points:
    """Without infinite and unbelievable numbers, and without points that are hardly ever seen."""
    values = points.values
    if values.shape[1] > MOST_POINTS:
        raise RecordingError(points.path, f"{values.shape[1]} points", f"at most {MOST_POINTS}")
    with np.errstate(invalid="ignore"):
        values = np.where(np.abs(values) <= LARGEST, values, np.nan)
    values = np.where(np.isnan(values).any(axis=2, keepdims=True), np.nan, values)
    seen = (~np.isnan(values[:, :, 0])).mean(axis=0)
    keep = np.flatnonzero(seen > LEAST_SEEN)
    if not len(keep):
        raise RecordingError(points.path, "no point is seen in any frame", "points with positions")
    if len(keep) == len(seen):
        return replace(points, values=values)
    missing = [points.names[k] for k in range(len(seen)) if k not in set(keep.tolist())]
    shown = ", ".join(missing[:6]) + (" ..." if len(missing) > 6 else "")
    index = {int(old): new for new, old in enumerate(keep)}
    found = {role: tuple(index[k] for k in which if k in index) for role, which in points.parts.items()}
    whole = {role: kept for role, kept in found.items() if len(kept) == len(points.parts[role])}
    return replace(
        points,
        values=values[:, keep],
        names=tuple(points.names[k] for k in keep),
        parts=whole,
        findings=(*points.findings, Finding("unseen", f"hardly ever seen and left out: {shown}")),
    )


def _figure(points: Points) -> Clip:
    roles = [role for role in ROLES if role in points.parts]
    there = set(roles)
    # a part whose parents are all missing hangs from the pelvis
    parents = [-1 if role == "pelvis" else roles.index(parent_among(role, there) or "pelvis") for role in roles]
    positions = np.stack([points.values[:, points.parts[role]].mean(axis=1) for role in roles], axis=1)
    up = cleaning.upward(_line(positions, roles))
    to_file = quat.conjugate(np.array(TO_Y[up]))
    directions = quat.rotate(to_file, np.array([direction_of(role) for role in roles]))
    solution = solve(positions, parents, directions)
    skeleton = Skeleton(
        names=_names(points, roles),
        parents=tuple(parents),
        offsets=solution.offsets,
    )
    unit, note = _unit(points, skeleton)
    median, most = (float(np.percentile(solution.errors * unit, share)) * 1000 for share in (50, _FITS))
    fit = (
        f"{len(roles)} joints from {len(points.names)} points; bones of fixed lengths fit within {median:.1f} mm in "
        + (f"the median, {most:.1f} mm in {_FITS} of 100")
    )
    findings = points.findings
    if median / 1000 > _POOR_FIT:
        words = f"bones of fixed lengths fit poorly ({median:.0f} mm in the median): is it the right list of joints?"
        findings = (*findings, Finding("fit", words))
    return Clip(
        name=points.name,
        skeleton=replace(skeleton, offsets=skeleton.offsets.astype(float) * unit, unit=unit),
        fps=float(points.fps),
        root_positions=(positions[:, 0] * unit).astype(np.float32),
        rotations=solution.rotations,
        notes=(*points.notes, fit, note),
        findings=findings,
    )


def _line(positions: np.ndarray, roles: Sequence[str]) -> np.ndarray:
    """From the feet (or the pelvis) to the top of the figure, ``(n, 3)``."""
    low = [roles.index(role) for role in ("left_ankle", "right_ankle") if role in roles] or [0]
    high = next((roles.index(role) for role in ("head", "neck", "chest", "head_top", "spine") if role in roles), 0)
    line: np.ndarray = positions[:, high] - positions[:, low].mean(axis=1)
    return line


def _names(points: Points, roles: Sequence[str]) -> tuple[str, ...]:
    """A joint is called like its only point, else like its part of the body."""
    names: list[str] = []
    for role in roles:
        which = points.parts[role]
        name = points.names[which[0]] if len(which) == 1 else role
        while name in names:
            name += "_"
        names.append(name)
    return tuple(names)


def _cloud(points: Points) -> Clip:
    """Markers that are no body: each hangs from their middle and moves on a track of its own."""
    middle = np.nanmean(points.values, axis=1)
    values = points.values
    local = values - middle[:, None]
    rest = np.median(local, axis=0)
    root = "markers"
    while root in points.names:
        root += "_"
    names = (root, *_unique(points.names))
    skeleton = Skeleton(names, (-1, *[0] * len(points.names)), np.concatenate([np.zeros((1, 3)), rest]))
    unit, note = _unit(points, skeleton)
    rotations = np.zeros((len(values), len(names), 4), np.float32)
    rotations[..., 0] = 1
    words = f"{len(points.names)} markers that are no known set of joints: each moves by itself"
    return Clip(
        name=points.name,
        skeleton=replace(skeleton, offsets=skeleton.offsets.astype(float) * unit, unit=unit),
        fps=float(points.fps),
        root_positions=(middle * unit).astype(np.float32),
        rotations=rotations,
        translations={k + 1: (local[:, k] * unit).astype(np.float32) for k in range(len(points.names))},
        notes=(*points.notes, note),
        findings=(*points.findings, Finding("body", words)),
    )


def _unique(names: Sequence[str]) -> list[str]:
    found: list[str] = []
    for given in names:
        name, k = given or "point", 2
        while name in found:
            name, k = f"{given or 'point'}_{k}", k + 1
        found.append(name)
    return found


def _unit(points: Points, skeleton: Skeleton) -> tuple[float, str]:
    """Metres per unit, and the sentence that says where it is from."""
    if points.unit is not None:
        return points.unit, f"unit: {in_words(points.unit)}, as the file says"
    guess = guess_unit(skeleton)
    return guess.metres, f"unit: the file does not say it; {guess.words}"
