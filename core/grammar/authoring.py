"""Editing a generated sentence by its tree: constituents around a terminal, alternatives for them, replacement.

SYN section 6. All are pure functions on trees of :mod:`core.grammar.trees`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.errors import ParameterError
from core.grammar.motion_grammar import Grammar
from core.grammar.trees import Node, Path, at_path, leaves, shifted

_TRIES = 60  # at a different alternative, for each that is wanted


def constituents(tree: Node, terminal: int) -> tuple[Path, ...]:
    """The non-terminals above terminal number ``terminal`` of a sentence, as paths: that which made it first, the whole
    sentence last. Raises IndexError where there is no such terminal."""
    if not tree.start <= terminal < tree.end:
        raise IndexError(f"the sentence has no terminal {terminal}")
    path: Path = ()
    paths = []
    node = tree
    while not node.is_leaf:
        paths.append(path)
        child = next(k for k, part in enumerate(node.children) if part.start <= terminal < part.end)
        node, path = node.children[child], (*path, child)
    return tuple(paths[::-1])


def alternatives(
    grammar: Grammar, tree: Node, path: Sequence[int], n: int = 4, seed: int = 0, max_terminals: int | None = None
) -> tuple[Node, ...]:
    """Up to ``n`` sentences (trees) that differ from this one in what the constituent at ``path`` became.

    Each reads differently; there are fewer where the grammar has fewer, within ``max_terminals`` for the constituent
    (twice what it has and five more where None). The same seed gives the same ones.
    Raises IndexError where there is no such node, ValueError where it is a terminal.
    """
    node = _constituent(tree, path)
    own = leaves(node)
    most = 2 * len(own) + 5 if max_terminals is None else max_terminals
    rng = np.random.default_rng(seed)
    trees: dict[tuple[int, ...], Node] = {}
    for _ in range(_TRIES * n):
        if len(trees) == n:
            break
        made = grammar.generate(rng, most, node.name)
        spelled = leaves(made)
        if spelled != own and spelled not in trees:
            trees[spelled] = made
    return tuple(replace(tree, path, made) for made in trees.values())


def replace(tree: Node, path: Sequence[int], made: Node) -> Node:
    """The sentence with ``made``, a tree below the same non-terminal, in place of the constituent at ``path``.

    Raises IndexError where there is no such node, ParameterError where it is another symbol.
    """
    if made.symbol != at_path(tree, path).symbol:
        raise ParameterError(f"{made.symbol} cannot stand in place of {at_path(tree, path).symbol}")
    return _placed(_replaced(tree, path, made), tree.start)


def _constituent(tree: Node, path: Sequence[int]) -> Node:
    node = at_path(tree, path)
    if node.is_leaf:
        raise ParameterError("a terminal has no alternatives; choose the constituent that made it")
    return node


def _replaced(tree: Node, path: Sequence[int], made: Node) -> Node:
    if not path:
        return made
    child, *rest = path
    children = list(tree.children)
    children[child] = _replaced(children[child], rest, made)
    return tree._replace(children=tuple(children))


def _placed(tree: Node, start: int) -> Node:
    """The tree with spans that fit its leaves."""
    if tree.is_leaf:
        return shifted(tree, start - tree.start)
    children, at = [], start
    for child in tree.children:
        children.append(_placed(child, at))
        at = children[-1].end
    return tree._replace(start=start, end=at, children=tuple(children))
