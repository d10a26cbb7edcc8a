"""New sentences, and other ways for their constituents."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar import authoring
from core.grammar.generation import least
from core.grammar.induction import induce
from core.grammar.motion_grammar import Grammar
from core.grammar.rules import Rule
from core.grammar.trees import at_path, depth, leaves, preorder
from tests.core.grammar.test_induction import BASKETBALL, SENTENCES, spelled
from tests.core.grammar.test_motion_grammar import CYCLIC, check_spans


@pytest.fixture(scope="module")
def basketball():
    return induce(map(spelled, BASKETBALL)).grammar


@settings(max_examples=30, deadline=None)
@given(SENTENCES, st.integers(0, 5))
def test_what_is_generated_parses_and_is_the_same_again(sentences, seed) -> None:
    grammar = induce(sentences).grammar
    tree = grammar.generate(seed, 20)
    assert grammar.accepts(leaves(tree)) and tree == grammar.generate(seed, 20)
    assert grammar.tree_of(grammar.rule_indices(tree)) == tree
    check_spans(tree, grammar)


def test_cyclic_grammars_end_within_the_bounds() -> None:
    endless = Grammar((Rule("S", ("S", "S"), 99), Rule("S", (0,), 1), Rule("S", ("S",), 99)))
    for grammar in (CYCLIC, endless):
        for seed in range(40):
            tree = grammar.generate(seed, 15)
            assert 1 <= len(leaves(tree)) <= 15 and depth(tree) <= 41
    assert least(endless.rules)["S"][:2] == (1, 1)
    never = Grammar((Rule("S", ("S", 1)),))
    with pytest.raises(ValueError, match="nothing can be generated"):
        never.generate(0)


def test_sentences_longer_than_asked_are_the_shortest_there_are() -> None:
    grammar = Grammar((Rule("S", (1, "A", 2)), Rule("A", (3,)), Rule("A", (4, "A"), 9)))
    assert {leaves(grammar.generate(seed, 1)) for seed in range(9)} == {(1, 3, 2)}
    assert max(len(leaves(grammar.generate(seed, 6))) for seed in range(60)) == 6


def test_constituents_around_a_terminal_grow_to_the_whole(basketball) -> None:
    tree = basketball.parse(spelled("rfdpm"))
    for terminal in range(5):
        paths = authoring.constituents(tree, terminal)
        assert paths[-1] == ()
        spans = [(at_path(tree, path).start, at_path(tree, path).end) for path in paths]
        assert all(start <= terminal < end for start, end in spans)
        assert all(b[0] <= a[0] and a[1] <= b[1] for a, b in itertools.pairwise(spans))
        assert all(len(a) == len(b) + 1 for a, b in itertools.pairwise(paths))
    for outside in (-1, 5):
        with pytest.raises(IndexError):
            authoring.constituents(tree, outside)


def test_alternatives_differ_in_their_constituent_alone(basketball) -> None:
    tree = basketball.parse(spelled("rfdpm"))
    for terminal in range(1, 4):
        for path in authoring.constituents(tree, terminal):
            others = authoring.alternatives(basketball, tree, path, n=4, seed=1)
            assert others == authoring.alternatives(basketball, tree, path, n=4, seed=1)
            node = at_path(tree, path)
            assert len({leaves(at_path(other, path)) for other in others} | {leaves(node)}) == len(others) + 1
            for other in others:
                check_spans(other, basketball)
                assert leaves(other)[: node.start] == leaves(tree)[: node.start]
                assert leaves(other)[at_path(other, path).end :] == leaves(tree)[node.end :]
                assert basketball.accepts(leaves(other))
    assert len(authoring.alternatives(basketball, tree, (), n=4)) == 4


def test_what_cannot_be_replaced(basketball) -> None:
    tree = basketball.parse(spelled("rfdpm"))
    with pytest.raises(ValueError, match="no alternatives"):
        authoring.alternatives(basketball, tree, (0,))
    with pytest.raises(ValueError, match="cannot stand"):
        authoring.replace(tree, (1,), tree)
    with pytest.raises(IndexError):
        authoring.replace(tree, (9,), tree)
    assert authoring.replace(tree, (), tree) == tree


def test_one_way_alone_has_no_alternatives() -> None:
    grammar = Grammar((Rule("S", (1, "A")), Rule("A", (2,))))
    assert authoring.alternatives(grammar, grammar.parse((1, 2)), (1,)) == ()
    assert sum(not node.is_leaf for node in preorder(grammar.generate(np.random.default_rng(0)))) == 2
