"""Joint names of the common rigs, and how to read a side and a body part out of them.

Covered: CMU ASF and BVH, Bandai-Namco, Character Creator (``CC_Base_*``), Mixamo, SMPL, LAFAN, Biped, Unreal, Daz.
"""

from __future__ import annotations

import re
from typing import NamedTuple

# Per limb, from the trunk outwards: canonical joint -> names, best first. A name that serves two joints ("shoulder",
# "leg", "foot") stands last in one list, so that the better name is taken where both are present.
LIMB_NAMES: dict[str, dict[str, tuple[str, ...]]] = {
    "leg": {
        "hip": ("upleg", "upperleg", "thigh", "femur", "legupper", "hip"),
        "knee": ("lowerleg", "lowleg", "loleg", "calf", "tibia", "shin", "knee", "leglower", "leg"),
        "ankle": ("ankle", "foot"),
        "toe": ("toebase", "toes", "toe", "ball", "forefoot", "foot"),
    },
    "arm": {
        "clavicle": ("clavicle", "collar", "collarbone", "clav", "shoulder"),
        "shoulder": ("upperarm", "uparm", "humerus", "armupper", "shldr", "arm", "shoulder"),
        "elbow": ("forearm", "lowerarm", "lowarm", "loarm", "radius", "elbow", "armlower"),
        "wrist": ("wrist", "hand"),
    },
}
# The order in which a limb's joints choose among shared names.
CHOOSING_ORDER = {"leg": ("hip", "knee", "ankle", "toe"), "arm": ("shoulder", "elbow", "wrist", "clavicle")}
TRUNK_NAMES = {"neck": ("neck", "lowerneck", "necktwist", "neckbase"), "head": ("head", "skull")}

_PREFIXES = {"cc", "base", "joint", "jnt", "bip", "mixamorig", "def", "bone", "avg", "m", "f", "character", "bn", "j"}
_LEFT, _RIGHT = {"l", "left", "lft", "lf"}, {"r", "right", "rgt", "rt"}
_TOKEN = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_KNOWN = {name for limb in LIMB_NAMES.values() for names in limb.values() for name in names} | {
    *("hipjoint", "thumb", "fingers", "fingerbase", "hand", "foot")
}


_THIGHS, _SHINS = LIMB_NAMES["leg"]["hip"], LIMB_NAMES["leg"]["knee"][:-1]


def with_thigh(first: dict[str, int]) -> dict[str, int]:
    """Parts of one side -> joints, in which a ``leg`` above a shin is the thigh where nothing else is (``LeftLeg``,
    ``LeftShin``, as in SOMA)."""
    if "leg" in first and any(name in first for name in _SHINS) and not any(name in first for name in _THIGHS):
        return {"thigh" if name == "leg" else name: joint for name, joint in first.items()}
    return first


class ParsedName(NamedTuple):
    """A joint name taken apart: side (``left``, ``right`` or ``centre``) and part in small letters, digits dropped."""

    side: str
    part: str


def parse_name(name: str) -> ParsedName:
    """Side and body part of a joint name, whatever its prefix, suffix, separators and case.

    ``mixamorig:LeftUpLeg``, ``CC_Base_L_Thigh``, ``thigh.L`` and ``lfemur`` are all on the left.
    """
    tokens = [t.lower() for t in _TOKEN.findall(name.rsplit(":", 1)[-1])]
    words = [t for t in tokens if not t.isdigit()]
    while len(words) > 1 and words[0] in _PREFIXES:
        words = words[1:]
    for side, marks in (("left", _LEFT), ("right", _RIGHT)):
        marked = next((k for k, w in enumerate(words) if w in marks), None)
        if marked is not None:
            return ParsedName(side, "".join(words[:marked] + words[marked + 1 :]))
    part = "".join(words)
    for side, prefixes in (("left", ("left", "l")), ("right", ("right", "r"))):
        for mark in prefixes:
            if part.startswith(mark) and part[len(mark) :] in _KNOWN:
                return ParsedName(side, part[len(mark) :])
    return ParsedName("centre", part)
