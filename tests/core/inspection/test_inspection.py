"""Inspection: a clean clip has no doubts; each fault is found where it was put."""

from __future__ import annotations

import csv
from dataclasses import replace

import numpy as np
import pytest

from core.inspection import inspect_clip, inspect_dataset, inspect_file, rest_pose
from core.mocap import quaternions as quat
from core.mocap.bvh import read_bvh, write_bvh
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.kinematics import resample
from core.mocap.reading import Reading
from core.mocap.skeleton import Skeleton
from tests.core.mocap import samples


def _rotated(clip: Clip, frames: slice | list[int], joint: str, rotvec) -> Clip:
    """The clip with one joint's rotation replaced in some frames."""
    rotations = clip.rotations.copy()
    rotations[frames, clip.skeleton.index(joint)] = quat.from_rotvec(np.array(rotvec, float))
    return replace(clip, rotations=rotations)


def _in_front(clip: Clip, frames: int, rest: bool) -> Clip:
    """The clip with frames of the rest pose (a T-pose), or of its own first frame, in front, 3 m away."""
    rotations = np.repeat(clip.rotations[:1], frames, axis=0)
    if rest:
        rotations[:] = (1, 0, 0, 0)
    root = np.repeat(clip.root_positions[:1], frames, axis=0) + np.float32([3, 0, 0])
    return replace(
        clip,
        rotations=np.concatenate([rotations, clip.rotations]),
        root_positions=np.concatenate([root, clip.root_positions]),
    )


@pytest.mark.parametrize("fps", [30.0, 60.0, 120.0])
def test_a_clean_clip_has_no_doubts(fps):
    assert inspect_clip(samples.idling(fps=fps)) == ()
    assert inspect_clip(samples.idling(fps=fps, seconds=1 / fps)) == ()
    assert inspect_clip(samples.idling(fps=fps, seconds=2 / fps)) == ()


@pytest.mark.parametrize("frames", [1, 40])
def test_a_t_pose_in_front(frames):
    clip = _in_front(samples.idling(), frames, rest=True)
    doubts = inspect_clip(clip)
    last = "frame 0 " if frames == 1 else f"frames 0 to {frames - 1} "
    assert len(doubts) == 1 and doubts[0].startswith(last) and "T-pose" in doubts[0]
    assert rest_pose(clip) == frames
    assert rest_pose(samples.idling()) == 0


def test_a_jump_of_the_body_without_a_t_pose_is_a_jump():
    doubts = inspect_clip(_in_front(samples.idling(), 5, rest=False))
    assert len(doubts) == 1 and "jumps once" in doubts[0] and "Hips by 3 m at frame 5" in doubts[0]


@pytest.mark.parametrize("fps", [60.0, 120.0])
def test_a_flip_of_one_frame(fps):
    clip = samples.idling(fps=fps)
    doubts = inspect_clip(_rotated(clip, [100], "LeftUpLeg", [1.5, 0, 0]))
    assert len(doubts) == 1 and "jumps 2 times" in doubts[0]
    assert "frame 100" in doubts[0] and "frame 101" in doubts[0] and "Left" in doubts[0]


def test_fast_motion_is_no_flip():
    """An arm that swings at 10 m/s, and one that starts at once within a tenth of a second."""
    clip = samples.idling(fps=60.0)
    t = np.arange(clip.n_frames) / clip.fps
    angle = np.stack([np.zeros_like(t), 1.3 * np.sin(2 * np.pi * 1.8 * t), np.zeros_like(t)], axis=1)
    rotations = clip.rotations.copy()
    rotations[:, clip.skeleton.index("LeftArm")] = quat.from_rotvec(angle)
    assert inspect_clip(replace(clip, rotations=rotations)) == ()


def test_repeated_frames_and_odd_rates():
    clip = samples.idling(fps=30.0)
    at = np.repeat(np.arange(clip.n_frames), 2)
    doubled = replace(clip, fps=60.0, rotations=clip.rotations[at], root_positions=clip.root_positions[at])
    assert any("comes 2 times" in doubt and "at 30 " in doubt for doubt in inspect_clip(doubled))
    assert any("frames per second" in doubt for doubt in inspect_clip(replace(clip, fps=2.0)))
    still = replace(clip, rotations=np.repeat(clip.rotations[:1], clip.n_frames, axis=0))
    assert inspect_clip(still) == ("nothing moves in any frame",)


def test_which_way_is_up():
    clip = samples.idling()

    def turned(rotvec):
        q = quat.from_rotvec(np.array(rotvec, float))
        rotations = clip.rotations.copy()
        rotations[:, 0] = quat.multiply(q, rotations[:, 0])
        return replace(clip, rotations=rotations, root_positions=quat.rotate(q, clip.root_positions).astype(np.float32))

    assert any("along Z" in doubt for doubt in inspect_clip(turned([np.pi / 2, 0, 0])))
    assert any("below the feet" in doubt for doubt in inspect_clip(turned([np.pi, 0, 0])))
    assert inspect_clip(turned([0, 2, 0])) == ()
    assert inspect_clip(turned([0.4, 0, 0])) == ()


def test_sizes():
    clip = samples.idling()
    doubts = inspect_clip(samples.idling(scale=3.0))
    assert any("no body is that large" in doubt or "not the size of a person" in doubt for doubt in doubts)
    offsets = clip.skeleton.offsets.copy()
    offsets[clip.skeleton.index("Neck")] = (0, 900, 0)
    s = clip.skeleton
    large = Skeleton(s.names, s.parents, offsets, s.end_sites, s.channels, s.unit)
    assert any("Neck is 900 m away from Chest" in doubt for doubt in inspect_clip(replace(clip, skeleton=large)))


def test_sliding_feet():
    clip = samples.idling()
    root = clip.root_positions.copy()
    root[:, 0] += np.arange(clip.n_frames) * 1.5 / clip.fps
    assert any("feet slide" in doubt for doubt in inspect_clip(replace(clip, root_positions=root)))


def test_a_floor_that_is_not_at_zero_is_a_remark(tmp_path):
    clip = samples.idling()
    low = replace(clip, root_positions=clip.root_positions - np.float32([0, 0.96, 0]))
    write_bvh(tmp_path / "a.bvh", low)
    report = inspect_file(tmp_path / "a.bvh")
    assert report.verdict == "ok" and any("floor is at -0.9" in message for message in report.messages)


def test_files(tmp_path):
    write_bvh(tmp_path / "good.bvh", samples.idling())
    (tmp_path / "good.asf").write_text(samples.ASF)
    (tmp_path / "odd.asf").write_text(samples.ASF.replace("length 9", "length 900000"))
    (tmp_path / "bad.asf").write_text(samples.ASF.replace("length 9", "length nine"))
    (tmp_path / "take.amc").write_text(samples.AMC)
    (tmp_path / "bad.bvh").write_text("nothing")
    (tmp_path / "notes.txt").write_text("nothing")
    verdicts = {"good.bvh": "ok", "good.asf": "ok", "odd.asf": "warning", "bad.asf": "error", "bad.bvh": "error"}
    verdicts |= {"notes.txt": "error", "none.bvh": "error", "none.asf": "error", "take.amc": "error"}
    for name, verdict in verdicts.items():
        report = inspect_file(tmp_path / name)
        assert report.verdict == verdict, report
        assert report.path == str(tmp_path / name) and all("\n" not in m for m in report.messages)
        assert report.messages or verdict == "ok"
    assert inspect_file(tmp_path / "good.bvh").clip == "good" and inspect_file(tmp_path / "good.asf").clip is None
    report = inspect_file(tmp_path / "take.amc", skeleton=tmp_path / "good.asf", how=Reading(fps=30))
    assert report.verdict != "error" and report.clip == "take"


def test_duplicates():
    """A copy, another rate, another body, a T-pose in front: the same motion. Another take is not."""
    clip = samples.idling("a")
    other_body = replace(samples.idling("taller", scale=1.1))
    clips = [
        clip,
        replace(clip, name="copy"),
        replace(resample(clip, 30.0), name="slower rate"),
        other_body,
        replace(_in_front(clip, 1, rest=True), name="with a rest pose"),
        samples.idling("another take", seed=5),
        samples.idling("a third", seed=6),
    ]
    heard = []
    report = inspect_dataset(Dataset("all", tuple(clips)), report=lambda stage, fraction: heard.append(fraction))
    found = {file.clip: file for file in report.files}
    for name in ("copy", "slower rate", "taller", "with a rest pose"):
        doubt = next(message for message in found[name].messages if "same motion as" in message)
        assert "a" in doubt.removeprefix("looks like the same motion as ").split(", "), name
    for name in ("another take", "a third"):
        assert found[name].verdict == "ok", found[name]
    assert heard[0] == 0 and heard[-1] == 1


def test_an_exact_copy_is_called_one(tmp_path):
    for name in ("a", "b"):
        write_bvh(tmp_path / f"{name}.bvh", samples.idling())
    write_bvh(tmp_path / "c.bvh", samples.idling(seed=3))
    (tmp_path / "bad.bvh").write_text("nothing")
    report = inspect_dataset(open_dataset(tmp_path, on_error="report"))
    by_name = {file.path.rpartition("/")[2]: file for file in report.files}
    assert by_name["a.bvh"].messages[0] == "the same recording as b"
    assert [by_name[n].verdict for n in ("a.bvh", "b.bvh", "c.bvh", "bad.bvh")] == ["warning", "warning", "ok", "error"]


def _index(shared_data) -> list[dict]:
    with (shared_data / "cmu/index.csv").open(newline="") as file:
        return [row for row in csv.DictReader(file) if row["format"] == "bvh"]


def test_real_t_poses(shared_data):
    for row in _index(shared_data):
        if row["subject"] == "07" or row["clip"] in ("003_01", "005_03"):
            clip = read_bvh(shared_data / "cmu" / row["file"])
            assert rest_pose(clip) == int(row["tpose_frames"]), row["clip"]
    assert rest_pose(read_bvh(shared_data / "fairmotion/01_01.bvh")) == 1


def test_real_knee_flips_and_clean_dances(shared_data):
    """All nine clips of subject 05 with knee flips are found; those without any fault in the index have no doubts."""
    for row in _index(shared_data):
        if row["subject"] == "05":
            doubts = inspect_clip(read_bvh(shared_data / "cmu" / row["file"]))
            if "knee flips" in row["notes"]:
                assert any("jumps" in doubt for doubt in doubts), row["clip"]
            elif not row["notes"]:
                assert doubts == (), row["clip"]


def test_real_conversions_of_one_motion_are_found(shared_data):
    """The 15 motions that are in cmu both as BVH (60 fps, another body) and AMC (120 fps), and no others."""
    dataset = open_dataset(shared_data / "cmu", skeleton=shared_data / "cmu/asfamc/86/86.asf")
    found = set()
    for file in inspect_dataset(dataset).files:
        for message in file.messages:
            if message.startswith("looks like the same motion as "):
                found.add(frozenset([file.clip, message.removeprefix("looks like the same motion as ")]))
    both = {name for name in dataset.names if "0" + name in dataset.names}
    assert found == {frozenset([name, "0" + name]) for name in both} and len(both) == 15


def test_a_clean_collection_has_no_doubts(shared_data):
    report = inspect_dataset(open_dataset(shared_data / "bandai_namco_1"))
    assert [file for file in report.files if file.verdict != "ok"] == []
