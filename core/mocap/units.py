"""BVH has no unit of length: guess it from the size of the body."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np


class UnitGuess(NamedTuple):
    """Metres per unit, in words, and whether the body then has a size that people have."""

    metres: float
    words: str
    believable: bool


# Metres per unit, and the range of tip-to-tip lengths (see span) that is taken for it. A grown person spans 1.9 to
# 2.6 m from the finger tips to the toes, a child from about 1.3 m. CMU's unit is an inch divided by 0.45.
_UNITS = (
    (1.0, 1.0, 4.5, "metres"),
    (0.0254 / 0.45, 20.0, 75.0, "CMU's unit"),
    (0.0254, 75.0, 130.0, "inches"),
    (0.01, 130.0, 450.0, "centimetres"),
    (0.001, 1300.0, 4500.0, "millimetres"),
)
SPANS = (0.9, 4.5)  # metres from tip to tip that a body may have, with room for parts of a body and for giants
LONGEST_BONE = 1.2  # metres


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


def guess_unit(parents: Sequence[int], offsets: np.ndarray) -> UnitGuess:
    """The unit in which a skeleton with these offsets (n_joints, 3) is of human size, else the nearest to that."""
    length, bone = max(span(parents, offsets), 1e-9), float(np.linalg.norm(offsets, axis=1).max())
    # The span decides; where it is near two units, a bone longer than any in one of them speaks for the other.
    doubt = [max(low / length, length / high, bone * metres / LONGEST_BONE, 1.0) for metres, low, high, _ in _UNITS]
    metres, _, _, words = _UNITS[int(np.argmin(doubt))]
    believable = SPANS[0] <= length * metres <= SPANS[1] and bone * metres <= LONGEST_BONE
    return UnitGuess(metres, f"{words} ({metres:.6g} m)", believable)
