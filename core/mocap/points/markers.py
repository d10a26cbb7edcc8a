"""Markers on the skin become joints: the common marker sets, and published regressions for what lies inside.

Known sets: Plug-in Gait (Vicon), Helen Hayes, and CMU's 41 markers; names of another set are added to ALIASES. Joints
that the file has itself (the segments that Plug-in Gait computes) come first.

Sources: hip centre from the width and depth of the pelvis, Harrington et al. 2007, Journal of Biomechanics 40, 595-602
(regressions on these two alone); shoulder centre .17 of the distance between the acromia below the acromion, Rab,
Petuskey and Bagley 2002, Gait and Posture 15, 57-63; knee and ankle between their epicondyles or malleoli where both
are marked, Wu et al. 2002, Journal of Biomechanics 35, 543-548, else half a joint's width inwards, across the thigh
and the shank, as in Davis et al. 1991, Human Movement Science 10, 575-587.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from core.mocap.points.cleaning import median_of
from core.mocap.points.naming import plain
from core.mocap.points.presets import SIDES

ALIASES: dict[str, tuple[str, ...]] = {
    "asi": ("fwt", "asis", "asisl", "asisr", "ias"),
    "psi": ("bwt", "psis", "psisl", "psisr", "ips"),
    "sho": ("ac", "acr", "acromion", "acromium", "shoulder", "shd", "acg", "acd"),
    "kne": ("knee", "kneelat", "lkne", "fle", "lek"),
    "mkne": ("kneemed", "knem", "kneem", "medknee", "fme", "mek", "knemed"),
    "ank": ("ankle", "anklelat", "fal", "lat"),
    "mank": ("anklemed", "ankm", "anklem", "med", "medankle", "tam", "ankmed"),
    "toe": ("toetip", "mt2", "toelat", "to2", "sec", "fm2"),
    "hee": ("heel", "calc", "fcc"),
    "elb": ("elbow", "elblat", "elbowlat", "hle"),
    "melb": ("elbm", "elbmed", "elbowmed", "hme"),
    "wra": ("wristmed", "wrmed", "wri", "wrist", "rsp"),
    "wrb": ("wristlat", "wrlat", "usp"),
    "fin": ("fing", "finger", "hand"),
    "fhd": ("headfront",),
    "bhd": ("headback",),
}
"""Name of a marker in Plug-in Gait, without its side -> what other sets call it, in small letters."""
_CENTRE = {
    "c7": ("c7", "cv7"),
    "t10": ("t10", "tv10"),
    "clav": ("clav", "ij", "jugularnotch", "stertop"),
    "strn": ("strn", "px", "xiphoid", "xiph", "xyp"),
    "sacr": ("sacr", "vsacral", "sacral", "sacrum", "vsac"),
    "head": ("tophead", "headtop", "tophd", "vtophead", "head"),
}
_OWN = {  # segments that Plug-in Gait computes: their origin (O) or upper end (P)
    "pelo": "pelvis_own",
    "trxo": "chest",
    "hedo": "head",
}
_OWN_SIDED = {
    "fep": "hip",
    "feo": "knee",
    "tio": "ankle",
    "foo": "toe",
    "clo": "shoulder",
    "huo": "elbow",
    "rao": "wrist",
    "hno": "hand",
}
_KNEE_WIDTH, _ANKLE_WIDTH = 0.10, 0.07  # metres, of adults; the markers' own radius lies within
_LEAST = 6  # joints that have to come of it

Markers = Mapping[str, np.ndarray]


def marker_names(names: Sequence[str]) -> dict[str, int]:
    """Marker of a known set (``left_asi``, ``c7``) -> index among ``names``."""
    found: dict[str, int] = {}
    for k, name in enumerate(names):
        short = plain(name)
        for centre, words in _CENTRE.items():
            if short in words:
                found.setdefault(centre, k)
        for side in SIDES:
            for base in _without_side(short, side):
                for marker, words in ALIASES.items():
                    if base == marker or base in words:
                        found.setdefault(f"{side}_{marker}", k)
                if base in _OWN_SIDED:
                    found.setdefault(f"{side}_own_{base}", k)
        if short in _OWN:
            found.setdefault(_OWN[short], k) if short == "pelo" else found.setdefault(f"own_{short}", k)
    return found


def _without_side(short: str, side: str) -> list[str]:
    """What a name is without the mark of this side: ``lasi`` and ``asisl`` without their ``l``; nothing without one."""
    return [
        *(short[len(mark) :] for mark in (side, side[0]) if short.startswith(mark)),
        *(short[: -len(mark)] for mark in (side, side[0]) if short.endswith(mark)),
    ]


def joints_of_markers(names: Sequence[str], values: np.ndarray, unit: float) -> dict[str, np.ndarray]:
    """Role -> positions ``(n_frames, 3)`` of the joints that the markers ``values`` (n_frames, n_points, 3) speak for.

    unit: metres per unit of the values. Empty where the markers are no known set.
    """
    index = marker_names(names)
    at = {name: values[:, k] for name, k in index.items()}
    joints = _own_joints(at)
    if len(joints) < _LEAST:
        joints = _lower_body(at, unit) | _upper_body(at)
    if "left_hip" in joints and "right_hip" in joints:
        joints.setdefault("pelvis", (joints["left_hip"] + joints["right_hip"]) / 2)
    if "pelvis" not in joints and {"left_asi", "right_asi"} <= at.keys():
        joints["pelvis"] = _mean(at, "left_asi", "right_asi", "left_psi", "right_psi", "sacr")
    return joints if len(joints) >= _LEAST and "pelvis" in joints else {}


def _own_joints(at: Markers) -> dict[str, np.ndarray]:
    joints = {
        f"{side}_{role}": at[f"{side}_own_{k}"]
        for side in SIDES
        for k, role in _OWN_SIDED.items()
        if f"{side}_own_{k}" in at
    }
    if len(joints) < _LEAST:
        return {}
    joints |= {_OWN[k]: at[f"own_{k}"] for k in ("trxo", "hedo") if f"own_{k}" in at}
    if {"left_fhd", "right_fhd", "left_bhd", "right_bhd"} <= at.keys():
        joints["head"] = _mean(at, "left_fhd", "right_fhd", "left_bhd", "right_bhd")
    return joints


def _lower_body(at: Markers, unit: float) -> dict[str, np.ndarray]:
    joints: dict[str, np.ndarray] = {}
    if {"left_asi", "right_asi"} <= at.keys() and ("sacr" in at or {"left_psi", "right_psi"} <= at.keys()):
        joints |= _hips(at, unit)
    right = _unit_vectors(joints["right_hip"] - joints["left_hip"]) if joints else None
    for side in SIDES:
        if right is None:
            break
        inwards = right if side == "left" else -right
        above = joints[f"{side}_hip"]
        for part, marker, inner, width in (
            ("knee", "kne", "mkne", _KNEE_WIDTH),
            ("ankle", "ank", "mank", _ANKLE_WIDTH),
        ):
            if f"{side}_{marker}" not in at:
                break
            outer = at[f"{side}_{marker}"]
            if f"{side}_{inner}" in at:
                above = (outer + at[f"{side}_{inner}"]) / 2
            else:
                bone = _unit_vectors(outer - above)
                across = _unit_vectors(inwards - (inwards * bone).sum(1, keepdims=True) * bone)
                above = outer + across * (width / 2 / unit)
            joints[f"{side}_{part}"] = above
        joints |= {
            f"{side}_{r}": at[f"{side}_{m}"] for r, m in (("toe", "toe"), ("heel", "hee")) if f"{side}_{m}" in at
        }
    return joints


def _hips(at: Markers, unit: float) -> dict[str, np.ndarray]:
    """Hip centres after Harrington et al. 2007: the origin lies between the front spines; x forward, y up, z right."""
    left, right = at["left_asi"], at["right_asi"]
    back = at["sacr"] if "sacr" in at else (at["left_psi"] + at["right_psi"]) / 2
    front = (left + right) / 2
    z = _unit_vectors(right - left)
    x = front - back
    x = _unit_vectors(x - (x * z).sum(1, keepdims=True) * z)
    y = np.cross(z, x)
    width = median_of(np.linalg.norm(right - left, axis=1)) * unit * 1000
    depth = median_of(np.linalg.norm(front - back, axis=1)) * unit * 1000
    forward, up, out = (v / 1000 / unit for v in (-0.24 * depth - 9.9, -0.30 * width - 10.9, 0.33 * width + 7.3))
    middle = front + x * forward + y * up
    return {"left_hip": middle - z * out, "right_hip": middle + z * out}


def _upper_body(at: Markers) -> dict[str, np.ndarray]:
    joints: dict[str, np.ndarray] = {}
    trunk = [name for name in ("c7", "clav") if name in at]
    if trunk:
        joints["chest"] = _mean(at, *trunk)
    if {"t10", "strn"} & at.keys():
        joints["spine"] = _mean(at, "t10", "strn")
    if any(name in at for name in ("left_fhd", "right_fhd", "left_bhd", "right_bhd")):
        joints["head"] = _mean(at, "left_fhd", "right_fhd", "left_bhd", "right_bhd")
    elif "head" in at:
        joints["head"] = at["head"]
    if {"left_sho", "right_sho"} <= at.keys():
        apart = np.linalg.norm(at["left_sho"] - at["right_sho"], axis=1)
        down = _downwards(at, joints)
        for side in SIDES:
            joints[f"{side}_shoulder"] = at[f"{side}_sho"] + down * 0.17 * median_of(apart)
        joints.setdefault("chest", (at["left_sho"] + at["right_sho"]) / 2)
    for side in SIDES:
        for role, markers in (("elbow", ("elb", "melb")), ("wrist", ("wra", "wrb")), ("hand", ("fin",))):
            there = [f"{side}_{m}" for m in markers if f"{side}_{m}" in at]
            if there and f"{side}_shoulder" in joints:
                joints[f"{side}_{role}"] = _mean(at, *there)
    return joints


def _downwards(at: Markers, joints: Mapping[str, np.ndarray]) -> np.ndarray:
    """Unit vectors ``(n, 3)`` down along the trunk, from the shoulders to the spine or the pelvis."""
    top = (at["left_sho"] + at["right_sho"]) / 2
    low = [name for name in ("left_asi", "right_asi", "left_psi", "right_psi", "sacr") if name in at]
    bottom = _mean(at, *low) if low else joints.get("spine", top - np.array([0.0, 1.0, 0.0]))
    return _unit_vectors(bottom - top)


def _mean(at: Markers, *names: str) -> np.ndarray:
    return np.asarray(np.mean([at[name] for name in names if name in at], axis=0))


def _unit_vectors(v: np.ndarray) -> np.ndarray:
    unit: np.ndarray = v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-9)
    return unit
