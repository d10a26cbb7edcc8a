"""Anatomy: which joint of a skeleton is which part of the body.

Names first (:mod:`core.mocap.anatomy_names`), the shape of the tree where they say nothing. What a skeleton does not
have is left out, so ask ``"left_toe" in anatomy.joints``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from types import MappingProxyType

import numpy as np

from core.errors import ParameterError
from core.mocap import anatomy_shape as shape
from core.mocap.anatomy_names import (
    CHOOSING_ORDER,
    LIMB_NAMES,
    TRUNK_NAMES,
    ParsedName,
    is_qualified,
    parse_names,
    with_thigh,
)
from core.mocap.body_kinds import ARM, LEG, BodyKind, kind_of_body, missing_parts
from core.mocap.skeleton import Skeleton

SIDES = ("left", "right")
_LEG, _ARM = ("hip", "knee", "ankle", "toe"), ("clavicle", "shoulder", "elbow", "wrist")
CANONICAL: tuple[str, ...] = (
    *("pelvis", "spine", "chest", "neck", "head"),
    *(f"{side}_{part}" for side in SIDES for part in (*_ARM, *_LEG)),
)
# Share of the stature below the ankle and above the head joint (Drillis and Contini 1966; ear canal to crown).
_BELOW_ANKLE, _ABOVE_HEAD = 0.039, 0.08
# Shares of hip to ankle, shoulder to wrist, and (what is left) pelvis to head joint, for bodies that are not whole.
_LEG_SHARE, _ARM_SHARE, _TRUNK_SHARE = 0.491, 0.332, 0.39


@dataclass(frozen=True, eq=False)
class Anatomy:
    """The body in a skeleton.

    joints: canonical name (of :data:`CANONICAL`) -> joint index, for the joints found.
    posture_joints: joint indices, ascending, that make up a posture: trunk, arms and legs down to wrist and toe. Not
        among them: the pelvis (its height and tilt are features of their own), twist, finger, face and helper joints,
        and end sites. All turning joints but the root where no body is recognised.
    sides: per joint ``"left"``, ``"right"`` or ``"centre"``.
    body_height: metres, from rest bone lengths: leg, trunk and head, with the usual share for the foot's height; of a
        partial body, what the parts that are there speak for; of another, the longest way along its bones.
    head_tip: joint index of the crown (the head joint itself, or the last trunk joint, where there is no tip).
    by_name: False where arms and legs had to be told from the tree's shape alone.
    body: ``"human"``, ``"partial"`` or ``"other"``: an animal, a prop; then ``joints`` has the pelvis, which is the
        root, and what someone said. missing: what a person has and a partial body has not, in words.
    """

    skeleton: Skeleton
    joints: Mapping[str, int]
    posture_joints: tuple[int, ...]
    sides: tuple[str, ...]
    body_height: float
    head_tip: int
    by_name: bool
    body: BodyKind = "human"
    missing: tuple[str, ...] = ()

    def side(self, joint: int) -> str:
        """``"left"``, ``"right"`` or ``"centre"`` for a joint index."""
        return self.sides[joint]

    @property
    def legs(self) -> tuple[tuple[int, int, int], ...]:
        """(hip, knee, ankle) joint indices of each complete leg, left before right."""
        chains = [[self.joints.get(f"{side}_{part}", -1) for part in _LEG[:3]] for side in SIDES]
        return tuple((hip, knee, ankle) for hip, knee, ankle in chains if min(hip, knee, ankle) >= 0)

    @property
    def feet(self) -> tuple[tuple[int, int], ...]:
        """(ankle, toe) joint indices of each foot found, left before right; toe is the ankle where there is none."""
        found = [(self.joints.get(f"{s}_ankle", -1), self.joints.get(f"{s}_toe", -1)) for s in SIDES]
        return tuple((ankle, toe if toe >= 0 else ankle) for ankle, toe in found if ankle >= 0)

    def foot_joints(self, ankle: int) -> tuple[int, ...]:
        """The ankle and all joints and end sites below it."""
        return tuple(shape.subtree(self.skeleton, ankle))


def find_anatomy(skeleton: Skeleton, corrections: Mapping[str, str | int | None] | None = None) -> Anatomy:
    """The body in ``skeleton``; the answer is kept, so asking again costs nothing.

    corrections: canonical name -> joint name or index that replaces the guess, or None for "there is none"; beside
    those of the skeleton itself. Raises ValueError for a canonical name or a joint that does not exist.
    """
    corrections = {**dict(skeleton.corrections), **(corrections or {})}
    fixed = tuple(sorted(corrections.items(), key=lambda item: item[0]))
    return _find(skeleton, tuple((name, _joint(skeleton, name, joint)) for name, joint in fixed))


def suggested_joints(skeleton: Skeleton) -> dict[str, int]:
    """Canonical name -> joint index as names and shape would have it, also where they do not make a human body."""
    return dict(find_anatomy(replace(skeleton, corrections=(), body="partial")).joints)


def _joint(skeleton: Skeleton, name: str, joint: str | int | None) -> int | None:
    if name not in CANONICAL:
        raise ParameterError(f"{name!r} is no part of the body; the parts are {', '.join(CANONICAL)}")
    if isinstance(joint, str):
        try:
            return skeleton.index(joint)
        except KeyError as error:
            raise ParameterError(error.args[0]) from None
    if joint is not None and not 0 <= joint < skeleton.n_joints:
        raise ParameterError(f"{name}: no joint number {joint}; the skeleton has {skeleton.n_joints}")
    return joint


@lru_cache(maxsize=256)
def _find(skeleton: Skeleton, corrections: tuple[tuple[str, int | None], ...]) -> Anatomy:
    parsed = parse_names(skeleton.names)
    limbs = {(side, limb): _limb_by_name(skeleton, parsed, side, limb) for side in SIDES for limb in LIMB_NAMES}
    named = sum(_is_named(found, limb) for (_, limb), found in limbs.items())
    by_name = named > 0
    if named < len(limbs):
        limbs = _limbs_by_shape(skeleton, parsed, limbs)
    joints = {"pelvis": 0}
    for (side, _), found in limbs.items():
        joints |= {f"{side}_{part}": joint for part, joint in found.items()}
    joints |= _trunk(skeleton, parsed, joints)
    for name, joint in corrections:
        joints.pop(name, None)
        if joint is not None:
            joints[name] = joint
    joints = {name: joints[name] for name in CANONICAL if name in joints}
    body = skeleton.body or kind_of_body(skeleton, joints, by_name or bool(corrections))
    if body == "other":  # only what someone said
        joints = {"pelvis": 0} | {name: joint for name, joint in corrections if joint is not None}
    tip = _head_tip(skeleton, joints)
    return Anatomy(
        skeleton=skeleton,
        joints=MappingProxyType(joints),
        posture_joints=_posture_joints(skeleton, joints if body != "other" else {}),
        sides=_sides(skeleton, parsed, joints),
        body_height=_body_height(skeleton, joints, tip) if body != "other" else float(shape.reach(skeleton)[0]),
        head_tip=tip,
        by_name=by_name,
        body=body,
        missing=tuple(missing_parts(joints)) if body == "partial" else (),
    )


def _is_named(found: dict[str, int], limb: str) -> bool:
    """Whether names gave at least two of the joints that make a limb: then its names are believed."""
    return sum(part in found for part in (LEG if limb == "leg" else ARM)) >= 2


def _limb_by_name(skeleton: Skeleton, parsed: list[ParsedName], side: str, limb: str) -> dict[str, int]:
    """Joints of one limb that have a known name and hang from one another; nothing where they do not."""
    first: dict[str, int] = {}
    helpers_last = sorted(enumerate(parsed), key=lambda item: is_qualified(skeleton.names[item[0]]))
    for j, (joint_side, part) in helpers_last:
        if joint_side == side and not skeleton.end_sites[j]:
            first.setdefault(part, j)
    alike = [j for j, part in enumerate(parsed) if part == (side, limb) and not skeleton.end_sites[j]]
    first = with_thigh(first, len(alike) if limb == "leg" else 1)
    joints: dict[str, int] = {}
    for part in CHOOSING_ORDER[limb]:
        name = next((n for n in LIMB_NAMES[limb][part] if n in first and first[n] not in joints.values()), None)
        if name is not None:
            joints[part] = first[name]
    upper, middle, lower = LEG if limb == "leg" else ARM
    if middle not in joints and {upper, lower} <= joints.keys():
        joints |= _between(skeleton, joints[upper], joints[lower], middle)
    if middle not in joints and joints.get(upper) in alike[:1] and len(alike) > 1:  # leg1, leg2
        joints[middle] = alike[1]
    chain = [joints[part] for part in LIMB_NAMES[limb] if part in joints]
    hangs = all(a in shape.ancestors(skeleton, b) for a, b in pairwise(chain))
    return {part: joints[part] for part in LIMB_NAMES[limb] if part in joints} if hangs else {}


def _between(skeleton: Skeleton, top: int, bottom: int, name: str) -> dict[str, int]:
    """The joint between two others that divides the way best, under ``name``; nothing where none lies between."""
    line = shape.path(skeleton, top, bottom)
    length = np.cumsum([0.0, *np.linalg.norm(skeleton.offsets[line[1:]], axis=1)]) if line else np.zeros(1)
    inner = range(1, len(line) - 1)
    best = max(inner, key=lambda k: min(length[k], length[-1] - length[k]), default=None)
    return {} if best is None else {name: line[best]}


_Limbs = dict[tuple[str, str], dict[str, int]]  # by side and limb: part -> joint


def _limbs_by_shape(skeleton: Skeleton, parsed: list[ParsedName], named: _Limbs) -> _Limbs:
    """Limbs told from the tree where names gave none; a limb that has a name is kept, and no joint is used twice."""
    limbs = {key: found if _is_named(found, key[1]) else {} for key, found in named.items()}
    used = {j for found in limbs.values() if found for j in shape.subtree(skeleton, next(iter(found.values())))}
    for limb, pair in shape.find_limbs(skeleton).items():
        taken = any(limbs[side, limb] for side in SIDES)
        if taken or used & {j for chain in pair for j in chain.values()} or _named_otherwise(parsed, limb, pair):
            continue
        left, right = sorted(pair, key=lambda chain: not _is_left(skeleton, parsed, chain, pair))
        limbs["left", limb], limbs["right", limb] = left, right
    return limbs


def _named_otherwise(parsed: list[ParsedName], limb: str, pair: tuple[dict[str, int], dict[str, int]]) -> bool:
    """Whether the names along a pair of chains are those of the other limb (arms where legs are looked for)."""
    words = {other: {n for names in parts.values() for n in names} for other, parts in LIMB_NAMES.items()}
    (other,) = (name for name in words if name != limb)
    parts = {parsed[j].part for chain in pair for j in chain.values()}
    return bool(parts & (words[other] - words[limb]))


def _is_left(
    skeleton: Skeleton, parsed: list[ParsedName], chain: dict[str, int], pair: tuple[dict[str, int], dict[str, int]]
) -> bool:
    """By the names in the chain where these give sides, else by the rest position."""
    votes = [sum(parsed[j].side == side for j in chain.values()) for side in SIDES]
    if votes[0] != votes[1]:
        return votes[0] > votes[1]
    other = pair[1] if chain is pair[0] else pair[0]
    votes = [sum(parsed[j].side == side for j in other.values()) for side in SIDES]
    return (
        votes[1] > votes[0]
        if votes[0] != votes[1]
        else shape.leftness(skeleton, chain) > shape.leftness(skeleton, other)
    )


def _trunk(skeleton: Skeleton, parsed: list[ParsedName], joints: dict[str, int]) -> dict[str, int]:
    """Spine, chest, neck and head: the path from the pelvis to the head, seen from where the arms branch off."""
    trunk: dict[str, int] = {}
    arms = [joints.get(f"{side}_clavicle", joints.get(f"{side}_shoulder", -1)) for side in SIDES]
    legs = {a for side in SIDES for a in shape.ancestors(skeleton, joints.get(f"{side}_hip", 0))}
    named = {
        part: next((j for n in names for j, p in enumerate(parsed) if p == ("centre", n) and j), None)
        for part, names in TRUNK_NAMES.items()
    }
    head = named["head"]
    if min(arms) >= 0:
        chest = shape.common_ancestor(skeleton, *arms)
        if chest and chest == named["neck"]:  # the arms hang from the neck
            chest = skeleton.parents[chest]
        beside = [j for j in skeleton.children(chest) if parsed[j].side != "centre"]
        above = shape.longest_path(skeleton, chest, avoid=[*arms, *beside]) if chest else []
        head = head if head is not None and chest in shape.ancestors(skeleton, head) else shape.head_of(skeleton, above)
        if chest:
            trunk["chest"] = chest
    elif head is None:
        return trunk
    chest = trunk.get("chest", 0)
    path = [j for j in shape.path(skeleton, 0, chest)[1:-1] if j not in legs]
    if path:
        trunk["spine"] = path[0]
    if head is not None:
        between = [j for j in shape.path(skeleton, chest, head)[1:-1] if j]
        if named["neck"] in between:
            between = [named["neck"]]
        elif not chest:  # of a trunk without arms, only what is next to the head
            between = between[-1:]
        trunk |= {"neck": between[0], "head": head} if between else {"head": head}
    elif named["neck"] is not None:
        trunk["neck"] = named["neck"]
    return trunk


def _head_tip(skeleton: Skeleton, joints: dict[str, int]) -> int:
    top = next(joints[name] for name in ("head", "neck", "chest", "pelvis") if name in joints)
    ends = [j for j in skeleton.children(top) if skeleton.end_sites[j]]
    return max(ends, key=lambda j: np.linalg.norm(skeleton.offsets[j])) if ends and top else top


def _posture_joints(skeleton: Skeleton, joints: dict[str, int]) -> tuple[int, ...]:
    tips = ("head", "neck", "chest", "left_wrist", "right_wrist", "left_ankle", "right_ankle", "left_toe", "right_toe")
    chosen = {j for tip in tips if tip in joints for j in shape.path(skeleton, 0, joints[tip])} - {0}
    if not chosen:
        chosen = {j for j in range(1, skeleton.n_joints) if not skeleton.end_sites[j]}
    return tuple(sorted(chosen))


def _sides(skeleton: Skeleton, parsed: list[ParsedName], joints: dict[str, int]) -> tuple[str, ...]:
    """A limb hands its side down; the rest goes by name, or else by its parent."""
    given = {j: name.split("_")[0] for name, j in joints.items() if "_" in name}
    sides: list[str] = []
    for j, parent in enumerate(skeleton.parents):
        inherited = sides[parent] if parent >= 0 else "centre"
        centre = j in joints.values() and j not in given
        sides.append(given.get(j) or ("centre" if centre else inherited if inherited != "centre" else parsed[j].side))
    return tuple(sides)


def _body_height(skeleton: Skeleton, joints: dict[str, int], tip: int) -> float:
    length = np.linalg.norm(skeleton.offsets, axis=1)

    def along(a: int, b: int) -> float:
        return float(length[shape.path(skeleton, a, b)[1:]].sum())

    legs = [along(joints[f"{s}_hip"], joints[f"{s}_ankle"]) for s in SIDES if {f"{s}_hip", f"{s}_ankle"} <= set(joints)]
    if not legs or tip == 0:
        arms = [along(joints[f"{s}_shoulder"], joints[f"{s}_wrist"]) for s in SIDES if f"{s}_wrist" in joints]
        spine = [along(0, joints["head"])] if "head" in joints else []
        parts = ((legs, _LEG_SHARE), (arms, _ARM_SHARE), (spine, _TRUNK_SHARE))
        heights = [float(np.mean(lengths)) / share for lengths, share in parts if lengths and max(lengths) > 0]
        return float(np.mean(heights)) if heights else float(shape.reach(skeleton)[0])
    head = joints.get("head", tip)
    trunk = along(0, head)
    crown = along(head, tip) if tip != head else 0.0
    known = float(np.mean(legs)) + trunk
    # a tip of no length is a tip that nobody measured
    return (known + crown) / (1 - _BELOW_ANKLE) if crown > 0.03 * known else known / (1 - _BELOW_ANKLE - _ABOVE_HEAD)
