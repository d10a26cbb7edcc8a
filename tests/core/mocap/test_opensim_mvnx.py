"""OpenSim's tables as curves, and Xsens' segments."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from core.inspection import inspect_recording
from core.mocap import quaternions as quat
from core.mocap.anatomy import find_anatomy
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.mvnx import PARENTS

HEAD = "Coordinates\nversion=1\nnRows=3\nnColumns=4\ninDegrees={degrees}\n\nendheader\n"
SEGMENTS = ["Pelvis", "L5", "L3", "T12", "T8", "Neck", "Head"]
SEGMENTS += [f"Right{part}" for part in ("Shoulder", "UpperArm", "ForeArm", "Hand")]
SEGMENTS += [f"Left{part}" for part in ("Shoulder", "UpperArm", "ForeArm", "Hand")]
SEGMENTS += [f"{side}{part}" for side in ("Right", "Left") for part in ("UpperLeg", "LowerLeg", "Foot", "Toe")]


@pytest.mark.parametrize(("degrees", "factor"), [("yes", 1.0), ("no", np.pi / 180)])
@pytest.mark.parametrize("divider", ["\t", ",", " "])
def test_angles_turn_and_lengths_shift(tmp_path, degrees, factor, divider):
    rows = [["time", "knee_angle_r", "pelvis_tx", "hip_moment"]]
    rows += [[f"{k / 50:.3f}", f"{30 * k * factor:.9f}", f"{0.1 * k:.4f}", f"{100 * k}"] for k in range(3)]
    (tmp_path / "a.mot").write_text(HEAD.format(degrees=degrees) + "\n".join(divider.join(row) for row in rows))
    (clip,) = open_dataset(tmp_path / "a.mot").clips
    assert clip.fps == 50.0 and clip.skeleton.names[1:] == ("knee_angle_r", "pelvis_tx", "hip_moment")
    assert np.allclose(np.degrees(quat.to_rotvec(clip.rotations[:, 1].astype(float)))[:, 0], [0, 30, 60], atol=1e-3)
    at = joint_positions(clip)
    assert np.allclose(at[:, 2, 1], [0, 0.1, 0.2], atol=1e-5) and np.allclose(at[:, 3, 1], [0, 0.1, 0.2], atol=1e-5)


@pytest.mark.parametrize(
    "text", ["time\ta\n0\t1\n", HEAD.format(degrees="yes"), HEAD.format(degrees="yes") + "a\tb\n1\t2\n"]
)
def test_other_tables_are_refused(tmp_path, text):
    (tmp_path / "a.sto").write_text(text)
    with pytest.raises(RecordingError):
        open_dataset(tmp_path / "a.sto")


@pytest.mark.parametrize(("name", "columns"), [("inverse_kin.mot", 25), ("inverse_dyn.sto", 25)])
def test_the_samples_are_read(shared_data, name, columns):
    (clip,) = open_dataset(shared_data / "formats" / name).clips
    assert clip.skeleton.n_joints == columns + 1 and clip.n_frames > 50 and clip.fps == 100.0


def mvnx(n: int = 12) -> tuple[str, np.ndarray]:
    """The text of a file, Z up, and the places (n, 23, 3) in it."""
    rest = dict.fromkeys(SEGMENTS, (0.0, 0.0, 0.1))
    for sign, side in ((-1, "Right"), (1, "Left")):
        rest |= {f"{side}Shoulder": (0, 0.05 * sign, 0.1), f"{side}UpperArm": (0, 0.15 * sign, 0)}
        rest |= {f"{side}ForeArm": (0, 0.3 * sign, 0), f"{side}Hand": (0, 0.25 * sign, 0)}
        rest |= {f"{side}UpperLeg": (0, 0.09 * sign, -0.03), f"{side}LowerLeg": (0, 0, -0.42)}
        rest |= {f"{side}Foot": (0, 0, -0.41), f"{side}Toe": (0.15, 0, -0.05)}
    places, frames = np.zeros((n, len(SEGMENTS), 3)), []
    for f in range(n):
        turns = {name: Rotation.identity() for name in SEGMENTS}
        bend = Rotation.from_euler("z", 4.0 * f, degrees=True)
        for name in ("LeftForeArm", "LeftHand"):
            turns[name] = bend
        for j, name in enumerate(SEGMENTS):
            if name == "Pelvis":
                places[f, j] = (0.05 * f, 0, 0.95)
            else:
                above = PARENTS[name]
                places[f, j] = places[f, SEGMENTS.index(above)] + turns[above].apply(rest[name])
        orientation = " ".join(f"{v:.6f}" for name in SEGMENTS for v in np.roll(turns[name].as_quat(), 1))
        position = " ".join(f"{v:.6f}" for v in places[f].ravel())
        numbers = f"<orientation>{orientation}</orientation><position>{position}</position>"
        frames.append(f'<frame type="normal" index="{f}">{numbers}</frame>')
    listed = "".join(f'<segment label="{name}" id="{k + 1}"/>' for k, name in enumerate(SEGMENTS))
    tpose = '<frame type="tpose"><orientation>1</orientation><position>0</position></frame>'
    text = (
        f'<mvnx xmlns="http://www.xsens.com/mvn/mvnx"><subject label="A" frameRate="120"><segments>{listed}</segments>'
    )
    return text + f"<frames>{tpose}{''.join(frames)}</frames></subject></mvnx>", places


def test_segments_lie_where_the_file_has_them(tmp_path):
    text, places = mvnx()
    (tmp_path / "a.mvnx").write_text(text)
    report, facts = inspect_recording(tmp_path / "a.mvnx")
    assert (facts.frames, facts.fps, facts.body, facts.up) == (12, 120.0, "human", "z"), report.messages
    (clip,) = open_dataset(tmp_path / "a.mvnx").clips
    at = joint_positions(clip)
    for name in ("LeftHand", "RightFoot", "Head"):
        there = places[:, SEGMENTS.index(name)][:, [1, 2, 0]]
        ours = at[:, clip.skeleton.index(name)]
        assert np.allclose(
            np.linalg.norm(ours - at[:, 0], axis=1),
            np.linalg.norm(there - places[:, 0][:, [1, 2, 0]], axis=1),
            atol=1e-4,
        )
    assert find_anatomy(clip.skeleton).joints["left_elbow"] == clip.skeleton.index("LeftForeArm")


@pytest.mark.parametrize("text", ["<mvnx>", "<mvnx/>", "<!DOCTYPE a [<!ENTITY x 'y'>]><mvnx/>", "no xml"])
def test_what_is_no_mvnx_says_so(tmp_path, text):
    (tmp_path / "a.mvnx").write_text(text)
    with pytest.raises(RecordingError):
        open_dataset(tmp_path / "a.mvnx")
