"""Distances as chances: how likely people would call two motions the same action (docs/methods/search.md).

A distance says little by itself: exercises on the spot are all nearer to one another than walks in all directions are.
So it is seen beside the distance that is usual between the query and anything else in the collection, and a logistic
regression on labelled collections (``python -m benchmarks chances``) turns the two into a chance.
"""

from __future__ import annotations

import numpy as np

from core.retrieval.frames import FrameStore, evenly_spread
from core.retrieval.metric import Metric, Motions

PLACES = 64  # stretches or clips of the collection that the usual distance is taken from
LEAST = 0.01  # chance below which a stretch is no hit
EVEN, BY_DISTANCE, BY_RATIO = 5.2, -2.3, -9.2
"""Log odds of the same action: at distance 0, and for each unit of the distance and of its ratio to the usual one."""

_LEAST_USUAL = 0.4  # in a collection of one action everything is near: distances are not called far by their ratio
_TYPICAL, _FEW = 0.7, 30  # what is usual where nothing is known, and how many stretches say as much as that


def usual_distance(store: FrameStore, metric: Metric, query: Motions, n_frames: int) -> float:
    """Median distance of a motion of ``n_frames`` (one of ``query``) to stretches as long, spread over all clips.

    A small collection says little of what is usual: the fewer such stretches it holds, the more a typical value counts.
    So one more clip in a small collection hardly changes what others score.
    """
    places = evenly_spread(len(store.codes), PLACES)
    clips = np.searchsorted(store.starts, places, side="right") - 1
    first, last = store.starts[clips], store.starts[clips + 1]
    starts = np.maximum(first, np.minimum(places, last - n_frames))
    ends = np.minimum(starts + n_frames, last)
    median = np.median(metric.distances(query, metric.motions(store, store.codes, starts, ends)))
    return _with_typical(float(median), len(store.codes) / n_frames)


def usual_of_clips(metric: Metric, query: Motions, clips: Motions) -> float | None:
    """The usual distance of a whole clip (one of ``query``): the median to whole clips; None where they are too few."""
    n = len(clips.samples)
    if n < PLACES:
        return None
    median = np.median(metric.distances(query, clips[evenly_spread(n, PLACES)]))
    return _with_typical(float(median), n)


def _with_typical(median: float, n: float) -> float:
    """A median of what ``n`` stretches are like, drawn towards the typical one where they are few."""
    return max(_LEAST_USUAL, (n * median + _FEW * _TYPICAL) / (n + _FEW))


def chances(distances: np.ndarray, usual: float) -> np.ndarray:
    """Chances ``(k,)`` that motions at these distances show the query's action, from 0 to 1; 1 for an equal motion.

    They fall as the distance grows, so the order stays. usual: see usual_distance.
    """
    distances = np.asarray(distances, np.float64)
    odds = EVEN + BY_DISTANCE * distances + BY_RATIO * distances / usual
    found: np.ndarray = (1 + np.exp(-EVEN)) / (1 + np.exp(-odds))
    return found
