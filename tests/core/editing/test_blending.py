"""Transitions: ground-plane fit against a general minimiser, search against brute force, joins without jumps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize

from core.editing.blending import (
    blend,
    crossfade_weights,
    find_transition,
    ground_fit,
    heading,
    join,
    place,
    register,
    turn_about_y,
)
from core.editing.legs import place_ankles
from core.mocap import quaternions as quat
from core.mocap.kinematics import joint_positions
from tests.core.editing.figures import action, moved, standing


def test_ground_fit_is_the_minimum() -> None:
    rng = np.random.default_rng(0)
    for _ in range(5):
        a = rng.normal(size=(30, 3))
        b = turn_about_y(rng.uniform(-3, 3), a) + [2, 0, -1] + 0.3 * rng.normal(size=(30, 3))
        w = rng.uniform(0.1, 2, 30)

        def error(x, a=a, b=b, w=w):
            return (w * ((a - turn_about_y(x[0], b) - [x[1], 0, x[2]]) ** 2).sum(1)).sum() / w.sum()

        best = min((minimize(error, [yaw, 0, 0], tol=1e-12) for yaw in (-2, 0, 2)), key=lambda r: r.fun)
        yaw, shift, left = ground_fit(a, b, w)
        assert left == pytest.approx(np.sqrt(best.fun), rel=1e-6)
        assert np.allclose([np.cos(yaw), np.sin(yaw)], [np.cos(best.x[0]), np.sin(best.x[0])], atol=1e-4)
        assert np.allclose(shift, [best.x[1], 0, best.x[2]], atol=1e-3)


def test_ground_fit_of_a_moved_copy_is_exact_and_works_in_batches() -> None:
    rng = np.random.default_rng(1)
    b = rng.normal(size=(4, 1, 20, 3))
    yaw, shift = rng.uniform(-3, 3, (4, 5)), rng.normal(size=(4, 5, 3)) * [1, 0, 1]
    a = turn_about_y(yaw[..., None], b) + shift[..., None, :]
    found, moved_by, left = ground_fit(a, b)
    assert np.allclose(found, yaw) and np.allclose(moved_by, shift) and left.max() < 1e-9


def test_placing_turns_the_heading_and_moves_the_joints_rigidly() -> None:
    clip = action("kick", 3)
    there = place(clip, 0.8, np.array([1.0, 0, -2.0]))
    turned = np.angle(np.exp(1j * (heading(there) - heading(clip))))
    assert np.allclose(turned, 0.8, atol=1e-3)
    expected = turn_about_y(0.8, joint_positions(clip)) + np.array([1, 0, -2])
    assert np.allclose(joint_positions(there), expected, atol=1e-4)


def test_heading_of_a_standing_figure_is_along_z() -> None:
    assert np.allclose(heading(standing(3)), 0, atol=1e-6)
    assert np.allclose(heading(place(standing(3), np.pi / 2, np.zeros(3))), np.pi / 2, atol=1e-6)


def test_blend() -> None:
    a, b = action("kick", 1).cut(0, 40), action("jump", 2).cut(0, 40)
    assert np.allclose(joint_positions(blend(a, b, np.zeros(40))), joint_positions(a), atol=1e-5)
    assert np.allclose(joint_positions(blend(a, b, np.ones(40))), joint_positions(b), atol=1e-5)
    half = blend(a, b, np.full(40, 0.5))
    assert np.allclose(np.linalg.norm(half.rotations, axis=-1), 1, atol=1e-5)
    assert np.allclose(
        np.abs((half.rotations * a.rotations).sum(-1)), np.abs((half.rotations * b.rotations).sum(-1)), atol=1e-4
    )
    with pytest.raises(ValueError, match="cannot be blended"):
        blend(a, b.cut(0, 30), np.zeros(40))


def test_a_blend_does_not_change_sides_where_two_postures_are_half_a_turn_apart() -> None:
    a, b = (action("kick", 1).cut(0, 60) for _ in range(2))
    angles = np.linspace(np.pi - 0.4, np.pi + 0.4, 60)  # past half a turn on the way
    turned = b.rotations.copy()
    turned[:, 0] = quat.multiply(a.rotations[:, 0], quat.from_rotvec(angles[:, None] * [1.0, 0, 0]))
    half = blend(a, replace(b, rotations=turned), np.full(60, 0.5))
    speed = np.linalg.norm(np.diff(joint_positions(half), axis=0), axis=-1).max() * a.fps
    assert speed < 3 * np.linalg.norm(np.diff(joint_positions(a), axis=0), axis=-1).max() * a.fps


def test_crossfade_weights() -> None:
    w = crossfade_weights(18)
    assert (np.diff(w) > 0).all() and 0 < w[0] < 0.01 and 0.99 < w[-1] < 1
    assert np.allclose(w + w[::-1], 1)


def test_register_finds_a_time_warp() -> None:
    t = np.linspace(0, 1, 80)
    warped = t + 0.12 * np.sin(2 * np.pi * t) / (2 * np.pi) * 2

    def curve(u):
        return np.c_[np.sin(5 * u), np.cos(7 * u), u]

    a, b = curve(t), curve(warped)
    i, k = register(a, b, "dtw")
    gap = [np.abs(np.interp(i, np.arange(80), t) - np.interp(k, np.arange(80), warped)).max()]
    i, k = register(a, b)
    gap.append(np.abs(np.interp(i, np.arange(80), t) - np.interp(k, np.arange(80), warped)).max())
    assert gap[0] < 0.015 < 0.03 < gap[1]
    with pytest.raises(ValueError, match="linear"):
        register(a, b, "guess")


def test_register_runs_from_first_to_last() -> None:
    rng = np.random.default_rng(0)
    for method in ("linear", "dtw"):
        i, k = register(rng.normal(size=(30, 2)), rng.normal(size=(50, 2)), method)
        assert len(i) == len(k) == 40
        assert (i[0], k[0], i[-1], k[-1]) == (0, 0, 29, 49)
        assert (np.diff(i) >= 0).all() and (np.diff(k) >= 0).all()


def test_find_transition_is_the_best_of_its_windows() -> None:
    a, b = action("dance", 4), place(action("kick", 5), 1.0, np.array([3.0, 0, 1]))
    best = find_transition(a, b, 0.3, exit_window=0.5, entry_window=0.4)
    n = 18
    costs = {}
    for exit_frame in range(a.n_frames - n, a.n_frames - n - 31, -2):
        for entry in range(0, 25, 2):
            way = find_transition(a.cut(0, exit_frame + n), b.cut(entry, b.n_frames), 0.3)
            costs[exit_frame, entry] = way.cost
    assert best.cost == pytest.approx(min(costs.values()), rel=1e-5)
    assert costs[best.exit, best.entry] == pytest.approx(best.cost, rel=1e-5)


@pytest.mark.parametrize("registration", ["linear", "dtw"])
@pytest.mark.parametrize("names", [("jump", "kick"), ("cartwheel", "punch"), ("punch", "spin kick")])
def test_joined_motions_do_not_jump(names: tuple[str, str], registration: str) -> None:
    a, b = action(names[0], 1), place(action(names[1], 2), 2.0, np.array([5.0, 0, 5]))
    clip, seam = join(a, b, 0.3, exit_window=0.2, entry_window=0.2, registration=registration)
    speed = np.linalg.norm(np.diff(joint_positions(clip), axis=0), axis=-1).max(1) * clip.fps
    fastest = max(np.linalg.norm(np.diff(joint_positions(c), axis=0), axis=-1).max() * c.fps for c in (a, b))
    assert speed[max(0, seam.start - 1) : seam.end + 1].max() < max(fastest, 6)
    assert np.allclose(joint_positions(clip)[: seam.start], joint_positions(a)[: seam.start], atol=1e-5)
    assert ((clip.rotations[1:] * clip.rotations[:-1]).sum(-1) > 0).all()


def test_feet_step_from_stance_to_stance_instead_of_sliding() -> None:
    a, b = standing(60), moved(standing(60), np.zeros(3))
    feet = [b.skeleton.index("LeftFoot"), b.skeleton.index("RightFoot")]
    wide = joint_positions(b)[:, feet].astype(float) + np.array([[[0.12, 0, 0.05], [-0.12, 0, -0.05]]])
    b = place_ankles(b, wide)
    speeds = {}
    for steps in (False, True):
        clip, seam = join(a, b, 0.7, steps=steps)
        positions = joint_positions(clip)[seam.start : seam.end]
        height = positions[:, [clip.skeleton.index("LeftFoot_end"), clip.skeleton.index("RightFoot_end")], 1]
        low = (height < 0.005)[1:]
        way = np.linalg.norm(np.diff(positions[:, feet][..., [0, 2]], axis=0), axis=-1)
        speeds[steps] = (way * low).sum()
        if steps:
            assert (height.max(0) > 0.02).all()
            assert (height.min(1) < 0.01).mean() > 0.85  # one foot is always down, but for the change-over
    assert speeds[True] < 0.3 * speeds[False]


def test_join_refuses_what_does_not_fit() -> None:
    a, b = action("jump", 0), action("jump", 0, performer=1)
    with pytest.raises(ValueError, match="cannot be joined"):
        join(a, b)
