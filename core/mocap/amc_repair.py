"""Frames of an AMC file that the plain pass refused: bones missing or too many, a cut end, values that are none.

What is clear is read, and said; everything else is still an error that names its line.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from core.mocap.bvh_table import MOST_FILLED
from core.mocap.errors import RecordingError
from core.mocap.number_words import numbers_in
from core.mocap.reports import Finding
from core.mocap.text import LARGEST, decoded, line_at, quoted


@dataclass
class AmcTable:
    """values: ``(n_frames, n_values)`` float64; lost: frames to be filled from those around, ``(n_frames,)`` bool."""

    values: np.ndarray
    lost: np.ndarray
    findings: list[Finding] = field(default_factory=list)


@dataclass
class _Frame:
    line: int
    rows: dict[int, list[float]] = field(default_factory=dict)
    unknown: dict[str, int] = field(default_factory=dict)  # name -> line
    cut: bool = False


def repaired_frames(
    path: str | Path,
    data: bytes,
    start: int,
    bones: Sequence[str],
    first_value: np.ndarray,
    turns: Mapping[int, Sequence[int]],
    skeleton: str,
) -> AmcTable:
    """The frames from byte ``start`` of ``data``; ``first_value`` ``(n_bones + 1,)``: where the values of each begin.

    turns: number of a bone that may also shift or stretch -> which of its values are turns; others may be left out.
    A cut last frame is left out. A bone that a frame lacks keeps its values of the frame before; one that all frames
    lack stays at 0; one that is in all frames and not in the skeleton is left out. Raises RecordingError for the rest.
    """
    reader = _Reader(path, bones, first_value, skeleton)
    reader.turns = turns
    reader.read(data, start)
    return reader.table()


class _Reader:
    def __init__(self, path: str | Path, bones: Sequence[str], first_value: np.ndarray, skeleton: str):
        self.path, self.bones, self.first, self.skeleton = path, bones, first_value, skeleton
        self.widths = np.diff(first_value)
        small = {bone.lower(): k for k, bone in enumerate(bones)}
        self.index: Mapping[str, int] = small if len(small) == len(bones) else {b: k for k, b in enumerate(bones)}
        self.turns: Mapping[int, Sequence[int]] = {}
        self.frames: list[_Frame] = []
        self.findings: list[Finding] = []

    def error(self, found: str, expected: str, line: int) -> RecordingError:
        """An error that names the file and the line."""
        return RecordingError(self.path, found, expected, line)

    def read(self, data: bytes, start: int) -> None:
        """Collects the frames from byte ``start``. Raises RecordingError where there is none, or a line is none."""
        first_line, number = line_at(data, start), -1
        lines = decoded(data[start:]).rstrip().split("\n")
        for k, text in enumerate(lines):
            words, line = text.split("#", 1)[0].split(), first_line + k
            if not words:
                continue
            if words[0][0].isdigit() or words[0][0] in "+-":
                number = self.frame_number(words, line, number)
                self.frames.append(_Frame(line))
            elif not self.frames:
                raise self.error(quoted(words[0]), "a frame's number before its bones", line)
            else:
                self.row(self.frames[-1], words, line, last=k == len(lines) - 1)
        if not self.frames:
            raise RecordingError(self.path, "no frames", "a frame's number and its bones")

    def frame_number(self, words: list[str], line: int, before: int) -> int:
        """The number of a frame, one more than ``before``. Raises RecordingError where it is not."""
        found = numbers_in(words[0])
        value = found[0] if found and len(found) == 1 and len(words) == 1 else np.nan
        follows = value == before + 1 if before >= 0 else 0 <= value <= 2**53 and value == int(value)
        if not follows:
            after = f"the frame number {before + 1}" if before >= 0 else "a frame number"
            raise self.error(quoted(" ".join(words)), after, line)
        return int(value)

    def row(self, frame: _Frame, words: list[str], line: int, last: bool) -> None:
        """Puts the values of one bone into its frame; ``last``: of the file, which may be cut off there. Raises
        RecordingError for what is no number, too many or too few values, and a bone that comes twice.
        """
        name = words[0] if words[0] in self.index else words[0].lower()
        bone = self.index.get(name)
        parts = [numbers_in(word) for word in words[1:]]
        bad = next((word for word, part in zip(words[1:], parts, strict=True) if part is None), None)
        values = [value for part in parts for value in part or ()]
        if bone is not None and bone in self.turns and len(values) == len(self.turns[bone]):
            values = self.with_gaps(bone, values)
        if last and self.is_cut(words, bone, bad, len(values)):
            frame.cut = True
        elif bad is not None:
            raise self.error(quoted(bad), "a finite decimal number", line)
        elif any(abs(value) > LARGEST for value in values):
            large = next(
                word for word, part in zip(words[1:], parts, strict=True) if max(map(abs, part or ())) > LARGEST
            )
            raise self.error(f"{quoted(large)} is out of range", "a finite decimal number", line)
        elif bone is None:
            frame.unknown[words[0]] = line
        elif bone in frame.rows:
            raise self.error(f"the bone {quoted(words[0])} comes twice in a frame", "each bone once", line)
        elif len(values) != self.widths[bone]:
            found = f"{len(values)} values for {quoted(words[0])}"
            raise self.error(found, f"{self.widths[bone]}, as {self.skeleton} says", line)
        else:
            frame.rows[bone] = values

    def is_cut(self, words: list[str], bone: int | None, bad: str | None, n_values: int) -> bool:
        """Whether the last line of a file looks as if more had followed."""
        if bone is None:
            begun = any(name.startswith(words[0].lower()) for name in self.index)
            return begun and len(words) == 1
        return n_values < self.widths[bone] and (bad is None or bad == words[-1])

    def with_gaps(self, bone: int, values: list[float]) -> list[float]:
        """Values of a bone whose row leaves out those that are no turn (dof l), 0 in their places."""
        row = [0.0] * int(self.widths[bone])
        for place, value in zip(self.turns[bone], values, strict=True):
            row[place] = value
        return row

    def table(self) -> AmcTable:
        """All frames, mended, with what was found. Raises RecordingError where too much is missing."""
        self.leave_out_cut_frame()
        self.leave_out_unknown()
        values = np.zeros((len(self.frames), int(self.first[-1])))
        for k, frame in enumerate(self.frames):
            for bone, row in frame.rows.items():
                values[k, self.first[bone] : self.first[bone + 1]] = row
        self.hold_missing(values)
        return AmcTable(values, self.lost_frames(values), self.findings)

    def leave_out_cut_frame(self) -> None:
        """Drops the last frame where the file is cut off in it."""
        if len(self.frames) < 2:
            return
        last, before = self.frames[-1], self.frames[-2]
        order = list(before.rows)
        ends_early = len(last.rows) < len(order) and order[: len(last.rows)] == list(last.rows)
        if last.cut or (not last.unknown and ends_early):
            self.frames.pop()
            words = f"the file is cut off in frame {len(self.frames)} (line {last.line}): that frame is left out"
            self.findings.append(Finding("cut", words))

    def leave_out_unknown(self) -> None:
        """Says which bones the skeleton does not have. Raises RecordingError where some frames have them and others
        not.
        """
        always = set.intersection(*(set(frame.unknown) for frame in self.frames))
        for frame in self.frames:
            for name, line in frame.unknown.items():
                if name not in always:
                    found = f"the bone {quoted(name)} is not in {self.skeleton}"
                    raise self.error(found, "bones of this skeleton", line)
        if always:
            names = ", ".join(quoted(name) for name in sorted(always)[:5])
            words = f"{names}: not in {self.skeleton}, so left out; the skeleton may be another person's"
            self.findings.append(Finding("extra", words))

    def hold_missing(self, values: np.ndarray) -> None:
        """Bones without a row keep what they had; which, and when, is said."""
        n = len(self.frames)
        given = set().union(*(frame.rows for frame in self.frames))
        moving = {int(bone) for bone in np.flatnonzero(self.widths)}
        if (missing := sorted(moving - given)) and (0 in missing or n == 1 or len(missing) > len(moving) / 2):
            found = f"no frame has the bone {quoted(self.bones[missing[0]])}"
            raise self.error(found, f"most bones of {self.skeleton}, in every frame", self.frames[0].line)
        for bone, name in enumerate(self.bones):
            there = np.array([bone in frame.rows for frame in self.frames])
            if self.widths[bone] == 0 or there.all():
                continue
            gaps = np.flatnonzero(~there)
            first = int(gaps[0])
            if len(gaps) == n:
                self.findings.append(Finding("missing", f"no frame has the bone {quoted(name)}: it stays unturned"))
                continue
            if len(gaps) > MOST_FILLED * n:
                found = f"frame {first} ends without the bone {quoted(name)}, as {len(gaps)} of {n} frames do"
                expected = f"every bone of {self.skeleton} that moves, in {1 - MOST_FILLED:.0%} of the frames"
                raise self.error(found, expected, self.frames[first].line)
            columns = slice(int(self.first[bone]), int(self.first[bone + 1]))
            source = np.maximum.accumulate(np.where(there, np.arange(n), -1))
            source[source < 0] = int(np.flatnonzero(there)[0])
            values[:, columns] = values[source, columns]
            more = f" and {len(gaps) - 1} more" if len(gaps) > 1 else ""
            words = f"frame {first}{more} has no {quoted(name)}: held from the frame before"
            self.findings.append(Finding("filled", words, first, int(gaps[-1]) + 1))

    def lost_frames(self, values: np.ndarray) -> np.ndarray:
        """The frames that have NaN, ``(n_frames,)`` bool. Raises RecordingError where they are too many to be
        filled.
        """
        lost: np.ndarray = np.isnan(values).any(axis=1)
        if lost.sum() > MOST_FILLED * len(lost):
            first = int(np.flatnonzero(lost)[0])
            found = (
                f"{lost.sum()} of {len(lost)} frames have values that are none (nan, inf), the first is frame {first}"
            )
            raise self.error(found, f"at most {MOST_FILLED:.0%} of them", self.frames[first].line)
        if lost.any():
            at = np.flatnonzero(lost)
            more = f" and {len(at) - 1} more are" if len(at) > 1 else " is"
            words = f"frame {at[0]}{more} filled from the frames around: values that are no numbers (nan, inf)"
            self.findings.append(Finding("filled", words, int(at[0]), int(at[-1]) + 1))
        return lost
