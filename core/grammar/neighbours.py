"""Pairs of neighbouring terminals in the sentences, and which further pairs are plausible."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import pairwise

from core.grammar.alignment import Sentence

END = -1
"""What stands before and after a whole sentence."""

_UNSEEN = 0.1  # of what follows, or goes before: beyond this, one more is no surprise


class Neighbours:
    """Pairs of neighbours of sentences, their ends included.

    By Good and Turing the share of a terminal's coming successors that it never had is about the share of its
    successors that it had once; likewise before it.
    """

    def __init__(self, sentences: Iterable[Sequence[int]]) -> None:
        self.seen = Counter(pair for sentence in sentences for pair in pairwise((END, *sentence, END)))
        self._after: Counter[int] = Counter()
        self._before: Counter[int] = Counter()
        self._once_after: Counter[int] = Counter()
        self._once_before: Counter[int] = Counter()
        for (a, b), count in self.seen.items():
            self._after[a] += count
            self._before[b] += count
            self._once_after[a] += count == 1
            self._once_before[b] += count == 1

    def plausible(self, a: int, b: int) -> bool:
        """Whether ``b`` was seen after ``a``, or may be expected: where a tenth of what follows the one, or of what
        goes before the other, is still unseen."""
        if (a, b) in self.seen:
            return True
        after = self._once_after[a] / max(self._after[a], 1)
        return max(after, self._once_before[b] / max(self._before[b], 1)) >= _UNSEEN

    def allow(self, contexts: Iterable[tuple[int, int]], words: Iterable[Sentence]) -> bool:
        """Whether every word may stand in every context (what is before it, what after)."""
        words = list(words)
        return all(
            self.plausible(before, word[0]) and self.plausible(word[-1], after)
            if word
            else self.plausible(before, after)
            for before, after in contexts
            for word in words
        )
