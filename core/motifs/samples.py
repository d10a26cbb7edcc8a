"""Discovery in samples of the string, for recordings too long to match every seed with everything.

A motion that recurs a thousand times is found as well among a few dozen of its repetitions. So the exact greedy
discovery (:mod:`core.motifs.discovery`) runs on a sample of what is left of the string, and the motifs it finds there
are completed with their matches in the whole string. Every round draws afresh from what no motif has taken yet, so
rarer motifs come up as the frequent ones are gone. A round costs about the same whatever the length of the string, a
motif is completed in time linear in it, and the matches of one sample are all that is ever in memory.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from core.motifs.discovery import Substrings
from core.motifs.matching import Matcher, Rule, first_cuts
from core.motifs.volumes import bounds_of, heap_of, index_of, largest, motif_of, partition, volume_of
from core.progress import Report, silent
from core.sequences.repeats import Runs

_STRETCH = 128  # letters that are drawn together, several times the longest motion
_TRUSTED = 4  # motions of a motif in the sample from which on its size there says enough
_WORTHWHILE = 0.05  # share of the free letters that a round must take for another one like it
_ROUND = 0.4  # of the progress that is left, what a round adds: nobody knows how many there will be
_MATCHED = 0.8  # of that, what matching the sample adds
_CONTENDERS = 16  # starts of seeds of about the largest volume in the sample that are tried on the whole string


def sampled_first(
    runs: Runs,
    matcher: Matcher,
    rule: Rule,
    rho: float,
    size: int,
    seed: int = 0,
    *,
    tightness: float = 0.0,
    report: Report = silent,
) -> list[Substrings]:
    """Motifs of about the largest volumes first, as :func:`largest_first` finds them, from samples of ``size`` letters.

    As soon as no more than ``size`` letters are free the rest is exact; a string that short is searched exactly from
    the start. Where rounds no longer find motifs that occur often enough for a sample, one pass over the free letters
    in pieces of ``size`` ends the search: of motifs so rare, those are found that occur twice in a piece. The same
    seed, the same motifs. Time is about linear in the string, memory does not grow with its repetition.
    """
    search = _Search(runs, matcher, rule, rho, tightness, report)
    rng = np.random.default_rng(seed)
    while len(free := search.free()) > size:
        search.take_from(next(_pieces(runs, free, len(free) / size, rng)), _TRUSTED, _ROUND)
        if len(search.free()) > (1 - _WORTHWHILE) * len(free):
            break
    free = search.free()
    n = int(np.ceil(len(free) / size))
    for k, piece in enumerate(_pieces(runs, free, n, rng)):
        search.take_from(piece, 2, 1 / (n - k))
    report("discovery", 1.0)
    return search.motifs


def _pieces(runs: Runs, free: np.ndarray, n: float, rng: np.random.Generator) -> Iterator[np.ndarray]:
    """The free letters in ``n`` pieces, the last one smaller where n is no whole number.

    Each piece is of stretches from all over the string, ascending.
    """
    stretch = np.cumsum((np.arange(len(runs.firsts)) - runs.firsts) % _STRETCH == 0)[free]
    _, stretch = np.unique(stretch, return_inverse=True)
    counts = np.bincount(stretch, minlength=1)
    order, piece = rng.permutation(len(counts)), np.empty(len(counts), np.int64)
    piece[order] = (np.cumsum(counts[order]) - 1) * n // max(len(free), 1)
    for k in range(int(np.ceil(n))):
        yield free[piece[stretch] == k]


class _Search:
    """Motifs found so far and what they have left of the string."""

    def __init__(self, runs: Runs, matcher: Matcher, rule: Rule, rho: float, tightness: float, report: Report):
        self.runs, self.matcher, self.rule, self.rho = runs, matcher, rule, rho
        self.tightness, self.report = tightness, report
        self.cut = first_cuts(runs)
        self.motifs: list[Substrings] = []
        self._letters, self._middles = np.arange(len(self.cut)), runs.middles
        self._done = 0.0

    def free(self) -> np.ndarray:
        """Letters at which a motion may still begin, ascending."""
        room = self._middles[self.cut] - self._middles
        return np.flatnonzero((self.cut > self._letters) & (room >= self.rule.min_frames))

    def take_from(self, piece: np.ndarray, least: int, share: float) -> None:
        """Take motifs, the largest of the piece first, while they have ``least`` motions in it.

        share: of the progress that is left, what this adds.
        """
        free, before, step = self.free(), self._done, share * (1 - self._done)
        piece = np.intersect1d(piece, free, assume_unique=True)
        self._done += step

        def matching(stage: str, fraction: float) -> None:
            self.report("discovery", before + _MATCHED * step * fraction)

        matches = self.matcher.all(self.rule, matching, cut=self.cut, among=piece)
        index = index_of(self.runs, matches, self.rule, self.tightness)
        heap = heap_of(bounds_of(index, self.cut, self.rho))
        volumes, counts = np.zeros(len(matches.pointers)), np.full(len(matches.pointers), -1, np.int64)
        while True:
            k, compared = largest(index, heap, volumes, counts, self.cut, self.rho)
            if k < 0 or len(motif := motif_of(index, k, self.cut)[0]) < least:
                return
            if len(piece) < len(free):
                best = compared[np.argsort(-volumes[compared], kind="stable")]
                starts = dict.fromkeys((index.firsts[best // index.lengths]).tolist())
                motif = self._largest_of(list(starts)[:_CONTENDERS])
            self.motifs.append(motif)
            partition(motif, self.cut)
            taken = 1 - len(self.free()) / len(free)
            self.report("discovery", before + step * (_MATCHED + (1 - _MATCHED) * taken))

    def _largest_of(self, starts: list[int]) -> Substrings:
        """The largest motif in the whole string of all whose seeds start at one of these letters."""
        free = self.free()
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            found = list(pool.map(lambda first: self._complete(first, free), starts))
        return max(found, key=lambda f: f[1])[0]

    def _complete(self, first: int, free: np.ndarray) -> tuple[Substrings, float]:
        """The largest motif whose seed starts at letter ``first``, and its volume."""
        matches = self.matcher.starting_at(first, self.rule, self.cut, free)
        index = index_of(self.runs, matches, self.rule, self.tightness)
        rows: list[int] = np.flatnonzero(np.diff(index.pointers)).tolist()
        volumes = {k: volume_of(index, k, self.cut, self.rho) for k in rows}
        k = max(rows, key=lambda row: volumes[row])
        return motif_of(index, k, self.cut)[0], volumes[k]
