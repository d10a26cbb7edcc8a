"""Who is compared with whom: groups, and the subjects in them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from core.errors import AnalysisError, ParameterError
from core.mocap.properties import Properties

SUBJECT_NAMES = ("subject", "performer", "person", "participant", "actor", "player", "patient")
MOST_GROUPS = 12
FEWEST = 2  # subjects of a group
_FEW = 6  # names in a message
Paired = Literal["auto", "yes", "no"]


@dataclass(frozen=True)
class Unit:
    """What is counted once: the clips of one subject in one group, or one clip where no subjects are known."""

    name: str
    group: str
    clips: tuple[str, ...]


@dataclass(frozen=True)
class Design:
    """A comparison. column: the property that makes the groups; groups: its values that are compared.

    subject: the property that names who moves; "" where only clips are known, and then each clip is a unit.
    paired: every subject is in every group, and is compared with itself. remarks: what was left out, in sentences.
    """

    column: str
    groups: tuple[str, ...]
    units: tuple[Unit, ...]
    subject: str = ""
    paired: bool = False
    remarks: tuple[str, ...] = ()

    @property
    def unit(self) -> str:
        """What a unit is called: subject or clip."""
        return "subject" if self.subject else "clip"

    @property
    def codes(self) -> np.ndarray:
        """Number of the group of each unit, ``(n_units,)``."""
        return np.array([self.groups.index(unit.group) for unit in self.units])

    @property
    def blocks(self) -> np.ndarray:
        """Number of the subject of each unit, ``(n_units,)``: labels are permuted within a block where paired."""
        names = {name: k for k, name in enumerate(dict.fromkeys(unit.name for unit in self.units))}
        return np.array([names[unit.name] for unit in self.units])

    def pair(self, a: str, b: str) -> Design:
        """The same comparison with two of its groups alone."""
        units = tuple(unit for group in (a, b) for unit in self.units if unit.group == group)
        return Design(self.column, (a, b), units, self.subject, self.paired, self.remarks)


def make_design(
    properties: Properties,
    clips: Sequence[str],
    by: str,
    *,
    subject: str | None = None,
    groups: Sequence[str] = (),
    paired: Paired = "auto",
) -> Design:
    """The comparison of the clips by the property ``by``.

    subject: the property that names who moves; None looks for one that is called so (:data:`SUBJECT_NAMES`), "" takes
    clips. groups: the values to compare, all where empty. paired: "auto" pairs where a subject is in several groups.
    Raises ParameterError for a property or group that is not there, AnalysisError where groups or subjects are too few.
    """
    known = properties.of_clips(clips)
    values, remarks = known.column(by), []
    chosen = _chosen(by, known.groups(by), groups)
    if missing := [clip for clip in clips if clip not in values]:
        remarks.append(f"{len(missing)} of {len(clips)} clips have no {by} and are left out ({_few(missing)}).")
    name = _subject_column(known, by) if subject is None else subject
    who = known.column(name) if name else {}
    if name and (unnamed := [clip for clip in values if clip not in who and values[clip] in chosen]):
        remarks.append(f"{len(unnamed)} clips have no {name} and are left out ({_few(unnamed)}).")
    if not name:
        remarks.append(
            "Who moves in which clip is not known, so clips are compared. Clips of one person are alike: what is found "
            "holds for these recordings, and may not hold for other people. Name a property of clips “subject”."
        )
    by_unit: dict[tuple[str, str], list[str]] = {}
    for clip in clips:
        if values.get(clip) in chosen and (not name or clip in who):
            by_unit.setdefault((values[clip], who[clip] if name else clip), []).append(clip)
    units = [Unit(one, group, tuple(own)) for (group, one), own in by_unit.items()]
    units, is_paired = _paired(units, chosen, paired, name, remarks)
    kept = _large_enough(by, name, units, chosen, bool(groups), remarks)
    order = {group: k for k, group in enumerate(kept)}
    units = sorted((unit for unit in units if unit.group in order), key=lambda unit: (order[unit.group], unit.name))
    return Design(by, kept, tuple(units), name, is_paired, tuple(remarks))


def _chosen(by: str, known: dict[str, tuple[str, ...]], groups: Sequence[str]) -> tuple[str, ...]:
    if unknown := [group for group in groups if group not in known]:
        raise ParameterError(f"No clip has the {by} {unknown[0]!r}; there are: {_few(list(known))}.")
    if len(set(groups)) == 1:
        raise ParameterError(f"One group alone ({groups[0]}) cannot be compared; name two or more.")
    if groups:
        return tuple(dict.fromkeys(groups))
    if len(known) < 2:
        one = f"all {len(next(iter(known.values())))} clips that have one have {next(iter(known))}" if known else "none"
        raise AnalysisError(f"There are no two groups by “{by}” to compare: {one}.")
    if len(known) > MOST_GROUPS:
        largest = sorted(known, key=lambda value: -len(known[value]))
        raise AnalysisError(
            f"“{by}” has {len(known)} values, and at most {MOST_GROUPS} groups are compared at once. Name those that "
            f"matter, for example {largest[0]} and {largest[1]}."
        )
    return tuple(known)


def _subject_column(known: Properties, by: str) -> str:
    names = {name.lower(): name for name in known.columns}
    return next((names[name] for name in SUBJECT_NAMES if name in names and names[name] != by), "")


def _paired(
    units: list[Unit], groups: Sequence[str], paired: Paired, name: str, remarks: list[str]
) -> tuple[list[Unit], bool]:
    """The units, and whether subjects are compared with themselves; those that are not in all groups are left out."""
    where: dict[str, set[str]] = {}
    for unit in units:
        where.setdefault(unit.name, set()).add(unit.group)
    several = [one for one, own in where.items() if len(own) > 1]
    complete = {one for one, own in where.items() if len(own) == len(groups)}
    if paired == "no" or (paired == "auto" and not several):
        if several:
            remarks.append(
                f"{len(several)} subjects are in several groups ({_few(several)}) and are treated as different people: "
                "p-values are then too large or too small. Leave “paired” to be found."
            )
        return units, False
    if len(complete) < FEWEST:
        raise AnalysisError(
            f"Only {len(complete)} of {len(where)} {name or 'clip'}s are in all {len(groups)} groups, so they cannot "
            "be compared with themselves. Choose two groups, or say that the comparison is not paired."
        )
    if left := sorted(set(where) - complete):
        remarks.append(f"{len(left)} of {len(where)} subjects are not in all groups and are left out ({_few(left)}).")
    return [unit for unit in units if unit.name in complete], True


def _large_enough(
    by: str, name: str, units: Sequence[Unit], groups: Sequence[str], asked: bool, remarks: list[str]
) -> tuple[str, ...]:
    counts = {group: sum(unit.group == group for unit in units) for group in groups}
    small = [group for group in groups if counts[group] < FEWEST]
    kept = tuple(group for group in groups if group not in small)
    if len(kept) < 2 or (asked and small):
        said = ", ".join(f"{group} {count}" for group, count in counts.items())
        raise AnalysisError(
            f"Groups need {FEWEST} {name or 'clip'}s at least, to be told apart; by “{by}” there are: {said}."
        )
    if small:
        remarks.append(f"Groups with fewer than {FEWEST} {name or 'clip'}s are left out: {_few(small)}.")
    return kept


def _few(items: Iterable[str]) -> str:
    items = list(items)
    return ", ".join(items[:_FEW]) + (" ..." if len(items) > _FEW else "")
