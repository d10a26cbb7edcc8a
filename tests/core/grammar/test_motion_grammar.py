"""The grammar as an object, against brute force: section 5.1's example, parsing, probability, codes and bits."""

from __future__ import annotations

import itertools
from collections import defaultdict

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.motion_grammar import Grammar
from core.grammar.rules import Rule
from core.grammar.trees import at_path, brackets, depth, leaves, preorder

SECTION_5_1 = Grammar((Rule("S", (0, 1, "A", 2, 3), 3), Rule("A", (4,), 2), Rule("A", (5,), 1)))
SENTENCES = ((0, 1, 4, 2, 3), (0, 1, 5, 2, 3), (0, 1, 4, 2, 3))
CYCLIC = Grammar(
    (
        Rule("S", ("A", "S", "A")),
        Rule("S", (0,)),
        Rule("A", ()),
        Rule("A", (1,)),
        Rule("A", ("A",)),
        Rule("A", ("A", "A")),
    )
)


def test_the_bits_of_section_5_1() -> None:
    trees = [SECTION_5_1.parse(sentence) for sentence in SENTENCES]
    bits = SECTION_5_1.bits(trees)
    assert bits.sentences == 3 and bits.grammar == pytest.approx(38.04, abs=0.005)
    assert bits.total == bits.grammar + bits.sentences
    assert [SECTION_5_1.rule_indices(tree) for tree in trees] == [(0, 0), (0, 1), (0, 0)]
    assert [SECTION_5_1.reconstruct(SECTION_5_1.rule_indices(tree)) for tree in trees] == list(SENTENCES)


def test_probability_sums_over_trees_and_cycles() -> None:
    # A is empty with probability 1/4 + 1/4 e + 1/4 e^2 = e
    e = (3 - np.sqrt(5)) / 2
    zero = 0.5 / (1 - 0.5 * e * e)
    assert CYCLIC.log2_probability((0,)) == pytest.approx(np.log2(zero))
    assert CYCLIC.log2_probability((0, 0)) == -np.inf
    assert SECTION_5_1.log2_probability(SENTENCES[0]) == pytest.approx(np.log2(2 / 3))


def test_trees_of_a_cyclic_grammar_are_finite_and_spell_the_sentence() -> None:
    for sentence in ((0,), (1, 0), (1, 1, 0, 1, 1)):
        tree = CYCLIC.parse(sentence)
        assert leaves(tree) == sentence and (tree.start, tree.end) == (0, len(sentence))
        check_spans(tree, CYCLIC)
    assert CYCLIC.parse(()) is None and CYCLIC.parse((1,)) is None and not CYCLIC.accepts((7,))


def test_empty_sentences() -> None:
    grammar = Grammar((Rule("S", ("A", "A")), Rule("A", ()), Rule("A", (3,), 3)))
    assert leaves(grammar.parse(())) == () and grammar.log2_probability(()) == pytest.approx(-4)
    assert grammar.parse_series(()) == () and grammar.accepts((3, 3)) and not grammar.accepts((3, 3, 3))


def test_a_string_read_as_sentences() -> None:
    trees = SECTION_5_1.parse_series(sum(SENTENCES, ()))
    assert [leaves(tree) for tree in trees] == list(SENTENCES)
    assert [(tree.start, tree.end) for tree in trees] == [(0, 5), (5, 10), (10, 15)]
    assert SECTION_5_1.parse_series((0, 1)) is None and SECTION_5_1.parse_series((9,)) is None


def test_wrong_codes_and_wrong_grammars_are_refused() -> None:
    for code in ((), (0,), (0, 2), (1, 0), (0, 0, 0)):
        with pytest.raises(ValueError, match="rule ind"):
            SECTION_5_1.reconstruct(code)
    with pytest.raises(ValueError, match="no rule rewrites A"):
        Grammar((Rule("S", ("A",)),))
    with pytest.raises(ValueError, match="only once"):
        Grammar((Rule("S", (0,)), Rule("S", (0,), 2)))
    with pytest.raises(ValueError, match="too long"):
        SECTION_5_1.accepts((0,) * 5000)


def test_trees() -> None:
    tree = SECTION_5_1.parse(SENTENCES[0])
    assert brackets(tree, str) == "S(0 1 A(4) 2 3)" and depth(tree) == 2
    assert at_path(tree, (2, 0)).symbol == 4 and at_path(tree, ()) is tree
    for path in ((9,), (-1,), (0, 0)):
        with pytest.raises(IndexError):
            at_path(tree, path)


@st.composite
def grammars(draw) -> Grammar:
    """Small random grammars over 0, 1, with empty right sides, cycles and left recursion; all can end."""
    lefts = ["S", "A", "B"][: draw(st.integers(1, 3))]
    symbols = st.sampled_from([0, 1, *lefts])
    rules = {(left, (k % 2,)): 1 for k, left in enumerate(lefts)}
    for left, right, count in draw(
        st.lists(st.tuples(st.sampled_from(lefts), st.lists(symbols, max_size=3), st.integers(1, 3)), max_size=6)
    ):
        rules.setdefault((left, tuple(right)), count)
    return Grammar(tuple(Rule(left, right, count) for (left, right), count in rules.items()))


def words_by_hand(grammar: Grammar, longest: int) -> set[tuple[int, ...]]:
    """All sentences up to a length: sets of words per symbol, grown until nothing is new."""
    words = defaultdict(set)
    while True:
        before = sum(map(len, words.values()))
        for rule in grammar.rules:
            parts = [words[s] if isinstance(s, str) else {(s,)} for s in rule.right]
            for choice in itertools.product(*map(tuple, parts)):
                word = sum(choice, ())
                if len(word) <= longest:
                    words[rule.left].add(word)
        if sum(map(len, words.values())) == before:
            return words[grammar.start]


def check_spans(tree, grammar: Grammar) -> None:
    for node in preorder(tree):
        if node.is_leaf:
            assert node.end == node.start + 1
            continue
        rule = grammar.rules[node.rule]
        assert rule.left == node.symbol and rule.right == tuple(child.symbol for child in node.children)
        at = node.start
        for child in node.children:
            assert child.start == at
            at = child.end
        assert at == node.end


@settings(max_examples=60, deadline=None)
@given(grammars())
def test_accepts_what_brute_force_generates(grammar: Grammar) -> None:
    language = words_by_hand(grammar, 4)
    for n in range(5):
        for word in itertools.product((0, 1), repeat=n):
            tree = grammar.parse(word)
            assert (tree is not None) == (word in language) == grammar.accepts(word)
            probability = grammar.log2_probability(word)
            assert (probability > -np.inf) == (word in language)
            if tree is None:
                continue
            assert leaves(tree) == word and grammar.reconstruct(grammar.rule_indices(tree)) == word
            check_spans(tree, grammar)
            own = sum(np.log2(grammar.probabilities[node.rule]) for node in preorder(tree) if not node.is_leaf)
            assert grammar.chart.score(word) == pytest.approx(own)
            assert own <= probability + 1e-9


def test_probabilities_of_all_sentences_sum_to_one() -> None:
    grammar = Grammar((Rule("S", ("A", "A"), 3), Rule("S", (0,), 1), Rule("A", (), 1), Rule("A", (1, "B"), 1),
                       Rule("B", (0,), 1), Rule("B", (1,), 3)))  # fmt: skip
    total = sum(2 ** grammar.log2_probability(word) for n in range(5) for word in itertools.product((0, 1), repeat=n))
    assert total == pytest.approx(1)
