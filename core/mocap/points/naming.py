"""Which point is which part of the body: by a preset's list, or by names that mean something."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from core.errors import ParameterError
from core.mocap.anatomy_names import CHOOSING_ORDER, LIMB_NAMES, parse_name, with_thigh
from core.mocap.points.cleaning import median_of
from core.mocap.points.presets import PRESETS, SIDES, Preset

Parts = dict[str, tuple[int, ...]]
_KNOWN_SHARE = 0.7  # of a preset's names that make a list that preset
_PELVIS = ("pelvis", "hips", "hip", "midhip", "hipcenter", "hipcentre", "spinebase", "root", "pelviscentre")
_CHEST = ("chest", "thorax", "spineshoulder", "shouldercenter", "shouldercentre", "upperchest", "sternum", "torso")
_SPINE = ("spine", "spinemid", "lowerback", "upperback", "back", "abdomen", "belly", "waist", "lumbar")
_NECK, _HEAD = ("neck", "lowerneck", "upperneck", "neckbase"), ("head", "skull", "headcentre", "headcenter")
_TOP = ("headtop", "headend", "topofhead", "crown", "vertex")
_SINGLE = {"nose": "nose", "jaw": "jaw"}
_PAIRED = {"eye": "eye", "ear": "ear", "heel": "heel", "thumb": "thumb", "handtip": "hand_tip", "smalltoe": "small_toe"}
_JOINT_CENTRES = {"hjc": "hip", "kjc": "knee", "ajc": "ankle", "sjc": "shoulder", "ejc": "elbow", "wjc": "wrist"}


def plain(name: str) -> str:
    """A name in small letters without anything but letters and digits."""
    return re.sub(r"[^a-z0-9]", "", name.lower())


def preset_called(name: str) -> Preset:
    """The preset that ``--points`` names. Raises ParameterError."""
    found = PRESETS.get(name.strip().lower())
    if found is None:
        raise ParameterError(f"points {name!r}: expected one of {', '.join(PRESETS)}, or auto")
    return found


def parts_of_preset(preset: Preset, names: Sequence[str] | None = None) -> Parts:
    """Role -> indices of points, in the preset's own order or among points called ``names``."""
    index = {plain(name): k for k, name in enumerate(preset.points if names is None else names)}
    found = {role: tuple(index.get(plain(s), -1) for s in sources) for role, sources in preset.parts.items()}
    return {role: which for role, which in found.items() if min(which) >= 0}


def preset_of_names(names: Sequence[str]) -> Preset | None:
    """The preset that has most of these names; None where none has enough."""
    given = {plain(name) for name in names}
    best, share = None, 0.0
    for preset in PRESETS.values():
        own = {plain(point) for point in preset.points}
        agree = len(own & given) / len(own)
        if agree >= _KNOWN_SHARE and agree > share:
            best, share = preset, agree
    return best


def presets_of_count(count: int) -> list[str]:
    """Names of the presets with so many points."""
    return [name for name, preset in PRESETS.items() if len(preset.points) == count]


def likely_preset(values: np.ndarray) -> str:
    """Of the presets with as many points as ``values`` (n_frames, n_points, 3), the one whose bones fit best.

    Bones keep their lengths and are equally long on either side; empty where no preset has so many points.
    """
    names = presets_of_count(values.shape[1])
    return min(names, key=lambda name: _misfit(values, PRESETS[name]), default="")


def _misfit(values: np.ndarray, preset: Preset) -> float:
    parts = parts_of_preset(preset)
    step = max(1, len(values) // 200)
    at = {role: values[::step, list(which)].mean(axis=1) for role, which in parts.items()}
    bones = (("hip", "knee"), ("knee", "ankle"), ("shoulder", "elbow"), ("elbow", "wrist"))
    misfit = []
    for a, b in bones:
        lengths = [np.linalg.norm(at[f"{side}_{a}"] - at[f"{side}_{b}"], axis=1) for side in SIDES]
        middle = [median_of(length) for length in lengths]
        spread = [median_of(np.abs(length - m)) for length, m in zip(lengths, middle, strict=True)]
        misfit.append((sum(spread) + abs(middle[0] - middle[1])) / max(sum(middle), 1e-9))
    both = [median_of(np.linalg.norm(at[f"left_{p}"] - at[f"right_{p}"], axis=1)) for p in ("hip", "shoulder")]
    leg = median_of(np.linalg.norm(at["left_hip"] - at["left_ankle"], axis=1))
    wide = max(both) / max(leg, 1e-9)  # hips and shoulders are narrower than a leg is long
    return float(np.mean(misfit)) + max(0.0, wide - 0.8)


def parts_by_name(names: Sequence[str], values: np.ndarray) -> Parts:
    """Role -> points whose names say what they are (``LeftUpLeg``, ``lfemur``, ``knee_r``, ``RKJC``).

    values: (n_frames, n_points, 3); the spine's points are ordered from the pelvis upwards by where they are.
    """
    parsed = [parse_name(_joint_centre(name)) for name in names]
    parts: Parts = {}
    for side in SIDES:
        first: dict[str, int] = {}
        for k, (joint_side, part) in enumerate(parsed):
            if joint_side == side:
                first.setdefault(part, k)
        first = with_thigh(first)
        for limb, order in CHOOSING_ORDER.items():
            taken: set[int] = set()
            for part in order:
                found = next((first[n] for n in LIMB_NAMES[limb][part] if n in first and first[n] not in taken), None)
                if found is not None:
                    taken.add(found)
                    parts[f"{side}_{part}"] = (found,)
        parts |= {f"{side}_{role}": (first[part],) for part, role in _PAIRED.items() if part in first}
    return parts | _middle_parts(names, parsed, parts, values)


def _joint_centre(name: str) -> str:
    """``LKJC`` as ``left_knee``: the short names of joint centres in words."""
    short = plain(name)
    if short[1:] in _JOINT_CENTRES and short[:1] in "lr":
        return f"{'left' if short[0] == 'l' else 'right'}_{_JOINT_CENTRES[short[1:]]}"
    return name


def _middle_parts(names: Sequence[str], parsed: Sequence[tuple[str, str]], limbs: Parts, values: np.ndarray) -> Parts:
    centre: dict[str, list[int]] = {}
    for k, (side, part) in enumerate(parsed):
        if side == "centre":
            centre.setdefault(part, []).append(k)

    def first(words: Sequence[str]) -> tuple[int, ...]:
        return next(((centre[word][0],) for word in words if word in centre), ())

    parts: Parts = {}
    pairs = (("pelvis", _PELVIS, "hip"), ("chest", _CHEST, "shoulder"))
    for role, words, pair in pairs:
        both = [limbs.get(f"{side}_{pair}", ()) for side in SIDES]
        if found := first(words):
            parts[role] = found
        elif all(both):
            parts[role] = (*both[0], *both[1])
    parts |= {role: found for role, words in (("neck", _NECK), ("head_top", _TOP)) if (found := first(words))}
    ears = (*limbs.get("left_ear", ()), *limbs.get("right_ear", ()))
    if head := first(_HEAD) or (ears if len(ears) == 2 else ()):
        parts["head"] = head
    parts |= {role: (centre[word][0],) for word, role in _SINGLE.items() if word in centre}
    spine = [k for word in (*_SPINE, *_CHEST) for k in centre.get(word, ()) if (k,) != parts.get("pelvis")]
    return parts | _spine(spine, parts, first(_CHEST), values)


def _spine(points: list[int], parts: Parts, chest: tuple[int, ...], values: np.ndarray) -> Parts:
    """The points of the spine in their order from the pelvis: the first, one between, and the last as the chest."""
    if not points or "pelvis" not in parts:
        return {}
    middle = values[:, list(parts["pelvis"])].mean(axis=1)
    away = {k: median_of(np.linalg.norm(values[:, k] - middle, axis=1)) for k in points}
    order = sorted(dict.fromkeys(points), key=lambda k: away[k])
    found: Parts = {}
    if not chest and len(order) > 1:
        found["chest"] = (order.pop(),)
    else:
        order = [k for k in order if (k,) != chest and (not chest or away[k] < away[chest[0]])]
    if order:
        found["spine"] = (order[0],)
    if len(order) > 1:
        found["spine2"] = (order[-1],)
    return found
