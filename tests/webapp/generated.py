"""Small generated data sets for tests and benchmarks of what is seen."""

from __future__ import annotations

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton

# name, parent, offset in metres: the 31 joints of the CMU skeleton, roughly its proportions
_LEG = (
    ("HipJoint", "Hips", (0.0, 0.0, 0.0)),
    ("UpLeg", "HipJoint", (0.09, -0.08, 0.02)),
    ("Leg", "UpLeg", (0.0, -0.41, 0.0)),
    ("Foot", "Leg", (0.0, -0.40, 0.0)),
    ("ToeBase", "Foot", (0.0, -0.05, 0.13)),
)
_ARM = (
    ("Shoulder", "Spine1", (0.0, 0.12, 0.0)),
    ("Arm", "Shoulder", (0.17, 0.06, 0.0)),
    ("ForeArm", "Arm", (0.0, -0.28, 0.0)),
    ("Hand", "ForeArm", (0.0, -0.24, 0.0)),
    ("FingerBase", "Hand", (0.0, -0.05, 0.0)),
    ("HandIndex1", "FingerBase", (0.0, -0.06, 0.0)),
    ("Thumb", "Hand", (-0.04, -0.05, 0.02)),
)
_TRUNK = (
    ("LowerBack", "Hips", (0.0, 0.02, 0.0)),
    ("Spine", "LowerBack", (0.0, 0.12, 0.0)),
    ("Spine1", "Spine", (0.0, 0.13, 0.0)),
    ("Neck", "Spine1", (0.0, 0.21, 0.0)),
    ("Neck1", "Neck", (0.0, 0.06, 0.01)),
    ("Head", "Neck1", (0.0, 0.06, 0.01)),
)
STANDING = 0.96  # height of the hips, metres


def person() -> Skeleton:
    """A skeleton of 31 joints named as CMU's, facing +Z at rest, arms hanging."""
    rows = [("Hips", "", (0.0, STANDING, 0.0)), *_TRUNK]
    for side, mirror in (("Left", 1.0), ("Right", -1.0)):
        own = {name for name, _, _ in (*_LEG, *_ARM)}
        for name, parent, (x, y, z) in (*_LEG, *_ARM):
            rows.append((side + name, side + parent if parent in own else parent, (mirror * x, y, z)))
    names = tuple(row[0] for row in rows)
    parents = tuple(names.index(row[1]) if row[1] else -1 for row in rows)
    return Skeleton(names, parents, np.array([row[2] for row in rows]))


def walk(name: str = "walk", seconds: float = 4.0, fps: float = 60.0, *, pace: float = 1.0, turn: float = 0.0) -> Clip:
    """Someone who strides along +Z, turned by ``turn`` radians: swinging limbs, a root that travels 1.2 m a second."""
    skeleton = person()
    n = round(seconds * fps)
    phase = 2 * np.pi * pace * np.arange(n) / fps
    rotations = np.zeros((n, skeleton.n_joints, 4))
    rotations[..., 0] = 1
    for side, shift in (("Left", 0.0), ("Right", np.pi)):
        swing = np.sin(phase + shift)
        bend = {
            "UpLeg": -0.5 * swing,
            "Leg": 0.45 + 0.45 * np.cos(phase + shift),
            "Arm": 0.5 * swing,
            "ForeArm": -0.4 + 0 * phase,
        }
        for part, angle in bend.items():
            rotations[:, skeleton.index(side + part)] = quat.from_rotvec(angle[:, None] * [1.0, 0.0, 0.0])
    rotations[:, 0] = quat.from_yaw(np.full(n, turn))
    travel = 1.2 * pace * np.arange(n) / fps
    root = np.stack([np.sin(turn) * travel, STANDING + 0.02 * np.cos(2 * phase), np.cos(turn) * travel], axis=-1)
    return Clip(name, skeleton, fps, root.astype(np.float32), rotations.astype(np.float32))


def walkers(names: tuple[str, ...] = ("walk", "stroll", "rush"), *, name: str = "walkers", **options) -> Dataset:
    """A data set of walks at different paces and in different directions."""
    clips = (walk(n, pace=0.8 + 0.2 * (k % 5), turn=0.7 * k, **options) for k, n in enumerate(names))
    return Dataset(name, tuple(clips))
