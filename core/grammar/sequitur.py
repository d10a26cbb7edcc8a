"""Sequitur: the hierarchy of repeats in a string (Nevill-Manning and Witten 1997), a baseline of SYN section 5.

Two rules hold after every symbol: no pair of neighbours occurs twice, and every rule is used at least twice.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeAlias

from core.grammar.motion_grammar import START, Grammar
from core.grammar.trees import Node, Symbol

_Value: TypeAlias = "int | tuple[int] | _Rule | None"  # a terminal, the end of a sentence, a rule; None: a guard


class _Link:
    """A symbol of a right side, in a ring that begins and ends at its rule's guard."""

    __slots__ = ("after", "before", "guards", "value")

    def __init__(self, value: _Value, guards: _Rule | None = None) -> None:
        self.value, self.guards = value, guards
        self.before = self.after = self


class _Rule:
    """A right side; users: the links that stand for it."""

    def __init__(self) -> None:
        self.guard = _Link(None, self)
        self.users: set[_Link] = set()

    def links(self) -> list[_Link]:
        symbols, link = [], self.guard.after
        while link is not self.guard:
            symbols.append(link)
            link = link.after
        return symbols


class _Sequitur:
    def __init__(self) -> None:
        self.top = _Rule()
        self.pairs: dict[tuple[_Value, _Value], _Link] = {}  # pair of neighbours -> its left link

    def append(self, symbol: int | tuple[int]) -> None:
        last = self.top.guard.before
        self._insert(last, symbol)
        self._check(last)

    def _insert(self, after: _Link, value: _Value) -> _Link:
        link = _Link(value)
        if isinstance(value, _Rule):
            value.users.add(link)
        self._join(link, after.after)
        self._join(after, link)
        return link

    def _join(self, left: _Link, right: _Link) -> None:
        self._forget(left)
        left.after, right.before = right, left

    def _forget(self, left: _Link) -> None:
        """Takes the pair that begins here out of the index."""
        pair = _pair(left)
        if pair is None or self.pairs.get(pair) is not left:
            return
        del self.pairs[pair]
        after = left.after  # of three equal symbols the other pair takes its place
        if _pair(after) == pair:
            self.pairs[pair] = after
        elif _pair(left.before) == pair:
            self.pairs[pair] = left.before

    def _delete(self, link: _Link) -> None:
        self._join(link.before, link.after)
        self._forget(link)  # last: the pair before may just have been handed on to it
        if isinstance(link.value, _Rule):
            link.value.users.discard(link)

    def _check(self, left: _Link) -> bool:
        """Restores both properties where the pair that begins here has broken them; whether it had."""
        pair = _pair(left)
        if pair is None:
            return False
        match = self.pairs.setdefault(pair, left)
        if match is left or match.after is left or left.after is match:
            return False
        self._match(left, match)
        return True

    def _match(self, left: _Link, match: _Link) -> None:
        if match.before.guards is not None and match.after.after.guards is not None:
            rule = match.before.guards
            self._substitute(left, rule)
        else:
            rule = _Rule()
            self._insert(self._insert(rule.guard, left.value), left.after.value)
            self._substitute(match, rule)
            self._substitute(left, rule)
            first = rule.guard.after
            self.pairs[first.value, first.after.value] = first
        for link in (rule.guard.after, rule.guard.before):
            if isinstance(link.value, _Rule) and len(link.value.users) == 1:
                self._expand(link)

    def _substitute(self, left: _Link, rule: _Rule) -> None:
        """Puts a rule in place of the pair that begins here."""
        before = left.before
        self._delete(left.after)
        self._delete(left)
        self._insert(before, rule)
        if not self._check(before):
            self._check(before.after)

    def _expand(self, link: _Link) -> None:
        """Puts the right side of a rule that is used once in place of its only use."""
        rule, before, after = link.value, link.before, link.after
        assert isinstance(rule, _Rule)
        first, last = rule.guard.after, rule.guard.before
        self._forget(before)
        self._forget(link)
        self._join(before, first)
        self._join(last, after)
        for left in (last, before):
            pair = _pair(left)
            if pair is not None and left is last:
                self.pairs[pair] = left
            elif pair is not None:
                self.pairs.setdefault(pair, left)


def _pair(left: _Link) -> tuple[_Value, _Value] | None:
    if left.guards is not None or left.after.guards is not None:
        return None
    return left.value, left.after.value


def sequitur(sentences: Sequence[Sequence[int]]) -> Grammar:
    """The grammar of Sequitur: it generates the given sentences and no others. Rules are counted once a training tree.

    Repeats are shared among sentences, and none reaches from one into the next. Raises ValueError for no sentences.
    """
    from core.grammar.constituents import grammar_of
    from core.grammar.trees import build_tree

    if not sentences:
        raise ValueError("a grammar needs sentences")
    machine = _Sequitur()
    for k, sentence in enumerate(sentences):
        for symbol in sentence:
            machine.append(int(symbol))
        machine.append((k,))  # an end of its own, so that no repeat reaches across
    names: dict[_Rule, str] = {}
    rights: dict[str, tuple[Symbol, ...]] = {}

    def named(value: _Value) -> Symbol:
        if isinstance(value, int):
            return value
        assert isinstance(value, _Rule)  # ends and guards are no symbols
        if value not in names:
            names[value] = f"X{len(names) + 1}"
            rights[names[value]] = tuple(named(link.value) for link in value.links())
        return names[value]

    tops: list[list[Symbol]] = [[]]
    for link in machine.top.links():
        if isinstance(link.value, tuple):
            tops.append([])
        else:
            tops[-1].append(named(link.value))

    def tree_of(top: Sequence[Symbol]) -> Node:
        return build_tree(START, lambda left: (0, top if left == START else rights[left]))

    return grammar_of([tree_of(top) for top in tops[:-1]])[0]
