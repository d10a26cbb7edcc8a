"""C3D files: every byte order, integers and reals, gaps, people, marker sets."""

from __future__ import annotations

import numpy as np
import pytest

from core.inspection import inspect_file, inspect_recording
from core.mocap.anatomy import find_anatomy
from core.mocap.c3d_file import parse_c3d
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.points.markers import joints_of_markers
from tests.core.mocap.c3d_writer import c3d
from tests.core.mocap.points.walker import POINTS, walk

SAMPLES = [
    *("Eb015pi", "Eb015pr", "Eb015vi", "Eb015vr", "dec_int", "sgi_real", "duplicate_labels", "rotations"),
    *("plug_in_gait_static", "tennis_serve", "tennis_serve_2players", "tennis_serve_gaps"),
]


@pytest.mark.parametrize("order", ["intel", "dec", "sgi"])
@pytest.mark.parametrize("real", [True, False])
def test_every_byte_order_gives_the_same_walk(tmp_path, order, real):
    values = walk()[..., [2, 0, 1]]  # Z up, as is usual
    (tmp_path / "a.c3d").write_bytes(c3d(values * 1000, POINTS, order, real))
    report, facts = inspect_recording(tmp_path / "a.c3d")
    assert {f.kind for f in report.findings} <= {"sliding"}
    assert (facts.frames, facts.fps, facts.unit, facts.up, facts.body) == (90, 50.0, "mm", "z", "human")
    (clip,) = open_dataset(tmp_path / "a.c3d").clips
    wrist = joint_positions(clip)[:, find_anatomy(clip.skeleton).joints["left_wrist"]]
    there = values[:, POINTS.index("left_wrist")]
    assert np.abs(wrist - there[:, [0, 2, 1]] * [1, 1, -1]).max() < 3e-3


def test_lost_points_are_filled_and_marked(tmp_path):
    values = walk() * 1000
    values[30:36, POINTS.index("right_knee")] = np.nan
    (tmp_path / "a.c3d").write_bytes(c3d(values, POINTS))
    found = [(f.kind, f.start, f.end) for f in inspect_file(tmp_path / "a.c3d").findings if f.kind != "sliding"]
    assert found == [("filled", 30, 36)]


def test_each_person_is_a_clip(tmp_path):
    values = np.concatenate([walk(), walk() + np.array([1.0, 0, 0])], axis=1)
    labels = [f"{who}:{point}" for who in ("Ann", "Bo") for point in POINTS]
    (tmp_path / "a.c3d").write_bytes(c3d(values, labels, unit="m"))
    clips = open_dataset(tmp_path / "a.c3d").clips
    assert [clip.name for clip in clips] == ["a", "a Bo"]
    assert np.abs(joint_positions(clips[1])[:, 0] - joint_positions(clips[0])[:, 0] - [1, 0, 0]).max() < 1e-3


def test_a_file_that_ends_early_is_read_as_far_as_it_goes(tmp_path):
    whole = c3d(walk() * 1000, POINTS)
    (tmp_path / "a.c3d").write_bytes(whole[: len(whole) - 22 * 16 * 30])
    report = inspect_file(tmp_path / "a.c3d")
    assert "rows" in {f.kind for f in report.findings} and open_dataset(tmp_path / "a.c3d").clips[0].n_frames == 60


def test_hip_centres_lie_where_the_regression_says():
    markers = {"LASI": (0.12, 1, 0), "RASI": (-0.12, 1, 0), "LPSI": (0.05, 1, -0.15), "RPSI": (-0.05, 1, -0.15)}
    markers |= {"LKNE": (0.15, 0.5, 0), "RKNE": (-0.15, 0.5, 0), "LANK": (0.13, 0.08, 0), "RANK": (-0.13, 0.08, 0)}
    markers |= {"LTOE": (0.13, 0.03, 0.15), "RTOE": (-0.13, 0.03, 0.15)}
    values = np.tile(np.array(list(markers.values()))[None], (3, 1, 1))
    joints = joints_of_markers(list(markers), values, 1.0)
    # Harrington et al. 2007 for a pelvis 240 mm wide and 150 mm deep: back 45.9, down 82.9, out 86.5 mm
    assert np.allclose(joints["left_hip"][0], [0.0865, 1 - 0.0829, -0.0459], atol=1e-4)
    assert joints["left_knee"][0, 0] == pytest.approx(0.15 - 0.05, abs=5e-3)


def test_what_is_no_c3d_says_so(tmp_path):
    for content in (b"x" * 2000, b"\x02\x50" + bytes(1000), b"\x02\x50"):
        (tmp_path / "a.c3d").write_bytes(content)
        with pytest.raises(RecordingError):
            open_dataset(tmp_path / "a.c3d")


@pytest.mark.parametrize("name", SAMPLES)
def test_the_samples_are_read(shared_data, name):
    clip = open_dataset(shared_data / "formats" / f"{name}.c3d").clips[0]
    assert clip.n_frames > 50 and np.isfinite(joint_positions(clip)).all()
    if name.startswith(("tennis", "plug", "rotations")):
        assert find_anatomy(clip.skeleton).body == "human" and 1.5 < find_anatomy(clip.skeleton).body_height < 2.0


def test_the_same_motion_in_other_numbers_is_the_same(shared_data):
    folder = shared_data / "formats"
    a, b = (parse_c3d(name, (folder / name).read_bytes()).points for name in ("dec_int.c3d", "sgi_real.c3d"))
    assert np.nanmax(np.abs(a - b)) < 1e-3 and (np.isnan(a) == np.isnan(b)).all()
    ezc3d = pytest.importorskip("ezc3d")
    for name in (n for n in SAMPLES if n not in ("sgi_real", "rotations")):
        theirs = ezc3d.c3d(str(folder / f"{name}.c3d"))["data"]["points"][:3].transpose(2, 1, 0)
        ours = parse_c3d(name, (folder / f"{name}.c3d").read_bytes()).points
        assert np.array_equal(theirs, ours, equal_nan=True)
