"""Learning grammars: the paper's basketball strings, section 5.1, and properties that hold for any sentences."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.constituents import END
from core.grammar.induction import induce
from core.grammar.trees import leaves

LETTERS = "rdpsfm"
BASKETBALL = ("rfdpm", "rfdsm", "rdfsm", "rdpm", "rdsm", "rpm")
SOURCE = {
    "r" + "".join(x) + e + "m" for x in itertools.product(("f", ""), ("d", ""), ("f", "")) for e in "ps"
}  # of section 7
SENTENCES = st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=6).map(tuple), min_size=1, max_size=7)


def spelled(word: str) -> tuple[int, ...]:
    return tuple(LETTERS.index(letter) for letter in word)


@pytest.fixture(scope="module")
def basketball():
    return induce(map(spelled, BASKETBALL))


def test_the_paper_s_basketball_strings(basketball) -> None:
    grammar = basketball.grammar
    assert len(grammar.rules) <= 11 and len(grammar.nonterminals) > 1
    assert all(grammar.accepts(spelled(word)) for word in BASKETBALL)
    unseen = SOURCE - set(BASKETBALL)
    assert len(unseen) == 8 and sum(grammar.accepts(spelled(word)) for word in unseen) >= 3


def test_basketball_shuffles_that_begin_or_end_otherwise_are_rejected(basketball) -> None:
    for word in SOURCE:
        for shuffled in set(itertools.permutations(word)):
            if shuffled[0] != "r" or shuffled[-1] != "m":
                assert not basketball.grammar.accepts(spelled("".join(shuffled)))


def test_section_5_1_is_learned() -> None:
    learned = induce([(0, 1, 4, 2, 3), (0, 1, 5, 2, 3), (0, 1, 4, 2, 3)])
    bits = learned.grammar.bits(learned.trees)
    assert bits.sentences == 3 and bits.grammar == pytest.approx(38.04, abs=0.005)
    assert learned.bits == bits.total


OPTIONS = [
    {"align_by": align_by, "select_by": select_by, "touching": touching, "merge": merge}
    for align_by, select_by, touching, merge in (
        ("pairs", "joint", False, "side"),
        ("pairs", "branch", True, "no"),
        ("contexts", "leaf", True, "rules"),
        ("contexts", "joint", False, "no"),
    )
]


@pytest.mark.parametrize("options", OPTIONS)
@settings(max_examples=25, deadline=None)
@given(SENTENCES)
def test_every_training_sentence_is_reconstructed_and_accepted(options, sentences) -> None:
    grammar, trees = induce(sentences, **options)
    assert [leaves(tree) for tree in trees] == sentences
    assert [grammar.reconstruct(grammar.rule_indices(tree)) for tree in trees] == sentences
    assert all(grammar.accepts(sentence) for sentence in sentences)
    assert sum(rule.count for rule in grammar.rules if rule.left == "S") >= len(sentences)
    assert grammar.bits(trees).sentences == pytest.approx(sum(map(grammar.sentence_bits, trees)))


@settings(max_examples=30, deadline=None)
@given(SENTENCES, st.sampled_from(["pairs", "contexts"]))
def test_without_merging_no_new_neighbours_are_ever_made(sentences, align_by) -> None:
    grammar, _ = induce(sentences, align_by=align_by, merge="no", touching=False)
    seen = {pair for s in sentences for pair in itertools.pairwise((END, *s, END))}
    for word in itertools.chain.from_iterable(itertools.product(range(4), repeat=n) for n in range(1, 5)):
        if grammar.accepts(word):
            assert set(itertools.pairwise((END, *word, END))) <= seen


def test_nothing_to_learn_from() -> None:
    for nothing in ([], [(1, 2), ()]):
        with pytest.raises(ValueError, match="at least one terminal"):
            induce(nothing)
    with pytest.raises(ValueError, match="auto, pairs"):
        induce([(1, 2)], align_by="words")
