"""Foot contacts and the foot-skate meter, against figures whose contacts are known and against plain loops."""

from __future__ import annotations

import numpy as np
import pytest

from core.editing import contacts as module
from core.editing.contacts import floor_height, foot_contacts, foot_skate, heights, runs, sole_points
from core.editing.legs import place_ankles
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from tests.core.editing.figures import action, moved, standing


@pytest.mark.parametrize("speed", [0.0, 0.05, 0.2])
def test_a_sliding_figure_skates_at_exactly_its_speed(speed: float) -> None:
    clip = standing(90)
    direction = np.array([np.sin(0.7), 0, np.cos(0.7)])
    clip = moved(clip, direction * speed * np.arange(90)[:, None] / clip.fps)
    assert foot_contacts(clip).all()
    assert foot_skate(clip) == pytest.approx(speed, abs=1e-5)


def test_a_fast_figure_does_not_stand() -> None:
    clip = standing(60)
    clip = moved(clip, np.array([0, 0, 2.0]) * np.arange(60)[:, None] / clip.fps)
    assert not foot_contacts(clip, floor=0.0).any()
    assert foot_skate(clip, floor=0.0) == 0.0


def lifted(scale: float = 1.0):
    """Left foot lifted by 12 cm from frame 40 to frame 80."""
    clip = standing(120, scale=scale)
    feet = joint_positions(clip)[:, [clip.skeleton.index("LeftFoot"), clip.skeleton.index("RightFoot")]].astype(float)
    feet[40:80, 0, 1] += 0.12 * scale
    return place_ankles(clip, feet)


@pytest.mark.parametrize("height", [0.0, 1.7, -0.4])
@pytest.mark.parametrize("scale", [1.0, 0.3, 17.7])
def test_a_lifted_foot_does_not_stand_wherever_the_floor_and_whatever_the_size(height: float, scale: float) -> None:
    clip = moved(lifted(scale), np.array([0, height * scale, 0]))
    assert floor_height(clip) == pytest.approx(height * scale, abs=2e-3 * scale)
    found = foot_contacts(clip)
    expected = np.ones((120, 2), bool)
    expected[40:80, 0] = False
    assert (found != expected).sum() <= 4  # a frame or so at either end, where the foot jumps up


def test_hysteresis_is_the_state_machine() -> None:
    rng = np.random.default_rng(3)
    for _ in range(50):
        lasts = rng.uniform(size=80) < 0.7
        begins = lasts & (rng.uniform(size=80) < 0.2)
        found = module._hysteresis(begins, lasts)
        # a state machine, told what is to come: a run of "lasts" counts if a "begins" is anywhere in it
        k = 0
        while k < 80:
            end = k
            while end < 80 and lasts[end]:
                end += 1
            assert (found[k:end] == any(begins[k:end])).all()
            if end < 80:
                assert not found[end]
            k = end + 1


def test_skate_is_the_sum_of_steps_of_the_lowest_point() -> None:
    clip = action("kick", 5)
    positions, standing_feet = joint_positions(clip), foot_contacts(clip, 0.0)
    slid, frames = 0.0, 0
    for column, points in enumerate(sole_points(clip)):
        height = heights(clip, positions, points, 0.0)
        for f in range(clip.n_frames - 1):
            if standing_feet[f, column] and standing_feet[f + 1, column]:
                k = min(range(len(points)), key=lambda k: height[f, k] + height[f + 1, k])
                step = positions[f + 1, points[k]] - positions[f, points[k]]
                slid += float(np.hypot(step[0], step[2]))
                frames += 1
    assert frames > 20
    assert foot_skate(clip, standing_feet, 0.0) == pytest.approx(slid * clip.fps / frames, rel=1e-5)


def test_runs() -> None:
    mask = np.array([1, 1, 0, 0, 1, 0, 1], bool)
    assert runs(mask).tolist() == [[0, 2], [4, 5], [6, 7]]
    assert runs(np.zeros(4, bool)).shape == (0, 2)


def test_without_feet_nothing_stands() -> None:
    clip = standing(10)
    chain = Skeleton(("a", "b"), (-1, 0), np.array([[0, 0, 0], [0, 1, 0]]))
    bare = type(clip)("bare", chain, 30.0, clip.root_positions, clip.rotations[:, :2])
    assert not foot_contacts(bare).any() and foot_skate(bare) == 0.0


def test_a_real_walk_stands_on_one_foot_after_the_other(shared_data) -> None:
    bvh = pytest.importorskip("core.mocap.bvh")
    clip = bvh.read_bvh(shared_data / "bandai_namco_1" / "dataset-1_walk_normal_001.bvh")
    found = foot_contacts(clip)
    assert (found.mean(0) > 0.4).all() and (found.mean(0) < 0.85).all()
    assert found.any(1).mean() > 0.9
    assert foot_skate(clip) < 0.25
