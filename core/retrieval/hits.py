"""Results of a search: hits and their explanations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.mocap.clip import Segment
from core.poses.body_parts import LEAVES


class IndexedClip(NamedTuple):
    """A clip of an index: name, number of frames and frame rate."""

    name: str
    frames: int
    fps: float


class Hit(NamedTuple):
    """A stretch like the query. ``score``: higher is better, 1 is as good as equal.

    Of the engine bounded-edit it is the chance that people would call the two the same action (core.retrieval.chance),
    so the scores of all searches compare; those of the other engines compare within one search.

    query_segment: the stretch of the query it is like, where that is not all of it.
    """

    segment: Segment
    score: float
    query_segment: Segment | None = None


@dataclass(frozen=True, eq=False)
class Explanation:
    """Which parts of a hit are like the query when.

    parts: the leaves, in the order of LEAVES. times: ``(n,)`` seconds from the query's start. similarity: ``(10, n)``
    from 0 (nothing alike) to 1 (equal); NaN for a part that the query or the hit does not have. warp: ``(q,)`` for
    each frame of the query (its own rate; of a hybrid, of its leading part) the frame of the hit's clip that stands
    beside it; never decreases.
    """

    times: np.ndarray
    similarity: np.ndarray
    warp: np.ndarray
    parts: tuple[str, ...] = LEAVES
