"""New sentences: non-terminals rewritten by chance until none is left (SYN section 6)."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from core.errors import AnalysisError
from core.grammar.trees import Node, Symbol, build_tree

if TYPE_CHECKING:
    from core.grammar.motion_grammar import Grammar

DEEPEST = 40  # non-terminals one inside another


class Least(NamedTuple):
    """The shortest that can come of a symbol: terminals, and the depth of the tree; rule: which one begins it."""

    terminals: float
    depth: float
    rule: int = -1


_ENDLESS = Least(np.inf, np.inf)


def least(grammar: Grammar) -> dict[str, Least]:
    """Non-terminal -> its shortest derivation, in terminals, then in depth; endless ones have infinitely many."""
    shortest = dict.fromkeys(grammar.nonterminals, _ENDLESS)
    changed = True
    while changed:
        changed = False
        for k, rule in enumerate(grammar.rules):
            new = through(rule.right, shortest)._replace(rule=k)
            if new[:2] < shortest[rule.left][:2]:
                shortest[rule.left], changed = new, True
    return shortest


def through(right: tuple[Symbol, ...], known: dict[str, Least]) -> Least:
    """The shortest that can come of a right side."""
    parts = [known[symbol] if isinstance(symbol, str) else Least(1, 0) for symbol in right]
    return Least(sum(part.terminals for part in parts), 1 + max((part.depth for part in parts), default=0))


def generate(
    grammar: Grammar, rng: np.random.Generator, symbol: str, max_terminals: int, max_depth: int = DEEPEST
) -> Node:
    """A random tree below ``symbol``: rules by their probability, among those that keep within both bounds.

    Where no rule does, the shortest derivation ends it: rules may be cyclic. The bounds are only broken where even that
    is too long. Raises AnalysisError for a symbol that has no rule or no finite derivation.
    """
    known = least(grammar)
    if known.get(symbol, _ENDLESS).terminals == np.inf:
        raise AnalysisError(f"nothing can be generated from {symbol}")
    room = max_terminals - known[symbol].terminals  # terminals that may still come on top of the shortest
    depths = [0]  # of the non-terminals that are still to be rewritten, as they come in preorder

    def rewrite(left: str) -> tuple[int, tuple[Symbol, ...]]:
        nonlocal room
        depth = depths.pop()
        fits, costs = [], []
        for k in grammar.choices[left]:
            own = through(grammar.rules[k].right, known)
            if own.terminals - known[left].terminals <= room and depth + own.depth <= max_depth:
                fits.append(k)
                costs.append(own.terminals - known[left].terminals)
        if fits:
            chances = grammar.probabilities[fits]
            chosen = int(rng.choice(len(fits), p=chances / chances.sum()))
            rule = fits[chosen]
            room -= costs[chosen]
        else:
            rule = known[left].rule
        right = grammar.rules[rule].right
        depths.extend(depth + 1 for part in right if isinstance(part, str))
        return rule, right

    return build_tree(symbol, rewrite)
