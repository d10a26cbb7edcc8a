"""Where on a motion map two groups spend their time differently."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import combinations
from typing import Any

import numpy as np
from scipy.ndimage import gaussian_filter

from core.arrays import FloatArray
from core.groups.clusters import cluster_test
from core.groups.design import Design
from core.groups.parameters import GroupParameters

SMOOTH = 1.0  # nodes: standard deviation of the kernel that makes a density of stays

Stay = tuple[str, int, float]
"""A stay of a clip on a node: name of the clip, number of the node row by row, frames."""


def densities(design: Design, stays: Iterable[Stay], grid: tuple[int, int]) -> FloatArray:
    """Share of time near each node, per cent, ``(n_units, *grid)``; a unit that is not on the map is nan."""
    row_of = {clip: row for row, unit in enumerate(design.units) for clip in unit.clips}
    counts = np.zeros((len(design.units), grid[0] * grid[1]))
    for clip, node, frames in stays:
        if clip in row_of:
            counts[row_of[clip], node] += frames
    totals = counts.sum(1, keepdims=True)
    shares = np.divide(100 * counts, totals, out=np.full(counts.shape, np.nan), where=totals > 0)
    smooth: FloatArray = gaussian_filter(shares.reshape(-1, *grid), (0, SMOOTH, SMOOTH), mode="reflect")
    return smooth


def map_differences(
    design: Design, stays: Iterable[Stay], grid: tuple[int, int], parameters: GroupParameters
) -> list[dict[str, Any]]:
    """For every pair of groups ``groups``, ``grid``, ``difference`` (second minus first, per cent, row by row) and
    ``clusters``: ``nodes`` [[i, j]], ``sign`` and ``p`` over the whole map. Pairs with a unit off the map are left out.
    """
    values = densities(design, stays, grid)
    found = []
    for a, b in combinations(design.groups, 2):
        own = np.array([k for group in (a, b) for k, unit in enumerate(design.units) if unit.group == group])
        pair = design.pair(a, b)
        if not np.isfinite(values[own]).all():
            continue
        test = cluster_test(pair, values[own], parameters.permutations, parameters.alpha, parameters.seed)
        means = [values[own][pair.codes == group].mean(0) for group in (0, 1)]
        clusters = [
            {"nodes": np.argwhere(cluster.where).tolist(), "sign": cluster.sign, "p": cluster.p}
            for cluster in test.clusters
        ]
        difference = [float(f"{x:.4g}") for x in (means[1] - means[0]).ravel()]
        found.append({"groups": [a, b], "grid": list(grid), "difference": difference, "clusters": clusters})
    return found
