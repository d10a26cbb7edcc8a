"""What kind of body a skeleton is: a human, a part of one, or something else."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Literal

import numpy as np

from core.mocap import anatomy_shape as shape
from core.mocap.skeleton import Skeleton

BodyKind = Literal["human", "partial", "other"]
SIDES = ("left", "right")
LEG, ARM = ("hip", "knee", "ankle"), ("shoulder", "elbow", "wrist")
# Parts of animals and machines; words of a joint's name, whole.
_NOT_HUMAN = re.compile(
    r"(tail|wing|beak|bill|feather|paw|hoof|hooves|claw|pincer|fin|flipper|fang|snout|muzzle|horn|antler|mane|udder|"
    r"antenna|feeler|mandible|tentacle|thorax\d?leg|horselink|hock|fetlock|pastern|trunk\d+|wheel|axis|propeller)s?",
    re.IGNORECASE,
)
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
# Ratios of lengths that people have, children and stylised figures too: Drillis and Contini (1966), and a third either
# way. Trunk: pelvis to head.
_RATIOS = {
    "arm to leg": (0.42, 0.88),
    "trunk to leg": (0.4, 1.6),
    "shin to thigh": (0.55, 1.7),
    "fore to upper": (0.5, 1.8),
}
_SIDE_BY_SIDE, _ACROSS = (
    0.8,
    0.6,
)  # cosines between any two limbs, and between them and the trunk, of what has four legs
_MOST_CHAINS = 6  # long branches of a person: two arms, two legs, head, and one that is worn


def kind_of_body(skeleton: Skeleton, joints: Mapping[str, int], by_name: bool) -> BodyKind:
    """The kind of the body whose canonical ``joints`` (name -> joint index) were found, by their names or by shape.

    A human has both arms, both legs, and a head or a neck; and human proportions where the names do not say that it is
    one, or speak of an animal besides. What stands on four legs at rest, whatever its joints are called, has the
    proportions of nobody, or names of an animal's parts, is "other".
    """
    complete = not missing_parts(joints)
    animal = any(_NOT_HUMAN.fullmatch(word) for name in skeleton.names for word in _WORD.findall(name))
    if complete and is_on_all_fours(skeleton, joints):
        return "other"
    if complete and (by_name and not animal):
        return "human"
    if complete:
        return "human" if is_proportioned(skeleton, joints) and (by_name or not has_many_limbs(skeleton)) else "other"
    found = any(_has(joints, side, limb) for side in SIDES for limb in (LEG, ARM))
    return "partial" if found and by_name and not animal else "other"


def missing_parts(joints: Mapping[str, int]) -> list[str]:
    """What of a person is not among the canonical ``joints``, in words: ``legs``, ``left hand``, ``head`` ..."""
    missing = [] if {"head", "neck"} & joints.keys() else ["head"]
    for name, limb, tip in (("arm", ARM, "hand"), ("leg", LEG, "foot")):
        lacking = {}
        for side in SIDES:
            if not {f"{side}_{limb[0]}", f"{side}_{limb[1]}"} <= joints.keys():
                lacking[side] = name
            elif f"{side}_{limb[2]}" not in joints:
                lacking[side] = tip
        if len(set(lacking.values())) == 1 and len(lacking) == 2:
            missing.append({"foot": "feet"}.get(lacking["left"], f"{lacking['left']}s"))
        else:
            missing += [f"{side} {part}" for side, part in lacking.items()]
    return missing


def is_proportioned(skeleton: Skeleton, joints: Mapping[str, int]) -> bool:
    """Whether the bones between the canonical ``joints`` are as long to one another as a person's."""
    length = np.linalg.norm(skeleton.offsets.astype(float), axis=1)

    def along(top: int, bottom: int) -> float:
        return float(length[shape.path(skeleton, top, bottom)[1:]].sum())

    head = joints.get("head", joints.get("neck", 0))
    sizes: dict[str, list[float]] = {"upper": [], "fore": [], "thigh": [], "shin": [], "trunk": [along(0, head)]}
    for side in SIDES:
        for (a, b, c), (upper, lower) in ((ARM, ("upper", "fore")), (LEG, ("thigh", "shin"))):
            if _has(joints, side, (a, b, c)):
                sizes[upper].append(along(joints[f"{side}_{a}"], joints[f"{side}_{b}"]))
                sizes[lower].append(along(joints[f"{side}_{b}"], joints[f"{side}_{c}"]))
    mean = {name: float(np.mean(values)) if values else 0.0 for name, values in sizes.items()}
    arm, leg = mean["upper"] + mean["fore"], mean["thigh"] + mean["shin"]
    ratios = {
        "arm to leg": (arm, leg),
        "trunk to leg": (mean["trunk"], leg),
        "shin to thigh": (mean["shin"], mean["thigh"]),
        "fore to upper": (mean["fore"], mean["upper"]),
    }
    return all(
        low * of <= value <= high * of and of > 0
        for name, (value, of) in ratios.items()
        for low, high in [_RATIOS[name]]
    )


def is_on_all_fours(skeleton: Skeleton, joints: Mapping[str, int]) -> bool:
    """Whether arms and legs hang down side by side at rest, and the trunk lies across them."""
    places = np.zeros((skeleton.n_joints, 3))
    for joint, parent in enumerate(skeleton.parents):
        if parent >= 0:
            places[joint] = places[parent] + skeleton.offsets[joint]

    limbs = [(joints[f"{side}_{top}"], joints[f"{side}_{tip}"]) for side in SIDES for top, _, tip in (ARM, LEG)]
    down = np.array([_unit(places[tip] - places[top]) for top, tip in limbs])
    shoulders, hips = (np.mean([places[joints[f"{s}_{p}"]] for s in SIDES], axis=0) for p in ("shoulder", "hip"))
    across = abs(_unit(shoulders - hips) @ _unit(down.sum(axis=0)))
    return bool((down @ down.T).min() > _SIDE_BY_SIDE and across < _ACROSS)


def _unit(vector: np.ndarray) -> np.ndarray:
    return vector / max(float(np.linalg.norm(vector)), 1e-9)


def has_many_limbs(skeleton: Skeleton) -> bool:
    """Whether more long chains end in a tip than a person has limbs and heads."""
    below = shape.reach(skeleton)
    length = np.linalg.norm(skeleton.offsets.astype(float), axis=1)
    reaches = length + below
    long = [j for j in range(1, skeleton.n_joints) if _is_long(skeleton, j, reaches, below[0])]
    branches = Counter(skeleton.parents[joint] for joint in long)
    return 1 + sum(count - 1 for count in branches.values()) > _MOST_CHAINS


def _is_long(skeleton: Skeleton, joint: int, reach: np.ndarray, body: float) -> bool:
    """Whether a limb may begin at a joint: three joints one behind the other, and a fifth of the body's reach."""
    bends = any(skeleton.children(j) for j in skeleton.children(joint))
    return bool(reach[joint] > 0.2 * body) and bends


def _has(joints: Mapping[str, int], side: str, limb: Iterable[str]) -> bool:
    return all(f"{side}_{part}" in joints for part in limb)
