"""The table of numbers of a BVH file: in one pass where all is well, with repairs where a few rows are damaged."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.mocap import numbers
from core.mocap.errors import RecordingError
from core.mocap.number_words import is_numeric, numbers_in
from core.mocap.reports import Finding
from core.mocap.text import LARGEST, line_at, quoted, token_at

MOST_FILLED = 0.2  # share of a recording's frames that may be filled from their neighbours
_PATIENCE = 20  # damaged rows before the share is looked at
_LARGE = 1 << 26  # bytes: words of a damaged stream are repaired one by one only below it


class _Fault(NamedTuple):
    """A damaged row: its line, how many numbers it has, and the word that is none where that is what is wrong."""

    line: int
    numbers: int
    word: str = ""

    def words(self, width: int) -> str:
        return f"{quoted(self.word)} instead of a number" if self.word else f"{self.numbers} numbers instead of {width}"


@dataclass
class Table:
    """values: ``(n_frames, n_channels)`` float64, NaN in every column of frames that are to be filled."""

    values: np.ndarray
    findings: list[Finding] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    @property
    def lost(self) -> np.ndarray:
        """Frames that have no values of their own, ``(n_frames,)`` bool."""
        lost: np.ndarray = np.isnan(self.values).any(axis=1)
        return lost


def read_table(
    path: str | Path, data: bytes, start: int, stated: int, n_channels: int, decimal_commas: bool = False
) -> Table:
    """The frames from byte ``start`` of ``data``; ``stated``: how many there are, as the file says.

    One row a frame, or the numbers of all frames one after another. Rows that cannot be read are marked by NaN, up to
    MOST_FILLED of them. Raises RecordingError where too much is damaged, or there is no frame at all.
    """
    # The announced count is not believed before the file is long enough to hold it.
    room = min(stated, (len(data) - start) // (2 * n_channels) + 1)
    out = np.empty((room, n_channels))
    found, status, _, _ = numbers.scan_rows(np.frombuffer(data, np.uint8), start, out, LARGEST)
    if status == numbers.OK and found == stated:
        return Table(out)
    return _Repair(path, data, start, stated, n_channels, decimal_commas).table()


class _Repair:
    """Reads what the plain pass refused, and says what was wrong with it."""

    def __init__(self, path: str | Path, data: bytes, start: int, stated: int, width: int, decimal_commas: bool):
        self.path, self.data, self.start, self.stated, self.width = path, data, start, stated, width
        self.findings: list[Finding] = []
        self.notes: list[str] = []
        self.trailing: int | None = None  # line of the first text after the frames
        self.faults: dict[int, _Fault] = {}  # by row
        self.glued: list[int] = []
        self.no_rows = 0  # damaged rows that have more or fewer numbers than a frame
        self.counted = (0, 1)  # a place in the data, and the number of the line it is in
        self.replace_commas(decimal_commas)

    def error(self, found: str, expected: str, line: int) -> RecordingError:
        """An error that names the file and the line."""
        return RecordingError(self.path, found, expected, line)

    def line_number(self, at: int) -> int:
        """The number of the line that holds byte ``at``; counted from where it was asked for last."""
        before, number = self.counted
        self.counted = (at, number + self.data.count(b"\n", before, at))
        return self.counted[1]

    def replace_commas(self, decimal: bool) -> None:
        """Numbers with decimal commas become numbers with points; commas and semicolons between numbers, spaces.

        Raises RecordingError where a comma may mean either.
        """
        if self.data.count(b";", self.start) > self.data.count(b"\n", self.start):
            self.notes.append("semicolons between the numbers: read as spaces")
            self.data = self.data[: self.start] + self.data[self.start :].replace(b";", b" ")
        at = self.data.find(b",", self.start)
        if at < 0:
            return
        head, tail = self.data[: self.start], self.data[self.start :]
        if b"." not in tail and (decimal or b", " not in tail):
            self.notes.append("decimal commas: read as decimal points")
            self.data = head + tail.replace(b",", b".")
        elif not decimal and tail.count(b",") >= tail.count(b"\n"):
            self.notes.append("commas between the numbers: read as spaces")
            self.data = head + tail.replace(b",", b" ")
        else:
            line = line_at(self.data, at)
            raise self.error(f"{token_at(self.data, at - 1)} with a decimal comma", "decimal points, or commas", line)

    def table(self) -> Table:
        """The frames with what was found. Raises RecordingError where too much is damaged, or there is none."""
        rows = self.rows()
        values = self.stream() if rows is None else rows
        n = len(values)
        if n == 0:
            raise RecordingError(self.path, "no frames follow: a skeleton without motion", "at least one frame")
        if n != self.stated:
            words = f"{n} frame{'s' * (n > 1)} where the line 'Frames:' says {self.stated}: all that are there are read"
            self.findings.append(Finding("frames", words))
        if self.trailing is not None:
            self.findings.append(Finding("text", f"text after the frames, in line {self.trailing}: left out"))
        return Table(values, self.findings, self.notes)

    def rows(self) -> np.ndarray | None:
        """One row a line; None where the lines are no rows."""
        raw = np.frombuffer(self.data, np.uint8)
        room = min(self.data.count(b"\n", self.start) + 1, (len(self.data) - self.start) // 2 + 1)
        if room > (len(self.data) - self.start) // self.width + 1:  # most lines are too short for a row
            return None
        out = np.empty((room, self.width))
        row, at, status = 0, self.start, numbers.ROW_WIDTH
        while True:
            found, status, offset, _ = numbers.scan_rows(raw, at, out[row:], LARGEST)
            row += found
            if status == numbers.OK:
                break
            begin = self.data.rfind(b"\n", 0, offset) + 1
            at = self.data.find(b"\n", offset) + 1 or len(self.data)
            row += self.line(self.data[max(begin, self.start) : at], max(begin, self.start), row, out)
            if self.no_rows > _PATIENCE + MOST_FILLED * row:
                return None
            if len(self.faults) > _PATIENCE + MOST_FILLED * room:
                raise self.too_many(f"more than {MOST_FILLED:.0%} of the frames")
        return self.kept(out[:row])

    def line(self, text: bytes, begin: int, row: int, out: np.ndarray) -> int:
        """Puts a line that is no plain row into ``out[row]``; 1 where it is a frame, 0 where it is something else."""
        words = text.decode("latin-1").split()
        if words[0].startswith(("#", "//")):
            return 0
        number = self.line_number(begin)
        if self.trailing is not None:
            if not is_numeric(words[0]):
                return 0
            raise self.error("frames after a line of text", "the end of the file", self.trailing)
        parts = [numbers_in(word) for word in words]
        bad = next((k for k, part in enumerate(parts) if part is None), None)
        if bad is not None:
            if bad == 0 and not is_numeric(words[0]):
                self.trailing = number
                return 0
            raise self.error(quoted(words[bad]), "a finite decimal number", number)
        values = [value for part in parts for value in part or ()]
        if any(abs(value) > LARGEST for value in values):
            large = next(word for word, part in zip(words, parts, strict=True) if max(map(abs, part or ())) > LARGEST)
            raise self.error(f"{quoted(large)} is out of range", "a finite decimal number", number)
        if len(values) == self.width and not np.isnan(values).any():
            out[row] = values
            self.glued.append(row)
            return 1
        lost = (word for word, part in zip(words, parts, strict=True) if np.isnan(part or ()).any())
        self.faults[row] = _Fault(number, len(values), next(lost, "") if len(values) == self.width else "")
        out[row] = np.nan
        self.no_rows += len(values) != self.width
        return 1

    def kept(self, values: np.ndarray) -> np.ndarray | None:
        """The rows without one that was cut off at the end; None where too many are damaged to be rows."""
        n = len(values)
        last = self.faults.get(n - 1)
        if n > 1 and last and last.numbers < self.width:
            del self.faults[n - 1]
            self.no_rows -= 1
            words = f"the last frame is cut off ({last.words(self.width)}, line {last.line}): left out"
            self.findings.append(Finding("cut", words))
            values, n = values[:-1], n - 1
        if self.no_rows > MOST_FILLED * n:
            return None
        if len(self.faults) > MOST_FILLED * n:
            raise self.too_many(f"{len(self.faults)} of {n} frames")
        for first, end in _runs(sorted(self.faults)):
            fault = self.faults[first]
            why = f"{fault.words(self.width)} in line {fault.line}"
            self.findings.append(
                Finding("filled", f"{_frames(first, end)} filled from the frames around: {why}", first, end)
            )
        if self.glued:
            more = f" and {len(self.glued) - 1} more" if len(self.glued) > 1 else ""
            words = f"numbers without a space between them in frame {self.glued[0]}{more}: read as two"
            self.findings.append(Finding("glued", words, self.glued[0], self.glued[-1] + 1))
        return values

    def too_many(self, which: str) -> RecordingError:
        """The error that says which share of the frames is damaged, and how the first of them is."""
        row, fault = next(iter(self.faults.items()))
        found = f"{which} are damaged, the first is frame {row}: {fault.words(self.width)}"
        return self.error(found, f"at most {MOST_FILLED:.0%} of them, which can be filled", fault.line)

    def stream(self) -> np.ndarray:
        """All numbers one after another, whatever the lines; a frame that is not whole at the end is left out."""
        self.findings, self.glued = [], []
        lines = [len(text.split()) for text in self.data[self.start : self.start + _LARGE].split(b"\n")]
        widths = {count for count in lines if count}
        fault = next(iter(self.faults.values()), _Fault(line_at(self.data, self.start), 0))
        width = next(iter(widths), 0)
        even = len(widths) == 1 and sum(map(bool, lines)) > 1 and sum(lines) != self.stated * self.width
        if even and width % self.width and self.width % width:
            raise self.error(f"a frame of {width} numbers", f"{self.width}, one for each channel", fault.line)
        values = self.all_numbers()
        n, rest = divmod(len(values), self.width)
        damaged_rows = n > 1 and sum(map(bool, lines)) == n
        if n == 0 or damaged_rows or (rest and n + 1 != self.stated):
            found = f"a frame of {fault.numbers or len(values)} numbers"
            raise self.error(found, f"{self.width}, one for each channel", fault.line)
        if rest:
            words = f"the last frame is cut off ({rest} numbers instead of {self.width}): left out"
            self.findings.append(Finding("cut", words))
        table: np.ndarray = values[: n * self.width].reshape(n, self.width)
        lost = np.flatnonzero(np.isnan(table).any(axis=1))
        if len(lost) > MOST_FILLED * n:
            raise self.error(f"{len(lost)} of {n} frames have values that are no numbers", "fewer", fault.line)
        for first, end in _runs(lost.tolist()):
            words = f"{_frames(first, end)} filled from the frames around: values that are no numbers"
            self.findings.append(Finding("filled", words, first, end))
        table[lost] = np.nan
        return table

    def all_numbers(self) -> np.ndarray:
        """All numbers behind ``start``, ``(n,)``. Raises RecordingError for a word that is none."""
        text = self.data[self.start :].replace(b"\n", b" ")
        raw = np.frombuffer(text, np.uint8)
        _, status, offset, count = numbers.scan_rows(raw, 0, np.empty((1, 0)), LARGEST)
        if status == numbers.ROW_WIDTH:
            out = np.empty((1, count))
            numbers.scan_rows(raw, 0, out, LARGEST)
            return out.ravel()
        if len(text) > _LARGE:
            raise self.error(token_at(text, offset), "a finite decimal number", line_at(self.data, self.start + offset))
        values: list[float] = []
        for match_at, word in _words(text):
            part = numbers_in(word)
            if part is None or any(abs(value) > LARGEST for value in part):
                raise self.error(quoted(word), "a finite decimal number", line_at(self.data, self.start + match_at))
            values += part
        return np.array(values)


def _words(text: bytes) -> Iterator[tuple[int, str]]:
    at = 0
    for word in text.split():
        at = text.index(word, at)
        yield at, word.decode("latin-1")
        at += len(word)


def _frames(first: int, end: int) -> str:
    return f"frame {first} is" if end == first + 1 else f"frames {first} to {end - 1} are"


def _runs(frames: list[int]) -> Iterator[tuple[int, int]]:
    """First frame and end of each run of ascending numbers that follow one another."""
    breaks = [k for k in range(len(frames)) if k == 0 or frames[k] != frames[k - 1] + 1]
    for k, start in enumerate(breaks):
        last = (breaks[k + 1] if k + 1 < len(breaks) else len(frames)) - 1
        yield frames[start], frames[last] + 1
