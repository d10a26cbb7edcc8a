"""Leg IK reaches its targets; locked feet stay; nobody sinks into the floor."""

from __future__ import annotations

import numpy as np
import pytest

from core.editing.blending import join
from core.editing.contacts import foot_contacts, foot_skate
from core.editing.legs import lift_from_floor, lock_feet, place_ankles, smooth_step
from core.mocap.anatomy import find_anatomy
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.kinematics import forward_kinematics, joint_positions
from tests.core.editing.figures import LEG, action, moved, standing


def joints(clip, *names):
    return [clip.skeleton.index(name) for name in names]


@pytest.mark.parametrize("name", ["kick", "roll", "dance"])
def test_ankles_reach_their_targets_and_nothing_else_moves(name: str) -> None:
    clip, rng = action(name, 2), np.random.default_rng(0)
    before, world = forward_kinematics(clip)
    feet = joints(clip, "LeftFoot", "RightFoot")
    hips = before[:, joints(clip, "LeftUpLeg", "RightUpLeg")].astype(float)
    # anywhere within reach: towards the hip by up to a third, and aside
    targets = before[:, feet] + rng.uniform(0.05, 0.33, (clip.n_frames, 2, 1)) * (hips - before[:, feet])
    targets += rng.uniform(-0.02, 0.02, targets.shape)
    after, world_after = forward_kinematics(place_ankles(clip, targets))
    assert np.abs(after[:, feet] - targets).max() < 2e-4
    for side in LEG.values():
        for a, b in ((0, 1), (1, 2)):
            i, j = joints(clip, side[a], side[b])
            length = np.linalg.norm(after[:, j] - after[:, i], axis=1)
            assert np.allclose(length, np.linalg.norm(clip.skeleton.offsets[j]), atol=1e-5)
    assert np.abs(np.abs((world[:, feet] * world_after[:, feet]).sum(-1)) - 1).max() < 1e-5
    trunk = [
        j for j in range(clip.skeleton.n_joints) if not any(w in clip.skeleton.names[j] for w in ("Leg", "Foot", "Toe"))
    ]
    assert np.abs(after[:, trunk] - before[:, trunk]).max() < 1e-5


def test_the_knee_keeps_its_hinge() -> None:
    clip = standing(20)
    hip, knee, ankle = joints(clip, *LEG["Left"])
    before = joint_positions(clip)
    targets = np.full((20, 2, 3), np.nan)
    targets[:, 0] = before[:, ankle] + np.linspace(0, 0.3, 20)[:, None] * [0.1, 1.0, 0.2]
    after = joint_positions(place_ankles(clip, targets))
    ahead = after[:, knee] - (after[:, hip] + after[:, ankle]) / 2
    assert (ahead[:, 2] > 0.05).all()  # knees point forward, along Z
    right = joints(clip, *LEG["Right"])
    assert np.array_equal(after[:, right], before[:, right])  # no target: untouched


def test_out_of_reach_is_reached_for_and_the_knee_does_not_pop() -> None:
    clip = standing(121)
    hip, knee, ankle = joints(clip, *LEG["Left"])
    before = joint_positions(clip).astype(float)
    length = np.linalg.norm(clip.skeleton.offsets[[knee, ankle]], axis=1).sum()
    down = np.linspace(0.9, 1.2, 121) * length
    targets = np.full((121, 2, 3), np.nan)
    targets[:, 0] = before[:, hip] - down[:, None] * [0, 1, 0]
    after = joint_positions(place_ankles(clip, targets)).astype(float)
    reach = np.linalg.norm(after[:, ankle] - after[:, hip], axis=1)
    assert (np.diff(reach) > -1e-6).all() and reach[-1] < length and reach[-1] > 0.995 * length
    assert np.abs(after[:, ankle, 0] - before[:, hip, 0]).max() < 1e-3  # straight below the hip
    # the target falls at .15 m/s; the knee never moves much faster
    assert np.linalg.norm(np.diff(after[:, knee], axis=0), axis=1).max() * clip.fps < 1.0


def test_locking_takes_the_slide_out() -> None:
    clip = standing(90)
    clip = moved(clip, np.array([0.06, 0, 0.08]) * np.arange(90)[:, None] / clip.fps)
    locked = lock_feet(clip)
    contacts = foot_contacts(clip)
    assert foot_skate(clip, contacts) == pytest.approx(0.1, abs=1e-4)
    assert foot_skate(locked, contacts) < 0.1 * foot_skate(clip, contacts)
    slower = np.diff(locked.root_positions[20:70, 2]) / np.diff(clip.root_positions[20:70, 2])
    assert np.allclose(slower, 0.5, atol=0.02)  # the pelvis shares the way with its feet


def test_locking_eases_in_and_out() -> None:
    clip = action("punch", 1)
    locked = lock_feet(clip, floor=0.0)
    feet = joints(clip, "LeftFoot", "RightFoot")
    before, after = (joint_positions(c)[:, feet].astype(float) for c in (clip, locked))
    assert np.abs(after - before).max() > 0.005
    kinks = [np.abs(np.diff(way, n=2, axis=0)).max() for way in (before, after)]
    assert kinks[1] < 1.1 * kinks[0]  # the foot comes to its stand, and leaves it, no harder than before
    contacts = foot_contacts(clip, 0.0)
    assert foot_skate(locked, contacts, 0.0) < 0.2 * foot_skate(clip, contacts, 0.0)


def test_lifting() -> None:
    clip = standing(60)
    wave = np.zeros((60, 3))
    wave[:, 1] = -0.06 * np.sin(np.linspace(0, np.pi, 60))
    sunk = moved(clip, wave)
    lifted = lift_from_floor(sunk)
    assert joint_positions(sunk)[..., 1].min() < -0.05
    assert joint_positions(lifted)[..., 1].min() > -0.004
    assert (lifted.root_positions[:, 1] >= sunk.root_positions[:, 1]).all()
    assert lift_from_floor(moved(clip, np.array([0, 0.5, 0]))).root_positions[0, 1] == pytest.approx(
        clip.root_positions[0, 1] + 0.5
    )


def test_smooth_step() -> None:
    u = np.linspace(-0.5, 1.5, 2001)
    y = smooth_step(u)
    assert y[0] == 0 and y[-1] == 1 and (np.diff(y) >= 0).all()
    assert smooth_step(np.array(0.5)) == pytest.approx(0.5)
    assert np.abs(np.diff(y, 2)).max() / 1e-6 < 6  # second derivative bounded, and none at the ends


def test_a_skeleton_without_legs_is_left_alone() -> None:
    clip = standing(5)
    assert find_anatomy(clip.skeleton).legs
    same = place_ankles(clip, np.full((5, 2, 3), np.nan))
    assert np.allclose(same.rotations, clip.rotations, atol=1e-6)


def test_locking_real_walks(shared_data) -> None:
    asf = read_asf(shared_data / "cmu" / "asfamc" / "02" / "02.asf")
    clips = [read_amc(shared_data / "cmu" / "asfamc" / "02" / "02_01.amc", asf)]
    clips.append(read_bvh(shared_data / "bandai_namco_1" / "dataset-1_walk_normal_001.bvh"))
    for clip in clips:
        contacts = foot_contacts(clip)
        assert 0.35 < contacts.mean() < 0.7
        assert foot_skate(lock_feet(clip, contacts), contacts) < 0.2 * foot_skate(clip, contacts)


def test_joining_real_motions(shared_data) -> None:
    folder = shared_data / "cmu" / "asfamc" / "02"
    walk, run = (read_amc(folder / name, read_asf(folder / "02.asf")) for name in ("02_01.amc", "02_03.amc"))
    clip, seam = join(walk, run, 0.4, exit_window=0.5, entry_window=0.5)
    speed = [np.linalg.norm(np.diff(joint_positions(c), axis=0), axis=-1).max(1) * c.fps for c in (clip, walk, run)]
    assert speed[0][seam.start - 1 : seam.end + 1].max() <= max(speed[1].max(), speed[2].max())
    assert foot_skate(lock_feet(clip)) < 0.75 * foot_skate(clip)
