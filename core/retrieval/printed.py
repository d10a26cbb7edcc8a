"""Algorithm 2 as the paper prints it (PCR section 4.1), for comparison; ``part_matching`` is the repaired one.

The scan of a list stops when the query's end is reached, where the printed loop would read beyond it.
"""

from __future__ import annotations

import numpy as np

from core.arrays import Float32Array, Float64Array, Int32Array, Int64Array, IntArray
from core.compiled import njit

MAX_TOLERANCE = 0.02
MIN_CON_NUM = 5


def next_values(query: np.ndarray) -> np.ndarray:
    """The ``nextval`` vector of Knuth, Morris and Pratt 1977 for a list of symbols ``(m,)``: ``(m,)`` int64.

    Where symbol j does not match, the scan goes on with symbol ``next_values[j]``; -1: with the next of the text.
    """
    return _next_values(np.ascontiguousarray(query, np.int64))


@njit(nogil=True)
def _next_values(query: Int64Array) -> Int64Array:
    m = len(query)
    values = np.empty(m, np.int64)
    if m == 0:
        return values
    values[0] = -1
    i, j = 0, -1
    while i < m - 1:
        if j == -1 or query[i] == query[j]:
            i, j = i + 1, j + 1
            values[i] = values[j] if query[i] == query[j] else j
        else:
            j = values[j]
    return values


def algorithm_2(
    source: np.ndarray,
    query: np.ndarray,
    dissimilarities: np.ndarray,
    *,
    weight: float = 1.0,
    max_tolerance: float = MAX_TOLERANCE,
    min_con_num: int = MIN_CON_NUM,
) -> float:
    """Score of a source list ``(n,)`` against a query list ``(m,)``, both of pattern indices, for one part.

    dissimilarities: ``(k, k)`` between patterns, 1 the greatest. weight: of the part; as printed it scales the gain
    and not the penalty. Raises ValueError for an empty list.
    """
    source, query = np.ascontiguousarray(source, np.int64), np.ascontiguousarray(query, np.int64)
    if len(source) == 0 or len(query) == 0:
        raise ValueError("a pattern index list has at least one entry")
    table = np.ascontiguousarray(dissimilarities, np.float32)[query]
    following = _next_values(query)
    return _algorithm_2(source, table, following, float(weight), float(max_tolerance), int(min_con_num))


def scan(
    symbols: np.ndarray,
    starts: np.ndarray,
    query: np.ndarray,
    dissimilarities: np.ndarray,
    *,
    weight: float = 1.0,
    max_tolerance: float = MAX_TOLERANCE,
    min_con_num: int = MIN_CON_NUM,
) -> np.ndarray:
    """:func:`algorithm_2` for many lists ``symbols[starts[i]:starts[i + 1]]``: scores ``(n_lists,)`` float64."""
    table = np.ascontiguousarray(dissimilarities, np.float32)[query]
    following = _next_values(np.ascontiguousarray(query, np.int64))
    return _scan(symbols, starts, table, following, float(weight), float(max_tolerance), int(min_con_num))


@njit(nogil=True)
def _algorithm_2(
    source: IntArray, table: Float32Array, following: Int64Array, weight: float, max_tolerance: float, min_con_num: int
) -> float:
    score, count, i, j = 0.0, 0, 0, 0
    while i < len(source) and j < len(table):
        distance = table[j, source[i]]
        if distance <= max_tolerance:
            count, i, j = count + 1, i + 1, j + 1
        else:
            count = 0
            score -= distance
            if following[j] == -1:
                i, j = i + 1, 0
            else:
                j = following[j]
        if count >= min_con_num:
            score += weight
    return score / len(source)


@njit(nogil=True)
def _scan(
    symbols: Int32Array,
    starts: Int64Array,
    table: Float32Array,
    following: Int64Array,
    weight: float,
    max_tolerance: float,
    min_con_num: int,
) -> Float64Array:
    scores = np.empty(len(starts) - 1)
    for k in range(len(scores)):
        source = symbols[starts[k] : starts[k + 1]]
        scores[k] = _algorithm_2(source, table, following, weight, max_tolerance, min_con_num)
    return scores
