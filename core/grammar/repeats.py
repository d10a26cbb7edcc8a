"""Repeated substrings of terminal strings, by suffix array (Gusfield 1997, as SYN 5.2 asks)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from core.arrays import Int64Array
from core.compiled import njit


class Suffixes(NamedTuple):
    """A suffix array over strings: ``text (n,)`` int64, every string followed by an end of its own; ``order (n,)``: the
    suffixes sorted; ``shared (n,)``: how many symbols each has in common with the one before it in that order."""

    text: np.ndarray
    order: np.ndarray
    shared: np.ndarray
    begins: np.ndarray  # (n_strings + 1,): where each string begins in the text


def suffixes_of(strings: Sequence[Sequence[int]]) -> Suffixes:
    """The suffix array of strings of terminals; no two of their ends are equal, so nothing is shared across them.

    Prefix doubling, O(n log^2 n). Raises ValueError for a negative terminal.
    """
    begins = np.cumsum([0, *(len(string) + 1 for string in strings)])
    text = np.empty(begins[-1], np.int64)
    for k, (begin, end) in enumerate(pairwise(begins)):
        text[begin : end - 1] = strings[k]
        text[end - 1] = -1
    inside = np.ones(len(text), bool)
    inside[begins[1:] - 1] = False
    if (text[inside] < 0).any():
        raise ValueError("terminals are numbers from 0")
    text[begins[1:] - 1] = -1 - np.arange(len(strings))
    order = _sorted_suffixes(text)
    return Suffixes(text, order, _shared(text, order), begins)


def _sorted_suffixes(text: np.ndarray) -> np.ndarray:
    rank = np.unique(text, return_inverse=True)[1].astype(np.int64)
    width = 1
    while True:
        ahead = np.full(len(text), -1, np.int64)
        ahead[:-width] = rank[width:]
        order = np.lexsort((ahead, rank))
        changes = np.diff(rank[order]).astype(bool) | np.diff(ahead[order]).astype(bool)
        rank[order] = np.concatenate([[0], np.cumsum(changes)])[: len(text)]
        if width >= len(text) or rank.max(initial=0) == len(text) - 1:
            return order
        width *= 2


@njit()
def _shared(text: Int64Array, order: Int64Array) -> Int64Array:
    """Kasai's longest common prefixes."""
    n = len(text)
    rank = np.empty(n, np.int64)
    rank[order] = np.arange(n)
    shared = np.zeros(n, np.int64)
    length = 0
    for i in range(n):
        if rank[i] == 0:
            length = 0
            continue
        j = order[rank[i] - 1]
        while i + length < n and j + length < n and text[i + length] == text[j + length]:
            length += 1
        shared[rank[i]] = length
        length = max(0, length - 1)
    return shared


def longest_repeats(strings: Sequence[Sequence[int]]) -> list[np.ndarray]:
    """Per string ``(n,)``: how many symbols from here on are also somewhere else in the strings."""
    suffixes = suffixes_of(strings)
    longest = np.zeros(len(suffixes.text), np.int64)
    longest[suffixes.order] = np.maximum(suffixes.shared, np.append(suffixes.shared[1:], 0))
    return [longest[a : b - 1] for a, b in pairwise(suffixes.begins)]
