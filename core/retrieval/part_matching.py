"""Matching lists of pattern indices, and from parts to the whole body (PCR section 4.1, repaired).

The printed algorithm looks for the query's beginning only and loses its place at the first difference. Here two lists
are aligned locally (Smith and Waterman 1981): pairs of patterns gain ``1 - d / tolerance`` for their dissimilarity d, a
pattern without a partner costs ``gap``, and the best run of pairs counts wherever it begins and ends in either list.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array, Float64Array, Int32Array, Int64Array
from core.compiled import njit
from core.errors import AnalysisError
from core.poses.body_parts import CHILDREN, LEAVES, NODES, leaves_of


def gains(dissimilarities: np.ndarray, tolerance: float) -> np.ndarray:
    """What pairing each pattern of a query (m,) with each pattern (k,) brings: ``(m, k)`` float32, from 1 down to -1.

    dissimilarities: ``(m, k)``, 0 for equal. Raises ValueError where the tolerance is not positive.
    """
    if not tolerance > 0:
        raise ValueError(f"tolerance must be positive, not {tolerance}")
    gain: np.ndarray = np.maximum(1 - np.asarray(dissimilarities, np.float32) / np.float32(tolerance), -1)
    return gain


def window_scores(
    symbols: np.ndarray, starts: np.ndarray, ends: np.ndarray, gain: np.ndarray, gap: float
) -> np.ndarray:
    """How alike windows ``symbols[starts[i]:ends[i]]`` and a query are: ``(n,)`` from 0 to 1, 1 for equal lists.

    gain: ``(m, k)`` of :func:`gains`. The best local alignment over the geometric mean of the two lengths, so that
    what either has beyond the other counts against it. An empty window scores 0.
    """
    if len(gain) == 0 or len(starts) == 0:
        return np.zeros(len(starts))
    first, last = np.ascontiguousarray(starts, np.int64), np.ascontiguousarray(ends, np.int64)
    return _window_scores(symbols, first, last, np.ascontiguousarray(gain, np.float32), np.float32(gap))


class Places(NamedTuple):
    """The best local alignment that ends at each symbol, ``(n,)`` each: its score, first symbol, and query range.

    start: of the first paired symbol; query_start, query_end: half-open range of the query's symbols.
    """

    score: np.ndarray
    start: np.ndarray
    query_start: np.ndarray
    query_end: np.ndarray


def places(symbols: np.ndarray, starts: np.ndarray, ends: np.ndarray, gain: np.ndarray, gap: float) -> Places:
    """Where the query fits: for all symbols ``(n,)`` the best alignment that ends there, within its window only.

    starts, ends: ``(n_windows,)`` windows that do not overlap; symbols in none of them score 0. gain: ``(m, k)``.
    """
    n = len(symbols)
    best = Places(np.zeros(n, np.float32), *(np.zeros(n, np.int32) for _ in range(3)))
    if len(gain) and len(starts):
        first, last = np.ascontiguousarray(starts, np.int64), np.ascontiguousarray(ends, np.int64)
        _places(symbols, first, last, np.ascontiguousarray(gain, np.float32), np.float32(gap), *best)
    return best


def aligned_pairs(symbols: np.ndarray, gain: np.ndarray, gap: float) -> np.ndarray:
    """The pairs of the best local alignment of a list ``(n,)`` with the query: ``(k, 2)`` indices into query and list.

    Both columns ascend; empty where nothing gains. gain: ``(m, k)``.
    """
    if len(gain) == 0 or len(symbols) == 0:
        return np.zeros((0, 2), np.int64)
    table = np.asarray(gain, np.float32)[:, symbols]
    return _aligned_pairs(np.ascontiguousarray(table), np.float32(gap))


def propagate(scores: Mapping[str, np.ndarray], weights: Mapping[str, float], alpha: float) -> np.ndarray:
    """The scores of the whole body ``(n,)`` from those of the nodes ``(n,)`` each, through the hierarchy.

    U(node) = a S(node) + (1 - a) sum(w U(child)) / sum(w), where w is the mean weight of the leaves below a child:
    with equal weights the even ratio of the paper. A node's own score mixes its leaves as they are, so its share is a =
    alpha * (least weight below it / mean weight below it): alpha for equal weights, and none where a leaf has no
    weight, which then has no influence at all. A node that is not in ``scores`` (a hybrid's, of several motions) hands
    on what its children say. Raises AnalysisError where no leaf with a weight has a score.
    """
    means = {node: float(np.mean([weights[leaf] for leaf in leaves_of(node)])) for node in NODES}
    combined: dict[str, np.ndarray] = {}
    for node in reversed(NODES):  # children before parents
        children = [child for child in CHILDREN[node] if child in combined]
        if node in LEAVES:
            if means[node] > 0 and node in scores:
                combined[node] = np.asarray(scores[node], float)
        elif children:
            total = np.sum([means[child] * combined[child] for child in children], axis=0)
            below = total / sum(means[child] for child in children)
            share = own_share(node, weights, alpha) if node in scores else 0.0
            combined[node] = share * scores[node] + (1 - share) * below if share > 0 else below
    if "whole_body" not in combined:
        raise AnalysisError("none of the parts with a weight has a score")
    return combined["whole_body"]


def own_share(node: str, weights: Mapping[str, float], alpha: float) -> float:
    """Share of a node's own score against what its children hand on, see :func:`propagate`; 1 for a leaf."""
    below = [weights[leaf] for leaf in leaves_of(node)]
    if node in LEAVES:
        return 1.0 if below[0] > 0 else 0.0
    return alpha * min(below) / (sum(below) / len(below)) if sum(below) > 0 else 0.0


@njit(nogil=True)
def _window_scores(
    symbols: Int32Array, starts: Int64Array, ends: Int64Array, gain: Float32Array, gap: np.float32
) -> Float64Array:
    m = len(gain)
    scores = np.zeros(len(starts))
    row = np.zeros(m + 1, np.float32)
    for w in range(len(starts)):
        row[:] = 0
        best = np.float32(0)
        for i in range(starts[w], ends[w]):
            diagonal = np.float32(0)
            for j in range(m):
                above = row[j + 1]
                value = max(diagonal + gain[j, symbols[i]], max(row[j], above) - gap)
                diagonal = above
                if value < 0:
                    value = np.float32(0)
                row[j + 1] = value
                if value > best:
                    best = value
        if ends[w] > starts[w]:
            scores[w] = best / np.sqrt(m * (ends[w] - starts[w]))
    return scores


@njit(nogil=True)
def _places(
    symbols: Int32Array,
    starts: Int64Array,
    ends: Int64Array,
    gain: Float32Array,
    gap: np.float32,
    out_score: Float32Array,
    out_start: Int32Array,
    out_query_start: Int32Array,
    out_query_end: Int32Array,
) -> None:
    m = len(gain)
    score = np.zeros(m + 1, np.float32)
    first, since = np.zeros(m + 1, np.int32), np.zeros(m + 1, np.int32)  # of the alignment in each column
    for w in range(len(starts)):
        score[:] = 0
        for i in range(starts[w], ends[w]):
            diagonal, diagonal_first, diagonal_since = np.float32(0), np.int32(0), np.int32(0)
            for j in range(m):
                above, above_first, above_since = score[j + 1], first[j + 1], since[j + 1]
                pair = gain[j, symbols[i]]
                value, begin, query = diagonal + pair, diagonal_first, diagonal_since
                if diagonal <= 0:
                    begin, query = np.int32(i), np.int32(j)
                if above - gap > value:
                    value, begin, query = above - gap, above_first, above_since
                if score[j] - gap > value:
                    value, begin, query = score[j] - gap, first[j], since[j]
                if value < 0:
                    value = np.float32(0)
                diagonal, diagonal_first, diagonal_since = above, above_first, above_since
                score[j + 1], first[j + 1], since[j + 1] = value, begin, query
                if value > out_score[i]:
                    out_score[i], out_start[i], out_query_start[i], out_query_end[i] = value, begin, query, j + 1


@njit(nogil=True)
def _aligned_pairs(table: Float32Array, gap: np.float32) -> Int64Array:
    m, n = table.shape
    score = np.zeros((m + 1, n + 1), np.float32)
    best, at_i, at_j = np.float32(0), 0, 0
    for i in range(m):
        for j in range(n):
            value = max(score[i, j] + table[i, j], max(score[i, j + 1], score[i + 1, j]) - gap)
            if value < 0:
                value = np.float32(0)
            score[i + 1, j + 1] = value
            if value > best:
                best, at_i, at_j = value, i + 1, j + 1
    pairs = np.empty((min(m, n), 2), np.int64)
    k = len(pairs)
    while at_i > 0 and at_j > 0 and score[at_i, at_j] > 0:
        if score[at_i, at_j] == score[at_i - 1, at_j - 1] + table[at_i - 1, at_j - 1]:
            at_i, at_j, k = at_i - 1, at_j - 1, k - 1
            pairs[k, 0], pairs[k, 1] = at_i, at_j
        elif score[at_i, at_j] == score[at_i - 1, at_j] - gap:
            at_i -= 1
        else:
            at_j -= 1
    return pairs[k:]
