"""Mirroring: the motion as seen in a mirror, left and right exchanged, played by the same body.

The mirror stands at X = 0 of the world: a joint of the left goes where its partner on the right was reflected to. A
reflected rotation must still be told in the joint frames of the same skeleton, and rigs turn the frames of left and
right limbs in many ways. Where the rest pose is its own mirror image, frames are reflected with it; elsewhere the
anatomical frames of the segments (:mod:`core.poses.body_frames`) say which way a joint faces.
"""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from core.errors import AnalysisError
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.anatomy_names import parse_name
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics
from core.mocap.skeleton import Skeleton
from core.poses.body_frames import BodyFrames, body_frames, matrices

MIRROR = np.diag([-1.0, 1, 1])  # of the world
_REFLECTED = np.array([1.0, 1, -1, -1])  # signs of a quaternion's numbers in that mirror
_SIDE = np.diag([1.0, 1, -1])  # of a segment: what was right is left
_LIKENESS = 0.06  # of the body's height: a rest pose off by more from its mirror image is not its own
_PULL = 1e-6  # how much a frame counts against a bone as long as the body: bones are to be reflected exactly


def mirror(clip: Clip, name: str | None = None, frames: BodyFrames | None = None) -> Clip:
    """The clip with left and right exchanged, reflected at the world's plane X = 0. Doing it twice gives it back.

    Bones point exactly where their partners' reflections point. They keep their own lengths: joints lie where the
    reflection has them as far as the body's two sides are equally long.
    frames: of the clip's skeleton, for rigs whose rest pose is not symmetric; read off the clip where None.
    Raises ValueError where a joint of one side has no partner on the other.
    """
    skeleton = clip.skeleton
    partner = partners(skeleton)
    turns = _frame_turns(clip, partner, frames)
    world = forward_kinematics(clip)[1].astype(np.float64)
    own_turns = np.roll(Rotation.from_matrix(turns).as_quat(), 1, axis=-1)
    reflected = np.empty_like(world)
    reflected[:, list(partner)] = quat.multiply(world * _REFLECTED, own_turns)
    local = reflected.copy()
    local[:, 1:] = quat.multiply(quat.conjugate(reflected[:, list(skeleton.parents[1:])]), reflected[:, 1:])
    local[:, list(skeleton.end_sites)] = (1, 0, 0, 0)
    rotations = quat.normalise(local)
    tracks = {
        int(partner[j]): (track @ MIRROR @ turns[skeleton.parents[j]]).astype(np.float32)
        for j, track in clip.translations.items()
    }
    return replace(
        clip,
        name=name or f"{clip.name} mirrored",
        root_positions=(clip.root_positions * np.diag(MIRROR)).astype(np.float32),
        rotations=quat.continuous(rotations).astype(np.float32),
        translations=tracks,
    )


def partners(skeleton: Skeleton) -> tuple[int, ...]:
    """For every joint the one on the other side; joints in the middle are their own.

    Raises AnalysisError where a joint of one side has no partner on the other.
    """
    anatomy = find_anatomy(skeleton)
    order = [0]
    for j in range(1, skeleton.n_joints):
        order.append(j if anatomy.side(j) == "centre" else _partner(skeleton, j, order[skeleton.parents[j]]))
    hang_alike = all(order[skeleton.parents[j]] == skeleton.parents[k] for j, k in enumerate(order) if j)
    if not hang_alike or any(order[k] != j for j, k in enumerate(order)):
        raise AnalysisError("the joints on the left and on the right do not hang from one another in the same way")
    return tuple(order)


def _partner(skeleton: Skeleton, joint: int, above: int) -> int:
    """The joint across from ``joint`` among those that hang from ``above``: by anatomy, by name, or the only one."""
    anatomy = find_anatomy(skeleton)
    side, other = anatomy.side(joint), "right" if anatomy.side(joint) == "left" else "left"
    for name, index in anatomy.joints.items():
        if index == joint and name.replace(side, other) in anatomy.joints:
            return anatomy.joints[name.replace(side, other)]
    across = [k for k in skeleton.children(above) if anatomy.side(k) == other]
    alike = [k for k in across if _key(skeleton.names[k]) == _key(skeleton.names[joint])]
    if not alike and len(across) != 1:
        raise AnalysisError(f"{skeleton.names[joint]} is on the {side}, but there is no such joint on the {other}")
    return (alike or across)[0]


def _key(name: str) -> tuple[str, list[str]]:
    """What is left of a joint's name without its side."""
    return parse_name(name).part, re.findall(r"\d+", name)


def _frame_turns(clip: Clip, partner: tuple[int, ...], frames: BodyFrames | None) -> np.ndarray:
    """Per joint the turn ``(n_joints, 3, 3)`` from its reflected frame to the frame its partner has on this rig.

    It lays the partner's bones along the reflected bones; what these leave open, the rest pose or the body's frames
    decide.
    """
    skeleton = clip.skeleton
    plane = _rest_mirror(skeleton, partner)
    wanted = np.broadcast_to(MIRROR @ plane, (skeleton.n_joints, 3, 3)) if plane is not None else None
    if wanted is None:
        axes = _all_axes(clip, frames or body_frames([clip]))
        wanted = np.stack([MIRROR @ axes[j] @ _SIDE @ axes[p].T for j, p in enumerate(partner)])
    offsets = skeleton.offsets.astype(np.float64) / find_anatomy(skeleton).body_height
    pulls = _PULL * wanted
    for k in range(1, skeleton.n_joints):
        pulls[skeleton.parents[k]] += np.outer(MIRROR @ offsets[k], offsets[partner[k]])
    u, _, v = np.linalg.svd(pulls)
    u[..., -1] *= np.linalg.det(u @ v)[..., None]
    nearest: np.ndarray = u @ v
    return nearest


def _rest_mirror(skeleton: Skeleton, partner: tuple[int, ...]) -> np.ndarray | None:
    """The reflection ``(3, 3)`` under which the rest pose is its own mirror image, None where there is none."""
    anatomy = find_anatomy(skeleton)
    posture = list(anatomy.posture_joints)
    rest = np.zeros((skeleton.n_joints, 3))
    for j, p in enumerate(skeleton.parents[1:], 1):
        rest[j] = rest[p] + skeleton.offsets[j]
    for axis in range(3):
        plane = np.diag([1.0 - 2 * (axis == k) for k in range(3)])
        if np.abs(rest[list(partner)] - rest @ plane)[posture].max() < _LIKENESS * anatomy.body_height:
            return plane
    return None


def _all_axes(clip: Clip, frames: BodyFrames) -> list[np.ndarray]:
    """Anatomical frame of every joint ``(3, 3)`` in its own; joints without one share, on average, what is above."""
    known = {find_anatomy(clip.skeleton).joints[name]: axes for name, axes in frames.axes.items()}
    step = max(1, clip.n_frames // 500)
    local = matrices(clip.rotations[::step])
    normals: list[np.ndarray] = []
    for j, parent in enumerate(clip.skeleton.parents):
        if j in known or parent < 0:
            normals.append(known.get(j, np.eye(3)))
        else:
            mean = (np.swapaxes(local[:, j], 1, 2) @ normals[parent]).sum(0)
            u, _, v = np.linalg.svd(mean)
            normals.append(u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v)
    return normals
