"""Finds stretches of the recordings that are like the query (docs/methods/search.md).

Coarse to fine: how far a few frames of the query are from every few frames of the recordings, summed up along windows
of several tempos; the best windows are compared by the metric; the best of these get their ends from dynamic time
warping.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array, Float64Array, Int8Array, Int64Array
from core.compiled import njit
from core.retrieval.chance import chances, usual_distance
from core.retrieval.compose import Composed
from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import FrameStore
from core.retrieval.metric import Metric
from core.retrieval.path_length import at_shares, path_lengths
from core.retrieval.trajectories import path_distances

KEYS = 8  # frames of the query that the coarse look compares
TEMPOS = (0.7, 0.84, 1.0, 1.19, 1.41)  # lengths of windows, in lengths of the query
STRIDE = 4  # at most so many frames between two that the coarse look sees
POOL = 256  # windows that are compared by the metric, at least
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


@dataclass
class _Windows:
    """Stretches ``[start, end)`` of the store, ``(k,)`` each, with the clip each lies in."""

    clip: np.ndarray
    start: np.ndarray
    end: np.ndarray

    def take(self, which: np.ndarray) -> _Windows:
        return _Windows(self.clip[which], self.start[which], self.end[which])


def locate(store: FrameStore, query: Composed, among: np.ndarray, top: int, root_path: float = 0.0) -> list[Place]:
    """At most ``top`` stretches of the clips numbered ``(k,)``, best first; none lies over most of another."""
    metric = Metric(query.weights)
    query_motion = metric.motions(store, query.codes, np.array([0]), np.array([len(query.codes)]))

    def apart(windows: _Windows) -> np.ndarray:
        distance = metric.distances(query_motion, metric.motions(store, store.codes, windows.start, windows.end))
        if root_path > 0:
            paths = path_distances(query.codes, store.codes, windows.start, windows.end, store.fps)
            distance = (1 - root_path) * distance + root_path * paths
        return distance

    windows = _coarse(store, query, metric, among, max(POOL, 8 * top))
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


def _coarse(store: FrameStore, query: Composed, metric: Metric, among: np.ndarray, most: int) -> _Windows:
    """The ``most`` best windows that are the best of their neighbourhood."""
    n = len(query.codes)
    stride = max(1, min(STRIDE, n // KEYS))
    keys, times = _keys(query, metric)
    frames = store.starts[among + 1] - store.starts[among]
    offsets = np.concatenate([[0], np.cumsum(-(-frames // stride))])
    table = _table(store.codes, store.starts, among, offsets, keys, metric.scales, np.float32(metric.cap), stride)
    score, length = _score_windows(table, frames, offsets, times, n, np.array(TEMPOS), stride)
    minima = _minima(score, offsets, max(1, n // (3 * stride)))
    if len(minima) > most:
        minima = minima[np.argpartition(score[minima], most)[:most]]
    place = np.searchsorted(offsets, minima, side="right") - 1
    clip = among[place]
    start = store.starts[clip] + (minima - offsets[place]) * stride
    return _Windows(clip, start, np.minimum(start + length[minima], store.starts[clip + 1]))


def _keys(query: Composed, metric: Metric) -> tuple[np.ndarray, np.ndarray]:
    """Its frames at equal steps of its way ``(KEYS, width)`` as codes, and their times (0 to 1) ``(KEYS,)``."""
    values = query.codes.astype(np.float32)
    lengths = path_lengths((values * metric.scales)[:, metric.columns[: metric.way]])
    shares = (np.arange(KEYS) + 0.5) / KEYS
    times = np.interp(shares * lengths[-1], lengths, np.arange(len(lengths)) / max(len(lengths) - 1, 1))
    return at_shares(values, lengths, shares).astype(np.float32), times


@njit(nogil=True, fastmath=True)
def _table(
    codes: Int8Array,
    starts: Int64Array,
    among: Int64Array,
    offsets: Int64Array,
    keys: Float32Array,
    scales: Float32Array,
    cap: np.float32,
    stride: int,
) -> Float32Array:
    """How far every coarse frame of the clips is from every key: ``(n_keys, total)``, 0 to 1."""
    n_keys, used, block = len(keys), np.flatnonzero(scales), 64
    table = np.empty((n_keys, offsets[-1]), np.float32)
    mine, far = np.zeros((len(used), block), np.float32), np.empty(block, np.float32)
    for c in range(len(among)):
        first, coarse = starts[among[c]], offsets[c + 1] - offsets[c]
        for low in range(0, coarse, block):  # a block of frames at a time, side by side: no sums across
            many = min(block, coarse - low)
            for i in range(many):
                frame = codes[first + (low + i) * stride]
                for u in range(len(used)):
                    mine[u, i] = np.float32(frame[used[u]]) * scales[used[u]]
            for k in range(n_keys):
                for i in range(block):
                    far[i] = np.float32(0.0)
                for u in range(len(used)):
                    key, theirs = keys[k, used[u]] * scales[used[u]], mine[u]
                    for i in range(block):
                        apart = theirs[i] - key
                        far[i] += apart * apart
                row = table[k, offsets[c] + low : offsets[c] + low + many]
                for i in range(many):
                    row[i] = min(np.float32(1.0), np.sqrt(far[i]) / cap)
    return table


@njit(nogil=True, fastmath=True)
def _score_windows(
    table: Float32Array,
    frames: Int64Array,
    offsets: Int64Array,
    times: Float64Array,
    n: int,
    tempos: Float64Array,
    stride: int,
) -> tuple[Float32Array, Int64Array]:
    """Per coarse frame of the clips the mean distance of the best window that starts there, and its length."""
    n_keys, total = table.shape
    score = np.full(total, np.float32(2.0))
    length = np.zeros(total, np.int64)
    longest = 1
    for c in range(len(frames)):
        longest = max(longest, offsets[c + 1] - offsets[c])
    sums = np.empty(longest, np.float32)
    for c in range(len(frames)):
        at, coarse = offsets[c], offsets[c + 1] - offsets[c]
        for tempo in tempos:
            window = max(1, round(tempo * n))
            if window > frames[c]:
                if tempo > tempos[0]:
                    continue
                window = frames[c]  # a clip shorter than every window is one itself
            count = (frames[c] - window) // stride + 1
            sums[:count] = 0.0
            for k in range(n_keys):
                shift = at + min(int(times[k] * (window - 1) / stride + 0.5), coarse - count)
                row = table[k, shift : shift + count]
                for i in range(count):
                    sums[i] += row[i]
            for i in range(count):
                if sums[i] / n_keys < score[at + i]:
                    score[at + i] = sums[i] / n_keys
                    length[at + i] = window
    return score, length


@njit(nogil=True)
def _minima(score: Float32Array, offsets: Int64Array, reach: int) -> Int64Array:
    """Indices of windows that are no worse than those up to ``reach`` away in the same clip."""
    minima = []
    for c in range(len(offsets) - 1):
        for i in range(offsets[c], offsets[c + 1]):
            if score[i] > 1.5:
                continue
            best = True
            for j in range(max(offsets[c], i - reach), min(offsets[c + 1], i + reach + 1)):
                if score[j] < score[i] or (score[j] == score[i] and j < i):
                    best = False
                    break
            if best:
                minima.append(i)
    return np.array(minima, np.int64)


def _refine(store: FrameStore, query: Composed, metric: Metric, windows: _Windows) -> tuple[_Windows, np.ndarray]:
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
    return _Windows(windows.clip, start, end), cost / len(query_values)


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


def _apart(windows: _Windows, distances: np.ndarray, top: int) -> list[int]:
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


def _part(store: FrameStore, query: Composed, metric: Metric, window: _Windows) -> tuple[tuple[int, int], np.ndarray]:
    """The frames of the query that a window is like, and the distance of the window to them, ``(1,)``."""
    frames = store.codes[window.start[0] : window.end[0]].astype(np.float32) * metric.scales
    start, end, _ = warped_stretch(frames, query.codes.astype(np.float32) * metric.scales, metric.cap)
    part = metric.motions(store, query.codes, np.array([start]), np.array([end]))
    return (start, end), metric.distances(part, metric.motions(store, store.codes, window.start, window.end))


def _place(store: FrameStore, windows: _Windows, k: int, score: float, within: tuple[int, int] | None) -> Place:
    clip = int(windows.clip[k])
    first = int(store.starts[clip])
    return Place(clip, int(windows.start[k]) - first, int(windows.end[k]) - first, float(score), within)
