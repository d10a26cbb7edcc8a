"""Curves of a movement, registered: each motion is read at the moments that stand beside those of its medoid."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from core.arrays import FloatArray
from core.groups.design import Design
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.poses.angles import JOINTS, joint_angles, known_joints
from core.poses.body_frames import BodyFrames, body_frames
from core.progress import Report, silent

POINTS = 101  # per cent of the movement
_JOINTS = (
    "pelvis",
    "trunk",
    "head",
    *(f"{side}_{j}" for j in ("hip", "knee", "ankle", "shoulder", "elbow") for side in ("left", "right")),
)
CHANNELS = {"pelvis": (0, 1), "trunk": (0, 1), "head": (0,), "shoulder": (0, 3), "hip": (0, 1), "ankle": (0,)}
"""Joint -> which of its angles are curves; the first, flexion, where none is named."""
SPEED = "speed of the pelvis"


def curves_of(clip: Clip, frames: BodyFrames) -> dict[str, FloatArray]:
    """Name -> ``(n_frames,)``: joint angles in degrees, the speed of the pelvis over the ground in m/s."""
    joints = [name for name in _JOINTS if name in known_joints(frames)]
    found = {}
    for name, angles in joint_angles(clip, frames, joints).items():
        for channel in CHANNELS.get(name.split("_")[-1], (0,)):
            found[f"{name.replace('_', ' ')} {JOINTS[name].channels[channel].name}"] = angles[:, channel].astype(float)
    path = np.asarray(joint_positions(clip)[:, 0][:, [0, 2]], float)
    speed = np.linalg.norm(np.gradient(path, axis=0), axis=1) if clip.n_frames > 1 else np.zeros(clip.n_frames)
    width = max(1, round(clip.fps / 10))
    found[SPEED] = (
        np.convolve(np.pad(speed, width // 2, mode="edge"), np.ones(width) / width, "valid")[: clip.n_frames] * clip.fps
    )
    return found


def all_curves(dataset: Dataset, clips: Sequence[str], report: Report = silent) -> dict[str, dict[str, FloatArray]]:
    """Clip -> its curves (:func:`curves_of`); clips of one skeleton share their frames. Raises Cancelled."""
    by_skeleton: dict[int, list[Clip]] = {}
    for name in clips:
        clip = dataset.clip(name)
        by_skeleton.setdefault(hash(clip.skeleton), []).append(clip)
    found, done = {}, 0
    for own in by_skeleton.values():
        frames = body_frames(own)
        for clip in own:
            report("reading curves", done / len(clips))
            found[clip.name] = curves_of(clip, frames)
            done += 1
    return found


def registered(curve: FloatArray, segment: Segment, warp: FloatArray) -> FloatArray:
    """A curve of a clip at POINTS moments of a motion.

    curve: ``(n_frames,)`` of the whole clip. warp: ``(n,)`` frames from the start of the motion, one beside each frame
    of the medoid.
    """
    moments = segment.start + np.interp(np.linspace(0, len(warp) - 1, POINTS), np.arange(len(warp)), warp)
    values: FloatArray = np.interp(moments, np.arange(len(curve)), curve)
    return values


def unit_curves(
    design: Design,
    curves: Mapping[str, Mapping[str, FloatArray]],
    name: str,
    motions: Sequence[tuple[Segment, FloatArray]],
) -> FloatArray:
    """The mean curve of each unit over its motions, ``(n_units, POINTS)``; nan where it has none."""
    by_clip: dict[str, list[FloatArray]] = {}
    for segment, warp in motions:
        if name in curves.get(segment.clip, {}):
            by_clip.setdefault(segment.clip, []).append(registered(curves[segment.clip][name], segment, warp))
    out = np.full((len(design.units), POINTS), np.nan)
    for row, unit in enumerate(design.units):
        own = [curve for clip in unit.clips for curve in by_clip.get(clip, ())]
        if own:
            out[row] = np.mean(own, axis=0)
    return out
