"""Regions of a map: ridges of the U-matrix divide it, and each part is shown by one posture (MAP section 3.2).

In the paper every ridge divides, however low. Most of the ridges of a map are noise: two postures that somebody holds
give dozens of regions. So a ridge must have a height: a region is a basin of the U-matrix, and two basins stay apart
where the pass between them lies so much higher than the bottom of the shallower one (its persistence, Edelsbrunner et
al. 2002).
"""

from __future__ import annotations

import heapq

import numpy as np
from scipy.ndimage import label

from core.motion_map.som import u_matrix

_LINES = ((1, 0), (0, 1), (1, 1), (1, -1))  # vertical, horizontal and the diagonals
_BESIDE = ((-1, 0), (1, 0), (0, -1), (0, 1))


def borders(heights: np.ndarray) -> np.ndarray:
    """Which nodes ``(nx, ny)`` bool are higher than both neighbours along a row, a column or a diagonal.

    heights: the U-matrix ``(nx, ny)``. A node at the rim has both neighbours only along the rim.
    """
    nx, ny = heights.shape
    padded = np.pad(heights, 1, constant_values=np.inf)  # nothing is higher than what lies outside
    is_border = np.zeros((nx, ny), bool)
    for a, b in _LINES:
        before = padded[1 - a : nx + 1 - a, 1 - b : ny + 1 - b]
        after = padded[1 + a : nx + 1 + a, 1 + b : ny + 1 + b]
        is_border |= (heights > before) & (heights > after)
    return is_border


def find_regions(weights: np.ndarray, ridge: float = 0.0) -> np.ndarray:
    """Region ``(nx, ny)`` int of every node, from 0, in the order of the regions' first nodes.

    weights: model vectors ``(nx, ny, d)``. ridge: how high a ridge must be, in standard deviations of the heights;
    0: every ridge divides, as in the paper, see :func:`paper_regions`. Raises ValueError for a negative ridge.
    """
    if ridge < 0:
        raise ValueError(f"a ridge cannot be {ridge} high")
    regions = _basins(weights, ridge) if ridge else paper_regions(weights)
    order: dict[int, int] = {}
    for region in regions.ravel():
        order.setdefault(int(region), len(order))
    ordered: np.ndarray = np.vectorize(order.__getitem__, otypes=[int])(regions)
    return ordered


def paper_regions(weights: np.ndarray) -> np.ndarray:
    """Region ``(nx, ny)`` int of every node.

    Nodes that are no border make regions where they touch along rows and columns (with diagonals the ridges would
    leak); then border nodes join, nearest model vector first, the region of a neighbour, until all have one. A map of
    borders only is one region.
    """
    components, n = label(~borders(u_matrix(weights)))
    if n == 0:
        return np.zeros(weights.shape[:2], int)
    regions: np.ndarray = components - 1
    _join_borders(regions, weights)
    return regions


def _basins(weights: np.ndarray, ridge: float) -> np.ndarray:
    """Basins of the U-matrix whose passes are ``ridge`` standard deviations above their bottoms.

    Nodes come by rising height. One without a neighbour below it begins a basin; any other joins that of the neighbour
    it is most like. Where that basin is too shallow, it becomes part of the deepest that meets it there; the others
    that are too shallow become part of the node's own, so that every region is in one piece.
    """
    heights = u_matrix(weights)
    nx, ny = heights.shape
    least, flat = ridge * float(heights.std()), heights.ravel()
    basin: dict[int, int] = {}  # node -> one further on towards the lowest node of its basin

    def bottom(node: int) -> int:
        while basin[node] != node:
            basin[node] = basin[basin[node]]
            node = basin[node]
        return node

    for node in map(int, np.argsort(flat, kind="stable")):
        x, y = divmod(node, ny)
        beside = [(x + a) * ny + y + b for a, b in _BESIDE if 0 <= x + a < nx and 0 <= y + b < ny]
        lower = [other for other in beside if other in basin]
        if not lower:
            basin[node] = node
            continue
        apart = [float(np.linalg.norm(weights[x, y] - weights[divmod(other, ny)])) for other in lower]
        own = basin[node] = bottom(lower[int(np.argmin(apart))])
        meeting = sorted({bottom(other) for other in lower}, key=lambda at: (flat[at], at))
        if flat[node] - flat[own] <= least:
            own = basin[own] = meeting[0]
        for other in meeting[1:]:
            if flat[node] - flat[other] <= least:
                basin[other] = own  # they touch here and perhaps nowhere else
    return np.array([bottom(node) for node in range(nx * ny)]).reshape(nx, ny)


def _join_borders(regions: np.ndarray, weights: np.ndarray) -> None:
    """Gives every node of region -1 that of the neighbour it is nearest to, nearest pairs first, in place."""
    nx, ny = regions.shape
    waiting: list[tuple[float, int, int, int, int]] = []

    def offer(x: int, y: int) -> None:
        """Neighbours without a region may join that of (x, y)."""
        for a, b in _BESIDE:
            u, v = x + a, y + b
            if 0 <= u < nx and 0 <= v < ny and regions[u, v] < 0:
                apart = float(np.linalg.norm(weights[x, y] - weights[u, v]))
                heapq.heappush(waiting, (apart, u, v, x, y))

    for x, y in zip(*np.nonzero(regions >= 0), strict=True):
        offer(int(x), int(y))
    while waiting:
        _, u, v, x, y = heapq.heappop(waiting)
        if regions[u, v] < 0:
            regions[u, v] = regions[x, y]
            offer(u, v)


def region_icons(regions: np.ndarray) -> np.ndarray:
    """The node ``(n_regions, 2)`` of each region that is nearest to the region's centre: its posture is the icon."""
    icons = []
    for region in range(int(regions.max()) + 1):
        nodes = np.argwhere(regions == region)
        apart = np.linalg.norm(nodes - nodes.mean(axis=0), axis=1)
        icons.append(nodes[np.argmin(np.round(apart, 9))])
    return np.array(icons, int)
