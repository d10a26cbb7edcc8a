"""Self-organising maps of postures: batch training, the paper's online schedule, and both errors (MAP section 3.1).

A map is an array of model vectors ``(nx, ny, d)`` float32. Distances on the grid are between node indices, so a sigma
of 1 reaches about one node far.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
from sklearn.decomposition import PCA
from threadpoolctl import threadpool_limits

from core.arrays import Float32Array, Int64Array
from core.compiled import njit
from core.progress import Progress, Report, silent, unheard

FIRST_RATE, LAST_RATE = 0.8, 0.01  # the paper's learning rates
PASSES = 1000  # the paper's n_L, read as passes over all samples: its 17 minutes rule out 1000 single steps
_BLOCK = 1 << 22  # distances that are held at once
_FEWEST = 2000  # samples an epoch looks at, at least


def batch_som(
    samples: np.ndarray,
    grid: tuple[int, int],
    *,
    epochs: int = 24,
    sigma: tuple[float, float] | None = None,
    seed: int = 0,
    report: Report = silent,
) -> np.ndarray:
    """Model vectors ``(nx, ny, d)`` float32 for samples ``(n, d)``, by batch training.

    It starts from the plane of the two largest principal directions; in each epoch every node becomes the mean of all
    samples weighted by a Gaussian of the grid distance to their best nodes, whose sigma falls geometrically from
    sigma[0], (nx + ny) / 4 where nothing is said, to sigma[1], 0.7. While sigma is wide the map is smooth and a part of
    the samples, drawn with ``seed``, tells as much as all of them; the last epochs look at all.
    Raises ValueError for no samples, a grid below 2 x 2, or sigmas that are not positive and falling.
    """
    samples = _checked(samples, grid)
    first, last = sigma or ((grid[0] + grid[1]) / 4, 0.7)
    if not 0 < last <= first or epochs < 1:
        raise ValueError(f"sigma must fall and stay above 0, not from {first} to {last}, in at least one epoch")
    weights = plane(samples, grid)
    order = np.random.default_rng(seed).permutation(len(samples))
    with threadpool_limits(1, user_api="blas"):  # beside other work, threads wait for one another longer than they gain
        for epoch in range(epochs):
            width = first * (last / first) ** (epoch / max(epochs - 1, 1))
            seen = samples if width <= 2 * last else samples[order[: _enough(len(samples), first, width)]]
            weights = _moved(seen, best_nodes(seen, weights)[0], weights, width)
            report("map", (epoch + 1) / epochs)
    return weights


def _enough(n: int, first: float, width: float) -> int:
    """How many samples an epoch with this sigma looks at: the fewer, the wider."""
    return min(n, max(_FEWEST, math.ceil(n * min(1.0, 0.15 * first / width))))


def plane(samples: np.ndarray, grid: tuple[int, int]) -> np.ndarray:
    """A flat map ``(nx, ny, d)``: the mean and one standard deviation either way along two principal directions.

    The longer side of the grid takes the larger direction.
    """
    mean, axes = principal_axes(samples, 2)
    axes = axes * np.std((samples - mean) @ axes, axis=0)
    if grid[1] > grid[0]:
        axes = axes[:, ::-1]
    x, y = np.meshgrid(np.linspace(-1, 1, grid[0]), np.linspace(-1, 1, grid[1]), indexing="ij")
    flat: np.ndarray = mean + x[..., None] * axes[:, 0] + y[..., None] * axes[:, 1]
    return flat.astype(np.float32)


def principal_axes(samples: np.ndarray, n: int) -> tuple[np.ndarray, np.ndarray]:
    """Mean ``(d,)`` and the ``n`` largest principal directions ``(d, n)``, float32, of samples ``(k, d)``.

    Signs are fixed (the sum of a direction is not negative); directions that the samples lack are 0.
    """
    part = samples[:: max(1, len(samples) // 5000)].astype(np.float64)
    axes = np.zeros((n, part.shape[1]))
    rank = min(n, *part.shape)
    if np.ptp(part, axis=0).any():
        axes[:rank] = PCA(rank, svd_solver="covariance_eigh").fit(part).components_
    axes *= np.where(axes.sum(axis=1, keepdims=True) < 0, -1, 1)
    return part.mean(axis=0).astype(np.float32), axes.T.astype(np.float32)


def _moved(samples: np.ndarray, best: np.ndarray, weights: np.ndarray, sigma: float) -> np.ndarray:
    """The map after one batch step: the Gaussian is separable, so rows and columns are smoothed one after the other."""
    nx, ny, d = weights.shape
    counts = np.bincount(best, minlength=nx * ny).astype(np.float32)
    order = np.argsort(best, kind="stable")
    sums = np.zeros((nx * ny, d), np.float32)
    filled = np.flatnonzero(counts)
    starts = np.concatenate([[0], np.cumsum(counts[filled]).astype(np.int64)[:-1]])
    sums[filled] = np.add.reduceat(samples[order], starts, axis=0)
    along_x, along_y = _gauss(nx, sigma), _gauss(ny, sigma)
    top = np.tensordot(along_x, sums.reshape(nx, ny * d), 1).reshape(nx, ny, d)
    top = np.matmul(along_y, top)
    bottom = along_x @ counts.reshape(nx, ny) @ along_y
    far = bottom < 1e-12  # nobody is near: the node stays
    return np.where(far[..., None], weights, top / np.where(far, 1, bottom)[..., None]).astype(np.float32)


def _gauss(n: int, sigma: float) -> np.ndarray:
    steps = np.arange(n, dtype=np.float64)
    return np.exp(-((steps[:, None] - steps) ** 2) / (2 * sigma * sigma)).astype(np.float32)


def best_nodes(samples: np.ndarray, weights: np.ndarray, progress: Progress = unheard) -> tuple[np.ndarray, np.ndarray]:
    """Index ``(n,)`` of the nearest node (row-major in the grid) and the distance ``(n,)`` to its model vector."""
    index, squared = np.empty(len(samples), np.int64), np.empty(len(samples), np.float32)
    for rows, apart in _blocks(samples, weights):
        index[rows] = np.argmin(apart, axis=1)
        squared[rows] = np.take_along_axis(apart, index[rows, None], axis=1)[:, 0]
        progress(rows.stop / len(samples))
    squared += np.einsum("nd,nd->n", samples, samples, dtype=np.float32)
    return index, np.sqrt(np.maximum(squared, 0))


def _blocks(samples: np.ndarray, weights: np.ndarray) -> Iterator[tuple[slice, np.ndarray]]:
    """Squared distances to all nodes less the squared length of the sample, a block of samples at a time."""
    models = weights.reshape(-1, weights.shape[-1]).astype(np.float32)
    lengths = np.einsum("kd,kd->k", models, models)
    double = np.ascontiguousarray(-2 * models.T)
    rows = max(64, _BLOCK // len(models))
    for low in range(0, len(samples), rows):
        apart = samples[low : low + rows] @ double
        apart += lengths
        yield slice(low, low + len(apart)), apart


def errors(samples: np.ndarray, weights: np.ndarray) -> tuple[float, float]:
    """Quantisation error, the mean distance of a sample to its best node, and topographic error, the share of samples
    whose second best node is none of the eight around the best."""
    ny = weights.shape[1]
    apart_sum, torn = 0.0, 0
    for rows, apart in _blocks(samples, weights):
        seen = samples[rows]
        two = np.argpartition(apart, 1, axis=1)[:, :2]
        near = np.take_along_axis(apart, two, axis=1)
        squared = near.min(axis=1) + np.einsum("nd,nd->n", seen, seen)
        apart_sum += float(np.sqrt(np.maximum(squared, 0)).sum())
        x, y = np.divmod(two, ny)
        torn += int(np.count_nonzero(np.maximum(abs(x[:, 0] - x[:, 1]), abs(y[:, 0] - y[:, 1])) > 1))
    return apart_sum / len(samples), torn / len(samples)


def online_som(
    samples: np.ndarray, grid: tuple[int, int], *, passes: int = PASSES, seed: int = 0, report: Report = silent
) -> np.ndarray:
    """Model vectors ``(nx, ny, d)`` float32 by the paper's own schedule: one sample at a time, from a map of zeros.

    In ``passes`` passes over all samples, each in a new order, alpha = .8 (1 - 6 t / n) while above .01, then .01, and
    sigma = .25 (nx + ny) (1 - t / n), at least .3 (the paper's falls to 0). Raises ValueError as :func:`batch_som`.
    """
    samples = _checked(samples, grid)
    if passes < 1:
        raise ValueError(f"there must be at least one pass, not {passes}")
    weights = np.zeros((*grid, samples.shape[1]), np.float32)
    rng, steps = np.random.default_rng(seed), passes * len(samples)
    for p in range(passes):
        _pass(samples, rng.permutation(len(samples)), weights, p * len(samples), steps)
        report("map", (p + 1) / passes)
    return weights


@njit()
def _pass(samples: Float32Array, order: Int64Array, weights: Float32Array, step: int, steps: int) -> None:
    nx, ny, d = weights.shape
    for i in range(len(order)):
        x = samples[order[i]]
        done = (step + i) / steps
        alpha = max(FIRST_RATE * (1 - 6 * done), LAST_RATE)
        sigma = max(0.25 * (nx + ny) * (1 - done), 0.3)
        best, p, q = np.float32(np.inf), 0, 0
        for a in range(nx):
            for b in range(ny):
                apart = np.float32(0)
                for k in range(d):
                    apart += (x[k] - weights[a, b, k]) ** 2
                if apart < best:
                    best, p, q = apart, a, b
        reach = int(5.3 * sigma) + 1  # beyond that a node would move by less than a millionth
        for a in range(max(0, p - reach), min(nx, p + reach + 1)):
            for b in range(max(0, q - reach), min(ny, q + reach + 1)):
                near = np.float32(alpha * math.exp(-((a - p) ** 2 + (b - q) ** 2) / (2 * sigma * sigma)))
                for k in range(d):
                    weights[a, b, k] += near * (x[k] - weights[a, b, k])


def u_matrix(weights: np.ndarray) -> np.ndarray:
    """Mean distance ``(nx, ny)`` of each node's model vector to those of its four neighbours (fewer at the rim)."""
    heights, counts = np.zeros(weights.shape[:2]), np.zeros(weights.shape[:2])
    for axis in (0, 1):
        step = np.linalg.norm(np.diff(weights.astype(np.float64), axis=axis), axis=-1)
        before = tuple(slice(None, -1) if a == axis else slice(None) for a in (0, 1))
        after = tuple(slice(1, None) if a == axis else slice(None) for a in (0, 1))
        for side in (before, after):
            heights[side] += step
            counts[side] += 1
    return heights / counts


def _checked(samples: np.ndarray, grid: tuple[int, int]) -> np.ndarray:
    samples = np.ascontiguousarray(samples, np.float32)
    if samples.ndim != 2 or len(samples) == 0:
        raise ValueError(f"a map needs samples (n, d), not an array of shape {samples.shape}")
    if min(grid) < 2:
        raise ValueError(f"a map needs at least 2 x 2 nodes, not {grid[0]} x {grid[1]}")
    return samples
