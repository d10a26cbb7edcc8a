"""Alignment-based learning, first phase: which spans can replace one another (van Zaanen 2000; SYN section 5).

Unequal parts of two sentences in equal contexts are interchangeable: hypotheses of one kind. Two ways to find them:

- edit distance: every pair of sentences is aligned, and the parts between linked symbols are exchanged;
- contexts: everything that stands between equal symbols. That is what a suffix tree of the sentences gives for where a
  constituent begins, and one of the reversed sentences for where it ends (Geertzen and van Zaanen 2004; the -a st3 that
  SYN uses), and its time does not grow with the number of pairs.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.arrays import Int32Array, Int64Array
from core.compiled import njit
from core.progress import Progress, unheard

Sentence = tuple[int, ...]
WAYS = ("pairs", "contexts")
_CELLS = 400_000_000  # of all edit distance tables: a few seconds
_SPANS = 1_000_000  # of all sentences: a few seconds, too


class Hypotheses(NamedTuple):
    """Spans that may be constituents, ``(n,)`` int64 each: sentence, start and end of the span (equal: nothing stands
    there), and kind: spans of equal kind are interchangeable. By sentence, start and end; no span twice."""

    sentence: np.ndarray
    start: np.ndarray
    end: np.ndarray
    kind: np.ndarray


def ways(sentences: Sequence[Sentence]) -> tuple[str, ...]:
    """The ways to align so many sentences in good time; the pairs where there is none."""
    lengths = np.array([len(sentence) for sentence in sentences], float)
    cells, spans = lengths.sum() ** 2 / 2, (lengths**2).sum() / 2
    return tuple(way for way, fits in zip(WAYS, (cells <= _CELLS, spans <= _SPANS), strict=True) if fits) or WAYS[:1]


def align(sentences: Sequence[Sentence], how: str = "pairs", progress: Progress = unheard) -> Hypotheses:
    """The hypotheses of different sentences; how: "pairs" by edit distance, or "contexts".

    Raises ValueError for another word or for equal sentences.
    """
    if len(set(sentences)) < len(sentences):
        raise ValueError("the sentences to align must differ")
    if how == "pairs":
        return align_pairs(sentences, progress)
    if how == "contexts":
        return align_contexts(sentences, progress)
    raise ValueError(f"the ways to align are {', '.join(WAYS)}, not {how!r}")


def align_pairs(sentences: Sequence[Sentence], progress: Progress = unheard) -> Hypotheses:
    """Hypotheses from the alignment of every pair of sentences by edit distance (insertions and deletions).

    Spans that get exchanged in several pairs become one kind. The contexts of all spans of a kind are equal: the
    symbols before and after, or the ends of the sentence.
    """
    symbols, begins = _joined(sentences)
    bases = _bases(sentences)
    parent = np.full(bases[-1], -1, np.int64)
    for k in range(len(sentences) - 1):
        _align_with_later(symbols, begins, bases, k, parent)
        n = len(sentences) - 1 - k  # later ones: a triangle is left
        progress(1 - n * (n - 1) / (len(sentences) * (len(sentences) - 1)))
    return _hypotheses(sentences, bases, _roots(parent))


def align_contexts(sentences: Sequence[Sentence], progress: Progress = unheard) -> Hypotheses:
    """Hypotheses from contexts alone: all spans with the same symbol (or end of a sentence) before and after are of
    one kind, where not all are equal. No span is a whole sentence.

    A suffix tree gives a class of spans for every repeated substring before them and, of the reversed sentences, after
    them; as spans in several classes make those one kind, the shortest substrings, of one symbol, decide.
    """
    groups: dict[tuple[int, int], list[tuple[int, int, int]]] = {}
    for k, sentence in enumerate(sentences):
        n = len(sentence)
        for i in range(n + 1):
            for j in range(i, n + 1 if i else n):
                context = (sentence[i - 1] if i else -1, sentence[j] if j < n else -1)
                groups.setdefault(context, []).append((k, i, j))
        progress((k + 1) / len(sentences))
    links = []
    for kind, spans in enumerate(groups.values()):
        if len({sentences[k][i:j] for k, i, j in spans}) > 1:
            links += [(*span, kind) for span in spans]
    return Hypotheses(*np.array(sorted(links), np.int64).reshape(-1, 4).T)


def links(a: Sentence, b: Sentence) -> list[tuple[int, int]]:
    """The equal symbols that an alignment of two sentences links: as many as possible, rising on both sides."""
    left, right = np.array(a, np.int64), np.array(b, np.int64)
    return [(int(i), int(j)) for i, j in _links(left, right, np.empty((len(a) + 1, len(b) + 1), np.int32))]


def _joined(sentences: Sequence[Sentence]) -> tuple[np.ndarray, np.ndarray]:
    begins = np.cumsum([0, *map(len, sentences)])
    return np.array([s for sentence in sentences for s in sentence], np.int64), begins


def _bases(sentences: Sequence[Sentence]) -> np.ndarray:
    """Where the table of a sentence's spans begins: span [i, j) of one of n symbols is at base + i (n + 1) + j."""
    return np.cumsum([0, *((len(sentence) + 1) ** 2 for sentence in sentences)])


def _hypotheses(sentences: Sequence[Sentence], bases: np.ndarray, kinds: np.ndarray) -> Hypotheses:
    spans = np.flatnonzero(kinds >= 0)
    sentence = np.searchsorted(bases, spans, side="right") - 1
    width = np.array([len(s) + 1 for s in sentences], np.int64)[sentence]
    start, end = np.divmod(spans - bases[sentence], width)
    return Hypotheses(sentence, start, end, np.unique(kinds[spans], return_inverse=True)[1].astype(np.int64))


@njit()
def _links(a: Int64Array, b: Int64Array, table: Int32Array) -> Int64Array:
    """Longest common subsequence of ``a (n,)`` and ``b (m,)`` as pairs ``(k, 2)``; table: room for (n + 1, m + 1)."""
    n, m = len(a), len(b)
    table[n, : m + 1] = 0
    for i in range(n - 1, -1, -1):
        table[i, m] = 0
        for j in range(m - 1, -1, -1):
            if a[i] == b[j]:
                table[i, j] = table[i + 1, j + 1] + 1
            else:
                table[i, j] = max(table[i + 1, j], table[i, j + 1])
    pairs = np.empty((table[0, 0], 2), np.int64)
    i = j = k = 0
    while i < n and j < m:
        if a[i] == b[j]:
            pairs[k, 0], pairs[k, 1] = i, j
            i, j, k = i + 1, j + 1, k + 1
        elif table[i + 1, j] >= table[i, j + 1]:
            i += 1
        else:
            j += 1
    return pairs


@njit()
def _root(parent: Int64Array, x: int) -> int:
    while parent[x] != x:
        parent[x] = parent[parent[x]]
        x = parent[x]
    return x


@njit()
def _align_with_later(symbols: Int64Array, begins: Int64Array, bases: Int64Array, k: int, parent: Int64Array) -> None:
    """Joins in ``parent`` the spans that sentence k and each later one may exchange."""
    a = symbols[begins[k] : begins[k + 1]]
    longest = np.max(np.diff(begins))
    table = np.empty((len(a) + 1, longest + 1), np.int32)
    for other in range(k + 1, len(begins) - 1):
        b = symbols[begins[other] : begins[other + 1]]
        aligned = _links(a, b, table)
        if len(aligned) == 0:
            continue
        i = j = 0
        for row in range(len(aligned) + 1):
            to_i, to_j = (aligned[row, 0], aligned[row, 1]) if row < len(aligned) else (len(a), len(b))
            if i < to_i or j < to_j:
                x = bases[k] + i * (len(a) + 1) + to_i
                y = bases[other] + j * (len(b) + 1) + to_j
                if parent[x] < 0:
                    parent[x] = x
                if parent[y] < 0:
                    parent[y] = y
                x, y = _root(parent, x), _root(parent, y)
                if x != y:
                    parent[max(x, y)] = min(x, y)
            i, j = to_i + 1, to_j + 1


@njit()
def _roots(parent: Int64Array) -> Int64Array:
    kinds = np.full(len(parent), -1, np.int64)
    for x in range(len(parent)):
        if parent[x] >= 0:
            kinds[x] = _root(parent, x)
    return kinds
