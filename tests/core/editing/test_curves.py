"""Curves of a clip: right values under right names, and a table that reads back."""

from __future__ import annotations

import csv
import io

import numpy as np
import pytest

from core.editing.contacts import foot_contacts
from core.editing.curves import TRAVEL, ClipCurves, csv_blocks, speed
from core.mocap.kinematics import joint_positions
from core.poses.angles import JOINTS, joint_angles
from core.poses.body_frames import body_frames
from tests.core.editing.figures import going, moved, standing


@pytest.fixture(scope="module")
def curves():
    clip = going(("walk", 3.0))
    return ClipCurves(clip, body_frames([clip]))


@pytest.mark.parametrize("fps", [30.0, 60.0, 120.0])
def test_a_body_that_glides_has_that_speed_in_all_its_joints(fps):
    clip = standing(90, fps)
    clip = moved(clip, np.outer(np.arange(90) / fps, [0.9, 1.2, 0]))
    glide = ClipCurves(clip, body_frames([clip]))
    for curve in glide.speeds():
        expected = 0.9 if curve.part == TRAVEL else 1.5
        assert curve.values == pytest.approx(np.full(90, expected), abs=1e-3), curve.part
        assert curve.unit == "m/s"


def test_speed_is_way_over_time():
    places = np.random.default_rng(1).normal(size=(50, 3)).cumsum(0)
    found = speed(places, 90.0)  # 1/30 s is three frames: two on one side, rounded to one each
    half = max(1, round(90 / 60))
    for k in (0, 1, 20, 49):
        a, b = max(k - half, 0), min(k + half, 49)
        assert found[k] == pytest.approx(np.linalg.norm(places[b] - places[a]) / ((b - a) / 90), rel=1e-5)


def test_angles_positions_and_feet_are_those_of_the_clip(curves):
    clip = curves.clip
    both = curves.angles(["left_knee", "right_hip"], ["flexion"])
    assert [(c.part, c.name, c.unit) for c in both] == [
        ("left_knee", "flexion", "deg"),
        ("right_hip", "flexion", "deg"),
    ]
    assert np.array_equal(both[0].values, joint_angles(clip, curves.frames, ["left_knee"])["left_knee"][:, 0])
    assert len(curves.angles()) == sum(len(JOINTS[joint].channels) for joint in curves.angle_joints)
    x, y, z = curves.positions(["head"])
    assert np.array_equal(
        np.stack([x.values, y.values, z.values], 1), joint_positions(clip)[:, clip.skeleton.index("Head")]
    )
    left, right, left_down, right_down = curves.feet()
    assert np.array_equal(np.stack([left_down.values, right_down.values], 1), foot_contacts(clip))
    assert left.values[left_down.values].max() < 0.05 < left.values.max() and right.values.max() > 0.05
    assert curves.gait.bouts
    events = {(c.part, c.name): np.flatnonzero(c.values).tolist() for c in curves.events()}
    for side in ("left", "right"):
        strikes = [e.frame for e in curves.gait.events if (e.side, e.kind) == (side, "strike")]
        assert events[f"{side}_foot", "heel strike"] == strikes != []


def test_channels_are_named_as_in_the_file(curves):
    knee = curves.clip.skeleton.index("LeftLeg")
    found = curves.channels([knee])
    assert [(c.part, c.name) for c in found] == [("LeftLeg", f"{axis}rotation") for axis in "ZYX"]
    assert np.ptp(found[2].values) > 40  # the demo's knees bend about X


def test_what_is_not_there_is_named(curves):
    for call, why in (
        (lambda: curves.angles(["tail"]), "no angles for tail"),
        (lambda: curves.speeds(["tail"]), "no tail; it has pelvis"),
        (lambda: curves.positions(["tail"]), "no tail"),
        (lambda: curves.channels([999]), "no turning joint number 999"),
        (lambda: list(csv_blocks(curves.clip, [], 5, 2)), "frames 0 to 180; cannot write 5 to 2"),
    ):
        with pytest.raises(ValueError, match=why):
            call()


def test_a_table_reads_back(curves):
    chosen = [*curves.angles(["left_knee"]), *curves.speeds([TRAVEL]), *curves.feet(), *curves.positions(["pelvis"])]
    rows = list(csv.reader(io.StringIO("".join(csv_blocks(curves.clip, chosen, 20, 170)))))
    assert rows[0][:3] == ["frame", "time [s]", "left_knee flexion [deg]"] and "left_foot on floor [0/1]" in rows[0]
    table = np.array(rows[1:], float)
    assert table.shape == (150, 2 + len(chosen))
    assert np.array_equal(table[:, 0], np.arange(20, 170)) and np.allclose(table[:, 1], np.arange(20, 170) / 60)
    for k, curve in enumerate(chosen):
        assert np.allclose(table[:, 2 + k], curve.values[20:170], rtol=1e-5, atol=1e-6)
