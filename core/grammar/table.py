"""Grammars for several numbers of terminals, one after another: Table 1 of SYN section 7."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any

from core.errors import ParameterError
from core.parameters import read_object
from core.progress import Report

MOST = 24
LARGEST = 500


@dataclass(frozen=True)
class TableParameters:
    """The numbers of terminals to try, and all other parameters of the grammar, in text, so that they can stand in a
    link and in the job table.

    counts: ``12,20,40``; base: the other parameters as a JSON object. Equal tables have equal texts. Raises
    ParameterError.
    """

    counts: str = field(default="8,12,20,30,40,60", metadata={"help": "Numbers of terminals, separated by commas."})
    base: str = field(default="{}", metadata={"help": "The other parameters of the grammar, as a JSON object."})

    def __post_init__(self) -> None:
        object.__setattr__(self, "counts", ",".join(map(str, self.numbers())))
        object.__setattr__(self, "base", json.dumps(self._base(), sort_keys=True))

    def numbers(self) -> tuple[int, ...]:
        """The numbers of terminals, ascending, each once. Raises ParameterError."""
        words = self.counts.replace(",", " ").split()
        for word in words:
            if not (word.isascii() and word.isdecimal()) or not 1 <= int(word) <= LARGEST:
                raise ParameterError(
                    f"{word[:20]!r} is no number of actions; expected whole numbers from 1 to {LARGEST}"
                )
        if not 1 <= len(set(words)) <= MOST:
            raise ParameterError(f"expected 1 to {MOST} numbers, separated by commas")
        return tuple(sorted(set(map(int, words))))

    def points(self) -> tuple[dict[str, Any], ...]:
        """The parameters of the grammar for every number, in ascending order."""
        return tuple({**self._base(), "n_terminals": number} for number in self.numbers())

    def _base(self) -> dict[str, Any]:
        return {name: value for name, value in read_object(self.base, "base").items() if name != "n_terminals"}


def part_report(report: Report, number: int, total: int) -> Report:
    """A report for one of several computations, ``number`` of ``total`` from 0: fractions go on through all."""

    def tell(stage: str, fraction: float) -> None:
        report(f"{stage} ({number + 1} of {total})", (number + fraction) / total)

    return tell
