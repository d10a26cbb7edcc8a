"""Explains a hit: which part of the body is like the query, and when."""

from __future__ import annotations

import numpy as np

from core.mocap.clip import Segment
from core.poses.body_parts import LEAVES
from core.retrieval.compose import Composed
from core.retrieval.descriptors import BLOCKS
from core.retrieval.frames import FrameStore, decode
from core.retrieval.hits import Explanation
from core.retrieval.metric import Metric
from core.retrieval.queries import Query
from core.sequences.warping import registration, warp_path

_LIKE = 1.0
"""Distance of two unit vectors (60 degrees) from which a part counts as not alike at all."""


def explain(store: FrameStore, composed: Composed, query: Query, segment: Segment) -> Explanation:
    """Warps the query onto the segment, by the parts that have a weight, and compares part by part.

    Raises KeyError where the segment's clip is not in the store.
    """
    clip, start, end = store.stretch(segment)
    codes = store.of(clip)[start:end]
    scales = Metric(composed.weights).scales
    path = warp_path(composed.codes * scales, codes * scales)
    beside = registration(path, len(composed.codes))
    ours, theirs = decode(composed.codes), decode(codes)
    low = np.floor(beside).astype(np.int64)
    rest = (beside - low)[:, None].astype(np.float32)
    theirs = theirs[low] * (1 - rest) + theirs[np.minimum(low + 1, len(theirs) - 1)] * rest
    has = store.has[clip]
    similarity = np.full((len(LEAVES), len(ours)), np.nan)
    for k, leaf in enumerate(LEAVES):
        if leaf in query.leaves and has[k] and (ours[:, BLOCKS[leaf]] != 0).any():
            apart = (ours[:, BLOCKS[leaf]] - theirs[:, BLOCKS[leaf]]).reshape(len(ours), -1, 3)
            similarity[k] = 1 - np.minimum(np.linalg.norm(apart, axis=2).mean(1) / _LIKE, 1)
    entry = store.clips[clip]
    at = np.interp(composed.frames, np.arange(len(beside)), beside)
    warp = np.clip(np.rint((start + at) * entry.fps / store.fps), segment.start, segment.end - 1).astype(np.int64)
    return Explanation(np.arange(len(ours)) / store.fps, similarity, warp)
