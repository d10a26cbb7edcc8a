"""Anatomy: every rig's names, the shape of the tree where there are none, corrections, real skeletons."""

from __future__ import annotations

import numpy as np
import pytest

from core.mocap.anatomy import CANONICAL, find_anatomy
from core.mocap.anatomy_names import parse_name
from core.mocap.skeleton import Skeleton

# part, parent, offset in metres; facing +Z, so left is +X
TRUNK = [("pelvis", None, (0, 0, 0)), ("spine", "pelvis", (0, 0.12, 0)), ("chest", "spine", (0, 0.16, 0))]
HEAD = [("neck", "chest", (0, 0.22, 0)), ("head", "neck", (0, 0.1, 0)), ("head_end", "head", (0, 0.18, 0))]
LIMB = [
    ("clavicle", "chest", (0.03, 0.18, 0)),
    ("shoulder", "clavicle", (0.15, 0, 0)),
    ("elbow", "shoulder", (0.28, 0, 0)),
    ("wrist", "elbow", (0.26, 0, 0)),
    ("wrist_end", "wrist", (0.15, 0, 0)),
    ("hip", "pelvis", (0.09, -0.05, 0)),
    ("knee", "hip", (0, -0.42, 0)),
    ("ankle", "knee", (0, -0.41, 0)),
    ("toe", "ankle", (0, -0.06, 0.13)),
    ("toe_end", "toe", (0, 0, 0.06)),
]


def body(rename=lambda part: part, turn=0.0) -> Skeleton:
    """A person with the joint names ``rename`` gives, turned about the vertical by ``turn`` radians."""
    rows = list(TRUNK + HEAD)
    for side, x in (("left", 1), ("right", -1)):
        for part, parent, offset in LIMB:
            on_side = f"{side}_{parent}" if parent not in ("chest", "pelvis") else parent
            rows.append((f"{side}_{part}", on_side, (x * offset[0], *offset[1:])))
    index = {row[0]: k for k, row in enumerate(rows)}
    c, s = np.cos(turn), np.sin(turn)
    offsets = np.array([row[2] for row in rows]) @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    parents = tuple(-1 if row[1] is None else index[row[1]] for row in rows)
    ends = tuple(row[0].endswith("_end") for row in rows)
    return Skeleton(tuple(rename(row[0]) for row in rows), parents, offsets, ends)


def rig(trunk: dict, limb: dict, style: str):
    """A renaming: ``style`` holds {side} (left), {S} (L), {s} (l), {Side} (Left) and {part}."""

    def rename(part: str) -> str:
        end = "_end" if part.endswith("_end") else ""
        side, _, bare = part.removesuffix("_end").rpartition("_")
        if not side:
            return trunk.get(bare, bare) + end
        words = {"side": side, "Side": side.title(), "S": side[0].upper(), "s": side[0], "part": limb[bare]}
        return style.format(**words) + end

    return rename


PARTS = ("clavicle", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")


def parts(words: str) -> dict[str, str]:
    return dict(zip(PARTS, words.split(), strict=True))


RIGS = {
    "cmu-bvh": rig({}, parts("Shoulder Arm ForeArm Hand UpLeg Leg Foot ToeBase"), "{Side}{part}"),
    "mixamo": rig(
        {"pelvis": "mixamorig:Hips", "chest": "mixamorig:Spine2", "neck": "mixamorig:Neck", "head": "mixamorig:Head"},
        parts("Shoulder Arm ForeArm Hand UpLeg Leg Foot ToeBase"),
        "mixamorig:{Side}{part}",
    ),
    "cmu-asf": rig(
        {"pelvis": "root", "spine": "lowerback", "chest": "thorax", "neck": "lowerneck"},
        parts("clavicle humerus radius wrist femur tibia foot toes"),
        "{s}{part}",
    ),
    "bandai": rig({}, parts("Shoulder UpperArm LowerArm Hand UpperLeg LowerLeg Foot Toes"), "{part}_{S}"),
    "creator": rig(
        {"neck": "CC_Base_NeckTwist01", "head": "CC_Base_Head"},
        parts("Clavicle Upperarm Forearm Hand Thigh Calf Foot ToeBase"),
        "CC_Base_{S}_{part}",
    ),
    "smpl": rig({}, parts("Collar Shoulder Elbow Wrist Hip Knee Ankle Foot"), "m_avg_{S}_{part}"),
    "smpl-body": rig({}, parts("collar shoulder elbow wrist hip knee ankle foot"), "{side}_{part}"),
    "unreal": rig({}, parts("clavicle upperarm lowerarm hand thigh calf foot ball"), "{part}_{s}"),
    "blender": rig({}, parts("shoulder upper_arm forearm hand thigh shin foot toe"), "{part}.{S}"),
    "biped": rig({}, parts("Clavicle UpperArm Forearm Hand Thigh Calf Foot Toe0"), "Bip01 {S} {part}"),
    "capitals": rig({}, parts("COLLAR SHOULDER ELBOW WRIST HIP KNEE ANKLE TOE"), "{S}_{part}"),
}


@pytest.mark.parametrize("name", RIGS)
def test_every_rig_is_recognised_by_name(name: str) -> None:
    reference, skeleton = body(), body(RIGS[name])
    anatomy = find_anatomy(skeleton)
    assert anatomy.by_name
    assert dict(anatomy.joints) == {part: reference.index(part) for part in CANONICAL}


@pytest.mark.parametrize("turn", [0.0, 1.3, np.pi, -2.0])
def test_without_names_the_shape_tells_the_limbs_and_the_feet_tell_the_sides(turn: float) -> None:
    reference = body()
    anatomy = find_anatomy(body(lambda part: f"bone{reference.index(part)}", turn))
    assert not anatomy.by_name
    assert dict(anatomy.joints) == {part: reference.index(part) for part in CANONICAL}


def test_names_in_another_language_keep_their_sides() -> None:
    words = parts("Schluesselbein Oberarm Unterarm Handgelenk Oberschenkel Unterschenkel Sprunggelenk Zehe")
    # the right arm is built where left would be: only the marks in the names tell
    swap = {"left": "right", "right": "left"}
    rename = rig({}, words, "{part}_{S}")
    reference = body()
    skeleton = body(lambda part: rename("_".join(swap.get(w, w) for w in part.split("_"))))
    anatomy = find_anatomy(skeleton)
    assert anatomy.joints["left_knee"] == reference.index("right_knee")
    assert anatomy.joints["right_wrist"] == reference.index("left_wrist")


def test_posture_joints_leave_helpers_out() -> None:
    skeleton = body(RIGS["bandai"])
    extra = ("UpperArm_L_Twist", "Index_L", "Jaw")
    parents = (skeleton.index("UpperArm_L"), skeleton.index("Hand_L"), skeleton.index("head"))
    wider = Skeleton(
        skeleton.names + extra,
        skeleton.parents + parents,
        np.r_[skeleton.offsets, np.full((3, 3), 0.02)],
        skeleton.end_sites + (False,) * 3,
    )
    plain, anatomy = find_anatomy(skeleton), find_anatomy(wider)
    assert anatomy.posture_joints == plain.posture_joints
    assert dict(anatomy.joints) == dict(plain.joints)
    assert 0 not in plain.posture_joints
    assert not any(skeleton.end_sites[j] for j in plain.posture_joints)
    assert anatomy.side(wider.index("Index_L")) == "left"
    assert anatomy.side(wider.index("Jaw")) == "centre"


def test_sides_tips_and_height() -> None:
    skeleton = body()
    anatomy = find_anatomy(skeleton)
    assert [anatomy.side(skeleton.index(n)) for n in ("left_toe_end", "right_wrist", "neck")] == [
        "left",
        "right",
        "centre",
    ]
    assert anatomy.head_tip == skeleton.index("head_end")
    bones = 0.42 + 0.41 + 0.12 + 0.16 + 0.22 + 0.1 + 0.18
    assert anatomy.body_height == pytest.approx(bones / (1 - 0.039), rel=1e-6)
    double = Skeleton(skeleton.names, skeleton.parents, 2 * skeleton.offsets, skeleton.end_sites)
    assert find_anatomy(double).body_height == pytest.approx(2 * anatomy.body_height, rel=1e-6)


def test_kept_per_skeleton_and_corrected_by_hand() -> None:
    skeleton = body()
    assert find_anatomy(skeleton) is find_anatomy(body())
    corrected = find_anatomy(skeleton, {"left_toe": None, "neck": "head", "chest": 1})
    assert "left_toe" not in corrected.joints
    assert corrected.joints["neck"] == skeleton.index("head") and corrected.joints["chest"] == 1
    for bad in ({"left_tail": 3}, {"neck": "nowhere"}, {"neck": 99}):
        with pytest.raises(ValueError, match=r"no (part|joint)"):
            find_anatomy(skeleton, bad)


def test_no_body_is_no_crash() -> None:
    chain = Skeleton(("base", "a", "b", "c"), (-1, 0, 1, 2), np.array([[0, 0, 0], [0, 5, 0], [-5, 0, 0], [0, 3, 0]]))
    anatomy = find_anatomy(chain)
    assert dict(anatomy.joints) == {"pelvis": 0}
    assert anatomy.posture_joints == (1, 2, 3) and anatomy.feet == () and anatomy.body_height == pytest.approx(13)
    assert find_anatomy(Skeleton(("only",), (-1,), np.zeros((1, 3)))).posture_joints == ()


def test_parse_name() -> None:
    assert parse_name("mixamorig:LeftUpLeg") == ("left", "upleg")
    assert parse_name("LHipJoint") == ("left", "hipjoint")
    assert parse_name("lfemur") == ("left", "femur")
    assert parse_name("lowerback") == ("centre", "lowerback")
    assert parse_name("RightToeBase_end") == ("right", "toebaseend")
    assert parse_name("") == ("centre", "")


REAL = {
    "cmu/bvh/001_01.bvh": dict(
        spine="CC_Base_Waist", chest="CC_Base_Spine02", neck="CC_Base_NeckTwist01", head="CC_Base_Head",
        left_clavicle="CC_Base_L_Clavicle", left_shoulder="CC_Base_L_Upperarm", right_elbow="CC_Base_R_Forearm",
        right_wrist="CC_Base_R_Hand", left_hip="CC_Base_L_Thigh", right_knee="CC_Base_R_Calf",
        left_ankle="CC_Base_L_Foot", right_toe="CC_Base_R_ToeBase",
    ),
    "bandai_namco_1/dataset-1_bow_active_001.bvh": dict(
        spine="Spine", chest="Chest", neck="Neck", head="Head", left_clavicle="Shoulder_L", left_shoulder="UpperArm_L",
        left_wrist="Hand_L", right_hip="UpperLeg_R", right_knee="LowerLeg_R", right_ankle="Foot_R", left_toe="Toes_L",
    ),
    "fairmotion/01_01.bvh": dict(
        spine="LowerBack", chest="Spine1", neck="Neck", head="Head", left_clavicle="LeftShoulder",
        left_shoulder="LeftArm", left_elbow="LeftForeArm", left_wrist="LeftHand", left_hip="LeftUpLeg",
        left_knee="LeftLeg", left_ankle="LeftFoot", left_toe="LeftToeBase",
    ),
}  # fmt: skip


@pytest.mark.parametrize("file", REAL)
def test_real_bvh_skeletons(shared_data, file: str) -> None:
    bvh = pytest.importorskip("core.mocap.bvh")
    skeleton = bvh.read_bvh(shared_data / file).skeleton
    anatomy = find_anatomy(skeleton)
    assert anatomy.by_name
    assert {part: skeleton.names[anatomy.joints[part]] for part in REAL[file]} == REAL[file]
    assert 1.4 < anatomy.body_height < 2.0


@pytest.mark.parametrize("subject", ["01", "02", "13", "14", "86"])
def test_real_asf_skeletons(shared_data, subject: str) -> None:
    asfamc = pytest.importorskip("core.mocap.asfamc")
    found = sorted((shared_data / "cmu" / "asfamc" / subject).glob("*.asf"))
    if not found:
        pytest.skip(f"no skeleton of subject {subject} here")
    skeleton = asfamc.read_asf(found[0]).skeleton
    anatomy = find_anatomy(skeleton)
    want = dict(spine="lowerback", chest="thorax", neck="lowerneck", head="head", left_clavicle="lclavicle",
                left_shoulder="lhumerus", right_elbow="rradius", left_wrist="lwrist", left_hip="lfemur",
                right_knee="rtibia", left_ankle="lfoot", right_toe="rtoes")  # fmt: skip
    assert {part: skeleton.names[anatomy.joints[part]] for part in want} == want
    assert 1.5 < anatomy.body_height < 2.1


@pytest.mark.parametrize("file", REAL)
def test_real_skeletons_without_their_names(shared_data, file: str) -> None:
    """The tree's shape finds the same hips, knees, ankles, shoulders, elbows and wrists, up to the side."""
    bvh = pytest.importorskip("core.mocap.bvh")
    skeleton = bvh.read_bvh(shared_data / file).skeleton
    named = find_anatomy(skeleton).joints
    nameless = tuple(f"n{j}" for j in range(skeleton.n_joints))
    anatomy = find_anatomy(Skeleton(nameless, skeleton.parents, skeleton.offsets, skeleton.end_sites))
    for part in ("hip", "knee", "ankle", "shoulder", "elbow", "wrist"):
        pair = {f"left_{part}", f"right_{part}"}
        assert {anatomy.joints[p] for p in pair} == {named[p] for p in pair}, part
