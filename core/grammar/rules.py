"""Rules of context-free grammars, and which of them rewrite a symbol."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from core.grammar.trees import Symbol


@dataclass(frozen=True)
class Rule:
    """``left`` may be rewritten as ``right``; count: how often it is in the training trees."""

    left: str
    right: tuple[Symbol, ...]
    count: int = 1


def choices(rules: Sequence[Rule]) -> dict[str, tuple[int, ...]]:
    """Non-terminal -> indices of the rules that rewrite it, in the order in which left sides first come."""
    indices: dict[str, list[int]] = {}
    for k, rule in enumerate(rules):
        indices.setdefault(rule.left, []).append(k)
    return {left: tuple(numbers) for left, numbers in indices.items()}
