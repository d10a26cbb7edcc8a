"""Anatomical frames of the body's segments: which way is forward, up and right for a thigh, a foot, a chest.

Joint frames of recordings are whatever the maker of the rig liked, and the pose of no rotation need not be a standing
one. Angles that mean the same on every rig need frames with a meaning: X forward, Y up, Z to the right as the
International Society of Biomechanics has it (Wu et al. 2002, 2005), fixed to each segment. They are read off motion:
the long axis of a limb from its joints, its side axis from the hinge of knee or elbow, up and right of the trunk and
head from the frames in which the person stands upright, and the level of a foot from the frames in which it is lowest.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from core.mocap.anatomy import SIDES, Anatomy, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics
from core.mocap.skeleton import Skeleton

_SAMPLED = 2400  # frames looked at, spread evenly over all clips
_BENT = np.radians(15)  # a hinge shows its axis only where it is bent further
_FEWEST = 8  # bent frames it takes to trust a hinge
_UPRIGHT = np.radians(25)  # the line from pelvis to head leans no further
_STANDING = 0.93  # share of the greatest height that counts as standing
_LOWEST = 20  # per cent of the frames in which a foot is taken to be level


@dataclass(frozen=True, eq=False)
class BodyFrames:
    """Anatomical frames of the segments of one skeleton.

    axes: canonical joint name (the joint a segment hangs from: ``left_hip`` is the left thigh) -> ``(3, 3)`` rotation;
        its columns are forward, up and right of the segment in the joint's own frame.
    hinges: knees and elbows whose axis was found in motion; the others never bend far enough, their side axis is the
        pelvis's or the chest's.
    """

    skeleton: Skeleton
    axes: Mapping[str, np.ndarray]
    hinges: frozenset[str]


@dataclass(frozen=True, eq=False)
class _Sample:
    """Positions ``(n, n_joints, 3)`` and world rotations ``(n, n_joints, 3, 3)`` of frames from all clips."""

    anatomy: Anatomy
    positions: np.ndarray
    world: np.ndarray

    def at(self, name: str) -> np.ndarray:
        return self.positions[:, self.anatomy.joints[name]]

    def local(self, name: str, vectors: np.ndarray) -> np.ndarray:
        """World vectors ``(n, 3)`` in the frame of a joint."""
        local: np.ndarray = np.einsum("nji,nj->ni", self.world[:, self.anatomy.joints[name]], vectors)
        return local

    def has(self, *names: str) -> bool:
        return all(name in self.anatomy.joints for name in names)


def body_frames(clips: Sequence[Clip]) -> BodyFrames:
    """Anatomical frames of the skeleton that all ``clips`` share, from a sample of their frames.

    The more the person moves, the better: give all clips of one skeleton, so that the same pose has the same angles in
    all of them. Mirroring the clips mirrors the frames. Segments whose joints the anatomy does not know are left out.
    Raises ValueError where there is no clip or the skeletons differ.
    """
    if not clips:
        raise ValueError("no clip to read the body's frames from")
    skeleton = clips[0].skeleton
    if any(clip.skeleton != skeleton for clip in clips):
        raise ValueError("the clips have different skeletons; read the frames of each on its own")
    sample = _sample(clips)
    upright = _upright(sample)
    axes: dict[str, np.ndarray] = {}
    _trunk(sample, upright, axes)
    hinges = set()
    for side in SIDES:
        hinges |= _limb(sample, upright, axes, [f"{side}_{part}" for part in ("hip", "knee", "ankle")], "pelvis", -1)
        hinges |= _limb(
            sample, upright, axes, [f"{side}_{part}" for part in ("shoulder", "elbow", "wrist")], "chest", 1
        )
        _foot(sample, axes, side)
        _hand(sample, axes, side)
    return BodyFrames(skeleton, MappingProxyType(axes), frozenset(hinges))


def _sample(clips: Sequence[Clip]) -> _Sample:
    step = max(1, sum(clip.n_frames for clip in clips) // _SAMPLED)
    offset, parts = 0, []
    for clip in clips:
        if offset < clip.n_frames:
            parts.append(forward_kinematics(_every(clip, offset, step)))
        offset = (offset - clip.n_frames) % step
    positions = np.concatenate([part[0] for part in parts]).astype(np.float64)
    quaternions = np.concatenate([part[1] for part in parts])
    return _Sample(find_anatomy(clips[0].skeleton), positions, matrices(quaternions))


def _every(clip: Clip, offset: int, step: int) -> Clip:
    keep = slice(offset, None, step)
    tracks = {joint: track[keep] for joint, track in clip.translations.items()}
    return replace(clip, root_positions=clip.root_positions[keep], rotations=clip.rotations[keep], translations=tracks)


def matrices(q: np.ndarray) -> np.ndarray:
    """Unit quaternions ``(..., 4)`` as rotation matrices ``(..., 3, 3)``, float64."""
    w, x, y, z = np.moveaxis(np.asarray(q, np.float64), -1, 0)
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    return np.stack([np.stack(row, -1) for row in rows], -2)


def _upright(sample: _Sample) -> np.ndarray:
    """Frames ``(n,)`` in which the body stands: trunk upright, head nearly as high above the feet as it ever is."""
    top = next((name for name in ("head", "neck", "chest") if sample.has(name)), None)
    if top is None:
        return np.ones(len(sample.positions), bool)
    trunk = sample.at(top) - sample.at("pelvis")
    lean = np.arccos(np.clip(_unit(trunk)[:, 1], -1, 1))
    height = sample.at(top)[:, 1] - sample.positions[..., 1].min(1)
    standing: np.ndarray = (lean < _UPRIGHT) & (height > _STANDING * np.percentile(height, 98))
    if standing.sum() < _FEWEST:
        standing = lean <= np.percentile(lean, 10)
    return standing


def _trunk(sample: _Sample, upright: np.ndarray, axes: dict[str, np.ndarray]) -> None:
    """Pelvis: right along the line of the hips. Chest: up first, right along the shoulders. Head: as the chest."""
    vertical = np.tile([0.0, 1.0, 0.0], (len(sample.positions), 1))
    if sample.has("left_hip", "right_hip"):
        right = _mean(sample.local("pelvis", sample.at("right_hip") - sample.at("left_hip")))
        axes["pelvis"] = _frame(up=_mean(sample.local("pelvis", vertical)[upright]), right=right, first="right")
    if sample.has("chest", "left_shoulder", "right_shoulder"):
        right = _mean(sample.local("chest", sample.at("right_shoulder") - sample.at("left_shoulder")))
        axes["chest"] = _frame(up=_mean(sample.local("chest", vertical)[upright]), right=right)
    if sample.has("head") and "chest" in axes:
        right = _mean(sample.local("head", _axis(sample, axes, "chest", 2))[upright])
        axes["head"] = _frame(up=_mean(sample.local("head", vertical)[upright]), right=right)


def _limb(
    sample: _Sample, upright: np.ndarray, axes: dict[str, np.ndarray], joints: list[str], trunk: str, bends: int
) -> set[str]:
    """Upper and lower segment of a limb, their side axis the hinge between; the joint at the hinge if it was found.

    bends: 1 where flexion brings the lower segment forward (elbow), -1 where back (knee).
    """
    if not sample.has(*joints) or trunk not in axes:
        return set()
    upper, lower, end = joints
    thigh, shank = _unit(sample.at(lower) - sample.at(upper)), _unit(sample.at(end) - sample.at(lower))
    across = bends * np.cross(thigh, shank)
    bent = (np.linalg.norm(across, axis=1) > np.sin(_BENT)) & np.isfinite(across).all(1)
    enough = bent.sum() >= _FEWEST
    for name, along in ((upper, thigh), (lower, shank)):
        side = (
            sample.local(name, across)[bent] if enough else sample.local(name, _axis(sample, axes, trunk, 2))[upright]
        )
        up = -_mean(sample.local(name, along))
        axes[name] = _frame(up=up, right=_without_flips(side) if enough else _mean(side))
    return {lower} if enough else set()


def _without_flips(sides: np.ndarray) -> np.ndarray:
    """Mean direction of ``(n, 3)``, frames left out in which a fault of the recording turns a hinge over."""
    mean = _mean(sides)
    kept = sides[sides @ mean > 0.5 * np.linalg.norm(sides, axis=1)]
    return _mean(kept) if len(kept) else mean


def _foot(sample: _Sample, axes: dict[str, np.ndarray], side: str) -> None:
    """Forward from the ankle to the toes; up is up where the foot is lowest, ankle and toes together."""
    ankle = f"{side}_ankle"
    toe = _farthest(sample, sample.anatomy.joints.get(f"{side}_toe", sample.anatomy.joints.get(ankle, -1)), ankle)
    if f"{side}_knee" not in axes or toe is None:
        return
    height = sample.at(ankle)[:, 1] + sample.positions[:, toe, 1]
    level = height <= np.percentile(height, _LOWEST)
    up = _mean(sample.local(ankle, np.tile([0.0, 1.0, 0.0], (len(height), 1)))[level])
    forward = _mean(sample.local(ankle, sample.positions[:, toe] - sample.at(ankle)))
    axes[ankle] = _frame(up=up, right=np.cross(forward, up))


def _hand(sample: _Sample, axes: dict[str, np.ndarray], side: str) -> None:
    """Along the fingers (the forearm where there are none); right as the forearm's on average."""
    wrist, elbow = f"{side}_wrist", f"{side}_elbow"
    if elbow not in axes or not sample.has(wrist):
        return
    tip = _farthest(sample, sample.anatomy.joints[wrist], wrist)
    up = _axis(sample, axes, elbow, 1) if tip is None else sample.at(wrist) - sample.positions[:, tip]
    right = sample.local(wrist, _axis(sample, axes, elbow, 2))
    axes[wrist] = _frame(up=_mean(sample.local(wrist, up)), right=_mean(right))


def _farthest(sample: _Sample, joint: int, start: str) -> int | None:
    """The joint at or below ``joint`` that reaches furthest from ``start``; None where none is a hand's breadth off."""
    if joint < 0 or not sample.has(start):
        return None
    below = sample.anatomy.foot_joints(joint)
    reach = [np.linalg.norm(sample.positions[:, j] - sample.at(start), axis=1).mean() for j in below]
    best = int(np.argmax(reach))
    return below[best] if reach[best] > 0.01 * sample.anatomy.body_height else None


def _axis(sample: _Sample, axes: dict[str, np.ndarray], name: str, column: int) -> np.ndarray:
    """An axis of a segment in the world, frame by frame ``(n, 3)``."""
    axis: np.ndarray = sample.world[:, sample.anatomy.joints[name]] @ axes[name][:, column]
    return axis


def _frame(up: np.ndarray, right: np.ndarray, first: str = "up") -> np.ndarray:
    """Rotation ``(3, 3)`` with columns forward, up, right from two directions; ``first`` is kept exactly."""
    if first == "up":
        right = right - up * (right @ up)
    else:
        up = up - right * (up @ right)
    up, right = _unit(up), _unit(right)
    if not (np.isfinite(up).all() and np.isfinite(right).all()):
        return np.eye(3)
    return np.stack([np.cross(up, right), up, right], axis=1)


def _mean(vectors: np.ndarray) -> np.ndarray:
    return _unit(vectors.sum(0))


def _unit(v: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(v, axis=-1, keepdims=True)
    return v / np.where(length > 1e-12, length, np.nan)
