"""Poses of the SMPL family and of SOMA: rates, the way up, bodies, damaged arrays."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.inspection import inspect_recording
from core.mocap.anatomy import find_anatomy
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.smpl_body import NAMES, PARENTS, average_offsets

TO_Z = Rotation.from_euler("x", 90, degrees=True)


def poses(n: int = 40, joints: int = 52) -> np.ndarray:
    """Poses ``(n, joints, 3)`` with a bent left knee and a lifted right arm."""
    turns = np.zeros((n, joints, 3))
    turns[:, NAMES.index("left_knee"), 0] = np.linspace(0, 1, n)
    turns[:, NAMES.index("right_shoulder"), 2] = 1.0
    return turns


def amass(path, rate="mocap_framerate", joints=52, n=40, **more) -> None:
    turns = poses(n, joints)
    turns[:, 0] = TO_Z.as_rotvec()  # Z up, as AMASS is
    trans = np.stack([np.zeros(n), -0.01 * np.arange(n), np.full(n, 0.95)], axis=1)
    np.savez(path, poses=turns.reshape(n, -1), trans=trans, betas=np.zeros(16), **{rate: np.array(120.0)}, **more)


@pytest.mark.parametrize("rate", ["mocap_framerate", "mocap_frame_rate"])
@pytest.mark.parametrize("joints", [24, 52, 55])
def test_amass_is_read_at_its_rate_and_stands_along_y(tmp_path, rate, joints):
    amass(tmp_path / "a.npz", rate, joints, gender=np.array("neutral"))
    report, facts = inspect_recording(tmp_path / "a.npz")
    assert (facts.fps, facts.up, facts.body, facts.unit) == (120.0, "z", "human", "m"), report.messages
    assert 1.6 < facts.height < 1.8 and any("average proportions" in note for note in report.messages)
    (clip,) = open_dataset(tmp_path / "a.npz").clips
    at = joint_positions(clip)
    assert at[0, NAMES.index("head"), 1] > 1.3 > 0.2 > at[0, NAMES.index("left_ankle"), 1]
    assert np.allclose(clip.root_positions[-1], [0, 0.95, 0.39], atol=1e-4)


def test_joints_lie_where_a_naive_chain_of_rotations_puts_them(tmp_path):
    amass(tmp_path / "a.npz", joints=24)
    (clip,) = open_dataset(tmp_path / "a.npz").clips
    turns, offsets = poses(40, 24), average_offsets()
    for frame in (0, 20, 39):
        world, at = [], []
        for j, parent in enumerate(PARENTS):
            own = Rotation.from_rotvec(turns[frame, j])
            world.append(own if parent < 0 else world[parent] * own)
            at.append(clip.root_positions[frame] if parent < 0 else at[parent] + world[parent].apply(offsets[j]))
        assert np.abs(joint_positions(clip)[frame] - np.array(at)).max() < 1e-5


def test_poses_in_parts_and_as_matrices(tmp_path):
    turns, trans = poses(30, 22), np.tile([0, 0.95, 0], (30, 1))
    np.savez(tmp_path / "parts.npz", root_orient=turns[:, 0], pose_body=turns[:, 1:].reshape(30, -1), trans=trans)
    matrices = Rotation.from_rotvec(turns.reshape(-1, 3)).as_matrix().reshape(30, 22, 3, 3)
    np.savez(tmp_path / "matrices.npz", smpl_poses=matrices, smpl_trans=trans, fps=30)
    a, b = open_dataset(tmp_path).clips
    assert np.abs(joint_positions(a) - joint_positions(b)).max() < 1e-5 and {a.fps, b.fps} == {30.0, 60.0}


def test_joints_with_rotations_are_exact(tmp_path, shared_data):
    for path in sorted((shared_data / "formats").glob("kimodo*.npz")):
        (clip,) = open_dataset(path).clips
        with np.load(path) as arrays:
            assert np.abs(joint_positions(clip) - arrays["posed_joints"]).max() < 2e-3
        assert find_anatomy(clip.skeleton).body == "human" and clip.fps == 30.0


def test_the_model_that_someone_has_gives_its_own_joints(tmp_path, monkeypatch):
    joints = np.cumsum(np.ones((24, 3)) * 0.01, axis=0)
    table = np.array([[2**32 - 1, *PARENTS[1:]], range(24)])
    np.savez(tmp_path / "model.npz", J_regressor=np.eye(24), v_template=joints, kintree_table=table)
    amass(tmp_path / "a.npz")
    monkeypatch.setenv("MOTIONSCAPE_SMPL", str(tmp_path / "model.npz"))
    (clip,) = open_dataset(tmp_path / "a.npz").clips
    there = joints[NAMES.index("left_hip")] - joints[0]
    assert np.allclose(clip.skeleton.offsets[NAMES.index("left_hip")], there, atol=1e-6)
    monkeypatch.setenv("MOTIONSCAPE_SMPL", str(tmp_path / "model.pkl"))
    with pytest.raises(RecordingError, match=r"\.npz"):
        open_dataset(tmp_path / "a.npz")


@pytest.mark.parametrize(
    "fault", [{"trans": np.zeros((3, 3))}, {"poses": np.zeros((40, 9))}, {"poses": np.full((40, 72), np.nan)}]
)
def test_arrays_that_do_not_fit_together_are_refused(tmp_path, fault):
    good = {"poses": np.zeros((40, 72)), "trans": np.zeros((40, 3)), "mocap_framerate": 60}
    np.savez(tmp_path / "a.npz", **(good | fault))
    with pytest.raises(RecordingError):
        open_dataset(tmp_path / "a.npz")


def test_a_pickle_is_refused_with_the_way_to_convert_it(tmp_path):
    (tmp_path / "a.pkl").write_bytes(b"\x80\x04N.")
    with pytest.raises(RecordingError, match=r"never read.*numpy\.savez"):
        open_dataset(tmp_path / "a.pkl")
