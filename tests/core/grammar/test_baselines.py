"""The state machine and Sequitur."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.baselines import sequitur, state_machine

SENTENCES = st.lists(st.lists(st.integers(0, 2), min_size=1, max_size=14).map(tuple), min_size=1, max_size=4)


@settings(max_examples=80, deadline=None)
@given(SENTENCES)
def test_sequitur_keeps_its_two_rules_and_generates_the_sentences_alone(sentences) -> None:
    grammar = sequitur(sentences)
    assert all(grammar.accepts(sentence) for sentence in sentences)
    different = set(sentences)
    tops = [rule for rule in grammar.rules if rule.left == "S"]
    assert len(tops) == len(different) or len(tops) >= 1
    below = [rule for rule in grammar.rules if rule.left != "S"]
    assert len({rule.left for rule in below}) == len(below), "every other rule is the only one of its kind"
    for word in itertools.chain.from_iterable(itertools.product(range(3), repeat=n) for n in range(1, 4)):
        assert grammar.accepts(word) == (word in different)
    if len(different) == len(sentences):
        for rule in below:
            assert sum(symbol == rule.left for other in grammar.rules for symbol in other.right) >= 2
        digrams = {}
        for k, rule in enumerate(grammar.rules):
            for i, pair in enumerate(itertools.pairwise(rule.right)):
                digrams.setdefault(pair, []).append((k, i))
        for places in digrams.values():  # only overlapping ones, as in aaa, may be equal
            assert all(a[0] == b[0] and b[1] == a[1] + 1 for a, b in itertools.pairwise(places))


@settings(max_examples=40, deadline=None)
@given(SENTENCES, st.integers(0, 9))
def test_the_machine_knows_the_transitions_that_were_seen(sentences, seed) -> None:
    machine = state_machine(sentences)
    assert all(machine.accepts(sentence) for sentence in sentences)
    made = machine.generate(seed, 12)
    assert machine.accepts(made) and machine.log2_probability(made) > -np.inf
    assert len(made) <= 12 + 3 and made == machine.generate(seed, 12)
    assert not machine.accepts((7,)) and machine.log2_probability((7,)) == -np.inf


def test_probabilities_of_a_machine() -> None:
    machine = state_machine([(0, 1), (0, 1), (0, 2), (0,)])
    assert machine.log2_probability((0, 1)) == pytest.approx(-1)
    assert machine.log2_probability((0,)) == pytest.approx(-2)


def test_nothing_to_learn_from() -> None:
    for learn in (state_machine, sequitur):
        with pytest.raises(ValueError, match="needs sentences"):
            learn([])
