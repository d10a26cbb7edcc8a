"""Motion packed small for a file that plays without a server: whole millimetres, second differences, deflated.

Positions of drawn joints are rounded to a unit (a millimetre, or more for a clip that covers more than 65 m). Along
time, each coordinate is written as its second difference in 16 bits that wrap around, so that unpacking is two running
sums; then all is deflated. ``assets/report/packed_motion.mjs`` reads it.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.posture_drawing import drawn_positions
from core.progress import Report, silent

MILLIMETRE = 0.001
RATES = (60.0, 30.0, 15.0)
"""Frames a second, the first that fits."""
NEAR = 0.5  # seconds: stretches of a clip that lie nearer than this are kept as one
_FULLEST = 32_000  # units from the origin that 16 bits hold
_MOST_FRAMES = 120_000  # a first guess at what can fit; more is not even tried
_ATTEMPTS = 6


class Piece(NamedTuple):
    """A stretch of a clip. step: every how many frames one is kept; frames: how many those are; unit: metres;
    origin: (x, y, z) in metres, added to every position."""

    segment: Segment
    step: int
    frames: int
    unit: float
    origin: tuple[float, float, float]


@dataclass(frozen=True, eq=False)
class PackedMotion:
    """Pieces, and their numbers as deflated little-endian int16, piece after piece, coordinate after coordinate.

    error: largest distance (metres) of a joint in a kept frame from where it was recorded; between: the same over all
    recorded frames, those between kept ones drawn on straight lines. left_out: segments that found no room.
    """

    pieces: tuple[Piece, ...]
    data: bytes
    error: float
    between: float
    left_out: tuple[Segment, ...] = ()


def pack_motion(
    dataset: Dataset, segments: Iterable[Segment], most_bytes: int, report: Report = silent
) -> PackedMotion:
    """The segments, most important first, in at most ``most_bytes``: all of them at the first of RATES that fits; where
    none does, the last segments are left out. Raises KeyError, ParameterError for no frames of the dataset.
    """
    wanted = list(dict.fromkeys(segments))
    size = 2 * most_bytes  # where nothing could be tried: half as much next time
    kept = _within(dataset, wanted, RATES[-1])
    for attempt in range(_ATTEMPTS):
        for k, rate in enumerate(RATES):
            report("packing motion", (attempt + k / len(RATES)) / _ATTEMPTS)
            pieces = [_piece(dataset, stretch, rate) for stretch in _joined(dataset, wanted[:kept])]
            if sum(piece.frames for piece in pieces) > _MOST_FRAMES:
                continue
            numbers = [_quantised(dataset, piece) for piece in pieces]
            data = zlib.compress(b"".join(_differences(one).tobytes() for one in numbers), 9)
            if len(data) <= most_bytes:
                error, between = _errors(dataset, pieces, numbers)
                return PackedMotion(tuple(pieces), data, error, between, tuple(wanted[kept:]))
            size = len(data)
        kept = min(int(0.9 * kept * most_bytes / max(size, 1)), kept - 1) if pieces else 0
    return PackedMotion((), zlib.compress(b""), 0.0, 0.0, tuple(wanted))


def unpack(packed: PackedMotion, n_joints: Sequence[int]) -> list[np.ndarray]:
    """The positions ``(frames, joints, 3)`` of every piece in metres, as the browser computes them.

    n_joints: of each piece.
    """
    numbers = np.frombuffer(zlib.decompress(packed.data), "<i2")
    positions, at = [], 0
    for piece, joints in zip(packed.pieces, n_joints, strict=True):
        size = piece.frames * joints * 3
        columns = numbers[at : at + size].reshape(joints * 3, piece.frames).astype(np.int64)
        at += size
        summed = np.cumsum(np.cumsum(columns, axis=1), axis=1)
        wrapped = ((summed + 32768) % 65536 - 32768).T.reshape(piece.frames, joints, 3)
        positions.append(wrapped * piece.unit + np.array(piece.origin))
    return positions


def _within(dataset: Dataset, segments: Sequence[Segment], rate: float) -> int:
    """How many of the segments, from the first, have no more frames together than can fit."""
    frames = 0.0
    for k, segment in enumerate(segments):
        frames += segment.n_frames * min(1.0, rate / dataset.clip(segment.clip).fps)
        if frames > _MOST_FRAMES * 4:  # they may overlap: packing joins them
            return k
    return len(segments)


def _joined(dataset: Dataset, segments: Iterable[Segment]) -> list[Segment]:
    """The stretches of the clips that the segments cover, in the order of the clips."""
    by_clip: dict[str, list[tuple[int, int]]] = {}
    for segment in segments:
        by_clip.setdefault(segment.clip, []).append((segment.start, segment.end))
    stretches: list[Segment] = []
    for clip, spans in sorted(by_clip.items()):
        near = round(NEAR * dataset.clip(clip).fps)
        start, end = min(spans)
        for low, high in sorted(spans):
            if low > end + near:
                stretches.append(Segment(clip, start, end))
                start, end = low, high
            end = max(end, high)
        stretches.append(Segment(clip, start, end))
    return stretches


def _piece(dataset: Dataset, segment: Segment, rate: float) -> Piece:
    clip = dataset.clip(segment.clip)
    step = max(1, int(np.ceil(clip.fps / rate - 0.01)))
    roots = np.asarray(clip.root_positions[segment.start : segment.end : step], np.float64)
    origin = (roots.min(axis=0) + roots.max(axis=0)) / 2
    reach = float(np.abs(roots - origin).max()) + 4.0  # a body reaches no further from its root
    unit = MILLIMETRE * max(1.0, float(np.ceil(reach / (MILLIMETRE * _FULLEST))))
    return Piece(segment, step, len(roots), unit, tuple(np.round(origin, 3).tolist()))


def _quantised(dataset: Dataset, piece: Piece) -> np.ndarray:
    """Positions in units, ``(frames, joints, 3)`` int16."""
    clip, start, end = piece.segment
    positions, _, _ = drawn_positions(dataset.clip(clip), start, end, piece.step)
    units = np.round((positions.astype(np.float64) - np.array(piece.origin)) / piece.unit)
    quantised: np.ndarray = np.clip(units, -_FULLEST, _FULLEST).astype("<i2")
    return quantised


def _differences(numbers: np.ndarray) -> np.ndarray:
    """Second differences along time, ``(joints * 3, frames)`` int16 that wrap around."""
    columns = numbers.reshape(len(numbers), -1).T
    for _ in range(2):
        columns = np.diff(columns, axis=1, prepend=np.zeros((len(columns), 1), np.int16))
    ready: np.ndarray = np.ascontiguousarray(columns, "<i2")
    return ready


def _errors(dataset: Dataset, pieces: Sequence[Piece], numbers: Sequence[np.ndarray]) -> tuple[float, float]:
    """See PackedMotion: ``error`` and ``between``."""
    kept = between = 0.0
    for piece, units in zip(pieces, numbers, strict=True):
        clip, start, end = piece.segment
        recorded, _, _ = drawn_positions(dataset.clip(clip), start, end)
        shown = units.astype(np.float64) * piece.unit + np.array(piece.origin)
        kept = max(kept, _largest(shown - recorded[:: piece.step]))
        at = np.minimum(np.arange(len(recorded)) / piece.step, piece.frames - 1)
        low = np.floor(at).astype(int)
        high, share = np.minimum(low + 1, piece.frames - 1), (at - low)[:, None, None]
        between = max(between, _largest(shown[low] * (1 - share) + shown[high] * share - recorded))
    return kept, between


def _largest(differences: np.ndarray) -> float:
    return float(np.linalg.norm(differences, axis=-1).max()) if differences.size else 0.0
