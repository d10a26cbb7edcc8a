"""The recorded motions behind the demo (core/data/demo_motions.npz), as smooth curves that can be read at any time."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

import numpy as np
from scipy.interpolate import CubicSpline

from core.demo.performers import Performer, skeleton_of
from core.editing.contacts import foot_contacts, sole_points
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

FPS = 60.0
JOINTS = (
    *("Hips", "Chest", "Neck", "RightUpLeg", "RightLeg", "RightFoot", "RightArm", "RightForeArm"),
    *("LeftUpLeg", "LeftLeg", "LeftFoot", "LeftArm", "LeftForeArm"),
)
HINGES = ("RightLeg", "RightForeArm", "LeftLeg", "LeftForeArm")
_MIRRORED = [JOINTS.index(n.replace("Left", "?").replace("Right", "Left").replace("?", "Right")) for n in JOINTS]
_GROUNDLESS = ("crawl", "getup_facedown", "getup_faceup")  # too little standing to read the floor off


@dataclass(frozen=True, eq=False)
class Motion:
    """Pelvis positions ``(n, 3)``, metres of the source's person, and joint rotations ``(n, 13, 4)``."""

    pelvis: np.ndarray
    rotations: np.ndarray

    def __len__(self) -> int:
        return len(self.pelvis)

    def mirrored(self) -> Motion:
        """Left and right exchanged."""
        return Motion(self.pelvis * [-1, 1, 1], self.rotations[:, _MIRRORED] * [1, 1, -1, -1])


@lru_cache(maxsize=1)
def sources() -> dict[str, tuple[np.ndarray, Motion]]:
    """All recorded motions: name -> (times ``(n,)`` in seconds, motion as recorded)."""
    with (
        files("core").joinpath("data", "demo_motions.npz").open("rb") as file,
        np.load(file, allow_pickle=False) as data,
    ):
        names, starts, differences = data["names"], data["starts"], data["rows"]
    rows = np.cumsum(differences, axis=0, dtype=np.int16)
    motions = {}
    for name, start, end in zip(names, starts, starts[1:], strict=False):
        row = rows[start:end].astype(np.float64)
        times = np.r_[0, np.cumsum(row[:-1, 0] * 1e-4)]
        column, rotations = 4, []
        for joint in JOINTS:
            vector = np.zeros((len(row), 3))
            width = 1 if joint in HINGES else 3
            vector[:, :width] = row[:, column : column + width] * (np.pi / 32767)
            column += width
            rotations.append(quat.from_rotvec(vector))
        pelvis = row[:, 1:4] * 1e-4
        pelvis[:, [0, 2]] -= pelvis[0, [0, 2]]
        motions[str(name)] = times, Motion(pelvis, quat.continuous(np.stack(rotations, axis=1)))
    return motions


@lru_cache(maxsize=64)
def curve(name: str) -> tuple[CubicSpline, float]:
    """A recorded motion as a spline over seconds, on the floor, and its duration in seconds."""
    times, motion = sources()[name]
    spline = CubicSpline(times, np.c_[motion.pelvis, motion.rotations.reshape(len(motion), -1)])
    if name not in _GROUNDLESS:
        spline.c[-1, :, 1] -= _ground(_read(spline, np.arange(0, times[-1], 1 / FPS)))
    return spline, float(times[-1])


def sample(name: str, times: np.ndarray) -> Motion:
    """The recorded motion ``name`` at ``times`` ``(n,)``, seconds."""
    return _read(curve(name)[0], times)


def to_clip(motion: Motion, performer: Performer, name: str) -> Clip:
    """The motion on a performer's skeleton at :data:`FPS`: the pelvis' path scales with the legs, the neck's turn is
    shared by neck and head."""
    skeleton = skeleton_of(performer)
    rotations = np.zeros((len(motion), skeleton.n_joints, 4), np.float32)
    rotations[..., 0] = 1
    for k, joint in enumerate(JOINTS):
        rotations[:, skeleton.index(joint)] = motion.rotations[:, k]
    half = quat.slerp(np.array([1.0, 0, 0, 0]), motion.rotations[:, JOINTS.index("Neck")], 0.5)
    rotations[:, skeleton.index("Neck")] = rotations[:, skeleton.index("Head")] = half
    return Clip(name, skeleton, FPS, (motion.pelvis * performer.measure("legs")).astype(np.float32), rotations)


def _read(spline: CubicSpline, times: np.ndarray) -> Motion:
    values = spline(times)
    return Motion(values[:, :3], quat.normalise(values[:, 3:].reshape(len(values), len(JOINTS), 4)))


def _ground(motion: Motion) -> float:
    """Where the floor is in a recorded motion: the lower fifth of the lowest sole point while a foot stands."""
    clip = to_clip(motion, Performer("source", size=1.0), "source")
    positions = joint_positions(clip)
    standing = foot_contacts(clip, positions=positions).any(1)
    left, right = sole_points(clip)
    lowest = positions[:, [*left, *right], 1].min(1)
    return float(np.percentile(lowest[standing], 20)) if standing.sum() > 5 else 0.0


def standing_pose() -> Motion:
    """A relaxed stance (the frame before the backflip) as a motion of one frame."""
    return sample("backflip", np.zeros(1))
