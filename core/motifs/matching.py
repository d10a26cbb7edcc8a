"""Which substrings match which: one alignment programme for all seeds that start at one letter (MMG section 3.4)."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.motifs.adjacency import Adjacency
from core.motifs.match_kernels import Rule, Text, by_seed, inverted_lists, match_seeds, places_like
from core.progress import Report, silent
from core.sequences.repeats import Runs

__all__ = ["Matcher", "Matches", "Rule", "first_cuts"]

_BLOCK = 50_000  # pairs of seed start and candidate matched at a time, some tens of milliseconds
_TRIED = 256  # letters from whose matches the number of all is estimated
_BYTES = 2 * 12  # of a match: in its block and among all


class Matches(NamedTuple):
    """Matches of all seeds that start at certain letters. Seed (firsts[i], firsts[i] + l) is row
    ``i * (max_letters - min_letters + 1) + l + 1 - min_letters``.

    pointers: (n_seeds + 1,) where each seed's matches begin; starts, ends: (n_matches,) int32 first and last letter of
    the match, ordered by start, then end; costs: (n_matches,) float32 mean distance along its best alignment; firsts:
    the letters at which seeds start, ascending.
    """

    pointers: np.ndarray
    starts: np.ndarray
    ends: np.ndarray
    costs: np.ndarray
    firsts: np.ndarray


def first_cuts(runs: Runs) -> np.ndarray:
    """For each letter the first transition at or after it that crosses a clip's end: ``(m,)`` int64."""
    cuts: np.ndarray = runs.stops.astype(np.int64) - 1
    return cuts


class Matcher:
    """The string, ready to be asked for matches; m runs."""

    def __init__(self, runs: Runs, adjacency: Adjacency):
        self.text = Text(runs.letters, runs.middles, runs.lengths, runs.firsts, runs.stops)
        self.adjacency = adjacency
        self._uncut = first_cuts(runs)
        self._columns = int((runs.stops - runs.firsts).max(initial=1))
        letters, adjacent = np.nonzero(np.isfinite(adjacency.costs))
        begins = np.searchsorted(letters, np.arange(len(adjacency.costs) + 1))
        self._adjacent = begins.astype(np.int64), adjacent.astype(np.int32)

    def of(
        self, first: int, last: int, rule: Rule, cut: np.ndarray | None = None, among: np.ndarray | None = None
    ) -> Matches:
        """Matches of the one seed (first, last), whatever its length and whether or not it is partitioned itself.

        cut, among: as in :meth:`all`.
        """
        n = last - first + 1
        return self._starting_at(first, last, rule._replace(min_letters=n, max_letters=n), cut, among)

    def starting_at(
        self, first: int, rule: Rule, cut: np.ndarray | None = None, among: np.ndarray | None = None
    ) -> Matches:
        """Matches of all seeds that start at letter ``first``. cut ``(m,)``, among ``(n,)``: as in :meth:`all`."""
        return self._starting_at(first, int(self._cuts(cut)[first]), rule, cut, among)

    def expected_bytes(self, rule: Rule) -> float:
        """About how much memory the matches of all seeds take while they are put together, from some of the seeds."""
        some = np.unique(np.linspace(0, len(self._uncut) - 1, _TRIED).astype(np.int64))
        found = sum(len(self.starting_at(int(first), rule).costs) for first in some)
        return _BYTES * found * len(self._uncut) / len(some)

    def _starting_at(
        self, first: int, limit: int, rule: Rule, cut: np.ndarray | None, among: np.ndarray | None
    ) -> Matches:
        a, x = self.adjacency, self.text.letters[first]
        places = places_like(x, self.text, a.distances, a.costs, self._all_letters(among))
        pointers = np.zeros(len(a.costs) + 1, np.int64)
        pointers[x + 1 :] = len(places)
        return self._block(np.array([first]), np.array([limit]), rule, self._cuts(cut), pointers, places)

    def all(
        self, rule: Rule, report: Report = silent, cut: np.ndarray | None = None, among: np.ndarray | None = None
    ) -> Matches:
        """Matches of all seeds, in parallel; cost about linear in the pairs of places with adjacent letters.

        cut: ``(m,)`` first partitioned transition at or after each letter, where it is not that of the clips' ends;
        among: the letters ``(n,)``, ascending, at which seeds and matches may start, where these are not all.
        """
        a, among, cut = self.adjacency, self._all_letters(among), self._cuts(cut)
        lists = inverted_lists(self.text, a.distances, self._adjacent, among)
        cuts = _even_blocks(np.cumsum(np.diff(lists[0])[self.text.letters[among]]), _BLOCK)
        blocks: list[Matches] = []
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            futures = [
                pool.submit(self._block, among[b:e], cut[among[b:e]], rule, cut, *lists) for b, e in pairwise(cuts)
            ]
            try:
                for k, future in enumerate(futures):
                    blocks.append(future.result())
                    report("matching", (k + 1) / len(futures))
            except BaseException:
                for future in futures:
                    future.cancel()
                raise
        return _concatenated(blocks)

    def _block(
        self,
        firsts: np.ndarray,
        limits: np.ndarray,
        rule: Rule,
        cut: np.ndarray,
        pointers: np.ndarray,
        places: np.ndarray,
    ) -> Matches:
        a, rule = self.adjacency, _typed(rule)
        found = match_seeds(firsts, limits, self.text, cut, self._columns, a.distances, a.costs, rule, pointers, places)
        return Matches(*by_seed(len(firsts), *found, rule), firsts)

    def _cuts(self, cut: np.ndarray | None) -> np.ndarray:
        return self._uncut if cut is None else cut

    def _all_letters(self, among: np.ndarray | None) -> np.ndarray:
        return np.arange(len(self._uncut)) if among is None else among


def _typed(rule: Rule) -> Rule:
    """One set of types for the kernels, so that they are compiled once."""
    low, high, gamma, slack, max_cost, min_frames = rule
    limits = np.float32(gamma), np.float32(slack), np.float32(max_cost), np.float32(min_frames)
    return Rule(int(low), int(high), *limits)


def _even_blocks(work: np.ndarray, size: int) -> np.ndarray:
    """Cuts of the string such that each block holds about ``size`` pairs of seed start and candidate; work is (m,)."""
    n = int(np.ceil(work[-1] / size)) if len(work) else 0
    inner = np.searchsorted(work, np.arange(1, n) * size) + 1
    return np.unique(np.concatenate([[0], inner, [len(work)]])).astype(np.int64)


def _concatenated(blocks: list[Matches]) -> Matches:
    total = sum(len(b.costs) for b in blocks)
    starts, ends, costs = np.empty(total, np.int32), np.empty(total, np.int32), np.empty(total, np.float32)
    pointers, firsts, at = [np.zeros(1, np.int64)], [np.zeros(0, np.int64)], 0
    blocks.reverse()
    while blocks:  # each is let go as soon as it is copied
        b = blocks.pop()
        n = len(b.costs)
        starts[at : at + n], ends[at : at + n], costs[at : at + n] = b.starts, b.ends, b.costs
        pointers.append(b.pointers[1:] + at)
        firsts.append(b.firsts)
        at += n
    return Matches(np.concatenate(pointers), starts, ends, costs, np.concatenate(firsts))
