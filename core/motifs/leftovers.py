"""Motions left over by the discovery join a motif that they match less closely."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from core.motifs.discovery import Substrings
from core.motifs.matching import Matcher, Matches, Rule, first_cuts
from core.motifs.volumes import partition
from core.progress import Report, silent
from core.sequences.repeats import Runs

_ATTRACTORS = 64  # motions of a motif that others may join
_OFFER = np.dtype([("cost", np.float32), ("motif", np.int32), ("first", np.int32), ("last", np.int32)])


def join_leftovers(
    runs: Runs, matcher: Matcher, motifs: list[Substrings], rule: Rule, report: Report = silent
) -> list[Substrings]:
    """Ours: unpartitioned substrings join the motif whose motions they match, under a looser rule than it was found
    with.

    Two thresholds, as in edge tracing: a motif has to be found among near motions, but takes in one somewhat further
    off. Nearest first; motifs neither appear nor meet, and who joined attracts nobody else. Of a motif of many motions
    only some attract others, taken evenly from its nearest to its furthest, so that time is linear in the string.
    """
    cut = first_cuts(runs)
    for motif in motifs:
        partition(motif, cut)
    free = np.flatnonzero(cut > np.arange(len(cut)))
    offers = [np.zeros(0, _OFFER)]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for number, motif in enumerate(motifs):
            matches = pool.map(lambda motion: matcher.of(int(motion[0]), int(motion[1]), rule, cut, free), _some(motif))
            offers.append(_nearest_offers(number, list(matches)))
            report("joining", (number + 1) / len(motifs))
    grown = [list(map(tuple, motif)) for motif in motifs]
    for _, number, first, last in np.sort(np.concatenate(offers), order=_OFFER.names).tolist():
        if cut[first] >= last:
            grown[number].append((first, last))
            partition(np.array([[first, last]]), cut)
    return [np.array(motif, np.int64) for motif in grown]


def _nearest_offers(number: int, matches: list[Matches]) -> np.ndarray:
    """What matches motions of motif ``number``, each substring once, with its nearest motion."""
    offers = np.zeros(sum(len(found.costs) for found in matches), _OFFER)
    offers["motif"] = number
    for field, values in (("cost", "costs"), ("first", "starts"), ("last", "ends")):
        offers[field] = np.concatenate([getattr(found, values) for found in matches])
    offers = offers[np.lexsort((offers["cost"], offers["last"], offers["first"]))]
    new = np.ones(len(offers), bool)
    new[1:] = (np.diff(offers["first"]) != 0) | (np.diff(offers["last"]) != 0)
    return offers[new]


def _some(motif: Substrings) -> Substrings:
    """At most so many motions of a motif, evenly from its nearest to its furthest."""
    n = len(motif)
    return motif if n <= _ATTRACTORS else motif[np.arange(_ATTRACTORS) * n // _ATTRACTORS]
