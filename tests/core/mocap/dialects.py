"""A walking person as the BVH files of many programs have it: their names, axes, units, channels and extra joints."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

# canonical joint -> parent, and where it is from there at rest, in metres, of a person of about 1.7 m; left side only
BODY: dict[str, tuple[str | None, tuple[float, float, float]]] = {
    "pelvis": (None, (0, 0, 0)),
    "spine": ("pelvis", (0, 0.11, 0)),
    "chest": ("spine", (0, 0.26, 0)),
    "neck": ("chest", (0, 0.13, 0)),
    "head": ("neck", (0, 0.11, 0.02)),
    "clavicle": ("chest", (0.04, 0.08, 0)),
    "shoulder": ("clavicle", (0.14, 0, 0)),
    "elbow": ("shoulder", (0.28, 0, 0)),
    "wrist": ("elbow", (0.26, 0, 0)),
    "hip": ("pelvis", (0.09, -0.04, 0)),
    "knee": ("hip", (0, -0.41, 0.01)),
    "ankle": ("knee", (0, -0.41, -0.02)),
    "toe": ("ankle", (0, -0.07, 0.14)),
}
TIPS = {"head": (0, 0.18, 0), "wrist": (0.17, 0, 0), "toe": (0, 0, 0.07)}
HEIGHT = 1.70  # of this body, metres, within two centimetres
TO_UP = {"y": np.eye(3), "z": Rotation.from_euler("x", 90, degrees=True).as_matrix()}
TO_UP["x"] = Rotation.from_euler("z", -90, degrees=True).as_matrix()
TO_UP["-z"], TO_UP["-x"] = TO_UP["z"].T, TO_UP["x"].T


@dataclass(frozen=True)
class Dialect:
    """How a program writes a person.

    names: canonical part (of BODY) -> name, ``{s}`` for the side; parts left out have no joint, their bone goes to the
    next. sides: the words for left and right. between: names of joints on the way to a part, at even distances.
    beside: names of joints that hang from a part (fingers, twists). hang: part -> another parent. metres: per unit.
    """

    names: dict[str, str]
    sides: tuple[str, str] = ("Left", "Right")
    between: dict[str, tuple[str, ...]] = field(default_factory=dict)
    beside: dict[str, tuple[str, ...]] = field(default_factory=dict)
    hang: dict[str, str] = field(default_factory=dict)
    above: tuple[str, ...] = ()
    metres: float = 0.01
    up: str = "y"
    order: str = "ZXY"
    six: bool = False
    displaced: bool = False
    rest: str = "t"
    fps: float = 30.0


@dataclass
class _Joint:
    name: str
    parent: int
    offset: np.ndarray
    part: str = ""
    tip: np.ndarray | None = None


def joints_of(dialect: Dialect, height: float = HEIGHT) -> list[_Joint]:
    """The joints, parents first, with offsets in metres and Y up, the arms stretched sideways."""
    scale = height / HEIGHT
    joints = [_Joint(name, k - 1, np.zeros(3)) for k, name in enumerate(dialect.above)]
    index: dict[str, int] = {}

    def add(name: str, parent: int, offset: np.ndarray, part: str = "") -> int:
        joints.append(_Joint(name, parent, offset, part))
        return len(joints) - 1

    def put(part: str, key: str, side: int) -> None:
        flip = np.array([-1.0 if side else 1.0, 1, 1])
        up, offset = BODY[part][0], np.zeros(3)
        offset += np.array(BODY[part][1]) * flip * scale
        while up is not None and up not in dialect.names:
            offset += np.array(BODY[up][1]) * (flip if up in _LIMBS else 1) * scale
            up = BODY[up][0]
        up = dialect.hang[part] if dialect.hang.get(part) in dialect.names else up
        parent = len(dialect.above) - 1 if up is None else index[up if up not in _LIMBS else f"{up}{side}"]
        steps = dialect.between.get(part, ())
        word = dialect.sides[side]
        for name in steps:
            parent = add(name.format(s=word), parent, offset / (len(steps) + 1))
        canonical = part if part not in _LIMBS else f"{('left', 'right')[side]}_{part}"
        index[key] = add(dialect.names[part].format(s=word), parent, offset / (len(steps) + 1), canonical)
        if part in TIPS:
            joints[index[key]].tip = np.array(TIPS[part]) * flip * scale
        for k, name in enumerate(dialect.beside.get(part, ())):
            add(name.format(s=word), index[key], np.array([0.02, 0.01 * k, 0.02]) * flip * scale)

    for part in BODY:
        if part in dialect.names and part not in _LIMBS:
            put(part, part, 0)
    for side in (0, 1):
        for part in BODY:
            if part in dialect.names and part in _LIMBS:
                put(part, f"{part}{side}", side)
    return _depth_first(joints)


_LIMBS = ("clavicle", "shoulder", "elbow", "wrist", "hip", "knee", "ankle", "toe")


def _depth_first(joints: list[_Joint]) -> list[_Joint]:
    order: list[int] = []

    def visit(j: int) -> None:
        order.append(j)
        for k, joint in enumerate(joints):
            if joint.parent == j:
                visit(k)

    visit(0)
    place = {j: k for k, j in enumerate(order)}
    for joint in joints:
        joint.parent = place.get(joint.parent, -1)
    return [joints[j] for j in order]


def walking_turns(joints: list[_Joint], seconds: float, fps: float, pose: str = "walk") -> np.ndarray:
    """World-aligned local rotations ``(n_frames, n_joints, 3, 3)`` of a walk (or of another pose that sways)."""
    n = max(int(seconds * fps), 1)
    t = np.arange(n) / fps
    turns = np.tile(np.eye(3), (n, len(joints), 1, 1))
    swing = np.sin(2 * np.pi * t)
    for j, joint in enumerate(joints):
        side = joint.part.split("_")[0]
        sign = 1.0 if side == "left" else -1.0
        kind = joint.part.split("_")[-1]
        x = {"hip": -0.15 - 0.45 * sign * swing, "knee": 0.3 + 0.3 * np.cos(2 * np.pi * t + sign)}.get(kind, 0 * t)
        if pose == "sit":
            x = {"hip": -1.5 + 0.05 * swing, "knee": 1.5 + 0.05 * swing}.get(kind, 0 * t)
        if pose == "crouch":
            x = {"hip": -1.9 + 0.1 * swing, "knee": 2.2 + 0.1 * swing, "spine": 0.6 + 0 * t}.get(kind, 0 * t)
        if pose == "crawl":
            x = {"hip": -1.4 + 0.2 * sign * swing, "knee": 1.4 + 0.1 * swing, "neck": -0.6 + 0 * t}.get(kind, 0 * t)
        turn = Rotation.from_rotvec(np.outer(x, [1.0, 0, 0]))
        if kind == "shoulder" and pose != "crawl":
            down = Rotation.from_rotvec([0, 0, -1.25 * sign])
            turn = Rotation.from_rotvec(np.outer(0.4 * sign * swing, [1.0, 0, 0])) * down
        if kind == "shoulder" and pose == "crawl":
            turn = Rotation.from_rotvec(np.outer(0.2 * sign * swing, [1.0, 0, 0])) * Rotation.from_rotvec(
                [0, -1.5 * sign, 0]
            )
        turns[:, j] = turn.as_matrix()
        if joint.part == "pelvis" and pose == "crawl":
            turns[:, j] = Rotation.from_rotvec(np.outer(1.4 + 0 * t, [1.0, 0, 0])).as_matrix()
    return turns


def bvh_of(dialect: Dialect, **options: Any) -> str:
    """The BVH text of the person; options as in :func:`motion_of`."""
    return text_of(dialect, *motion_of(dialect, **options))


def motion_of(
    dialect: Dialect,
    seconds: float = 3.0,
    height: float = HEIGHT,
    pose: str = "walk",
    lead: int = 0,
    speed: float = 1.2,
) -> tuple[list[_Joint], np.ndarray, np.ndarray]:
    """Joints, root path ``(n, 3)`` and rotations ``(n, n_joints, 3, 3)``, metres, Y up. lead: frames of a T-pose."""
    joints = joints_of(dialect, height)
    turns = walking_turns(joints, seconds, dialect.fps, pose)
    t = np.arange(len(turns)) / dialect.fps
    level = {"walk": 0.93, "sit": 0.5, "crouch": 0.45, "crawl": 0.5}[pose] * height / HEIGHT
    travel = speed if pose in ("walk", "crawl") else 0.0
    path = np.column_stack([0.02 * np.sin(t), level + 0.02 * np.cos(4 * np.pi * t), travel * t])
    if lead:
        turns[:lead] = np.eye(3)
        path[:lead] = [0, 0.93 * height / HEIGHT, -2.5]
    if dialect.rest != "t":
        joints, turns = _other_rest(dialect, joints, turns)
    return joints, path, turns


def _other_rest(dialect: Dialect, joints: list[_Joint], turns: np.ndarray) -> tuple[list[_Joint], np.ndarray]:
    """The same motion told from another rest pose: all bones along X ("x"), or arms hanging down ("a")."""
    local = []
    for joint in joints:
        bone = next(
            (other.offset for other in joints if other.parent >= 0 and joints[other.parent] is joint), joint.tip
        )
        if dialect.rest == "x":
            turn = _between(bone, np.array([1.0, 0, 0])) if bone is not None and np.any(bone) else np.eye(3)
        else:
            sign = 1.0 if joint.part.startswith("left") else -1.0
            arm = joint.part.split("_")[-1] in ("shoulder", "elbow", "wrist")
            turn = Rotation.from_rotvec([0, 0, -0.9 * sign]).as_matrix() if arm else np.eye(3)
        local.append(turn)
    new, out = [], np.empty_like(turns)
    for j, joint in enumerate(joints):  # the world turn of each frame is that of before times the inverse of the rest's
        above = local[joint.parent] if joint.parent >= 0 else np.eye(3)
        out[:, j] = above @ turns[:, j] @ local[j].T
        tip = None if joint.tip is None else local[j] @ joint.tip
        new.append(_Joint(joint.name, joint.parent, above @ joint.offset, joint.part, tip))
    return new, out


def _between(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The turn that takes the direction of ``a`` to that of ``b``."""
    return Rotation.align_vectors(b[None] / np.linalg.norm(b), a[None] / np.linalg.norm(a))[0].as_matrix()


def text_of(dialect: Dialect, joints: list[_Joint], path: np.ndarray, turns: np.ndarray) -> str:
    """The BVH text of a motion in metres with Y up, in the axes, unit and channels of the dialect."""
    turn = TO_UP[dialect.up]
    places = ["Xposition", "Yposition", "Zposition"]
    angles = [f"{axis}rotation" for axis in dialect.order]
    lines, columns, open_at = ["HIERARCHY"], [], []

    def close(depth: int) -> None:
        while len(open_at) > depth:
            open_at.pop()
            lines.append("  " * len(open_at) + "}")

    depth_of: dict[int, int] = {}
    for j, joint in enumerate(joints):
        depth = depth_of[j] = 0 if joint.parent < 0 else depth_of[joint.parent] + 1
        close(depth)
        pad = "  " * depth
        offset = turn @ joint.offset / dialect.metres
        channels = (places if joint.parent < 0 or dialect.six or dialect.displaced else []) + angles
        head = "ROOT" if joint.parent < 0 else "JOINT"
        lines += [f"{pad}{head} {joint.name}", pad + "{", f"{pad}  OFFSET " + " ".join(f"{x:.6f}" for x in offset)]
        lines.append(f"{pad}  CHANNELS {len(channels)} " + " ".join(channels))
        open_at.append(j)
        if joint.tip is not None or not any(other.parent == j for other in joints):
            end = turn @ (joint.tip if joint.tip is not None else np.array([0, 0.01, 0])) / dialect.metres
            lines += [f"{pad}  End Site", pad + "  {", f"{pad}    OFFSET " + " ".join(f"{x:.6f}" for x in end)]
            lines.append(pad + "  }")
        rotation = np.einsum("ab,nbc,dc->nad", turn, turns[:, j], turn)
        euler = Rotation.from_matrix(rotation).as_euler(dialect.order.upper(), degrees=True)
        if len(channels) > 3:
            carries = joint.parent < 0 if not (dialect.six or dialect.displaced) else joint.part == "pelvis"
            if carries:
                columns.append(path @ turn.T / dialect.metres)
            else:
                columns.append(np.tile(0 * offset if dialect.displaced else offset, (len(path), 1)))
        columns.append(euler)
    close(0)
    rows = np.concatenate(columns, axis=1)
    lines += ["MOTION", f"Frames: {len(rows)}", f"Frame Time: {1 / dialect.fps:.7f}"]
    return "\n".join([*lines, *(" ".join(f"{x:.6f}" for x in row) for row in rows)]) + "\n"


def _limbs(pattern: str, words: str) -> dict[str, str]:
    """Names of the parts of arms and legs: ``{n}`` in the pattern is each of the words, in the order of BODY; - for
    none."""
    names = (pattern.replace("{n}", word) if word != "-" else "" for word in words.split())
    return {part: name for part, name in zip(_LIMBS, names, strict=True) if name}


_HIK = _limbs("{s}{n}", "Shoulder Arm ForeArm Hand UpLeg Leg Foot ToeBase")
_TRUNK = {"pelvis": "Hips", "spine": "Spine", "chest": "Spine2", "neck": "Neck", "head": "Head"}
_SPINE1 = {"chest": ("Spine1",)}
_FINGERS = {"wrist": ("{s}HandThumb1", "{s}HandIndex1", "{s}HandPinky1")}
_OLD = _limbs("{s}{n}", "Collar Shoulder Elbow Wrist Hip Knee Ankle Toe")
_CHESTS = {"pelvis": "Hips", "spine": "Chest", "chest": "Chest4", "neck": "Neck", "head": "Head"}
_LR, _lr = ("L", "R"), ("l", "r")
_BIP = _limbs("Bip01 {s} {n}", "Clavicle UpperArm Forearm Hand Thigh Calf Foot Toe0")


def _prefixed(prefix: str, names: dict[str, str]) -> dict[str, str]:
    return {part: prefix + name for part, name in names.items()}


DIALECTS: dict[str, Dialect] = {
    "MotionBuilder": Dialect({**_TRUNK, **_HIK}, between=_SPINE1, beside=_FINGERS, above=("Reference",), fps=60),
    "HumanIK of Maya": Dialect(_prefixed("Character1_", {**_TRUNK, **_HIK}), between=_SPINE1, order="XYZ"),
    "Mixamo": Dialect(_prefixed("mixamorig:", {**_TRUNK, **_HIK}), between={"chest": ("mixamorig:Spine1",)}),
    "Mixamo, read by Blender": Dialect(
        _prefixed("mixamorig:", {**_TRUNK, **_HIK}), metres=1.0, up="z", order="XYZ", six=True
    ),
    "Rokoko": Dialect(
        {
            **_TRUNK,
            **_limbs("{s}{n}", "Shoulder Arm ForeArm Hand Thigh Shin Foot Toe"),
        },
        beside={"wrist": ("{s}Finger1Metacarpal", "{s}Finger2Proximal")},
        fps=100,
    ),
    "Xsens MVN": Dialect({**_CHESTS, **_OLD}, between={"chest": ("Chest2", "Chest3")}, order="YXZ", fps=240),
    "100STYLE": Dialect({**_CHESTS, **_OLD}, between={"chest": ("Chest2", "Chest3")}, order="YXZ", fps=60),
    "Perception Neuron": Dialect(
        {**_TRUNK, **_HIK, "toe": ""} | {"chest": "Spine3"},
        between={"chest": ("Spine1", "Spine2")},
        beside={"wrist": ("{s}HandThumb1", "{s}InHandIndex", "{s}HandIndex1")},
        order="YXZ",
        six=True,
        fps=125,
    ),
    "iPi": Dialect(
        {
            **{"pelvis": "Hip", "spine": "LowerSpine", "chest": "Chest", "neck": "Neck", "head": "Head"},
            **_limbs("{s}{n}", "Clavicle Shoulder Forearm Hand Thigh Shin Foot Toe"),
        },
        _LR,
        {"chest": ("MiddleSpine",)},
        metres=0.0254,
    ),
    "DAZ and Poser": Dialect(
        {
            **{"pelvis": "hip", "spine": "abdomen", "chest": "chest", "neck": "neck", "head": "head"},
            **_limbs("{s}{n}", "Collar Shldr ForeArm Hand Thigh Shin Foot Toe"),
        },
        _lr,
        {"hip": ("{s}Buttock",)},
        {"head": ("leftEye", "rightEye")},
    ),
    "Genesis": Dialect(
        {
            **{"pelvis": "hip", "spine": "abdomenLower", "chest": "chestLower", "neck": "neckLower", "head": "head"},
            **_limbs("{s}{n}", "Collar ShldrBend ForearmBend Hand ThighBend Shin Foot Toe"),
        },
        _lr,
        {
            **{"chest": ("abdomenUpper",), "head": ("neckUpper",), "elbow": ("{s}ShldrTwist",)},
            **{"wrist": ("{s}ForearmTwist",), "knee": ("{s}ThighTwist",), "toe": ("{s}Metatarsals",)},
        },
        rest="a",
    ),
    "Second Life": Dialect(
        {
            **{"pelvis": "hip", "spine": "abdomen", "chest": "chest", "neck": "neck", "head": "head"},
            **_limbs("{s}{n}", "Collar Shldr ForeArm Hand Thigh Shin Foot -"),
        },
        _lr,
        metres=0.0254,
        order="XZY",
    ),
    "Biped of 3ds Max": Dialect(
        {
            **{"pelvis": "Bip01 Pelvis", "spine": "Bip01 Spine", "chest": "Bip01 Spine2", "neck": "Bip01 Neck"},
            **{"head": "Bip01 Head"},
            **_BIP,
        },
        _LR,
        {"chest": ("Bip01 Spine1",)},
        {"wrist": ("Bip01 {s} Finger0", "Bip01 {s} Finger1")},
        {"clavicle": "neck", "hip": "spine"},
        ("Bip01",),
        metres=0.0254,
        up="z",
    ),
    "ValveBiped": Dialect(
        {
            part: "ValveBiped." + name.replace(" ", "_")
            for part, name in {
                **{"pelvis": "Bip01_Pelvis", "spine": "Bip01_Spine1", "chest": "Bip01_Spine4", "neck": "Bip01_Neck1"},
                **{"head": "Bip01_Head1"},
                **_BIP,
            }.items()
        },
        _LR,
        metres=0.0254,
        up="z",
    ),
    "Cascadeur": Dialect(
        {
            **{"pelvis": "pelvis", "spine": "stomach", "chest": "chest", "neck": "neck", "head": "head"},
            **_limbs("{n}_{s}", "clavicle arm forearm hand thigh calf foot toe"),
        },
        _lr,
    ),
    "Unreal": Dialect(
        {
            **{"pelvis": "pelvis", "spine": "spine_01", "chest": "spine_03", "neck": "neck_01", "head": "head"},
            **_limbs("{n}_{s}", "clavicle upperarm lowerarm hand thigh calf foot ball"),
        },
        _lr,
        {"chest": ("spine_02",)},
        {"elbow": ("lowerarm_twist_01_{s}",), "hip": ("thigh_twist_01_{s}",), "wrist": ("index_01_{s}",)},
        {},
        ("root",),
        up="z",
    ),
    "LaFAN1": Dialect({**_TRUNK, **_HIK, "toe": "{s}Toe"}, between=_SPINE1, order="ZYX", rest="x"),
    "CMU for MotionBuilder": Dialect(
        {**_TRUNK, **_HIK} | {"spine": "LowerBack", "chest": "Spine1"},
        between={"chest": ("Spine",), "head": ("Neck1",)},
        beside={"wrist": ("{s}FingerBase", "{s}Thumb")},
        fps=120,
    ),
    "CMU for 3ds Max": Dialect(
        {**_CHESTS, **_OLD, "toe": ""} | {"spine": "", "chest": "Chest"}, metres=0.0254 / 0.45, fps=120
    ),
    "SMPL": Dialect(
        {
            **{"pelvis": "Pelvis", "spine": "Spine1", "chest": "Spine3", "neck": "Neck", "head": "Head"},
            **_limbs("{s}_{n}", "Collar Shoulder Elbow Wrist Hip Knee Ankle Foot"),
        },
        _LR,
        {"chest": ("Spine2",)},
        {"wrist": ("{s}_Hand",)},
        metres=1.0,
    ),
    "VRoid": Dialect(
        {
            **{"pelvis": "J_Bip_C_Hips", "spine": "J_Bip_C_Spine", "chest": "J_Bip_C_UpperChest"},
            **{"neck": "J_Bip_C_Neck", "head": "J_Bip_C_Head"},
            **_limbs("J_Bip_{s}_{n}", "Shoulder UpperArm LowerArm Hand UpperLeg LowerLeg Foot ToeBase"),
        },
        _LR,
        {"chest": ("J_Bip_C_Chest",)},
        {
            "head": ("J_Adj_L_FaceEye", "J_Sec_Hair1_01", "J_Sec_Hair1_02"),
            "shoulder": ("J_Sec_{s}_TopsUpperArmInside",),
        },
        metres=1.0,
    ),
    "MikuMikuDance": Dialect(
        {
            **{"pelvis": "下半身", "spine": "上半身", "chest": "上半身2", "neck": "首", "head": "頭"},
            **_limbs("{s}{n}", "肩 腕 ひじ 手首 足 ひざ 足首 つま先"),
        },
        ("左", "右"),
        above=("センター",),
        metres=0.08,
        rest="a",
    ),
    "Kinect": Dialect(
        {
            **{"pelvis": "SpineBase", "spine": "SpineMid", "chest": "SpineShoulder", "neck": "Neck", "head": "Head"},
            **_limbs("{n}{s}", "- Shoulder Elbow Wrist Hip Knee Ankle Foot"),
        },
        beside={"wrist": ("Hand{s}",)},
        metres=1.0,
    ),
    "OptiTrack": Dialect(
        {
            **{"pelvis": "Hip", "spine": "Ab", "chest": "Chest", "neck": "Neck", "head": "Head"},
            **_limbs("{s}{n}", "Shoulder UArm FArm Hand Thigh Shin Foot Toe"),
        },
        _LR,
        metres=0.001,
        fps=120,
    ),
    "Rigify": Dialect(
        {
            **{"pelvis": "spine", "spine": "spine.001", "chest": "spine.003", "neck": "spine.004", "head": "spine.006"},
            **_limbs("{n}.{s}", "shoulder upper_arm forearm hand thigh shin foot toe"),
        },
        _LR,
        {"chest": ("spine.002",), "head": ("spine.005",)},
        {"pelvis": ("pelvis.L", "pelvis.R"), "chest": ("breast.L", "breast.R"), "wrist": ("thumb.01.{s}",)},
        metres=1.0,
        up="z",
        order="XYZ",
        displaced=True,
    ),
    "MakeHuman": Dialect(
        {
            **{"pelvis": "root", "spine": "spine05", "chest": "spine01", "neck": "neck01", "head": "head"},
            **_limbs("{n}.{s}", "clavicle upperarm01 lowerarm01 wrist upperleg01 lowerleg01 foot toe1-1"),
        },
        _LR,
        {
            **{"chest": ("spine04", "spine03", "spine02"), "head": ("neck02", "neck03"), "hip": ("pelvis.{s}",)},
            **{"shoulder": ("shoulder01.{s}",), "elbow": ("upperarm02.{s}",), "wrist": ("lowerarm02.{s}",)},
            **{"knee": ("upperleg02.{s}",), "ankle": ("lowerleg02.{s}",)},
        },
        {"wrist": ("finger1-1.{s}", "metacarpal1.{s}")},
        metres=0.1,
    ),
    "AdvancedSkeleton": Dialect(
        {
            **{"pelvis": "Root_M", "spine": "Spine1_M", "chest": "Chest_M", "neck": "Neck_M", "head": "Head_M"},
            **_limbs("{n}_{s}", "Scapula Shoulder Elbow Wrist Hip Knee Ankle Toes"),
        },
        _LR,
        {"elbow": ("ShoulderPart1_{s}",), "wrist": ("ElbowPart1_{s}",), "knee": ("HipPart1_{s}",)},
        fps=24,
    ),
    "words apart": Dialect(
        {
            **{
                "pelvis": "jnt_hips",
                "spine": "jnt_spine_a",
                "chest": "jnt_spine_c",
                "neck": "jnt_neck",
                "head": "jnt_head",
            },
            **_limbs("jnt_{s}_{n}", "clavicle arm_upper arm_lower hand leg_upper leg_lower foot toe"),
        },
        ("left", "right"),
        {"chest": ("jnt_spine_b",)},
    ),
    "numbered": Dialect(
        {
            **{"pelvis": "pelvis", "spine": "spine1", "chest": "spine3", "neck": "neck", "head": "head"},
            **_limbs("{n}.{s}", "clavicle arm1 arm2 hand leg1 leg2 foot toe"),
        },
        _lr,
        {"chest": ("spine2",)},
    ),
    "robot": Dialect(
        {
            **{"pelvis": "pelvis", "spine": "waist_yaw_link", "chest": "torso_link", "head": "head_link"},
            **_limbs("{s}_{n}_link", "- shoulder_pitch elbow wrist_roll hip_pitch knee ankle_pitch -"),
        },
        ("left", "right"),
        {"elbow": ("{s}_shoulder_roll_link",), "knee": ("{s}_hip_roll_link",)},
        metres=1.0,
        up="z",
    ),
    "OpenSim": Dialect(
        {
            **{"pelvis": "pelvis", "chest": "torso", "head": "head"},
            **_limbs("{n}_{s}", "- humerus ulna hand femur tibia talus toes"),
        },
        _lr,
        metres=1.0,
    ),
    "nameless": Dialect(
        {
            **{"pelvis": "Bone", "spine": "Bone.001", "chest": "Bone.002", "neck": "Bone.003", "head": "Bone.004"},
            **_limbs("Bone.{n}{s}", "10 11 12 13 20 21 22 23"),
        },
        ("4", "7"),
        metres=1.0,
    ),
}
DIALECTS = {  # parts named "" have no joint
    name: Dialect(**{**one.__dict__, "names": {part: word for part, word in one.names.items() if word}})
    for name, one in DIALECTS.items()
}


def without(dialect: Dialect, *parts: str) -> Dialect:
    """The dialect without these parts of the body."""
    names = {part: name for part, name in dialect.names.items() if part not in parts}
    kept = {part: words for part, words in dialect.between.items() if part in names}
    beside = {part: words for part, words in dialect.beside.items() if part in names}
    return replace(dialect, names=names, between=kept, beside=beside)


def mirrored(joints: list[_Joint], path: np.ndarray, turns: np.ndarray) -> tuple[list[_Joint], np.ndarray, np.ndarray]:
    """X turned round in all coordinates and no joint renamed, as a left-handed program writes it."""
    flip = np.array([-1.0, 1, 1])
    tip = [None if joint.tip is None else joint.tip * flip for joint in joints]
    new = [replace(joint, offset=joint.offset * flip, tip=end) for joint, end in zip(joints, tip, strict=True)]
    return new, path * flip, turns * np.outer(flip, flip)


def lifted_by_the_root(
    joints: list[_Joint], path: np.ndarray, turns: np.ndarray, up: str, facing: float
) -> tuple[list[_Joint], np.ndarray, np.ndarray]:
    """Another axis up in the motion and Y in the rest pose: only the root is turned. facing: degrees about the axis."""
    turn = TO_UP[up] @ Rotation.from_euler("y", facing, degrees=True).as_matrix()
    lifted = turns.copy()
    lifted[:, 0] = turn @ turns[:, 0]
    return joints, path @ turn.T, lifted


def on_all_fours(
    joints: list[_Joint], path: np.ndarray, turns: np.ndarray
) -> tuple[list[_Joint], np.ndarray, np.ndarray]:
    """An animal with these names: the trunk lies level, four legs hang down."""
    new = []
    for joint in joints:
        offset, kind = joint.offset, joint.part.split("_")[-1]
        if kind in ("elbow", "wrist"):
            offset = np.array([0, -abs(offset[0]), 0.02])
        elif kind not in ("hip", "knee", "ankle", "toe", "clavicle", "shoulder", "pelvis"):
            offset = np.array([offset[0], offset[2], offset[1]])
        new.append(replace(joint, offset=offset))
    still = turns.copy()
    for j, joint in enumerate(joints):
        if joint.part.split("_")[-1] in ("shoulder", "hip"):
            still[:, j] = Rotation.from_rotvec(
                np.outer(0.3 * np.sin(np.arange(len(turns)) / 5), [1.0, 0, 0])
            ).as_matrix()
    return new, path, still
