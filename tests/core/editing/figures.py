"""Figures for the tests of editing: a person who stands, slides, lifts a foot, or performs something of the demo."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.demo.actions import perform
from core.demo.gaits import gait
from core.demo.performers import PERFORMERS, skeleton_of
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton

LEG = {side: tuple(f"{side}{joint}" for joint in ("UpLeg", "Leg", "Foot")) for side in ("Left", "Right")}


def standing(n: int = 60, fps: float = 60.0, bend: float = 0.3, scale: float = 1.0) -> Clip:
    """Knees bent by ``2 bend`` radians, soles level on the floor at height 0."""
    skeleton = skeleton_of(PERFORMERS[0])
    if scale != 1:
        skeleton = Skeleton(skeleton.names, skeleton.parents, skeleton.offsets * scale, skeleton.end_sites)
    rotations = np.zeros((n, skeleton.n_joints, 4), np.float32)
    rotations[..., 0] = 1
    for leg in LEG.values():
        for joint, angle in zip(leg, (-bend, 2 * bend, -bend), strict=True):
            rotations[:, skeleton.index(joint)] = quat.from_rotvec(np.array([angle, 0, 0]))
    thigh, shin = (-skeleton.offsets[skeleton.index(j), 1] for j in LEG["Left"][1:])
    sole = -skeleton.offsets[skeleton.index("LeftFoot_end"), 1]
    root = np.zeros((n, 3), np.float32)
    root[:, 1] = (thigh + shin) * np.cos(bend) + sole
    return Clip("standing", skeleton, fps, root, rotations)


def moved(clip: Clip, shift: np.ndarray) -> Clip:
    """The clip with ``shift`` ``(n_frames, 3)`` or ``(3,)`` added to its path."""
    return replace(clip, root_positions=(clip.root_positions + shift).astype(np.float32))


def action(name: str, seed: int = 0, performer: int = 0) -> Clip:
    """A performance out of the demo."""
    return perform(name, PERFORMERS[performer], np.random.default_rng(seed))


def rerigged(clip: Clip, seed: int = 0) -> Clip:
    """The same motion on a rig whose joint frames are turned at random: same positions, other rest pose and numbers."""
    skeleton, rng = clip.skeleton, np.random.default_rng(seed)
    turns = quat.normalise(rng.normal(size=(skeleton.n_joints, 4)))
    above = turns[list(skeleton.parents)]
    offsets = quat.rotate(quat.conjugate(above), skeleton.offsets.astype(float))
    offsets[0] = 0
    rotations = quat.multiply(quat.conjugate(above), quat.multiply(clip.rotations.astype(float), turns))
    rotations[:, 0] = quat.multiply(clip.rotations[:, 0].astype(float), turns[0])
    rig = Skeleton(skeleton.names, skeleton.parents, offsets, skeleton.end_sites)
    return replace(clip, skeleton=rig, rotations=rotations.astype(np.float32))


def going(*stages: tuple[str, float], turn: float = 0.0, seed: int = 0) -> Clip:
    """The demo's gait: stages of ("walk" or "run", seconds), turning by ``turn`` radians over all."""
    return gait(list(stages), turn, PERFORMERS[0], np.random.default_rng(seed))[0]
