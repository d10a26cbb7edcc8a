"""The hidden grammar of the demo: what its routines are made of. It is the ground truth of tests.

A context-free grammar: left side -> alternatives, each a weight and a sequence of symbols. Symbols that are no left
side are actions, and are the labels of the recordings.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np

START = "routine"
GRAMMAR: dict[str, tuple[tuple[float, tuple[str, ...]], ...]] = {
    "routine": (
        (4, ("idle", "arrival", "parts", "idle")),
        (1, ("idle", "parts", "arrival", "idle")),
    ),
    "parts": ((3, ("part", "link", "part")), (2, ("part", "link", "parts"))),
    "link": ((3, ("idle",)), (2, ("idle", "arrival", "idle"))),
    "arrival": ((3, ("walk",)), (2, ("walk", "run", "walk"))),
    "part": (
        (3, ("fight",)),
        (2, ("tumbling",)),
        (2, ("floor",)),
        (2, ("exercise",)),
        (2, ("dancing",)),
    ),
    "fight": (
        (2, ("combination",)),
        (2, ("combination", "combination")),
        (2, ("combination", "spin kick")),
    ),
    "combination": ((3, ("punch", "kick")), (2, ("punch", "punch", "kick"))),
    "tumbling": (
        (2, ("cartwheel", "idle", "backflip")),
        (2, ("roll", "idle", "cartwheel")),
        (1, ("cartwheel", "cartwheel")),
    ),
    "floor": ((2, ("lie down", "get up")), (1, ("lie down", "crawl", "get up"))),
    "exercise": ((2, ("squat", "idle", "jumps")), (1, ("jumps",))),
    "jumps": ((2, ("jump", "jump")), (1, ("jump", "jumps"))),
    "dancing": ((3, ("dance",)), (1, ("dance", "twirl"))),
}
ACTIONS: tuple[str, ...] = tuple(
    sorted({s for rules in GRAMMAR.values() for _, right in rules for s in right if s not in GRAMMAR})
)


def derive(rng: np.random.Generator, symbol: str = START) -> tuple[str, ...]:
    """A random sentence: the actions of one routine, in order."""
    if symbol not in GRAMMAR:
        return (symbol,)
    weights = np.array([weight for weight, _ in GRAMMAR[symbol]], float)
    _, right = GRAMMAR[symbol][int(rng.choice(len(weights), p=weights / weights.sum()))]
    return tuple(action for part in right for action in derive(rng, part))


def accepts(sentence: Sequence[str], symbol: str = START) -> bool:
    """Whether the grammar derives ``sentence`` from ``symbol``."""
    words = tuple(sentence)

    @cache
    def ends(left: str, start: int) -> frozenset[int]:
        """Where a phrase of kind ``left`` that begins at ``start`` may end."""
        if left not in GRAMMAR:
            return frozenset({start + 1} if start < len(words) and words[start] == left else ())
        reached: set[int] = set()
        for _, right in GRAMMAR[left]:
            at = {start}
            for part in right:
                at = {end for begin in at for end in ends(part, begin)}
            reached |= at
        return frozenset(reached)

    return len(words) in ends(symbol, 0)
