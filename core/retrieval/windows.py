"""The coarse look for stretches like a query: the best windows of several tempos (docs/methods/search.md).

A window is judged as the metric judges it: less its mean posture and divided by its size, so that another performer's
same movement is found, at a few frames instead of all. With the postures x of the window's frames, their mean m, their
size s, shares c of the mean that are taken off, and keys q of the query treated alike, the mean of
``|(x - c m) / s - q|^2`` needs only the products of frames and keys, which all windows share, and the sums of frames.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from core.arrays import Float32Array, Float64Array, Int8Array, Int64Array
from core.compiled import njit
from core.retrieval.compose import Composed
from core.retrieval.frames import UNITS, FrameStore
from core.retrieval.metric import FASTEST, SMALL, Metric
from core.retrieval.path_length import at_shares, path_lengths

KEYS = 8  # frames of the query that are looked at
TEMPOS = (0.7, 0.84, 1.0, 1.19, 1.41)  # lengths of windows, in lengths of the query
STRIDE = 4  # at most so many frames between two that are looked at
_BLOCK = 64  # frames at a time


@dataclass
class Windows:
    """Stretches ``[start, end)`` of the store, ``(k,)`` each, with the clip each lies in."""

    clip: np.ndarray
    start: np.ndarray
    end: np.ndarray

    def take(self, which: np.ndarray) -> Windows:
        """Those numbered ``(k,)``."""
        return Windows(self.clip[which], self.start[which], self.end[which])


@dataclass(frozen=True, eq=False)
class Keys:
    """Frames of the query at equal steps of its way.

    times: ``(KEYS,)``, 0 to 1. postures: ``(KEYS, d)`` less the query's mean posture, by its size. mean: ``(d,)`` what
    products with the window's mean posture count, see :func:`find_windows`. root: ``(KEYS, r)``, as it is.
    """

    times: np.ndarray
    postures: np.ndarray
    mean: np.ndarray
    root: np.ndarray


def find_windows(store: FrameStore, query: Composed, metric: Metric, among: np.ndarray, most: int) -> Windows:
    """The ``most`` best windows of the clips ``(k,)`` that are the best of their neighbourhood."""
    n = len(query.codes)
    stride = max(1, min(STRIDE, n // KEYS))
    keys, scales = _keys(query, metric), UNITS[metric.columns] * metric.factors
    frames = store.starts[among + 1] - store.starts[among]
    offsets = np.concatenate([[0], np.cumsum(-(-frames // stride))])
    score, length = _scored(
        store.codes,
        store.starts[among],
        frames,
        offsets,
        metric.columns,
        scales.astype(np.float32),
        metric.centre,
        (FASTEST * metric.factors[metric.way :]).astype(np.float32),
        keys.postures,
        keys.mean,
        keys.root,
        keys.times,
        np.maximum(1, np.rint(np.array(TEMPOS) * n)).astype(np.int64),
        stride,
        np.float32(SMALL),
    )
    minima = _minima(score, offsets, max(1, n // (3 * stride)))
    if len(minima) > most:
        minima = minima[np.argpartition(score[minima], most)[:most]]
    place = np.searchsorted(offsets, minima, side="right") - 1
    clip = among[place]
    start = store.starts[clip] + (minima - offsets[place]) * stride
    return Windows(clip, start, np.minimum(start + length[minima], store.starts[clip + 1]))


def _keys(query: Composed, metric: Metric) -> Keys:
    way = metric.way
    values = query.codes[:, metric.columns] * (UNITS[metric.columns] * metric.factors)
    fastest = FASTEST * metric.factors[way:]
    values[:, way:] = np.clip(values[:, way:], -fastest, fastest)
    lengths = path_lengths(values[:, :way])
    shares = (np.arange(KEYS) + 0.5) / KEYS
    times = np.interp(shares * lengths[-1], lengths, np.arange(len(lengths)) / max(len(lengths) - 1, 1))
    chosen = at_shares(values.astype(np.float32), lengths, shares).astype(np.float32)
    postures, mean = chosen[:, :way], chosen[:, :way].mean(0)
    size = np.sqrt(((postures - mean) ** 2).sum(1).mean() + SMALL**2)
    left = metric.centre * (1 - metric.centre) * mean / size
    return Keys(times, (postures - metric.centre * mean) / size, left.astype(np.float32), chosen[:, way:])


@njit(nogil=True, fastmath=True)
def _scored(
    codes: Int8Array,
    starts: Int64Array,
    frames: Int64Array,
    offsets: Int64Array,
    columns: Int64Array,
    scales: Float32Array,
    centre: Float32Array,
    fastest: Float32Array,
    postures: Float32Array,
    key_mean: Float32Array,
    roots: Float32Array,
    times: Float64Array,
    windows: Int64Array,
    stride: int,
    small: np.float32,
) -> tuple[Float32Array, Int64Array]:
    """Per coarse frame of the clips the distance of the best window that starts there, and its length."""
    n_keys, d = postures.shape
    longest = max(1, np.diff(offsets).max())
    score, length = np.full(offsets[-1], np.float32(1e9)), np.zeros(offsets[-1], np.int64)
    sums, over = np.zeros((d, longest + 1), np.float32), np.zeros((2, longest + 1), np.float32)
    alike, apart = np.empty((n_keys, longest), np.float32), np.empty((n_keys, longest), np.float32)
    far = np.empty((5, longest), np.float32)
    for c in range(len(starts)):
        coarse = offsets[c + 1] - offsets[c]
        _tables(
            codes, starts[c], stride, coarse, columns, scales, fastest, postures, key_mean, roots,
            sums, over, alike, apart,
        )  # fmt: skip
        for t in range(len(windows)):
            window = windows[t]
            if window > frames[c] and t > 0:
                continue
            window = min(window, frames[c])  # a clip shorter than every window is one itself
            count = (frames[c] - window) // stride + 1
            wide = min((window - 1) // stride + 1, coarse - count + 1)
            shifts = np.minimum((times * (window - 1) / stride + 0.5).astype(np.int64), coarse - count)
            _judge(count, wide, shifts, centre, small, sums, over, alike, apart, far)
            at = offsets[c]
            for i in range(count):
                if far[4, i] < score[at + i]:
                    score[at + i], length[at + i] = far[4, i], window
    queried = np.float32((postures * postures).sum() / n_keys)
    return score + queried, length


@njit(nogil=True, fastmath=True)
def _tables(
    codes: Int8Array,
    start: int,
    stride: int,
    coarse: int,
    columns: Int64Array,
    scales: Float32Array,
    fastest: Float32Array,
    postures: Float32Array,
    key_mean: Float32Array,
    roots: Float32Array,
    sums: Float32Array,
    over: Float32Array,
    alike: Float32Array,
    apart: Float32Array,
) -> None:
    """Of a clip's coarse frames: sums of postures up to each, of their squares and products with ``key_mean``, and

    products with the keys and squared differences of the root for each key.
    """
    n_keys, d = postures.shape
    n_root = roots.shape[1]
    block = np.empty((d + n_root, _BLOCK), np.float32)
    alike[:, :coarse] = 0.0
    apart[:, :coarse] = 0.0
    over[:, : coarse + 1] = 0.0
    for low in range(0, coarse, _BLOCK):  # a block of frames at a time, side by side: no sums across
        many = min(_BLOCK, coarse - low)
        for i in range(many):
            frame = codes[start + (low + i) * stride]
            for e in range(d + n_root):
                block[e, i] = np.float32(frame[columns[e]]) * scales[e]
        for e in range(d):
            total, row = sums[e, low], block[e]
            for i in range(many):
                total += row[i]
                sums[e, low + i + 1] = total
            for i in range(many):
                over[0, low + i + 1] += row[i] * row[i]
                over[1, low + i + 1] += row[i] * key_mean[e]
        for k in range(n_keys):
            _add_key(block, many, postures[k], roots[k], fastest, alike[k, low:], apart[k, low:])
    for i in range(coarse):
        over[0, i + 1] += over[0, i]
        over[1, i + 1] += over[1, i]


@njit(nogil=True, fastmath=True)
def _add_key(
    block: Float32Array,
    many: int,
    posture: Float32Array,
    root: Float32Array,
    fastest: Float32Array,
    alike: Float32Array,
    apart: Float32Array,
) -> None:
    d = len(posture)
    for e in range(d):
        key, row = posture[e], block[e]
        for i in range(many):
            alike[i] += row[i] * key
    for e in range(len(root)):
        key, row, most = root[e], block[d + e], fastest[e]
        for i in range(many):
            off = min(most, max(-most, row[i])) - key
            apart[i] += off * off


@njit(nogil=True, fastmath=True)
def _judge(
    count: int,
    wide: int,
    shifts: Int64Array,
    centre: Float32Array,
    small: np.float32,
    sums: Float32Array,
    over: Float32Array,
    alike: Float32Array,
    apart: Float32Array,
    far: Float32Array,
) -> None:
    """Row 4 of ``far``: the distances of ``count`` windows of ``wide`` frames, less what the keys alone add."""
    n_keys = len(shifts)
    part, share = np.float32(1.0 / wide), np.float32(1.0 / n_keys)
    product, root, whole, kept, out = far[0], far[1], far[2], far[3], far[4]
    far[:4, :count] = 0.0
    for k in range(n_keys):
        near, off = alike[k, shifts[k] : shifts[k] + count], apart[k, shifts[k] : shifts[k] + count]
        for i in range(count):
            product[i] += near[i]
            root[i] += off[i]
    for e in range(len(centre)):
        first, last = sums[e, :count], sums[e, wide : wide + count]
        left = (np.float32(1.0) - centre[e]) * (np.float32(1.0) - centre[e])
        if left > 0:
            for i in range(count):
                square = (last[i] - first[i]) * (last[i] - first[i])
                whole[i] += square
                kept[i] += left * square
        else:
            for i in range(count):
                whole[i] += (last[i] - first[i]) * (last[i] - first[i])
    for i in range(count):
        changed = max(np.float32(0.0), ((over[0, i + wide] - over[0, i]) - whole[i] * part) * part)
        room = changed + small * small
        lean = product[i] * share - (over[1, i + wide] - over[1, i]) * part
        out[i] = (changed + kept[i] * part * part) / room + root[i] * share - np.float32(2.0) * lean / np.sqrt(room)


@njit(nogil=True)
def _minima(score: Float32Array, offsets: Int64Array, reach: int) -> Int64Array:
    """Indices of windows that are no worse than those up to ``reach`` away in the same clip."""
    minima = []
    for c in range(len(offsets) - 1):
        for i in range(offsets[c], offsets[c + 1]):
            if score[i] > 1e8:
                continue
            best = True
            for j in range(max(offsets[c], i - reach), min(offsets[c + 1], i + reach + 1)):
                if score[j] < score[i] or (score[j] == score[i] and j < i):
                    best = False
                    break
            if best:
                minima.append(i)
    return np.array(minima, np.int64)
