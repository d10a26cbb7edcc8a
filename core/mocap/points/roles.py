"""Parts of a figure of points: what hangs from what, and where each bone points in a T-pose."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Role(NamedTuple):
    """A part of the body: the part it hangs from, and the way it lies from there in a T-pose.

    ``direction``: a vector of any length; Y up, the body faces Z, its left is X.
    """

    parent: str
    direction: tuple[float, float, float]


_CENTRE = {
    "pelvis": Role("", (0, 0, 0)),
    "spine": Role("pelvis", (0, 1, 0)),
    "spine2": Role("spine", (0, 1, 0)),
    "chest": Role("spine2", (0, 1, 0)),
    "neck": Role("chest", (0, 1, 0)),
    "head": Role("neck", (0, 1, 0)),
    "head_top": Role("head", (0, 1, 0)),
    "jaw": Role("head", (0, -0.3, 0.95)),
    "nose": Role("head", (0, 0, 1)),
}
_LEFT = {
    "hip": Role("pelvis", (0.85, -0.5, 0)),
    "knee": Role("hip", (0, -1, 0)),
    "ankle": Role("knee", (0, -1, 0)),
    "heel": Role("ankle", (0, -0.7, -0.7)),
    "toe": Role("ankle", (0, -0.4, 0.9)),
    "small_toe": Role("ankle", (0.4, -0.4, 0.8)),
    "toe_tip": Role("toe", (0, 0, 1)),
    "clavicle": Role("chest", (0.8, 0.6, 0)),
    "shoulder": Role("clavicle", (1, 0, 0)),
    "elbow": Role("shoulder", (1, 0, 0)),
    "wrist": Role("elbow", (1, 0, 0)),
    "hand": Role("wrist", (1, 0, 0)),
    "hand_tip": Role("hand", (1, 0, 0)),
    "thumb": Role("wrist", (0.7, 0, 0.7)),
    "index": Role("wrist", (0.95, 0, 0.3)),
    "pinky": Role("wrist", (0.95, 0, -0.3)),
    "eye": Role("head", (0.3, 0.2, 0.9)),
    "ear": Role("head", (0.9, 0, 0.2)),
}


def _sided(side: str, sign: float) -> dict[str, Role]:
    return {
        f"{side}_{part}": Role(
            role.parent if role.parent in _CENTRE else f"{side}_{role.parent}",
            (sign * role.direction[0], role.direction[1], role.direction[2]),
        )
        for part, role in _LEFT.items()
    }


ROLES: dict[str, Role] = {**_CENTRE, **_sided("left", 1.0), **_sided("right", -1.0)}
"""Every part by its name, parents first."""


def parent_among(role: str, there: set[str]) -> str:
    """The nearest part above ``role`` that is among those ``there``; empty where none is."""
    parent = ROLES[role].parent
    while parent and parent not in there:
        parent = ROLES[parent].parent
    return parent


def direction_of(role: str) -> np.ndarray:
    """Unit vector (3,) of the bone that ends at ``role``, in a T-pose; zero for the pelvis."""
    vector = np.array(ROLES[role].direction, float)
    length = float(np.linalg.norm(vector))
    return vector / length if length else vector
