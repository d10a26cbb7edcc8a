"""The body in parts: the hierarchy of eighteen nodes of PCR section 3.1 (its Figure 2), and weights over its leaves."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

from core.errors import ParameterError
from core.mocap.anatomy import Anatomy

LEAVES: tuple[str, ...] = (
    *("head", "torso"),
    *(f"{side}_{part}" for side in ("left", "right") for part in ("arm", "hand", "leg", "foot")),
)
"""The ten basic parts (level 4). An arm is collar bone to elbow, a hand the wrist and below, a leg hip and knee, a foot
ankle and toes."""

CHILDREN: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "whole_body": ("upper_body", "lower_body"),
        "upper_body": ("head_torso", "left_arm_hand", "right_arm_hand"),
        "lower_body": ("left_leg_foot", "right_leg_foot"),
        "head_torso": ("head", "torso"),
        "left_arm_hand": ("left_arm", "left_hand"),
        "right_arm_hand": ("right_arm", "right_hand"),
        "left_leg_foot": ("left_leg", "left_foot"),
        "right_leg_foot": ("right_leg", "right_foot"),
    }
    | {leaf: () for leaf in LEAVES}
)
"""Node -> the nodes below it."""

NODES: tuple[str, ...] = tuple(CHILDREN)
"""All eighteen, parents before children: the whole body, two halves, five limbs and trunk, ten leaves."""

PARENT: Mapping[str, str | None] = MappingProxyType(
    {"whole_body": None} | {child: node for node, children in CHILDREN.items() for child in children}
)
LEVEL: Mapping[str, int] = MappingProxyType(
    {n: 4 if n in LEAVES else 1 if n == "whole_body" else 2 if n in CHILDREN["whole_body"] else 3 for n in NODES}
)
"""Level of a node as the paper counts: 1 the whole body, 4 the leaves."""

_JOINTS = {
    "head": ("neck", "head"),
    "torso": ("spine", "chest"),
    "arm": ("clavicle", "shoulder", "elbow"),
    "hand": ("wrist",),
    "leg": ("hip", "knee"),
    "foot": ("ankle", "toe"),
}


def leaves_of(node: str) -> tuple[str, ...]:
    """The leaves at or below a node, in the order of :data:`LEAVES`. Raises ParameterError for an unknown node."""
    if node not in CHILDREN:
        raise ParameterError(f"{str(node)[:60]!r} is no part of the body; the parts are {', '.join(NODES)}")
    below = {node} if node in LEAVES else {leaf for child in CHILDREN[node] for leaf in leaves_of(child)}
    return tuple(leaf for leaf in LEAVES if leaf in below)


def leaf_of(canonical: str) -> str | None:
    """The leaf that a canonical joint (core.mocap.anatomy) belongs to; None for the pelvis, which is the root's."""
    side, _, name = canonical.rpartition("_")
    part = next((part for part, names in _JOINTS.items() if name in names), None)
    return f"{side}_{part}" if side and part else part


def part_joints(anatomy: Anatomy) -> dict[str, tuple[int, ...]]:
    """Leaf -> indices of its posture joints, ascending; empty where the skeleton lacks the part.

    A posture joint without a canonical name goes with the next named joint below it (a second spine joint with the
    chest). Where no body is recognised all joints are the torso's.
    """
    parents = anatomy.skeleton.parents
    owner = {joint: leaf for name, joint in anatomy.joints.items() if (leaf := leaf_of(name))}
    for joint in list(owner):
        above = parents[joint]
        while above > 0 and above not in owner:
            owner[above] = owner[joint]
            above = parents[above]
    joints_of: dict[str, list[int]] = {leaf: [] for leaf in LEAVES}
    for joint in anatomy.posture_joints:
        joints_of[owner.get(joint, "torso")].append(joint)
    return {leaf: tuple(joints) for leaf, joints in joints_of.items()}


def normalise_weights(weights: Mapping[str, float]) -> dict[str, float]:
    """Weights of nodes or leaves as weights of the ten leaves that sum to 1 (PCR section 4).

    The weight of a node is shared evenly by its leaves; a leaf that is named itself as well gets both. Raises
    ParameterError, in plain words, for an unknown part, a weight that is negative or no number, or where all are zero.
    """
    shares = dict.fromkeys(LEAVES, 0.0)
    for node, weight in weights.items():
        leaves = leaves_of(node)
        if isinstance(weight, bool) or not isinstance(weight, int | float) or not math.isfinite(weight) or weight < 0:
            raise ParameterError(
                f"{node}: the weight of a part must be zero or a positive number, not {str(weight)[:40]!r}"
            )
        for leaf in leaves:
            shares[leaf] += weight / len(leaves)
    total = sum(shares.values())
    if not 0 < total < math.inf:
        raise ParameterError("all weights are zero; give at least one part of the body a positive weight")
    return {leaf: share / total for leaf, share in shares.items()}


def _preset(**nodes: float) -> Mapping[str, float]:
    return MappingProxyType(normalise_weights(nodes))


PRESETS: Mapping[str, Mapping[str, float]] = MappingProxyType(
    {
        "whole body": MappingProxyType(dict.fromkeys(LEAVES, 1 / len(LEAVES))),
        "upper body": _preset(**dict.fromkeys(leaves_of("upper_body"), 1.0)),
        "lower body": _preset(lower_body=1),
        "head and torso": _preset(head_torso=1),
        "arms": _preset(left_arm_hand=1, right_arm_hand=1),
        "left arm": _preset(left_arm_hand=1),
        "right arm": _preset(right_arm_hand=1),
        "legs": _preset(left_leg_foot=1, right_leg_foot=1),
        "left leg": _preset(left_leg_foot=1),
        "right leg": _preset(right_leg_foot=1),
        "arms and legs (35 / 45 / 20)": _preset(left_arm_hand=0.35, right_arm_hand=0.45, lower_body=0.2),
    }
)
"""Ready-made weights over the leaves, each summing to 1; the last is the paper's example (section 4)."""
