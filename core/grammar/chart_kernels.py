"""The loops of chart parsing; :class:`core.grammar.chart.Chart` checks and prepares what they are given."""

from __future__ import annotations

import numpy as np

from core.arrays import Float64Array, Int32Array, Int64Array
from core.compiled import njit

_ROUNDS = 200  # of the sum over cycles of rules; each shortens the rest
_SYMBOL = 0  # column of entries


@njit()
def viterbi(
    sentence: Int32Array,
    n_symbols: int,
    size: int,
    first: Int32Array,
    second: Int32Array,
    target: Int32Array,
    unit_first: Int32Array,
    unit_target: Int32Array,
    unit_weight: Float64Array,
    unit_label: Int32Array,
) -> tuple[Int32Array, Int32Array, Float64Array]:
    """Best derivations of a sentence ``(n,)``: index, entries and scores of :class:`core.grammar.chart._Best`.

    Entries of one span stand together: those of [i, j) are [begin[i, j], stop[i, j]).
    """
    n = len(sentence)
    index = np.full((n + 1, n + 1, n_symbols), -1, np.int32)
    begin, stop = np.zeros((n + 1, n + 1), np.int64), np.zeros((n + 1, n + 1), np.int64)
    entries, score, m = np.empty((1024, 5), np.int32), np.empty(1024), 0
    here = np.full(size, -1, np.int64)  # entry of each symbol in the span at hand
    for j in range(1, n + 1):
        for i in range(j - 1, -1, -1):
            begin[i, j] = m
            entries, score = _room(entries, score, m + size)
            if j == i + 1:
                m = _offer(entries, score, here, m, 0.0, sentence[i], -1, -1, -1, -1)
            for k in range(i + 1, j):
                for a in range(begin[i, k], stop[i, k]):
                    symbol = entries[a, _SYMBOL]
                    for e in range(first[symbol], first[symbol + 1]):
                        b = index[k, j, second[e]]
                        if b >= 0:
                            m = _offer(entries, score, here, m, score[a] + score[b], target[e], -1, a, b, k)
            m = _close(entries, score, here, begin[i, j], m, unit_first, unit_target, unit_weight, unit_label)
            stop[i, j] = m
            for a in range(begin[i, j], m):
                here[entries[a, _SYMBOL]] = -1
                if entries[a, _SYMBOL] < n_symbols:
                    index[i, j, entries[a, _SYMBOL]] = a
    return index, entries[:m], score[:m]


@njit()
def _room(entries: Int32Array, score: Float64Array, needed: int) -> tuple[Int32Array, Float64Array]:
    """The same with room for ``needed`` entries."""
    if needed <= len(score):
        return entries, score
    larger, scores = np.empty((2 * needed, 5), np.int32), np.empty(2 * needed)
    larger[: len(entries)], scores[: len(score)] = entries, score
    return larger, scores


@njit()
def _offer(
    entries: Int32Array,
    score: Float64Array,
    here: Int64Array,
    m: int,
    value: float,
    symbol: int,
    step: int,
    left: int,
    right: int,
    middle: int,
) -> int:
    """Keeps a derivation where it is its symbol's best in this span; the number of entries."""
    x = here[symbol]
    if x < 0:
        x = here[symbol] = m
        score[x] = -np.inf
        m += 1
    if value > score[x]:
        score[x] = value
        entries[x, 0], entries[x, 1], entries[x, 2], entries[x, 3], entries[x, 4] = symbol, step, left, right, middle
    return m


@njit()
def _close(
    entries: Int32Array,
    score: Float64Array,
    here: Int64Array,
    begin: int,
    m: int,
    unit_first: Int32Array,
    unit_target: Int32Array,
    unit_weight: Float64Array,
    unit_label: Int32Array,
) -> int:
    """Unit steps from the entries of a span, until none makes one better; the number of entries."""
    done = begin
    while done < m:
        again = m
        for a in range(done, m):
            for e in range(unit_first[entries[a, _SYMBOL]], unit_first[entries[a, _SYMBOL] + 1]):
                value, t = score[a] + unit_weight[e], unit_target[e]
                if here[t] >= 0 and value > score[here[t]]:
                    again = min(again, here[t])
                m = _offer(entries, score, here, m, value, t, unit_label[e], a, -1, -1)
        done = again
    return m


@njit()
def inside(
    sentence: Int32Array,
    start: int,
    n_symbols: int,
    size: int,
    first: Int32Array,
    second: Int32Array,
    target: Int32Array,
    unit_first: Int32Array,
    unit_target: Int32Array,
    unit_weight: Float64Array,
) -> float:
    """Log2 of the sum over all derivations of the sentence ``(n,)`` from ``start``."""
    n = len(sentence)
    table = np.full((n + 1, n + 1, n_symbols), -np.inf)
    begin, stop = np.zeros((n + 1, n + 1), np.int64), np.zeros((n + 1, n + 1), np.int64)
    symbol, score, m = np.empty(1024, np.int64), np.empty(1024), 0
    total = np.empty(size)
    for j in range(1, n + 1):
        for i in range(j - 1, -1, -1):
            total[:] = -np.inf
            if j == i + 1:
                total[sentence[i]] = 0.0
            for k in range(i + 1, j):
                for a in range(begin[i, k], stop[i, k]):
                    for e in range(first[symbol[a]], first[symbol[a] + 1]):
                        total[target[e]] = _plus(total[target[e]], score[a] + table[k, j, second[e]])
            _add_units(total, unit_first, unit_target, unit_weight)
            table[i, j] = total[:n_symbols]
            found = np.flatnonzero(total > -np.inf)
            while m + len(found) > len(score):
                symbol, score = np.concatenate((symbol, symbol)), np.concatenate((score, score))
            begin[i, j], stop[i, j] = m, m + len(found)
            symbol[m : m + len(found)], score[m : m + len(found)] = found, total[found]
            m += len(found)
    return float(table[0, n, start])


@njit()
def _add_units(total: Float64Array, unit_first: Int32Array, unit_target: Int32Array, unit_weight: Float64Array) -> None:
    """Adds to ``total`` what follows from it by unit steps, over and over: a cycle adds ever less."""
    fresh = total.copy()
    for _ in range(_ROUNDS):
        coming = np.full(len(total), -np.inf)
        for s in np.flatnonzero(fresh > -np.inf):
            for e in range(unit_first[s], unit_first[s + 1]):
                coming[unit_target[e]] = _plus(coming[unit_target[e]], fresh[s] + unit_weight[e])
        fresh = coming
        found = np.flatnonzero(coming > -np.inf)
        if not (coming[found] > total[found] - 50.0).any():
            return
        for s in found:
            total[s] = _plus(total[s], coming[s])


@njit()
def _plus(a: float, b: float) -> float:
    """Log2 of the sum of two numbers given by their log2."""
    if a < b:
        a, b = b, a
    return a if b == -np.inf else a + np.log2(1.0 + 2.0 ** (b - a))
