"""Units of length: their names, and which one a file is in that does not say it, from the size of the body."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.errors import ParameterError
from core.mocap.anatomy import find_anatomy
from core.mocap.skeleton import Skeleton

UNITS = {
    "m": (1.0, "metres"),
    "dm": (0.1, "decimetres"),
    "cm": (0.01, "centimetres"),
    "mm": (0.001, "millimetres"),
    "in": (0.0254, "inches"),
    "ft": (0.3048, "feet"),
    "cmu": (0.0254 / 0.45, "CMU's unit"),  # an inch divided by 0.45
}
"""Name -> metres, and the name in words."""

_GUESSED = ("m", "dm", "cmu", "in", "cm", "mm")
_TYPICAL, _RARER = 1.7, 1.5  # metres: of units that come near it, the nearest; giants are rarer than children
HEIGHTS = (1.2, 2.15)  # metres that people are tall, from a child of six or seven
# Of what is no person, by the longest way along the bones, in units.
_SPANS = {"m": (1.0, 4.5), "cmu": (20.0, 75.0), "in": (75.0, 130.0), "cm": (130.0, 450.0), "mm": (1300.0, 4500.0)}
SPANS = (0.9, 4.5)  # metres from tip to tip that a body may have, with room for parts of a body and for giants
LONGEST_BONE = 1.2  # metres


class UnitGuess(NamedTuple):
    """A unit (of UNITS), metres per unit, and the sentence that says what was taken and why."""

    name: str
    metres: float
    words: str


def metres_of(unit: str) -> float | None:
    """Metres per unit of the name ``unit``, or of a number of metres; None for "auto". Raises ParameterError."""
    word = unit.strip().lower()
    if word == "auto":
        return None
    if word in UNITS:
        return UNITS[word][0]
    try:
        metres = float(word)
    except ValueError:
        metres = 0.0
    if not 1e-6 <= metres <= 1000:
        raise ParameterError(f"unit {unit!r}: expected one of {', '.join(UNITS)}, auto, or a number of metres")
    return metres


def name_of(metres: float) -> str:
    """The unit of this length as UNITS names it, else the number of metres."""
    return next((name for name, (known, _) in UNITS.items() if abs(known - metres) < 1e-3 * known), f"{metres:.6g}")


def in_words(metres: float) -> str:
    """The unit in words, with its length."""
    name = name_of(metres)
    return f"{UNITS[name][1]} ({metres:.6g} m)" if name in UNITS else f"units of {metres:.6g} m"


def span(parents: Sequence[int], offsets: np.ndarray) -> float:
    """Longest way along the bones between two joints (usually a hand and a foot), in the unit of ``offsets``.

    parents: of every joint, parents first, -1 for the root; offsets: (n_joints, 3). Does not depend on the pose.
    """
    lengths = np.linalg.norm(offsets, axis=1)
    depth, longest = np.zeros(len(lengths)), 0.0
    for j in range(len(lengths) - 1, 0, -1):
        way, parent = depth[j] + lengths[j], parents[j]
        longest = max(longest, way + depth[parent])
        depth[parent] = max(depth[parent], way)
    return float(longest)


def guess_unit(skeleton: Skeleton) -> UnitGuess:
    """The unit in which a skeleton, whose offsets are in the file's unit, has the size of a person.

    By the height of the body where one is recognised; of anything else by the longest way along its bones.
    """
    anatomy = find_anatomy(skeleton)
    if anatomy.body != "other" and anatomy.body_height > 0:
        apart = {name: np.log(anatomy.body_height * UNITS[name][0] / _TYPICAL) for name in _GUESSED}
        name = min(apart, key=lambda unit: max(apart[unit] * _RARER, -apart[unit]))
        metres = UNITS[name][0]
        height = anatomy.body_height * metres
        return UnitGuess(name, metres, f"taken as {in_words(metres)}, for a body of {height:.2f} m")
    length = max(span(skeleton.parents, skeleton.offsets), 1e-9)
    bone = float(np.linalg.norm(skeleton.offsets, axis=1).max())
    # The span decides; where it is near two units, a bone longer than any in one of them speaks for the other.
    doubt = {
        name: max(low / length, length / high, bone * UNITS[name][0] / LONGEST_BONE, 1.0)
        for name, (low, high) in _SPANS.items()
    }
    name = min(doubt, key=lambda unit: doubt[unit])
    metres = UNITS[name][0]
    return UnitGuess(name, metres, f"taken as {in_words(metres)}, for a span of {length * metres:.2f} m")


def height_doubt(skeleton: Skeleton) -> str:
    """What is to be said of a body, in metres, of a height that few people have; empty where all is well."""
    anatomy = find_anatomy(skeleton)
    height, taken = anatomy.body_height, skeleton.unit
    if anatomy.body == "other" or HEIGHTS[0] <= height <= HEIGHTS[1]:
        return ""
    others = {UNITS[name][1]: metres for name, metres in other_heights(skeleton).items()}
    also = "".join(f"; in {words} it would be {metres:.2f} m" for words, metres in others.items())
    return f"the body is {height:.2f} m tall in {in_words(taken)}{also}: check the unit"


def other_heights(skeleton: Skeleton) -> dict[str, float]:
    """Units (names of UNITS) other than the skeleton's own in which its body may be a person's -> height in metres."""
    anatomy, own = find_anatomy(skeleton), skeleton.unit
    heights = {name: anatomy.body_height / own * UNITS[name][0] for name in _GUESSED if anatomy.body != "other"}
    return {
        name: height
        for name, height in heights.items()
        if abs(UNITS[name][0] - own) > 1e-3 * own and 0.75 < height < 2.7
    }
