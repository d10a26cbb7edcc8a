"""Describes frames part by part, each leaf of the body independently of the others (PCR section 3.1).

Each leaf is described by where its bones point, seen from the part it hangs from: arms and head from the chest, chest
and legs from the pelvis, hands from the forearm, feet from the shin. So a leaf depends on its own joints alone, as
joint angles do, and yet means the same on every skeleton. What is left over is the root's: how it travels.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics, resample
from core.poses.body_parts import LEAVES

_SIZES = {"head": 6, "torso": 6, "arm": 6, "hand": 3, "leg": 6, "foot": 3}
_ENDS = np.cumsum([0, *(_SIZES[leaf.split("_")[-1]] for leaf in LEAVES)])
BLOCKS: Mapping[str, slice] = {leaf: slice(int(_ENDS[k]), int(_ENDS[k + 1])) for k, leaf in enumerate(LEAVES)}
"""Leaf -> its columns: components of one or two unit vectors."""

N_COLUMNS = int(_ENDS[-1])
ROOT = ("velocity left", "velocity forward", "velocity up", "turning")
"""Columns of the root, after those of the parts: m/s of a body of 1.7 m, rad/s."""

STANDARD_HEIGHT = 1.7  # metres
_STEP = 1 / 30  # seconds either side of a frame, over which velocities are taken
_SMOOTH = 1 / 10  # seconds either side of a frame that it is averaged with, less and less: jitter is no motion
_SPARSE = 3.0  # frames a second that are plenty for a mean


@dataclass(frozen=True, eq=False)
class Axes:
    """How a skeleton's joints sit in its body: per joint name a frame (3, 3), rows in that joint's coordinates.

    "pelvis", "chest", "head": left, up, forward. "left_elbow", "left_knee", ...: along the bone, and the way it bends.
    "left_wrist", "left_ankle", ...: along hand or foot. Leaves whose joints the skeleton lacks are not in ``leaves``.
    """

    frames: Mapping[str, np.ndarray]
    leaves: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class PartFrames:
    """Frames in parts, at one rate.

    values: ``(n, N_COLUMNS)`` float32, see BLOCKS; zero in leaves that the skeleton lacks. root: ``(n, 4)`` float32,
    see ROOT. leaves: those it has.
    """

    values: np.ndarray
    root: np.ndarray
    leaves: tuple[str, ...]


def find_axes(clips: Iterable[Clip]) -> Axes:
    """The axes of a skeleton, from clips that have it (or one whose joints have the same names).

    Bones give most of them; which way is up for a pelvis, or a straight arm bends, is the mean over the clips.
    """
    sums: dict[str, np.ndarray] = {}
    leaves: tuple[str, ...] = ()
    for clip in clips:
        step = max(1, round(clip.fps / _SPARSE))
        pose = _Pose(
            Clip(
                clip.name,
                clip.skeleton,
                clip.fps / step,
                clip.root_positions[::step],
                clip.rotations[::step],
                {j: t[::step] for j, t in clip.translations.items()},
            )
        )
        leaves = pose.leaves
        for name, vectors in pose.raw_axes().items():
            sums[name] = sums.get(name, 0.0) + vectors.sum(0)
    frames = {name: _orthonormal(total[0], total[1]) for name, total in sums.items()}
    return Axes(frames, leaves if "pelvis" in frames and "chest" in frames else ())


def part_frames(clip: Clip, axes: Axes, fps: float) -> PartFrames:
    """The frames of a clip in parts, at ``fps``. Raises ValueError where ``fps`` is not positive."""
    pose = _Pose(resample(clip, fps))
    values, root = np.zeros((pose.n, N_COLUMNS), np.float32), np.zeros((pose.n, len(ROOT)), np.float32)
    if axes.leaves:
        for leaf in axes.leaves:
            values[:, BLOCKS[leaf]] = pose.leaf(leaf, axes.frames)
        root[:] = pose.root(axes.frames["pelvis"])
    return PartFrames(values, root, axes.leaves)


def smoothed(values: np.ndarray, fps: float) -> np.ndarray:
    """Frames ``(n, d)`` averaged with their neighbours up to 1/10 s away, by weights that fall evenly to nothing."""
    reach = max(1, round(fps * _SMOOTH))
    total, weight = values * reach, np.full((len(values), 1), reach, np.float32)
    for k in range(1, min(reach, len(values))):
        total[k:] += (reach - k) * values[:-k]
        total[:-k] += (reach - k) * values[k:]
        weight[k:] += reach - k
        weight[:-k] += reach - k
    return total / weight


class _Pose:
    """World positions and rotations of a clip's canonical joints, and what is read off them."""

    def __init__(self, clip: Clip):
        self.clip, self.n = clip, clip.n_frames
        anatomy = find_anatomy(clip.skeleton)
        self.joints, self.height = anatomy.joints, max(anatomy.body_height, 1e-6)
        positions, rotations = forward_kinematics(clip)
        self.at = {name: positions[:, j].astype(np.float64) for name, j in self.joints.items()}
        self.turn = {name: _matrices(rotations[:, j].astype(np.float64)) for name, j in self.joints.items()}
        self.at.setdefault("chest", self.at.get("spine", self.at["pelvis"]))
        self.turn.setdefault("chest", self.turn.get("spine", self.turn["pelvis"]))

    @property
    def leaves(self) -> tuple[str, ...]:
        """The leaves whose joints are there."""
        need = {"head": ("head",), "torso": (), "arm": ("shoulder", "elbow", "wrist"), "hand": ("elbow", "wrist")}
        need |= {"leg": ("hip", "knee", "ankle"), "foot": ("knee", "ankle")}
        features = []
        for leaf in LEAVES:
            side, _, part = leaf.rpartition("_")
            if all((f"{side}_{name}" if side else name) in self.joints for name in need[part]):
                features.append(leaf)
        return tuple(features)

    def raw_axes(self) -> dict[str, np.ndarray]:
        """Joint -> ``(n, 2, 3)``: the two directions its frame is made of, in its own coordinates."""
        blocks: dict[str, np.ndarray] = {}
        top = next((name for name in ("neck", "head") if name in self.joints), None)
        if not {"left_hip", "right_hip", "left_shoulder", "right_shoulder"} <= set(self.joints) or top is None:
            return {}
        hips, shoulders = self._bone("right_hip", "left_hip"), self._bone("right_shoulder", "left_shoulder")
        blocks["pelvis"] = self._seen("pelvis", hips, self._bone("pelvis", top))
        blocks["chest"] = self._seen("chest", shoulders, self._bone("chest" if top == "head" else "pelvis", top))
        if "head" in self.joints:
            blocks["head"] = self._seen("head", shoulders, self._bone("pelvis", top))
        for side in ("left", "right"):
            for upper, middle, lower, tip in (("shoulder", "elbow", "wrist", None), ("hip", "knee", "ankle", "toe")):
                names = [f"{side}_{name}" for name in (upper, middle, lower)]
                if not set(names) <= set(self.joints):
                    continue
                above, along = self._bone(*names[:2]), self._bone(*names[1:])
                blocks[names[1]] = self._seen(names[1], along, above)
                tip = f"{side}_{tip}"
                points = self._bone(names[2], tip) if tip in self.joints else along
                if np.linalg.norm(points, axis=1).max() < 1e-4:
                    points = along
                blocks[names[2]] = self._seen(names[2], points, above)
        return blocks

    def leaf(self, leaf: str, frames: Mapping[str, np.ndarray]) -> np.ndarray:
        """Unit vectors of a leaf, ``(n, 3)`` or ``(n, 6)``, in the frame of what it hangs from."""
        side, _, part = leaf.rpartition("_")
        if leaf == "torso":
            return self._in("pelvis", frames, *self._axes("chest", frames, (0, 1)))
        if leaf == "head":
            return self._in("chest", frames, *self._axes("head", frames, (1, 2)))
        if part in ("arm", "leg"):
            a, b, c = (
                f"{side}_{name}"
                for name in (("shoulder", "elbow", "wrist") if part == "arm" else ("hip", "knee", "ankle"))
            )
            return self._in(
                "chest" if part == "arm" else "pelvis", frames, _unit(self._bone(a, b)), _unit(self._bone(b, c))
            )
        above, joint = ("elbow", "wrist") if part == "hand" else ("knee", "ankle")
        return self._in(f"{side}_{above}", frames, *self._axes(f"{side}_{joint}", frames, (0,)))

    def root(self, pelvis: np.ndarray) -> np.ndarray:
        """The root's columns ``(n, 4)``."""
        (left,) = self._axes("pelvis", {"pelvis": pelvis}, (0,))
        yaw = np.unwrap(np.arctan2(-left[:, 2], left[:, 0]))
        back = quat.from_yaw(-yaw)
        half = max(1, round(self.clip.fps * _STEP))
        at = np.arange(self.n)
        before, after = np.maximum(at - half, 0), np.minimum(at + half, self.n - 1)
        seconds = np.maximum(after - before, 1) / self.clip.fps
        place = np.asarray(self.clip.root_positions, np.float64)
        velocity = quat.rotate(back, (place[after] - place[before]) / seconds[:, None]) * (
            STANDARD_HEIGHT / self.height
        )
        turning = (yaw[after] - yaw[before]) / seconds
        return np.column_stack([velocity[:, 0], velocity[:, 2], velocity[:, 1], turning])

    def _bone(self, a: str, b: str) -> np.ndarray:
        return self.at[b] - self.at[a]

    def _axes(self, joint: str, frames: Mapping[str, np.ndarray], rows: tuple[int, ...]) -> list[np.ndarray]:
        return [self.turn[joint] @ frames[joint][row] for row in rows]

    def _in(self, joint: str, frames: Mapping[str, np.ndarray], *vectors: np.ndarray) -> np.ndarray:
        """World vectors as seen from a joint's frame, side by side."""
        turn = self.turn[joint] @ frames[joint].T
        return np.concatenate([np.einsum("nj,nji->ni", v, turn) for v in vectors], axis=1)

    def _seen(self, joint: str, *vectors: np.ndarray) -> np.ndarray:
        return np.stack([_unit(np.einsum("nj,nji->ni", v, self.turn[joint])) for v in vectors], axis=1)


def _matrices(q: np.ndarray) -> np.ndarray:
    """Unit quaternions ``(n, 4)`` as matrices ``(n, 3, 3)``."""
    w, x, y, z = np.ascontiguousarray(q.T)
    matrices = np.empty((len(q), 3, 3))
    matrices[:, 0, 0], matrices[:, 1, 1] = 1 - 2 * (y * y + z * z), 1 - 2 * (x * x + z * z)
    matrices[:, 2, 2] = 1 - 2 * (x * x + y * y)
    matrices[:, 0, 1], matrices[:, 1, 0] = 2 * (x * y - w * z), 2 * (x * y + w * z)
    matrices[:, 0, 2], matrices[:, 2, 0] = 2 * (x * z + w * y), 2 * (x * z - w * y)
    matrices[:, 1, 2], matrices[:, 2, 1] = 2 * (y * z - w * x), 2 * (y * z + w * x)
    return matrices


def _unit(vectors: np.ndarray) -> np.ndarray:
    unit: np.ndarray = vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-9)
    return unit


def _orthonormal(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Three rows: the first direction, the second made square to it, and what is square to both."""
    first = _unit(first)
    second = second - first * (first @ second)
    if np.linalg.norm(second) < 1e-6:
        second = np.eye(3)[np.abs(first).argmin()]
        second = second - first * (first @ second)
    second = _unit(second)
    return np.stack([first, second, np.cross(first, second)])
