"""Way up, unit, rate and bodies: found out where files do not say them, said by someone, and changed afterwards."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from core.errors import FormatError, MotionscapeError, ParameterError
from core.inspection import facts_of, find_doubts, inspect_recording
from core.mocap.anatomy import find_anatomy
from core.mocap.bvh import write_bvh
from core.mocap.corrections import corrections_of, from_json, read_corrections, to_json
from core.mocap.dataset import Reading, open_dataset, reading
from core.mocap.kinematics import joint_positions
from core.mocap.reading import Change, read_again
from core.mocap.units import UNITS
from core.mocap.upright import find_up, turned
from tests.core.mocap import samples
from tests.core.mocap.odd_clips import dog, in_other_axes, mirrored, spider, walking, without, written
from tests.core.mocap.test_anatomy import body, rig

HALF = np.sqrt(0.5)
FROM_Y = {  # turns Y to the axis: what a file with that axis up holds
    "z": np.array([HALF, HALF, 0, 0]),
    "-z": np.array([HALF, -HALF, 0, 0]),
    "x": np.array([HALF, 0, 0, -HALF]),
    "-x": np.array([HALF, 0, 0, HALF]),
    "-y": np.array([0.0, 1, 0, 0]),
}


@pytest.mark.parametrize("up", FROM_Y)
def test_a_file_with_another_axis_up_is_turned_and_says_so(tmp_path, up):
    clip = walking()
    written(tmp_path, clip, replace(in_other_axes(clip, FROM_Y[up]), name="other"))
    plain, other = open_dataset(tmp_path).clip("walk"), open_dataset(tmp_path).clip("other")
    assert (plain.up, other.up) == ("y", up)
    assert any(f"{up.upper()} points up" in note for note in other.notes) and not other.findings
    np.testing.assert_allclose(joint_positions(other), joint_positions(plain), atol=2e-4)


def test_a_root_that_is_turned_as_a_whole_is_seen_where_it_travels(tmp_path):
    """The rest pose has Y up, the motion Z: an exporter that turns the root only."""
    clip, turn = walking(), FROM_Y["z"]
    rotations = clip.rotations.copy()
    from core.mocap import quaternions as quat

    rotations[:, 0] = quat.multiply(turn[None], rotations[:, 0].astype(float))
    root = quat.rotate(turn[None], clip.root_positions.astype(float)).astype(np.float32)
    away = replace(clip, root_positions=root, rotations=rotations)
    assert find_up(away) == "z"
    on_the_spot = replace(away, root_positions=np.repeat(root[:1], len(root), 0))
    assert find_up(on_the_spot) == "z"  # its feet are at 0, and half of it would be below a floor
    still = replace(away, root_positions=np.repeat([[0, 0.12, 0]], len(root), 0).astype(np.float32))
    assert find_up(still) == "y"  # a person who lies on the floor all the time
    assert "up" in [finding.kind for finding in find_doubts(still).findings]


def test_animals_and_short_stays_on_the_floor_are_left_as_they_are():
    assert find_up(spider()) == find_up(dog()) == "y"
    lying = walking()
    rotations = lying.rotations.copy()
    rotations[:30, 0] = FROM_Y["z"]
    assert find_up(replace(lying, rotations=rotations)) == "y"


def test_the_way_up_can_be_said_and_changed_back(tmp_path):
    clip = walking()
    written(tmp_path, clip)
    said = open_dataset(tmp_path, up="z").clips[0]
    assert said.up == "z" and "as was said" in said.notes[-1]
    back = read_again(said, Change(Reading(up="y")))
    np.testing.assert_allclose(joint_positions(back), joint_positions(open_dataset(tmp_path).clips[0]), atol=1e-5)
    assert not any("points up" in note for note in back.notes)
    assert read_again(said, Change(guess_up=True)).up == "y"
    for up in FROM_Y:
        np.testing.assert_allclose(turned(turned(clip, up), "y").rotations[:, 0], clip.rotations[:, 0], atol=1e-6)


@pytest.mark.parametrize("unit", ["m", "dm", "cm", "mm", "in", "cmu"])
@pytest.mark.parametrize("height", [0.9, 1.0])  # of 1.8 m: a small and a tall grown person
def test_the_unit_is_the_one_that_makes_a_person(tmp_path, unit, height):
    clip = walking(scale=height)
    file = replace(clip, skeleton=replace(clip.skeleton, unit=UNITS[unit][0]))
    written(tmp_path, file)
    report, facts = inspect_recording(tmp_path / "walk.bvh")
    assert facts.unit == unit and facts.height == pytest.approx(find_anatomy(clip.skeleton).body_height, rel=1e-3)
    assert report.verdict == "ok"


@pytest.mark.parametrize("scale", [0.5, 1.5])
def test_a_person_of_a_height_that_nobody_has_is_a_doubt_that_names_the_other_units(tmp_path, scale):
    written(tmp_path, walking(scale=scale))
    report, _ = inspect_recording(tmp_path / "walk.bvh", how=reading(unit="cm"))
    (doubt,) = (finding for finding in report.findings if finding.kind == "size")
    assert "check the unit" in doubt.message and "m tall in centimetres" in doubt.message


def test_the_unit_can_be_said_and_changed(tmp_path):
    written(tmp_path, walking())
    plain, said = open_dataset(tmp_path).clips[0], open_dataset(tmp_path, unit="in").clips[0]
    np.testing.assert_allclose(joint_positions(said), 2.54 * joint_positions(plain), rtol=1e-5, atol=1e-6)
    assert said.skeleton.unit == 0.0254 and any("inches" in note for note in said.notes)
    changed = read_again(said, Change(Reading(unit=0.01)))
    np.testing.assert_allclose(joint_positions(changed), joint_positions(plain), rtol=1e-5, atol=1e-6)
    guessed = read_again(said, Change(guess_unit=True))
    assert guessed.skeleton.unit == pytest.approx(0.01) and guessed.notes == plain.notes
    assert read_again(plain, Change(Reading(fps=50.0))).fps == 50
    assert open_dataset(tmp_path, fps=24).clips[0].fps == 24


@pytest.mark.parametrize("said", [{"unit": "stone"}, {"unit": "-1"}, {"up": "w"}, {"fps": -1.0}, {"unit": 0.0}])
def test_what_cannot_be_said(said):
    with pytest.raises(ParameterError):
        reading(**said)


PARTS = {
    "upper body": (("LeftUpLeg", "RightUpLeg"), ("legs",)),
    "lower body": (("Spine",), ("head", "arms")),
    "no hands": (("LeftHand", "RightHand"), ("hands",)),
    "one arm": (("LeftShoulder",), ("left arm",)),
    "one leg and one foot": (("LeftUpLeg", "RightFoot"), ("left leg", "right foot")),
}


@pytest.mark.parametrize("what", PARTS)
def test_partial_bodies_keep_what_their_names_say(what):
    tops, missing = PARTS[what]
    whole, part = walking(), without(walking(), *tops)
    anatomy = find_anatomy(part.skeleton)
    assert anatomy.body == "partial" and anatomy.missing == missing
    names = find_anatomy(whole.skeleton).joints
    for name, joint in anatomy.joints.items():
        assert part.skeleton.names[joint] == whole.skeleton.names[names[name]], name
    assert len(set(anatomy.joints.values())) == len(anatomy.joints)
    finding = next(finding for finding in find_doubts(part).findings if finding.kind == "body")
    assert all(f"no {one}" in finding.message for one in missing)


def test_arms_never_become_legs_where_nothing_has_a_name():
    upper = without(walking(), "LeftUpLeg", "RightUpLeg").skeleton
    nameless = replace(upper, names=tuple(f"bone{k}" for k in range(upper.n_joints)))
    assert find_anatomy(nameless).body == "other" and list(find_anatomy(nameless).joints) == ["pelvis"]


@pytest.mark.parametrize("make", [spider, dog])
def test_what_is_no_human_says_so(make):
    clip = make()
    assert find_anatomy(clip.skeleton).body == facts_of(clip).body == "other"
    assert "no human body" in find_doubts(clip).doubts[0]
    nameless = replace(clip.skeleton, names=tuple(f"bone{k}" for k in range(clip.skeleton.n_joints)))
    assert find_anatomy(nameless).body == "other"


def test_people_of_any_rig_are_people():
    for rename in (lambda part: part, rig({}, {p: p for p in PARTS_OF_A_LIMB}, "{part}_{S}")):
        assert find_anatomy(body(rename)).body == "human"
    assert find_anatomy(body(lambda part: f"b{body().index(part)}")).body == "human"
    nameless = body(lambda part: f"{part[0]}{len(part)}{part[-1]}{body().index(part)}")
    assert find_anatomy(nameless).body == "human"


PARTS_OF_A_LIMB = ("clavicle", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")


def test_a_mirrored_export_is_a_doubt():
    assert not find_doubts(walking()).findings
    swapped = [finding for finding in find_doubts(mirrored(walking())).findings if finding.kind == "sides"]
    assert swapped and "left and right seem swapped" in swapped[0].message


def test_corrections_are_kept_with_the_skeleton_and_leave_as_json(tmp_path):
    clip = without(walking(), "LeftHand")
    skeleton = clip.skeleton
    assert find_anatomy(skeleton).missing == ("left hand",)
    document = to_json(corrections_of([skeleton]))
    (tmp_path / "body.json").write_text(json.dumps(document))
    assert corrections_of([read_corrections(tmp_path / "body.json").applied(skeleton)]) == corrections_of([skeleton])
    arm = {"left_wrist": "LeftForeArm", "left_elbow": "LeftArm", "left_shoulder": "LeftShoulder", "left_clavicle": None}
    flat = from_json(arm)
    corrected = flat.applied(skeleton)
    anatomy = find_anatomy(corrected)
    assert anatomy.body == "human" and corrected.names[anatomy.joints["left_wrist"]] == "LeftForeArm"
    assert corrected != skeleton and corrected.fingerprint != skeleton.fingerprint
    assert type(corrected).from_json(json.loads(json.dumps(corrected.to_json()))) == corrected
    assert flat.applied(spider().skeleton).corrections == ()
    kind = from_json({"rigs": [{"rig": list(skeleton.names), "body": "other", "joints": {}}]}).applied(skeleton)
    assert find_anatomy(kind).body == "other"
    twice = from_json({"left_wrist": "LeftForeArm"})
    with pytest.raises(ParameterError, match="cannot both be 'LeftForeArm'"):
        twice.applied(skeleton)


@pytest.mark.parametrize(
    "document",
    [
        *([], {"left_paw": "a"}, {"left_hip": 3}, {"rigs": 1}, {"rigs": [{"joints": []}]}, {"format": "x", "rigs": []}),
        *({"joints": {}, "body": "dog"}, {"rig": ["a"], "joints": {"head": "b"}}, {"rig": 4, "joints": {}}),
    ],
)
def test_bad_corrections_are_named(document):
    with pytest.raises(FormatError):
        from_json(document)


def test_a_correction_that_does_not_fit_is_a_files_error(tmp_path):
    written(tmp_path, walking())
    with pytest.raises(MotionscapeError, match=r"walk\.bvh: .*cannot both be"):
        open_dataset(tmp_path, body=from_json({"left_wrist": "LeftForeArm"}))


def test_a_workspace_changes_how_clips_are_read_without_their_files(tmp_path):
    from core.workspace import Workspace, WorkspaceError

    clips = [walking(), replace(samples.idling("idle"), name="idle"), dog()]
    folder = written(tmp_path / "files", *clips)
    workspace = Workspace(tmp_path / "space")
    workspace.import_dataset("a", folder, up="y")
    for path in folder.iterdir():
        path.unlink()
    before = workspace.open("a")
    token = workspace.version("a")
    report = workspace.change_reading("a", Change(Reading(unit=0.0254, up="z", fps=25.0)), ["walk"])
    after = workspace.open("a")
    walk = after.clip("walk")
    assert (walk.skeleton.unit, walk.up, walk.fps) == (0.0254, "z", 25)
    assert {f.kind for file in report.files if file.clip == "walk" for f in file.findings} >= {"size"}
    assert after.clip("idle").fps == before.clip("idle").fps and after.fingerprint != before.fingerprint
    workspace.change_reading("a", Change(Reading(body=from_json({"left_toe": None, "right_toe": None}))), ["walk"])
    toes = ["left_toe" in find_anatomy(clip.skeleton).joints for clip in workspace.open("a").clips]
    assert toes == [False, False, False]  # one correction for all clips of the rig; the dog has none
    written(folder, replace(walking(), name="more"))
    workspace.add_files("a", folder)
    assert "left_toe" not in find_anatomy(workspace.open("a").clip("more").skeleton).joints
    with pytest.raises(WorkspaceError, match="Nothing changes"):
        workspace.change_reading("a", Change(Reading(fps=25.0)), ["walk"])
    with pytest.raises(WorkspaceError, match="no clip 'x'"):
        workspace.change_reading("a", Change(Reading(fps=25.0)), ["x"])
    assert workspace.last_version("a") != token


def test_the_job_that_changes_how_clips_are_read(tmp_path):
    from core import analyses
    from core.requests import reread_request
    from core.workspace import Workspace

    workspace = Workspace(tmp_path / "space")
    workspace.import_dataset("a", written(tmp_path / "files", walking()))
    analyses.run(workspace, reread_request("a", clips='["walk"]', up="z", body='{"left_toe": null}'))
    clip = workspace.open("a").clips[0]
    assert clip.up == "z" and "left_toe" not in find_anatomy(clip.skeleton).joints
    write_bvh(tmp_path / "back.bvh", clip)
    assert [rig.rig for rig in workspace.bodies("a").rigs] == [clip.skeleton.names]
