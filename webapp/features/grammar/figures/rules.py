"""The rules of a grammar as people read them: what a routine may be, and the phrases it is made of."""

from __future__ import annotations

import io
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from core.spreadsheets import SheetWriter

if TYPE_CHECKING:
    from core.grammar.rules import Rule


def phrase_names(ways: Iterable[Rule], start: str) -> dict[str, str]:
    """What people read for each phrase: the start is a routine, the others are numbered by how often they are used."""
    counts: dict[str, int] = {}
    for way in ways:
        counts[way.left] = counts.get(way.left, 0) + way.count
        for symbol in way.right:
            if isinstance(symbol, str):
                counts.setdefault(symbol, 0)
    others = sorted((symbol for symbol in counts if symbol != start), key=lambda s: (-counts[s], _natural(s)))
    return {start: "Routine"} | {symbol: f"Phrase {number}" for number, symbol in enumerate(others, 1)}


def rules_data(ways: Sequence[Rule], start: str) -> list[dict[str, Any]]:
    """An entry for each phrase, the routine first, then the most used; see ``names.Phrase``.

    parts: actions as numbers, phrases as their ids; ways by how often they are taken. cyclic: the phrase can occur
    inside itself.
    """
    names = phrase_names(ways, start)
    inside = _reachable(ways)
    found = []
    for symbol, name in names.items():
        alternatives = sorted((way for way in ways if way.left == symbol), key=lambda way: (-way.count, str(way.right)))
        found.append(
            {
                "id": symbol,
                "name": name,
                "seen": sum(way.count for way in alternatives),
                "cyclic": symbol in inside.get(symbol, ()),
                "ways": [{"parts": list(way.right), "count": way.count} for way in alternatives],
            }
        )
    return found


def rules_csv(ways: Sequence[Rule], start: str, actions: Mapping[int, str]) -> str:
    """A line for each rule: the phrase, what may stand for it, and how often it does. actions: names by number."""
    names = phrase_names(ways, start)
    text = io.StringIO()
    lines = SheetWriter(text)
    lines.writerow(["phrase", "symbol", "may be", "symbols", "times"])
    for way in sorted(ways, key=lambda way: (list(names).index(way.left), -way.count)):
        words = ", ".join(names[part] if isinstance(part, str) else actions.get(part, str(part)) for part in way.right)
        lines.writerow([names[way.left], way.left, words or "nothing", " ".join(map(str, way.right)), way.count])
    return text.getvalue()


def _reachable(ways: Sequence[Rule]) -> dict[str, set[str]]:
    """Phrases that can occur somewhere inside each phrase."""
    direct: dict[str, set[str]] = {}
    for way in ways:
        direct.setdefault(way.left, set()).update(part for part in way.right if isinstance(part, str))
    found = {left: set(parts) for left, parts in direct.items()}
    changed = True
    while changed:
        changed = False
        for parts in found.values():
            more = set().union(*(found.get(part, set()) for part in parts)) - parts
            if more:
                parts |= more
                changed = True
    return found


def _natural(symbol: str) -> tuple[Any, ...]:
    """X2 before X10."""
    return tuple(int(part) if part.isdigit() else part for part in re.split(r"(\d+)", symbol))
