"""Forward kinematics of what the readers return, against plain parsers and 4x4 matrices."""

from __future__ import annotations

import numpy as np
import pytest

from core.mocap.anatomy import find_anatomy
from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from tests.core.mocap import oracle, samples

SHARE_OF_HEIGHT = 1e-4
BVH_FILES = [
    *("cmu/bvh/001_14.bvh", "cmu/bvh/002_01.bvh", "cmu/bvh/005_06.bvh", "cmu/bvh/007_03.bvh"),
    *("bandai_namco_1/dataset-1_run_normal_001.bvh", "bandai_namco_1/dataset-1_bow_active_001.bvh"),
    *("bandai_namco_1/dataset-1_walk-back_normal_001.bvh", "bandai_namco_1/dataset-1_dash_normal_001.bvh"),
    *("fairmotion/01_01.bvh", "fairmotion/sinusoidal.bvh", "fairmotion/sinusoidal_2.bvh"),
    *("malformed/ok_baseline.bvh", "malformed/ok_leading_dot_numbers.bvh", "malformed/ok_zero_length_end_site.bvh"),
]
AMC_FILES = [
    *(("01/01_06.amc.gz", "01/01.asf"), ("02/02_03.amc", "02/02.asf"), ("03/03_02.amc", "03/03.asf")),
    *(("11/11_01.amc", "11/11.asf"), ("13/13_30.amc", "86/86.asf"), ("86/86_09.amc", "86/86.asf")),
]


def _frames(clip: Clip) -> list[int]:
    return sorted({0, clip.n_frames - 1, *np.linspace(0, clip.n_frames - 1, 7).astype(int).tolist()})


def _check_bvh(path) -> None:
    clip = read_bvh(path)
    frames = _frames(clip)
    expected = oracle.bvh_positions(path, frames)
    found = joint_positions(clip)[frames]
    height = find_anatomy(clip.skeleton).body_height
    for j, name in enumerate(clip.skeleton.names):
        assert np.abs(found[:, j] - expected[name] * clip.skeleton.unit).max() < SHARE_OF_HEIGHT * height, name


def _check_amc(path, skeleton) -> None:
    clip = read_amc(path, read_asf(skeleton))
    frames = _frames(clip)
    expected = oracle.amc_positions(path, skeleton, frames)
    found = joint_positions(clip)[frames]
    height = find_anatomy(clip.skeleton).body_height
    names, parents = clip.skeleton.names, clip.skeleton.parents
    for j, name in enumerate(names):
        bone = names[parents[j]] if j else "root"  # a joint is where its parent bone ends
        assert np.abs(found[:, j] - expected[bone]).max() < SHARE_OF_HEIGHT * height, name


@pytest.mark.parametrize("file", BVH_FILES)
def test_real_bvh(shared_data, file):
    _check_bvh(shared_data / file)


@pytest.mark.parametrize("file, skeleton", AMC_FILES)
def test_real_amc(shared_data, file, skeleton):
    _check_amc(shared_data / "cmu/asfamc" / file, shared_data / "cmu/asfamc" / skeleton)


def test_generated_bvh(tmp_path):
    (tmp_path / "a.bvh").write_text(samples.BVH)
    _check_bvh(tmp_path / "a.bvh")


def test_generated_bvh_with_a_moving_joint_above_the_pelvis_and_positions_everywhere(tmp_path):
    text = samples.BVH.replace("CHANNELS 3 Zrotation", "CHANNELS 6 Xposition Zposition Yposition Zrotation")
    text = text.replace(
        "ROOT Hips", "ROOT World\n{\nOFFSET 1 2 3\nCHANNELS 4 Xposition Yrotation Zposition Xrotation\nJOINT Hips"
    )
    head, rows = text.split("MOTION\n")
    rows = rows.split("\n")
    table = []
    for k, row in enumerate(rows[2:5]):
        w = row.split()
        table.append(" ".join(["5", str(30 + k), str(7 * k), "4", *w[:6], "1", str(k), "21", *w[6:]]))
    path = tmp_path / "a.bvh"
    path.write_text(head + "}\nMOTION\n" + "\n".join([*rows[:2], *table]))
    clip = read_bvh(path)
    assert clip.skeleton.names[0] == "Hips"
    assert list(clip.translations) == [clip.skeleton.index("Chest")]
    assert any("World above Hips" in note for note in clip.notes)
    _check_bvh(path)


def test_generated_amc(tmp_path):
    (tmp_path / "a.asf").write_text(samples.ASF)
    (tmp_path / "a.amc").write_text(samples.AMC)
    _check_amc(tmp_path / "a.amc", tmp_path / "a.asf")


def test_legs_of_the_same_motion_agree_between_formats(shared_data):
    """fairmotion's BVH of CMU 01_01 has one frame more in front, and the same legs (the data's README)."""
    asf = read_asf(shared_data / "cmu/asfamc/01/01.asf")
    amc = read_amc(shared_data / "cmu/asfamc/01/01_01.amc", asf)
    bvh = read_bvh(shared_data / "fairmotion/01_01.bvh")
    a, b = joint_positions(amc), joint_positions(bvh)[1:]
    pairs = {
        "lfemur": "LeftUpLeg",
        "ltibia": "LeftLeg",
        "lfoot": "LeftFoot",
        "ltoes": "LeftToeBase",
        "rfoot": "RightFoot",
    }
    for bone, joint in pairs.items():
        assert np.abs(a[:, amc.skeleton.index(bone)] - b[:, bvh.skeleton.index(joint)]).max() < 2e-5
