"""Fewer postures that cover as much: one is kept when it is far enough from all that are kept (MAP section 3.1)."""

from __future__ import annotations

import numpy as np
from numba import njit

from core.motion_map.som import principal_axes
from core.progress import Report, silent

_CHUNK = 20_000  # postures between two reports
_TABLE = 1 << 16  # lists of the hash table


def reduce_samples(postures: np.ndarray, threshold: float, report: Report = silent) -> np.ndarray:
    """Indices ``(k,)``, ascending, of the postures that are kept; postures: ``(n, d)``, distances Euclidean.

    In the order they come a posture is kept when no kept one lies within ``threshold``: exactly the paper's rule. Kept
    ones stand in a grid of cells over the three largest principal directions, as wide as the threshold: whoever is
    near is in one of the 27 cells around. Raises ValueError for a negative threshold.
    """
    if threshold < 0:
        raise ValueError(f"the threshold must not be negative, not {threshold}")
    postures = np.ascontiguousarray(postures, np.float32)
    n = len(postures)
    if threshold == 0 or n == 0:
        return np.arange(n)
    mean, axes = principal_axes(postures, 3)
    cells = np.floor((postures - mean) @ axes / threshold).astype(np.int64)
    head, follow, kept = np.full(_TABLE, -1, np.int64), np.empty(n, np.int64), np.zeros(n, bool)
    for low in range(0, n, _CHUNK):
        _keep(postures, cells, threshold**2, low, min(low + _CHUNK, n), head, follow, kept)
        report("samples", min(1.0, (low + _CHUNK) / n))
    return np.flatnonzero(kept)


@njit(cache=True)
def _cell(x, y, z):
    return (x * 73856093 ^ y * 19349663 ^ z * 83492791) & (_TABLE - 1)


@njit(cache=True)
def _is_free(postures, cells, squared, i, head, follow):
    """Whether nothing kept lies within the threshold of posture i."""
    for x in range(-1, 2):
        for y in range(-1, 2):
            for z in range(-1, 2):
                k = head[_cell(cells[i, 0] + x, cells[i, 1] + y, cells[i, 2] + z)]
                while k >= 0:
                    apart = np.float32(0)
                    for d in range(postures.shape[1]):
                        apart += (postures[i, d] - postures[k, d]) ** 2
                        if apart > squared:
                            break
                    if apart <= squared:
                        return False
                    k = follow[k]
    return True


@njit(cache=True)
def _keep(postures, cells, squared, low, high, head, follow, kept):
    """Looks at postures [low, high) and enters those that are kept; head, follow: linked lists of the cells."""
    for i in range(low, high):
        if _is_free(postures, cells, squared, i, head, follow):
            place = _cell(cells[i, 0], cells[i, 1], cells[i, 2])
            follow[i], head[place], kept[i] = head[place], i, True


def threshold_for(postures: np.ndarray, wanted: int, *, seed: int = 0) -> float:
    """A threshold that keeps up to ``wanted`` of the postures ``(n, d)``, to about 20 %; 0 where there are fewer.

    Of long collections a part is looked at, so that the cost has a bound; the number kept grows little beyond it.
    """
    if len(postures) <= wanted:
        return 0.0
    rng, most = np.random.default_rng(seed), max(20_000, 3 * wanted)
    part = postures[np.sort(rng.choice(len(postures), min(len(postures), most), replace=False))]
    high = float(np.linalg.norm(part - part.mean(axis=0), axis=1).mean())
    while len(reduce_samples(part, high)) > wanted:
        high *= 1.5
    low = high
    while len(reduce_samples(part, low)) <= wanted and low > high / 1000:
        high, low = low, low / 1.4
    middle = (low * high) ** 0.5
    return high if len(reduce_samples(part, middle)) > wanted else middle
