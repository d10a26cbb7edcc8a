"""Which motifs: the largest volume first (MMG section 3.3), exactly by an upper-bound heap, or by random seeds."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from core.arrays import Float64Array, Int64Array, IntArray
from core.compiled import njit
from core.motifs.matching import Matcher, Matches, Rule
from core.progress import Report, silent
from core.sequences.ordering import ascending
from core.sequences.repeats import Runs

Substrings = np.ndarray
"""A string motif: ``(n_motions, 2)`` int64, first and last letter of each motion, the seed first."""


class _Index(NamedTuple):
    """What the jitted kernels need: matches per seed, letters' times and lengths of seeds."""

    pointers: np.ndarray
    starts: np.ndarray
    ends: np.ndarray
    costs: np.ndarray
    times: np.ndarray
    min_letters: int
    lengths: int
    discount: float  # tightness over the highest cost a match can have


@njit(nogil=True)
def _seed(index: _Index, k: int) -> tuple[int, int]:
    first = k // index.lengths
    return first, first + k % index.lengths + index.min_letters - 1


@njit(nogil=True)
def _width(index: _Index, a: int, b: int) -> float:
    width: float = index.times[b] - index.times[a]
    return width


@njit(nogil=True)
def _weight(index: _Index, q: int) -> float:
    """What a match adds to the height of its motif: 1 in the paper."""
    weight: float = 1.0 - index.discount * index.costs[q]
    return weight


@njit(nogil=True)
def _bound(index: _Index, k: int, cut: Int64Array, rho: float) -> tuple[float, int]:
    """Upper bound of the seed's volume now and after any further partitioning.

    Of motions that all overlap one another a motif holds one at most. Taken by start, the matches fall into the fewest
    such groups; each group counts with its widest. Slightly inflated so that rounding never hides a motif.
    Also returns how many matches are still free.
    """
    first, last = _seed(index, k)
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
def _bounds(index: _Index, cut: Int64Array, rho: float) -> Float64Array:
    bounds = np.empty(len(index.pointers) - 1)
    for k in range(len(bounds)):
        bounds[k] = _bound(index, k, cut, rho)[0] if index.pointers[k] < index.pointers[k + 1] else 0.0
    return bounds


@njit(nogil=True)
def _motif_of(index: _Index, k: int, cut: Int64Array) -> tuple[Int64Array, float]:
    """The motif a seed gives now: itself, then its matches by ascending cost, dropping what overlaps one already in.

    Also its height without the seed, B_h - 1 where every match weighs 1.
    """
    first, last = _seed(index, k)
    low = index.pointers[k]
    order = ascending(index.costs[low : index.pointers[k + 1]])
    chosen = np.empty((len(order) + 1, 2), np.int64)
    chosen[0, 0], chosen[0, 1], n, height = first, last, 1, 0.0
    for q in order:
        a, b = index.starts[low + q], index.ends[low + q]
        free = cut[a] >= b
        h = 0
        while free and h < n:
            free = a >= chosen[h, 1] or b <= chosen[h, 0]
            h += 1
        if free:
            chosen[n, 0], chosen[n, 1] = a, b
            n, height = n + 1, height + _weight(index, low + q)
    return chosen[:n], height


@njit(nogil=True)
def _volume(index: _Index, k: int, cut: Int64Array, rho: float) -> float:
    motif, height = _motif_of(index, k, cut)
    total = 0.0
    for h in range(len(motif)):
        total += _width(index, motif[h, 0], motif[h, 1])
    volume: float = height * (total / len(motif)) ** rho
    return volume


@njit(nogil=True)
def _partition(motif: IntArray, cut: Int64Array) -> None:
    """Mark the motions' transitions as partitioned: ``cut[j]`` is the first partitioned transition at or after j."""
    for h in range(len(motif)):
        a, b = motif[h, 0], motif[h, 1]
        for j in range(a, b):
            cut[j] = j
        j = a - 1
        while j >= 0 and cut[j] > a:
            cut[j] = a
            j -= 1


class _Heap(NamedTuple):
    """A binary max-heap of seeds in arrays ``(n_seeds,)``; size: (1,). Of equal keys the first seed is on top."""

    keys: np.ndarray
    seeds: np.ndarray
    size: np.ndarray


@njit(nogil=True)
def _push(heap: _Heap, key: float, seed: int) -> None:
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
def _pop(heap: _Heap) -> tuple[float, int]:
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


def _heap_of(bounds: np.ndarray) -> _Heap:
    """All seeds with a positive bound; a descending array is a heap. bounds: (n_seeds,)."""
    seeds = np.argsort(-bounds, kind="stable")
    seeds = seeds[: np.count_nonzero(bounds > 0)]
    return _Heap(bounds[seeds], seeds, np.array([len(seeds)]))


@njit(nogil=True)
def _largest(index: _Index, heap: _Heap, volumes: Float64Array, counts: Int64Array, cut: Int64Array, rho: float) -> int:
    """The seed of the largest volume (ties: the first), -1 when none is left; the heap's keys are upper bounds.

    A seed's volume is computed only while its bound still beats the best volume of this round, and again later only
    if one of its matches has gone since (counts).
    """
    best, winner = 0.0, -1
    waiting, n = np.empty((64, 2)), 0
    while heap.size[0] and heap.keys[0] >= best:
        key, k = _pop(heap)
        bound, free = _bound(index, k, cut, rho)
        if bound < key:
            if bound > 0:
                _push(heap, bound, k)
            continue
        if counts[k] != free:
            counts[k], volumes[k] = free, _volume(index, k, cut, rho)
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
    return winner


def largest_first(
    runs: Runs, matches: Matches, rule: Rule, rho: float, *, tightness: float = 0.0, report: Report = silent
) -> list[Substrings]:
    """Exact greedy discovery: again and again the motif of largest volume V = (B_h - 1) B_w^rho; deterministic.

    tightness: ours. A match at the highest allowed mean cost adds 1 - tightness to the height, one at cost 0 adds 1, so
    that of two volumes about equal the motif of nearer motions comes first, around a seed in its middle. 0: the paper.
    """
    index, cut = _index(runs, matches, rule, tightness), _first_cuts(runs)
    heap = _heap_of(_bounds(index, cut, rho))
    volumes, counts = np.zeros(len(matches.pointers)), np.full(len(matches.pointers), -1, np.int64)
    motifs: list[Substrings] = []
    while (k := _largest(index, heap, volumes, counts, cut, rho)) >= 0:
        motifs.append(_motif_of(index, k, cut)[0])
        _partition(motifs[-1], cut)
        report("discovery", float((cut == np.arange(len(cut))).mean()))
    report("discovery", 1.0)
    return motifs


def random_seeds(
    runs: Runs,
    matches: Matches,
    rule: Rule,
    rho: float,
    seed: int = 0,
    *,
    tightness: float = 0.0,
    report: Report = silent,
    letters_a_round: int = 4,
) -> list[Substrings]:
    """The paper's discovery: seeds are all unpartitioned substrings that contain one of a few random letters.

    Letters are drawn by how often they still occur. The largest motif among the seeds is kept; where no seed matches
    anything, two letters of a random one are cut out, so that the search ends.
    """
    index, cut = _index(runs, matches, rule, tightness), _first_cuts(runs)
    rng, motifs = np.random.default_rng(seed), []
    last = np.arange(len(cut))
    while len(free := _seeds_left(index, cut, last)):
        drawn = rng.choice(runs.letters[np.unique(_first_letters(index, free))], letters_a_round)
        seeds = free[_contain(index, free, np.isin(runs.letters, drawn))]
        k = _best_of(index, seeds, cut, rho)
        if k >= 0:
            motifs.append(_motif_of(index, k, cut)[0])
        else:
            first, _ = _seed(index, rng.choice(seeds))
        _partition(motifs[-1] if k >= 0 else np.array([[first, first + 1]]), cut)
        report("discovery", float((cut == last).mean()))
    report("discovery", 1.0)
    return motifs


def join_leftovers(
    runs: Runs, matcher: Matcher, motifs: list[Substrings], rule: Rule, report: Report = silent
) -> list[Substrings]:
    """Ours: unpartitioned substrings join the motif whose motions they match, under a looser rule than it was found
    with.

    Two thresholds, as in edge tracing: a motif has to be found among near motions, but takes in one somewhat further
    off. Nearest first; motifs neither appear nor meet, and who joined attracts nobody else.
    """
    cut = _first_cuts(runs)
    for motif in motifs:
        _partition(motif, cut)
    offers = []
    for number, motif in enumerate(motifs):
        for first, last in motif:
            matches = matcher.of(int(first), int(last), rule)
            free = np.flatnonzero(cut[matches.starts] >= matches.ends)
            offers += [(matches.costs[q], number, matches.starts[q], matches.ends[q]) for q in free]
        report("joining", (number + 1) / len(motifs))
    grown = [list(map(tuple, motif)) for motif in motifs]
    for _, number, first, last in sorted(offers):
        if cut[first] >= last:
            grown[number].append((int(first), int(last)))
            _partition(np.array([[first, last]]), cut)
    return [np.array(motif, np.int64) for motif in grown]


def _seeds_left(index: _Index, cut: np.ndarray, last: np.ndarray) -> np.ndarray:
    """All unpartitioned seeds, ``(n_seeds,)``."""
    reach = cut[:, None] - last[:, None]
    lengths = np.arange(index.lengths) + index.min_letters - 1
    return np.flatnonzero(reach >= lengths)


def _first_letters(index: _Index, seeds: np.ndarray) -> np.ndarray:
    """First letters ``(n_seeds,)`` of seeds ``(n_seeds,)``."""
    return seeds // index.lengths


def _contain(index: _Index, seeds: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Whether each seed holds one of the letters marked in ``wanted`` (m,)."""
    before = np.concatenate([[0], np.cumsum(wanted)])
    first = _first_letters(index, seeds)
    stop = first + seeds % index.lengths + index.min_letters
    held: np.ndarray = before[stop] > before[first]
    return held


@njit(nogil=True)
def _best_of(index: _Index, seeds: Int64Array, cut: Int64Array, rho: float) -> int:
    best, winner = 0.0, -1
    for k in seeds:
        volume = _volume(index, k, cut, rho)
        if volume > best:
            best, winner = volume, k
    return winner


def _index(runs: Runs, matches: Matches, rule: Rule, tightness: float) -> _Index:
    times = runs.middles.astype(np.float64)
    discount = tightness / rule.max_cost if 0 < rule.max_cost < np.inf else 0.0
    return _Index(*matches, times, rule.min_letters, rule.max_letters - rule.min_letters + 1, float(discount))


def _first_cuts(runs: Runs) -> np.ndarray:
    """For each letter the first transition at or after it that crosses a clip's end: ``(m,)`` int64."""
    return runs.stops.astype(np.int64) - 1
