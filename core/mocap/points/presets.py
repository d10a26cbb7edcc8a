"""Lists of points that common trackers and datasets write, and what each point is.

A preset names its points in the order of the source, and gives each part of the body (core.mocap.points.roles) the
point that it is, or the mean of several ("left_hip+right_hip").
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

SIDES = ("left", "right")


@dataclass(frozen=True)
class Preset:
    """A list of points. title: for people; points: names in the order of the source; parts: role -> its points.

    fps: frames per second where the source always has one rate; unit: metres per unit where it always is the same.
    """

    title: str
    points: tuple[str, ...]
    parts: Mapping[str, tuple[str, ...]]
    fps: float | None = None
    unit: float | None = None


def _preset(title: str, points: str, parts: str, fps: float | None = None, unit: float | None = None) -> Preset:
    """From words: points divided by blanks; parts as ``role=point`` or ``role=point+point``."""
    pairs = (word.split("=") for word in parts.split())
    return Preset(title, tuple(points.split()), {role: tuple(sources.split("+")) for role, sources in pairs}, fps, unit)


def _both(text: str, left: str = "left", right: str = "right") -> str:
    """The text for either side: ``{side}`` is a role's side, ``{s}`` what the source calls it."""
    pairs = zip(SIDES, (left, right), strict=True)
    return " ".join(text.format(side=side, s=source) for side, source in pairs)


_SMPL_POINTS = (
    "pelvis left_hip right_hip spine1 left_knee right_knee spine2 left_ankle right_ankle spine3 left_foot right_foot "
    "neck left_collar right_collar head left_shoulder right_shoulder left_elbow right_elbow left_wrist right_wrist"
)
_SMPL_PARTS = "pelvis=pelvis spine=spine1 spine2=spine2 chest=spine3 neck=neck head=head " + _both(
    "{side}_hip={s}_hip {side}_knee={s}_knee {side}_ankle={s}_ankle {side}_toe={s}_foot {side}_clavicle={s}_collar "
    "{side}_shoulder={s}_shoulder {side}_elbow={s}_elbow {side}_wrist={s}_wrist"
)
_COCO_FACE = "nose left_eye right_eye left_ear right_ear"
_COCO_BODY = (
    "left_shoulder right_shoulder left_elbow right_elbow left_wrist right_wrist left_hip right_hip left_knee "
    "right_knee left_ankle right_ankle"
)
_LIMBS = _both(
    "{side}_hip={s}_hip {side}_knee={s}_knee {side}_ankle={s}_ankle "
    "{side}_shoulder={s}_shoulder {side}_elbow={s}_elbow {side}_wrist={s}_wrist"
)
_MIDDLES = "pelvis=left_hip+right_hip chest=left_shoulder+right_shoulder"
_FACE = "nose=nose " + _both("{side}_eye={s}_eye {side}_ear={s}_ear")
_KINECT_LIMBS = _both(
    "{side}_hip=Hip{s} {side}_knee=Knee{s} {side}_ankle=Ankle{s} {side}_toe=Foot{s} "
    "{side}_shoulder=Shoulder{s} {side}_elbow=Elbow{s} {side}_wrist=Wrist{s} {side}_hand=Hand{s}",
    "Left",
    "Right",
)


def _kinect_points(limb: str) -> str:
    return " ".join(part + side for side in ("Left", "Right") for part in limb.split())


PRESETS: dict[str, Preset] = {
    "kinect1": _preset(
        "Kinect v1 (20 joints, as in UTKinect)",
        "HipCenter Spine ShoulderCenter Head "
        + _kinect_points("Shoulder Elbow Wrist Hand")
        + " "
        + _kinect_points("Hip Knee Ankle Foot"),
        f"pelvis=HipCenter spine=Spine chest=ShoulderCenter head=Head {_KINECT_LIMBS}",
    ),
    "kinect2": _preset(
        "Kinect v2 (25 joints)",
        "SpineBase SpineMid Neck Head "
        + _kinect_points("Shoulder Elbow Wrist Hand")
        + " "
        + _kinect_points("Hip Knee Ankle Foot")
        + " SpineShoulder HandTipLeft ThumbLeft HandTipRight ThumbRight",
        f"pelvis=SpineBase spine=SpineMid chest=SpineShoulder neck=Neck head=Head {_KINECT_LIMBS} "
        + _both("{side}_hand_tip=HandTip{s} {side}_thumb=Thumb{s}", "Left", "Right"),
    ),
    "mediapipe": _preset(
        "MediaPipe Pose (33 landmarks)",
        "nose left_eye_inner left_eye left_eye_outer right_eye_inner right_eye right_eye_outer left_ear right_ear "
        "mouth_left mouth_right left_shoulder right_shoulder left_elbow right_elbow left_wrist right_wrist left_pinky "
        "right_pinky left_index right_index left_thumb right_thumb left_hip right_hip left_knee right_knee left_ankle "
        "right_ankle left_heel right_heel left_foot_index right_foot_index",
        f"{_MIDDLES} head=left_ear+right_ear {_LIMBS} {_FACE} "
        + _both(
            "{side}_heel={s}_heel {side}_toe={s}_foot_index {side}_index={s}_index {side}_pinky={s}_pinky "
            "{side}_thumb={s}_thumb"
        ),
    ),
    "body25": _preset(
        "OpenPose BODY_25",
        "Nose Neck RShoulder RElbow RWrist LShoulder LElbow LWrist MidHip RHip RKnee RAnkle LHip LKnee LAnkle REye "
        "LEye REar LEar LBigToe LSmallToe LHeel RBigToe RSmallToe RHeel",
        "pelvis=MidHip chest=Neck head=REar+LEar nose=Nose "
        + _both(
            "{side}_hip={s}Hip {side}_knee={s}Knee {side}_ankle={s}Ankle {side}_shoulder={s}Shoulder "
            "{side}_elbow={s}Elbow {side}_wrist={s}Wrist {side}_eye={s}Eye {side}_ear={s}Ear {side}_toe={s}BigToe "
            "{side}_small_toe={s}SmallToe {side}_heel={s}Heel",
            "L",
            "R",
        ),
    ),
    "coco": _preset(
        "COCO (17 key points)", f"{_COCO_FACE} {_COCO_BODY}", f"{_MIDDLES} head=left_ear+right_ear {_LIMBS} {_FACE}"
    ),
    "h36m": _preset(
        "Human3.6M (17 joints)",
        "Hip RHip RKnee RFoot LHip LKnee LFoot Spine Thorax Nose Head LShoulder LElbow LWrist RShoulder RElbow RWrist",
        "pelvis=Hip spine=Spine chest=Thorax head=Nose head_top=Head "
        + _both(
            "{side}_hip={s}Hip {side}_knee={s}Knee {side}_ankle={s}Foot {side}_shoulder={s}Shoulder "
            "{side}_elbow={s}Elbow {side}_wrist={s}Wrist",
            "L",
            "R",
        ),
    ),
    "smpl22": _preset("SMPL body (22 joints, as in HumanML3D)", _SMPL_POINTS, _SMPL_PARTS, 20.0, 1.0),
    "smpl24": _preset(
        "SMPL (24 joints)",
        f"{_SMPL_POINTS} left_hand right_hand",
        f"{_SMPL_PARTS} left_hand=left_hand right_hand=right_hand",
    ),
}
"""Every preset by the name that ``--points`` takes."""
