"""The alignment programme of matching, compiled: which substrings match a seed (MMG section 3.4)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float32Array, Int32Array, Int64Array
from core.compiled import njit

_INFINITE = np.float32(np.inf)
_Real = float | np.float32


class Rule(NamedTuple):
    """When an alignment is a match.

    min_letters, max_letters: lengths of the seed; gamma: slope limit of the alignment and of the durations; slack:
    freedom around a held pose, in shares of its duration; max_cost: highest mean distance along the alignment;
    min_frames: the shortest motion on either side.
    """

    min_letters: int = 5
    max_letters: int = 30
    gamma: _Real = 1.5
    slack: _Real = 0.5
    max_cost: _Real = np.inf
    min_frames: _Real = 0.0


class Text(NamedTuple):
    """The runs as the jitted kernels want them: each array ``(m,)``; middles and lengths float32, in frames."""

    letters: np.ndarray
    middles: np.ndarray
    lengths: np.ndarray
    firsts: np.ndarray
    stops: np.ndarray


@njit(nogil=True)
def inverted_lists(
    text: Text, distances: Float32Array, adjacent: tuple[Int64Array, Int32Array], among: Int64Array
) -> tuple[Int64Array, Int32Array]:
    """For each letter the places ``among`` these, in their order, where a match of a seed with that letter may begin.

    adjacent: pointers (kappa + 1,) and the letters adjacent to each letter, its own among them. Returns pointers
    (kappa + 1,) and places: those of letter x are ``places[pointers[x] : pointers[x + 1]]``.
    """
    letters, _, _, firsts, stops = text
    begins, neighbours = adjacent
    pointers = np.zeros(len(begins), np.int64)
    for a in among:
        for k in range(begins[letters[a]], begins[letters[a] + 1]):
            pointers[neighbours[k] + 1] += _is_nearest(letters, firsts, stops, distances, neighbours[k], a)
    for x in range(len(begins) - 1):
        pointers[x + 1] += pointers[x]
    at, places = pointers[:-1].copy(), np.empty(pointers[-1], np.int32)
    for a in among:
        for k in range(begins[letters[a]], begins[letters[a] + 1]):
            x = neighbours[k]
            if _is_nearest(letters, firsts, stops, distances, x, a):
                places[at[x]] = a
                at[x] += 1
    return pointers, places


@njit(nogil=True)
def places_like(x: int, text: Text, distances: Float32Array, costs: Float32Array, among: Int64Array) -> Int32Array:
    """One of the inverted lists: places ``among`` these where a match of a seed with first letter x may begin."""
    letters, _, _, firsts, stops = text
    places, n = np.empty(len(among), np.int32), 0
    for a in among:
        if costs[x, letters[a]] < np.inf and _is_nearest(letters, firsts, stops, distances, x, a):
            places[n] = a
            n += 1
    return places[:n]


@njit(nogil=True)
def _is_nearest(
    letters: Int32Array, firsts: Int32Array, stops: Int32Array, distances: Float32Array, x: int, a: int
) -> bool:
    """Whether place a is nearer to letter x than the letters beside it; beyond a clip's end all is infinitely far.

    Distances are symmetric; read from the place to the letter, neighbouring letters lie side by side in memory.
    """
    here = distances[letters[a], x]
    if a > firsts[a] and distances[letters[a - 1], x] <= here:
        return False
    return not (a + 1 < stops[a] and distances[letters[a + 1], x] <= here)


@njit(nogil=True)
def _cheaper(total: np.float32, steps: int, best: np.float32, n: int) -> bool:
    """Whether an alignment is cheaper; of equal costs, which equal letters give, the shorter path counts."""
    return bool(total < best or (total == best and steps < n))


@njit(nogil=True)
def _next_row(
    letters: Int32Array,
    middles: Float32Array,
    lengths: Float32Array,
    costs: Float32Array,
    gamma: _Real,
    slack: _Real,
    seed: int,
    start: int,
    row: int,
    columns: int,
    low: int,
    high: int,
    totals: Float32Array,
    steps: Int32Array,
) -> tuple[int, int]:
    """One letter more of the seed: costs and lengths of the best alignments that end at each letter of the candidate.

    totals, steps: (2, n) buffers, row parity alternates; [low, high] are the reachable columns of the row before.
    Returns the reachable columns of this row, (0, -1) when there are none. Takes plain arrays: a tuple of arrays would
    count references, atomically, at every call.
    """
    new, old = row % 2, 1 - row % 2
    x = letters[seed + row]
    seed_time = middles[seed + row] - middles[seed]
    seed_slack = slack * lengths[seed + row]
    longest, origin = gamma * seed_time, middles[start]
    first, last = 0, -1
    left, left_steps = _INFINITE, 0
    corner, corner_steps = (np.float32(0), 0) if row == 0 else (_INFINITE, 0)
    totals[old, high + 1] = _INFINITE
    if row == 0:
        totals[old, 0] = _INFINITE
    for c in range(low, columns):
        up, up_steps = _INFINITE, 0
        if c <= high + 1:
            up, up_steps = totals[old, c], steps[old, c]
        elif left == _INFINITE:
            break
        best, n = corner, corner_steps
        corner, corner_steps = up, up_steps
        if _cheaper(up, up_steps, best, n):
            best, n = up, up_steps
        if _cheaper(left, left_steps, best, n):
            best, n = left, left_steps
        best += costs[x, letters[start + c]]
        if best < _INFINITE:
            time, freedom = middles[start + c] - origin, seed_slack + slack * lengths[start + c]
            if time > longest + freedom or seed_time > gamma * (time + freedom):
                best = _INFINITE
            else:
                if last < first:
                    first = c
                last = c
        totals[new, c], steps[new, c] = best, n + 1
        left, left_steps = best, n + 1
    return first, last


@njit(nogil=True)
def match_seeds(
    seeds: Int64Array,
    limits: Int64Array,
    text: Text,
    cut: Int64Array,
    columns: int,
    distances: Float32Array,
    costs: Float32Array,
    rule: Rule,
    pointers: Int64Array,
    places: Int32Array,
) -> tuple[Int32Array, Float32Array]:
    """Matches of all seeds that start at the letters ``seeds``, as (number of the start, row, first, last letter).

    limits: the last letter that each seed may have; cut: (m,) first partitioned transition at or after each letter,
    which no match crosses; columns: the most letters a match may have; pointers, places: inverted lists of places where
    matches may begin. Matches come in the order of discovery and never overlap their seed: they share an end letter
    with it at most.
    """
    letters, middles, lengths, firsts, stops = text
    min_letters, max_letters, gamma, slack, max_cost, min_frames = rule
    totals, steps = np.empty((2, columns + 1), np.float32), np.empty((2, columns + 1), np.int32)
    n_found, spans, values = 0, np.empty((4096, 4), np.int32), np.empty(4096, np.float32)
    for number in range(len(seeds)):
        seed = seeds[number]
        x = letters[seed]
        for q in range(pointers[x], pointers[x + 1]):
            start = places[q]
            rows = min(max_letters, limits[number] - seed + 1)
            width = cut[start] - start + 1
            if start == seed or rows < min_letters:
                continue
            if start > seed:
                rows = min(rows, start - seed + 1)
            else:
                width = min(width, seed - start + 1)
            low, high = 0, 0
            for row in range(rows):
                low, high = _next_row(
                    letters, middles, lengths, costs, gamma, slack, seed, start, row, width, low, high, totals, steps
                )
                if high < low:
                    break
                if row + 1 < min_letters or middles[seed + row] - middles[seed] < min_frames:
                    continue
                if n_found + high - low + 1 > len(values):
                    spans, values = _grown(spans, values, n_found, high - low + 1)
                n_found = _collect(
                    letters, middles, firsts, stops, distances, gamma, max_cost, min_frames,
                    number, seed, start, row, low, high, totals, steps, n_found, spans, values,
                )  # fmt: skip
    return spans[:n_found], values[:n_found]


@njit(nogil=True)
def _grown(spans: Int32Array, values: Float32Array, found: int, more: int) -> tuple[Int32Array, Float32Array]:
    size = 2 * len(values) + more
    new_spans, new_values = np.empty((size, 4), np.int32), np.empty(size, np.float32)
    for k in range(found):  # slice assignment would take seconds more to compile
        new_values[k] = values[k]
        for i in range(4):
            new_spans[k, i] = spans[k, i]
    return new_spans, new_values


@njit(nogil=True)
def _collect(
    letters: Int32Array,
    middles: Float32Array,
    firsts: Int32Array,
    stops: Int32Array,
    distances: Float32Array,
    gamma: _Real,
    max_cost: _Real,
    min_frames: _Real,
    number: int,
    seed: int,
    start: int,
    row: int,
    low: int,
    high: int,
    totals: Float32Array,
    steps: Int32Array,
    found: int,
    spans: Int32Array,
    values: Float32Array,
) -> int:
    """Add the alignments of this row that end at an end candidate and keep duration ratio and mean cost."""
    x = letters[seed + row]
    seed_time = middles[seed + row] - middles[seed]
    for c in range(max(low, 1), high + 1):
        total = totals[row % 2, c]
        if total == _INFINITE or not total <= max_cost * steps[row % 2, c]:  # no limit, still no path
            continue
        time = middles[start + c] - middles[start]
        if time < min_frames or time > gamma * seed_time or seed_time > gamma * time:
            continue
        if _is_nearest(letters, firsts, stops, distances, x, start + c):
            spans[found, 0], spans[found, 1] = number, row
            spans[found, 2], spans[found, 3] = start, start + c
            values[found] = total / steps[row % 2, c]
            found += 1
    return found


@njit(nogil=True)
def by_seed(
    n_starts: int, spans: Int32Array, values: Float32Array, rule: Rule
) -> tuple[Int64Array, Int32Array, Int32Array, Float32Array]:
    """Counting sort by seed of what :func:`match_seeds` found; the order within a seed (by start, then end) stays."""
    lengths = rule.max_letters - rule.min_letters + 1
    pointers = np.zeros(n_starts * lengths + 1, np.int64)
    for k in range(len(values)):
        pointers[spans[k, 0] * lengths + spans[k, 1] + 2 - rule.min_letters] += 1
    for k in range(len(pointers) - 1):
        pointers[k + 1] += pointers[k]
    at = pointers[:-1].copy()
    starts, ends = np.empty(len(values), np.int32), np.empty(len(values), np.int32)
    costs = np.empty(len(values), np.float32)
    for k in range(len(values)):
        row = spans[k, 0] * lengths + spans[k, 1] + 1 - rule.min_letters
        starts[at[row]], ends[at[row]], costs[at[row]] = spans[k, 2], spans[k, 3], values[k]
        at[row] += 1
    return pointers, starts, ends, costs
