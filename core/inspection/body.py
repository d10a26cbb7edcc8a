"""Doubts about the body and the space around it: size, which way is up, where the floor is, feet that slide."""

from __future__ import annotations

import numpy as np

from core.editing.contacts import floor_height, sole_points
from core.mocap.anatomy import Anatomy, find_anatomy
from core.mocap.clip import Clip
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.units import LONGEST_BONE, SPANS, height_doubt, span

_FLOOR = 0.25  # metres from zero that are worth a word
_FEW = 5  # joints, tips among them: what has no more may have any size
_FOUR_LIMBS = 12  # joints of two arms and two legs: what has fewer is nobody's animal either
_FOOT, _BEND = 0.04, 0.04  # of the body's height: how far toes or knees must stand out to show the way forward
_SWAPPED = 0.85  # share of the frames in which left is on the right
_SLIDING, _LOW = 1.0, 0.03  # m/s of the slowest foot while the lowest is within 3 cm of the floor


def size_doubts(skeleton: Skeleton) -> list[Finding]:
    """Bones and bodies of impossible size."""
    lengths = np.linalg.norm(skeleton.offsets, axis=1)
    longest = int(lengths.argmax())
    if lengths[longest] > LONGEST_BONE:
        parent = skeleton.names[skeleton.parents[longest]]
        words = f"{skeleton.names[longest]} is {lengths[longest]:.4g} m away from {parent}: no body is that large"
        return [Finding("size", words)]
    if words := height_doubt(skeleton):
        return [Finding("size", words)]
    size = span(skeleton.parents, skeleton.offsets)
    if skeleton.n_joints > _FEW and find_anatomy(skeleton).body == "other" and not SPANS[0] <= size <= SPANS[1]:
        words = f"the skeleton spans {size:.3g} m from tip to tip: not the size of a person; check the unit"
        return [Finding("size", words)]
    return []


def body_doubts(skeleton: Skeleton) -> list[Finding]:
    """What is no human, and what is a part of one."""
    anatomy = find_anatomy(skeleton)
    if anatomy.body == "partial":
        return [Finding("body", f"a part of a human body: no {', no '.join(anatomy.missing)}")]
    if anatomy.body == "other" and skeleton.n_joints >= _FOUR_LIMBS:
        words = "no human body is recognised (an animal, a prop?): it is compared with clips of its own rig only"
        return [Finding("body", words)]
    return []


def side_doubts(clip: Clip, positions: np.ndarray) -> list[Finding]:
    """Whether what is called left lies on the body's right, as in a mirrored export.

    positions: (n_frames, n_joints, 3), metres, world. Forward is where the toes point and where the knees bend to.
    """
    anatomy = find_anatomy(clip.skeleton)
    joints = anatomy.joints
    pair = next((p for p in ("hip", "shoulder") if {f"left_{p}", f"right_{p}"} <= joints.keys()), "")
    if not pair or not anatomy.head_tip:
        return []
    left = positions[:, joints[f"left_{pair}"]] - positions[:, joints[f"right_{pair}"]]
    up = positions[:, anatomy.head_tip] - positions[:, 0]
    votes = []
    for forward, least in ((_toes(anatomy, positions), _FOOT), (_knees(anatomy, positions), _BEND)):
        if forward is None:
            continue
        across = np.cross(up, forward)
        size = np.linalg.norm(across, axis=1) / np.maximum(np.linalg.norm(up, axis=1), 1e-9)
        clear = size > least * anatomy.body_height
        if clear.any():
            votes.append(float(np.mean((across * left).sum(1)[clear] < 0)))
    if votes and min(votes) > _SWAPPED:
        words = "left and right seem swapped: what is called left lies on the body's right, as in a mirrored export"
        return [Finding("sides", words)]
    return []


def _toes(anatomy: Anatomy, positions: np.ndarray) -> np.ndarray | None:
    """Where the feet point, ``(n, 3)``: from the ankles to what lies furthest from them below."""
    lines = []
    for ankle, _ in anatomy.feet:
        below = list(anatomy.foot_joints(ankle))
        away = positions[:, below] - positions[:, [ankle]]
        lines.append(away[:, int(np.linalg.norm(away, axis=-1).mean(0).argmax())])
    return np.sum(lines, axis=0) if lines else None


def _knees(anatomy: Anatomy, positions: np.ndarray) -> np.ndarray | None:
    """Where the knees are against the line from hip to ankle, ``(n, 3)``, both legs together."""
    lines = []
    for hip, knee, ankle in anatomy.legs:
        leg = positions[:, ankle] - positions[:, hip]
        out = positions[:, knee] - positions[:, hip]
        share = (out * leg).sum(1) / np.maximum((leg * leg).sum(1), 1e-9)
        lines.append(out - share[:, None] * leg)
    return np.sum(lines, axis=0) if lines else None


def up_doubts(clip: Clip, positions: np.ndarray) -> list[Finding]:
    """Whether the head is above the feet most of the time. positions: (n_frames, n_joints, 3), metres, world."""
    anatomy = find_anatomy(clip.skeleton)
    if not anatomy.legs or anatomy.head_tip == 0:
        return []
    feet = np.mean([positions[:, ankle] for _, _, ankle in anatomy.legs], axis=0)
    upright = np.median(positions[:, anatomy.head_tip] - feet, axis=0)
    upright /= max(float(np.linalg.norm(upright)), 1e-9)
    axis = int(np.abs(upright).argmax())
    if axis == 1 and upright[1] < 0:
        words = "the head is below the feet most of the time: a handstand, or Y points down in this file"
        return [Finding("up", words)]
    if axis != 1 and abs(upright[axis]) > 0.9:
        sign = "" if upright[axis] > 0 else "-"
        words = f"the body lies along {sign}{'XYZ'[axis]} most of the time: a person lying, or a file with Z up"
        return [Finding("up", words)]
    return []


def floor_notes(clip: Clip, positions: np.ndarray) -> tuple[list[Finding], list[str]]:
    """Doubts (feet that slide) and remarks (a floor that is not at zero).

    positions: (n_frames, n_joints, 3), metres, world.
    """
    soles = [points for points in sole_points(clip) if points]
    if not soles or clip.n_frames < 3:
        return [], []
    floor = floor_height(clip, positions)
    remarks = [f"the floor is at {floor:.2f} m, not at 0"] if abs(floor) > _FLOOR else []
    speeds, heights = [], []
    for points in soles:
        foot = positions[:, points]
        step = np.linalg.norm(np.diff(foot[..., [0, 2]], axis=0), axis=-1).min(1)
        speeds.append(step * clip.fps)
        heights.append(foot[1:, :, 1].min(1))
    low = np.min(heights, axis=0) < np.percentile(np.min(heights, axis=0), 10) + _LOW
    sliding = float(np.median(np.min(speeds, axis=0)[low])) if low.sum() > clip.fps else 0.0
    doubts = []
    if sliding > _SLIDING:
        words = f"the feet slide: both move at {sliding:.1f} m/s or more half the time they are near the floor"
        doubts.append(Finding("sliding", words))
    return doubts, remarks
