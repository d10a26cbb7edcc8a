"""A long string of terminals cut into sentences by minimum description length (SYN section 5.2).

Cuts are random, but none splits a repeated substring, no sentence is shorter than a minimum or crosses the end of a
clip; the partition whose grammar and sentences take the fewest bits wins.

The paper's constraint cannot be meant word for word: in its own example abxcd|abycd|abxcd the cuts split cdab, which
occurs twice. We take the longest repeats first, and leave out occurrences that overlap one taken before and do not lie
in it or around it; a repeat counts while two of its occurrences are left. In the example abxcd, ab and cd remain.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from core.grammar.repeats import suffixes_of
from core.progress import Report, silent

String = tuple[int, ...]
Cuts = tuple[tuple[int, ...], ...]
"""Per string the places, rising, where it is cut; not its ends."""


class Repeat(NamedTuple):
    """A substring that occurs more than once and cannot be made longer without losing one: its length, and the
    (string, start) of every occurrence."""

    length: int
    places: tuple[tuple[int, int], ...]


def maximal_repeats(strings: Sequence[String]) -> list[Repeat]:
    """All maximal repeats of at least two symbols, longest first: nodes of the suffix tree that also differ before."""
    suffixes = suffixes_of(strings)
    text, order, shared = suffixes.text, suffixes.order, suffixes.shared
    intervals, open_at = [], [(0, 0)]  # (length, first row) of the intervals of rows that are open
    for row in range(1, len(order) + 1):
        length, begin = int(shared[row]) if row < len(order) else 0, row - 1
        while open_at[-1][0] > length:
            own, begin = open_at.pop()
            starts = np.sort(order[begin:row])
            before = {int(text[s - 1]) if s else -len(text) - 1 for s in starts}
            if own > 1 and (len(before) > 1 or min(before) < 0):
                intervals.append(Repeat(own, _places(starts, suffixes.begins)))
        if open_at[-1][0] < length:
            open_at.append((length, begin))
    return sorted(intervals, key=lambda repeat: (-repeat.length, repeat.places))


def protected_spans(strings: Sequence[String]) -> list[set[tuple[int, int]]]:
    """Per string the occurrences (start, end) of repeats that no cut may split."""
    taken: list[set[tuple[int, int]]] = [set() for _ in strings]
    for length, places in maximal_repeats(strings):
        free = [(k, at) for k, at in places if not any(_crosses((at, at + length), span) for span in taken[k])]
        if len(free) > 1:
            for k, at in free:
                taken[k].add((at, at + length))
    return taken


def possible_cuts(strings: Sequence[String]) -> list[np.ndarray]:
    """Per string the places ``(k,)`` inside it where a cut splits no protected repeat."""
    cuts = []
    for string, spans in zip(strings, protected_spans(strings), strict=True):
        free = np.ones(len(string) + 1, bool)
        free[[0, -1]] = False
        for start, end in spans:
            free[start + 1 : end] = False
        cuts.append(np.flatnonzero(free))
    return cuts


def best_cuts(
    strings: Sequence[String],
    bits: Callable[[list[String]], float],
    *,
    candidates: int = 40,
    shortest: int = 3,
    seed: int = 0,
    report: Report = silent,
) -> Cuts:
    """The cuts whose sentences take the fewest ``bits`` among random ones, and none at all.

    How many cuts a candidate has is drawn as well: none to as many as fit. Raises ValueError where candidates is
    negative or shortest below 1.
    """
    if candidates < 0 or shortest < 1:
        raise ValueError("candidates must be 0 or more, and the shortest sentence 1 or more")
    rng, possible = np.random.default_rng(seed), possible_cuts(strings)
    best: Cuts = tuple(() for _ in strings)
    fewest, tried = bits(cut(strings, best)), {best}
    for k in range(candidates):
        report("sentences", k / candidates)
        drawn = _draw(strings, possible, shortest, rng)
        if drawn in tried:
            continue
        tried.add(drawn)
        needed = bits(cut(strings, drawn))
        if needed < fewest:
            best, fewest = drawn, needed
    return best


def cut(strings: Sequence[String], cuts: Cuts) -> list[String]:
    """The sentences, in order."""
    return [
        string[start:end]
        for string, own in zip(strings, cuts, strict=True)
        for start, end in zip((0, *own), (*own, len(string)), strict=True)
    ]


def _draw(strings: Sequence[String], possible: Sequence[np.ndarray], shortest: int, rng: np.random.Generator) -> Cuts:
    """Random cuts: the same share of the possible ones is wanted in every string."""
    share = rng.random()
    drawn = []
    for string, places in zip(strings, possible, strict=True):
        wanted = rng.binomial(len(places), share)
        chosen: list[int] = []
        for place in rng.permutation(places)[:wanted].tolist():
            nearest = min((abs(place - other) for other in (0, *chosen, len(string))), default=0)
            if nearest >= shortest:
                chosen.append(place)
        drawn.append(tuple(sorted(chosen)))
    return tuple(drawn)


def _places(starts: np.ndarray, begins: np.ndarray) -> tuple[tuple[int, int], ...]:
    strings = np.searchsorted(begins, starts, side="right") - 1
    return tuple((int(k), int(s - begins[k])) for k, s in zip(strings, starts, strict=True))


def _crosses(a: tuple[int, int], b: tuple[int, int]) -> bool:
    (a0, a1), (b0, b1) = sorted((a, b))
    return a0 < b0 < a1 < b1
