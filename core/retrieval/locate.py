"""Finds stretches of the recordings that are like the query (docs/methods/search.md).

Coarse to fine: how far a few frames of the query are from every few frames of the recordings, summed up along windows
of several tempos; the best windows are compared by the metric; the best of these get their ends from dynamic time
warping.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array
from core.compiled import njit
from core.retrieval.chance import chances, usual_distance
from core.retrieval.compose import Composed
from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import FrameStore
from core.retrieval.metric import Metric
from core.retrieval.trajectories import path_distances
from core.retrieval.windows import TEMPOS, Windows, find_windows

POOL = 128  # windows that are compared by the metric, at least
COPY = 0.3  # cost a frame of warping postures onto postures below which a window is the query again, or nearly so
_SHRUNK = 0.6  # share of a window below which warping may not shorten it
_REFINED = 150  # frames of the query that warping looks at, at most


class Place(NamedTuple):
    """Frames ``[start, end)`` of a clip, by numbers of the store; within: of the query, where it is like a part."""

    clip: int
    start: int
    end: int
    score: float
    within: tuple[int, int] | None


def locate(store: FrameStore, query: Composed, among: np.ndarray, top: int, root_path: float = 0.0) -> list[Place]:
    """At most ``top`` stretches of the clips numbered ``(k,)``, best first; none lies over most of another."""
    metric = Metric(query.weights)
    query_motion = metric.motions(store, query.codes, np.array([0]), np.array([len(query.codes)]))

    def apart(windows: Windows) -> np.ndarray:
        distance = metric.distances(query_motion, metric.motions(store, store.codes, windows.start, windows.end))
        if root_path > 0:
            paths = path_distances(query.codes, store.codes, windows.start, windows.end, store.fps)
            distance = (1 - root_path) * distance + root_path * paths
        return distance

    windows = find_windows(store, query, metric, among, max(POOL, 6 * top))
    distances = apart(windows)
    best = np.argsort(distances, kind="stable")[: 3 * top + 10]
    windows, distances = windows.take(best), distances[best]
    windows, warped = _refine(store, query, metric, windows)
    # among the like, what is the very motion comes first; how fast it was played hardly matters then
    distances = apart(windows) * np.minimum(1, warped / COPY) ** 2
    usual = usual_distance(store, metric, query_motion, len(query.codes))
    scores, parts = chances(distances, usual), {}
    for k in np.flatnonzero(windows.end - windows.start < TEMPOS[0] * len(query.codes) - 1).tolist():
        part, distance = _part(store, query, metric, windows.take(np.array([k])))  # the clip holds no more
        parts[k] = part
        scores[k] = chances(distance, usual)[0] * (part[1] - part[0]) / len(query.codes)
    kept = _apart(windows, -scores, top)
    return [_place(store, windows, k, scores[k], parts.get(k)) for k in kept]


def _refine(store: FrameStore, query: Composed, metric: Metric, windows: Windows) -> tuple[Windows, np.ndarray]:
    """The windows with the ends that dynamic time warping gives them, looked for a quarter of their length around, and

    what the warping costs a frame of the query, ``(k,)`` from 0 to 1.
    """
    step = max(1, -(-len(query.codes) // _REFINED))
    scales = metric.scales
    scales[N_COLUMNS:] = 0  # postures alone: how fast one travels changes with the tempo
    query_values = query.codes[::step].astype(np.float32) * scales
    start, end, cost = windows.start.copy(), windows.end.copy(), np.empty(len(windows.clip))
    for k, clip in enumerate(windows.clip):
        more = (end[k] - start[k]) // 4
        low, high = max(store.starts[clip], start[k] - more), min(store.starts[clip + 1], end[k] + more)
        frames = store.codes[low:high:step].astype(np.float32) * scales
        first, last, cost[k] = warped_stretch(query_values, frames, metric.cap)
        found = low + first * step, min(high, low + (last - 1) * step + 1)
        if found[1] - found[0] >= _SHRUNK * (end[k] - start[k]):  # who stands still warps onto a single frame
            start[k], end[k] = found
    return Windows(windows.clip, start, end), cost / len(query_values)


def warped_stretch(query: np.ndarray, frames: np.ndarray, cap: float) -> tuple[int, int, float]:
    """The stretch ``[start, end)`` of ``frames`` (m, d) onto which ``query`` (n, d) is warped cheapest, and the cost.

    A pair of frames costs ``min(1, distance / cap)``; every frame of the query is used, steps go on in either or both.
    Raises ValueError for empty sequences or unlike dimensions.
    """
    query, frames = np.ascontiguousarray(query, np.float32), np.ascontiguousarray(frames, np.float32)
    if not len(query) or not len(frames) or query.shape[1:] != frames.shape[1:]:
        raise ValueError(f"cannot look for shape {query.shape} in shape {frames.shape}")
    start, end, cost = _warped_stretch(query, frames, np.float32(cap))
    return start, end, float(cost)


@njit(nogil=True, fastmath=True)
def _warped_stretch(query: Float32Array, frames: Float32Array, cap: np.float32) -> tuple[int, int, np.float32]:
    n, m = len(query), len(frames)
    cost, begun = np.zeros(m, np.float32), np.arange(m)
    for i in range(n):
        corner, corner_begun = np.float32(0.0), 0
        for j in range(m):
            far = np.float32(0.0)
            for e in range(query.shape[1]):
                apart = query[i, e] - frames[j, e]
                far += apart * apart
            here = min(np.float32(1.0), np.sqrt(far) / cap)
            above, above_begun = cost[j], begun[j]
            if i == 0:
                best, start = np.float32(0.0), j  # may begin anywhere
            else:
                best, start = above, above_begun
                if j > 0 and corner <= best:
                    best, start = corner, corner_begun
                if j > 0 and cost[j - 1] < best:
                    best, start = cost[j - 1], begun[j - 1]
            corner, corner_begun = above, above_begun
            cost[j], begun[j] = best + here, start
    last = 0
    for j in range(m):
        if cost[j] < cost[last]:
            last = j
    return begun[last], last + 1, cost[last]


def _apart(windows: Windows, distances: np.ndarray, top: int) -> list[int]:
    """Indices of the best windows of which none shares more than half of the shorter one with a better one."""
    kept: list[int] = []
    for k in np.argsort(distances, kind="stable"):
        for h in kept:
            shared = min(windows.end[k], windows.end[h]) - max(windows.start[k], windows.start[h])
            shorter = min(windows.end[k] - windows.start[k], windows.end[h] - windows.start[h])
            if shared > 0.5 * shorter:
                break
        else:
            kept.append(int(k))
            if len(kept) == top:
                break
    return kept


def _part(store: FrameStore, query: Composed, metric: Metric, window: Windows) -> tuple[tuple[int, int], np.ndarray]:
    """The frames of the query that a window is like, and the distance of the window to them, ``(1,)``."""
    frames = store.codes[window.start[0] : window.end[0]].astype(np.float32) * metric.scales
    start, end, _ = warped_stretch(frames, query.codes.astype(np.float32) * metric.scales, metric.cap)
    part = metric.motions(store, query.codes, np.array([start]), np.array([end]))
    return (start, end), metric.distances(part, metric.motions(store, store.codes, window.start, window.end))


def _place(store: FrameStore, windows: Windows, k: int, score: float, within: tuple[int, int] | None) -> Place:
    clip = int(windows.clip[k])
    first = int(store.starts[clip])
    return Place(clip, int(windows.start[k]) - first, int(windows.end[k]) - first, float(score), within)
