"""Distance of two paths over the ground, which PCR section 6 leaves open."""

from __future__ import annotations

import numpy as np

from core.retrieval.descriptors import N_COLUMNS
from core.retrieval.frames import UNITS

_POINTS = 16
_ROOM = 0.5  # metres that a path may be off whatever its length
_LEFT, _FORWARD, _TURNING = N_COLUMNS, N_COLUMNS + 1, N_COLUMNS + 3


def path_distances(
    query: np.ndarray, codes: np.ndarray, starts: np.ndarray, ends: np.ndarray, fps: float
) -> np.ndarray:
    """How far the way of ``query`` (n, ...) is from those of stretches ``[start, end)`` of ``codes``: ``(k,)``.

    Paths begin at one place, facing one way, and are read at equal steps of time; half is how far the places are
    apart, as a share of the longer path, half how far the headings are (half a turn is most).
    """
    query_path, heading, length = _path(query, fps)
    distances = np.empty(len(starts))
    for k, (start, end) in enumerate(zip(starts, ends, strict=True)):
        path, turn, longer = _path(codes[start:end], fps)
        apart = np.linalg.norm(path - query_path, axis=1) / (_ROOM + max(length, longer))
        distances[k] = 0.5 * np.minimum(apart, 1).mean() + 0.5 * np.minimum(np.abs(turn - heading) / np.pi, 1).mean()
    return distances


def _path(codes: np.ndarray, fps: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Places ``(_POINTS, 2)`` m and headings ``(_POINTS,)`` rad of a path, and its length in metres."""
    step = [codes[:, column] * (UNITS[column] / fps) for column in (_LEFT, _FORWARD, _TURNING)]
    heading = np.concatenate([[0.0], np.cumsum(step[2])])
    sin, cos = np.sin(heading[:-1]), np.cos(heading[:-1])
    moves = np.column_stack([step[0] * cos + step[1] * sin, step[1] * cos - step[0] * sin])
    places = np.concatenate([np.zeros((1, 2)), np.cumsum(moves, axis=0)])
    at = np.linspace(0, len(codes), _POINTS)
    read = [np.interp(at, np.arange(len(codes) + 1), track) for track in (places[:, 0], places[:, 1], heading)]
    return np.column_stack(read[:2]), read[2], float(np.linalg.norm(moves, axis=1).sum())
