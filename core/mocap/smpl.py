"""Poses of the SMPL family (AMASS, SMPL-H, SMPL-X) and of kimodo's SOMA, in NPZ files."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.points.array_files import RATES, as_floats
from core.mocap.points.cleaning import upward
from core.mocap.points.solving import from_matrices
from core.mocap.skeleton import Skeleton
from core.mocap.smpl_body import ENVIRONMENT, NAMES, PARENTS, STATURE, average_offsets, model_offsets
from core.mocap.text import LARGEST, recording_format
from core.mocap.upright import turned
from core.mocap.world_poses import clip_of_world

_POSES = ("poses", "smpl_poses", "pose", "full_pose", "fullpose", "body_pose", "pose_body", "poses_body")
_ROOTS = ("root_orient", "global_orient", "pose_root", "orient")
_PLACES = ("trans", "smpl_trans", "transl", "translation", "root_translation", "Th")
_DEFAULT_FPS = 60.0  # of most of AMASS that names no rate
_BODY = 22  # joints that all models of the family share; hands and faces behind them differ
_SOMA = (
    ("Hips", -1), ("Spine1", 0), ("Spine2", 1), ("Chest", 2), ("Neck1", 3), ("Neck2", 4), ("Head", 5), ("Jaw", 6),
    ("LeftEye", 6), ("RightEye", 6),
    ("LeftShoulder", 3), ("LeftArm", 10), ("LeftForeArm", 11), ("LeftHand", 12), ("LeftHandThumbEnd", 13),
    ("LeftHandMiddleEnd", 13),
    ("RightShoulder", 3), ("RightArm", 16), ("RightForeArm", 17), ("RightHand", 18), ("RightHandThumbEnd", 19),
    ("RightHandMiddleEnd", 19),
    ("LeftLeg", 0), ("LeftShin", 22), ("LeftFoot", 23), ("LeftToeBase", 24),
    ("RightLeg", 0), ("RightShin", 26), ("RightFoot", 27), ("RightToeBase", 28),
)  # fmt: skip

Arrays = dict[str, np.ndarray]


@dataclass(frozen=True, eq=False)
class _Motion:
    """rotations: (n, n_joints, 4), local; root: (n, 3), metres."""

    rotations: np.ndarray
    root: np.ndarray


def holds_poses(names: set[str]) -> bool:
    """Whether arrays of these names are poses of the SMPL family or of SOMA."""
    lower = {name.lower() for name in names}
    return "global_rot_mats" in lower or bool(lower & {*_POSES} and lower & {*_PLACES, *_ROOTS})


def read_poses(path: str | Path, arrays: Arrays, fps: float | None = None) -> Clip:
    """The clip that arrays ``(n_frames, ...)`` of poses are. Raises RecordingError where they do not fit together."""
    lower = {name.lower(): array for name, array in arrays.items()}
    rate = fps or next((float(lower[k].reshape(-1)[0]) for k in RATES if _is_rate(lower.get(k))), None)
    if "global_rot_mats" in lower and "posed_joints" in lower:
        return _soma(path, lower, rate)
    return _smpl(path, lower, rate)


def _is_rate(array: np.ndarray | None) -> bool:
    return array is not None and array.size == 1 and array.dtype.kind in "fiu" and 0 < float(array.reshape(-1)[0]) < 1e5


def _smpl(path: str | Path, arrays: Arrays, rate: float | None) -> Clip:
    motion = _motion(path, arrays)
    betas = arrays.get("betas")
    shape = as_floats(betas).reshape(-1)[:300] if betas is not None and betas.dtype.kind in "fiu" else None
    notes = [] if rate else [f"frame rate: the file does not say it; taken as {_DEFAULT_FPS:g} frames per second"]
    own = model_offsets(shape)
    if own is not None:
        notes.append(f"the joints are those of the body model that {ENVIRONMENT} names, in the shape of the file")
    else:
        notes.append(
            f"a body of average proportions, {STATURE:.2f} m, stands in for the body model (see {ENVIRONMENT})"
        )
        notes += ["the shape of the body (betas) is left aside"] if shape is not None else []
    n = min(motion.rotations.shape[1], len(NAMES), len(own) if own is not None else len(NAMES))
    if motion.rotations.shape[1] > len(NAMES):
        n = _BODY  # what follows the body are the jaw and the fingers
        notes.append(f"{motion.rotations.shape[1] - _BODY} joints of hands and face are left out")
    offsets = (average_offsets() if own is None else own)[:n]
    skeleton = Skeleton(NAMES[:n], PARENTS[:n], offsets)
    return _upright(_clip(path, skeleton, motion, rate or _DEFAULT_FPS, n, tuple(notes)))


def _motion(path: str | Path, arrays: Arrays) -> _Motion:
    name = next((k for k in _POSES if k in arrays), "")
    if not name:
        raise RecordingError(path, "no poses in it", "arrays poses and trans")
    poses = as_floats(arrays[name])
    n = len(poses)
    turns = _turns(path, poses, name)
    root = next((arrays[k] for k in _ROOTS if k in arrays), None)
    if root is not None and turns.shape[1] in (21, 23):  # the body without its root
        turns = np.concatenate([_turns(path, as_floats(root), "root_orient"), turns], axis=1)
    if turns.shape[1] < _BODY:
        raise RecordingError(path, f"{turns.shape[1]} joints in {name}", f"at least {_BODY}")
    place = next((as_floats(arrays[k]) for k in _PLACES if k in arrays), np.zeros((n, 3)))
    if place.ndim != 2 or place.shape != (n, 3):
        raise RecordingError(path, f"translations of shape {place.shape}", f"({n}, 3)")
    if not (np.isfinite(turns).all() and np.isfinite(place).all() and np.abs(place).max(initial=0) < LARGEST):
        raise RecordingError(path, "poses or translations that are no numbers", "finite numbers")
    return _Motion(turns, place)


def _turns(path: str | Path, poses: np.ndarray, name: str) -> np.ndarray:
    """Quaternions ``(n, n_joints, 4)`` of axis-angle vectors or matrices, in whatever shape they come."""
    n = len(poses) if poses.ndim else 0
    if n and poses.ndim == 4 and poses.shape[2:] == (3, 3):
        return from_matrices(poses.reshape(-1, 3, 3)).reshape(n, -1, 4)
    if n and poses.ndim in (2, 3) and poses[0].size % 3 == 0 and (poses.ndim == 2 or poses.shape[2] == 3):
        with np.errstate(invalid="ignore", over="ignore"):
            turns: np.ndarray = quat.from_rotvec(poses.reshape(n, -1, 3))
        return turns
    raise RecordingError(path, f"{name} of shape {poses.shape}", "(frames, joints x 3), or (frames, joints, 3, 3)")


def _clip(path: str | Path, skeleton: Skeleton, motion: _Motion, fps: float, n: int, notes: tuple[str, ...]) -> Clip:
    lengths = np.linalg.norm(motion.rotations[:, :n], axis=2, keepdims=True)
    if not (lengths > 1e-6).all():
        raise RecordingError(path, "rotations that are none", "rotations")
    return Clip(
        name=recording_format(path)[0],
        skeleton=skeleton,
        fps=float(fps),
        root_positions=motion.root.astype(np.float32),
        rotations=(motion.rotations[:, :n] / lengths).astype(np.float32),
        notes=notes,
    )


def _upright(clip: Clip) -> Clip:
    """The clip turned so that Y points up: the poses of AMASS stand along Z, the body's rest does not."""
    step = max(1, clip.n_frames // 200)
    at = joint_positions(clip.cut(0, clip.n_frames))[::step].astype(float)
    names = clip.skeleton.names
    low = [names.index(f"{side}_ankle") for side in ("left", "right")]
    return turned(clip, upward(at[:, names.index("head")] - at[:, low].mean(axis=1)))


def _soma(path: str | Path, arrays: Arrays, rate: float | None) -> Clip:
    """Joints and their rotations in the world: exact offsets and local rotations."""
    joints, world = as_floats(arrays["posed_joints"]), as_floats(arrays["global_rot_mats"])
    known = {len(_SOMA): _SOMA, _BODY: tuple(zip(NAMES[:_BODY], PARENTS[:_BODY], strict=True))}
    n = joints.shape[1] if joints.ndim == 3 else 0
    if n not in known or world.shape != (len(joints), n, 3, 3) or joints.shape[2] != 3 or not len(joints):
        shapes = f"posed_joints {joints.shape} and global_rot_mats {world.shape}"
        raise RecordingError(path, shapes, "(frames, 30, 3) and (frames, 30, 3, 3)")
    names, parents = (tuple(part) for part in zip(*known[n], strict=True))
    turns = from_matrices(np.nan_to_num(world.reshape(-1, 3, 3))).reshape(len(joints), n, 4)
    notes = () if rate else ("frame rate: the file does not say it; taken as 30 frames per second",)
    return clip_of_world(path, names, parents, joints, turns, rate or 30.0, notes)
