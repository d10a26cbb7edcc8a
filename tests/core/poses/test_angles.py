"""Joint angles: against poses whose angles are known, against plain geometry, on any rig, on real recordings."""

from __future__ import annotations

import numpy as np
import pytest

from core.editing.blending import concatenate
from core.mocap import quaternions as quat
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.poses.angles import JOINTS, channel_angles, joint_angles, known_joints
from core.poses.body_frames import body_frames
from tests.core.editing.figures import action, going, rerigged, standing

# turns of the demo's body, which faces Z, has its left at +X and stands when nothing is turned
BACK, UP, FORWARD = (1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0)  # axes to the left, up, forward


def turned(turns: dict[str, tuple[tuple[float, float, float], float]], n: int = 1) -> Clip:
    """The standing body, joints turned by degrees about an axis."""
    clip = standing(n, bend=0.0)
    for name, (axis, degrees) in turns.items():
        rotation = quat.from_rotvec(np.radians(degrees) * np.array(axis))
        clip.rotations[:, clip.skeleton.index(name)] = rotation
    return clip


def bending() -> Clip:
    """Stands, then bends both knees and elbows, so that hinges show."""
    knees = {f"{side}Leg": (BACK, 60.0) for side in ("Left", "Right")}
    elbows = {f"{side}ForeArm": (BACK, -60.0) for side in ("Left", "Right")}
    return concatenate([turned({}, 60), turned({**knees, **elbows}, 30)], "bending")


@pytest.mark.parametrize(
    ("joint", "turn", "angle", "channel", "degrees"),
    [
        ("LeftUpLeg", (BACK, -35.0), "left_hip", "flexion", 35),
        ("RightUpLeg", (BACK, 20.0), "right_hip", "flexion", -20),
        ("LeftUpLeg", (FORWARD, 25.0), "left_hip", "abduction", 25),
        ("RightUpLeg", (FORWARD, -25.0), "right_hip", "abduction", 25),
        ("LeftUpLeg", (UP, -15.0), "left_hip", "rotation", 15),
        ("RightUpLeg", (UP, 15.0), "right_hip", "rotation", 15),
        ("RightLeg", (BACK, 70.0), "right_knee", "flexion", 70),
        ("LeftFoot", (BACK, -12.0), "left_ankle", "flexion", 12),
        ("LeftFoot", (FORWARD, -8.0), "left_ankle", "inversion", 8),
        ("RightFoot", (FORWARD, 8.0), "right_ankle", "inversion", 8),
        ("LeftArm", (BACK, -50.0), "left_shoulder", "flexion", 50),
        ("RightArm", (FORWARD, -60.0), "right_shoulder", "abduction", 60),
        ("RightArm", (FORWARD, -60.0), "right_shoulder", "elevation", 60),
        ("LeftForeArm", (BACK, -80.0), "left_elbow", "flexion", 80),
        ("RightForeArm", (UP, 30.0), "right_elbow", "rotation", 30),
        ("LeftHand", (BACK, -20.0), "left_wrist", "flexion", 20),
        ("Chest", (BACK, 30.0), "trunk", "flexion", 30),
        ("Chest", (FORWARD, 10.0), "trunk", "side bend", 10),
        ("Chest", (UP, 20.0), "trunk", "rotation", 20),
        ("Head", (BACK, 15.0), "head", "flexion", 15),
        ("Hips", (UP, 40.0), "pelvis", "heading", 40),
        ("Hips", (BACK, 9.0), "pelvis", "tilt", 9),
        ("Hips", (FORWARD, 9.0), "pelvis", "list", 9),
    ],
)
def test_a_known_turn_is_the_angle_it_should_be_and_no_other(joint, turn, angle, channel, degrees):
    pose = turned({joint: turn})
    for clip in (pose, rerigged(pose, 3)):
        frames = body_frames([bending() if clip is pose else rerigged(bending(), 3)])
        found = joint_angles(clip, frames)
        names = [c.name for c in JOINTS[angle].channels]
        values = dict(zip(names, found[angle][0], strict=True))
        assert values.pop(channel) == pytest.approx(degrees, abs=0.2)
        values.pop("elevation", None)
        if channel != "elevation":
            assert max(map(abs, values.values())) < 0.2
        others = {name for name in found if JOINTS[angle].below not in (JOINTS[name].above, JOINTS[name].below)}
        assert all(np.abs(found[name]).max() < 0.2 for name in others), "another joint moved"


def test_knees_and_elbows_bend_by_the_angle_between_their_bones():
    clip = going(("run", 1.5))
    angles, at = joint_angles(clip, body_frames([clip])), joint_positions(clip).astype(float)
    for joint, chain in (
        ("left_knee", ("LeftUpLeg", "LeftLeg", "LeftFoot")),
        ("right_elbow", ("RightArm", "RightForeArm", "RightHand")),
    ):
        a, b, c = (at[:, clip.skeleton.index(name)] for name in chain)
        cosine = [
            np.dot(q - p, r - q) / np.linalg.norm(q - p) / np.linalg.norm(r - q)
            for p, q, r in zip(a, b, c, strict=True)
        ]
        between = np.degrees(np.arccos(np.clip(cosine, -1, 1)))
        assert np.ptp(between) > 30
        assert np.abs(angles[joint][:, 0] - between).max() < 3


@pytest.mark.parametrize("make", [lambda: going(("walk", 2.0)), lambda: action("punch")], ids=["walk", "punch"])
def test_angles_do_not_depend_on_how_a_rig_turns_its_joints(make):
    clip = make()
    other = rerigged(clip, 7)
    assert np.abs(joint_positions(clip) - joint_positions(other)).max() < 1e-4
    expected, found = (joint_angles(c, body_frames([c])) for c in (clip, other))
    assert set(expected) == set(found) == set(JOINTS)
    for joint in expected:
        away = np.abs((expected[joint] - found[joint] + 180) % 360 - 180)
        assert away.max() < 0.5, joint


def test_frames_of_another_skeleton_and_unknown_joints_are_refused():
    clip = action("punch")
    with pytest.raises(ValueError, match="another skeleton"):
        joint_angles(clip, body_frames([rerigged(clip)]))
    with pytest.raises(ValueError, match="no angles for tail; this body has pelvis"):
        joint_angles(clip, body_frames([clip]), ["tail"])
    with pytest.raises(ValueError, match="no clip"):
        body_frames([])
    with pytest.raises(ValueError, match="different skeletons"):
        body_frames([clip, rerigged(clip)])


def test_a_hinge_that_never_bends_takes_the_side_of_the_trunk():
    frames = body_frames([standing(30, bend=0.0)])
    assert not frames.hinges
    found = joint_angles(turned({"LeftLeg": (BACK, 50.0)}), frames)
    assert found["left_knee"][0] == pytest.approx([50, 0, 0], abs=0.2)


def test_channels_of_the_file_turn_back_into_the_rotations():
    clip = rerigged(action("kick"), 2)
    for joint in (0, clip.skeleton.index("LeftLeg")):
        names, angles = channel_angles(clip, joint)
        back = quat.from_euler("".join(name[0] for name in names), np.radians(angles))
        assert np.abs(np.abs((back * clip.rotations[:, joint]).sum(-1)) - 1).max() < 1e-5
        assert np.abs(np.diff(angles, axis=0)).max() < 350


def test_channels_do_not_jump_where_the_middle_angle_passes_a_right_angle():
    clip = standing(200)
    yaw = np.radians(np.linspace(0, 200, 200))  # about Y, the second of Z, Y, X
    clip.rotations[:, 0] = quat.from_yaw(yaw)
    names, angles = channel_angles(clip, 0)
    assert names == ("Zrotation", "Yrotation", "Xrotation")
    assert np.abs(np.diff(angles, axis=0)).max() < 10 and np.ptp(angles[:, 1]) > 190
    assert np.abs(np.abs((quat.from_euler("ZYX", np.radians(angles)) * clip.rotations[:, 0]).sum(1)) - 1).max() < 1e-5


def test_two_rigs_of_one_recording_have_the_same_angles(shared_data):
    """CMU 02_01: the actor's own skeleton at 120 Hz, and an avatar with another body and another rest pose at 60 Hz."""
    cmu = shared_data / "cmu"
    own = read_amc(cmu / "asfamc/02/02_01.amc", read_asf(cmu / "asfamc/02/02.asf"))
    avatar = read_bvh(next(cmu.rglob("002_01.bvh")))
    a, b = (joint_angles(clip, body_frames([clip])) for clip in (own, avatar))
    for joint in ("left_hip", "right_hip", "left_knee", "right_knee", "left_shoulder", "right_shoulder", "left_elbow"):
        n = min(len(b[joint]), len(a[joint][1::2]))
        x, y = a[joint][1::2][:n, 0], b[joint][:n, 0]
        assert np.corrcoef(x, y)[0, 1] > 0.99, joint
        assert np.std(x - y) < 2.5, joint
    for side in ("left", "right"):  # a walk as textbooks have it (Winter 1991): range of flexion in degrees
        assert 35 < np.ptp(a[f"{side}_hip"][:, 0]) < 60
        assert 55 < np.ptp(a[f"{side}_knee"][:, 0]) < 75
        assert 20 < np.ptp(a[f"{side}_ankle"][:, 0]) < 45


def test_every_recorded_body_has_its_angles(shared_data):
    clip = read_bvh(next(shared_data.rglob("*walk_normal_001.bvh")))
    frames = body_frames([clip])
    assert known_joints(frames) == tuple(JOINTS)
    knee = joint_angles(clip, frames, ["left_knee"])["left_knee"]
    assert -5 < knee[:, 0].min() < 10 and 55 < knee[:, 0].max() < 85 and np.abs(knee[:, 1:]).max() < 5
