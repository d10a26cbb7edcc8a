"""Volumes of motifs and the largest of them, compiled: the heap of upper bounds behind the greedy discovery."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float64Array, Int64Array, IntArray
from core.compiled import njit
from core.motifs.matching import Matches, Rule
from core.sequences.ordering import ascending
from core.sequences.repeats import Runs


class Index(NamedTuple):
    """What the jitted kernels need: matches per seed, letters' times and lengths of seeds."""

    pointers: np.ndarray
    starts: np.ndarray
    ends: np.ndarray
    costs: np.ndarray
    firsts: np.ndarray
    times: np.ndarray
    min_letters: int
    lengths: int
    discount: float  # tightness over the highest cost a match can have


@njit(nogil=True)
def seed_of(index: Index, k: int) -> tuple[int, int]:
    """First and last letter of seed k, which may reach beyond its clip if it has no matches."""
    first = index.firsts[k // index.lengths]
    return first, first + k % index.lengths + index.min_letters - 1


@njit(nogil=True)
def _width(index: Index, a: int, b: int) -> float:
    width: float = index.times[b] - index.times[a]
    return width


@njit(nogil=True)
def _weight(index: Index, q: int) -> float:
    """What a match adds to the height of its motif: 1 in the paper."""
    weight: float = 1.0 - index.discount * index.costs[q]
    return weight


@njit(nogil=True)
def bound_of(index: Index, k: int, cut: Int64Array, rho: float) -> tuple[float, int]:
    """Upper bound of the seed's volume now and after any further partitioning.

    Of motions that all overlap one another a motif holds one at most. Taken by start, the matches fall into the fewest
    such groups; each group counts with its widest. Slightly inflated so that rounding never hides a motif.
    Also returns how many matches are still free.
    """
    first, last = seed_of(index, k)
    if last >= len(cut) or cut[first] < last:
        return 0.0, 0
    widths = np.empty(index.pointers[k + 1] - index.pointers[k])
    n, free, reach = 0, 0, -1
    for q in range(index.pointers[k], index.pointers[k + 1]):
        a, b = index.starts[q], index.ends[q]
        if cut[a] < b:
            continue
        free += 1
        if a >= reach:
            n, reach = n + 1, b
            widths[n - 1] = 0.0
        reach = min(reach, b)
        widths[n - 1] = max(widths[n - 1], _width(index, a, b))
    order = ascending(widths[:n])
    total, best = _width(index, first, last), 0.0
    for h in range(n):
        total += widths[order[n - 1 - h]]
        best = max(best, (h + 1) * (total / (h + 2)) ** rho)
    return best * (1 + 1e-9), free


@njit(nogil=True)
def bounds_of(index: Index, cut: Int64Array, rho: float) -> Float64Array:
    """Upper bounds of the volumes of all seeds, ``(n_seeds,)``; cut: (m,)."""
    bounds = np.empty(len(index.pointers) - 1)
    for k in range(len(bounds)):
        bounds[k] = bound_of(index, k, cut, rho)[0] if index.pointers[k] < index.pointers[k + 1] else 0.0
    return bounds


@njit(nogil=True)
def motif_of(index: Index, k: int, cut: Int64Array) -> tuple[Int64Array, float]:
    """The motif a seed gives now: itself, then its matches by ascending cost, dropping what overlaps one already in.

    Also its height without the seed, B_h - 1 where every match weighs 1.
    """
    first, last = seed_of(index, k)
    low, n_matches = index.pointers[k], index.pointers[k + 1] - index.pointers[k]
    order = ascending(index.costs[low : low + n_matches])
    longest = 0
    for q in range(low, low + n_matches):
        longest = max(longest, index.ends[q] - index.starts[q])
    chosen, taken = np.empty((n_matches + 1, 2), np.int64), np.zeros(n_matches, np.bool_)
    chosen[0, 0], chosen[0, 1], n, height = first, last, 1, 0.0
    for q in order:
        a, b = index.starts[low + q], index.ends[low + q]
        free = cut[a] >= b and (a >= last or b <= first)
        r = q - 1  # matches are in the order of their starts, so those that overlap this one are beside it
        while free and r >= 0 and index.starts[low + r] + longest > a:
            free = not (taken[r] and index.ends[low + r] > a)
            r -= 1
        r = q + 1
        while free and r < n_matches and index.starts[low + r] < b:
            free = not taken[r]
            r += 1
        if free:
            taken[q] = True
            chosen[n, 0], chosen[n, 1] = a, b
            n, height = n + 1, height + _weight(index, low + q)
    return chosen[:n], height


@njit(nogil=True)
def volume_of(index: Index, k: int, cut: Int64Array, rho: float) -> float:
    """Volume of the motif that seed k, which has matches, gives now; cut: (m,)."""
    motif, height = motif_of(index, k, cut)
    total = 0.0
    for h in range(len(motif)):
        total += _width(index, motif[h, 0], motif[h, 1])
    volume: float = height * (total / len(motif)) ** rho
    return volume


@njit(nogil=True)
def partition(motif: IntArray, cut: Int64Array) -> None:
    """Mark the motions' transitions as partitioned: ``cut[j]`` is the first partitioned transition at or after j."""
    for h in range(len(motif)):
        a, b = motif[h, 0], motif[h, 1]
        for j in range(a, b):
            cut[j] = j
        j = a - 1
        while j >= 0 and cut[j] > a:
            cut[j] = a
            j -= 1


class Heap(NamedTuple):
    """A binary max-heap of seeds in arrays ``(n_seeds,)``; size: (1,). Of equal keys the first seed is on top."""

    keys: np.ndarray
    seeds: np.ndarray
    size: np.ndarray


@njit(nogil=True)
def _push(heap: Heap, key: float, seed: int) -> None:
    i = heap.size[0]
    heap.size[0] += 1
    while i > 0:
        up = (i - 1) // 2
        if not _above(key, seed, heap.keys[up], heap.seeds[up]):
            break
        heap.keys[i], heap.seeds[i] = heap.keys[up], heap.seeds[up]
        i = up
    heap.keys[i], heap.seeds[i] = key, seed


@njit(nogil=True)
def _pop(heap: Heap) -> tuple[float, int]:
    top_key, top_seed = heap.keys[0], heap.seeds[0]
    heap.size[0] -= 1
    n = heap.size[0]
    key, seed, i = heap.keys[n], heap.seeds[n], 0
    while 2 * i + 1 < n:
        down = 2 * i + 1
        if down + 1 < n and _above(heap.keys[down + 1], heap.seeds[down + 1], heap.keys[down], heap.seeds[down]):
            down += 1
        if not _above(heap.keys[down], heap.seeds[down], key, seed):
            break
        heap.keys[i], heap.seeds[i] = heap.keys[down], heap.seeds[down]
        i = down
    heap.keys[i], heap.seeds[i] = key, seed
    return top_key, top_seed


@njit(nogil=True)
def _above(key: float, seed: int, other_key: float, other_seed: int) -> bool:
    return key > other_key or (key == other_key and seed < other_seed)


def heap_of(bounds: np.ndarray) -> Heap:
    """All seeds with a positive bound; a descending array is a heap. bounds: (n_seeds,)."""
    seeds = np.argsort(-bounds, kind="stable")
    seeds = seeds[: np.count_nonzero(bounds > 0)]
    return Heap(bounds[seeds], seeds, np.array([len(seeds)]))


@njit(nogil=True)
def largest(
    index: Index, heap: Heap, volumes: Float64Array, counts: Int64Array, cut: Int64Array, rho: float
) -> tuple[int, Int64Array]:
    """The seed of the largest volume (ties: the first), -1 when none is left; the heap's keys are upper bounds.

    Also all seeds whose volumes were compared: no other seed can be as large as the winner.

    A seed's volume is computed only while its bound still beats the best volume of this round, and again later only
    if one of its matches has gone since (counts).
    """
    best, winner = 0.0, -1
    waiting, n = np.empty((64, 2)), 0
    while heap.size[0] and heap.keys[0] >= best:
        key, k = _pop(heap)
        bound, free = bound_of(index, k, cut, rho)
        if bound < key:
            if bound > 0:
                _push(heap, bound, k)
            continue
        if counts[k] != free:
            counts[k], volumes[k] = free, volume_of(index, k, cut, rho)
        if n == len(waiting):
            longer = np.empty((2 * n, 2))
            for w in range(n):
                longer[w, 0], longer[w, 1] = waiting[w, 0], waiting[w, 1]
            waiting = longer
        waiting[n, 0], waiting[n, 1], n = key, k, n + 1
        if volumes[k] > best or (volumes[k] == best and k < winner):
            best, winner = volumes[k], k
    for w in range(n):
        _push(heap, waiting[w, 0], int(waiting[w, 1]))
    return winner, waiting[:n, 1].astype(np.int64)


def index_of(runs: Runs, matches: Matches, rule: Rule, tightness: float) -> Index:
    """The matches ready for the kernels; tightness: share of its height that the furthest match allowed loses."""
    times = runs.middles.astype(np.float64)
    discount = tightness / rule.max_cost if 0 < rule.max_cost < np.inf else 0.0
    return Index(*matches, times, rule.min_letters, rule.max_letters - rule.min_letters + 1, float(discount))
