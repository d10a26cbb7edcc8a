"""Aligns two motions frame by frame, for a long blend in which each keeps its own path over the ground.

Laying the second motion once, as for a short cross-fade, lets the two drift apart before and after that moment, and the
blend would drag the feet from one place to the other. Instead the turn and shift between them are found for every pair
of frames, and the blend travels as the two travel, each by its weight.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.ndimage import gaussian_filter1d

from core.editing.blending import ground_fit, heading, turn_about_y
from core.mocap.clip import Clip

_SMOOTH = 0.08  # seconds


class Placements(NamedTuple):
    """Turns about the vertical ``yaw`` ``(n,)``, radians, then shifts on the ground ``shift`` ``(n, 3)``, metres.

    One a frame, or one (n = 1) for all frames.
    """

    yaw: np.ndarray
    shift: np.ndarray

    @property
    def last(self) -> Placements:
        """That of the last frame, ``(1,)`` and ``(1, 3)``."""
        return Placements(self.yaw[-1:], self.shift[-1:])

    def of(self, points: np.ndarray) -> np.ndarray:
        """Points ``(n, 3)``, one a frame, where they are placed."""
        placed: np.ndarray = turn_about_y(self.yaw, points) + self.shift
        return placed

    def after(self, other: Placements) -> Placements:
        """First ``other``, then this one."""
        return Placements(self.yaw + other.yaw, self.of(other.shift))


def lay_upon(a: np.ndarray, b: np.ndarray, weights: np.ndarray, fps: float) -> Placements:
    """How each frame of ``b`` is laid on that of ``a``: the best ground-plane fits, evened out over time.

    a, b: joint positions ``(n, n_joints, 3)``, metres, the root first; weights ``(n_joints,)``.
    """
    yaw, shift, _ = ground_fit(a, b, weights)
    roots = [np.asarray(x[:, 0], np.float64) * [1, 0, 1] for x in (a, b)]
    apart = turn_about_y(yaw, roots[1]) + shift - roots[0]  # small, wherever the motions take place
    yaw = np.unwrap(yaw)
    if len(yaw) > 1:
        yaw, apart = (gaussian_filter1d(x, _SMOOTH * fps, axis=0, mode="nearest") for x in (yaw, apart))
    return Placements(yaw, roots[0] + apart - turn_about_y(yaw, roots[1]))


def lay_once(a: Clip, b: Clip, at_a: np.ndarray, at_b: np.ndarray, weights: np.ndarray) -> Placements:
    """How all of ``b`` is laid on ``a``, frame beside frame: facing from hips and shoulders, place from the best fit.

    at_a, at_b: their joint positions ``(n, n_joints, 3)``, metres; weights ``(n_joints,)``. For motions so unlike that
    the best turn of single frames would spin.
    """
    turns = heading(a, at_a) - heading(b, at_b)
    yaw = np.arctan2(np.sin(turns).mean(), np.cos(turns).mean())
    n = len(at_a)
    first, second = (np.asarray(x, np.float64).reshape(1, -1, 3) for x in (at_a, at_b))
    _, shift, _ = ground_fit(first, second, np.tile(weights, n), np.array([yaw]))
    return Placements(np.full(n, yaw), np.repeat(shift, n, axis=0))


def travel(fits: Placements, start: Placements, pivots: np.ndarray, weights: np.ndarray) -> Placements:
    """Where the first motion is placed in each frame of a blend, so that the blend travels as both do.

    fits: how the second lies on the first (:func:`lay_upon`); start: where the first is placed when the blend begins,
    one frame; pivots: ``(n, 3)`` points about which turns are shared out, the roots of the first motion;
    weights ``(n,)``: of the second.
    """
    back = Placements(-fits.yaw, -turn_about_y(-fits.yaw, fits.shift))
    # from one frame to the next: what brings the second motion's frame from its new place on the first to its old one
    step = Placements(fits.yaw[:-1], fits.shift[:-1]).after(Placements(back.yaw[1:], back.shift[1:]))
    share = (weights[:-1] + weights[1:]) / 2
    pivots = (np.asarray(pivots, np.float64) * [1, 0, 1])[1:]
    turn = share * step.yaw
    slide = pivots + share[:, None] * (step.of(pivots) - pivots) - turn_about_y(turn, pivots)
    yaw, shift = np.empty(len(weights)), np.empty((len(weights), 3))
    yaw[0], shift[0] = start.yaw[0], start.shift[0]
    for k in range(1, len(weights)):
        yaw[k] = yaw[k - 1] + turn[k - 1]
        shift[k] = turn_about_y(yaw[k - 1], slide[k - 1]) + shift[k - 1]
    return Placements(yaw, shift)
