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
from core.mocap.skeleton import Skeleton
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
    bones: of what is no human the joints whose bones take the place of the parts, see :func:`own_bones`.
    """

    frames: Mapping[str, np.ndarray]
    leaves: tuple[str, ...]
    bones: tuple[int, ...] = ()


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
        if find_anatomy(clip.skeleton).body == "other":
            bones = own_bones(clip.skeleton)
            return Axes({}, LEAVES if bones else (), bones)
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


def own_bones(skeleton: Skeleton) -> tuple[int, ...]:
    """The joints at the ends of a rig's longest bones, as many as there are unit vectors in the columns.

    Repeated from the first where there are fewer, so that every column says something; none where no bone has a length.
    """
    length = np.linalg.norm(skeleton.offsets, axis=1)
    longest = np.argsort(-length, kind="stable")[: N_COLUMNS // 3]
    bones = sorted(int(joint) for joint in longest if length[joint] > 1e-6 * length.max())
    return tuple(np.resize(bones, N_COLUMNS // 3).tolist()) if bones else ()


def _own_frames(clip: Clip, axes: Axes) -> PartFrames:
    """Where the bones of a rig point, seen from its root, in the place of the parts of a human."""
    positions, world = forward_kinematics(clip)
    bones, parents = list(axes.bones), [clip.skeleton.parents[joint] for joint in axes.bones]
    lines = _unit(positions[:, bones].astype(np.float64) - positions[:, parents])
    values = quat.rotate(quat.conjugate(world[:, :1].astype(np.float64)), lines).reshape(clip.n_frames, -1)
    yaw = np.unwrap(quat.split_yaw(world[:, 0])[0])
    size = max(find_anatomy(clip.skeleton).body_height, 1e-6)
    root = _travel(np.asarray(clip.root_positions, np.float64), yaw, clip.fps, size)
    return PartFrames(values.astype(np.float32), root.astype(np.float32), axes.leaves)


def part_frames(clip: Clip, axes: Axes, fps: float) -> PartFrames:
    """The frames of a clip in parts, at ``fps``. Raises ValueError where ``fps`` is not positive."""
    if axes.bones:
        return _own_frames(resample(clip, fps), axes)
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
        top = next((name for name in ("neck", "head") if name in self.joints), "")
        pairs = [pair for pair in ("hip", "shoulder") if {f"left_{pair}", f"right_{pair}"} <= set(self.joints)]
        if not pairs or (not top and "left_ankle" not in self.joints):
            return {}
        # A body without legs, or without arms, is as wide as the other pair; one without a head stands on its feet.
        hips = self._bone(f"right_{pairs[0]}", f"left_{pairs[0]}")
        shoulders = self._bone(f"right_{pairs[-1]}", f"left_{pairs[-1]}")
        if not top:  # then the ankles are there
            up = self._bone("left_ankle", "pelvis")
            blocks["pelvis"], blocks["chest"] = self._seen("pelvis", hips, up), self._seen("chest", shoulders, up)
        else:
            blocks["pelvis"] = self._seen("pelvis", hips, self._bone("pelvis", top))
            blocks["chest"] = self._seen("chest", shoulders, self._bone("chest" if top == "head" else "pelvis", top))
        if "head" in self.joints:
            blocks["head"] = self._seen("head", shoulders, self._bone("pelvis", top))
        for side in ("left", "right"):
            for upper, middle, lower, end in (("shoulder", "elbow", "wrist", ""), ("hip", "knee", "ankle", "toe")):
                names = [f"{side}_{name}" for name in (upper, middle, lower)]
                if not set(names) <= set(self.joints):
                    continue
                above, along = self._bone(*names[:2]), self._bone(*names[1:])
                blocks[names[1]] = self._seen(names[1], along, above)
                tip = f"{side}_{end}"
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
        return _travel(np.asarray(self.clip.root_positions, np.float64), yaw, self.clip.fps, self.height)

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


def _travel(place: np.ndarray, yaw: np.ndarray, fps: float, height: float) -> np.ndarray:
    """The root's columns ``(n, 4)`` from its places ``(n, 3)`` and its heading ``(n,)``, for a body of this height."""
    half, at = max(1, round(fps * _STEP)), np.arange(len(place))
    before, after = np.maximum(at - half, 0), np.minimum(at + half, len(place) - 1)
    seconds = np.maximum(after - before, 1) / fps
    steps = (place[after] - place[before]) / seconds[:, None]
    velocity = quat.rotate(quat.from_yaw(-yaw), steps) * (STANDARD_HEIGHT / height)
    turning = (yaw[after] - yaw[before]) / seconds
    return np.column_stack([velocity[:, 0], velocity[:, 2], velocity[:, 1], turning])


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
