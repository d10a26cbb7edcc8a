"""Joint angles with a meaning: flexion, abduction, rotation, in degrees.

Convention. Every segment has an anatomical frame, X forward, Y up, Z right (:mod:`core.poses.body_frames`). A joint's
angles are the Cardan angles Z, X', Y'' of the distal frame seen from the proximal one: flexion about the proximal side
axis, abduction about the floating axis, rotation about the distal long axis: the joint coordinate system of Grood and
Suntay (1983) that the International Society of Biomechanics recommends for hip, knee and ankle (Wu et al. 2002).
Shoulders are given in the same way and not as ISB's plane of elevation, which a hanging arm does not have; near 90
degrees of abduction flexion and rotation cannot be told apart, so ``elevation``, the angle between the upper arm and
the trunk's downward axis, stands beside them. The pelvis is seen from the world, turning first (Y, X', Z''; Baker
2001).

Zero: limbs straight and hanging down, the hinge of knee or elbow pointing sideways; trunk, head and feet as in upright
standing, averaged over the recordings. Signs are clinical and alike for left and right, see :data:`JOINTS`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics
from core.poses.body_frames import BodyFrames, matrices


class Channel(NamedTuple):
    """One angle of a joint: its name and which way is positive."""

    name: str
    positive: str


class AngleJoint(NamedTuple):
    """A joint between two segments, named by the canonical joints they hang from (``above`` is "" for the world).

    signs: of the turns about Z, X' and Y'' that make flexion, abduction and rotation.
    """

    above: str
    below: str
    channels: tuple[Channel, ...]
    signs: tuple[int, int, int]


def _channels(**positive: str) -> tuple[Channel, ...]:
    return tuple(Channel(name.replace("_", " "), words) for name, words in positive.items())


# for the right side; a turn about the forward or the long axis means the contrary on the left
_LIMBS = {
    "hip": AngleJoint(
        "pelvis", "hip", _channels(flexion="thigh forward", abduction="outward", rotation="inward"), (1, -1, 1)
    ),
    "knee": AngleJoint(
        "hip", "knee", _channels(flexion="bent", abduction="shank outward", rotation="inward"), (-1, -1, 1)
    ),
    "ankle": AngleJoint(
        "knee", "ankle", _channels(flexion="toes up", inversion="sole inward", rotation="toes inward"), (1, 1, 1)
    ),
    "shoulder": AngleJoint(
        "chest",
        "shoulder",
        _channels(flexion="arm forward", abduction="outward", rotation="inward", elevation="away from the trunk"),
        (1, -1, 1),
    ),
    "elbow": AngleJoint(
        "shoulder", "elbow", _channels(flexion="bent", abduction="forearm outward", rotation="pronation"), (1, -1, 1)
    ),
    "wrist": AngleJoint(
        "elbow", "wrist", _channels(flexion="to the palm", abduction="to the thumb", rotation="pronation"), (1, -1, 1)
    ),
}
_PELVIS = _channels(tilt="forward", list="to the right", heading="to the left")
_LEAN = _channels(flexion="forward", side_bend="to the right", rotation="to the left")


def _sided(side: str, joint: AngleJoint) -> AngleJoint:
    about_z, about_x, about_y = joint.signs
    turn = 1 if side == "right" else -1
    above = joint.above if joint.above in ("pelvis", "chest") else f"{side}_{joint.above}"
    return AngleJoint(above, f"{side}_{joint.below}", joint.channels, (about_z, turn * about_x, turn * about_y))


JOINTS: Mapping[str, AngleJoint] = MappingProxyType(
    {
        "pelvis": AngleJoint("", "pelvis", _PELVIS, (-1, 1, 1)),
        "trunk": AngleJoint("pelvis", "chest", _LEAN, (-1, 1, 1)),
        "head": AngleJoint("chest", "head", _LEAN, (-1, 1, 1)),
        **{f"{side}_{name}": _sided(side, joint) for name, joint in _LIMBS.items() for side in SIDES},
    }
)  # fmt: skip
"""Joints with angles and how they are counted. A heading of 0 faces Z, 90 faces X, both on the ground."""

_WORLD = np.array([[0.0, 0, -1], [0, 1, 0], [1, 0, 0]])  # columns: forward is Z, up is Y, right is -X


def known_joints(frames: BodyFrames) -> tuple[str, ...]:
    """Names of :data:`JOINTS` that a body has, in their order."""
    return tuple(
        name for name, j in JOINTS.items() if j.below in frames.axes and (not j.above or j.above in frames.axes)
    )


def joint_angles(clip: Clip, frames: BodyFrames, joints: Iterable[str] | None = None) -> dict[str, np.ndarray]:
    """Angles of the ``joints`` (all known ones where None), degrees: joint -> ``(n_frames, n_channels)`` float32.

    Columns as in ``JOINTS[joint].channels``. Flexion lies in [-90, 270), rotation and abduction in [-180, 180); the
    heading goes on beyond a full turn. Raises ValueError for a joint the body lacks or frames of another skeleton.
    """
    if clip.skeleton != frames.skeleton:
        raise ValueError(f"{clip.name}: these are the frames of another skeleton")
    known = known_joints(frames)
    chosen = known if joints is None else tuple(joints)
    if unknown := [name for name in chosen if name not in known]:
        raise ParameterError(f"no angles for {', '.join(unknown)}; this body has {', '.join(known) or 'none'}")
    world = forward_kinematics(clip)[1]
    segments: dict[str, np.ndarray] = {"": np.broadcast_to(_WORLD, (clip.n_frames, 3, 3))}
    indices = find_anatomy(clip.skeleton).joints
    for name in chosen:
        for segment in (JOINTS[name].above, JOINTS[name].below):
            if segment not in segments:
                segments[segment] = matrices(world[:, indices[segment]]) @ frames.axes[segment]
    return {name: _angles(JOINTS[name], segments).astype(np.float32) for name in chosen}


def _angles(joint: AngleJoint, segments: Mapping[str, np.ndarray]) -> np.ndarray:
    turn = np.swapaxes(segments[joint.above], 1, 2) @ segments[joint.below]
    if not joint.above:  # the product of turns about Y, X and Z
        heading = np.unwrap(np.degrees(np.arctan2(turn[:, 0, 2], turn[:, 2, 2])), period=360)
        lean, tilt = np.arcsin(np.clip(-turn[:, 1, 2], -1, 1)), np.arctan2(turn[:, 1, 0], turn[:, 1, 1])
        return np.stack([-np.degrees(tilt), np.degrees(lean), heading], axis=1)
    about_z = np.arctan2(-turn[:, 0, 1], turn[:, 1, 1])
    about_x = np.arcsin(np.clip(turn[:, 2, 1], -1, 1))
    about_y = np.arctan2(-turn[:, 2, 0], turn[:, 2, 2])
    angles: np.ndarray = np.degrees(np.stack([about_z, about_x, about_y], axis=1)) * joint.signs
    angles[:, 0] = (angles[:, 0] + 90) % 360 - 90
    if len(joint.channels) == 4:
        elevation = np.degrees(np.arccos(np.clip(turn[:, 1, 1], -1, 1)))
        angles = np.column_stack([angles, elevation])
    return angles


def channel_angles(clip: Clip, joint: int) -> tuple[tuple[str, ...], np.ndarray]:
    """A joint's turn against its parent as the file's own channels: their names and ``(n_frames, 3)``, degrees.

    Intrinsic Euler angles in the order of the source's rotation channels (Z, Y, X where it has fewer than three, as in
    ASF), about the axes of the rig. Every turn has two such triples; that which is nearer to the frame before goes on,
    so curves have no jumps, as in a file that was recorded rather than computed.
    """
    turns = tuple(c for c in clip.skeleton.channels[joint] if c.endswith("rotation"))
    if len(turns) != 3:
        turns = ("Zrotation", "Yrotation", "Xrotation")
    order = "".join(channel[0] for channel in turns)
    angles = np.degrees(quat.to_euler(order, clip.rotations[:, joint]))
    middle = -angles[:, 1] if order[0] == order[2] else 180 - angles[:, 1]
    other = np.column_stack([angles[:, 0] + 180, middle, angles[:, 2] + 180])
    changes = _apart(angles[1:], other[:-1]) < _apart(angles[1:], angles[:-1])
    turned = np.r_[False, np.cumsum(changes) % 2 == 1]
    return turns, np.unwrap(np.where(turned[:, None], other, angles), period=360, axis=0)


def _apart(a: FloatArray, b: FloatArray) -> FloatArray:
    """How far triples of angles ``(n, 3)`` lie apart, full turns aside."""
    squared: FloatArray = (np.abs((a - b + 180) % 360 - 180) ** 2).sum(1)
    return squared
