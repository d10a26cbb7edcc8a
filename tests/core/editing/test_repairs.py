"""Repairs: what is offered for a finding helps against it, and everything else stays as it is."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core.editing.repairs import Repair, filled, repaired, repairs_for, smoothed, usual_repairs
from core.errors import ParameterError
from core.inspection import find_doubts
from core.mocap import quaternions as quat
from core.mocap.clip import Clip, Label
from core.mocap.kinematics import joint_positions
from core.mocap.reading import with_unit
from core.mocap.reports import Finding
from tests.core.mocap.odd_clips import in_other_axes, mirrored, walking

WALK = walking("walk", seconds=4.0)


def jumping(clip: Clip, start: int, end: int, by: float = 1.5) -> Clip:
    """The clip whose body stands elsewhere in frames ``[start, end)``."""
    roots = clip.root_positions.copy()
    roots[start:end, 0] += by
    return replace(clip, root_positions=roots)


def offered(clip: Clip) -> dict[str, tuple[Repair, ...]]:
    """The repairs of each kind of finding."""
    findings = find_doubts(clip).findings
    return {finding.kind: repairs_for(clip, finding, findings) for finding in findings}


def mended(clip: Clip) -> Clip:
    return repaired(clip, (), usual_repairs(clip, find_doubts(clip).findings))[0]


def kinds(clip: Clip) -> set[str]:
    return {finding.kind for finding in find_doubts(clip).findings}


def test_a_jump_and_the_jump_back_are_filled_in_between():
    odd = jumping(WALK, 40, 44)
    assert {repair.action for repair in offered(odd)["jump"]} == {"fill", "smooth", "cut"}
    (repair,) = usual_repairs(odd, find_doubts(odd).findings)
    assert (repair.action, repair.start, repair.end) == ("fill", 40, 44)
    new = mended(odd)
    assert "jump" in kinds(odd) and "jump" not in kinds(new)
    np.testing.assert_array_equal(new.root_positions[:40], WALK.root_positions[:40])
    np.testing.assert_allclose(new.root_positions, WALK.root_positions, atol=0.03)  # it walks evenly


def test_a_jump_to_another_place_is_smoothed_and_can_be_cut_off():
    odd = jumping(WALK, 50, WALK.n_frames)
    assert [repair.action for repair in offered(odd)["jump"]] == ["smooth", "cut"]
    new = mended(odd)
    assert "jump" not in kinds(new) and new.n_frames == odd.n_frames
    np.testing.assert_array_equal(new.root_positions[:24], odd.root_positions[:24])
    (short, _) = repaired(odd, (), offered(odd)["jump"][1:])
    assert short.n_frames == WALK.n_frames - 50 and "jump" not in kinds(short)


def test_a_flip_of_one_joint_is_smoothed_the_short_way():
    turns = WALK.rotations.copy()
    turns[60:, 0] *= -1  # the same rotations, told by the other sign
    odd = replace(WALK, rotations=turns)
    even = smoothed(odd, 59, 61)
    np.testing.assert_allclose(joint_positions(even), joint_positions(smoothed(WALK, 59, 61)), atol=1e-5)


def test_a_rest_pose_in_front_is_cut_off_and_labels_move_along():
    rest = np.zeros_like(WALK.rotations[:3])
    rest[..., 0] = 1
    roots = WALK.root_positions.copy()
    roots[:3] = [3.0, 1.0, 0]
    odd = replace(WALK, rotations=np.concatenate([rest, WALK.rotations[3:]]), root_positions=roots)
    labels = (Label("walk", 0, 10, "start"), Label("walk", 0, 3, "rest"), Label("other", 0, 5, "no"))
    new, moved = repaired(odd, labels, usual_repairs(odd, find_doubts(odd).findings))
    assert new.n_frames == WALK.n_frames - 3 and new.name == "walk"
    np.testing.assert_array_equal(new.rotations, WALK.rotations[3:])
    assert moved == (Label("walk", 0, 7, "start"),)
    assert kinds(new) == set()


def test_frames_that_the_reader_filled_are_cut_at_an_end_and_smoothed_inside():
    at_end, inside = Finding("filled", "held", WALK.n_frames - 5, WALK.n_frames), Finding("filled", "filled", 20, 30)
    odd = replace(WALK, findings=(at_end, inside))
    assert [repair.action for repair in repairs_for(odd, at_end)] == ["cut", "smooth"]
    assert [repair.action for repair in repairs_for(odd, inside)] == ["smooth"]
    new = mended(odd)
    assert new.n_frames == WALK.n_frames - 5 and new.findings == ()
    assert any("frames 20 to 29: smoothed by hand" in note for note in new.notes)


def test_a_body_that_lies_along_another_axis_is_turned():
    root = quat.from_rotvec(np.array([[np.pi / 2, 0, 0]]))
    lying = replace(WALK, root_positions=WALK.root_positions * [0, 0, 0], rotations=WALK.rotations.copy())
    lying.rotations[:, 0] = quat.multiply(root, WALK.rotations[:, 0].astype(float))
    (repair,) = offered(lying)["up"]
    assert (repair.action, repair.value) == ("turn", "z")
    new = mended(lying)
    assert new.up == "z" and "up" not in kinds(new)
    upside_down = in_other_axes(WALK, np.array([0.0, 0, 0, 1.0]))
    assert [repair.value for repair in offered(upside_down)["up"]] == ["-y"]
    assert "up" not in kinds(mended(upside_down))


def test_sizes_that_few_people_have_are_scaled_to_what_one_chooses():
    odd = with_unit(WALK, WALK.skeleton.unit * 2.54)
    by_words = {repair.words: repair for repair in offered(odd)["size"]}
    assert usual_repairs(odd, find_doubts(odd).findings) == []  # which unit is meant is not for a program to say
    new, _ = repaired(odd, (), [by_words["Make it 1.7 m tall"]])
    assert "size" not in kinds(new)
    assert find_doubts(new).findings == find_doubts(WALK).findings


def test_a_mirrored_export_is_mirrored_back():
    odd = mirrored(WALK)
    new = mended(odd)
    assert "sides" in kinds(odd) and "sides" not in kinds(new)
    np.testing.assert_allclose(joint_positions(new), joint_positions(WALK), atol=1e-5)


@pytest.mark.parametrize(
    ("repair", "why"),
    [
        (Repair("melt"), "no repair 'melt'"),
        (Repair("fill", 0, 500), "cannot be repaired"),
        (Repair("fill", 0, WALK.n_frames), "no other frames"),
        (Repair("cut", 5, 10), "Only frames at an end"),
        (Repair("cut", 0, WALK.n_frames), "not all"),
        (Repair("turn", value="up"), "expected y"),
    ],
)
def test_what_cannot_be_repaired_is_refused(repair, why):
    with pytest.raises(ParameterError, match=why):
        repaired(WALK, (), [repair])


def test_filling_at_an_end_holds_the_nearest_frame():
    new = filled(WALK, 0, 4)
    np.testing.assert_array_equal(new.root_positions[:4], np.repeat(WALK.root_positions[4:5], 4, axis=0))
