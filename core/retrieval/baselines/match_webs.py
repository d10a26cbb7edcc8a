"""Match webs, after Kovar and Gleicher 2004.

For every pair of motions their grid of posture distances is searched for chains of local minima: stretches that stay
side by side. These are the web; a query then finds what its chains lead to, and what is found is a query in its turn,
so that motions far from the query in numbers are reached over those between. Read here so: a chain's distance is the
mean along it, what of the query it leaves uncovered costs as much as strangers do, and a clip's distance is the least,
over ways of at most three steps, of the greatest step on the way. All grids are needed beforehand, so time and memory
are quadratic in frames: 10 frames a second are looked at, and a large collection is out of reach.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from scipy.spatial.distance import cdist

from core.arrays import Float64Array
from core.compiled import njit
from core.mocap.dataset import Dataset
from core.poses.postures import postures_of
from core.progress import Report, silent
from core.retrieval.baselines.recordings import in_order

FPS = 10.0
STEPS = 3
_REACH = 3  # frames that two minima of a chain may lie apart, in either motion


def match_web_distances(dataset: Dataset, report: Report = silent) -> np.ndarray:
    """Distances of all pairs of clips ``(n, n)``, in the data set's order. Raises as core.poses.postures."""
    postures = postures_of(dataset, analysis_fps=FPS, report=report)
    bounds = list(pairwise(postures.clip_starts))
    clips = [postures.vectors[i:j].astype(np.float64) for i, j in bounds]
    sample = postures.vectors[:: max(1, len(postures.vectors) // 300)]
    strangers = float(np.median(cdist(sample, sample))) or 1.0
    direct = np.zeros((len(clips), len(clips)))
    for i in range(len(clips)):
        for j in range(i + 1, len(clips)):
            grid = np.minimum(cdist(clips[i], clips[j]) / strangers, 1)
            direct[i, j], direct[j, i] = web_distance(grid), web_distance(grid.T)
        report("weaving", (i + 1) / len(clips))
    return in_order(by_steps(direct, STEPS), postures.clips, dataset)


def web_distance(grid: np.ndarray) -> float:
    """How far a motion is from what its best chain in ``grid`` (n, m) leads to, 0 to 1; rows are the query's frames.

    Distances are at most 1, that of strangers.
    """
    return float(_best_chain(np.ascontiguousarray(grid, np.float64), _REACH))


def by_steps(direct: np.ndarray, steps: int) -> np.ndarray:
    """Least greatest step on a way of at most ``steps`` steps, from all to all: ``(n, n)`` from direct ``(n, n)``.

    Among clips that are reached equally well the direct distance decides.
    """
    distances = direct.copy()
    for _ in range(steps - 1):
        distances = np.minimum(distances, np.stack([np.maximum(row[:, None], direct).min(0) for row in distances]))
    return distances + 1e-6 * direct


@njit(nogil=True)
def _best_chain(grid: Float64Array, reach: int) -> float:
    """Least cost of a chain: its cells' distances, those of skipped rows their neighbours', rows outside it 1 each."""
    n, m = grid.shape
    cost = np.empty((n, m))  # of the rows up to here, if a chain goes through this cell
    best = 1.0 * n
    for i in range(n):
        for j in range(m):
            cost[i, j] = np.inf
            value = grid[i, j]
            along = (i == 0 or grid[i - 1, j] >= value) and (i == n - 1 or grid[i + 1, j] >= value)
            across = (j == 0 or grid[i, j - 1] >= value) and (j == m - 1 or grid[i, j + 1] >= value)
            if not (along or across) or value >= 1:
                continue
            least = 1.0 * i + value  # a chain begins here
            for back in range(reach + 1):
                for left in range(reach + 1):
                    if back + left == 0 or i - back < 0 or j - left < 0:
                        continue
                    before = cost[i - back, j - left]
                    if before < np.inf:
                        bridge = 0.5 * (value + grid[i - back, j - left])
                        price = before + (back - 1) * bridge + value if back > 0 else before
                        if price < least:
                            least = price
            cost[i, j] = least
            if least + (n - 1 - i) < best:
                best = least + (n - 1 - i)
    mean: float = best / n
    return mean
