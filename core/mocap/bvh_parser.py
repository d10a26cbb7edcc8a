"""The text of a BVH file, checked: the joints of its hierarchy and the table of its motion, in the file's own units."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from core.mocap.bvh_hierarchy import CHANNELS, RawJoint, parse_hierarchy
from core.mocap.bvh_table import read_table
from core.mocap.errors import RecordingError
from core.mocap.reports import Finding
from core.mocap.text import line_at, number, quoted

__all__ = ["CHANNELS", "DEFAULT_FPS", "RawBvh", "RawJoint", "parse_bvh"]

DEFAULT_FPS = 30.0  # where a file says 0 and nobody else says anything
_SPACE = rb"(?:\s|\#[^\n]*\n|//[^\n]*\n)*"
_MOTION = re.compile(_SPACE + rb"MOTION\b", re.IGNORECASE)
_FIELDS = {
    "Frames:": re.compile(_SPACE + rb"Frames\s*[:=]?[ \t]*([^\s]*)", re.IGNORECASE),
    "Frame Time:": re.compile(_SPACE + rb"Frame[\s_]*Time\s*[:=]?[ \t]*([^\s]*)", re.IGNORECASE),
}
_WORD = re.compile(rb"\S")
_MOST_FRAMES = 2**53


@dataclass
class RawBvh:
    """Joints, parents first, in file order; values (n_frames, n_channels) float64, NaN in frames to be filled; seconds
    a frame; what was repaired."""

    joints: list[RawJoint]
    values: np.ndarray
    frame_time: float
    findings: list[Finding] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def parse_bvh(path: str | Path, data: bytes, fps: float | None = None) -> RawBvh:
    """Parse and check the bytes of a BVH file; ``fps`` stands in for the file's frame time.

    Raises RecordingError with the line of the first fault.
    """
    hierarchy = parse_hierarchy(path, data)
    findings: list[Finding] = []
    notes: list[str] = []
    at = hierarchy.end
    if at >= len(data):
        raise RecordingError(path, "a skeleton without motion: no line MOTION", "MOTION after the hierarchy")
    if motion := _MOTION.match(data, at):
        at = motion.end()
        if not _WORD.search(data, at):
            raise RecordingError(path, "a skeleton without motion: nothing after MOTION", "a line 'Frames:'")
    else:
        findings.append(Finding("head", f"the line MOTION is missing before line {line_at(data, at)}"))
    (frames, frames_at), (seconds, seconds_at), at = _head(path, data, at, fps)
    stated = _stated_frames(path, data, frames, frames_at)
    if hierarchy.n_columns == 0:
        raise RecordingError(path, "no joint has channels", "CHANNELS with motion")
    if not _WORD.search(data, at):
        raise RecordingError(
            path, "a skeleton without motion: no frames follow", "at least one", line_at(data, frames_at)
        )
    frame_time = 1 / fps if fps else _frame_time(path, data, seconds, seconds_at, findings)
    table = read_table(path, data, at, stated, hierarchy.n_columns, hierarchy.decimal_commas)
    if hierarchy.scaled:
        some = ", ".join(hierarchy.scaled[:3]) + (" ..." if len(hierarchy.scaled) > 3 else "")
        notes.append(f"scale channels of {some}: left out")
    return RawBvh(hierarchy.joints, table.values, frame_time, findings + table.findings, notes + table.notes)


def _head(path: str | Path, data: bytes, at: int, fps: float | None) -> tuple[tuple[str, int], tuple[str, int], int]:
    """What stands for frames and for seconds a frame, where, and the byte after both; they may come in any order."""
    found: dict[str, tuple[str, int]] = {}
    while len(found) < 2:
        for key, pattern in _FIELDS.items():
            if key not in found and (match := pattern.match(data, at)):
                found[key] = match.group(1).decode("latin-1"), match.start(1)
                at = match.end()
                break
        else:
            missing = next(key for key in _FIELDS if key not in found)
            if missing == "Frame Time:" and fps:
                found[missing] = "", at
                break
            text = data[at : at + 200].strip().split(b"\n")[0][:80].decode("latin-1")
            line = line_at(data, min(len(data), at + len(data[at : at + 200]) - len(data[at : at + 200].lstrip())))
            raise RecordingError(path, quoted(text) if text else "the file ends", f"a line '{missing}'", line)
    return found["Frames:"], found["Frame Time:"], at


def _stated_frames(path: str | Path, data: bytes, word: str, at: int) -> int:
    word = re.sub(r"[.,]0*$", "", word)
    if not (word.isascii() and word.isdigit()) or int(word[:30]) > _MOST_FRAMES:
        raise RecordingError(path, f"Frames: {quoted(word)}", "a whole number of at least 1", line_at(data, at))
    return int(word)


_SHORTEST, _LONGEST = 4.0, 100.0  # a Frame Time between these is milliseconds: nobody records a frame in four seconds


def _frame_time(path: str | Path, data: bytes, word: str, at: int, findings: list[Finding]) -> float:
    line = line_at(data, at)
    if re.fullmatch(r"[0-9]*,[0-9]+", word):
        word = word.replace(",", ".")
    seconds = number(path, word, line, "the seconds from frame to frame")
    if seconds == 0:
        words = f"Frame Time is 0: taken as {DEFAULT_FPS:g} frames per second; say the rate if it is another"
        findings.append(Finding("rate", words))
        return 1 / DEFAULT_FPS
    if _SHORTEST <= seconds <= _LONGEST:
        words = f"Frame Time is {seconds:g}: taken as milliseconds, {1000 / seconds:.4g} frames per second"
        findings.append(Finding("rate", f"{words}; say the rate if it is another"))
        return seconds / 1000
    if not 1e-6 <= seconds <= 3600:
        raise RecordingError(path, f"Frame Time: {quoted(word)}", "a positive number of seconds", line)
    return seconds
