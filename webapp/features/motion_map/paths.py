"""Paths of clips over a map: computed once for each clip, kept in memory, cut to the segments that are shown."""

from __future__ import annotations

from typing import Any

import numpy as np

from core.caching import RecentCache
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.motion_map.motion_map import MotionMap

_FINE_NODES = 40_000  # virtual and real: finer grids cost more than they show


def path_of(motion_map: MotionMap, key: str, dataset: Dataset, clip: Clip, start: int, end: int) -> dict[str, Any]:
    """The path of frames ``[start, end)`` of a clip over a map, for assets/motion_map/paths.mjs.

    clip, start, end, and ``step``, frames of the clip's own rate between two of ``points`` [[x, y], ...], in node
    units. Raises ValueError for a clip that lacks a joint of the map.
    """
    step = max(1, round(clip.fps / motion_map.fps))
    points = _whole(motion_map, key, dataset, clip, step)
    first, last = start // step, max((end - 1) // step, start // step)
    cut = points[first : last + 1]
    return {
        "dataset": dataset.name,
        "clip": clip.name,
        "start": first * step,
        "end": end,
        "step": step,
        "points": np.round(cut, 3).tolist(),
    }


def _whole(motion_map: MotionMap, key: str, dataset: Dataset, clip: Clip, step: int) -> np.ndarray:

    def compute() -> np.ndarray:
        nx, ny = motion_map.grid
        factor = next((f for f in (4, 3, 2) if nx * ny * f * f <= _FINE_NODES), 1)
        return motion_map.trajectory(clip, factor, step).astype(np.float32)

    return _paths.get_or_compute((key, dataset.name, dataset.fingerprint, clip.name), compute)


_paths: RecentCache[tuple[str, str, str, str], np.ndarray] = RecentCache(400)
