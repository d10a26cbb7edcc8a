"""Which motifs: the largest volume first (MMG section 3.3), exactly by an upper-bound heap, or by random seeds."""

from __future__ import annotations

import numpy as np

from core.arrays import Int64Array
from core.compiled import njit
from core.motifs.matching import Matches, Rule, first_cuts
from core.motifs.volumes import (
    Index,
    bounds_of,
    heap_of,
    index_of,
    largest,
    motif_of,
    partition,
    seed_of,
    volume_of,
)
from core.progress import Report, silent
from core.sequences.repeats import Runs

Substrings = np.ndarray
"""A string motif: ``(n_motions, 2)`` int64, first and last letter of each motion, the seed first."""


def largest_first(
    runs: Runs, matches: Matches, rule: Rule, rho: float, *, tightness: float = 0.0, report: Report = silent
) -> list[Substrings]:
    """Exact greedy discovery: again and again the motif of largest volume V = (B_h - 1) B_w^rho; deterministic.

    tightness: ours. A match at the highest allowed mean cost adds 1 - tightness to the height, one at cost 0 adds 1, so
    that of two volumes about equal the motif of nearer motions comes first, around a seed in its middle. 0: the paper.
    """
    index, cut = index_of(runs, matches, rule, tightness), first_cuts(runs)
    heap = heap_of(bounds_of(index, cut, rho))
    volumes, counts = np.zeros(len(matches.pointers)), np.full(len(matches.pointers), -1, np.int64)
    motifs: list[Substrings] = []
    while (k := largest(index, heap, volumes, counts, cut, rho)[0]) >= 0:
        motifs.append(motif_of(index, k, cut)[0])
        partition(motifs[-1], cut)
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
    index, cut = index_of(runs, matches, rule, tightness), first_cuts(runs)
    rng, motifs = np.random.default_rng(seed), []
    last = np.arange(len(cut))
    while len(free := _seeds_left(index, cut, last)):
        drawn = rng.choice(runs.letters[np.unique(_first_letters(index, free))], letters_a_round)
        seeds = free[_contain(index, free, np.isin(runs.letters, drawn))]
        k = _best_of(index, seeds, cut, rho)
        if k >= 0:
            motifs.append(motif_of(index, k, cut)[0])
        else:
            first, _ = seed_of(index, rng.choice(seeds))
        partition(motifs[-1] if k >= 0 else np.array([[first, first + 1]]), cut)
        report("discovery", float((cut == last).mean()))
    report("discovery", 1.0)
    return motifs


def _seeds_left(index: Index, cut: np.ndarray, last: np.ndarray) -> np.ndarray:
    """All unpartitioned seeds, ``(n_seeds,)``."""
    reach = cut[:, None] - last[:, None]
    lengths = np.arange(index.lengths) + index.min_letters - 1
    return np.flatnonzero(reach >= lengths)


def _first_letters(index: Index, seeds: np.ndarray) -> np.ndarray:
    """First letters ``(n_seeds,)`` of seeds ``(n_seeds,)``."""
    first: np.ndarray = index.firsts[seeds // index.lengths]
    return first


def _contain(index: Index, seeds: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Whether each seed holds one of the letters marked in ``wanted`` (m,)."""
    before = np.concatenate([[0], np.cumsum(wanted)])
    first = _first_letters(index, seeds)
    stop = first + seeds % index.lengths + index.min_letters
    held: np.ndarray = before[stop] > before[first]
    return held


@njit(nogil=True)
def _best_of(index: Index, seeds: Int64Array, cut: Int64Array, rho: float) -> int:
    best, winner = 0.0, -1
    for k in seeds:
        volume = volume_of(index, k, cut, rho)
        if volume > best:
            best, winner = volume, k
    return winner
