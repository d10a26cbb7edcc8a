"""Doubts about time: jumps between frames, a rest pose at the start, an impossible frame rate."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.reports import Finding

FASTEST = 12.0  # m/s of a joint against the pelvis; hands of sportsmen come near it
_OUTLIER = 5.0  # times as fast as the frames around it: motion has inertia, faults have none
_AROUND = 0.05  # seconds before and after that are looked at
_LEAD_IN = 2.0  # seconds in which a rest pose in front is looked for
_SLOWEST_RATE, _FASTEST_RATE = 10.0, 1000.0


class Jump(NamedTuple):
    """A joint is at one place in frame ``frame - 1`` and ``metres`` away in ``frame``."""

    frame: int
    joint: int
    metres: float


def find_jumps(clip: Clip, positions: np.ndarray) -> list[Jump]:
    """Steps from frame to frame that no body can make: above 12 m/s and five times the speed just before or after.

    positions: (n_frames, n_joints, 3), metres, world. The joint named is the one that moves furthest against the
    pelvis, or the pelvis where the whole body jumps.
    """
    if clip.n_frames < 3:
        return []
    local = positions - positions[:, :1]
    local[:, 0] = positions[:, 0]
    steps = np.linalg.norm(np.diff(local, axis=0), axis=-1)
    fast = np.flatnonzero((steps * clip.fps > FASTEST).any(axis=1))
    reach = max(2, round(_AROUND * clip.fps))
    jumps = []
    for step in fast:
        joint = int(steps[step].argmax())
        around = np.concatenate([steps[max(step - reach, 0) : step, joint], steps[step + 1 : step + 1 + reach, joint]])
        # A flip that comes back is two jumps, so the middle of the neighbours counts, not their largest.
        if steps[step, joint] > _OUTLIER * np.median(around):
            jumps.append(Jump(int(step) + 1, joint, float(steps[step, joint])))
    return jumps


def rest_pose_frames(clip: Clip, positions: np.ndarray, jumps: list[Jump]) -> tuple[int, str]:
    """How many frames in front do not belong to the motion (arms in a T-pose or nothing turned, then a jump), and why.

    positions: (n_frames, n_joints, 3), metres, world.
    """
    early = [jump for jump in jumps if jump.frame <= _LEAD_IN * clip.fps]
    if not early:
        return 0, ""
    first = max(early, key=lambda jump: jump.metres).frame
    if _arms_stretched(clip, positions[:first]):
        return first, "arms in a T-pose"
    if np.abs(clip.rotations[:first, :, 0]).min() > 1 - 1e-6:
        return first, "a rest pose, nothing turned"
    return 0, ""


def rate_doubts(clip: Clip, positions: np.ndarray) -> list[Finding]:
    """Doubts about the frame rate: an unusual rate, repeated frames.

    positions: (n_frames, n_joints, 3), metres, world.
    """
    doubts = []
    if not _SLOWEST_RATE <= clip.fps <= _FASTEST_RATE:
        words = f"{clip.fps:.4g} frames per second: few people record at such a rate; check the frame time"
        doubts.append(Finding("rate", words))
    if clip.n_frames <= 20:
        return doubts
    still = np.abs(np.diff(positions, axis=0)).max(axis=(1, 2)) < 1e-6
    if still.all():
        return [*doubts, Finding("still", "nothing moves in any frame")]
    for times in (2, 3, 4, 5):
        # frames that come in packs of equal ones: all steps stand still but every second (third ...)
        moves = [(~still[k::times]).mean() for k in range(times)]
        if max(moves) > 0.8 and sum(moves) - max(moves) < 0.05 and still.mean() > 0.4:
            rate = clip.fps / times
            words = f"every frame comes {times} times: the motion was recorded at {rate:.4g} frames per second"
            doubts.append(Finding("rate", words))
            break
    return doubts


def _arms_stretched(clip: Clip, positions: np.ndarray) -> bool:
    joints = find_anatomy(clip.skeleton).joints
    if any(f"{side}_{part}" not in joints for side in SIDES for part in ("shoulder", "elbow", "wrist")):
        return False
    arms = []
    for side in SIDES:
        shoulder, elbow, wrist = (positions[:, joints[f"{side}_{part}"]] for part in ("shoulder", "elbow", "wrist"))
        upper, lower, arm = (_unit(v) for v in (elbow - shoulder, wrist - elbow, wrist - shoulder))
        if ((upper * lower).sum(-1) < 0.9).any() or (np.abs(arm[:, 1]) > 0.5).any():
            return False
        arms.append(arm)
    return bool(((arms[0] * arms[1]).sum(-1) < -0.7).all())


def _unit(v: FloatArray) -> FloatArray:
    length: FloatArray = np.linalg.norm(v, axis=-1, keepdims=True)
    return v / np.maximum(length, 1e-9)
