"""Turns bracketed sentences into rules and trees, and merges kinds of constituents."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import combinations

import numpy as np

from core.grammar.alignment import Sentence
from core.grammar.motion_grammar import START, Grammar, counted
from core.grammar.neighbours import END, Neighbours
from core.grammar.selection import Bracket
from core.grammar.trees import Node, Symbol, preorder
from core.progress import Progress, unheard

Right = tuple[Symbol, ...]
_TURNS = 6  # of merging: progress is half way after so many


def read_off(sentences: Sequence[Sentence], brackets: Sequence[Sequence[Bracket]]) -> tuple[Node, ...]:
    """The trees of bracketed sentences. Their rule indices say only which are equal; :func:`grammar_of` numbers them.

    Kinds are named X1, X2, ... as they come.
    """
    names: dict[int, str] = {}
    trees = []
    for sentence, inside in zip(sentences, brackets, strict=True):
        waiting = sorted(inside, key=lambda b: (b.start, -b.end))[::-1]

        def node(
            left: str, start: int, end: int, sentence: Sentence = sentence, waiting: list[Bracket] = waiting
        ) -> Node:
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
    return tree._replace(symbol=names.get(tree.name, tree.name), rule=0, children=children)


def contexts_of(sentences: Sequence[Sentence], trees: Sequence[Node]) -> dict[str, set[tuple[int, int]]]:
    """Kind -> what stands before and after its constituents; END at the ends of a sentence."""
    contexts: dict[str, set[tuple[int, int]]] = {}
    for sentence, tree in zip(sentences, trees, strict=True):
        framed = (END, *sentence, END)
        for node in preorder(tree):
            if not node.is_leaf:
                contexts.setdefault(node.name, set()).add((framed[node.start], framed[node.end + 1]))
    return contexts


def _words_of(sentences: Sequence[Sentence], trees: Sequence[Node]) -> dict[str, set[Sentence]]:
    """Kind -> what its constituents are."""
    words: dict[str, set[Sentence]] = {}
    for sentence, tree in zip(sentences, trees, strict=True):
        for node in preorder(tree):
            if not node.is_leaf:
                words.setdefault(node.name, set()).add(sentence[node.start : node.end])
    return words


def alike(a: set[tuple[int, int]], b: set[tuple[int, int]]) -> bool:
    """Whether all contexts of two kinds have the same symbol before, or the same after."""
    return all(x[0] == y[0] or x[1] == y[1] for x in a for y in b)


def merge_kinds(
    sentences: Sequence[Sentence], trees: Sequence[Node], sharing: str = "side", progress: Progress = unheard
) -> tuple[Node, ...]:
    """The trees with kinds made one while that shortens the total description (SYN equation 6), the most gain first.

    sharing: "rules" looks at kinds that have half of the rules of the smaller one in common; "side" asks besides that
    all their contexts have a side in common. Either makes new neighbours only where such are to be expected
    (:class:`core.grammar.neighbours.Neighbours`). One kind for two of which one may hold the other could repeat itself
    without end, which no recording has shown. So these stay apart; where one would be shorter, the outer one gets the
    rule that it may be an inner one, in place of the rules that both have. Raises ValueError for another word.
    """
    if sharing not in ("side", "rules"):
        raise ValueError(f"sharing must be side or rules, not {sharing!r}")
    neighbours, trees = Neighbours(sentences), tuple(trees)
    turn = 0
    while True:
        progress(turn / (turn + _TURNS))  # nobody knows how many there will be
        description = Description(trees)
        contexts, words = contexts_of(sentences, trees), _words_of(sentences, trees)
        names = _merged(description, contexts, words, neighbours, sharing)
        trees = tuple(renamed(tree, names) for tree in trees)
        outer, inner = _widened(description, contexts, words, neighbours, sharing)
        if not outer:
            return _numbered_on(trees)
        rights = description.rights(inner)
        trees = tuple(_with_inner(tree, outer, inner, rights) for tree in trees)
        turn += 1


def _merged(
    description: Description,
    contexts: dict[str, set[tuple[int, int]]],
    words: dict[str, set[Sentence]],
    neighbours: Neighbours,
    sharing: str,
) -> dict[str, str]:
    """Makes kinds one, in place, while that shortens the description; old name -> new name."""
    names: dict[str, str] = {}
    while True:
        inside = description.inside
        pairs = {(a, b) for a, b in _pairs(description.rules) if a not in inside[b] and b not in inside[a]}
        if sharing == "side":
            pairs = {(a, b) for a, b in pairs if alike(contexts[a], contexts[b])}
        pairs = {(a, b) for a, b in pairs if neighbours.allow(contexts[a] | contexts[b], words[a] | words[b])}
        gains = sorted((description.gain(a, b), a, b) for a, b in pairs)
        if not gains or gains[0][0] >= -1e-9:
            return names
        _, a, b = gains[0]
        description.merge(a, b)
        names = {old: a if new == b else new for old, new in names.items()} | {b: a}
        contexts[a] |= contexts.pop(b)
        words[a] |= words.pop(b)


def _widened(
    description: Description,
    contexts: Mapping[str, set[tuple[int, int]]],
    words: Mapping[str, set[Sentence]],
    neighbours: Neighbours,
    sharing: str,
) -> tuple[str, str]:
    """The outer and the inner kind that would shorten the description most as one; empty for none."""
    inside, best = description.inside, (-1e-9, "", "")
    for pair in _pairs(description.rules):
        outer, inner = pair if pair[1] in inside[pair[0]] else pair[::-1]
        if inner not in inside[outer] or outer in inside[inner]:
            continue
        if sharing == "side" and not alike(contexts[outer], contexts[inner]):
            continue
        if neighbours.allow(contexts[outer], words[outer] | words[inner]):
            best = min(best, (description.gain(*sorted(pair)), outer, inner))
    return best[1], best[2]


def _with_inner(tree: Node, outer: str, inner: str, rights: set[Right]) -> Node:
    """The tree with an ``inner`` between each ``outer`` and its children where these are a right side of ``inner``."""
    if tree.is_leaf:
        return tree
    children = tuple(_with_inner(child, outer, inner, rights) for child in tree.children)
    tree = tree._replace(rule=0, children=children)
    if tree.name != outer or _rule(tree)[1] not in rights:
        return tree
    return tree._replace(children=(tree._replace(symbol=inner),))


class Description:
    """Rules of trees, how often each left side is rewritten, and what merging two of them would do to the bits."""

    def __init__(self, trees: Sequence[Node]) -> None:
        inner = [node for tree in trees for node in preorder(tree) if not node.is_leaf]
        self.uses = Counter(node.name for node in inner)
        self.rules = {_rule(node) for node in inner}
        self.choices = Counter(left for left, _ in self.rules)
        self.terminals = len({s for _, right in self.rules for s in right if not isinstance(s, str)})
        self.holding: dict[str, set[tuple[str, Right]]] = {left: set() for left in self.choices}
        for rule in self.rules:
            for name in _names(rule):
                self.holding[name].add(rule)

    def rights(self, left: str) -> set[Right]:
        """The right sides of a kind."""
        return {right for name, right in self.rules if name == left}

    @property
    def inside(self) -> dict[str, set[str]]:
        """Kind -> the kinds that may stand inside its constituents, at any depth."""
        direct: dict[str, set[str]] = {left: set() for left in self.choices}
        for left, right in self.rules:
            direct[left].update(symbol for symbol in right if isinstance(symbol, str))
        reached: dict[str, set[str]] = {}
        for left, found in direct.items():
            waiting, reached[left] = list(found), set()
            while waiting:
                kind = waiting.pop()
                if kind not in reached[left]:
                    reached[left].add(kind)
                    waiting.extend(direct.get(kind, ()))
        return reached

    def gain(self, a: str, b: str) -> float:
        """By how many bits the total changes (SYN equation 6, as :meth:`Grammar.bits`) where b becomes a."""
        old = self.holding[b]
        new = {_with(rule, a, b) for rule in old} - self.rules
        choices = Counter(left for left, _ in new)
        choices.subtract(left for left, _ in old)
        written = sum(2 + len(right) for _, right in self.rules) - 1
        less = sum(2 + len(right) for _, right in old) - sum(2 + len(right) for _, right in new)
        symbols = len(self.choices) + self.terminals + 1
        bits = (written - less) * np.log2(symbols - 1) - written * np.log2(symbols)
        for left in {a, b, *choices} - {b}:
            before, used = self.choices[left], self.uses[left]
            after = before + choices[left] + (self.choices[b] + choices[b] if left == a else 0)
            bits += (used + (self.uses[b] if left == a else 0)) * np.log2(after) - used * np.log2(before)
        return float(bits - self.uses[b] * np.log2(self.choices[b]))

    def merge(self, a: str, b: str) -> None:
        """Makes b an a."""
        old = self.holding.pop(b)
        for rule in old:
            for name in _names(rule) - {b}:
                self.holding[name].discard(rule)
        new = {_with(rule, a, b) for rule in old}
        for rule in new:
            for name in _names(rule):
                self.holding[name].add(rule)
        self.rules = (self.rules - old) | new
        self.choices = Counter(left for left, _ in self.rules)
        self.uses[a] += self.uses.pop(b)


def _numbered_on(trees: Sequence[Node]) -> tuple[Node, ...]:
    """The trees with kinds named X1, X2, ... as they come, without gaps."""
    inner = dict.fromkeys(node.name for tree in trees for node in preorder(tree) if not node.is_leaf)
    names = {kind: f"X{k + 1}" for k, kind in enumerate(kind for kind in inner if kind != START)}
    return tuple(renamed(tree, names) for tree in trees)


def _rule(node: Node) -> tuple[str, Right]:
    return node.name, tuple(child.symbol for child in node.children)


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


def _with(rule: tuple[str, Right], a: str, b: str) -> tuple[str, Right]:
    left, right = rule
    return a if left == b else left, tuple(a if symbol == b else symbol for symbol in right)


def _names(rule: tuple[str, Right]) -> set[str]:
    return {rule[0], *(symbol for symbol in rule[1] if isinstance(symbol, str))}
