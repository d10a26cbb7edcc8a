"""Tests by permutation and intervals by the bootstrap, both over units (subjects, or clips where no more is known)."""

from __future__ import annotations

from itertools import combinations, product
from math import comb, factorial
from typing import NamedTuple

import numpy as np

from core.arrays import FloatArray
from core.groups.design import Design

_CHUNK = 4_000_000  # numbers of one product


class Tested(NamedTuple):
    """Two groups compared in each column of a table, arrays ``(n_columns,)``; nan where a column cannot be compared.

    means: ``(2, n_columns)`` of the groups. difference: second minus first. low, high: 95 % interval of the difference.
    effect: Hedges' g, or the mean difference over its spread, corrected likewise, where paired. p: of a two-sided test.
    """

    means: FloatArray
    difference: FloatArray
    low: FloatArray
    high: FloatArray
    effect: FloatArray
    p: FloatArray


def permuted(design: Design, count: int, rng: np.random.Generator) -> np.ndarray:
    """Codes of groups, ``(n, n_units)``, the observed first.

    Labels change places among all units, or within each subject where paired. Where there are no more than ``count``
    ways, each is taken once; else ``count`` are drawn at random.
    """
    codes = design.codes
    ways = _ways(design)
    if ways <= count and len(design.groups) == 2:
        return _all_ways(design)
    if not design.paired:
        order = rng.permuted(np.tile(np.arange(len(codes)), (count, 1)), axis=1)
        return np.concatenate([codes[None], codes[order]])
    drawn = np.tile(codes, (count, 1))
    for block in np.unique(design.blocks):
        own = np.flatnonzero(design.blocks == block)
        drawn[:, own] = rng.permuted(drawn[:, own], axis=1)
    return np.concatenate([codes[None], drawn])


def smallest_p(design: Design, count: int) -> float:
    """The smallest p-value that so many units and permutations can give."""
    ways = _ways(design)
    if ways > count or len(design.groups) != 2:
        return 1 / (count + 1)
    return (2 if design.paired or len(set(np.bincount(design.codes))) == 1 else 1) / ways


def _ways(design: Design) -> int:
    sizes = np.bincount(design.codes)
    if design.paired:
        return int(factorial(len(design.groups)) ** int(sizes[0]))
    ways, left = 1, int(sizes.sum())
    for size in sizes:
        ways, left = ways * comb(left, int(size)), left - int(size)
    return ways


def _all_ways(design: Design) -> np.ndarray:
    codes, rows = design.codes, []
    if design.paired:
        blocks = design.blocks
        for flips in product((0, 1), repeat=len(np.unique(blocks))):
            rows.append(codes ^ np.array(flips)[blocks])
    else:
        for second in combinations(range(len(codes)), int((codes == 1).sum())):
            row = np.zeros(len(codes), np.int64)
            row[list(second)] = 1
            rows.append(row)
    observed = next(k for k, row in enumerate(rows) if (row == codes).all())
    rows[0], rows[observed] = rows[observed], rows[0]
    return np.array(rows)


def p_values(statistics: FloatArray) -> FloatArray:
    """Share of permutations whose statistic, ``(n, n_columns)`` with the observed first, is no smaller.

    The observed one counts among them, so no p-value is zero.
    """
    close = 1e-9 * np.maximum(1, np.abs(statistics[0]))
    at_least = (statistics >= statistics[0] - close).sum(0)
    return np.where(np.isfinite(statistics[0]), at_least / len(statistics), np.nan)


def between_groups(codes: np.ndarray, values: FloatArray, n_groups: int) -> FloatArray:
    """Sum of squares between groups for each labelling, ``(n, n_columns)``; values ``(n_units, n_columns)``, nan where
    a unit has none.
    """
    valid = np.isfinite(values)
    filled = np.where(valid, values, 0)
    out = np.empty((len(codes), values.shape[1]))
    rows = max(1, _CHUNK // max(values.shape[1], 1))
    total = filled.sum(0) / np.maximum(valid.sum(0), 1)
    for start in range(0, len(codes), rows):
        part = codes[start : start + rows]
        squares = np.zeros((len(part), values.shape[1]))
        for group in range(n_groups):
            own = (part == group).astype(float)
            counts = own @ valid
            means = np.divide(own @ filled, counts, out=np.zeros_like(squares), where=counts > 0)
            squares += counts * (means - total) ** 2 * (counts > 0)
        out[start : start + rows] = squares
    return out


def within_subjects(design: Design, values: FloatArray) -> FloatArray:
    """Values less the mean of their subject where paired; nan for a subject that lacks one in a group."""
    if not design.paired:
        return values
    out = np.array(values, float)
    for block in np.unique(design.blocks):
        own = design.blocks == block
        complete = np.isfinite(out[own]).all(0)
        out[own] = np.where(complete, out[own] - out[own].mean(0), np.nan)
    return out


def compare_two(design: Design, values: FloatArray, permutations: int, resamples: int, seed: int) -> Tested:
    """Compares the two groups of a design in every column of ``values``, ``(n_units, n_columns)``.

    A column in which a group has fewer than two units with a value is nan throughout.
    """
    rng = np.random.default_rng(seed)
    codes = permuted(design, permutations, rng)
    centred = within_subjects(design, values)
    if design.paired:
        values = np.where(np.isfinite(centred), values, np.nan)
    usable = np.array([np.isfinite(values[design.codes == group]).sum(0) >= 2 for group in (0, 1)]).all(0)
    values = np.where(usable, values, np.nan)
    p = p_values(between_groups(codes, np.where(usable, centred, np.nan), 2))
    means = np.array([_mean(values[design.codes == group]) for group in (0, 1)])
    low, high = _interval(design, values, resamples, rng)
    effect = effect_size(design, values)
    return Tested(means, means[1] - means[0], low, high, effect, np.where(usable, p, np.nan))


def compare_all(design: Design, values: FloatArray, permutations: int, seed: int) -> tuple[FloatArray, FloatArray]:
    """p-values and eta squared of all groups at once in every column of ``values``, ``(n_units, n_columns)``."""
    codes = permuted(design, permutations, np.random.default_rng(seed))
    centred = within_subjects(design, values)
    squares = between_groups(codes, centred, len(design.groups))
    spread = np.nansum((centred - _mean(centred)) ** 2, axis=0)
    eta = np.divide(squares[0], spread, out=np.zeros_like(spread), where=spread > 0)
    return p_values(squares), eta


def effect_size(design: Design, values: FloatArray) -> FloatArray:
    """Hedges' g of every column, second group minus first; where paired the mean over the spread of the differences.

    Both with the correction for small numbers, 1 - 3 / (4 degrees of freedom - 1); 0 where nothing differs, infinite
    where groups differ and nothing varies within them.
    """
    first, second = (values[design.codes == group] for group in (0, 1))
    if design.paired:
        differences = _in_order(design, values, 1) - _in_order(design, values, 0)
        n = np.isfinite(differences).sum(0)
        shift, spread, freedom = _mean(differences), _spread(differences), n - 1
    else:
        n_first, n_second = np.isfinite(first).sum(0), np.isfinite(second).sum(0)
        freedom = n_first + n_second - 2
        squares = (n_first - 1) * _spread(first) ** 2 + (n_second - 1) * _spread(second) ** 2
        shift = _mean(second) - _mean(first)
        spread = np.sqrt(np.divide(squares, freedom, out=np.zeros_like(squares), where=freedom > 0))
    small = 1 - 3 / np.maximum(4 * freedom - 1, 1)
    tiny = spread <= 1e-12 * np.maximum(1, np.abs(shift))
    with np.errstate(divide="ignore", invalid="ignore"):
        plain = np.where(tiny, np.where(np.abs(shift) <= 1e-12, 0.0, np.sign(shift) * np.inf), shift / spread)
    return np.where(np.isfinite(shift), plain * np.maximum(small, 0), np.nan)


def _interval(
    design: Design, values: FloatArray, resamples: int, rng: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    """95 % percentile interval of the difference of means; units are drawn again within groups, or subjects at once."""
    found = []
    sizes = [np.flatnonzero(design.codes == group) for group in (0, 1)]
    if design.paired:
        together = rng.multinomial(len(sizes[0]), np.full(len(sizes[0]), 1 / len(sizes[0])), resamples)
        weights = [together, together]
        tables = [_in_order(design, values, group) for group in (0, 1)]
    else:
        weights = [rng.multinomial(len(own), np.full(len(own), 1 / len(own)), resamples) for own in sizes]
        tables = [values[own] for own in sizes]
    for weight, table in zip(weights, tables, strict=True):
        valid = np.isfinite(table)
        counts = weight @ valid.astype(float)
        totals = weight @ np.where(valid, table, 0)
        found.append(np.divide(totals, counts, out=np.full(totals.shape, np.nan), where=counts > 0))
    differences = found[1] - found[0]
    empty = ~np.isfinite(differences).any(0)
    differences[:, empty] = 0
    low, high = np.nanpercentile(differences, [2.5, 97.5], axis=0)
    return np.where(empty, np.nan, low), np.where(empty, np.nan, high)


def _in_order(design: Design, values: FloatArray, group: int) -> FloatArray:
    """The values of a group, subjects in the order of their numbers."""
    own = np.flatnonzero(design.codes == group)
    return values[own[np.argsort(design.blocks[own])]]


def _mean(values: FloatArray) -> FloatArray:
    counts = np.isfinite(values).sum(0)
    totals = np.nansum(values, axis=0)
    means: FloatArray = np.divide(totals, counts, out=np.full(totals.shape, np.nan), where=counts > 0)
    return means


def _spread(values: FloatArray) -> FloatArray:
    counts = np.isfinite(values).sum(0)
    squares = np.nansum((values - _mean(values)) ** 2, axis=0)
    spreads: FloatArray = np.sqrt(np.divide(squares, counts - 1, out=np.zeros_like(squares), where=counts > 1))
    return spreads


def benjamini_hochberg(p: FloatArray) -> FloatArray:
    """p-values corrected so that of all that stay below a level at most that share is expected to be chance.

    Any shape; nan stays nan and does not count (Benjamini and Hochberg 1995).
    """
    flat = np.asarray(p, float).ravel()
    out = np.full(flat.shape, np.nan)
    tested = np.flatnonzero(np.isfinite(flat))
    if len(tested):
        order = tested[np.argsort(flat[tested], kind="stable")]
        scaled = flat[order] * len(order) / np.arange(1, len(order) + 1)
        out[order] = np.minimum(np.minimum.accumulate(scaled[::-1])[::-1], 1)
    return out.reshape(np.shape(p))
