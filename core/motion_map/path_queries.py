"""Search for motion by a path drawn over the map (proposed in MAP section 6)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from core.arrays import Float64Array, Int64Array
from core.compiled import njit
from core.errors import ParameterError
from core.mocap.clip import Segment
from core.motion_map.key_poses import Runs
from core.motion_map.motion_map import MotionMap

CAP = 3.0  # nodes: a point of the path that nobody passes costs no more, as motion may jump over folds of the map
FARTHEST = 1.5  # nodes, on the mean: what is farther is no hit
_MOST_POINTS = 200
_FARTHEST_POINT = 1e6  # nodes


class PathHit(NamedTuple):
    """A stretch of a clip, in analysis frames, and its mean distance to the drawn path, in nodes."""

    clip: int
    start: int
    end: int
    distance: float


def search_path(
    motion_map: MotionMap, points: Sequence[Sequence[float]], most: int = 60
) -> list[tuple[Segment, PathHit]]:
    """Stretches whose path over the map follows ``points`` ``(k, 2)``, in node units and in their order, best first.

    The path is cut into steps of a node, and warped onto the runs of every clip (subsequence dynamic time warping).
    Raises ValueError for fewer than two points, or points that are not finite.
    """
    hits = follow(motion_map.runs, motion_map.grid[1], even_steps(points))
    return [(motion_map.segment(hit.clip, hit.start, hit.end), hit) for hit in hits[:most]]


def even_steps(points: Sequence[Sequence[float]], step: float = 1.0) -> np.ndarray:
    """The polyline through ``points`` ``(k, 2)`` at equal steps, both ends among them. Raises ParameterError."""
    line = np.asarray(points, np.float64)
    if line.ndim != 2 or line.shape[1] != 2 or len(line) < 2 or not np.isfinite(line).all():
        raise ParameterError("a path needs at least two points with two finite numbers each")
    if np.abs(line).max() > _FARTHEST_POINT:
        raise ParameterError("a path lies on the map, or near it")
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    n = int(np.clip(round(along[-1] / step), 1, _MOST_POINTS - 1)) + 1
    at = np.linspace(0, along[-1], n)
    return np.column_stack([np.interp(at, along, line[:, d]) for d in (0, 1)])


def follow(runs: Runs, ny: int, path: np.ndarray) -> list[PathHit]:
    """Stretches of runs along ``path`` ``(m, 2)``, a point for each node, best first; no two share an end or a start.

    ny: nodes down, as runs count nodes row by row.
    """
    nodes = np.column_stack(np.divmod(runs.node, ny)).astype(np.float64)
    hits: list[PathHit] = []
    bounds = np.flatnonzero(np.diff(runs.clip)) + 1
    for rows in np.split(np.arange(len(nodes)), bounds) if len(nodes) else []:
        cost, first = _warped(nodes[rows], path)
        best: dict[int, int] = {}
        for last in np.flatnonzero(cost <= FARTHEST * len(path)).tolist():
            begin = int(first[last])
            if begin not in best or cost[last] < cost[best[begin]]:
                best[begin] = last
        hits += _apart(runs, rows, {last: begin for begin, last in best.items()}, cost / len(path))
    return sorted(hits, key=lambda hit: (round(hit.distance, 9), hit.end - hit.start, hit.clip, hit.start))


def _apart(runs: Runs, rows: np.ndarray, spans: dict[int, int], cost: np.ndarray) -> list[PathHit]:
    """The best of stretches that overlap by more than half of the shorter."""
    kept: list[tuple[int, int]] = []
    hits = []
    for last in sorted(spans, key=lambda k: (cost[k], k)):
        low, high = int(runs.start[rows[spans[last]]]), int(runs.end[rows[last]])
        if all(min(high, b) - max(low, a) <= 0.5 * min(high - low, b - a) for a, b in kept):
            kept.append((low, high))
            hits.append(PathHit(int(runs.clip[rows[0]]), low, high, float(cost[last])))
    return hits


@njit()
def _warped(nodes: Float64Array, path: Float64Array) -> tuple[Float64Array, Int64Array]:
    """Cost of the best warp of the whole path that ends at each node (n,), and the node where it begins (n,)."""
    n, m = len(nodes), len(path)
    cost, first = np.empty(n), np.arange(n)
    for j in range(n):
        cost[j] = min(np.hypot(nodes[j, 0] - path[0, 0], nodes[j, 1] - path[0, 1]), CAP)
    for i in range(1, m):
        above, begun = cost.copy(), first.copy()
        for j in range(n):
            least, begin = above[j], begun[j]
            if j > 0 and above[j - 1] <= least:
                least, begin = above[j - 1], begun[j - 1]
            if j > 0 and cost[j - 1] < least:
                least, begin = cost[j - 1], first[j - 1]
            cost[j] = least + min(np.hypot(nodes[j, 0] - path[i, 0], nodes[j, 1] - path[i, 1]), CAP)
            first[j] = begin
    return cost, first
