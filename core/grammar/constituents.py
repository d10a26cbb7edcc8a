"""From bracketed sentences to rules and trees, and kinds that are better made one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np

from core.grammar.alignment import Sentence
from core.grammar.motion_grammar import START, Grammar, counted
from core.grammar.selection import Bracket
from core.grammar.trees import Node, Symbol, preorder

Right = tuple[Symbol, ...]
END = -1
"""What stands before and after a whole sentence."""


def read_off(sentences: Sequence[Sentence], brackets: Sequence[Sequence[Bracket]]) -> tuple[Node, ...]:
    """The trees of bracketed sentences. Their rule indices say only which are equal; :func:`grammar_of` numbers them.

    Kinds are named X1, X2, ... as they come.
    """
    names: dict[int, str] = {}
    trees = []
    for sentence, inside in zip(sentences, brackets, strict=True):
        waiting = sorted(inside, key=lambda b: (b.start, -b.end))[::-1]

        def node(left: str, start: int, end: int, sentence=sentence, waiting=waiting) -> Node:
            children, at = [], start
            while at < end or (waiting and waiting[-1].end <= end):
                if waiting and waiting[-1].start == at and waiting[-1].end <= end:
                    inner = waiting.pop()
                    name = names.setdefault(inner.kind, f"X{len(names) + 1}")
                    children.append(node(name, inner.start, inner.end))
                else:
                    children.append(Node(sentence[at], at, at + 1))
                at = children[-1].end
            return Node(left, start, end, 0, tuple(children))

        trees.append(node(START, 0, len(sentence)))
    return tuple(trees)


def grammar_of(trees: Sequence[Node]) -> tuple[Grammar, tuple[Node, ...]]:
    """The rules that the trees use, with their counts, and the trees with the rules' indices. START comes first, then
    the others as they are met; the rules of one left side stand together, the most used first."""
    counts = Counter(_rule(node) for tree in trees for node in preorder(tree) if not node.is_leaf)
    lefts = {left: k for k, left in enumerate(dict.fromkeys([START, *(left for left, _ in counts)]))}
    ordered = sorted(counts, key=lambda rule: (lefts[rule[0]], -counts[rule]))
    index = {rule: k for k, rule in enumerate(ordered)}
    trees = tuple(_numbered(tree, index) for tree in trees)
    return counted(trees, ordered), trees


def renamed(tree: Node, names: Mapping[str, str]) -> Node:
    """The tree with other names of non-terminals; rule indices as :func:`read_off`."""
    if tree.is_leaf:
        return tree
    children = tuple(renamed(child, names) for child in tree.children)
    return tree._replace(symbol=names.get(tree.symbol, tree.symbol), rule=0, children=children)


def contexts_of(sentences: Sequence[Sentence], trees: Sequence[Node]) -> dict[str, set[tuple[int, int]]]:
    """Kind -> what stands before and after its constituents; END at the ends of a sentence."""
    found: dict[str, set[tuple[int, int]]] = {}
    for sentence, tree in zip(sentences, trees, strict=True):
        framed = (END, *sentence, END)
        for node in preorder(tree):
            if not node.is_leaf:
                found.setdefault(node.symbol, set()).add((framed[node.start], framed[node.end + 1]))
    return found


def alike(a: set[tuple[int, int]], b: set[tuple[int, int]]) -> bool:
    """Whether the contexts of two kinds all have the symbol before in common, or that after."""
    return all(x[0] == y[0] or x[1] == y[1] for x in a for y in b)


def merge_kinds(sentences: Sequence[Sentence], trees: Sequence[Node], sharing: str = "side") -> tuple[Node, ...]:
    """The trees with kinds made one while that shortens the total description (SYN equation 6), the most gain first.

    sharing: "rules" looks at kinds that have half of the rules of the smaller one in common; "side" asks besides that
    all their contexts have a side in common. Raises ValueError for another word.
    """
    if sharing not in ("side", "rules"):
        raise ValueError(f"sharing must be side or rules, not {sharing!r}")
    rules = {_rule(node) for tree in trees for node in preorder(tree) if not node.is_leaf}
    uses = Counter(node.symbol for tree in trees for node in preorder(tree) if not node.is_leaf)
    contexts = contexts_of(sentences, trees)
    names: dict[str, str] = {}
    now = _length(rules, uses)
    while True:
        best = None
        for a, b in sorted(_pairs(rules)):
            if sharing == "side" and not alike(contexts[a], contexts[b]):
                continue
            merged, used = _merged(rules, a, b), _used(uses, a, b)
            length = _length(merged, used)
            if length < now - 1e-9 and (best is None or length < best[0]):
                best = length, a, b, merged, used
        if best is None:
            break
        now, a, b, rules, uses = best
        names = {old: a if new == b else new for old, new in names.items()} | {b: a}
        contexts[a] |= contexts.pop(b)
    return tuple(renamed(tree, names) for tree in trees)


def _rule(node: Node) -> tuple[str, Right]:
    return node.symbol, tuple(child.symbol for child in node.children)


def _numbered(tree: Node, index: Mapping[tuple[str, Right], int]) -> Node:
    if tree.is_leaf:
        return tree
    return tree._replace(rule=index[_rule(tree)], children=tuple(_numbered(child, index) for child in tree.children))


def _pairs(rules: set[tuple[str, Right]]) -> set[tuple[str, str]]:
    """Kinds but START that have in common half of the right sides of the one with fewer."""
    lefts: dict[Right, list[str]] = {}
    for left, right in rules:
        if left != START:
            lefts.setdefault(right, []).append(left)
    common = Counter(pair for found in lefts.values() for pair in combinations(sorted(found), 2))
    choices = Counter(left for left, _ in rules)
    return {(a, b) for (a, b), n in common.items() if 2 * n >= min(choices[a], choices[b])}


def _merged(rules: set[tuple[str, Right]], a: str, b: str) -> set[tuple[str, Right]]:
    return {
        (a if left == b else left, tuple(a if s == b else s for s in right) if b in right else right)
        for left, right in rules
    }


def _used(uses: Mapping[str, int], a: str, b: str) -> dict[str, int]:
    return {left: n + uses[b] * (left == a) for left, n in uses.items() if left != b}


def _length(rules: set[tuple[str, Right]], uses: Mapping[str, int]) -> float:
    """Total description length in bits, as :meth:`Grammar.bits`."""
    choices = Counter(left for left, _ in rules)
    terminals = {s for _, right in rules for s in right if not isinstance(s, str)}
    written = sum(2 + len(right) for _, right in rules) - 1
    told = sum(n * np.log2(choices[left]) for left, n in uses.items())
    return written * np.log2(len(choices) + len(terminals) + 1) + float(told)
