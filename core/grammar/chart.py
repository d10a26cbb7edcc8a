"""Chart parsing of any context-free grammar: left recursion, empty right sides and cycles of rules included.

Right sides are shared as a trie of prefixes, so that every step joins a prefix with one more symbol (the binary rules
of a CYK chart). What an empty right side lets vanish, and rules with one symbol, become unit steps inside a span,
closed by relaxation. Scores are log2 probabilities.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from core.errors import AnalysisError
from core.grammar.chart_kernels import inside, viterbi
from core.grammar.trees import Node, Symbol

_NONE = -1
_ROUNDS = 200  # of the sum over empty derivations
_MOST_CELLS = 40_000_000  # of a chart: 400 terminals with 250 symbols


class _Edges(NamedTuple):
    """Edges in rows by their first symbol: row s is ``[first[s], first[s + 1])``; all int32 but weight ``(n,)``."""

    first: np.ndarray
    second: np.ndarray  # symbol that is joined, unused for unit steps
    target: np.ndarray
    weight: np.ndarray
    label: np.ndarray  # what a unit step stands for, see _Steps


class _Step(NamedTuple):
    """A unit step: a rule is complete (rule), or a prefix gains a symbol, or is one, while another part is empty."""

    rule: int = _NONE
    empty_left: int = _NONE
    empty_right: int = _NONE


@dataclass
class _Builder:
    """The symbols of a grammar as numbers: terminals, non-terminals, prefixes of right sides."""

    numbers: dict[Symbol, int]
    prefixes: dict[tuple[int, int], int] = field(default_factory=dict)
    ends: dict[int, list[tuple[int, int, float]]] = field(default_factory=dict)  # symbol or prefix -> rules

    @property
    def size(self) -> int:
        return len(self.numbers) + len(self.prefixes)

    def add(self, rule: int, left: int, right: Sequence[int], weight: float) -> None:
        state = right[0]
        for symbol in right[1:]:
            state = self.prefixes.setdefault((state, symbol), self.size)
        self.ends.setdefault(state, []).append((left, rule, weight))


class Chart:
    """A grammar made ready for parsing.

    rules: (left, right) pairs; weights: log2 of the probability of each. start: the start symbol.
    """

    def __init__(self, rules: Sequence[tuple[str, tuple[Symbol, ...]]], weights: Sequence[float], start: str) -> None:
        lefts = dict.fromkeys(left for left, _ in rules)
        lefts.setdefault(start)
        terminals = dict.fromkeys(s for _, right in rules for s in right if not isinstance(s, str))
        unknown = {s for _, right in rules for s in right if isinstance(s, str)} - set(lefts)
        symbols: list[Symbol] = [*terminals, *lefts, *sorted(unknown)]
        numbers = {symbol: k for k, symbol in enumerate(symbols)}
        self._symbols = list(numbers)
        self._terminals: Mapping[int, int] = {t: numbers[t] for t in terminals}
        self._start, self._rules = numbers[start], rules
        builder = _Builder(numbers)
        self._empty_rules: dict[int, list[tuple[int, float]]] = {}
        for k, ((left, right), weight) in enumerate(zip(rules, weights, strict=True)):
            if right:
                builder.add(k, numbers[left], [numbers[s] for s in right], weight)
            else:
                self._empty_rules.setdefault(numbers[left], []).append((k, weight))
        self._builder, self._parts = builder, {state: pair for pair, state in builder.prefixes.items()}
        self._binary = _rows(builder.size, [(a, b, t, 0.0, _NONE) for (a, b), t in builder.prefixes.items()])
        self._best_empty, self._empty_step = self._best_empties()
        self._steps, self._unit = self._units(self._best_empty)
        sums = self._sum_empties()
        self._sum_empty, self._sum_unit = sums, self._units(sums)[1]

    def accepts(self, sentence: Sequence[int]) -> bool:
        """Whether the start symbol derives it."""
        return self.score(sentence) > -np.inf

    def score(self, sentence: Sequence[int]) -> float:
        """Log2 of the probability of its best tree; -inf where there is none."""
        if not len(sentence):
            return float(self._best_empty[self._start])
        best = self._viterbi(sentence)
        return -np.inf if best is None else float(best.of(0, len(sentence), self._start))

    def parse(self, sentence: Sequence[int]) -> Node | None:
        """The most probable tree, or None."""
        if not len(sentence):
            return None if self._best_empty[self._start] == -np.inf else self._empty_tree(self._start, 0)
        best = self._viterbi(sentence)
        if best is None or best.of(0, len(sentence), self._start) == -np.inf:
            return None
        return self._tree(best, best.places[0, len(sentence), self._start], 0, len(sentence))

    def parse_series(self, symbols: Sequence[int]) -> tuple[Node, ...] | None:
        """The most probable way to read a string as sentences one after another; None where there is none."""
        n = len(symbols)
        best = self._viterbi(symbols)
        if best is None:
            return () if n == 0 else None
        total, back = np.full(n + 1, -np.inf), np.zeros(n + 1, np.int64)
        total[0] = 0.0
        for end in range(1, n + 1):
            through = [total[begin] + best.of(begin, end, self._start) for begin in range(end)]
            back[end] = int(np.argmax(through))
            total[end] = through[back[end]]
        if total[n] == -np.inf:
            return None
        cuts = [n]
        while cuts[-1]:
            cuts.append(int(back[cuts[-1]]))
        spans = list(zip(cuts[:0:-1], cuts[-2::-1], strict=True))
        return tuple(self._tree(best, best.places[a, b, self._start], a, b) for a, b in spans)

    def log2_probability(self, sentence: Sequence[int]) -> float:
        """Log2 of the sum over all trees; -inf where there is none. Raises ValueError for what is too long."""
        if not len(sentence):
            return float(self._sum_empty[self._start])
        numbers = self._numbers(sentence)
        if numbers is None:
            return -np.inf
        unit = self._sum_unit
        sizes = len(self._symbols), self._builder.size
        return float(inside(numbers, self._start, *sizes, *self._binary[:3], unit.first, unit.target, unit.weight))

    def _numbers(self, sentence: Sequence[int]) -> np.ndarray | None:
        """The sentence as numbers ``(n,)`` int32; None where a terminal is unknown."""
        if (len(sentence) + 1) ** 2 * len(self._symbols) > _MOST_CELLS:
            raise AnalysisError(f"a sentence of {len(sentence)} terminals is too long to be parsed by this grammar")
        numbers = [self._terminals.get(terminal, _NONE) for terminal in sentence]
        return None if _NONE in numbers else np.array(numbers, np.int32)

    def _viterbi(self, sentence: Sequence[int]) -> _Best | None:
        numbers = self._numbers(sentence) if len(sentence) else None
        if numbers is None:
            return None
        unit = self._unit
        sizes = len(self._symbols), self._builder.size
        return _Best(*viterbi(numbers, *sizes, *self._binary[:3], unit.first, unit.target, unit.weight, unit.label))

    def _best_empties(self) -> tuple[np.ndarray, dict[int, int]]:
        """Log2 probability of the best empty derivation of every symbol and prefix, and the rule it begins with."""
        best, chosen = np.full(self._builder.size, -np.inf), {}
        changed = True
        while changed:
            changed = False
            for left, choices in self._empty_rules.items():
                for rule, weight in choices:
                    if weight > best[left]:
                        best[left], chosen[left], changed = weight, rule, True
            for state, (a, b) in self._parts.items():
                if best[a] + best[b] > best[state]:
                    best[state], changed = best[a] + best[b], True
            for state, rules in self._builder.ends.items():
                for left, rule, weight in rules:
                    if best[state] + weight > best[left]:
                        best[left], chosen[left], changed = best[state] + weight, rule, True
        return best, chosen

    def _sum_empties(self) -> np.ndarray:
        """Log2 of the sum over all empty derivations ``(n_symbols,)``: the least fixed point, by iteration."""
        total = np.zeros(self._builder.size)
        own = np.zeros_like(total)
        for left, choices in self._empty_rules.items():
            own[left] = sum(2.0**weight for _, weight in choices)
        for _ in range(_ROUNDS):
            new = own.copy()
            for state, rules in self._builder.ends.items():
                for left, _, weight in rules:
                    new[left] += total[state] * 2.0**weight
            for state, (a, b) in self._parts.items():
                new[state] = new[a] * new[b]
            done = np.abs(new - total).max(initial=0.0) < 1e-15
            total = new
            if done:
                break
        with np.errstate(divide="ignore"):
            return np.log2(total)

    def _units(self, empties: np.ndarray) -> tuple[list[_Step], _Edges]:
        """The unit steps, and their edges from the symbol below to the one above."""
        steps: list[_Step] = []
        edges: list[tuple[int, int, int, float, int]] = []
        for state, rules in self._builder.ends.items():
            for left, rule, weight in rules:
                edges.append((state, 0, left, weight, len(steps)))
                steps.append(_Step(rule=rule))
        for state, (a, b) in self._parts.items():
            if empties[b] > -np.inf:
                edges.append((a, 0, state, empties[b], len(steps)))
                steps.append(_Step(empty_right=b))
            if empties[a] > -np.inf:
                edges.append((b, 0, state, empties[a], len(steps)))
                steps.append(_Step(empty_left=a))
        return steps, _rows(self._builder.size, edges)

    def _tree(self, best: _Best, entry: int, start: int, end: int) -> Node:
        """The tree of an entry that stands for a symbol (not a prefix)."""
        symbol, step, left, _, _ = best.entries[entry].tolist()
        if step == _NONE:
            return Node(self._symbols[symbol], start, end)
        children = self._parts_of(best, left, start, end)
        return Node(self._symbols[symbol], start, end, self._steps[step].rule, tuple(children))

    def _parts_of(self, best: _Best, entry: int, start: int, end: int) -> list[Node]:
        """The nodes of the symbols that a prefix is made of."""
        done = []
        while best.entries[entry, 0] >= len(self._symbols):
            _, step, left, right, middle = best.entries[entry].tolist()
            if step == _NONE:  # two parts that both have terminals
                done.append(self._tree(best, right, middle, end))
                end = middle
            elif self._steps[step].empty_right != _NONE:
                done.append(self._empty_tree(self._steps[step].empty_right, end))
            else:
                done.append(self._tree(best, left, start, end))
                return [*self._empty_parts(self._steps[step].empty_left, start), *reversed(done)]
            entry = left
        done.append(self._tree(best, entry, start, end))
        return done[::-1]

    def _empty_tree(self, symbol: int, at: int) -> Node:
        rule = self._empty_step[symbol]
        numbers = self._builder.numbers
        children = (self._empty_tree(numbers[part], at) for part in self._rules[rule][1])
        return Node(self._symbols[symbol], at, at, rule, tuple(children))

    def _empty_parts(self, state: int, at: int) -> list[Node]:
        if state < len(self._symbols):
            return [self._empty_tree(state, at)]
        before, last = self._parts[state]
        return [*self._empty_parts(before, at), self._empty_tree(last, at)]


class _Best(NamedTuple):
    """Best derivations. places ``(n + 1, n + 1, n_symbols)``: entry of a symbol over a span, or -1; entries ``(m, 5)``:
    symbol, unit step (-1: none), left and right entry, middle of the span; scores ``(m,)``."""

    places: np.ndarray
    entries: np.ndarray
    scores: np.ndarray

    def of(self, start: int, end: int, symbol: int) -> float:
        entry = self.places[start, end, symbol]
        return -np.inf if entry < 0 else float(self.scores[entry])


def _rows(size: int, edges: Sequence[tuple[int, int, int, float, int]]) -> _Edges:
    edges = sorted(edges)
    source = np.array([edge[0] for edge in edges], np.int32)
    first = np.searchsorted(source, np.arange(size + 1)).astype(np.int32)
    columns = [np.array([edge[k] for edge in edges], kind) for k, kind in enumerate([np.int32] * 3 + [float, np.int32])]
    return _Edges(first, *columns[1:])
