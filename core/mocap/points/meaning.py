"""What points mean: a preset that someone named or the names show, names of joints, or a set of markers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.mocap.points.cleaning import filled, median_of
from core.mocap.points.figure import Points
from core.mocap.points.markers import joints_of_markers
from core.mocap.points.naming import (
    likely_preset,
    parts_by_name,
    parts_of_preset,
    preset_called,
    preset_of_names,
    presets_of_count,
)
from core.mocap.points.presets import PRESETS
from core.mocap.units import UNITS

_ENOUGH = 8  # parts of a body that names have to give


def understood(points: Points, said: str | None = None, named: bool = True) -> Points:
    """The points with the parts of the body that they are.

    said: a preset's name, which counts before all else; named: whether the file gives the points names, else their
    number and how well bones keep their lengths decide. Points that are nothing known are left as they are. Raises
    ParameterError for a preset that does not exist.
    """
    if said:
        return _as_preset(points, said, f"read as {preset_called(said).title}, as was said")
    if not named:
        return _by_count(points)
    preset = preset_of_names(points.names)
    by_name = parts_by_name(points.names, points.values)
    parts = parts_of_preset(preset, points.names) if preset else {}
    if preset and "pelvis" in parts and len(parts) >= len(by_name):
        return replace(points, parts=parts, notes=(*points.notes, f"the points are those of {preset.title}"))
    if len(by_name) >= _ENOUGH and "pelvis" in by_name and _legs_or_arms(by_name):
        used = {k for which in by_name.values() for k in which}
        note = f"{len(used)} of {len(points.names)} points are parts of a body by their names"
        return replace(points, parts=by_name, notes=(*points.notes, note))
    return _as_markers(points)


def _legs_or_arms(parts: dict[str, tuple[int, ...]]) -> bool:
    """Whether the middle of a limb is there on both sides: without knees and elbows nothing moves."""
    return any({f"left_{joint}", f"right_{joint}"} <= parts.keys() for joint in ("knee", "elbow"))


def _as_preset(points: Points, said: str, note: str) -> Points:
    preset = preset_called(said)
    parts = parts_of_preset(preset, points.names)
    names = points.names
    if len(parts) < len(preset.parts) and len(names) >= len(preset.points):  # by their order
        parts, names = parts_of_preset(preset), (*preset.points, *points.names[len(preset.points) :])
    return replace(points, names=names, parts=parts, notes=(*points.notes, note))


def _by_count(points: Points) -> Points:
    count = len(points.names)
    found = likely_preset(points.values)
    if not found:
        return points
    others = [name for name in presets_of_count(count) if name != found]
    also = f"; also known with {count}: {', '.join(PRESETS[name].title for name in others)}" if others else ""
    return _as_preset(points, found, f"{count} points, taken as {PRESETS[found].title}{also}")


def _as_markers(points: Points) -> Points:
    """Markers of a known set become joints, which are added to the points."""
    unit = points.unit or _unit_of_markers(points.values)
    whole, _ = filled(points.values, points.names, points.fps)
    joints = joints_of_markers(points.names, whole, unit)
    if not joints:
        return points
    n = len(points.names)
    values = np.concatenate([points.values, np.stack(list(joints.values()), axis=1)], axis=1)
    note = f"{n} markers give {len(joints)} joints, by the joint centres of the file or by published regressions"
    return replace(
        points,
        names=(*points.names, *(f"{role}_joint" if role in points.names else role for role in joints)),
        values=values,
        parts={role: (n + k,) for k, role in enumerate(joints)},
        notes=(*points.notes, note),
    )


def _unit_of_markers(values: np.ndarray) -> float:
    """Metres per unit in which the markers span the size of a person."""
    sizes = np.fmax.reduce(values, axis=1) - np.fmin.reduce(values, axis=1)
    span = max(median_of(size) for size in sizes.T)
    return min(
        (UNITS[name][0] for name in ("m", "cm", "mm")), key=lambda metres: abs(np.log(max(span, 1e-9) * metres / 1.6))
    )
