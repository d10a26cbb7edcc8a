"""Thins postures: one is kept when it is far enough from all kept before (MAP section 3.1)."""

from __future__ import annotations

import numpy as np

from core.arrays import BoolArray, Float32Array, Int64Array
from core.compiled import njit
from core.motion_map.som import principal_axes
from core.progress import Report, silent

_CHUNK = 20_000  # postures between two reports
_TABLE = 1 << 16  # lists of the hash table
_MOST_TRIES = 24
_ENOUGH = 0.85  # of the samples that are wanted


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
    return np.flatnonzero(_kept(postures, (postures - mean) @ axes, threshold, n, report)[0])


def _kept(
    postures: np.ndarray, places: np.ndarray, threshold: float, most: int, report: Report = silent
) -> tuple[np.ndarray, int]:
    """Which postures ``(n,)`` bool are kept, and how many were looked at: no more once ``most`` are kept.

    places: the postures ``(n, 3)`` along their three largest principal directions.
    """
    n = len(postures)
    cells = np.floor(places / threshold).astype(np.int64)
    head, follow, kept = np.full(_TABLE, -1, np.int64), np.empty(n, np.int64), np.zeros(n, bool)
    seen, count = 0, 0
    for low in range(0, n, _CHUNK):
        end = min(low + _CHUNK, n)
        seen, count = _keep(postures, cells, threshold**2, low, end, head, follow, kept, count, most)
        report("samples", end / n)
        if seen < end:
            break
    return kept, seen


@njit()
def _cell(x: int, y: int, z: int) -> int:
    return (x * 73856093 ^ y * 19349663 ^ z * 83492791) & (_TABLE - 1)


@njit()
def _is_free(
    postures: Float32Array, cells: Int64Array, squared: float, i: int, head: Int64Array, follow: Int64Array
) -> bool:
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


@njit()
def _keep(
    postures: Float32Array,
    cells: Int64Array,
    squared: float,
    low: int,
    high: int,
    head: Int64Array,
    follow: Int64Array,
    kept: BoolArray,
    count: int,
    most: int,
) -> tuple[int, int]:
    """Looks at postures [low, high) and enters those that are kept, until they are more than ``most``.

    head, follow: linked lists of the cells. Gives where it stopped and how many are kept.
    """
    for i in range(low, high):
        if _is_free(postures, cells, squared, i, head, follow):
            place = _cell(cells[i, 0], cells[i, 1], cells[i, 2])
            follow[i], head[place], kept[i] = head[place], i, True
            count += 1
            if count > most:
                return i, count
    return high, count


def threshold_for(postures: np.ndarray, wanted: int, *, seed: int = 0) -> float:
    """A threshold that keeps up to ``wanted`` of the postures ``(n, d)``, to about 15 %; 0 where there are fewer.

    Of long collections a part is looked at, so that the cost has a bound; the number kept grows little beyond it. A
    threshold that keeps too many costs little: it is given up as soon as that is seen.
    """
    if len(postures) <= wanted:
        return 0.0
    rng, most = np.random.default_rng(seed), max(20_000, 3 * wanted)
    rows = np.sort(rng.choice(len(postures), min(len(postures), most), replace=False))
    part = np.ascontiguousarray(postures[rows], np.float32)
    mean, axes = principal_axes(part, 3)
    places = (part - mean) @ axes
    threshold = float(np.linalg.norm(part - mean, axis=1).mean()) / 4
    low, high, slope = 0.0, np.inf, 1.5  # keeps too many, keeps few enough; how fast the number falls, in logarithms
    before: tuple[float, float] | None = None
    for _ in range(_MOST_TRIES):
        kept, seen = _kept(part, places, threshold, wanted)
        count = float(np.count_nonzero(kept))
        if count > wanted:
            low, count = threshold, count * len(part) / max(seen, 1)  # had it gone on
        else:
            high = threshold
            if count >= _ENOUGH * wanted:
                break
        if before and before[0] != threshold and before[1] != count:
            slope = float(np.clip(-np.log(count / before[1]) / np.log(threshold / before[0]), 0.7, 6.0))
        before = threshold, count
        threshold *= (count / (0.94 * wanted)) ** (1 / slope)
        if not low < threshold < high:
            threshold = (low * high) ** 0.5 if low > 0 else high / 2
        if high < low * 1.002:
            break  # equal postures: nothing lies between
    return high if high < np.inf else low * 1.5
