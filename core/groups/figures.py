"""Figures of how someone moves, clip by clip: pace, turning, gait, posture, all from joint positions in space.

Nothing is measured against a zero of the body itself, such as its own usual posture, for that would hide differences
of posture between people.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from core.arrays import FloatArray
from core.editing.blending import heading
from core.editing.gait import find_gait
from core.groups.design import Design
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.progress import Report, silent

FIGURES: Mapping[str, str] = {
    "Walking speed": "m/s",
    "Step length": "m",
    "Step time": "s",
    "Cadence": "steps/min",
    "Stance": "% of stride",
    "Step time varies by": "%",
    "Step time, left and right apart by": "%",
    "Share of time walking or running": "%",
    "Travel": "m/s",
    "Turning": "°/s",
    "Height of the pelvis": "% of body height",
    "Lean of the trunk": "°",
    "Height of the head": "% of body height",
    "Bend of the neck": "°",
    "Left arm away from the trunk": "°",
    "Right arm away from the trunk": "°",
    "Elbows bent": "°",
    "Knees bent": "°",
    "Speed of the hands": "m/s",
    "Speed of the feet": "m/s",
}
"""Name -> unit. Lean and bend are from upright; speeds of hands and feet are relative to the pelvis."""

_OF_GAIT = {"Speed": "Walking speed", **{name: name for name in ("Step length", "Step time", "Cadence", "Stance")}}


def figures_of(clip: Clip) -> dict[str, tuple[float, float]]:
    """Figures of a clip, name -> (value, weight in seconds); those that the body or the motion does not have are left
    out."""
    positions = np.asarray(joint_positions(clip), float)
    found = {name: (value, clip.seconds) for name, value in _posture(clip, positions).items()}
    return found | _pace(clip, positions) | _gait(clip, positions)


ByClip = Mapping[str, Mapping[str, tuple[float, float]]]
"""Clip -> its figures: see :func:`figures_of`."""


def figures_by_clip(design: Design, dataset: Dataset, report: Report = silent) -> ByClip:
    """The figures of every clip of a design. Raises Cancelled from ``report``."""
    by_clip = {}
    clips = [clip for unit in design.units for clip in unit.clips]
    for k, name in enumerate(clips):
        report("measuring", k / len(clips))
        by_clip[name] = figures_of(dataset.clip(name))
    return by_clip


def figure_table(design: Design, by_clip: ByClip) -> FloatArray:
    """The figures of each unit, ``(n_units, n_figures)`` in the order of FIGURES.

    They are means over its clips by their weights, nan where it has none.
    """
    table = np.full((len(design.units), len(FIGURES)), np.nan)
    for row, unit in enumerate(design.units):
        for column, name in enumerate(FIGURES):
            own = np.array([by_clip[clip][name] for clip in unit.clips if name in by_clip[clip]]).reshape(-1, 2)
            if own[:, 1].sum() > 0:
                table[row, column] = own[:, 0] @ own[:, 1] / own[:, 1].sum()
    return table


def _gait(clip: Clip, positions: FloatArray) -> dict[str, tuple[float, float]]:
    bouts = find_gait(clip, positions=positions).bouts
    spent = sum(bout.end - bout.start for bout in bouts) / clip.fps
    found: dict[str, list[tuple[float, float]]] = {}
    for bout in bouts:
        if bout.kind != "walk":
            continue
        seconds = (bout.end - bout.start) / clip.fps
        for measure in bout.measures:
            if measure.name in _OF_GAIT:
                found.setdefault(_OF_GAIT[measure.name], []).append((measure.mean, seconds))
            if measure.name == "Step time" and measure.mean > 0:
                found.setdefault("Step time varies by", []).append((100 * measure.spread / measure.mean, seconds))
                if measure.asymmetry is not None:
                    name = "Step time, left and right apart by"
                    found.setdefault(name, []).append((abs(measure.asymmetry), seconds))
    means = {name: _weighted(values) for name, values in found.items()}
    return means | {"Share of time walking or running": (100 * spent / clip.seconds, clip.seconds)}


def _weighted(values: Sequence[tuple[float, float]]) -> tuple[float, float]:
    total = sum(weight for _, weight in values)
    return sum(value * weight for value, weight in values) / total, total


def _pace(clip: Clip, positions: FloatArray) -> dict[str, tuple[float, float]]:
    if clip.n_frames < 3:
        return {}
    steps = np.linalg.norm(np.diff(_smooth(positions[:, 0][:, [0, 2]], clip.fps), axis=0), axis=1)
    turns = np.abs(np.diff(_smooth(np.unwrap(heading(clip, positions))[:, None], clip.fps), axis=0))
    seconds = clip.seconds
    return {
        "Travel": (float(steps.mean() * clip.fps), seconds),
        "Turning": (float(np.degrees(turns.mean() * clip.fps)), seconds),
    }


def _smooth(values: FloatArray, fps: float) -> FloatArray:
    """Means over a third of a second, so that swaying and noise are no travel; columns on their own."""
    width = max(1, min(round(fps / 3), len(values)))
    sums = np.cumsum(np.concatenate([np.zeros((1, values.shape[1])), values]), axis=0)
    means: FloatArray = (sums[width:] - sums[:-width]) / width
    return means


def _posture(clip: Clip, positions: FloatArray) -> dict[str, float]:
    anatomy = find_anatomy(clip.skeleton)
    at = {name: positions[:, joint] for name, joint in anatomy.joints.items()}
    found = _trunk(at) | _bends(at)
    feet = [at[name] for side in SIDES for name in (f"{side}_ankle", f"{side}_toe") if name in at]
    if feet and anatomy.body_height > 0:
        floor = np.percentile(np.min([foot[:, 1] for foot in feet], axis=0), 5)
        for part in ("pelvis", "head"):
            if part in at:
                found[f"Height of the {part}"] = 100 * (at[part][:, 1] - floor) / anatomy.body_height
    for name, joint in (("Speed of the hands", "wrist"), ("Speed of the feet", "ankle")):
        ends = [at[f"{side}_{joint}"] - positions[:, 0] for side in SIDES if f"{side}_{joint}" in at]
        if ends and clip.n_frames > 1:
            found[name] = np.mean([np.linalg.norm(np.diff(e, axis=0), axis=1) for e in ends], axis=0) * clip.fps
    return {name: float(np.mean(values)) for name, values in found.items()}


def _trunk(at: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Lean of the trunk, bend of the neck, arms off the trunk, degrees ``(n_frames,)``; at: joint -> positions."""
    neck = at.get("neck", at.get("chest"))
    if "pelvis" not in at or neck is None:
        return {}
    trunk = neck - at["pelvis"]
    found = {"Lean of the trunk": _angle(trunk, np.broadcast_to([0.0, 1, 0], trunk.shape))}
    if "head" in at and "neck" in at:
        found["Bend of the neck"] = _angle(at["head"] - at["neck"], trunk)
    for side in SIDES:
        if {f"{side}_shoulder", f"{side}_elbow"} <= set(at):
            arm = at[f"{side}_elbow"] - at[f"{side}_shoulder"]
            found[f"{side.capitalize()} arm away from the trunk"] = _angle(arm, -trunk)
    return found


def _bends(at: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Bends of elbows and knees, means of both sides, degrees ``(n_frames,)``; 0 is straight."""
    found = {}
    for name, joints in (("Elbows bent", ("shoulder", "elbow", "wrist")), ("Knees bent", ("hip", "knee", "ankle"))):
        limbs = [[f"{side}_{joint}" for joint in joints] for side in SIDES]
        bends = [_angle(at[c] - at[b], at[b] - at[a]) for a, b, c in limbs if {a, b, c} <= set(at)]
        if bends:
            found[name] = np.mean(bends, axis=0)
    return found


def _angle(a: FloatArray, b: FloatArray) -> FloatArray:
    """Degrees between vectors, ``(n_frames, 3)`` each."""
    lengths = np.maximum(np.linalg.norm(a, axis=1) * np.linalg.norm(b, axis=1), 1e-12)
    degrees: FloatArray = np.degrees(np.arccos(np.clip((a * b).sum(1) / lengths, -1, 1)))
    return degrees
