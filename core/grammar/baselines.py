"""Baselines of the grammar: a finite state machine over terminals (SYN section 7), and Sequitur."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from core.grammar.sequitur import sequitur

__all__ = ["StateMachine", "sequitur", "state_machine"]

END = -1
"""The state before the first and after the last terminal."""


@dataclass(frozen=True)
class StateMachine:
    """A state for each terminal; transitions are the pairs of neighbours seen, ends included, and how often."""

    transitions: Mapping[tuple[int, int], int]

    @cached_property
    def leaving(self) -> dict[int, int]:
        """State -> how often it was left."""
        total: Counter[int] = Counter()
        for (state, _), count in self.transitions.items():
            total[state] += count
        return dict(total)

    def accepts(self, sentence: Sequence[int]) -> bool:
        """Whether all its transitions were seen."""
        return all(pair in self.transitions for pair in pairwise((END, *sentence, END)))

    def log2_probability(self, sentence: Sequence[int]) -> float:
        """Log2 of the probability that the machine makes this sentence; -inf where it cannot."""
        if not self.accepts(sentence):
            return -np.inf
        pairs = pairwise((END, *sentence, END))
        return float(sum(np.log2(self.transitions[pair] / self.leaving[pair[0]]) for pair in pairs))

    def generate(self, seed: int | np.random.Generator = 0, max_terminals: int = 40) -> tuple[int, ...]:
        """A random sentence; beyond ``max_terminals`` it goes the shortest way to an end."""
        rng = np.random.default_rng(seed)
        made: list[int] = []
        state = END
        while True:
            ways = [(after, count) for (before, after), count in self.transitions.items() if before == state]
            chances = np.array([count for _, count in ways], float)
            choice = int(rng.choice(len(ways), p=chances / chances.sum()))
            if len(made) >= max_terminals:
                choice = int(np.argmin([self._to_end.get(after, np.inf) for after, _ in ways]))
            state = ways[choice][0]
            if state == END:
                return tuple(made)
            made.append(state)

    @cached_property
    def _to_end(self) -> dict[int, int]:
        """State -> the fewest transitions to an end."""
        distance, reached = {END: 0}, [END]
        for target in reached:
            for before, after in self.transitions:
                if after == target and before not in distance:
                    distance[before] = distance[target] + 1
                    reached.append(before)
        return distance


def state_machine(sentences: Sequence[Sequence[int]]) -> StateMachine:
    """The machine that makes all transitions of the sentences, and no others. Raises ValueError for no sentences."""
    if not sentences:
        raise ValueError("a state machine needs sentences")
    return StateMachine(dict(Counter(pair for sentence in sentences for pair in pairwise((END, *sentence, END)))))
