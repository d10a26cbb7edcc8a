"""The text of a BVH file, checked: the joints of its hierarchy and the table of its motion, in the file's own units."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from core.mocap import numbers
from core.mocap.errors import RecordingError
from core.mocap.text import LARGEST, decoded, joint_name, line_at, number, quoted, token_at

CHANNELS = tuple(f"{axis}{kind}" for kind in ("position", "rotation") for axis in "XYZ")
_SPELLING = {name.lower(): name for name in CHANNELS}


@dataclass
class RawJoint:
    """A joint as the file gives it: offset in file units, channels in file order, first column in the motion table."""

    name: str
    parent: int
    line: int
    end_site: bool = False
    offset: tuple[float, ...] | None = None
    channels: tuple[str, ...] = ()
    first_column: int = 0
    children: list[int] = field(default_factory=list)


@dataclass
class RawBvh:
    """Joints, parents first, in file order; values (n_frames, n_channels) float64; seconds a frame."""

    joints: list[RawJoint]
    values: np.ndarray
    frame_time: float


def parse_bvh(path: str | Path, data: bytes) -> RawBvh:
    """Parse and check the bytes of a BVH file. Raises RecordingError with the line of the first fault."""
    motion = _find_motion(path, data)
    joints = _Hierarchy(path).parse(decoded(data[:motion]))
    n_channels = sum(len(joint.channels) for joint in joints)
    n_frames, frame_time, start = _motion_head(path, data, motion)
    return RawBvh(joints, _motion_table(path, data, start, n_frames, n_channels), frame_time)


def _find_motion(path: str | Path, data: bytes) -> int:
    """Byte offset of the line MOTION."""
    upper = data if b"\nMOTION" in data else data.upper()
    at = upper.find(b"MOTION")
    while at >= 0:
        begin, end = data.rfind(b"\n", 0, at) + 1, data.find(b"\n", at)
        if data[begin : end if end >= 0 else len(data)].strip().upper() == b"MOTION":
            return begin
        at = upper.find(b"MOTION", at + 1)
    _Hierarchy(path).parse(decoded(data), complete=False)  # a fault there explains more than the missing keyword
    raise RecordingError(path, "no line MOTION", "MOTION after the hierarchy")


class _Hierarchy:
    """Reads HIERARCHY statement by statement; never recursive, so depth costs nothing."""

    def __init__(self, path: str | Path):
        self.path = path
        self.joints: list[RawJoint] = []
        self.open: list[int] = []  # joints whose braces are open, innermost last
        self.pending: int | None = None  # a joint that still waits for its opening brace
        self.columns = 0

    def error(self, found: str, expected: str, line: int | None = None) -> RecordingError:
        return RecordingError(self.path, found, expected, line)

    def parse(self, text: str, complete: bool = True) -> list[RawJoint]:
        statements = _statements(text)
        line, words = next(statements, (1, [""]))
        if words[0].upper() != "HIERARCHY":
            raise self.error(quoted(words[0]), "HIERARCHY, as every BVH file begins", line)
        for line, words in statements:
            self.statement(line, words, complete)
        if complete and (self.open or self.pending is not None or not self.joints):
            found = "the hierarchy ends inside " + quoted(self.joints[-1].name) if self.joints else "no ROOT joint"
            raise self.error(found, "a closing brace for every joint", line)
        return self.joints

    def statement(self, line: int, words: list[str], complete: bool) -> None:
        key = words[0].upper()
        if self.pending is not None and key != "{":
            raise self.error(quoted(words[0]), f"{{ after {quoted(self.joints[self.pending].name)}", line)
        if key == "{":
            if self.pending is None:
                raise self.error("{", "ROOT, JOINT or End Site before it", line)
            self.open.append(self.pending)
            self.pending = None
        elif key == "}":
            self.close(line)
        elif key in ("ROOT", "JOINT", "END"):
            self.begin(line, key, words[1:])
        elif key == "OFFSET":
            self.offset(line, words[1:])
        elif key == "CHANNELS":
            self.channels(line, words[1:])
        elif complete or self.open:
            raise self.error(quoted(words[0]), "ROOT, JOINT, End Site, OFFSET, CHANNELS or a brace", line)
        else:  # the search for a missing MOTION has come to what follows the hierarchy
            raise self.error(quoted(words[0]), "MOTION after the hierarchy", line)

    def close(self, line: int) -> None:
        if not self.open:
            raise self.error("}", "no more closing braces than opening ones", line)
        joint = self.joints[self.open.pop()]
        if joint.offset is None:
            raise self.error(f"{quoted(joint.name)} has no OFFSET", "an OFFSET for every joint", joint.line)

    def begin(self, line: int, key: str, words: list[str]) -> None:
        parent = self.open[-1] if self.open else -1
        if key == "ROOT" and self.joints:
            raise self.error("a second ROOT", "one skeleton in a file", line)
        if key != "ROOT" and parent < 0:
            raise self.error(quoted(key), "ROOT before it" if not self.joints else "MOTION", line)
        if parent >= 0 and self.joints[parent].end_site:
            raise self.error(f"a joint inside the End Site of {quoted(self.joints[parent].name)}", "none", line)
        if key == "END":
            if [w.upper() for w in words[:1]] != ["SITE"]:
                raise self.error(quoted(" ".join(["End", *words])), "End Site", line)
            joint = RawJoint(f"{self.joints[parent].name}_end", parent, line, end_site=True)
        else:
            joint = RawJoint(joint_name(self.path, words, line), parent, line)
        self.pending = len(self.joints)
        if parent >= 0:
            self.joints[parent].children.append(self.pending)
        self.joints.append(joint)

    def current(self, line: int, key: str) -> RawJoint:
        if not self.open:
            raise self.error(f"{key} outside of a joint", "a joint around it", line)
        return self.joints[self.open[-1]]

    def offset(self, line: int, words: list[str]) -> None:
        joint = self.current(line, "OFFSET")
        if len(words) != 3 or joint.offset is not None:
            found = f"OFFSET with {len(words)} numbers" if joint.offset is None else "a second OFFSET"
            raise self.error(found, "one OFFSET of 3 numbers a joint", line)
        joint.offset = tuple(number(self.path, w, line, "a number for OFFSET") for w in words)

    def channels(self, line: int, words: list[str]) -> None:
        joint = self.current(line, "CHANNELS")
        count = int(words[0]) if words and words[0].isascii() and words[0].isdigit() and len(words[0]) < 10 else -1
        if joint.channels or joint.end_site:
            raise self.error(
                f"CHANNELS in {quoted(joint.name)}", "one line of CHANNELS a joint, none in End Site", line
            )
        if count != len(words) - 1:
            stated = quoted(words[0]) if words else "no count"
            raise self.error(f"CHANNELS says {stated} and names {max(len(words) - 1, 0)}", "as many as it says", line)
        for word in words[1:]:
            if word.lower() not in _SPELLING:
                raise self.error(f"channel {quoted(word)}", f"one of {', '.join(CHANNELS)}", line)
        joint.channels = tuple(_SPELLING[w.lower()] for w in words[1:])
        if len(set(joint.channels)) < count:
            raise self.error(f"a channel comes twice in {quoted(joint.name)}", "each channel once a joint", line)
        joint.first_column = self.columns
        self.columns += count


def _statements(text: str) -> Iterator[tuple[int, list[str]]]:
    """Line number and words of every line that has any; a brace is a statement of its own wherever it stands."""
    for line, raw in enumerate(text.split("\n"), 1):
        words: list[str] = []
        for word in raw.replace("{", " { ").replace("}", " } ").split() if "{" in raw or "}" in raw else raw.split():
            if word in ("{", "}"):
                if words:
                    yield line, words
                yield line, [word]
                words = []
            else:
                words.append(word)
        if words:
            yield line, words


def _motion_head(path: str | Path, data: bytes, motion: int) -> tuple[int, float, int]:
    """Frames, seconds a frame and the byte offset of the table."""
    at, fields = data.find(b"\n", motion) + 1 or len(data), []
    for key in ("Frames:", "Frame Time:"):
        while at < len(data):
            end = data.find(b"\n", at)
            end = end if end >= 0 else len(data)
            text, start, at = data[at:end].strip(), at, end + 1
            if text:
                break
        else:
            raise RecordingError(path, "the file ends", f"a line '{key}'", line_at(data, len(data)))
        line, words = line_at(data, start), text[:80].decode("latin-1")
        label, colon, value = words.partition(":")
        if not colon or " ".join(label.split()).lower() != key[:-1].lower():
            raise RecordingError(path, quoted(words), f"a line '{key}'", line)
        fields.append((line, value.strip()))
    (line, frames), (time_line, seconds) = fields
    if not (frames.isascii() and frames.isdigit()) or int(frames) == 0:
        raise RecordingError(path, f"Frames: {quoted(frames)}", "a whole number of at least 1", line)
    frame_time = number(path, seconds, time_line, "the seconds from frame to frame")
    if not 1e-6 <= frame_time <= 3600:
        raise RecordingError(path, f"Frame Time: {quoted(seconds)}", "a positive number of seconds", time_line)
    return int(frames), frame_time, min(at, len(data))


def _motion_table(path: str | Path, data: bytes, start: int, n_frames: int, n_channels: int) -> np.ndarray:
    """All frames, (n_frames, n_channels) float64."""
    if n_channels == 0:
        raise RecordingError(path, "no joint has channels", "CHANNELS with motion")
    # The announced count is not believed before the file is long enough to hold it.
    room = min(n_frames, (len(data) - start) // (2 * n_channels) + 1)
    out = np.empty((room, n_channels))
    found, status, offset, columns = numbers.scan_rows(np.frombuffer(data, np.uint8), start, out, LARGEST)
    line = line_at(data, offset)
    if status == numbers.NOT_A_NUMBER:
        raise RecordingError(path, token_at(data, offset), "a finite decimal number", line)
    if status == numbers.ROW_WIDTH:
        raise RecordingError(path, f"a frame of {columns} numbers", f"{n_channels}, one for each channel", line)
    if status == numbers.TOO_MANY_ROWS:
        surplus = f"{token_at(data, offset)} after the {n_frames} frames that the line 'Frames:' promises"
        raise RecordingError(path, surplus, "the end of the file", line)
    if found != n_frames:
        raise RecordingError(path, f"{found} frames", f"{n_frames}, as the line 'Frames:' says", line)
    return out
