"""Transitions: align two motions on the ground plane, register their times, cross-fade, join.

Ground-plane fit of weighted point clouds as in Kovar, Gleicher and Pighin, "Motion Graphs" (2002).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from core.arrays import FloatArray
from core.editing.legs import smooth_step
from core.editing.steps import step_across
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip, Segment
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from core.sequences.warping import warp_path


@dataclass(frozen=True)
class Transition:
    """Where and how one motion passes into another.

    exit: first frame of the first motion that is blended; entry: the frame of the second that stands beside it.
    yaw (radians, about vertical Y) and translation ``(3,)`` (metres, on the ground) place the second motion.
    cost: metres, root mean square distance of the joints over the blended frames.
    """

    exit: int
    entry: int
    yaw: float
    translation: np.ndarray
    cost: float


def ground_fit(
    a: np.ndarray, b: np.ndarray, weights: np.ndarray | None = None, yaw: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The turn about the vertical and the shift on the ground that lay ``b`` best upon ``a``.

    a, b: point clouds ``(..., n_points, 3)``, metres; weights ``(n_points,)``, alike for all where None.
    yaw: ``(...)``, radians, where the turn is given and only the shift is sought.
    Returns yaw ``(...)``, translation ``(..., 3)`` and the weighted root mean square distance left, ``(...)``, metres.
    """
    a, b = np.asarray(a, np.float64), np.asarray(b, np.float64)
    w = np.full(a.shape[-2], 1.0) if weights is None else np.asarray(weights, np.float64)
    w = w / w.sum()
    ground = np.array([1.0, 0, 1.0])
    centre_a, centre_b = (np.einsum("p,...pi->...i", w, x) * ground for x in (a, b))
    da, db = a - centre_a[..., None, :], b - centre_b[..., None, :]
    if yaw is None:
        sine = np.einsum("p,...p->...", w, da[..., 0] * db[..., 2] - da[..., 2] * db[..., 0])
        cosine = np.einsum("p,...p->...", w, da[..., 0] * db[..., 0] + da[..., 2] * db[..., 2])
        yaw = np.arctan2(sine, cosine)
    turned = turn_about_y(yaw[..., None], db)
    left = np.sqrt(np.einsum("p,...p->...", w, ((turned - da) ** 2).sum(-1)))
    return yaw, centre_a - turn_about_y(yaw, centre_b), left


def turn_about_y(yaw: np.ndarray | float, points: np.ndarray) -> np.ndarray:
    """Points ``(..., 3)`` turned about the vertical by ``yaw`` ``(...)``, radians, broadcast."""
    c, s = np.cos(yaw), np.sin(yaw)
    x, y, z = np.moveaxis(np.asarray(points), -1, 0)
    return np.stack(np.broadcast_arrays(c * x + s * z, y, c * z - s * x), axis=-1)


def heading(clip: Clip, positions: np.ndarray | None = None) -> np.ndarray:
    """Where the body faces, from hips and shoulders: ``(n_frames,)`` radians about Y, 0 along Z, pi/2 along X.

    positions: joint positions ``(n_frames, n_joints, 3)``, if they are at hand. Zero for a body without sides.
    """
    joints = find_anatomy(clip.skeleton).joints
    positions = joint_positions(clip) if positions is None else positions
    left = np.zeros((len(positions), 3))
    for part in ("hip", "shoulder"):
        if {f"left_{part}", f"right_{part}"} <= set(joints):
            across = positions[:, joints[f"left_{part}"]] - positions[:, joints[f"right_{part}"]]
            left += across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-9)
    return np.arctan2(-left[:, 2], left[:, 0])


def place(clip: Clip, yaw: float, translation: np.ndarray) -> Clip:
    """The clip turned about the vertical by ``yaw`` (radians), then shifted by ``translation`` ``(3,)``, metres."""
    rotations = np.array(clip.rotations, np.float32)
    rotations[:, 0] = quat.multiply(quat.from_yaw(np.float64(yaw)), rotations[:, 0])
    root = turn_about_y(np.float64(yaw), clip.root_positions) + translation
    return replace(clip, root_positions=root.astype(np.float32), rotations=rotations)


def blend(a: Clip, b: Clip, weights: np.ndarray) -> Clip:
    """A blend of two clips of one skeleton and length, frame by frame; weights ``(n_frames,)``: 0 is a, 1 is b.

    Rotations along great arcs, the shortest but for joints that turn past half a turn from one another on the way: they
    keep to one side. Root positions in a straight line. Raises ValueError where skeletons or lengths differ.
    """
    if a.skeleton != b.skeleton or a.n_frames != b.n_frames:
        raise ValueError(f"{a.name} and {b.name} differ in skeleton or length and cannot be blended")
    w = np.asarray(weights, np.float64)
    root = a.root_positions * (1 - w[:, None]) + b.root_positions * w[:, None]
    turns = quat.continuous(quat.multiply(quat.conjugate(a.rotations.astype(np.float64)), b.rotations))
    turns = np.where(turns[..., 0].sum(0)[:, None] < 0, -turns, turns)
    sine = np.linalg.norm(turns[..., 1:], axis=-1, keepdims=True)
    arcs = turns[..., 1:] / np.maximum(sine, 1e-9) * (2 * np.arctan2(sine, turns[..., :1]))
    rotations = quat.multiply(a.rotations, quat.from_rotvec(arcs * w[:, None, None]))
    return replace(a, root_positions=root.astype(np.float32), rotations=rotations.astype(np.float32), translations={})


def crossfade_weights(n: int) -> np.ndarray:
    """Quintic weights ``(n,)`` from just above 0 to just below 1, so that both motions join without a jump."""
    return smooth_step(np.arange(1, n + 1) / (n + 1))


def register(a: np.ndarray, b: np.ndarray, method: str = "linear") -> tuple[np.ndarray, np.ndarray]:
    """Which frames of two motions belong together: two rising ``(k,)`` float arrays of frame numbers.

    a, b: features ``(n, d)`` and ``(m, d)``, such as joint positions after :func:`ground_fit`; k is about their mean.
    method: ``"linear"`` or ``"dtw"`` (dynamic time warping; its staircase is taken at even steps of n + m).
    Raises ValueError for another method.
    """
    n, m = len(a), len(b)
    k = max(2, round((n + m) / 2))
    if method == "linear":
        return np.linspace(0, n - 1, k), np.linspace(0, m - 1, k)
    if method != "dtw":
        raise ValueError(f"time registration is 'linear' or 'dtw', not {method!r}")
    path = np.asarray(warp_path(a, b), np.float64)
    along = path.sum(1)
    steps = np.linspace(0, n + m - 2, k)
    return np.interp(steps, along, path[:, 0]), np.interp(steps, along, path[:, 1])


def find_transition(
    a: Clip, b: Clip, seconds: float = 0.3, exit_window: float = 0.0, entry_window: float = 0.0
) -> Transition:
    """The best place to pass from ``a`` to ``b`` in a cross-fade of ``seconds``.

    The exit lies within the last ``exit_window`` seconds before the latest possible one, the entry within the first
    ``entry_window``. Facing from hips and shoulders, place from a fit in which feet count threefold.
    Raises ValueError where skeletons or frame rates differ.
    """
    if a.skeleton != b.skeleton or abs(a.fps - b.fps) > 1e-3:
        raise ValueError(f"{a.name} and {b.name} differ in skeleton or frame rate and cannot be joined")
    n = min(max(2, round(seconds * a.fps)), a.n_frames, b.n_frames)
    latest, last_entry = a.n_frames - n, min(round(entry_window * b.fps), b.n_frames - n)
    exits = np.arange(latest, max(latest - round(exit_window * a.fps), 0) - 1, -2)[::-1]
    entries = np.arange(0, last_entry + 1, 2)
    frames = np.unique(np.linspace(0, n - 1, 8).round().astype(int))
    tail, head = a.cut(int(exits[0]), a.n_frames), b.cut(0, int(entries[-1]) + n)
    pa, pb = joint_positions(tail), joint_positions(head)
    at_a, at_b = exits[:, None] - exits[0] + frames, entries[:, None] + frames
    turns = _mean_angle(heading(tail, pa)[at_a])[:, None] - _mean_angle(heading(head, pb)[at_b])[None]
    weights = np.tile(joint_weights(a.skeleton), len(frames))
    clouds_a, clouds_b = (p[at].reshape(len(at), -1, 3) for p, at in ((pa, at_a), (pb, at_b)))
    _, shifts, costs = ground_fit(clouds_a[:, None], clouds_b[None], weights, turns)
    i, k = np.unravel_index(costs.argmin(), costs.shape)
    return Transition(int(exits[i]), int(entries[k]), float(turns[i, k]), shifts[i, k], float(costs[i, k]))


def join(
    a: Clip,
    b: Clip,
    seconds: float = 0.3,
    exit_window: float = 0.0,
    entry_window: float = 0.0,
    registration: str = "linear",
    steps: bool = True,
    name: str | None = None,
) -> tuple[Clip, Segment]:
    """``a``, a cross-fade of about ``seconds``, then ``b`` placed where it fits; and the segment of the cross-fade.

    Windows as in :func:`find_transition`; registration as in :func:`register`; steps: feet that stand in both motions
    step across (:func:`core.editing.steps.step_across`) instead of sliding. ``a`` stays where it is.
    Raises ValueError where skeletons or frame rates differ.
    """
    way = find_transition(a, b, seconds, exit_window, entry_window)
    before, seam, after = pieces(a, b, way, seconds, registration, steps)
    clip = concatenate([piece for piece in (before, seam, after) if piece is not None], name or f"{a.name}+{b.name}")
    return clip, Segment(clip.name, way.exit, way.exit + seam.n_frames)


def pieces(
    a: Clip,
    b: Clip,
    way: Transition,
    seconds: float,
    registration: str = "linear",
    steps: bool = True,
    floor: float | None = None,
) -> tuple[Clip | None, Clip, Clip | None]:
    """The parts of a join, the second motion placed: a before the seam, the cross-fade, b after it (None: empty).

    registration and steps as in :func:`join`; floor: metres, or None to estimate it where feet step.
    """
    n = min(max(2, round(seconds * a.fps)), a.n_frames - way.exit, b.n_frames - way.entry)
    b = place(b.cut(way.entry, b.n_frames), way.yaw, way.translation)
    first, second = a.cut(way.exit, way.exit + n), b.cut(0, n)
    if registration != "linear":
        flat = joint_positions(first).reshape(n, -1), joint_positions(second).reshape(n, -1)
        in_first, in_second = register(*flat, method=registration)
        first, second = at_frames(first, in_first), at_frames(second, in_second)
    seam = blend(first, second, crossfade_weights(first.n_frames))
    if steps:
        seam = step_across(first, second, seam, floor)
    before = a.cut(0, way.exit) if way.exit else None
    return before, seam, b.cut(n, b.n_frames) if b.n_frames > n else None


def at_frames(clip: Clip, frames: np.ndarray) -> Clip:
    """The clip read at fractional frame numbers ``(k,)``: root linear, rotations along great arcs."""
    low = np.clip(np.floor(frames).astype(int), 0, clip.n_frames - 1)
    high, t = np.minimum(low + 1, clip.n_frames - 1), np.asarray(frames) - low
    root = clip.root_positions[low] * (1 - t[:, None]) + clip.root_positions[high] * t[:, None]
    rotations = quat.slerp(clip.rotations[low].astype(np.float64), clip.rotations[high].astype(np.float64), t[:, None])
    return replace(
        clip, root_positions=root.astype(np.float32), rotations=rotations.astype(np.float32), translations={}
    )


def concatenate(clips: Sequence[Clip], name: str) -> Clip:
    """Clips of one skeleton and rate, one after another, rotations without sign flips. Raises ValueError for none."""
    if not clips:
        raise ValueError("nothing to concatenate")
    rotations = quat.continuous(np.concatenate([clip.rotations for clip in clips]))
    root = np.concatenate([clip.root_positions for clip in clips])
    return replace(clips[0], name=name, root_positions=root, rotations=rotations, translations={})


def joint_weights(skeleton: Skeleton) -> np.ndarray:
    """How much joints count when motions are laid upon one another, ``(n_joints,)``: feet threefold, fingers not."""
    anatomy = find_anatomy(skeleton)
    weights = np.zeros(skeleton.n_joints)
    weights[[0, *anatomy.posture_joints]] = 1.0
    for ankle, _ in anatomy.feet:
        weights[list(anatomy.foot_joints(ankle))] = 3.0
    return weights


def _mean_angle(angles: FloatArray) -> np.ndarray:
    mean: np.ndarray = np.arctan2(np.sin(angles).mean(-1), np.cos(angles).mean(-1))
    return mean
