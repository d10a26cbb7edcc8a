"""Parse trees, with the span of the sentence that every node covers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

Symbol = int | str
"""A terminal is a number (0 or more), a non-terminal a name."""

LEAF = -1


class Node(NamedTuple):
    """A node of a parse tree: terminals [start, end) of the sentence.

    symbol: a terminal (a leaf) or a non-terminal. rule: index of the grammar's rule that rewrites it, LEAF for a
    terminal. children: of the rule's right side, in order.
    """

    symbol: Symbol
    start: int
    end: int
    rule: int = LEAF
    children: tuple[Node, ...] = ()

    @property
    def is_leaf(self) -> bool:
        """Whether it is a terminal of the sentence."""
        return self.rule == LEAF

    @property
    def name(self) -> str:
        """The non-terminal of an inner node. Raises TypeError for a leaf."""
        if not isinstance(self.symbol, str):
            raise TypeError(f"the terminal {self.symbol} has no name")
        return self.symbol


Path = tuple[int, ...]
"""The way from the root to a node: which child, and which child of that; () is the root."""


def preorder(tree: Node) -> Iterator[Node]:
    """All nodes, parents before children, left before right."""
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        yield node
        waiting += reversed(node.children)


def leaves(tree: Node) -> tuple[int, ...]:
    """The sentence: the terminals of a tree in order."""
    return tuple(node.symbol for node in preorder(tree) if not isinstance(node.symbol, str))


def depth(tree: Node) -> int:
    """Non-terminals on the longest way down."""
    return 0 if tree.is_leaf else 1 + max((depth(child) for child in tree.children), default=0)


def at_path(tree: Node, path: Sequence[int]) -> Node:
    """The node at ``path``; raises IndexError where there is none."""
    for child in path:
        if not 0 <= child < len(tree.children):
            raise IndexError(f"the tree has no node {tuple(path)}")
        tree = tree.children[child]
    return tree


def build_tree(symbol: Symbol, rules: Callable[[str], tuple[int, Sequence[Symbol]]], start: int = 0) -> Node:
    """The tree below ``symbol``; ``rules(left)`` gives the rule that rewrites a non-terminal: its index and right side.

    It is asked in preorder.
    """
    if not isinstance(symbol, str):
        return Node(symbol, start, start + 1)
    rule, right = rules(symbol)
    children, at = [], start
    for part in right:
        children.append(build_tree(part, rules, at))
        at = children[-1].end
    return Node(symbol, start, at, rule, tuple(children))


def shifted(tree: Node, by: int) -> Node:
    """The same tree ``by`` terminals further on."""
    return tree._replace(
        start=tree.start + by, end=tree.end + by, children=tuple(shifted(child, by) for child in tree.children)
    )


def tree_json(tree: Node) -> dict[str, Any]:
    """A tree as nested objects: symbol, start, end, and where it is no leaf rule and children."""
    plain: dict[str, Any] = {"symbol": tree.symbol, "start": tree.start, "end": tree.end}
    return plain if tree.is_leaf else plain | {"rule": tree.rule, "children": [tree_json(c) for c in tree.children]}


def brackets(tree: Node, name: Callable[[Symbol], str] = str) -> str:
    """A tree on one line: ``S(r X1(f d) m)``."""
    if tree.is_leaf:
        return name(tree.symbol)
    return f"{name(tree.symbol)}({_spaced(brackets(child, name) for child in tree.children)})"


def _spaced(words: Iterable[str]) -> str:
    return " ".join(words)
