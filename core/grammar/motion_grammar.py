"""A context-free grammar as an object: rules with counts, parsing, probability, generation, reconstruction and bits.

After SYN sections 3, 5.1 and 6. Terminals are numbers, non-terminals names; right sides may be empty and rules cyclic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from core.errors import ParameterError
from core.grammar.chart import Chart
from core.grammar.generation import generate
from core.grammar.rules import Rule, choices
from core.grammar.trees import Node, Symbol, build_tree, leaves, preorder

START = "S"


class Bits(NamedTuple):
    """Description length (SYN equation 6): of the grammar, of the sentences given the grammar, and both."""

    grammar: float
    sentences: float

    @property
    def total(self) -> float:
        """The number that good sentences make small."""
        return self.grammar + self.sentences


@dataclass(frozen=True)
class Grammar:
    """Rules of a context-free grammar. Raises ValueError for equal rules, or none for a non-terminal that is used.

    A rule's probability is its share of the counts of all rules with its left side.
    """

    rules: tuple[Rule, ...]
    start: str = START

    def __post_init__(self) -> None:
        if len({(rule.left, rule.right) for rule in self.rules}) < len(self.rules):
            raise ValueError("a grammar has every rule only once")
        used = {symbol for rule in self.rules for symbol in rule.right if isinstance(symbol, str)}
        without = sorted({self.start, *used} - {rule.left for rule in self.rules})
        if without:
            raise ValueError(f"no rule rewrites {', '.join(without)}")

    @cached_property
    def nonterminals(self) -> tuple[str, ...]:
        """Left sides, the start symbol first, the others as they come in the rules."""
        return tuple(dict.fromkeys([self.start, *(rule.left for rule in self.rules)]))

    @cached_property
    def terminals(self) -> tuple[int, ...]:
        """The terminals that the rules hold, in order."""
        return tuple(sorted({s for rule in self.rules for s in rule.right if not isinstance(s, str)}))

    @cached_property
    def choices(self) -> dict[str, tuple[int, ...]]:
        """Non-terminal -> indices of the rules that rewrite it."""
        indices = choices(self.rules)
        return {left: indices[left] for left in self.nonterminals}

    @cached_property
    def probabilities(self) -> np.ndarray:
        """``(n_rules,)``: of each rule among those of its left side."""
        totals = {left: sum(self.rules[k].count for k in indices) for left, indices in self.choices.items()}
        return np.array([rule.count / totals[rule.left] for rule in self.rules])

    @cached_property
    def chart(self) -> Chart:
        """The rules made ready for parsing."""
        weights = np.log2(self.probabilities)
        return Chart([(rule.left, rule.right) for rule in self.rules], weights.tolist(), self.start)

    def accepts(self, sentence: Sequence[int]) -> bool:
        """Whether the grammar generates the sentence; raises ValueError for one too long to parse."""
        return self.chart.accepts(sentence)

    def parse(self, sentence: Sequence[int]) -> Node | None:
        """The most probable tree of a sentence, or None; raises ValueError for one too long to parse."""
        return self.chart.parse(sentence)

    def parse_series(self, symbols: Sequence[int]) -> tuple[Node, ...] | None:
        """The most probable reading of a string as sentences one after another, each tree counting from its own start
        in the string; None where there is none. Raises ValueError for one too long to parse."""
        return self.chart.parse_series(symbols)

    def log2_probability(self, sentence: Sequence[int]) -> float:
        """Log2 of the probability that the grammar generates the sentence, over all its trees; -inf where it cannot."""
        return self.chart.log2_probability(sentence)

    def rule_indices(self, tree: Node) -> tuple[int, ...]:
        """The code of SYN 5.1: in preorder, which of the rules of its left side rewrites each non-terminal, from 0."""
        return tuple(self.choices[node.name].index(node.rule) for node in preorder(tree) if not node.is_leaf)

    def tree_of(self, indices: Iterable[int]) -> Node:
        """The tree with this code; raises ParameterError where the code does not fit the grammar."""
        coming = iter(indices)

        def rewrite(left: str) -> tuple[int, tuple[Symbol, ...]]:
            index = next(coming, -1)
            if not 0 <= index < len(self.choices[left]):
                raise ParameterError(f"no tree of this grammar has the rule indices given: {left} has no rule {index}")
            rule = self.choices[left][index]
            return rule, self.rules[rule].right

        tree = build_tree(self.start, rewrite)
        if next(coming, None) is not None:
            raise ParameterError("there are more rule indices than the tree has non-terminals")
        return tree

    def reconstruct(self, indices: Iterable[int]) -> tuple[int, ...]:
        """The sentence with this code; raises ValueError where the code does not fit the grammar."""
        return leaves(self.tree_of(indices))

    def generate(self, seed: int | np.random.Generator = 0, max_terminals: int = 40, symbol: str | None = None) -> Node:
        """A random tree, the same for the same seed, of about ``max_terminals`` at most; see
        :func:`core.grammar.generation.generate`. Raises ValueError for a symbol from which nothing comes."""
        rng = np.random.default_rng(seed)
        return generate(self.rules, self.probabilities, rng, symbol or self.start, max_terminals)

    def bits(self, trees: Iterable[Node]) -> Bits:
        """Description length of the grammar and of the sentences with these trees (SYN 5.1)."""
        written = sum(1 + len(rule.right) for rule in self.rules) + max(0, len(self.rules) - 1)  # and separators
        symbols = len(self.nonterminals) + len(self.terminals) + 1
        return Bits(written * float(np.log2(symbols)), float(sum(self.sentence_bits(tree) for tree in trees)))

    def sentence_bits(self, tree: Node) -> float:
        """Bits of one sentence: log2 of the number of rules to choose from, for every non-terminal of its tree."""
        return float(sum(np.log2(len(self.choices[node.name])) for node in preorder(tree) if not node.is_leaf))


def counted(trees: Iterable[Node], rules: Sequence[tuple[str, tuple[Symbol, ...]]], start: str = START) -> Grammar:
    """The grammar of the rules that the trees use, with their counts; ``rules``: what their rule indices mean.

    The trees' indices hold for the grammar where every rule is used.
    """
    counts = np.zeros(len(rules), int)
    for tree in trees:
        for node in preorder(tree):
            if not node.is_leaf:
                counts[node.rule] += 1
    return Grammar(tuple(Rule(*rule, int(n)) for rule, n in zip(rules, counts, strict=True) if n), start)
