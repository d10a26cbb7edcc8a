"""A comparison in sentences: what differs, by how much, and that nothing else does beyond chance."""

from __future__ import annotations

from itertools import combinations
from typing import NamedTuple

from core.groups.comparison import Comparison, GroupComparison

MOST = 8  # sentences for two groups
# Name of a figure -> what more and less of it is called
_WAYS = {
    "Walking speed": ("walks {d} faster", "walks {d} slower"),
    "Step length": ("takes steps {d} longer", "takes steps {d} shorter"),
    "Step time": ("takes {d} longer for a step", "takes {d} less for a step"),
    "Cadence": ("takes {d} more", "takes {d} fewer"),
    "Step time varies by": ("steps less evenly (by {d})", "steps more evenly (by {d})"),
    "Share of time walking or running": (
        "walks or runs more ({d} of the time)",
        "walks or runs less ({d} of the time)",
    ),
    "Travel": ("gets {d} faster from place to place", "gets {d} slower from place to place"),
    "Turning": ("turns more ({d})", "turns less ({d})"),
    "Height of the pelvis": ("carries the pelvis higher ({d})", "carries the pelvis lower ({d})"),
    "Height of the head": ("holds the head higher ({d})", "holds the head lower ({d})"),
    "Lean of the trunk": ("leans {d} further from upright", "stands {d} more upright"),
    "Bend of the neck": ("bends the neck {d} more", "bends the neck {d} less"),
    "Left arm away from the trunk": ("holds the left arm {d} wider", "holds the left arm {d} closer"),
    "Right arm away from the trunk": ("holds the right arm {d} wider", "holds the right arm {d} closer"),
    "Elbows bent": ("bends the elbows {d} more", "bends the elbows {d} less"),
    "Knees bent": ("bends the knees {d} more", "bends the knees {d} less"),
    "Speed of the hands": ("moves the hands {d} faster", "moves the hands {d} slower"),
    "Speed of the feet": ("moves the feet {d} faster", "moves the feet {d} slower"),
}


class Sentence(NamedTuple):
    """A sentence, and the row that it speaks of; None where it speaks of all."""

    text: str
    row: Comparison | None = None


def sentences(found: GroupComparison) -> tuple[Sentence, ...]:
    """The answer in words, the largest effects first, for every pair of groups."""
    said: list[Sentence] = []
    unit = found.design.unit
    if found.least_p > found.parameters.alpha:
        said.append(
            Sentence(
                f"So few {unit}s cannot show a difference: the smallest p-value they can give is {found.least_p:.2g}, "
                f"above {found.parameters.alpha:g}. Four {unit}s in each group are the least."
            )
        )
    for a, b in combinations(found.design.groups, 2):
        said += _of_pair(found, a, b)
    return tuple(said)


def _of_pair(found: GroupComparison, a: str, b: str) -> list[Sentence]:
    rows = [row for row in found.rows if row.groups == (a, b)]
    hits = [row for row in found.found() if row.groups == (a, b)]
    shown: list[Comparison] = []
    for row in hits:  # of what happens more often and longer, the larger effect speaks for both
        same = [one for one in shown if (one.kind, one.id) == (row.kind, row.id)]
        if not same and len(shown) < MOST:
            shown.append(row)
    said = [Sentence(f"{_capital(b)} {words_of(row)}.", row) for row in shown]
    tested = sum(row.p == row.p for row in rows)
    if not hits:
        said.append(
            Sentence(
                f"{_capital(a)} and {b} do not differ beyond chance in any of {tested} figures that were compared."
            )
        )
        least = found.least_p
        if least <= found.parameters.alpha < least * tested:
            said.append(
                Sentence(
                    f"With so few {found.design.unit}s a single difference among so many figures cannot be told from "
                    f"chance: the smallest p-value is {least:.2g} before the correction."
                )
            )
        return said
    left = len({(row.kind, row.id) for row in hits}) - len(shown)
    rest = f"{left} more things differ; " if left else ""
    said.append(
        Sentence(
            f"{_capital(rest)}{tested - len(hits)} of {tested} figures do not differ beyond chance between {a} and {b}."
        )
    )
    return said


def words_of(row: Comparison) -> str:
    """What the second group does, compared with the first, without a full stop."""
    first, second = row.means
    if row.kind == "figure":
        more, less = _WAYS.get(
            row.name, (f"has more {row.name.lower()} ({{d}})", f"has less {row.name.lower()} ({{d}})")
        )
        amount = f"{_number(abs(row.difference))} {row.unit}".replace(" °", "°")
        return f"{(more if row.difference > 0 else less).format(d=amount)}: {_number(second)} against {_number(first)}"
    if row.measure == "share":
        way = _ratio(first, second, "as much")
        return f"spends {way} time in {row.name}: {_number(second)} % against {_number(first)} %"
    if row.measure == "rate":
        way = _ratio(first, second, "as often")
        return f"does {row.name} {way}: {_number(second)} against {_number(first)} times a minute"
    if row.measure == "duration":
        way = "longer" if row.difference > 0 else "less"
        amount = f"{_number(abs(row.difference))} s {way}"
        return f"takes {amount} for {row.name}: {_number(second)} s against {_number(first)} s"
    way = "more" if row.difference > 0 else "less"
    return f"goes {way} often from {row.name}: {100 * second:.0f} % against {100 * first:.0f} %"


def _ratio(first: float, second: float, as_much: str) -> str:
    """How much more or less the second is: “2.3 times as much”, or “more” where that says little."""
    low, high = sorted((first, second))
    if low <= 0 or high / low > 20:
        often = " often" if "often" in as_much else ""
        return f"more{often}" if second > first else f"less{often}"
    return f"{second / first:.1f} times {as_much}" if high / low >= 1.5 else f"{second / first:.2f} times {as_much}"


def _number(value: float) -> str:
    return f"{value:.0f}" if abs(value) >= 100 else f"{value:.1f}" if abs(value) >= 10 else f"{value:.2f}"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
