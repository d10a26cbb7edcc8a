"""Verifies stretches that were found by their patterns, by comparing their frames."""

from __future__ import annotations

import numpy as np

from core.retrieval.compose import Composed
from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import FrameStore
from core.retrieval.locate import warped_stretch
from core.retrieval.metric import Metric

_ROOM = 0.25  # of a stretch either side, within which the query may be warped onto it
_FRAMES = 150  # of the query, at most: longer ones are looked at in steps


def warped_spans(store: FrameStore, query: Composed, spans: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Stretches ``(k, 2)`` of the store's frames with the ends that warping the query onto them gives, ``(k, 2)``, and

    what it costs a frame of the query, ``(k,)`` from 0 (equal) to 1. Parts without weight count nothing.
    """
    metric = Metric(query.weights)
    scales = metric.scales
    scales[N_COLUMNS:] = 0  # postures alone: how fast one travels changes with the tempo
    step = max(1, -(-len(query.codes) // _FRAMES))
    query_values = query.codes[::step].astype(np.float32) * scales
    stretches, cost = spans.copy(), np.zeros(len(spans))
    for k, (start, end) in enumerate(spans):
        clip = int(np.searchsorted(store.starts, start, side="right")) - 1
        room = round(_ROOM * (end - start))
        low, high = max(store.starts[clip], start - room), min(store.starts[clip + 1], end + room)
        frames = store.codes[low:high:step].astype(np.float32) * scales
        first, last, cost[k] = warped_stretch(query_values, frames, metric.cap)
        stretches[k] = low + first * step, min(high, low + (last - 1) * step + 1)
    return stretches, cost / len(query_values)
