"""Statistics of map nodes: seconds of every label, motif or clip, speeds, and what passes a region."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from core.mocap.clip import Segment
from core.motion_map.motion_map import MotionMap


def frame_nodes(motion_map: MotionMap) -> tuple[np.ndarray, np.ndarray]:
    """Node of every analysis frame of all clips ``(n,)``, row by row in the grid, and the clips' first frames

    ``(n_clips + 1,)``.
    """
    runs = motion_map.runs
    lengths = runs.end - runs.start
    per_clip = np.bincount(runs.clip, lengths, len(motion_map.clips)).astype(np.int64)
    return np.repeat(runs.node, lengths), np.concatenate([[0], np.cumsum(per_clip)])


def seconds_on_nodes(motion_map: MotionMap, groups: Sequence[Sequence[Segment]]) -> np.ndarray:
    """Seconds that the segments of each group spend on each node: ``(n_groups, nx, ny)`` float64.

    Segments are in frames of the clips' own rates; those of clips that are not on the map do not count, and a frame
    that lies in two segments of a group counts once.
    """
    nodes, starts = frame_nodes(motion_map)
    place = {name: k for k, name in enumerate(motion_map.clips)}
    n_nodes = motion_map.grid[0] * motion_map.grid[1]
    seconds = np.zeros((len(groups), n_nodes))
    for g, segments in enumerate(groups):
        inside = np.zeros(len(nodes), bool)
        for clip, start, end in segments:
            k = place.get(clip)
            if k is not None:
                scale = motion_map.fps / motion_map.clip_fps[k]
                n = int(starts[k + 1] - starts[k])
                low = min(round(start * scale), n)
                inside[starts[k] + low : starts[k] + min(max(round(end * scale), low + 1), n)] = True
        seconds[g] = np.bincount(nodes[inside], minlength=n_nodes)
    return seconds.reshape(len(groups), *motion_map.grid) / motion_map.fps


def seconds_of_clips(motion_map: MotionMap) -> np.ndarray:
    """Seconds that each clip spends on each node: ``(n_clips, nx, ny)``."""
    runs, (nx, ny) = motion_map.runs, motion_map.grid
    flat = np.bincount(runs.clip * nx * ny + runs.node, runs.end - runs.start, len(motion_map.clips) * nx * ny)
    return flat.reshape(len(motion_map.clips), nx, ny) / motion_map.fps


def mean_speed(motion_map: MotionMap) -> np.ndarray:
    """Mean speed over the ground on each node, ``(nx, ny)`` m/s; nan where no clip passes."""
    runs, (nx, ny) = motion_map.runs, motion_map.grid
    frames = (runs.end - runs.start).astype(np.float64)
    there = np.bincount(runs.node, frames, nx * ny)
    total = np.bincount(runs.node, frames * runs.speed, nx * ny)
    return np.where(there > 0, total / np.maximum(there, 1), np.nan).reshape(nx, ny)


def leading(seconds: np.ndarray) -> np.ndarray:
    """Of groups ``(n_groups, nx, ny)`` the one with most seconds on each node, ``(nx, ny)`` int; -1 where none is."""
    if not len(seconds):
        return np.full(seconds.shape[1:], -1)
    return np.where(seconds.max(axis=0) > 0, seconds.argmax(axis=0), -1)


def passing(motion_map: MotionMap, nodes: np.ndarray, groups: Mapping[int, Sequence[Segment]]) -> dict[int, list[int]]:
    """Which segments of each group touch one of the nodes ``(nx, ny)`` bool: group -> indices, empty ones left out."""
    on = nodes.ravel()
    flat, starts = frame_nodes(motion_map)
    touched = np.concatenate([[0], np.cumsum(on[flat])])
    place = {name: k for k, name in enumerate(motion_map.clips)}
    passing_numbers: dict[int, list[int]] = {}
    for group, segments in groups.items():
        for number, (clip, start, end) in enumerate(segments):
            k = place.get(clip)
            if k is None:
                continue
            scale, last = motion_map.fps / motion_map.clip_fps[k], int(starts[k + 1])
            low = min(int(starts[k]) + round(start * scale), last)
            high = min(max(int(starts[k]) + round(end * scale), low + 1), last)
            if touched[high] > touched[low]:
                passing_numbers.setdefault(group, []).append(number)
    return passing_numbers
