"""Motions laid upon one another frame by frame."""

from __future__ import annotations

import numpy as np
import pytest

from core.editing.blending import joint_weights, place, turn_about_y
from core.editing.following import Placements, lay_once, lay_upon, travel
from core.mocap.kinematics import joint_positions
from tests.core.editing.figures import action


def test_a_moved_copy_is_laid_exactly_on_its_original() -> None:
    clip = action("kick", 2)
    there = place(clip, 1.1, np.array([4.0, 0, -3.0]))
    a, b = joint_positions(clip), joint_positions(there)
    fits = lay_upon(a, b, joint_weights(clip.skeleton), clip.fps)
    assert np.allclose(np.cos(fits.yaw), np.cos(-1.1), atol=1e-3)
    assert np.allclose(fits.of(b[:, 0]), a[:, 0], atol=2e-3)


def test_placements_follow_one_another() -> None:
    rng = np.random.default_rng(0)
    first, second = (Placements(rng.uniform(-3, 3, 5), rng.normal(size=(5, 3)) * [1, 0, 1]) for _ in range(2))
    points = rng.normal(size=(5, 3))
    assert np.allclose(second.after(first).of(points), second.of(first.of(points)))


@pytest.mark.parametrize("share", [0.0, 1.0])
def test_travelling_with_one_motion_alone_keeps_its_own_path(share: float) -> None:
    rng = np.random.default_rng(1)
    n = 80
    t = np.linspace(0, 1, n)[:, None]
    a = np.column_stack([t, 0 * t, 0.3 * t**2])  # one walks on, the other in a bend
    b = np.column_stack([np.sin(2 * t), 0 * t, 1 - np.cos(2 * t)]) + np.array([2, 0, 1])
    fits = Placements(rng.normal() + t[:, 0], np.zeros((n, 3)))
    fits = Placements(fits.yaw, a - turn_about_y(fits.yaw, b))  # b's root on a's
    start = Placements(np.array([0.7]), np.array([[1.0, 0, 2.0]]))
    way = travel(fits, start, a, np.full(n, share))
    if share == 0:
        assert np.allclose(way.yaw, 0.7) and np.allclose(way.shift, [1, 0, 2])
    else:
        on_b = way.after(fits)  # where the second motion is placed must not change
        assert np.allclose(on_b.yaw, on_b.yaw[0]) and np.allclose(on_b.shift, on_b.shift[0], atol=1e-9)


def test_half_and_half_travels_as_the_mean_of_both() -> None:
    """Steps of the blend, in its own heading, against a plain integration of the mean steps and turns."""
    n = 60
    turn_a, turn_b = 0.01, 0.03  # radians a frame
    step = np.array([0.0, 0, 0.02])

    def path(turn: float) -> tuple[np.ndarray, np.ndarray]:
        heading = turn * np.arange(n)
        return heading, np.concatenate(
            [[np.zeros(3)], np.cumsum(turn_about_y(heading[:-1], np.tile(step, (n - 1, 1))), 0)]
        )

    (heading_a, a), (heading_b, b) = path(turn_a), path(turn_b)
    yaw = heading_a - heading_b
    fits = Placements(yaw, a - turn_about_y(yaw, b))
    way = travel(fits, Placements(np.zeros(1), np.zeros((1, 3))), a, np.full(n, 0.5))
    assert np.allclose(way.yaw + heading_a, (turn_a + turn_b) / 2 * np.arange(n), atol=1e-9)
    _, expected = path((turn_a + turn_b) / 2)
    assert np.allclose(way.of(a), expected, atol=2e-3)


def test_laying_once_turns_facing_to_facing_and_does_not_spin() -> None:
    a, b = action("kick", 2).cut(0, 60), place(action("cartwheel", 1).cut(0, 60), 2.0, np.array([3.0, 0, 1]))
    at = joint_positions(a), joint_positions(b)
    fits = lay_once(a, b, *at, joint_weights(a.skeleton))
    assert np.ptp(fits.yaw) == 0 and np.ptp(fits.shift, axis=0).max() == 0
    left = fits.of(at[1][:, 0]) - at[0][:, 0]
    assert np.linalg.norm(left[:, [0, 2]].mean(0)) < 0.5
    copy = place(a, 1.3, np.array([2.0, 0, -1]))
    same = lay_once(a, copy, at[0], joint_positions(copy), joint_weights(a.skeleton))
    assert np.allclose(same.yaw, -1.3, atol=1e-3) and np.allclose(
        same.of(copy.root_positions), a.root_positions, atol=1e-3
    )
