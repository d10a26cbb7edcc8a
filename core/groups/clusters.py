"""Where along a curve, or on a map, two groups differ: t-statistics with clusters tested by permutation.

A point is over the threshold where its t exceeds what 95 % of permutations reach anywhere on the curve. Neighbouring
points over it form a cluster; its p-value is the share of permutations whose largest cluster has as much mass (the sum
of t over the threshold), as in statistical parametric mapping without assumptions (Nichols and Holmes 2002).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import label

from core.arrays import FloatArray
from core.groups.design import Design
from core.groups.permutation import permuted, within_subjects


@dataclass(frozen=True)
class Cluster:
    """Points that differ. where: ``shape`` bool; sign: of second minus first group; p: over the whole curve or map."""

    where: np.ndarray
    sign: int
    mass: float
    p: float


@dataclass(frozen=True)
class ClusterTest:
    """t of second minus first group, ``shape``; the threshold; clusters over it, smallest p first."""

    t: FloatArray
    threshold: float
    clusters: tuple[Cluster, ...]


def cluster_test(
    design: Design, values: FloatArray, permutations: int = 1000, alpha: float = 0.05, seed: int = 0
) -> ClusterTest:
    """Compares the two groups of a design at every point. values: ``(n_units, *shape)``, finite, shape of 1 or 2 axes.

    Raises ValueError for other shapes or values that are not finite.
    """
    values = np.asarray(values, float)
    if values.ndim not in (2, 3) or len(values) != len(design.units) or not np.isfinite(values).all():
        raise ValueError("a curve or a map of finite numbers is needed for every unit")
    shape = values.shape[1:]
    codes = permuted(design, permutations, np.random.default_rng(seed))
    statistics = t_statistics(design, codes, values.reshape(len(values), -1))
    largest = np.abs(statistics).max(1)
    threshold = float(np.quantile(largest, 1 - alpha))
    reached = np.flatnonzero(largest > threshold)
    masses = np.zeros(len(codes))
    for k in reached:
        masses[k] = max((mass for _, _, mass in _clusters(statistics[k].reshape(shape), threshold)), default=0.0)
    observed = statistics[0].reshape(shape)
    clusters = [
        Cluster(where, sign, mass, float((masses >= mass * (1 - 1e-9)).mean()))
        for where, sign, mass in _clusters(observed, threshold)
    ]
    return ClusterTest(observed, threshold, tuple(sorted(clusters, key=lambda cluster: (cluster.p, -cluster.mass))))


def t_statistics(design: Design, codes: np.ndarray, values: FloatArray) -> FloatArray:
    """Student's t of each labelling, ``(n, n_points)``; of differences within subjects where paired. 0 where nothing
    varies."""
    values = within_subjects(design, values)
    n_first, n_second = ((codes[0] == group).sum() for group in (0, 1))
    second = (codes == 1).astype(float)
    sums, squares = values.sum(0), (values**2).sum(0)
    mean_second = second @ values / n_second
    mean_first = (sums - second @ values) / n_first
    difference = mean_second - mean_first
    if design.paired:  # values are centred: those of the groups are opposite, half the difference each
        rest = squares * 2 / n_first - difference**2  # mean square of the differences less their mean
        variance = np.maximum(rest, 0) * n_first / max(n_first - 1, 1) / n_first
    else:
        within = np.maximum(squares - n_first * mean_first**2 - n_second * mean_second**2, 0)
        variance = within / max(n_first + n_second - 2, 1) * (1 / n_first + 1 / n_second)
    scale = np.maximum(np.abs(values).max(0), 1e-12) * 1e-7
    t: FloatArray = np.where(np.abs(difference) <= scale, 0, difference / np.sqrt(np.maximum(variance, scale**2)))
    return t


def _clusters(t: FloatArray, threshold: float) -> list[tuple[np.ndarray, int, float]]:
    found = []
    for sign in (1, -1):
        groups, count = label(sign * t > threshold)
        for k in range(1, count + 1):
            where = groups == k
            found.append((where, sign, float(np.abs(t[where]).sum())))
    return found
