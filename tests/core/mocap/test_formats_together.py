"""A folder of all formats goes in at once, and the same walk in each is the same walk."""

from __future__ import annotations

import json

import numpy as np
import pytest

from core.mocap.anatomy import find_anatomy
from core.mocap.bvh import write_bvh
from core.mocap.dataset import open_dataset
from core.mocap.gltf_writer import write_glb
from core.mocap.kinematics import joint_positions
from core.mocap.rigs import comparable_groups
from core.workspace import Workspace
from tests.core.mocap.c3d_writer import c3d
from tests.core.mocap.points.test_points import table, trc
from tests.core.mocap.points.walker import POINTS, figure, walk
from tests.core.mocap.test_opensim_mvnx import mvnx
from tests.core.mocap.test_smpl import amass

PARTS = ("left_knee", "right_elbow", "left_wrist", "right_ankle", "head")


@pytest.fixture
def folder(tmp_path):
    """The same walk in nine formats, and three other files."""
    folder = tmp_path / "takes"
    folder.mkdir()
    clip, values = figure(), walk()
    write_bvh(folder / "bvh.bvh", clip)
    write_glb(folder / "glb.glb", clip)
    (folder / "c3d.c3d").write_bytes(c3d(values[..., [2, 0, 1]] * 1000, POINTS, rate=30.0))
    (folder / "trc.trc").write_text(trc(values * 1000, POINTS))
    (folder / "csv.csv").write_text(table(values, POINTS, lambda name, axis: f"{name}_{axis}"))
    (folder / "json.json").write_text(json.dumps({"fps": 30, "joint_names": POINTS, "joints": values.tolist()}))
    np.savez(folder / "npz.npz", joints=values, fps=30)
    np.save(folder / "npy.npy", values)
    (folder / "mvnx.mvnx").write_text(mvnx()[0])
    amass(folder / "amass.npz")
    (folder / "labels.csv").write_text("clip,start_frame,end_frame,action\nbvh,0,90,walk\n")
    (folder / "notes.txt").write_text("Recorded on Monday.\n")
    (folder / "body.pkl").write_bytes(b"\x80\x04N.")
    return folder


def test_the_same_walk_in_every_format_is_the_same(folder):
    clips = {clip.name: clip for clip in open_dataset(folder, on_error="report").clips}
    there = {part: walk()[:, POINTS.index(part)] for part in PARTS}
    for name in ("bvh", "glb", "c3d", "trc", "csv", "json", "npz", "npy"):
        clip = clips[name]
        joints, at = find_anatomy(clip.skeleton).joints, joint_positions(clip)
        for part in PARTS:
            # C3D has Z up: turned, the walk goes along X
            own = at[:, joints[part]][:, [2, 1, 0]] * [-1, 1, 1] if name == "c3d" else at[:, joints[part]]
            away = own - own[0] - (there[part] - there[part][0])
            assert np.linalg.norm(away * ([1, 1, 1] if name != "c3d" else [0, 1, 0]), axis=1).max() < 5e-3, (name, part)


def test_a_workspace_takes_them_all_in_one_go(folder, tmp_path):
    workspace = Workspace(tmp_path / "space")
    report = workspace.import_dataset("all", folder)
    dataset = workspace.open("all")
    assert len(dataset.clips) == 10 and report.count("error") == 0 and len(dataset.labels) == 1
    assert [group.words for group in comparable_groups(dataset)] == ["people"]
    told = " ".join(message for file in report.files for message in file.messages)
    assert "pickle" in told and "notes.txt" in told
