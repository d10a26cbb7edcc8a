"""New sentences: non-terminals rewritten by chance until none is left (SYN section 6)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.errors import AnalysisError
from core.grammar.rules import Rule, choices
from core.grammar.trees import Node, Symbol, build_tree

DEEPEST = 40  # non-terminals one inside another


class Least(NamedTuple):
    """The shortest that can come of a symbol: terminals, and the depth of the tree; rule: which one begins it."""

    terminals: float
    depth: float
    rule: int = -1


_ENDLESS = Least(np.inf, np.inf)


def least(rules: Sequence[Rule]) -> dict[str, Least]:
    """Non-terminal -> its shortest derivation, in terminals, then in depth; endless ones have infinitely many."""
    shortest = dict.fromkeys((rule.left for rule in rules), _ENDLESS)
    changed = True
    while changed:
        changed = False
        for k, rule in enumerate(rules):
            new = through(rule.right, shortest)._replace(rule=k)
            if new[:2] < shortest[rule.left][:2]:
                shortest[rule.left], changed = new, True
    return shortest


def through(right: tuple[Symbol, ...], known: dict[str, Least]) -> Least:
    """The shortest that can come of a right side."""
    parts = [known[symbol] if isinstance(symbol, str) else Least(1, 0) for symbol in right]
    return Least(sum(part.terminals for part in parts), 1 + max((part.depth for part in parts), default=0))


def generate(
    rules: Sequence[Rule],
    probabilities: np.ndarray,
    rng: np.random.Generator,
    symbol: str,
    max_terminals: int,
    max_depth: int = DEEPEST,
) -> Node:
    """A random tree below ``symbol``: rules by their probability, among those that keep within both bounds.

    probabilities: ``(n_rules,)``, those of the rules with one left side add up to 1. Where no rule keeps within the
    bounds, the shortest derivation ends the tree: rules may be cyclic. The bounds are only broken where even that is
    too long. Raises AnalysisError for a symbol that has no rule or no finite derivation.
    """
    known, rules_of = least(rules), choices(rules)
    if known.get(symbol, _ENDLESS).terminals == np.inf:
        raise AnalysisError(f"nothing can be generated from {symbol}")
    room = max_terminals - known[symbol].terminals  # terminals that may still come on top of the shortest
    depths = [0]  # of the non-terminals that are still to be rewritten, as they come in preorder

    def rewrite(left: str) -> tuple[int, tuple[Symbol, ...]]:
        nonlocal room
        depth = depths.pop()
        fits, costs = [], []
        for k in rules_of[left]:
            own = through(rules[k].right, known)
            if own.terminals - known[left].terminals <= room and depth + own.depth <= max_depth:
                fits.append(k)
                costs.append(own.terminals - known[left].terminals)
        if fits:
            chances = probabilities[fits]
            chosen = int(rng.choice(len(fits), p=chances / chances.sum()))
            rule = fits[chosen]
            room -= costs[chosen]
        else:
            rule = known[left].rule
        right = rules[rule].right
        depths.extend(depth + 1 for part in right if isinstance(part, str))
        return rule, right

    return build_tree(symbol, rewrite)
