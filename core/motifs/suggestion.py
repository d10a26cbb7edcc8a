"""Suggests a setting of a sweep, with reasons: a trade-off between how much motion motifs cover and how alike it is.

The paper (section 5.2) chooses by eye: kappa as low as possible for coverage, while the error stays reasonable. Here
both are one figure, the motion explained (:func:`core.motifs.sweep_table.explained`), which has its highest value
between many loose motifs and few tight ones. Differences that are no larger than what the seed alone changes decide
nothing: among settings as good as the best, by one standard error (Breiman et al. 1984), the usual one is taken.
How often it agrees with labels: docs/methods/sweeps.md.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from core.motifs.parameters import MotifParameters
from core.motifs.sweep_table import SweepTable
from core.parameters import write_value

CLEAR, UNSURE, NONE = "clear", "unsure", "none"
_MATTERS = 4.0  # standard errors by which an axis must change the motion explained to count
_AGREE = 0.75  # share of seeds that must point to the same place, give or take one step
_ONE_SEED = 0.02  # what one seed may change, as a share of the best, where nothing else is known
_FEWEST = 3  # settings, below which there is nothing to choose from
_SEEDS = 3  # below which their agreement says nothing


@dataclass(frozen=True)
class Suggestion:
    """at: value of each axis, empty where there is nothing to suggest; index: its place on each axis; verdict: CLEAR,
    UNSURE (it is as good as any, but there is no clear trade-off) or NONE; why: one sentence.
    """

    at: dict[str, Any]
    index: tuple[int, ...]
    verdict: str
    why: str


def suggest(table: SweepTable) -> Suggestion:
    """The setting to take among those that are there."""
    worth, every = table.middle("explained"), table.of("explained")
    ready = np.isfinite(worth)
    if ready.sum() < _FEWEST:
        return Suggestion({}, (), NONE, "Too few settings are there to compare them.")
    if not np.nanmax(worth) > 0:
        return Suggestion({}, (), NONE, "Nothing recurs under any of these settings: try smaller kappas.")
    step = _standard_error(every) or _ONE_SEED * float(np.nanmax(worth))
    best = _usual_of_the_best(table, worth, step)
    at = {name: values[i] for (name, values), i in zip(table.axes.items(), best, strict=True)}
    matters = [axis for axis in range(worth.ndim) if _range_along(worth, best, axis) >= _MATTERS * step]
    agree, seeds = _agreement(every, best, matters)
    if not matters:
        low, high = _percent(np.nanmin(worth)), _percent(np.nanmax(worth))
        flat = f"these settings explain {low} to {high} % of the motion, a difference hardly larger than that of seeds"
        return Suggestion(at, best, UNSURE, f"No clear trade-off: {flat}; {_named(at)} is as good as any.")
    axis = max(matters, key=lambda a: _range_along(worth, best, a))
    sentence = f"With {_named(at)} the motifs explain {_percent(worth[best])} % of the motion: "
    sentence += _neighbours(table, best, axis)
    if (gap := _missing(table, best, axis)) is not None:
        return Suggestion(at, best, UNSURE, f"{sentence}; {gap} is not there yet.")
    if (end := _untried(table, best, axis)) is not None:
        return Suggestion(at, best, UNSURE, f"{sentence}; no {end} was tried.")
    if seeds < _SEEDS:
        return Suggestion(at, best, UNSURE, f"{sentence}; {_SEEDS} seeds or more would show how much of it is chance.")
    if agree < _AGREE * seeds:
        return Suggestion(at, best, UNSURE, f"No clear trade-off: only {agree} of {seeds} seeds agree on {_named(at)}.")
    return Suggestion(at, best, CLEAR, f"{sentence}; {agree} of {seeds} seeds agree.")


def _standard_error(every: np.ndarray) -> float:
    """Of a cell's median, pooled over cells ``(..., n_seeds)``; 0 where no cell has two seeds. NaN: not there."""
    cells = every.reshape(-1, every.shape[-1])
    counts = np.isfinite(cells).sum(1)
    cells, counts = cells[counts > 1], counts[counts > 1]
    if not len(cells):
        return 0.0
    return float(1.25 * np.sqrt((np.nanvar(cells, axis=1, ddof=1) / counts).mean()))


def _usual_of_the_best(table: SweepTable, worth: np.ndarray, step: float) -> tuple[int, ...]:
    """Among the cells within one standard error of the best the one nearest the method's defaults, then the best."""
    equal = [index for index in np.ndindex(worth.shape) if worth[index] >= np.nanmax(worth) - step]
    far = _distances_to_defaults(table)
    return min(equal, key=lambda index: (round(sum(d[i] for d, i in zip(far, index, strict=True)), 9), -worth[index]))


def _distances_to_defaults(table: SweepTable) -> list[list[float]]:
    """For every value of every axis how far it is from the default: in octaves, words 0 or 1, none from auto."""
    defaults = {f.name: f.default for f in fields(MotifParameters)}
    distances = []
    for name, values in table.axes.items():
        usual = defaults[name]
        if usual == "auto":
            distances.append([0.0] * len(values))
        elif isinstance(usual, str) or not usual:
            distances.append([float(value != usual) for value in values])
        else:
            distances.append([abs(np.log2(max(value, 1e-3) / usual)) for value in values])
    return distances


def _range_along(worth: np.ndarray, at: tuple[int, ...], axis: int) -> float:
    """How far the motion explained varies along an axis through ``at``."""
    places: tuple[int | slice, ...] = (*at[:axis], slice(None), *at[axis + 1 :])
    line = worth[places]
    return float(np.nanmax(line) - np.nanmin(line))


def _agreement(every: np.ndarray, at: tuple[int, ...], matters: list[int]) -> tuple[int, int]:
    """Seeds whose own best cell lies within one step of ``at`` on the axes that matter, and seeds that have any."""
    agree = seeds = 0
    for k in range(every.shape[-1]):
        own = every[..., k]
        if np.isfinite(own).sum() >= _FEWEST:
            best = np.unravel_index(np.nanargmax(own), own.shape)
            seeds += 1
            agree += all(abs(best[axis] - at[axis]) <= 1 for axis in matters)
    return agree, seeds


def _neighbours(table: SweepTable, at: tuple[int, ...], axis: int) -> str:
    """What is worse on either side of ``at`` along an axis."""
    worth = table.middle("explained")
    name, values = list(table.axes.items())[axis]
    parts = []
    for i in (at[axis] - 1, at[axis] + 1):
        other = (*at[:axis], i, *at[axis + 1 :])
        if 0 <= i < len(values) and np.isfinite(worth[other]):
            parts.append(f"at {_named({name: values[i]})} {_difference(table, at, other)}")
    return ", ".join(parts)


def _missing(table: SweepTable, at: tuple[int, ...], axis: int) -> str | None:
    """A neighbour of ``at`` along an axis that is not there (yet)."""
    name, values = list(table.axes.items())[axis]
    worth = table.middle("explained")
    for i in (at[axis] - 1, at[axis] + 1):
        if 0 <= i < len(values) and not np.isfinite(worth[(*at[:axis], i, *at[axis + 1 :])]):
            return _named({name: values[i]})
    return None


def _untried(table: SweepTable, at: tuple[int, ...], axis: int) -> str | None:
    """What lies beyond ``at`` where that is an end of the axis, but not of what the parameter may be."""
    name, values = list(table.axes.items())[axis]
    numbers, value = [v for v in values if not isinstance(v, str)], values[at[axis]]
    limits = next(f.metadata for f in fields(MotifParameters) if f.name == name)
    if isinstance(value, str):
        return None
    if value == min(numbers) and (limits["min"] is None or value > limits["min"]):
        return f"smaller {name.replace('_', ' ')}"
    if value == max(numbers) and (limits["max"] is None or value < limits["max"]):
        return f"larger {name.replace('_', ' ')}"
    return None


def _difference(table: SweepTable, at: tuple[int, ...], other: tuple[int, ...]) -> str:
    """The change, from one cell to another, that costs more."""
    error, coverage = table.middle("error_ratio"), table.middle("coverage")
    worse = 100 * (error[other] / max(error[at], 1e-9) - 1)
    points = 100 * (coverage[at] - coverage[other])
    if not np.isfinite(worse) or points >= worse * error[at]:  # both as shares of the motion explained
        return f"coverage is {abs(points):.0f} points {'lower' if points >= 0 else 'higher'}"
    return f"the error is {abs(worse):.0f} % {'higher' if worse >= 0 else 'lower'}"


def _named(at: dict[str, Any]) -> str:
    return " and ".join(f"{name.replace('_', ' ')} {write_value(value)}" for name, value in at.items())


def _percent(share: float) -> str:
    return f"{100 * share:.0f}"
