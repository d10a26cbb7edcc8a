"""Which axis points up in a file, and clips turned so that Y does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.anatomy import Anatomy, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics

AXES = ("y", "z", "x", "-z", "-x", "-y")
_HALF = np.sqrt(0.5)
TO_Y = {  # quaternions that turn an axis to Y
    "y": (1.0, 0.0, 0.0, 0.0),
    "z": (_HALF, -_HALF, 0.0, 0.0),
    "-z": (_HALF, _HALF, 0.0, 0.0),
    "x": (_HALF, 0.0, 0.0, _HALF),
    "-x": (_HALF, 0.0, 0.0, -_HALF),
    "-y": (0.0, 1.0, 0.0, 0.0),
}
_SAMPLED = 48  # frames that are looked at
_ALONG = 0.8  # cosine of a body that stands along an axis
_OFTEN, _MOSTLY = 0.3, 0.8  # share of the frames in which it does, where the rest pose does too, and where it does not
_AT_REST = 0.7  # cosine from which the rest pose speaks for an axis
_ON_FLOOR = 0.08  # of the body's height: how far the lowest joint may be from the floor
_LEVEL = 0.15  # how much that may change where there is a floor
_OFF_FLOOR = 0.04  # from how far it is not on it
_FAR = 1.5  # of the body's height: who goes so far across the own length does not lie on the floor
_TRAVEL = 0.25  # of the body's height: who moves so far along what would be the vertical does not lie on the floor


def axis_of(up: str) -> str | None:
    """The axis named ``up`` (y, z, x, -z, -x, -y), None for "auto". Raises ParameterError for anything else."""
    word = up.strip().lower().removeprefix("+")
    if word == "auto":
        return None
    if word not in AXES:
        raise ParameterError(f"up {up!r}: expected y, z, x, -y, -z, -x or auto")
    return word


def turned(clip: Clip, up: str) -> Clip:
    """The clip read as if ``up`` (one of AXES) points up in its file, instead of ``clip.up``; what was up is Y.

    Where the rest pose stands along ``up`` as well, all coordinates are turned, so that the skeleton is that of the
    same file with Y up; else only the motion is, by its root.
    """
    if up == clip.up:
        return clip
    as_filed = _turned(clip, quat.conjugate(np.array(TO_Y[clip.up])), clip.rest_turned)
    anatomy = find_anatomy(clip.skeleton)
    rest = _upright(anatomy, _resting(as_filed))
    axis = quat.rotate(quat.conjugate(np.array(TO_Y[up])), np.array([0.0, 1.0, 0.0]))
    with_rest = rest is not None and bool(rest[0] @ axis > _AT_REST)
    return replace(_turned(as_filed, np.array(TO_Y[up]), with_rest), up=up, rest_turned=with_rest and up != "y")


def _turned(clip: Clip, turn: np.ndarray, with_rest: bool) -> Clip:
    """The clip turned by a quaternion (4,), its rest pose with it or not."""
    root = quat.rotate(turn[None], np.asarray(clip.root_positions, float)).astype(np.float32)
    rotations = np.array(clip.rotations, np.float32)
    if not with_rest:
        rotations[:, 0] = quat.multiply(turn[None], clip.rotations[:, 0].astype(float))
        return replace(clip, root_positions=root, rotations=rotations)
    back = quat.conjugate(turn)
    rotations = quat.multiply(quat.multiply(turn[None, None], rotations.astype(float)), back[None, None])
    offsets = quat.rotate(turn[None], clip.skeleton.offsets.astype(float))
    tracks = {j: quat.rotate(turn[None], np.asarray(t, float)) for j, t in clip.translations.items()}
    return replace(
        clip,
        skeleton=replace(clip.skeleton, offsets=offsets),
        root_positions=root,
        rotations=rotations.astype(np.float32),
        translations={j: track.astype(np.float32) for j, track in tracks.items()},
    )


def _resting(clip: Clip) -> np.ndarray:
    """World positions ``(1, n_joints, 3)`` of the pose of no rotation."""
    unturned = np.zeros_like(clip.rotations[:1]) + np.array([1, 0, 0, 0], np.float32)
    resting = replace(clip, root_positions=clip.root_positions[:1], rotations=unturned, translations={})
    return forward_kinematics(resting)[0].astype(float)


def find_up(clip: Clip) -> str:
    """The axis, of the file the clip was read from, along which its body stands; ``clip.up`` where none is certain.

    A body that lies along another axis than Y may be a person on the floor. The file's axis it is where the rest pose
    stands along it too, or where, nearly always along it, the body moves as nobody on the floor does, or has its feet
    at 0. A rest pose along another axis also counts where a floor lies along it and none along Y. Upside down it is
    only where the rest pose is too.
    """
    anatomy = find_anatomy(clip.skeleton)
    if anatomy.body == "other":
        return clip.up
    some = _sampled(clip)
    positions = forward_kinematics(some)[0]
    upright = _upright(anatomy, positions.astype(float))
    if upright is None:
        return clip.up
    shares = [(float(np.mean(sign * upright[:, axis] > _ALONG)), axis, sign) for axis in range(3) for sign in (1, -1)]
    share, axis, sign = max(shares)
    rest = _standing_rest(anatomy, some)
    if (floor := _floor_along(anatomy, rest, positions)) is not None:
        axis, sign = floor
    elif (axis, sign) == (1, 1):
        return clip.up
    elif rest @ (sign * np.eye(3)[axis]) <= _AT_REST or share <= _OFTEN:
        told = np.abs(rest).max() > _AT_REST
        if axis == 1 or share <= _MOSTLY or not _lies_nowhere(anatomy, positions, axis, sign, told):
            return clip.up
    return _axis_of_file(clip, axis, sign)


def _standing_rest(anatomy: Anatomy, clip: Clip) -> np.ndarray:
    """The direction in which the pose of no rotation stands, ``(3,)``; 0 where its legs do not point away from its
    head, as where all bones lie along one axis."""
    joints, places = anatomy.joints, _resting(clip)
    upright = _upright(anatomy, places)
    legs = [places[0, ankle] - places[0, hip] for hip, _, ankle in anatomy.legs]
    top = anatomy.head_tip or joints.get("chest", 0)
    if upright is None or (legs and top and np.sum(legs, axis=0) @ (places[0, top] - places[0, 0]) >= 0):
        return np.zeros(3)
    return np.asarray(upright[0], float)


def _lies_nowhere(anatomy: Anatomy, positions: np.ndarray, axis: int, sign: int, told: bool) -> bool:
    """Whether a body that is along an axis (0 to 2) all the time cannot be a person on the floor.

    It goes up and down along Y, or goes far across its own axis, or its feet are at 0 along it. told: the rest pose
    stands along another axis; then it must also be away from a floor at Y = 0.
    """
    height, pelvis = anatomy.body_height, positions[:, 0]
    across = [k for k in range(3) if k != axis]
    travels = np.ptp(pelvis[:, 1]) > _TRAVEL * height or np.ptp(pelvis[:, across], axis=0).max() > _FAR * height
    feet = abs(float(np.median((sign * positions[..., axis]).min(axis=1)))) / height
    floor = abs(float(np.median(positions[..., 1].min(axis=1)))) / height
    return bool(travels or (feet < _ON_FLOOR and (floor > _OFF_FLOOR or not told)))


def _floor_along(anatomy: Anatomy, rest: np.ndarray, positions: np.ndarray) -> tuple[int, int] | None:
    """Axis (0 to 2) and direction along which the rest pose stands and a floor lies below a body that does not stand.

    So a person who crawls in a file with another axis up: the lowest joint stays at one height along that axis, while
    along Y it would rise and sink. None where this says nothing.
    """
    axis = int(np.abs(rest).argmax())
    sign = 1 if rest[axis] > 0 else -1
    if axis == 1 or abs(rest[axis]) <= _AT_REST:
        return None
    lowest = [(sign * positions[..., axis]).min(axis=1), positions[..., 1].min(axis=1)]
    along, along_y = (float(np.ptp(np.percentile(track, (5, 95)))) / anatomy.body_height for track in lowest)
    return (axis, sign) if along < _LEVEL and along_y > _TRAVEL else None


def axis_along(clip: Clip) -> str:
    """The axis, of the file the clip was read from, along which its body lies in most frames, upside down or not;
    ``clip.up`` where there is no body."""
    upright = _upright(find_anatomy(clip.skeleton), forward_kinematics(_sampled(clip))[0].astype(float))
    if upright is None:
        return clip.up
    middle = np.median(upright, axis=0)
    axis = int(np.abs(middle).argmax())
    return _axis_of_file(clip, axis, int(np.sign(middle[axis])) or 1)


def _sampled(clip: Clip) -> Clip:
    """Some frames of the clip, evenly spread."""
    step = max(1, clip.n_frames // _SAMPLED)
    tracks = {joint: track[::step] for joint, track in clip.translations.items()}
    return replace(
        clip, root_positions=clip.root_positions[::step], rotations=clip.rotations[::step], translations=tracks
    )


def _axis_of_file(clip: Clip, axis: int, sign: int) -> str:
    """What the file calls an axis (0 to 2) of the clip, in the direction ``sign`` (1 or -1)."""
    found = quat.rotate(quat.conjugate(np.array(TO_Y[clip.up])), sign * np.eye(3)[axis])
    k = int(np.abs(found).argmax())
    return ("" if found[k] > 0 else "-") + "xyz"[k]


def _upright(anatomy: Anatomy, positions: np.ndarray) -> np.ndarray | None:
    """Unit vectors ``(n, 3)`` from the feet (the pelvis where there are none) to the head or what is next to it."""
    joints = anatomy.joints
    ankles = [joints[name] for name in ("left_ankle", "right_ankle") if name in joints]
    top = anatomy.head_tip or next((joints[name] for name in ("head", "neck", "chest") if name in joints), 0)
    if not top:
        return None
    line = positions[:, top] - positions[:, ankles or [0]].mean(axis=1)
    length = np.linalg.norm(line, axis=1, keepdims=True)
    return line / np.maximum(length, 1e-9) if length.max() > 1e-6 else None
