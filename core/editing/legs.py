"""Legs: two-bone inverse kinematics, feet that stay where they stand, a body that stays above the floor."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d, maximum_filter1d

from core.arrays import FloatArray
from core.editing.contacts import floor_height, foot_contacts, heights, runs, sole_points
from core.mocap import quaternions as quat
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics, joint_positions

# A leg never straightens beyond the first share of its length (at 1 the knee angle is all noise), and is held back from
# the second share on.
_STRETCH, _SOFT = 0.999, 0.97
_FARTHEST = 0.1  # body heights that a locked foot is moved at most
_FOLLOW, _SINK = 0.15, 0.02  # seconds over which the pelvis follows its feet; body heights it sinks at most


def smooth_step(u: np.ndarray | float) -> np.ndarray:
    """Quintic from 0 to 1 with no speed and no acceleration at either end, ``(...)`` to ``(...)``; clipped."""
    u = np.clip(u, 0, 1)
    step: np.ndarray = u**3 * (u * (6 * u - 15) + 10)
    return step


def place_ankles(clip: Clip, targets: np.ndarray, orientations: np.ndarray | None = None) -> Clip:
    """The clip with its ankles at ``targets`` ``(n_frames, 2, 3)``, metres, world, left then right.

    Two-bone leg IK: bone lengths stay, the knee keeps the direction of its hinge, the foot keeps its orientation in the
    world, or takes that of ``orientations`` ``(n_frames, 2, 4)``. A target (nearly) out of reach
    is reached for, softly, so that knees do not pop. Frames whose target is not finite, and legs the
    skeleton lacks, are left as they are.
    """
    anatomy = find_anatomy(clip.skeleton)
    positions, world = (a.astype(np.float64) for a in forward_kinematics(clip))
    rotations = np.array(clip.rotations, np.float64)
    for column, side in enumerate(SIDES):
        leg = [anatomy.joints.get(f"{side}_{part}", -1) for part in ("hip", "knee", "ankle")]
        frames = np.flatnonzero(np.isfinite(targets[:, column]).all(1))
        if min(leg) >= 0 and len(frames):
            turns = _leg_turns(positions[:, leg], world[:, leg[0]], targets[:, column], frames)
            foot = world[frames, leg[2]] if orientations is None else orientations[frames, column]
            _turn(clip, leg, turns, world, rotations, frames, foot)
    return replace(clip, rotations=quat.normalise(rotations).astype(np.float32))


def lock_feet(
    clip: Clip,
    contacts: np.ndarray | None = None,
    floor: float | None = None,
    ease: float = 0.15,
    lifts: np.ndarray | None = None,
    farthest: float = _FARTHEST,
) -> Clip:
    """The clip with the slide taken out of its standing feet, and their soles on the floor.

    Within a contact the ankle is shifted against the slide of the point the foot stands on, so the foot still rolls
    from heel to toe; the shift eases in and out over ``ease`` seconds on either side, at the speed it has there. The
    pelvis goes along with half of what its standing feet move, and sinks where a leg would not reach.
    contacts: ``(n_frames, 2)`` bool, as :func:`core.editing.contacts.foot_contacts` finds them; floor: metres, or None
    to estimate it; lifts: ``(n_frames, 2)`` metres by which feet are raised besides; farthest: body heights that a foot
    is moved at most.
    """
    positions = joint_positions(clip).astype(np.float64)
    floor = floor_height(clip, positions) if floor is None else floor
    contacts = foot_contacts(clip, floor, positions) if contacts is None else contacts
    shifts = np.zeros((clip.n_frames, 2, 3))
    targets = np.full((clip.n_frames, 2, 3), np.nan)
    for column, points in enumerate(sole_points(clip)):
        if points:
            if contacts[:, column].any():
                shifts[:, column] = _shift(clip, positions, points, contacts[:, column], floor, ease, farthest)
            if lifts is not None:
                shifts[:, column, 1] += lifts[:, column]
            targets[:, column] = positions[:, points[0]] + shifts[:, column]
    if not shifts.any():
        return clip
    return place_ankles(_follow(clip, positions, contacts, shifts, targets), targets)


def lift_from_floor(clip: Clip, floor: float = 0.0, smooth: float = 0.1) -> Clip:
    """The clip raised, smoothly over ``smooth`` seconds, wherever a joint would be below ``floor`` (metres)."""
    sunk = np.maximum(0, floor - joint_positions(clip)[..., 1].min(1).astype(np.float64))
    if not sunk.any():
        return clip
    width = max(1, round(smooth * clip.fps))
    lift = gaussian_filter1d(maximum_filter1d(sunk, 2 * width + 1), width / 2)
    root = np.array(clip.root_positions, np.float32)
    root[:, 1] += lift.astype(np.float32)
    return replace(clip, root_positions=root)


def _leg_turns(
    leg: np.ndarray, hip: np.ndarray, targets: np.ndarray, frames: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """World turns of thigh and shin, ``(len(frames), 4)`` each, that bring the ankle to its target.

    leg: (n_frames, 3, 3) hip, knee, ankle; hip: (n_frames, 4) world rotation of the thigh.
    """
    thigh, shin = leg[:, 1] - leg[:, 0], leg[:, 2] - leg[:, 1]
    hinge = _hinge(thigh, shin, hip)[frames]
    thigh, shin, want = thigh[frames], shin[frames], targets[frames] - leg[frames, 0]
    a, b = np.linalg.norm(thigh, axis=1), np.linalg.norm(shin, axis=1)
    reach = _soft_reach(np.linalg.norm(want, axis=1), np.linalg.norm(thigh + shin, axis=1), a + b)
    reach = np.maximum(reach, np.abs(a - b) + 1e-3 * (a + b))
    now = np.arctan2(np.einsum("ij,ij->i", np.cross(thigh, shin), hinge), np.einsum("ij,ij->i", thigh, shin))
    bend = np.arccos(np.clip((reach**2 - a**2 - b**2) / (2 * a * b), -1, 1))
    knee = quat.from_rotvec(hinge * (bend - now)[:, None])
    return _shortest_turn(thigh + quat.rotate(knee, shin), want), knee


def _soft_reach(want: FloatArray, now: FloatArray, length: FloatArray) -> FloatArray:
    """Wanted distances (n,) from hip to ankle, bent so that a leg nears its full length slowly: knees do not pop."""
    soft, hard = _SOFT * length, _STRETCH * length
    eased = np.where(want > soft, soft + (hard - soft) * np.tanh((want - soft) / (hard - soft)), want)
    reach: FloatArray = np.where(want > now, np.maximum(eased, np.minimum(now, hard)), np.minimum(want, hard))
    return reach


def _hinge(thigh: np.ndarray, shin: np.ndarray, hip: np.ndarray) -> np.ndarray:
    """Unit axis of the knee in the world, ``(n_frames, 3)``: this frame's, or the clip's where the leg is straight."""
    axis = np.cross(thigh, shin) / (np.linalg.norm(thigh, axis=1) * np.linalg.norm(shin, axis=1))[:, None]
    usual = quat.rotate(quat.conjugate(hip), axis).sum(0)
    length = np.linalg.norm(usual)
    usual = usual / length if length > 1e-6 else np.array([1.0, 0, 0])
    usual = quat.rotate(hip, np.broadcast_to(usual, axis.shape))
    # a knee bends one way only: an axis against the usual one is a straight leg's noise
    axis = np.where((axis * usual).sum(1, keepdims=True) > 0, axis, 0) + 0.1 * usual
    axis -= thigh * ((axis * thigh).sum(1) / (thigh**2).sum(1))[:, None]
    return quat.normalise(axis)


def _shortest_turn(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    axis = np.cross(a, b)
    sine = np.linalg.norm(axis, axis=1, keepdims=True)
    angle = np.arctan2(sine[:, 0], (a * b).sum(1))
    return quat.from_rotvec(axis / np.maximum(sine, 1e-12) * angle[:, None])


def _turn(
    clip: Clip,
    leg: list[int],
    turns: tuple[np.ndarray, np.ndarray],
    world: np.ndarray,
    rotations: np.ndarray,
    frames: np.ndarray,
    foot: np.ndarray,
) -> None:
    """Write the turns into the local rotations of hip, knee and ankle; foot: the ankle's world rotation."""
    swing, bend = turns
    both = quat.multiply(swing, bend)
    parents = [clip.skeleton.parents[j] for j in leg]
    above = [world[frames, parents[0]] if parents[0] >= 0 else np.array([1.0, 0, 0, 0])]
    above += [quat.multiply(swing, world[frames, parents[1]]), quat.multiply(both, world[frames, parents[2]])]
    new = [quat.multiply(swing, world[frames, leg[0]]), quat.multiply(both, world[frames, leg[1]]), foot]
    for joint, parent, rotation in zip(leg, above, new, strict=True):
        rotations[frames, joint] = quat.multiply(quat.conjugate(parent), rotation)


def _shift(
    clip: Clip,
    positions: np.ndarray,
    points: list[int],
    contact: np.ndarray,
    floor: float,
    ease: float,
    farthest: float,
) -> np.ndarray:
    """How far to move the ankle in each frame: (n_frames, 3), metres."""
    body = find_anatomy(clip.skeleton).body_height
    height = heights(clip, positions, points, floor)
    # the foot stands on the point that is lowest in both of two neighbouring frames
    lowest = (height[1:] + height[:-1]).argmin(1)
    slide = np.take_along_axis(np.diff(positions[:, points], axis=0), lowest[:, None, None], 1)[:, 0]
    shift = np.zeros((len(contact), 3))
    spans = runs(contact)
    for start, end in spans:
        shift[start + 1 : end, [0, 2]] = -np.cumsum(slide[start : end - 1][:, [0, 2]], axis=0)
        shift[start:end] -= shift[start:end].mean(0)
        shift[start:end, 1] = -height[start:end].min(1)
    # nearly untouched up to the limit, never beyond it
    share = np.linalg.norm(shift, axis=1, keepdims=True) / (farthest * body)
    shift /= (1 + share**4) ** 0.25
    _ease(shift, spans, max(1, round(ease * clip.fps)))
    shift[:, 1] = gaussian_filter1d(shift[:, 1], 0.015 * clip.fps, mode="nearest")
    return shift


def _ease(shift: np.ndarray, spans: np.ndarray, n: int) -> None:
    """Let the shift fade in before each contact and out after it, in place; tails end where the next contact begins.

    Outside it goes on as it goes at the edge: the foot comes to its stand, and leaves it, without a jerk.
    """
    before, after = np.r_[0, spans[:-1, 1]], np.r_[spans[1:, 0], len(shift)]
    held, level = shift.copy(), np.array([1.0, 0, 1])
    for (start, end), low, high in zip(spans, before, after, strict=True):
        k = min(3, end - start - 1)
        into, out = (level * (held[b] - held[a]) / max(k, 1) for a, b in ((start, start + k), (end - 1 - k, end - 1)))
        lead, trail = np.arange(min(n, start - low), 0, -1), np.arange(1, min(n, high - end) + 1)
        fade = smooth_step(1 - lead / (len(lead) + 1))[:, None]
        shift[start - len(lead) : start] += fade * (held[start] - lead[:, None] * into)
        fade = smooth_step(1 - trail / (len(trail) + 1))[:, None]
        shift[end : end + len(trail)] += fade * (held[end - 1] + trail[:, None] * out)


def _follow(clip: Clip, positions: np.ndarray, contacts: np.ndarray, shifts: np.ndarray, targets: np.ndarray) -> Clip:
    """The clip with its pelvis moved for its feet: half their mean shift, and down where a leg that stands is short."""
    width = _FOLLOW * clip.fps
    move = gaussian_filter1d(0.5 * shifts.mean(1), width, axis=0, mode="nearest")
    sink = np.zeros(clip.n_frames)
    joints, bones = find_anatomy(clip.skeleton).joints, np.linalg.norm(clip.skeleton.offsets, axis=1)
    for column, side in enumerate(SIDES):
        hip, knee, ankle = (joints.get(f"{side}_{part}", -1) for part in ("hip", "knee", "ankle"))
        if min(hip, knee, ankle) >= 0:
            ways = positions[:, ankle], targets[:, column] - move
            now, want = (np.linalg.norm(x - positions[:, hip], axis=1) for x in ways)
            missing = want - np.maximum(now, _SOFT * (bones[knee] + bones[ankle]))
            sink = np.maximum(sink, missing * contacts[:, column])
    sink = np.minimum(sink, _SINK * find_anatomy(clip.skeleton).body_height)
    reach = 2 * round(width) + 1
    move[:, 1] -= gaussian_filter1d(maximum_filter1d(sink, reach), width / 2, mode="nearest")
    return replace(clip, root_positions=(clip.root_positions + move).astype(np.float32))
