"""A person in the files of many programs is found with unit, way up and joints, whole or in part; animals are not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.inspection import inspect_recording
from core.mocap.units import UNITS
from tests.core.mocap.dialects import (
    DIALECTS,
    HEIGHT,
    bvh_of,
    joints_of,
    lifted_by_the_root,
    mirrored,
    motion_of,
    on_all_fours,
    text_of,
    without,
)

NAMED = [name for name in DIALECTS if name != "nameless"]
STRAIGHT = ["MotionBuilder", "Mixamo, read by Blender", "Xsens MVN", "DAZ and Poser", "SMPL", "Rigify", "Unreal"]
Z_UP = [name for name, dialect in DIALECTS.items() if dialect.up == "z"]


@pytest.fixture
def look(tmp_path):
    """Writes a BVH text and inspects it: report and facts."""

    def write(text: str):
        path = tmp_path / "clip.bvh"
        path.write_text(text, encoding="utf-8")
        return inspect_recording(path)

    return write


def said(report) -> set[str]:
    """The kinds of doubts, but for feet that slide: these feet are not planted."""
    return {finding.kind for finding in report.findings} - {"sliding"}


def expected(dialect) -> dict[str, str]:
    return {joint.part: joint.name for joint in joints_of(dialect) if joint.part}


@pytest.mark.parametrize("name", DIALECTS)
def test_unit_way_up_and_joints_of_a_walk(look, name):
    dialect = DIALECTS[name]
    report, facts = look(bvh_of(dialect))
    assert (facts.body, facts.up, facts.fps) == ("human", dialect.up, dialect.fps)
    assert said(report) <= {"displacements"}
    joints = {part: joint.rsplit(":", 1)[-1] for part, joint in facts.joints.items()}
    wrong = {
        part: joints.get(part) for part, joint in expected(dialect).items() if joints.get(part) != joint.split(":")[-1]
    }
    wrong.pop("spine" if "hip" in dialect.hang else "", None)  # legs that hang from the spine make it a hip
    assert not wrong
    if name != "MikuMikuDance":  # its unit of 8 cm is nobody else's; decimetres come next
        assert UNITS[facts.unit][0] == pytest.approx(dialect.metres)
        assert facts.height == pytest.approx(HEIGHT, abs=0.04)


@pytest.mark.parametrize("pose", ["sit", "crouch", "crawl"])
@pytest.mark.parametrize("name", [*Z_UP, "Xsens MVN", "LaFAN1"])
def test_who_does_not_stand_is_read_the_same_way_up(look, name, pose):
    dialect = DIALECTS[name]
    _, facts = look(bvh_of(dialect, pose=pose))
    assert (facts.up, facts.body) == (dialect.up, "human")
    assert UNITS[facts.unit][0] == pytest.approx(dialect.metres)


@pytest.mark.parametrize("speed", [1.2, 0.0])
@pytest.mark.parametrize("up", ["y", "z", "x", "-z", "-x"])
@pytest.mark.parametrize("name", ["MotionBuilder", "LaFAN1", "Rigify"])
def test_any_axis_may_point_up(look, name, up, speed):
    _, facts = look(bvh_of(replace(DIALECTS[name], up=up), speed=speed))
    assert facts.up == up


@pytest.mark.parametrize(("facing", "speed"), [(0, 1.2), (90, 1.2), (45, 0.0)])
@pytest.mark.parametrize("up", ["z", "x", "-z"])
@pytest.mark.parametrize("name", ["Xsens MVN", "LaFAN1"])
def test_the_motion_may_have_another_axis_up_than_the_rest_pose(look, name, up, facing, speed):
    dialect = DIALECTS[name]
    _, facts = look(text_of(dialect, *lifted_by_the_root(*motion_of(dialect, speed=speed), up, facing)))
    assert facts.up == up


def test_a_jump_from_a_rest_pose_along_x_is_no_floor_along_x(look):
    joints, path, turns = motion_of(DIALECTS["LaFAN1"])
    path = path + np.outer(0.5 * np.sin(np.linspace(0, np.pi, len(path))), [0, 1, 0])
    _, facts = look(text_of(DIALECTS["LaFAN1"], joints, path, turns))
    assert facts.up == "y"


@pytest.mark.parametrize("name", ["MotionBuilder", "Second Life", "SMPL", "OptiTrack", "MakeHuman"])
@pytest.mark.parametrize("height", [1.15, 1.4, 2.0])
def test_children_and_giants_are_read_in_the_unit_of_the_file(look, name, height):
    report, facts = look(bvh_of(DIALECTS[name], height=height))
    assert UNITS[facts.unit][0] == pytest.approx(DIALECTS[name].metres)
    assert facts.height == pytest.approx(height, abs=0.05)
    assert ("size" in said(report)) == (height < 1.2)


@pytest.mark.parametrize("name", NAMED)
def test_a_mirrored_export_is_told(look, name):
    report, facts = look(text_of(DIALECTS[name], *mirrored(*motion_of(DIALECTS[name]))))
    assert "sides" in said(report) and facts.up == DIALECTS[name].up


@pytest.mark.parametrize("name", ["MotionBuilder", "Biped of 3ds Max", "Unreal", "LaFAN1", "VRoid"])
def test_a_t_pose_in_front_is_found(look, name):
    report, _ = look(bvh_of(DIALECTS[name], lead=3))
    (found,) = (finding for finding in report.findings if finding.kind == "rest pose")
    assert (found.start, found.end) == (0, 3)


PARTS = {
    "no legs": ("hip", "knee", "ankle", "toe"),
    "no arms": ("clavicle", "shoulder", "elbow", "wrist"),
    "no hands": ("wrist",),
    "no feet": ("ankle", "toe"),
}


@pytest.mark.parametrize("what", PARTS)
@pytest.mark.parametrize("name", NAMED)
def test_parts_of_a_person_keep_what_their_names_say(look, name, what):
    dialect = without(DIALECTS[name], *PARTS[what])
    report, facts = look(bvh_of(dialect))
    assert facts.body == "partial" and any(what in message for message in report.messages)
    limbs = {part: joint for part, joint in facts.joints.items() if "_" in part}
    assert {part: joint for part, joint in expected(dialect).items() if part in limbs} == limbs


@pytest.mark.parametrize("name", STRAIGHT)
def test_what_stands_on_four_legs_is_no_person_whatever_its_names(look, name):
    report, facts = look(text_of(DIALECTS[name], *on_all_fours(*motion_of(DIALECTS[name]))))
    assert facts.body == "other" and "body" in said(report)


@pytest.mark.parametrize("prefix", ["Skeleton_003_", "hero:", "UE5_Manny_", "my rig "])
def test_a_word_that_all_names_begin_with_means_nothing(look, prefix):
    plain = DIALECTS["Unreal"]
    names = {part: prefix + name for part, name in plain.names.items()}
    _, facts = look(bvh_of(replace(plain, names=names, between={}, beside={}, above=())))
    assert facts.body == "human" and facts.joints["left_knee"].endswith("calf_l")
