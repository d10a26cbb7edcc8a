"""Pose features: free of place and heading, continuous, comparable between skeletons."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton
from core.poses.features import CMU_UNIT, pose_features, principal_directions
from tests.core.motifs.recordings import BODY, NAMES, OFFSETS, PARENTS, clip_of, recurring, still


def raw(dataset: Dataset, **options) -> tuple[np.ndarray, tuple[str, ...]]:
    """Features before the reduction, (n, n_raw), and their names."""
    poses = pose_features(dataset, variance=1.0, **options)
    return poses.values @ poses.basis.T + poses.mean, poses.names


def turned(clip: Clip, yaw: float, shift=(3, 0, -2)) -> Clip:
    q = quat.from_yaw(np.float64(yaw))
    rotations = clip.rotations.copy()
    rotations[:, 0] = quat.multiply(q, rotations[:, 0])
    return replace(
        clip, root_positions=(quat.rotate(q, clip.root_positions) + shift).astype(np.float32), rotations=rotations
    )


@pytest.mark.parametrize("pose", ["angles", "positions"])
@pytest.mark.parametrize("yaw", [0.7, 3.1, -2.0])
def test_place_and_heading_do_not_matter(pose, yaw):
    clip = recurring(0, n_clips=1).clips[0]
    one, _ = raw(Dataset("a", (clip,)), pose=pose)
    two, _ = raw(Dataset("b", (turned(clip, yaw),)), pose=pose)
    np.testing.assert_allclose(one, two, atol=2e-2)


def test_angles_do_not_wrap_at_half_a_turn():
    """From 30 to 350 degrees against the rest pose: a plain rotation vector would jump at 180."""
    n = 120
    angles = np.zeros((n, len(NAMES), 3))
    angles[:, NAMES.index("LeftLeg"), 0] = np.radians(np.linspace(30, 350, n))
    values, names = raw(Dataset("a", (replace(still(n), rotations=quat.from_rotvec(angles).astype(np.float32)),)))
    assert np.abs(np.diff(values, axis=0)).max() < 4
    assert np.ptp(values[:, names.index("LeftLeg rotation x")]) == pytest.approx(320, abs=1)


def test_yaw_speed_and_horizontal_speed_are_per_thirtieth_of_a_second():
    clip = still(60)
    yaw, travel = np.linspace(0, 2, 60), np.linspace(0, 3, 60)
    rotations = clip.rotations.copy()
    rotations[:, 0] = quat.from_yaw(yaw)
    root = np.column_stack([travel, np.full(60, 0.9), np.zeros(60)]).astype(np.float32)
    moving = Dataset("a", (replace(clip, root_positions=root, rotations=rotations),))
    for fps in (15, 30, 60):
        values, names = raw(moving, analysis_fps=fps)
        middle = len(values) // 2
        assert values[middle, names.index("yaw speed")] == pytest.approx(np.degrees(2 / 59), rel=0.02)
        assert values[middle, names.index("horizontal speed")] == pytest.approx(3 / 59 / CMU_UNIT, rel=0.02)
        assert values[middle, names.index("root height")] == pytest.approx(0.9 / CMU_UNIT, rel=1e-4)


def test_pitch_and_roll_are_those_of_the_pelvis():
    clip = still(30)
    for axis, name in ((0, "pitch"), (2, "roll")):
        tilt = np.zeros((30, 3))
        tilt[10:, axis] = np.radians(20)
        rotations = clip.rotations.copy()
        rotations[:, 0] = quat.from_rotvec(tilt)
        values, names = raw(Dataset("a", (replace(clip, rotations=rotations),)))
        change = values[20] - values[0]
        assert change[names.index(name)] == pytest.approx(20, abs=0.5)
        assert np.abs(np.delete(change, names.index(name))).max() < 0.5


def test_a_rest_pose_that_is_no_body_pose_is_no_trouble():
    """Another convention for the same motion, a thigh with turned axes: distances between poses stay."""
    clip = recurring(4, n_clips=1).clips[0]
    flip = quat.from_rotvec(np.array([np.pi, 0, 0]))
    rotations = np.array(clip.rotations)
    rotations[:, 3] = quat.multiply(rotations[:, 3], flip)  # the thigh's axes point the other way
    rotations[:, 4] = quat.multiply(quat.conjugate(flip), rotations[:, 4])
    offsets = OFFSETS.copy()
    offsets[4] = quat.rotate(quat.conjugate(flip), offsets[4])
    other = replace(clip, skeleton=Skeleton(NAMES, PARENTS, offsets), rotations=rotations.astype(np.float32))
    one, two = (pose_features(Dataset("a", (c,)), variance=1.0).values for c in (clip, other))
    between = [np.linalg.norm(v[::7, None] - v[None, ::7], axis=2) for v in (one, two)]
    np.testing.assert_allclose(*between, rtol=0.02, atol=0.5)


def test_different_skeletons_meet_in_their_common_joints():
    clip = recurring(0, n_clips=1).clips[0]
    names = tuple(
        n.replace("UpLeg", "Thigh").replace("LeftLeg", "LeftShin").replace("RightLeg", "RightShin") for n in NAMES
    )
    other = replace(clip, name="other", skeleton=Skeleton(names, PARENTS, OFFSETS * 1.2))
    poses = pose_features(Dataset("two", (clip, other)))
    half = poses.clip_starts[1]
    np.testing.assert_allclose(poses.values[:half], poses.values[half:], atol=4)
    assert any("hip" in name for name in poses.names)


def test_rates_frames_and_single_frames():
    dataset = Dataset("a", (still(121, "long", fps=120), still(1, "short")))
    poses = pose_features(dataset)
    assert poses.clips == ("long", "short") and poses.clip_starts.tolist() == [0, 31, 32]
    assert poses.frame_of(0, 30) == 120 and poses.frame_of(0, 3) == 12 and poses.frame_of(1, 5) == 0
    assert np.isfinite(poses.values).all() and poses.mean_distance < 1e-3


def test_clips_come_in_order_of_their_names():
    dataset = recurring(0)
    turned_round = Dataset("b", dataset.clips[::-1])
    np.testing.assert_array_equal(pose_features(dataset).values, pose_features(turned_round).values)


def test_reduction_keeps_what_was_asked_for_in_as_few_directions_as_possible():
    rng = np.random.default_rng(0)
    x = rng.normal(size=(2000, 10)) * np.array([20, 10, 5, 3, 1, 1, 1, 1, 1, 1])
    for variance in (0.7, 0.9, 0.97):
        mean, basis, explained = principal_directions(x, variance)
        left = x - mean - (x - mean) @ basis @ basis.T
        assert (
            1 - (left**2).sum() / ((x - mean) ** 2).sum() == pytest.approx(explained, abs=1e-9)
            and explained >= variance
        )
        fewer = basis[:, :-1]
        if fewer.size:
            assert (((x - mean) @ fewer) ** 2).sum() / ((x - mean) ** 2).sum() < variance


@pytest.mark.parametrize("wrong", [{"pose": "mood"}, {"analysis_fps": 0}, {"variance": 0}, {"variance": 1.5}])
def test_wrong_requests_are_refused(wrong):
    with pytest.raises(ValueError):
        pose_features(Dataset("a", (still(),)), **wrong)


def test_clips_of_one_body_give_the_skeleton_names():
    assert "LeftLeg rotation x" in pose_features(Dataset("a", (clip_of("a", [0], np.random.default_rng(0)),))).names
    assert BODY.n_joints == len(NAMES)
