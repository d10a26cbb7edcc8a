"""Joint names of the common rigs, and how to read a side and a body part out of them.

Covered: CMU ASF and BVH, Bandai-Namco, Character Creator (``CC_Base_*``), Mixamo, SMPL, LAFAN, Biped, Unreal, Daz and
Genesis, Xsens, OptiTrack, Advanced Skeleton, robots, MikuMikuDance.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Sequence
from typing import NamedTuple

# Per limb, from the trunk outwards: canonical joint -> names, best first. A name that serves two joints ("shoulder",
# "leg", "foot") stands last in one list, so that the better name is taken where both are present.
LIMB_NAMES: dict[str, dict[str, tuple[str, ...]]] = {
    "leg": {
        "hip": ("upleg", "upperleg", "uleg", "thigh", "femur", "legupper", "hip", "足"),
        "knee": ("lowerleg", "lowleg", "loleg", "calf", "tibia", "shin", "shank", "knee", "leglower", "ひざ", "leg"),
        "ankle": ("ankle", "foot", "talus", "足首"),
        "toe": ("toebase", "toes", "toe", "ball", "forefoot", "foot", "つま先"),
    },
    "arm": {
        "clavicle": ("clavicle", "collar", "collarbone", "clav", "scapula", "shoulder", "肩"),
        "shoulder": ("upperarm", "uparm", "uarm", "humerus", "armupper", "shldr", "arm", "shoulder", "腕"),
        "elbow": (
            "forearm",
            "lowerarm",
            "lowarm",
            "loarm",
            "farm",
            "larm",
            "ulna",
            "radius",
            "elbow",
            "armlower",
            "ひじ",
        ),
        "wrist": ("wrist", "hand", "手首"),
    },
}
# The order in which a limb's joints choose among shared names.
CHOOSING_ORDER = {"leg": ("hip", "knee", "ankle", "toe"), "arm": ("shoulder", "elbow", "wrist", "clavicle")}
TRUNK_NAMES = {
    "neck": ("neck", "lowerneck", "necklower", "necktwist", "neckbase", "首"),
    "head": ("head", "skull", "頭"),
}

_PREFIXES = {"cc", "base", "joint", "jnt", "bip", "mixamorig", "def", "bone", "avg", "m", "f", "character", "bn", "j"}
# Words that say nothing of the part; a name without them goes first.
_QUALIFIERS = {"bend", "jnt", "joint", "bone", "link", "bind", "skin", "jt", "pitch", "roll", "yaw", "m", "c", "mid"}
_FEWEST, _SHARED = 8, 0.6  # joints, and the share of them that begin with a word that then means nothing
_LEFT, _RIGHT = {"l", "left", "lft", "lf"}, {"r", "right", "rgt", "rt"}
_TOKEN = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_a-zA-Z]+")
_SHORT = re.compile(r"(?<![A-Za-z])([LR])([UF])(Arm|Leg)(?![a-z])")  # LUArm: left upper arm
_KNOWN = {name for limb in LIMB_NAMES.values() for names in limb.values() for name in names} | {
    *("hipjoint", "thumb", "fingers", "fingerbase", "hand", "foot")
}


_THIGHS, _SHINS = LIMB_NAMES["leg"]["hip"], LIMB_NAMES["leg"]["knee"][:-1]


def with_thigh(first: dict[str, int], legs: int = 1) -> dict[str, int]:
    """Parts of one side -> joints, in which a ``leg`` is the thigh where nothing else is and it stands above a shin
    (``LeftLeg``, ``LeftShin``, as in SOMA) or another leg (``leg1``, ``leg2``). legs: how many joints are called so."""
    shins = any(name in first for name in _SHINS)
    if "leg" in first and (shins or legs > 1) and not any(name in first for name in _THIGHS):
        return {"thigh" if name == "leg" else name: joint for name, joint in first.items()}
    return first


class ParsedName(NamedTuple):
    """A joint name taken apart: side (``left``, ``right`` or ``centre``) and part in small letters, digits dropped."""

    side: str
    part: str


def parse_names(names: Sequence[str]) -> list[ParsedName]:
    """:func:`parse_name` of all joints of a skeleton, without words that most of them begin with."""
    means_nothing: set[str] = set(_PREFIXES)
    while len(names) >= _FEWEST:
        left = (_without_first(_words(name), means_nothing) for name in names)
        first = Counter(words[0] for words in left if len(words) > 1)
        word, count = first.most_common(1)[0] if first else ("", 0)
        if count <= _SHARED * len(names) or word in _LEFT | _RIGHT | _KNOWN:
            break
        means_nothing.add(word)
    return [parse_name(name, means_nothing) for name in names]


def _without_first(words: list[str], means_nothing: Collection[str]) -> list[str]:
    """Words without numbers, and without those in front that mean nothing, but for the last."""
    words = [word for word in words if not word.isdigit()]
    while len(words) > 1 and words[0] in means_nothing:
        words = words[1:]
    return words


def parse_name(name: str, means_nothing: Collection[str] = _PREFIXES) -> ParsedName:
    """Side and body part of a joint name, whatever its prefix, suffix, separators and case.

    ``mixamorig:LeftUpLeg``, ``CC_Base_L_Thigh``, ``thigh.L`` and ``lfemur`` are all on the left. means_nothing: words
    that are left out in front.
    """
    words = _without_first(_words(name), means_nothing)
    side, part = _side_and_part(words)
    if part not in _KNOWN:
        side, part = _side_and_part([word for word in words if word not in _QUALIFIERS] or words)
    return ParsedName(side, part)


def _side_and_part(words: list[str]) -> tuple[str, str]:
    """The side that one of the words or the beginning of all names, and what is left of them."""
    for side, marks in (("left", _LEFT), ("right", _RIGHT)):
        marked = next((k for k, w in enumerate(words) if w in marks), None)
        if marked is not None:
            return side, "".join(words[:marked] + words[marked + 1 :])
    part = "".join(words)
    for side, prefixes in (("left", ("left", "l", "左")), ("right", ("right", "r", "右"))):
        for mark in prefixes:
            if part.startswith(mark) and part[len(mark) :] in _KNOWN:
                return side, part[len(mark) :]
    return "centre", part


def is_qualified(name: str) -> bool:
    """Whether a name says more than side and part, so that one that does not is to be preferred."""
    return name.startswith("_") or bool(_QUALIFIERS.intersection(_words(name)[1:]))


def _words(name: str) -> list[str]:
    """The words of a joint name in small letters, without what stands before a colon."""
    return [token.lower() for token in _TOKEN.findall(_SHORT.sub(r"\1_\2\3", name.rsplit(":", 1)[-1]))]
