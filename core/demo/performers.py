"""The people of the demo: one skeleton, several proportions and styles. Facing Z, left X, metres."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from core.mocap.skeleton import Skeleton

# joint, parent, offset in metres of a person of 1.62 m, which measure scales it; left side only, x is mirrored
_Row = tuple[str, str | None, tuple[float, float, float], str]
_TRUNK: list[_Row] = [
    ("Hips", None, (0, 0, 0), "legs"),
    ("Chest", "Hips", (0, 0.236151, 0), "trunk"),
    ("Neck", "Chest", (0, 0.223894, 0), "trunk"),
    ("Head", "Neck", (0, 0.105, 0), "trunk"),
    ("Head_end", "Head", (0, 0.1725, 0), "trunk"),
]
_ARM: list[tuple[str, str, tuple[float, float, float], str]] = [
    ("Shoulder", "Chest", (0.03, 0.205, -0.01), "shoulders"),
    ("Arm", "Shoulder", (0.15311, 0.0385, -0.01405), "shoulders"),
    ("ForeArm", "Arm", (0, -0.274788, 0), "arms"),
    ("Hand", "ForeArm", (0, -0.258947, 0), "arms"),
    ("Hand_end", "Hand", (0, -0.1, 0), "arms"),
]
_LEG: list[tuple[str, str, tuple[float, float, float], str]] = [
    ("UpLeg", "Hips", (0.084887, 0, 0), "legs"),
    ("Leg", "UpLeg", (0, -0.421546, 0), "legs"),
    ("Foot", "Leg", (0, -0.40987, 0), "legs"),
    ("ToeBase", "Foot", (0, -0.045, 0.095), "legs"),
    ("ToeBase_end", "ToeBase", (0, -0.005, 0.05), "legs"),
    ("Foot_end", "Foot", (0, -0.05, -0.0435), "legs"),
]


@dataclass(frozen=True)
class Performer:
    """Proportions (1 is the source's person) and manner: tempo 1.1 moves a tenth faster, amplitude widens gestures.

    lean: degrees by which the chest is carried forward; bounce: how much the pelvis moves up and down in gaits.
    """

    name: str
    size: float
    legs: float = 1.0
    trunk: float = 1.0
    arms: float = 1.0
    shoulders: float = 1.0
    tempo: float = 1.0
    amplitude: float = 1.0
    lean: float = 0.0
    bounce: float = 1.0

    def measure(self, part: str) -> float:
        """Scale of ``legs``, ``trunk``, ``arms`` or ``shoulders`` against the source's person."""
        measure: float = getattr(self, part)
        return self.size * measure


PERFORMERS = (
    Performer("ana", size=1.05),
    Performer("ben", size=1.12, legs=1.02, arms=1.02, shoulders=1.08, tempo=0.93, amplitude=0.9, lean=3, bounce=0.9),
    Performer("chloe", size=1.0, legs=1.01, shoulders=0.92, tempo=1.06, amplitude=1.12, lean=-2, bounce=1.1),
)


@lru_cache(maxsize=32)
def skeleton_of(performer: Performer) -> Skeleton:
    """The performer's skeleton: 20 joints and end sites for crown, hands, toes and heels."""
    rows = list(_TRUNK)
    for limb in (_ARM, _LEG):
        for side, x in (("Left", 1), ("Right", -1)):
            for joint, parent, offset, measure in limb:
                parent = parent if parent in ("Chest", "Hips") else side + parent
                rows.append((side + joint, parent, (x * offset[0], offset[1], offset[2]), measure))
    index = {row[0]: k for k, row in enumerate(rows)}
    return Skeleton(
        names=tuple(index),
        parents=tuple(-1 if row[1] is None else index[row[1]] for row in rows),
        offsets=np.array([np.multiply(row[2], performer.measure(row[3])) for row in rows], np.float32),
        end_sites=tuple(row[0].endswith("_end") for row in rows),
        unit=0.01,
    )
