"""Foot contacts, and the foot-skate meter."""

from __future__ import annotations

import numpy as np

from core.arrays import FloatArray
from core.mocap.anatomy import SIDES, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions

# In body heights (and body heights a second): a contact begins below the first of each pair, lasts below the second.
_HEIGHT = (0.02, 0.03)
_SPEED = (0.2, 0.32)
_SLOW = 0.25
_SHORTEST, _GAP = 0.06, 0.05  # seconds: shorter contacts are dropped, shorter gaps closed
_SPEED_SPAN = 0.05  # seconds over which a speed is measured


def foot_contacts(clip: Clip, floor: float | None = None, positions: np.ndarray | None = None) -> np.ndarray:
    """Which foot stands on the floor, by height and speed with hysteresis: ``(n_frames, 2)`` bool, left then right.

    A foot stands when its lowest point (heel, ball or toe tip; each against its own height in a standing foot) is low
    and slow. Thresholds scale with the body height.
    floor: height of the floor, metres; estimated (:func:`floor_height`) where None.
    positions: joint positions ``(n_frames, n_joints, 3)``, if they are at hand.
    A foot that the skeleton lacks never stands.
    """
    anatomy = find_anatomy(clip.skeleton)
    positions = joint_positions(clip) if positions is None else positions
    floor = floor_height(clip, positions) if floor is None else floor
    contacts = np.zeros((clip.n_frames, 2), bool)
    for column, points in enumerate(sole_points(clip)):
        if points:
            height = heights(clip, positions, points, floor)
            speed = ground_speeds(positions[:, points], clip.fps)
            lowest = height.min(1, keepdims=True)
            low = lowest[:, 0] / anatomy.body_height
            # the point that stands may be about to change: the slowest of the nearly lowest counts
            near = height <= lowest + 0.005 * anatomy.body_height
            slow = np.where(near, speed, np.inf).min(1) / anatomy.body_height
            begins = (low < _HEIGHT[0]) & (slow < _SPEED[0])
            lasts = (low < _HEIGHT[1]) & (slow < _SPEED[1])
            contacts[:, column] = _clean(_hysteresis(begins, lasts), clip.fps)
    return contacts


def floor_height(clip: Clip, positions: np.ndarray | None = None) -> float:
    """Height of the floor, metres: where slow feet are (the lowest tenth of them), else the lowest twentieth of all.

    positions: joint positions ``(n_frames, n_joints, 3)``, if they are at hand.
    """
    positions = joint_positions(clip) if positions is None else positions
    feet = [points for points in sole_points(clip) if points]
    if not feet:
        return float(positions[..., 1].min())
    slow_speed = _SLOW * find_anatomy(clip.skeleton).body_height
    lowest = np.concatenate([positions[:, points, 1].min(1) for points in feet])
    slow = np.concatenate([ground_speeds(positions[:, points], clip.fps).min(1) < slow_speed for points in feet])
    return float(np.percentile(lowest[slow], 10) if slow.sum() > 0.1 * clip.fps else np.percentile(lowest, 5))


def foot_skate(clip: Clip, contacts: np.ndarray | None = None, floor: float | None = None) -> float:
    """Metres that the standing feet slide per second of contact; 0 where no foot ever stands.

    Measured at the point of the foot that is lowest in both of two neighbouring frames, so that rolling from heel to
    toe is no skate. contacts: ``(n_frames, 2)`` bool, found by :func:`foot_contacts` where None. floor: metres.
    """
    positions = joint_positions(clip)
    floor = floor_height(clip, positions) if floor is None else floor
    contacts = foot_contacts(clip, floor, positions) if contacts is None else contacts
    metres, seconds = slide(clip, contacts, floor, positions)
    return metres / seconds if seconds else 0.0


def slide(clip: Clip, contacts: np.ndarray, floor: float, positions: np.ndarray | None = None) -> tuple[float, float]:
    """Metres that the standing feet slide, and seconds that they stand, both feet added up; see :func:`foot_skate`.

    contacts: ``(n_frames, 2)`` bool; floor: metres; positions: ``(n_frames, n_joints, 3)``, if they are at hand.
    """
    positions = joint_positions(clip) if positions is None else positions
    slid, frames = 0.0, 0
    for column, points in enumerate(sole_points(clip)):
        both = contacts[1:, column] & contacts[:-1, column]
        if points and both.any():
            height = heights(clip, positions, points, floor)
            step = np.linalg.norm(np.diff(positions[:, points][..., [0, 2]], axis=0), axis=-1)
            lowest = (height[1:] + height[:-1]).argmin(1)[:, None]
            slid += float(np.take_along_axis(step, lowest, 1)[both].sum())
            frames += int(both.sum())
    return slid, frames / clip.fps


def heights(clip: Clip, positions: np.ndarray, points: list[int], floor: float) -> np.ndarray:
    """Heights of foot joints above where each is when the foot stands: ``(n_frames, len(points))``, metres.

    An ankle or a ball is above the floor in a standing foot; how far is read off the frames where it is slow.
    positions: ``(n_frames, n_joints, 3)``; floor: metres.
    """
    body = find_anatomy(clip.skeleton).body_height
    above = positions[:, points, 1].astype(np.float64) - floor
    slow = ground_speeds(positions[:, points], clip.fps) < _SLOW * body
    rest = [
        np.percentile(h[s], 10) if s.sum() > 0.1 * clip.fps else np.percentile(h, 5)
        for h, s in zip(above.T, slow.T, strict=True)
    ]
    height: np.ndarray = above - np.clip(rest, 0, 0.08 * body)
    return height


def runs(mask: np.ndarray) -> np.ndarray:
    """Runs of True in a mask ``(n,)`` as half-open rows ``(n_runs, 2)``."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    return edges.reshape(-1, 2)


def sole_points(clip: Clip) -> tuple[list[int], list[int]]:
    """Joint indices of each foot, left then right: the ankle and all below it; empty for a foot not there."""
    anatomy = find_anatomy(clip.skeleton)
    ankles = [anatomy.joints.get(f"{side}_ankle") for side in SIDES]
    left, right = ([] if ankle is None else list(anatomy.foot_joints(ankle)) for ankle in ankles)
    return left, right


def ground_speeds(points: np.ndarray, fps: float) -> np.ndarray:
    """Horizontal speeds ``(n_frames, n_points)``, metres a second, over 50 ms around each frame.

    points: ``(n_frames, n_points, 3)``, metres.
    """
    n, half = len(points), max(1, round(_SPEED_SPAN * fps / 2))
    after, before = np.minimum(np.arange(n) + half, n - 1), np.maximum(np.arange(n) - half, 0)
    way: FloatArray = np.linalg.norm((points[after] - points[before])[..., [0, 2]], axis=-1)
    speed: np.ndarray = way * fps / np.maximum(after - before, 1)[:, None]
    return speed


def _hysteresis(begins: np.ndarray, lasts: np.ndarray) -> np.ndarray:
    kept = np.zeros(len(lasts), bool)
    for start, end in runs(lasts):
        kept[start:end] = begins[start:end].any()
    return kept


def _clean(mask: np.ndarray, fps: float) -> np.ndarray:
    for start, end in runs(~mask):
        if end - start < _GAP * fps and start > 0 and end < len(mask):
            mask[start:end] = True
    for start, end in runs(mask):
        if end - start < _SHORTEST * fps:
            mask[start:end] = False
    return mask
