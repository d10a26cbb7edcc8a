"""Alignment-based learning, second phase: which of the overlapping hypotheses become constituents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

from core.grammar.alignment import Hypotheses, Sentence
from core.progress import Progress, unheard

BY = ("saving", "branch", "leaf")


class Bracket(NamedTuple):
    """A constituent of a sentence: [start, end) and the kind it is of."""

    start: int
    end: int
    kind: int


def select(
    sentences: Sequence[Sentence],
    hypotheses: Hypotheses,
    weights: Sequence[int] | None = None,
    by: str = "branch",
    touching: bool = True,
    progress: Progress = unheard,
) -> list[list[Bracket]]:
    """The constituents of every sentence: hypotheses by falling worth, unless one taken before stands in the way.

    by: "branch" is the share, among the spans of its kind, of those with its very symbols (van Zaanen's -s b); "leaf"
    the share of those symbols among all spans (-s l); "saving" goes by how much of the sentences would not have to be
    written: the spans of its kind, less one for each different one, times its length. weights: how often each sentence
    occurs. In the way are constituents that cross, and empty ones at another's edge; where ``touching`` is False, also
    those that meet: then what stands beside a constituent is never replaced, and its context stays as it was learned.
    Constituents may nest, also with a common edge.
    Raises ValueError for another ``by``.
    """
    if by not in BY:
        raise ValueError(f"by must be one of {', '.join(BY)}, not {by!r}")
    rows = list(zip(*(column.tolist() for column in hypotheses), strict=True))
    yields: Counter[tuple[int, tuple[int, ...]]] = Counter()
    kinds: Counter[int] = Counter()
    words: Counter[tuple[int, ...]] = Counter()
    for sentence, start, end, kind in rows:
        weight = 1 if weights is None else weights[sentence]
        yields[kind, sentences[sentence][start:end]] += weight
        words[sentences[sentence][start:end]] += weight
        kinds[kind] += weight

    different = Counter(kind for kind, _ in yields)

    def rank(row: tuple[int, int, int, int]) -> tuple[float, int, int, int]:
        sentence, start, end, kind = row
        word = sentences[sentence][start:end]
        times = yields[kind, word]
        saved = (kinds[kind] - different[kind]) * len(word)
        score = {"branch": times / kinds[kind], "leaf": words[word], "saving": saved}[by]
        return -score, -times, start - end, start

    chosen: list[list[Bracket]] = [[] for _ in sentences]
    for sentence, group in groupby(rows, key=lambda row: row[0]):
        taken = chosen[sentence]
        for _, start, end, kind in sorted(group, key=rank):
            if not any(_in_the_way((start, end), (b.start, b.end), touching) for b in taken):
                taken.append(Bracket(start, end, kind))
        taken.sort(key=lambda b: (b.start, -b.end))
        progress((sentence + 1) / len(sentences))
    return chosen


def _in_the_way(a: tuple[int, int], b: tuple[int, int], touching: bool) -> bool:
    (a0, a1), (b0, b1) = sorted((a, b))
    if a0 == a1 or b0 == b1:  # an empty one at an edge could stand inside as well as outside
        empty, other = ((a0, a1), (b0, b1)) if a0 == a1 else ((b0, b1), (a0, a1))
        return empty[0] in other
    if a1 == b0:
        return not touching
    return a0 < b0 < a1 < b1
