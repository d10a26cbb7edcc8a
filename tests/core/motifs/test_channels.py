"""Clips as matrices: there and back, headings that wind, somersaults, the unit of the columns."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.demo.actions import perform
from core.demo.performers import PERFORMERS
from core.editing.blending import place
from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.motifs.channels import channels_of
from tests.webapp.generated import walk

ACTIONS = ["kick", "cartwheel", "backflip", "roll"]


def action(name: str, seed: int = 0, performer: int = 0) -> Clip:
    return perform(name, PERFORMERS[performer], np.random.default_rng(seed))


@pytest.mark.parametrize("name", ACTIONS)
def test_there_and_back(name):
    clip = action(name)
    channels = channels_of([clip, action(name, 1)])
    values = channels.encode(clip)
    assert values.shape == (clip.n_frames, channels.width) and np.isfinite(values).all()
    back = channels.decode(values, fps=clip.fps)
    assert np.allclose(joint_positions(back), joint_positions(clip), atol=1e-4)
    assert np.allclose(channels.positions(values)[:, 0], clip.root_positions, atol=1e-5)


def test_columns_do_not_jump():
    turning = walk(seconds=6.0)
    spin = np.linspace(0, 5 * np.pi, turning.n_frames)
    rotations = turning.rotations.copy()
    rotations[:, 0] = quat.multiply(quat.from_yaw(spin), rotations[:, 0])
    turning = replace(turning, rotations=rotations)
    channels = channels_of([turning])
    heading = channels.encode(turning)[:, 3] / channels.scales[3]
    assert np.ptp(heading) == pytest.approx(5 * np.pi, rel=1e-3)
    for name in ACTIONS:
        clip = action(name)
        channels = channels_of([clip])
        steps = np.abs(np.diff(channels.encode(clip) / channels.scales, axis=0))
        assert steps[:, 3:].max() < 0.6, name


def test_joints_that_never_turn_have_no_column():
    clip = walk()
    channels = channels_of([clip])
    turning = {clip.skeleton.names[j] for j in channels.joints}
    assert "LeftUpLeg" in turning and "Head" not in turning
    still = replace(clip, rotations=np.repeat(clip.rotations[:1], clip.n_frames, 0))
    assert channels_of([still]).width == 8


def test_a_centimetre_is_a_centimetre():
    clip = action("kick")
    channels = channels_of([clip])
    values = channels.encode(clip)
    for column in (0, 1, 2):
        moved = values.copy()
        moved[:, column] += 3.0
        way = np.linalg.norm(channels.positions(moved) - channels.positions(values), axis=-1)
        assert np.allclose(way, 0.03, atol=1e-5)
    rng = np.random.default_rng(0)  # small changes of any kind: about as far as the matrix says
    noise = rng.normal(0, 0.05, values.shape)
    way = np.linalg.norm(channels.positions(values + noise) - channels.positions(values), axis=-1)
    assert 100 * np.sqrt((way**2).mean()) == pytest.approx(np.sqrt((noise**2).sum(1).mean()), rel=0.4)


def test_pose_distance_is_in_degrees_and_blind_to_place_and_heading():
    clip = action("kick")
    channels = channels_of([clip])
    a = channels.encode(clip)
    elsewhere = channels.encode(place(clip, 1.0, np.array([3.0, 0, 1])))
    assert channels.pose_distance(a, elsewhere).max() < 1e-2
    b = a.copy()
    b[:, 10] += np.radians(3) * channels.scales[10]
    b[:, 1] += 4 * 0.056444 * channels.scales[1]
    assert np.allclose(channels.pose_distance(a, b), 5, atol=1e-6)


def test_one_skeleton_only():
    with pytest.raises(ValueError, match="one skeleton"):
        channels_of([action("kick"), action("kick", performer=1)])
