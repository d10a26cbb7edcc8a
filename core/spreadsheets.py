"""CSV that people open in a spreadsheet: no cell is taken for a formula."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable
from typing import TextIO

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


class SheetWriter:
    """Writes rows of CSV to a text file. Text that a spreadsheet would compute gets an apostrophe before it."""

    def __init__(self, file: TextIO) -> None:
        self._rows = csv.writer(file, lineterminator="\n")

    def writerow(self, row: Iterable[object]) -> None:
        """Writes one row."""
        self._rows.writerow([guarded(cell) for cell in row])

    def writerows(self, rows: Iterable[Iterable[object]]) -> None:
        """Writes rows."""
        for row in rows:
            self.writerow(row)


def guarded(cell: object) -> object:
    """The cell; text that begins like a formula, and is no number, behind an apostrophe."""
    if not isinstance(cell, str) or not cell.startswith(_FORMULA) or _NUMBER.fullmatch(cell):
        return cell
    return f"'{cell}"


def unguarded(text: str) -> str:
    """The text of a cell that :func:`guarded` may have written."""
    return text[1:] if text[:1] == "'" and text[1:].startswith(_FORMULA) else text
