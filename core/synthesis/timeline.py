"""When which source frame shows: pieces of motion, one passing into the next along registered frames."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from scipy.ndimage import gaussian_filter1d

from core.arrays import FloatArray
from core.editing.legs import smooth_step
from core.errors import AnalysisError
from core.mocap.clip import Clip, Segment

_SMOOTH = 0.1  # seconds over which the staircase of a time warp is evened out
_LEAST = 1e-3  # seconds: no step of a registration takes less


class Overlap(NamedTuple):
    """How one piece passes into the next.

    rows: ``(k, 2)``, k >= 2, rising frames of the first clip beside rising frames of the second; blended from the first
    row to the last. seconds: the blend lasts at least so long, slowing down in its middle, up to three times its
    natural length. along: the two are one movement, laid upon one another frame by frame; False for a cross-fade
    between different ones, which are laid upon one another once.
    """

    rows: np.ndarray
    seconds: float = 0.0
    along: bool = True


class Timeline(NamedTuple):
    """For every output frame its one or two source frames.

    pieces ``(n, 2)``: indices of the piece that is being left and of the one that is being entered (the same twice
    outside blends); frames ``(n, 2)`` float64, at the clips' own rates; weights ``(n,)``: of the second;
    seams ``(n_seams, 2)``: half-open output frames of the blends.
    """

    pieces: np.ndarray
    frames: np.ndarray
    weights: np.ndarray
    seams: np.ndarray

    @property
    def leading(self) -> tuple[np.ndarray, np.ndarray]:
        """The piece that counts for more in each frame ``(n,)``, and its source frame ``(n,)``."""
        side = (self.weights >= 0.5).astype(np.int64)
        rows = np.arange(len(side))
        return self.pieces[rows, side], self.frames[rows, side]


def schedule(
    pieces: Sequence[Segment], rates: Sequence[float], overlaps: Sequence[Overlap | None], fps: float
) -> Timeline:
    """Output frames, ``fps`` a second, of pieces that pass into one another.

    rates: frames per second of each piece's clip. overlaps: between neighbours; None where the second goes on at once.
    In a blend, whichever motion weighs more plays about at its natural speed; blends last a whole number of frames, so
    that copies on either side stay exact.
    Raises ValueError where overlaps do not fit their pieces.
    """
    if len(overlaps) != len(pieces) - 1:
        raise ValueError(f"{len(pieces)} pieces need {len(pieces) - 1} overlaps, not {len(overlaps)}")
    blocks, seams, n = [], [], 0
    at = float(pieces[0].start)
    for i, piece in enumerate(pieces):
        overlap = overlaps[i] if i < len(overlaps) else None
        stop = float(piece.end) if overlap is None else float(overlap.rows[0, 0])
        if stop < at - 1e-6:
            raise AnalysisError(
                f"two blends meet in {piece.clip}: one lasts until frame {at:.0f}, the next begins earlier"
            )
        own = _alone(at, stop, rates[i] / fps)
        blocks.append((np.full((len(own), 2), i), np.column_stack([own, own]), np.zeros(len(own))))
        n += len(own)
        if overlap is not None:
            frames, weights = _blended(overlap, (rates[i], rates[i + 1]), fps)
            blocks.append((np.tile([i, i + 1], (len(frames), 1)), frames, weights))
            seams.append((n, n + len(frames)))
            n += len(frames)
            at = float(overlap.rows[-1, 1])
        elif i < len(overlaps):
            at = float(pieces[i + 1].start)
    numbers, frames, weights = (np.concatenate(column) for column in zip(*blocks, strict=True))
    return Timeline(numbers, frames, weights, np.array(seams, np.int64).reshape(-1, 2))


def crossfade(a: Clip, leave: float, b: Clip, enter: float, seconds: float) -> np.ndarray:
    """An overlap of about ``seconds`` around frame ``leave`` of ``a`` and ``enter`` of ``b``: ``(k, 2)``, inside both.

    Where a recording ends too soon, or begins too late, its part of the overlap moves inwards.
    """
    seconds = min(seconds, (a.n_frames - 1) / a.fps, (b.n_frames - 1) / b.fps)
    columns = []
    for clip, frame in ((a, leave), (b, enter)):
        n = max(1, int(seconds * clip.fps))  # whole frames, so that what follows is a copy
        first = int(np.clip(round(frame - n / 2), 0, clip.n_frames - 1 - n))
        columns.append(np.linspace(first, first + n, max(2, int(seconds * a.fps) + 1)))
    return np.column_stack(columns)


def smooth_warp(frames: np.ndarray, fps: float) -> np.ndarray:
    """Rising frame numbers ``(k,)`` with the staircase of a time warp evened out; the ends stay. fps: rows a second."""
    line = np.linspace(frames[0], frames[-1], len(frames))
    off = gaussian_filter1d(frames - line, _SMOOTH * fps, mode="nearest")
    off -= np.linspace(off[0], off[-1], len(off))
    return np.clip(np.maximum.accumulate(line + off), frames[0], frames[-1])


def _alone(start: float, stop: float, step: float) -> np.ndarray:
    """About every ``step``-th frame of [start, stop), at even steps that end in ``stop``."""
    n = max(0, round((stop - start) / step))
    return start + np.arange(n) * ((stop - start) / max(n, 1))


def _blended(overlap: Overlap, rates: tuple[float, float], fps: float) -> tuple[np.ndarray, np.ndarray]:
    """Frames ``(n, 2)`` and weights ``(n,)`` of one blend."""
    rows = np.arange(len(overlap.rows), dtype=np.float64)
    seconds = np.diff(overlap.rows, axis=0) / rates
    weights = smooth_step((rows[:-1] + 0.5) / rows[-1])
    lasts = np.maximum((1 - weights) * seconds[:, 0] + weights * seconds[:, 1], _LEAST)
    times = np.concatenate([[0.0], np.cumsum(lasts)])
    slower = np.clip(overlap.seconds / times[-1], 1, 3)
    n = max(2, round(times[-1] * slower * fps))
    at = np.interp(_slowed(np.arange(n) / n, slower) * times[-1], times, rows)
    return np.column_stack([np.interp(at, rows, column) for column in overlap.rows.T]), smooth_step(at / rows[-1])


def _slowed(u: FloatArray, times: float) -> FloatArray:
    """Shares of the way at shares ``u`` ``(n,)`` of a time that is ``times`` (1 to 3) as long as natural: natural speed
    at both ends, slowest in the middle."""
    return ((2 * times - 2) * u + 3 - 3 * times) * u * u + times * u
