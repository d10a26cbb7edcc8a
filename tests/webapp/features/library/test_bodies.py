"""The body editor's pure parts: rigs, drawings, drafts and files of corrections."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from core.errors import FormatError, ParameterError
from core.mocap.anatomy import find_anatomy
from core.mocap.corrections import BodyCorrections, corrections_of, to_json
from core.mocap.dataset import Dataset
from core.mocap.reports import ImportReport
from tests.core.mocap.odd_clips import dog
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.features.library import bodies, names


@pytest.fixture(scope="module")
def rigs():
    renamed = walk("c", 1.0)
    other = replace(renamed.skeleton, names=tuple(f"joint_{name}" for name in renamed.skeleton.names))
    clips = (replace(renamed, skeleton=other), walk("a", 1.0), walk("b", 2.0))
    return bodies.edited_rigs(Dataset("d", clips, (), ImportReport()))


def test_clips_of_equal_names_are_one_rig(rigs):
    assert [[clip.name for clip in rig.clips] for rig in rigs] == [["a", "b"], ["c"]]
    entries = [bodies.rig_entry(rig) for rig in rigs]
    shown = {"dataset": "d", "parts": ["pelvis"], "format": "x", "rigs": entries, "at": None}
    assert misfit(shown, names.BODY_RIGS) is None
    assert entries[0]["joints"]["pelvis"] == rigs[0].skeleton.names[0] and "2 clips" in entries[0]["words"]


@pytest.mark.parametrize("frame", [bodies.REST, 0, 10**6])
def test_a_posture_fits_its_drawings_and_shows_left_on_the_right(rigs, frame):
    drawn = bodies.posture(rigs[0].clips[1], frame)
    assert misfit({"rig": 0, "clip": "b", "frame": frame, **drawn}, names.BODY_POSTURE) is None
    views = np.array([drawn["front"], drawn["side"]])
    assert views.shape == (2, rigs[0].skeleton.n_joints, 2)
    assert (views >= 0).all() and (views[..., 0] <= bodies.WIDTH).all() and (views[..., 1] <= bodies.HEIGHT).all()
    joints = {part: rigs[0].skeleton.index(name) for part, name in bodies.rig_entry(rigs[0])["joints"].items()}
    assert views[0, joints["left_hip"], 0] > views[0, joints["right_hip"], 0]
    assert views[0, joints["head"], 1] < views[0, joints["left_ankle"], 1]  # y points down


def test_frames_of_any_clip_are_shown(rigs):
    assert [bodies.clip_of(rigs[0], name).name for name in ("b", None, "gone")] == ["b", "a", "a"]
    assert bodies.posture(rigs[0].clips[0], 5) != bodies.posture(rigs[0].clips[1], 40)


def test_animals_begin_with_suggestions_that_make_no_person_of_them():
    clip = dog()
    (rig,) = bodies.edited_rigs(Dataset("d", (clip,)))
    entry = bodies.rig_entry(rig)
    suggested = entry["suggested"]
    assert entry["body"] == "other" and list(entry["joints"]) == ["pelvis"]
    assert (suggested["left_hip"], suggested["right_elbow"]) == ("LeftUpLeg", "RightForeArm")
    assert suggested["head"] == "Head"
    (correction,) = bodies.drafted([rig], [{"changed": True, "joints": suggested, "body": None}]).rigs
    anatomy = find_anatomy(BodyCorrections((correction,)).applied(clip.skeleton))
    assert anatomy.body == "other" and anatomy.joints["left_hip"] == clip.skeleton.index("LeftUpLeg")
    assert anatomy.posture_joints == find_anatomy(clip.skeleton).posture_joints
    assert bodies.suggestions(walk("a", 1.0).skeleton) == {}


def test_only_what_was_changed_is_saved_and_must_fit(rigs):
    joints = bodies.rig_entry(rigs[0])["joints"]
    untouched = {"changed": False, "joints": {}, "body": None}
    draft = [{"changed": True, "joints": {"neck": None}, "body": None}, untouched]
    (correction,) = bodies.drafted(rigs, draft).rigs
    assert correction.rig == rigs[0].skeleton.names and correction.joints == (("neck", None),)
    twice = {"changed": True, "joints": {"left_wrist": joints["right_wrist"]}, "body": None}
    with pytest.raises(ParameterError, match="cannot both be"):
        bodies.drafted(rigs, [twice, untouched])


def test_a_file_says_something_of_the_rigs_it_fits(rigs):
    text = json.dumps(to_json(corrections_of([rigs[1].skeleton])))
    first, second = bodies.fitting(rigs, text)
    assert first is None and second["joints"]["pelvis"] == rigs[1].skeleton.names[0]
    assert misfit({"rigs": [first, second], "at": 1.0}, names.BODY_FILLED) is None
    for bad in ("{", '{"tail": "x"}', '{"neck": "nowhere"}'):
        with pytest.raises(FormatError):
            bodies.fitting(rigs, bad)
