"""Which joints of a skeleton are drawn, and where they are: the geometry behind the Stage, filmstrips and icons.

Fingers, face, twist and helper joints would only clutter a stick figure: the joints of the canonical body are drawn,
one tip for each hand and foot, and two points no recording has: the middle of the head and the tip of the nose.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache
from weakref import WeakKeyDictionary

import numpy as np

from core.errors import ParameterError
from core.mocap import quaternions as quat
from core.mocap.anatomy import Anatomy, find_anatomy
from core.mocap.clip import Clip
from core.mocap.kinematics import forward_kinematics
from core.mocap.skeleton import Skeleton

SAMPLED_FRAMES = 64
EXTREMITIES = ("left_wrist", "right_wrist", "left_toe", "right_toe")


@dataclass(frozen=True)
class DrawnBody:
    """The drawn joints of a skeleton, parents first; the last two may be made up: ``head_centre`` and ``nose``.

    sources: joint of the skeleton behind each drawn joint; the head joint behind the two made-up ones.
    parents: drawn parent of each drawn joint, -1 for the root.
    roles: canonical name ("left_knee", "left_hand", "head_centre" ...), "" where the anatomy does not know the joint.
    sides: "left", "right" or "centre".
    """

    names: tuple[str, ...]
    sources: tuple[int, ...]
    parents: tuple[int, ...]
    roles: tuple[str, ...]
    sides: tuple[str, ...]
    height: float

    def find(self, role: str) -> int:
        """Drawn joint of that role, -1 where there is none."""
        return self.roles.index(role) if role in self.roles else -1

    @property
    def hands(self) -> tuple[int, ...]:
        """Outermost drawn joint of each arm."""
        return self._first(("left_hand", "left_wrist"), ("right_hand", "right_wrist"))

    @property
    def feet(self) -> tuple[int, ...]:
        """Drawn joints that touch the ground: ankles, toes and their tips."""
        return tuple(j for j, role in enumerate(self.roles) if role.split("_")[-1] in ("ankle", "toe", "foot"))

    def _first(self, *choices: tuple[str, ...]) -> tuple[int, ...]:
        found = (next((self.find(r) for r in roles if r in self.roles), -1) for roles in choices)
        return tuple(j for j in found if j >= 0)


@dataclass(frozen=True)
class HeadAndFloor:
    """What only motion tells: see :func:`measure_head_and_floor`."""

    centre: np.ndarray
    nose: np.ndarray
    radius: float
    floor: float


@lru_cache(maxsize=256)
def drawn_body(skeleton: Skeleton) -> DrawnBody:
    """The joints to draw. A skeleton without a recognised human body is drawn whole."""
    anatomy = find_anatomy(skeleton)
    roles = {joint: role for role, joint in reversed(list(anatomy.joints.items()))}
    if len(roles) < 8:
        roles = dict.fromkeys(range(skeleton.n_joints), "")
    roles.setdefault(0, "")
    for extremity in EXTREMITIES:
        _add_tip(skeleton, anatomy, roles, extremity)
    sources = sorted(roles)
    place = {joint: k for k, joint in enumerate(sources)}
    parents = [_drawn_parent(skeleton, place, joint) for joint in sources]
    names, sides = [skeleton.names[j] for j in sources], [anatomy.side(j) for j in sources]
    labels = [roles[j] for j in sources]
    if "head" in labels:
        head = labels.index("head")
        sources += [sources[head]] * 2
        parents += [head, len(names)]
        names += ["head centre", "nose"]
        labels += ["head_centre", "nose"]
        sides += ["centre", "centre"]
    return DrawnBody(
        tuple(names), tuple(sources), tuple(parents), tuple(labels), tuple(sides), float(anatomy.body_height)
    )


def _add_tip(skeleton: Skeleton, anatomy: Anatomy, roles: dict[int, str], extremity: str) -> None:
    """Draw what reaches furthest from a wrist or toe (ankle where there is no toe): middle finger, tip of the toes."""
    side, part = extremity.split("_")
    joint = anatomy.joints.get(extremity, anatomy.joints.get(f"{side}_ankle") if part == "toe" else None)
    if joint is None or roles.get(joint, "") == "":
        return
    reach = {joint: np.zeros(3)}
    for child in range(joint + 1, skeleton.n_joints):
        if skeleton.parents[child] in reach:
            reach[child] = reach[skeleton.parents[child]] + skeleton.offsets[child]
    tip = max(reach, key=lambda j: float(np.linalg.norm(reach[j])))
    if np.linalg.norm(reach[tip]) > 0.01 * anatomy.body_height:
        roles.setdefault(tip, f"{side}_{'hand' if part == 'wrist' else 'foot'}")


def _drawn_parent(skeleton: Skeleton, place: dict[int, int], joint: int) -> int:
    parent = skeleton.parents[joint]
    while parent >= 0 and parent not in place:
        parent = skeleton.parents[parent]
    return place.get(parent, -1)


def facing(positions: np.ndarray, body: DrawnBody) -> np.ndarray:
    """Where the trunk faces: unit vectors ``(n, 3)`` on the ground, from the hips and shoulders of ``(n, joints, 3)``.

    Zero vectors where the body does not say (no left and right, or lying so that left is up).
    """
    left = np.zeros((len(positions), 3))
    for part in ("hip", "shoulder"):
        a, b = body.find(f"left_{part}"), body.find(f"right_{part}")
        if a >= 0 and b >= 0:
            left += positions[:, a] - positions[:, b]
    forward = np.stack([-left[:, 2], np.zeros(len(left)), left[:, 0]], axis=-1)
    length = np.linalg.norm(forward, axis=-1, keepdims=True)
    return np.where(length > 0.05 * body.height, forward / np.maximum(length, 1e-9), 0.0)


def measure_head_and_floor(clip: Clip, body: DrawnBody) -> HeadAndFloor:
    """Head and floor, from at most 64 frames spread over the clip.

    centre, nose: (3,) metres in the head joint's own frame: the middle of the head, and the tip of the nose. The nose
        points where the trunk faces on average: a rest pose need not be a standing one, so it cannot tell.
    radius: of the head, metres. floor: height of the lowest drawn joint in that sample, metres, 0 when within 3 cm.
    """
    step = max(1, clip.n_frames // SAMPLED_FRAMES)
    positions, rotations = forward_kinematics(_every(clip, 0, clip.n_frames, step))
    real = positions[:, list(body.sources)]
    floor = float(np.percentile(real[..., 1].min(axis=1), 2))
    floor = 0.0 if abs(floor) < 0.03 else floor
    head, neck = body.find("head"), body.find("neck")
    if head < 0:
        return HeadAndFloor(np.zeros(3), np.zeros(3), 0.0, floor)
    below = neck if neck >= 0 else body.parents[head]
    inverse = quat.conjugate(rotations[:, body.sources[head]])
    up = _mean_direction(quat.rotate(inverse, real[:, head] - real[:, below]))
    forward = _mean_direction(quat.rotate(inverse, facing(real, body)))
    forward = forward - up * (forward @ up)
    forward /= max(float(np.linalg.norm(forward)), 1e-9)
    radius = 0.062 * body.height
    centre = up * radius * 0.95
    return HeadAndFloor(centre, centre + forward * radius * 1.1, radius, floor)


def _mean_direction(vectors: np.ndarray) -> np.ndarray:
    mean = vectors.sum(axis=0)
    length = float(np.linalg.norm(mean))
    return mean / length if length > 1e-6 else np.array([0.0, 1.0, 0.0])


def drawn_positions(clip: Clip, start: int, end: int, step: int = 1) -> tuple[np.ndarray, DrawnBody, HeadAndFloor]:
    """Every ``step``-th frame of ``[start, end)``: ``(n, drawn joints, 3)`` float32, world metres, with its body.

    Only those frames are computed. Raises ParameterError when the interval is empty or outside the clip.
    """
    if not 0 <= start < end <= clip.n_frames or step < 1:
        raise ParameterError(f"{clip.name} has frames 0 to {clip.n_frames}; cannot show {start} to {end}")
    body = drawn_body(clip.skeleton)
    measured = _measured.get(clip)
    if measured is None:
        measured = _measured[clip] = measure_head_and_floor(clip, body)
    positions, rotations = forward_kinematics(_every(clip, start, end, step))
    drawn = positions[:, list(body.sources)]
    if body.find("nose") >= 0:
        turn = rotations[:, body.sources[-1], None]
        drawn[:, -2:] += quat.rotate(turn, np.stack((measured.centre, measured.nose)))
    return np.ascontiguousarray(drawn, np.float32), body, measured


_measured: WeakKeyDictionary[Clip, HeadAndFloor] = WeakKeyDictionary()  # many segments of few clips are asked for


def _every(clip: Clip, start: int, end: int, step: int) -> Clip:
    return replace(
        clip,
        root_positions=clip.root_positions[start:end:step],
        rotations=clip.rotations[start:end:step],
        translations={j: t[start:end:step] for j, t in clip.translations.items()},
    )
