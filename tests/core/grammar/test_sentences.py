"""Sentences by minimum description length, and repeated substrings, against brute force."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.induction import induce
from core.grammar.repeats import longest_repeats, suffixes_of
from core.grammar.sentences import best_cuts, cut, maximal_repeats, possible_cuts, protected_spans

EXAMPLE = tuple("abxycd".index(letter) for letter in "abxcdabycdabxcd")
STRINGS = st.lists(st.lists(st.integers(0, 2), max_size=12).map(tuple), min_size=1, max_size=3)


def occurrences(strings, piece):
    n = len(piece)
    return tuple((k, i) for k, s in enumerate(strings) for i in range(len(s) - n + 1) if s[i : i + n] == piece)


@settings(max_examples=80, deadline=None)
@given(STRINGS)
def test_maximal_repeats_are_those_of_brute_force(strings) -> None:
    pieces = {s[i:j] for s in strings for i in range(len(s)) for j in range(i + 2, len(s) + 1)}
    expected = set()
    for piece in pieces:
        places = occurrences(strings, piece)
        ends = len(piece)
        before = {strings[k][i - 1] if i else ("start", k) for k, i in places}
        after = {strings[k][i + ends] if i + ends < len(strings[k]) else ("end", k) for k, i in places}
        starts = sum(i == 0 for _, i in places)
        if len(places) > 1 and (len(before) > 1 or starts) and len(after) > 1:
            expected.add((len(piece), places))
    assert set(maximal_repeats(strings)) == expected


@settings(max_examples=50, deadline=None)
@given(STRINGS)
def test_suffixes_are_sorted_and_repeats_as_long_as_they_are(strings) -> None:
    suffixes = suffixes_of(strings)
    tails = [tuple(suffixes.text[i:].tolist()) for i in suffixes.order]
    assert tails == sorted(tails)
    for string, longest in zip(strings, longest_repeats(strings), strict=True):
        for i in range(len(string)):
            n = int(longest[i])
            assert n == 0 or len(occurrences(strings, string[i : i + n])) > 1
            assert i + n == len(string) or len(occurrences(strings, string[i : i + n + 1])) == 1


def test_section_5_s_example_is_cut_as_in_the_paper() -> None:
    spelled = {"".join("abxycd"[s] for s in EXAMPLE[i:j]) for i, j in protected_spans([EXAMPLE])[0]}
    assert spelled == {"abxcd", "ab", "cd"}
    assert possible_cuts([EXAMPLE])[0].tolist() == [5, 7, 8, 10]
    cuts = best_cuts([EXAMPLE], lambda parts: induce(parts).bits, candidates=60)
    assert cuts == ((5, 10),)
    assert induce(cut([EXAMPLE], cuts)).bits == pytest.approx(41.04, abs=0.005)


@settings(max_examples=30, deadline=None)
@given(STRINGS, st.integers(1, 4))
def test_cuts_keep_repeats_and_the_least_length(strings, shortest) -> None:
    rng = np.random.default_rng(0)
    seen = []

    def bits(parts) -> float:
        seen.append(parts)
        return float(rng.random())

    cuts = best_cuts(strings, bits, candidates=8, shortest=shortest)
    assert sum(cut(strings, cuts), ()) == sum(strings, ())
    assert cut(strings, cuts) in seen
    for string, own, spans in zip(strings, cuts, protected_spans(strings), strict=True):
        assert not any(start < place < end for place in own for start, end in spans)
        ends = (0, *own, len(string))
        assert len(own) == 0 or min(np.diff(ends)) >= shortest


def test_wrong_values() -> None:
    with pytest.raises(ValueError, match="candidates"):
        best_cuts([EXAMPLE], lambda parts: 0.0, candidates=-1)
    with pytest.raises(ValueError, match="from 0"):
        suffixes_of([(1, -1)])
