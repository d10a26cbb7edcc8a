"""What words are read from: a clip's joints as heights, speeds, angles and reaches, in units of the body.

Everything comes from joint positions, so recordings of points, whose rotations mean little, read as others do. Lengths
are in statures, times in seconds; frames are 30 a second whatever the clip has.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

RATE = 30.0
SIDES = ("left", "right")
NEEDS: Mapping[str, tuple[str, ...]] = {
    "body": ("pelvis",),
    "hips": ("left_hip", "right_hip"),
    "arms": ("left_shoulder", "left_wrist", "right_shoulder", "right_wrist"),
    "elbows": ("left_elbow", "right_elbow"),
    "legs": ("left_hip", "left_ankle", "right_hip", "right_ankle"),
    "knees": ("left_knee", "right_knee"),
    "head": ("head",),
}
"""Parts that words may need -> the joints that make them."""


@dataclass(frozen=True, eq=False)
class Signals:
    """One clip for the words.

    joints: canonical name -> places ``(n, 3)`` in statures at RATE, smoothed over a tenth of a second. parts: those of
    NEEDS that the body has.
    """

    joints: Mapping[str, np.ndarray]
    parts: frozenset[str]

    @property
    def n(self) -> int:
        """Number of frames."""
        return len(self.joints["pelvis"])

    @cached_property
    def floor(self) -> float:
        """Height of the floor: where the feet (all joints, without feet) are at their lowest."""
        feet = [self.joints[f"{s}_{j}"][:, 1] for s in SIDES for j in ("ankle", "toe") if f"{s}_{j}" in self.joints]
        lowest = np.min(feet or [at[:, 1] for at in self.joints.values()], axis=0)
        return float(np.percentile(lowest, 5))

    @cached_property
    def leg(self) -> float:
        """Length of a leg, in statures: the usual share where legs are not known."""
        if not {"legs", "knees"} <= self.parts:
            return 0.49
        bones = [("hip", "knee"), ("knee", "ankle")]
        lengths = [
            np.median(length(self.joints[f"{s}_{a}"] - self.joints[f"{s}_{b}"])) for s in SIDES for a, b in bones
        ]
        return float(sum(lengths)) / 2

    def arm(self, side: str) -> float:
        """Length of an arm."""
        s, e, w = (self.joints.get(f"{side}_{j}") for j in ("shoulder", "elbow", "wrist"))
        if s is None or w is None:
            return 0.33
        if e is None:
            return max(float(np.percentile(length(w - s), 95)), 0.1)
        return max(float(np.median(length(e - s)) + np.median(length(w - e))), 0.1)

    @cached_property
    def yaw(self) -> np.ndarray:
        """Heading ``(n,)`` in radians, growing to the left: across hips and shoulders."""
        across = np.zeros((self.n, 3))
        for pair in ("hip", "shoulder"):
            if {f"left_{pair}", f"right_{pair}"} <= set(self.joints):
                across += self.joints[f"left_{pair}"] - self.joints[f"right_{pair}"]
        if not np.abs(across).max() > 1e-6:
            return np.zeros(self.n)
        return np.unwrap(np.arctan2(-across[:, 2], across[:, 0]))

    @cached_property
    def turning(self) -> np.ndarray:
        """Turning rate ``(n,)`` in radians a second, to the left."""
        return mean_over(np.gradient(self.yaw) * RATE if self.n > 1 else np.zeros(1), 0.35)

    @cached_property
    def velocity(self) -> np.ndarray:
        """Velocity of the pelvis ``(n, 3)`` in statures a second: left, up, forward."""
        return turned(speeds(self.joints["pelvis"]), self.yaw)

    @cached_property
    def speed(self) -> np.ndarray:
        """Speed over the ground ``(n,)``, averaged over half a second."""
        return length(mean_over(self.velocity[:, [0, 2]], 0.5))

    @cached_property
    def pelvis(self) -> np.ndarray:
        """Height of the hips over the floor ``(n,)``, 1 where one stands upright."""
        hips = [self.joints[f"{s}_hip"][:, 1] for s in SIDES] if "hips" in self.parts else [self.joints["pelvis"][:, 1]]
        height = np.mean(hips, axis=0) - self.floor
        ankle = 0.045
        return np.asarray(height / (self.leg + ankle))

    @cached_property
    def trunk(self) -> np.ndarray:
        """Where the trunk points ``(n, 3)``: a unit vector from the pelvis, left, up and forward."""
        top = next((self.joints[j] for j in ("neck", "head", "chest", "spine") if j in self.joints), None)
        if "arms" in self.parts:
            top = (self.joints["left_shoulder"] + self.joints["right_shoulder"]) / 2
        if top is None:
            return np.tile([0.0, 1.0, 0.0], (self.n, 1))
        along = turned(top - self.joints["pelvis"], self.yaw)
        return np.asarray(along / np.maximum(length(along)[:, None], 1e-6))

    def local(self, joint: str, about: str = "pelvis") -> np.ndarray:
        """Place of a joint ``(n, 3)`` seen from another: left, up, forward."""
        return turned(self.joints[joint] - self.joints[about], self.yaw)

    def hand(self, side: str) -> np.ndarray:
        """Place of a hand ``(n, 3)`` seen from its shoulder in arm's lengths: left, up, forward."""
        return self.local(f"{side}_wrist", f"{side}_shoulder") / self.arm(side)

    def hand_speed(self, side: str) -> np.ndarray:
        """Speed of a hand seen from its shoulder ``(n,)``, arm's lengths a second."""
        return mean_over(length(speeds(self.hand(side))), 0.1)

    def foot_height(self, side: str) -> np.ndarray:
        """Height of an ankle over where the lower of both is at its lowest ``(n,)``."""
        lowest = min(float(np.percentile(self.joints[f"{s}_ankle"][:, 1], 5)) for s in SIDES)
        return np.asarray(self.joints[f"{side}_ankle"][:, 1] - lowest)

    def foot_speed(self, side: str) -> np.ndarray:
        """Speed of an ankle over the ground ``(n,)``."""
        return mean_over(length(speeds(self.joints[f"{side}_ankle"])), 0.1)

    def bend(self, side: str, joint: str) -> np.ndarray:
        """Angle in degrees ``(n,)`` by which a knee or an elbow is bent: 0 for a straight limb."""
        above, below = ("hip", "ankle") if joint == "knee" else ("shoulder", "wrist")
        a, b, c = (self.joints[f"{side}_{j}"] for j in (above, joint, below))
        upper, lower = b - a, c - b
        cosine = (upper * lower).sum(1) / np.maximum(length(upper) * length(lower), 1e-9)
        return np.asarray(np.degrees(np.arccos(np.clip(cosine, -1, 1))))

    @cached_property
    def motion(self) -> np.ndarray:
        """Mean speed of hands, feet and head seen from the pelvis ``(n,)``, statures a second."""
        ends = [j for j in ("left_wrist", "right_wrist", "left_ankle", "right_ankle", "head") if j in self.joints]
        if not ends:
            return self.speed
        return np.asarray(np.mean([mean_over(length(speeds(self.local(j))), 0.2) for j in ends], axis=0))


def signals_of(clip: Clip) -> Signals:
    """A clip for the words: ``joints`` (n, 3) at RATE."""
    anatomy = find_anatomy(clip.skeleton)
    positions = joint_positions(clip).astype(np.float64) / max(anatomy.body_height, 1e-6)
    n = max(1, int((clip.n_frames - 1) * RATE / clip.fps + 1e-6) + 1)
    at = np.arange(n) * clip.fps / RATE
    low = np.minimum(at.astype(np.int64), clip.n_frames - 1)
    high, rest = np.minimum(low + 1, clip.n_frames - 1), (at - np.floor(at))[:, None]
    joints = {}
    for name, j in anatomy.joints.items():
        joints[name] = mean_over(positions[low, j] * (1 - rest) + positions[high, j] * rest, 0.1)
    parts = frozenset(part for part, need in NEEDS.items() if all(joint in joints for joint in need))
    return Signals(joints, parts if anatomy.body != "other" else frozenset())


def length(vectors: np.ndarray) -> np.ndarray:
    """Lengths of vectors ``(n, d)``."""
    return np.asarray(np.linalg.norm(vectors, axis=-1))


def speeds(places: np.ndarray) -> np.ndarray:
    """Velocities of places ``(n, d)``, a second."""
    return np.gradient(places, axis=0) * RATE if len(places) > 1 else np.zeros_like(places)


def turned(vectors: np.ndarray, yaw: np.ndarray) -> np.ndarray:
    """Vectors ``(n, 3)`` of the world as seen by a body of this heading ``(n,)``: left, up, forward."""
    cos, sin = np.cos(yaw), np.sin(yaw)
    x, y, z = vectors[:, 0], vectors[:, 1], vectors[:, 2]
    return np.column_stack([cos * x - sin * z, y, sin * x + cos * z])


def mean_over(values: np.ndarray, seconds: float) -> np.ndarray:
    """Values ``(n, ...)`` averaged over so many seconds around each frame."""
    half = max(0, round(seconds * RATE / 2))
    if half == 0 or len(values) < 2:
        return np.asarray(values, float)
    sums = np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0, dtype=float)])
    at = np.arange(len(values))
    first, last = np.maximum(at - half, 0), np.minimum(at + half + 1, len(values))
    return np.asarray((sums[last] - sums[first]) / (last - first).reshape(-1, *[1] * (values.ndim - 1)))


def most_over(values: np.ndarray, seconds: float) -> np.ndarray:
    """The greatest of values ``(n,)`` within so many seconds around each frame."""
    half = max(0, round(seconds * RATE / 2))
    padded = np.pad(values, half, mode="edge")
    return np.asarray(np.lib.stride_tricks.sliding_window_view(padded, 2 * half + 1).max(1))


def above(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """0 where values ``(n,)`` are at ``low`` or less, 1 from ``high`` on, even between; ``low`` may be the greater."""
    return np.clip((np.asarray(values, float) - low) / (high - low), 0, 1)


def all_of(*scores: np.ndarray) -> np.ndarray:
    """The least of scores ``(n,)`` in every frame."""
    return np.asarray(np.min(np.broadcast_arrays(*scores), axis=0))


def any_of(*scores: np.ndarray) -> np.ndarray:
    """The greatest of scores ``(n,)`` in every frame."""
    return np.asarray(np.max(np.broadcast_arrays(*scores), axis=0))


def change(values: np.ndarray, seconds: float) -> np.ndarray:
    """How much values ``(n,)`` grow over so many seconds around each frame."""
    half = max(1, round(seconds * RATE / 2))
    at = np.arange(len(values))
    return np.asarray(values[np.minimum(at + half, len(values) - 1)] - values[np.maximum(at - half, 0)])


def swings(values: np.ndarray, seconds: float = 1.6) -> np.ndarray:
    """How often values ``(n,)`` swing to and fro a second, around each frame, however little."""
    centred = values - mean_over(values, seconds)
    crossed = np.concatenate([[0.0], (np.diff(np.sign(centred)) != 0).astype(float)])
    return mean_over(crossed, seconds) * RATE / 2


def swing_size(values: np.ndarray, seconds: float = 1.2) -> np.ndarray:
    """How far values ``(n,)`` swing around their mean (standard deviation) around each frame."""
    centred = values - mean_over(values, seconds)
    return np.asarray(np.sqrt(mean_over(centred**2, seconds)))
