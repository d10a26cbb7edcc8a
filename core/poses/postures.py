"""Postures as joint positions: relative to the root, facing one way, on a body of one size (MAP section 3.1)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray
from core.errors import AnalysisError
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import forward_kinematics, resample
from core.mocap.skeleton import Skeleton
from core.poses.features import SPEED_FPS, posture_joints
from core.progress import Report, silent

STANDARD_HEIGHT = 1.7
"""Metres: positions are scaled to a body of this height."""


@dataclass(frozen=True, eq=False)
class Postures:
    """Postures of many clips, one after the other, at one frame rate.

    values: ``(n, n_joints, 3)`` float32, metres, relative to the pelvis, turned about y so that the body faces +z,
    scaled to STANDARD_HEIGHT. joints: their names; roles: their canonical names, "" where the anatomy has none; sides:
    "left", "right" or "centre"; parents: per joint the index of the joint its bone comes from, -1 for the pelvis, which
    itself is not among them. yaw: ``(n,)`` heading in radians; velocity: ``(n, 2)`` m/s over the ground, straight ahead
    and to the body's left, of the real body. clip_starts: ``(n_clips + 1,)``; clips, clip_fps, clip_frames: names,
    rates and numbers of frames of the clips; fps: rate of ``values``.
    """

    values: np.ndarray
    joints: tuple[str, ...]
    roles: tuple[str, ...]
    sides: tuple[str, ...]
    parents: tuple[int, ...]
    yaw: np.ndarray
    velocity: np.ndarray
    clip_starts: np.ndarray
    clips: tuple[str, ...]
    clip_fps: tuple[float, ...]
    clip_frames: tuple[int, ...]
    fps: float

    @property
    def vectors(self) -> np.ndarray:
        """The postures as rows ``(n, 3 n_joints)``."""
        return self.values.reshape(len(self.values), -1)

    def frame_of(self, clip: int, k: float) -> int:
        """Frame of clip number ``clip``, at its own rate, that posture ``k`` of that clip was taken from."""
        return min(round(k * self.clip_fps[clip] / self.fps), self.clip_frames[clip] - 1)


def postures_of(dataset: Dataset, *, analysis_fps: float = 30, report: Report = silent) -> Postures:
    """The postures of all clips, by the order of their names, at ``analysis_fps``.

    Where all skeletons have the same posture joints these are taken, else the canonical joints that all have. Raises
    ValueError for an empty dataset, a rate that is not positive, or skeletons without a joint in common.
    """
    clips = sorted(dataset.clips, key=lambda clip: clip.name)
    if not clips:
        raise AnalysisError("the dataset has no clips, so there are no postures")
    if not analysis_fps > 0:
        raise ValueError(f"analysis_fps must be positive, not {analysis_fps}")
    chosen = posture_joints([clip.skeleton for clip in clips])
    values, yaws, velocities = [], [], []
    for k, clip in enumerate(clips):
        sampled = resample(clip, analysis_fps)
        posture, yaw, velocity = clip_postures(sampled, chosen[clip.skeleton])
        values.append(posture)
        yaws.append(yaw)
        velocities.append(velocity)
        report("postures", (k + 1) / len(clips))
    first = clips[0].skeleton
    anatomy, indices = find_anatomy(first), tuple(chosen[first].values())
    canonical = {joint: name for name, joint in anatomy.joints.items()}
    return Postures(
        values=np.concatenate(values),
        joints=tuple(chosen[first]),
        roles=tuple(canonical.get(joint, "") for joint in indices),
        sides=tuple(anatomy.side(joint) for joint in indices),
        parents=bones_among(first, indices),
        yaw=np.concatenate(yaws),
        velocity=np.concatenate(velocities),
        clip_starts=np.concatenate([[0], np.cumsum([len(v) for v in values])]).astype(np.int64),
        clips=tuple(clip.name for clip in clips),
        clip_fps=tuple(float(clip.fps) for clip in clips),
        clip_frames=tuple(clip.n_frames for clip in clips),
        fps=float(analysis_fps),
    )


def bones_among(skeleton: Skeleton, joints: tuple[int, ...]) -> tuple[int, ...]:
    """For each of the joints the place, among them, of the next one above it; -1 where that is the pelvis."""
    place = {joint: k for k, joint in enumerate(joints)}
    parents = []
    for joint in joints:
        above = skeleton.parents[joint]
        while above > 0 and above not in place:
            above = skeleton.parents[above]
        parents.append(place.get(above, -1))
    return tuple(parents)


def clip_postures(clip: Clip, joints: dict[str, int]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Postures ``(n, n_joints, 3)`` float32, headings ``(n,)`` and velocities ``(n, 2)`` of a clip, at its rate.

    Everything as in :class:`Postures`.
    """
    anatomy = find_anatomy(clip.skeleton)
    positions, world = forward_kinematics(clip)
    yaw = _heading(positions, world, anatomy.joints)
    offsets = positions[:, list(joints.values())] - positions[:, :1]
    turned = quat.rotate(quat.from_yaw(-yaw)[:, None], offsets.astype(np.float64))
    scaled = turned * (STANDARD_HEIGHT / anatomy.body_height)
    return scaled.astype(np.float32), yaw, _ground_velocity(clip, yaw)


def _ground_velocity(clip: Clip, yaw: np.ndarray) -> np.ndarray:
    """Velocity over the ground ``(n, 2)`` float32 in m/s: ahead and to the left of where the body faces."""
    half = max(1, round(clip.fps / SPEED_FPS))
    at = np.arange(clip.n_frames)
    before, after = np.maximum(at - half, 0), np.minimum(at + half, clip.n_frames - 1)
    travel = np.asarray(clip.root_positions, np.float64)
    steps = (travel[after] - travel[before]) * (clip.fps / np.maximum(after - before, 1))[:, None]
    own = quat.rotate(quat.from_yaw(-yaw), steps)
    return own[:, [2, 0]].astype(np.float32)


def _heading(positions: FloatArray, world: np.ndarray, joints: Mapping[str, int]) -> np.ndarray:
    """Which way the body faces, ``(n,)`` radians about y from +z: square to the line between the hips."""
    if "left_hip" not in joints or "right_hip" not in joints:
        return quat.split_yaw(world[:, 0])[0]
    across = positions[:, joints["left_hip"]] - positions[:, joints["right_hip"]]
    return np.arctan2(-across[:, 2], across[:, 0])
