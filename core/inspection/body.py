"""Doubts about the body and the space around it: size, which way is up, where the floor is, feet that slide."""

from __future__ import annotations

import numpy as np

from core.editing.contacts import floor_height, sole_points
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.units import LONGEST_BONE, SPANS, span

_FLOOR = 0.25  # metres from zero that are worth a word
_SLIDING, _LOW = 1.0, 0.03  # m/s of the slowest foot while the lowest is within 3 cm of the floor


def size_doubts(skeleton: Skeleton) -> list[Finding]:
    """Bones and bodies of a size that nobody has."""
    lengths = np.linalg.norm(skeleton.offsets, axis=1)
    longest = int(lengths.argmax())
    if lengths[longest] > LONGEST_BONE:
        parent = skeleton.names[skeleton.parents[longest]]
        words = f"{skeleton.names[longest]} is {lengths[longest]:.4g} m away from {parent}: no body is that large"
        return [Finding("size", words)]
    size = span(skeleton.parents, skeleton.offsets)
    if skeleton.n_joints > 5 and not SPANS[0] <= size <= SPANS[1]:
        words = f"the skeleton spans {size:.3g} m from tip to tip: not the size of a person; check the unit"
        return [Finding("size", words)]
    return []


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
