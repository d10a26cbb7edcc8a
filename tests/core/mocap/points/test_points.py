"""Files of points: every dialect gives the same walk, gaps are marked, what is no recording says so."""

from __future__ import annotations

import json

import numpy as np
import pytest

from core.inspection import inspect_file, inspect_recording
from core.mocap.anatomy import find_anatomy
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.points.array_files import humanml3d_positions
from core.mocap.points.cleaning import smoothed
from core.mocap.points.presets import PRESETS
from core.mocap.points.reading import read_points
from core.mocap.readers import is_recording
from tests.core.mocap.points.walker import POINTS, figure, of_preset, walk


def pairs(names, values):
    """Names with their values."""
    return zip(names, values, strict=True)


ALL_FOUR = ("left_knee", "right_elbow", "left_wrist", "right_ankle")


def trc(values, names, divider="\t", axes=True, unit="mm", blank=True) -> str:
    head = ["PathFileType", "4", "(X/Y/Z)", "walk.trc"]
    keys = [
        "DataRate",
        "CameraRate",
        "NumFrames",
        "NumMarkers",
        "Units",
        "OrigDataRate",
        "OrigDataStartFrame",
        "OrigNumFrames",
    ]
    facts = ["30.00", "30.00", str(len(values)), str(len(names)), unit, "30.00", "1", str(len(values))]
    lines = [divider.join(head), divider.join(keys), divider.join(facts)]
    lines.append(divider.join(["Frame#", "Time", *(cell for name in names for cell in (name, "", ""))]))
    if axes:
        lines.append(divider.join(["", "", *(f"{a}{k + 1}" for k in range(len(names)) for a in "XYZ")]))
    lines += [""] if blank else []
    for f, row in enumerate(values.reshape(len(values), -1)):
        lines.append(divider.join([str(f + 1), f"{f / 30:.5f}", *("" if np.isnan(v) else f"{v:.5f}" for v in row)]))
    return "\n".join(lines) + "\n"


def table(values, names, header, divider=",", lead=("frame", "time")) -> str:
    lines = [divider.join([*lead, *(header(name, axis) for name in names for axis in "xyz")])] if header else []
    for f, row in enumerate(values.reshape(len(values), -1)):
        first = [str(f), f"{f / 30:.6f}"][: len(lead)]
        lines.append(divider.join([*first, *("" if np.isnan(v) else f"{v:.6f}" for v in row)]))
    return "\n".join(lines) + "\n"


def tidy(values, names) -> str:
    rows = [
        f"{f},{f / 30:.5f},{n},{x:.6f},{y:.6f},{z:.6f}"
        for f, r in enumerate(values)
        for n, (x, y, z) in pairs(names, r)
    ]
    return "frame,timestamp,keypoint,x,y,z\n" + "\n".join(rows)


def deeplabcut(values, names) -> str:
    rows = [["scorer"] + ["me"] * 4 * len(names), ["bodyparts", *(n for n in names for _ in range(4))]]
    rows += [["coords"] + ["x", "y", "z", "likelihood"] * len(names)]
    rows += [[str(f), *(str(round(v, 6)) for p in row for v in (*p, 0.9))] for f, row in enumerate(values)]
    return "\n".join(",".join(row) for row in rows)


def motive(values, names) -> str:
    rows = [["Format Version", "1.23", "Export Frame Rate", "30.000000", "Length Units", "Meters"], []]
    kinds = [k for _ in names for k in ("Rotation",) * 4 + ("Position",) * 3]
    rows += [["", "Type", *("Bone" for _ in kinds)], ["", "Name", *(f"Skel:{n}" for n in names for _ in range(7))]]
    rows += [["", "", *kinds], ["Frame", "Time (Seconds)", *("XYZWXYZ" * len(names))]]
    rows += [
        [str(f), f"{f / 30:.6f}", *(str(v) for p in row for v in (0, 0, 0, 1, *p.round(6)))]
        for f, row in enumerate(values)
    ]
    return "\n".join(",".join(row) for row in rows)


MIXED = {
    name: f"{'L' if name.startswith('left') else 'R'}{name.split('_')[1].title()}" for name in POINTS if "_" in name
}
TEXTS = {
    "a.trc": lambda v: trc(v * 1000, POINTS),
    "no_axes.trc": lambda v: trc(v, POINTS, axes=False, unit="m"),
    "commas.trc": lambda v: trc(v * 1000, POINTS, ",", blank=False),
    "crlf.trc": lambda v: trc(v * 100, POINTS, unit="cm").replace("\n", "\r\n"),
    "under.csv": lambda v: table(v, POINTS, lambda n, a: f"{n}_{a}"),
    "dots.csv": lambda v: table(v, POINTS, lambda n, a: f"{n}.{a.upper()}", ";"),
    "first.csv": lambda v: table(v, POINTS, lambda n, a: f"{a}_{n}"),
    "units.csv": lambda v: table(v * 1000, POINTS, lambda n, a: f"{n} {a} (mm)"),
    "quoted.tsv": lambda v: table(v, POINTS, lambda n, a: f'"{n} {a}"', "\t"),
    "other_names.csv": lambda v: table(v, [MIXED.get(n, n) for n in POINTS], lambda n, a: f"{n}_{a}"),
    "backwards.csv": lambda v: table(v[:, ::-1], POINTS[::-1], lambda n, a: f"{n}_{a}"),
    "none.csv": lambda v: table(v, POINTS, None, lead=()),
    "tidy.csv": lambda v: tidy(v, POINTS),
    "dlc.csv": lambda v: deeplabcut(v, POINTS),
    "motive.csv": lambda v: motive(v, POINTS),
    "frames.json": lambda v: json.dumps({"fps": 30, "joint_names": POINTS, "frames": v.tolist()}),
    "dicts.json": lambda v: json.dumps(
        [{n: {"x": p[0], "y": p[1], "z": p[2]} for n, p in pairs(POINTS, r)} for r in v.tolist()]
    ),
    "lists.json": lambda v: json.dumps(
        [[{"name": n, "x": x, "y": y, "z": z} for n, (x, y, z) in pairs(POINTS, r)] for r in v.tolist()]
    ),
    "tracks.json": lambda v: json.dumps({n: v[:, k].tolist() for k, n in enumerate(POINTS)}),
    "numbered.json": lambda v: json.dumps(
        {str(f): {"joints": dict(pairs(POINTS, r))} for f, r in enumerate(v.tolist())}
    ),
}


@pytest.mark.parametrize("name", TEXTS)
def test_every_dialect_gives_the_same_walk(tmp_path, name):
    values = walk()
    path = tmp_path / name
    path.write_text(TEXTS[name](values))
    assert is_recording(path)
    report, facts = inspect_recording(path)
    assert {finding.kind for finding in report.findings} <= {"sliding"}, report.messages
    assert (facts.frames, facts.fps, facts.body, facts.up) == (90, 30.0, "human", "y")
    assert facts.height == pytest.approx(find_anatomy(figure().skeleton).body_height, rel=0.01)
    (clip,) = open_dataset(path).clips
    joints = find_anatomy(clip.skeleton).joints
    at = joint_positions(clip)
    for part in ALL_FOUR:
        assert np.abs(at[:, joints[part]] - values[:, POINTS.index(part)]).max() < 2e-3


@pytest.mark.parametrize("name", [n for n in PRESETS if n != "smpl22"])
def test_every_preset_is_known_by_its_number_of_points_and_makes_a_whole_body(tmp_path, name):
    values = of_preset(name)
    np.save(tmp_path / "a.npy", values.astype(np.float32))
    (clip,) = open_dataset(tmp_path / "a.npy").clips
    anatomy = find_anatomy(clip.skeleton)
    assert anatomy.body == "human", anatomy.missing
    assert PRESETS[name].title in " ".join(clip.notes)
    at, parts = joint_positions(clip), PRESETS[name].parts
    for part in ALL_FOUR:
        place = values[:, [PRESETS[name].points.index(p) for p in parts[part]]].mean(axis=1)
        assert np.abs(at[:, anatomy.joints[part]] - place).max() < 5e-3, part


@pytest.mark.parametrize(
    ("up", "turn"), [("z", lambda v: v[..., [0, 2, 1]] * [1, -1, 1]), ("-y", lambda v: v * [1, -1, -1])]
)
def test_points_that_stand_along_another_axis_are_turned(tmp_path, up, turn):
    np.save(tmp_path / "a.npy", turn(walk()))
    (clip,) = open_dataset(tmp_path / "a.npy").clips
    np.save(tmp_path / "b.npy", walk())
    (straight,) = open_dataset(tmp_path / "b.npy").clips
    assert clip.up == up and clip.skeleton.names == straight.skeleton.names
    assert np.abs(joint_positions(clip) - joint_positions(straight)).max() < 2e-3
    assert np.abs(clip.rotations - straight.rotations).max() < 2e-3


def test_gaps_are_filled_and_marked_and_long_ones_are_doubts(tmp_path):
    values = walk()
    values[20:25, POINTS.index("left_wrist")] = np.nan
    values[40:70, POINTS.index("right_ankle")] = np.nan
    (tmp_path / "a.trc").write_text(trc(values * 1000, POINTS))
    report = inspect_file(tmp_path / "a.trc")
    found = {f.kind: (f.start, f.end) for f in report.findings if f.kind in ("filled", "gap")}
    assert found == {"filled": (20, 25), "gap": (40, 70)}
    (clip,) = open_dataset(tmp_path / "a.trc").clips
    wrist = joint_positions(clip)[20:25, find_anatomy(clip.skeleton).joints["left_wrist"]]
    assert np.abs(wrist - walk()[20:25, POINTS.index("left_wrist")]).max() < 0.03


def test_points_at_the_origin_are_lost(tmp_path):
    values = walk()
    values[10:14, POINTS.index("left_wrist")] = 0
    np.save(tmp_path / "a.npy", values)
    report = inspect_file(tmp_path / "a.npy")
    assert [(f.kind, f.start, f.end) for f in report.findings if f.kind != "sliding"] == [("filled", 10, 14)]


def test_openpose_writes_a_file_a_frame_and_they_are_one_clip(tmp_path):
    values = of_preset("body25", 40)
    for f, row in enumerate(values):
        flat = [x for p in row for x in (*p, 0.9)]
        text = json.dumps({"version": 1.3, "people": [{"pose_keypoints_3d": flat}]})
        (tmp_path / f"walk_{f:012d}_keypoints.json").write_text(text)
    dataset = open_dataset(tmp_path)
    assert [clip.n_frames for clip in dataset.clips] == [40]
    assert find_anatomy(dataset.clips[0].skeleton).body == "human" and not dataset.report.messages


def test_numbered_recordings_are_not_the_frames_of_one(tmp_path):
    values = of_preset("body25", 50)
    for k in range(3):
        document = {"names": [f"p{j}" for j in range(25)], "joints": values.tolist(), "fps": 30}
        (tmp_path / f"walk_{k:03d}.json").write_text(json.dumps(document))
    dataset = open_dataset(tmp_path, points="body25")
    assert {clip.name: clip.n_frames for clip in dataset.clips} == {f"walk_{k:03d}": 50 for k in range(3)}


def test_arrays_in_other_orders_and_with_several_people(tmp_path):
    values = walk(120)
    np.savez(tmp_path / "joints_first.npz", motion=values.transpose(1, 2, 0))
    np.savez(tmp_path / "two.npz", joints=np.stack([values, values + 1]), fps=60)
    np.savez(tmp_path / "flat.npz", positions=values.reshape(120, -1), joint_names=np.array(POINTS))
    np.savez(tmp_path / "sure.npz", keypoints=np.concatenate([values, np.ones((120, 22, 1))], axis=2))
    clips = open_dataset(tmp_path).clips
    assert [clip.n_frames for clip in clips] == [120] * 5
    assert {find_anatomy(clip.skeleton).body for clip in clips} == {"human"}
    assert sorted(clip.fps for clip in clips) == [20.0, 20.0, 30.0, 60.0, 60.0]


def test_pickles_are_never_opened(tmp_path):
    np.save(tmp_path / "a.npy", np.array([{"a": 1}], object), allow_pickle=True)
    np.savez(tmp_path / "b.npz", joints=np.array([{"a": 1}], object))
    for name in ("a.npy", "b.npz"):
        assert not is_recording(tmp_path / "a.npy")
        with pytest.raises(RecordingError, match=r"Python objects|no array of points"):
            open_dataset(tmp_path / name)


def test_smoothing_takes_jitter_out_and_says_its_cut_off(tmp_path):
    values = walk(300)
    noisy = values + np.random.default_rng(0).normal(0, 0.01, values.shape)
    assert np.abs(smoothed(noisy, 30, 5.0) - values).mean() < 0.6 * np.abs(noisy - values).mean()
    np.save(tmp_path / "a.npy", noisy)
    (clip,) = read_points(tmp_path / "a.npy", ".npy", smooth=5.0)
    assert any("5 Hz" in note for note in clip.notes)


@pytest.mark.parametrize(
    "text", ["frame,time\n1,2\n", "a,b,c,d\nx,y,z,w\n", "", "clip,start_frame,end_frame,action\nw,0,9,a\n"]
)
def test_other_tables_are_no_recordings(tmp_path, text):
    (tmp_path / "a.csv").write_text(text)
    assert not is_recording(tmp_path / "a.csv")
    with pytest.raises(RecordingError):
        open_dataset(tmp_path / "a.csv")


def test_a_letter_among_the_numbers_is_named_with_its_line(tmp_path):
    text = trc(walk(20), POINTS, unit="m").split("\n")
    text[12] = text[12].replace("0.", "O.", 1)
    (tmp_path / "a.trc").write_text("\n".join(text))
    with pytest.raises(RecordingError, match=r"a\.trc:13: 'O\."):
        open_dataset(tmp_path / "a.trc")


def test_the_263_numbers_are_the_joints_that_they_come_from(shared_data):
    joints = np.load(shared_data / "formats" / "humanml3d_joints_012314.npy")
    vectors = shared_data / "formats" / "humanml3d_vectors_012314.npy"
    assert np.abs(humanml3d_positions(np.load(vectors)) - joints).max() < 1e-5
    (clip,) = open_dataset(vectors).clips
    order = [clip.skeleton.names.index(name) for name in POINTS]
    assert np.abs(joint_positions(clip)[:, order] - joints).max() < 1e-3


def test_utkinect_stands_at_its_own_times(shared_data):
    clip = open_dataset(shared_data / "utkinect" / "joints_s01_e01.txt").clips[0]
    assert (clip.n_frames, clip.fps) == (2290 - 190 + 1, 30.0)
    assert find_anatomy(clip.skeleton).body == "human" and 1.4 < find_anatomy(clip.skeleton).body_height < 1.9
