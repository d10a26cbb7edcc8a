"""The bytes of a C3D file: head, parameters, points and rotations, as c3d.org describes them.

Written here because no well-kept reader takes all files that people have: ezc3d 1.7.2 refuses big-endian ones and ends
the whole process on some damaged ones. Integers and reals, Intel, DEC and SGI byte orders.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.errors import RecordingError

_BLOCK = 512
_INTEL, _DEC, _SGI = 84, 85, 86
MOST_FRAMES, _MOST_POINTS = 2**31, 65535
_KEY = 0x50

Parameters = dict[tuple[str, str], Any]


@dataclass(frozen=True, eq=False)
class RawC3d:
    """What a C3D file holds.

    points: (n_frames, n_points, 3) in the file's unit, NaN where a point was not seen. rotations: (n_frames, n, 4, 4)
    or None. parameters: (group, name) -> number, text, or list of them. analog: number of analog channels.
    """

    points: np.ndarray
    rotations: np.ndarray | None
    parameters: Parameters
    rate: float
    frames_stated: int
    analog: int

    def texts(self, group: str, name: str) -> list[str]:
        """A parameter that is a list of words, with its continuations (LABELS2 ...)."""
        found: list[str] = []
        for k in range(1, 256):
            value = self.parameters.get((group, name if k == 1 else f"{name}{k}"))
            if value is None:
                break
            found += [str(v) for v in (value if isinstance(value, list) else [value])]
        return found


class _Numbers:
    """Numbers in the byte order of a file."""

    def __init__(self, processor: int):
        self.order = ">" if processor == _SGI else "<"
        self._dec = processor == _DEC

    def word(self, data: bytes, at: int) -> int:
        """The unsigned number of two bytes at ``at``."""
        return int(struct.unpack_from(self.order + "H", data, at)[0])

    def reals(self, data: bytes) -> np.ndarray:
        """Four-byte reals as float64."""
        with np.errstate(invalid="ignore", over="ignore"):
            if not self._dec:
                return np.frombuffer(data, self.order + "f4").astype(float)
            words = np.frombuffer(data, "<u2").reshape(-1, 2).astype(np.uint32)
            # the numbers of a VAX: the halves exchanged, and an exponent that is 2 more
            return ((words[:, 0] << 16) | words[:, 1]).view(np.float32).astype(float) / 4

    def integers(self, data: bytes) -> np.ndarray:
        """Signed numbers of two bytes."""
        return np.frombuffer(data, self.order + "i2")


def parse_c3d(path: str | Path, data: bytes) -> RawC3d:
    """Everything in a C3D file. Raises RecordingError where it is none, or is damaged."""
    if len(data) < 2 * _BLOCK or data[1] != _KEY:
        raise RecordingError(path, "this is no C3D file", "a file that begins as C3D does")
    start = (data[0] - 1) * _BLOCK
    if start < _BLOCK or start + 4 > len(data):
        raise RecordingError(path, "the parameters lie outside the file", "a whole C3D file")
    numbers = _Numbers(data[start + 3])
    if data[start + 3] not in (_INTEL, _DEC, _SGI):
        raise RecordingError(path, f"processor type {data[start + 3]}", "84 (Intel), 85 (DEC) or 86 (SGI)")
    parameters = _parameters(data, start, numbers)
    return _data(path, data, numbers, parameters)


def _parameters(data: bytes, start: int, numbers: _Numbers) -> Parameters:
    """Groups and parameters; the list ends where it says so, or where the file does."""
    groups: dict[int, str] = {}
    raw: list[tuple[int, str, Any]] = []
    at = start + 4
    while at + 2 < len(data):
        length, group = abs(struct.unpack_from("b", data, at)[0]), struct.unpack_from("b", data, at + 1)[0]
        if length == 0 or group == 0:
            break
        name = data[at + 2 : at + 2 + length].decode("latin-1").strip().upper()
        pointer = at + 2 + length
        if pointer + 2 > len(data):
            break
        step = numbers.word(data, pointer)
        if group < 0:
            groups[-group] = name
        else:
            raw.append((group, name, _value(data, pointer + 2, numbers)))
        if step == 0:
            break
        at = pointer + step
    return {(groups.get(group, str(group)), name): value for group, name, value in raw if value is not None}


def _value(data: bytes, at: int, numbers: _Numbers) -> Any:
    """The value of a parameter: a number, a word, or a list of them; None where it is cut off."""
    if at + 2 > len(data):
        return None
    kind, rank = struct.unpack_from("b", data, at)[0], data[at + 1]
    shape = list(data[at + 2 : at + 2 + rank])
    count = int(np.prod(shape, dtype=np.int64)) if shape else 1
    size = abs(kind) or 1
    if len(shape) < rank or size not in (1, 2, 4) or count * size > len(data):
        return None
    body = data[at + 2 + rank : at + 2 + rank + count * size]
    if len(body) < count * size:
        return None
    if kind == -1:
        width = shape[0] if shape else 1
        words = (
            [body[k : k + width].decode("latin-1").strip(" \0") for k in range(0, len(body), max(width, 1))]
            if width
            else []
        )
        return words if rank > 1 else (words[0] if words else "")
    values = {1: lambda: np.frombuffer(body, "i1"), 2: lambda: numbers.integers(body), 4: lambda: numbers.reals(body)}[
        size
    ]()
    plain = values.tolist()
    return plain if rank else (plain[0] if plain else None)


def _data(path: str | Path, data: bytes, numbers: _Numbers, parameters: Parameters) -> RawC3d:
    count, per_frame = numbers.word(data, 2), numbers.word(data, 4)
    first, last, begin = numbers.word(data, 6), numbers.word(data, 8), numbers.word(data, 16)
    scale = float(numbers.reals(data[12:16])[0])
    rate = float(numbers.reals(data[20:24])[0])
    rate = _real(parameters.get(("POINT", "RATE"))) or rate
    scale = _real(parameters.get(("POINT", "SCALE"))) or scale
    begin = _whole(parameters.get(("POINT", "DATA_START"))) or begin
    frames = _frame_count(parameters, last - first + 1)
    size = 4 if scale < 0 else 2
    width = size * (4 * count + per_frame)
    at = (begin - 1) * _BLOCK
    if not 0 <= at <= len(data) or count > _MOST_POINTS:
        raise RecordingError(path, "the points lie outside the file", "a whole C3D file")
    there = (len(data) - at) // width if width else 0
    n = min(frames, there) if width else 0
    points = np.empty((n, count, 3))
    if count and n:
        body = data[at : at + n * width]
        rows = np.frombuffer(body, np.uint8).reshape(n, width)[:, : size * 4 * count]
        flat = np.ascontiguousarray(rows).tobytes()
        table = (numbers.reals(flat) if size == 4 else numbers.integers(flat).astype(float)).reshape(n, count, 4)
        points = table[..., :3] * (1.0 if size == 4 else abs(scale))
        with np.errstate(invalid="ignore"):
            lost = ~(table[..., 3] >= 0) | ~np.isfinite(points).all(axis=2)
        points[lost] = np.nan
    rotations = _rotations(data, numbers, parameters)
    if not len(points) and rotations is None:
        raise RecordingError(path, "no frames with points", "frames of points or of rotations")
    return RawC3d(points, rotations, parameters, rate, frames, per_frame)


def _frame_count(parameters: Parameters, stated: int) -> int:
    """Frames: the largest that any place of the file says, for old ones hold 65535 at most."""
    frames = [stated, _whole(parameters.get(("POINT", "FRAMES"))), _whole(parameters.get(("POINT", "LONG_FRAMES")))]
    start, end = (parameters.get(("TRIAL", name)) for name in ("ACTUAL_START_FIELD", "ACTUAL_END_FIELD"))
    if isinstance(start, list) and isinstance(end, list) and len(start) == len(end) == 2:
        first, last = ((int(v[0]) & 0xFFFF) + (int(v[1]) & 0xFFFF) * 65536 for v in (start, end))
        if stated <= last - first + 1 < MOST_FRAMES and stated in (last - first + 1, 65535, 0):
            frames.append(last - first + 1)
    return max(0, *frames)


def _rotations(data: bytes, numbers: _Numbers, parameters: Parameters) -> np.ndarray | None:
    """Matrices (n_frames, n, 4, 4) of the group ROTATION (Theia); None where there are none."""
    used, start = (_whole(parameters.get(("ROTATION", name))) for name in ("USED", "DATA_START"))
    if not 0 < used < 1000 or start < 1:
        return None
    body = data[(start - 1) * _BLOCK :]
    width = 17 * 4 * used  # a matrix and how sure it is
    n = len(body) // width
    stated = _whole(parameters.get(("POINT", "FRAMES")))
    ratio = _whole(parameters.get(("ROTATION", "RATIO"))) or 1
    n = min(n, stated * ratio) if stated else n
    if not n:
        return None
    values = numbers.reals(body[: n * width]).reshape(n, used, 17)
    return values[..., :16].reshape(n, used, 4, 4).swapaxes(2, 3)


def _whole(value: Any) -> int:
    """A parameter as a number that counts; 0 where it is none."""
    value = value[0] if isinstance(value, list) and value else value
    if isinstance(value, int):
        return value & 0xFFFF if value < 0 else value
    return int(value) if isinstance(value, float) and 0 <= value < MOST_FRAMES else 0


def _real(value: Any) -> float:
    value = value[0] if isinstance(value, list) and value else value
    return float(value) if isinstance(value, int | float) and np.isfinite(value) else 0.0
