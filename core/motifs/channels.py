"""A clip as a matrix of numbers and back, in a unit that counts alike for every column: how far it moves the body.

Columns: root position (x, height, z), heading, tilt of the root (a quaternion, twice: a body may turn head over heels),
then three for each joint that turns: a rotation vector about its mean. Each is scaled to centimetres, the root mean
square way of the joints at the mean posture for a small change of it, so that the nearest matrix is about the nearest
motion; the scales follow from the mean posture.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from core.poses.features import CMU_UNIT

_LEAST = 0.5  # centimetres a radian: joints that move nothing that is compared (fingers) count at least so much
_ROOT = 8  # columns of the root
_NO_TILT = np.array([2.0, 0, 0, 0])


@dataclass(frozen=True, eq=False)
class Channels:
    """How clips of one skeleton become numbers; made by :func:`channels_of`.

    joints: indices of the joints that turn, the root first; rest: their mean rotations ``(n_joints, 4)``, the root's
    without heading; still: rotations ``(n_skeleton_joints, 4)`` of all joints, for those that never turn.
    """

    skeleton: Skeleton
    joints: tuple[int, ...]
    rest: np.ndarray
    still: np.ndarray

    @property
    def width(self) -> int:
        """Number of columns."""
        return _ROOT + 3 * (len(self.joints) - 1)

    def encode(self, clip: Clip) -> np.ndarray:
        """``(n_frames, width)`` float64, centimetres as the module explains; shifting joints are left out."""
        rotations = np.asarray(clip.rotations[:, list(self.joints)], np.float64)
        yaw, rotations[:, 0] = _split(rotations[:, 0], self.rest[0])
        turns = _one_side(quat.multiply(quat.conjugate(self.rest), rotations))
        vectors = _vectors(turns[:, 1:]).reshape(clip.n_frames, -1)
        columns = [clip.root_positions, yaw, 2 * turns[:, 0] - _NO_TILT, vectors]
        values: np.ndarray = np.column_stack(columns) * self.scales
        return values

    def decode(self, values: np.ndarray, name: str = "rebuilt", fps: float = 30.0) -> Clip:
        """The clip that ``(n_frames, width)`` values stand for; inverse of :meth:`encode` (float32)."""
        return self._clip(values / self.scales, name, fps)

    def positions(self, values: np.ndarray) -> np.ndarray:
        """Root and posture joints of ``(n, width)`` values in the world: ``(n, n_points, 3)``, metres."""
        return joint_positions(self.decode(values))[:, self._points]

    def pose_distance(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """Distance of poses as MMG (section 3.2) measures it, ``(n,)``: joint angles, pitch and roll in degrees, root
        height in CMU's unit; place and heading do not count, nor do speeds."""
        distance: np.ndarray = np.linalg.norm((a - b) * self._pose_units, axis=1)
        return distance

    @cached_property
    def scales(self) -> np.ndarray:
        """Centimetres per metre or radian of each column, ``(width,)``."""
        small = 0.01 * np.eye(self.width)
        postures = np.concatenate([np.zeros((1, self.width)), small])
        points = joint_positions(self._clip(postures, "scales", 1.0))[:, self._points].astype(np.float64)
        way = np.sqrt(((points[1:] - points[0]) ** 2).sum(-1).mean(1))
        way[4:_ROOT] = np.sqrt((way[5:_ROOT] ** 2).mean())  # at rest the first of a quaternion does nothing
        scales: np.ndarray = np.maximum(100 * way / 0.01, _LEAST)
        return scales

    @cached_property
    def _points(self) -> list[int]:
        return [0, *find_anatomy(self.skeleton).posture_joints]

    @cached_property
    def _pose_units(self) -> np.ndarray:
        units: np.ndarray = np.zeros(self.width)
        units[1] = 1 / CMU_UNIT
        units[4:_ROOT] = np.degrees(1)
        for k, joint in enumerate(self.joints[1:]):
            if joint in self._points:
                units[_ROOT + 3 * k : _ROOT + 3 * k + 3] = np.degrees(1)
        units = units / self.scales
        return units

    def _clip(self, raw: np.ndarray, name: str, fps: float) -> Clip:
        n = len(raw)
        rotations = np.tile(self.still, (n, 1, 1)).astype(np.float64)
        tilt = raw[:, 4:_ROOT] + _NO_TILT
        tilt[(tilt**2).sum(1) < 1e-12] = _NO_TILT
        tilt = quat.normalise(tilt)
        turns = np.concatenate([tilt[:, None], quat.from_rotvec(raw[:, _ROOT:].reshape(n, -1, 3))], axis=1)
        turned = quat.multiply(self.rest, turns)
        turned[:, 0] = quat.multiply(quat.from_yaw(raw[:, 3]), turned[:, 0])
        rotations[:, list(self.joints)] = turned
        return Clip(name, self.skeleton, fps, raw[:, :3].astype(np.float32), rotations.astype(np.float32))


def channels_of(clips: Sequence[Clip]) -> Channels:
    """The channels of clips of one skeleton: the joints that turn in any of them, about their mean rotations.

    Raises ValueError for no clips or for several skeletons.
    """
    if len({clip.skeleton for clip in clips}) != 1:
        raise ValueError("channels are made for clips of one skeleton")
    still = np.array(clips[0].rotations[0], np.float64)
    alike = [np.abs((np.asarray(clip.rotations) * still).sum(-1)).min(0) for clip in clips]
    turning = np.flatnonzero(np.min(alike, axis=0) < 1 - 1e-6)
    joints = (0, *(int(j) for j in turning if j))
    moments = 0
    for clip in clips:
        q = np.asarray(clip.rotations[:, list(joints)], np.float64)
        q[:, 0] = quat.split_yaw(q[:, 0])[1]
        moments = moments + np.einsum("fji,fjk->jik", q, q)
    return Channels(clips[0].skeleton, joints, np.linalg.eigh(moments)[1][..., -1], still)


def _split(q: np.ndarray, rest: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Heading ``(n,)`` in radians, unwrapped, and what is left of the root's rotations ``(n, 4)``.

    Upside down there is no heading: it passes evenly from the last to the next there is.
    """
    turned = quat.multiply(q, quat.conjugate(rest))
    yaw = quat.split_yaw(turned)[0]
    known = np.flatnonzero(np.hypot(turned[:, 0], turned[:, 2]) > 0.5)
    yaw = np.interp(np.arange(len(q)), known, np.unwrap(yaw[known])) if len(known) else np.zeros(len(q))
    return yaw, quat.multiply(quat.from_yaw(-yaw), q)


def _one_side(q: np.ndarray) -> np.ndarray:
    """Signs of ``(n, n_joints, 4)`` without jumps: each joint keeps to the side of the double cover where it is nearer
    to no turn most of the time."""
    q = quat.continuous(q)
    return np.where(q[..., 0].sum(0)[:, None] < 0, -q, q)


def _vectors(q: np.ndarray) -> np.ndarray:
    """Rotation vectors ``(..., 3)``, radians; of more than half a turn where the sign of ``q`` says so."""
    length = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2 * np.arctan2(length, q[..., :1])
    return q[..., 1:] * np.where(length > 1e-8, angle / np.maximum(length, 1e-8), 2.0)
