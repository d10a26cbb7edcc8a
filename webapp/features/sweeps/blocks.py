"""What boards and reports show of a sweep: its figures over the settings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.parameters import write_value
from core.workspace import Workspace
from webapp.features.sweeps import reading
from webapp.features.sweeps.figures.measures import MEASURES, axis_name
from webapp.shell import settings
from webapp.shell.results import MOTIFS

SHOWN = ("explained", "coverage", "n_motifs", "mean_motions", "error_ratio", "purity", "f1_majority")


def sweep_chart(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``x``: name and values of the first axis; ``series``: values of the second, or one empty text; ``measures``:
    key, name, unit, digits; ``figures``: by measure, a row a series of [median, least, most], null where missing;
    ``settings``: of each of these places, as they stand in a view under ``keys``."""
    try:
        sweep = reading.sweep_of(reading.form_of(dataset, view), view)
    except ParameterError:
        return None
    table = reading.table_of(workspace, dataset, sweep)
    if not table.n_ready:
        return None
    names = list(table.axes)
    points = sweep.points()[:: sweep.seeds]
    texts = [settings.in_link(MOTIFS, asdict(point)) for point in points]
    n_series = len(table.axes[names[1]]) if len(names) > 1 else 1
    seed = settings.key(MOTIFS, "seed")
    measures = [key for key in SHOWN if table.has(key)]
    return {
        "x": {"name": axis_name(names[0]), "values": [write_value(value) for value in table.axes[names[0]]]},
        "series": [f"{axis_name(names[1])} {write_value(value)}" for value in table.axes[names[1]]]
        if len(names) > 1
        else [""],
        "measures": [[key, MEASURES[key].name, MEASURES[key].unit, MEASURES[key].digits] for key in measures],
        "figures": {key: _rows(table.of(key) * MEASURES[key].factor, len(names) > 1) for key in measures},
        "keys": [key for key in settings.keys(MOTIFS) if key != seed],
        "settings": [texts[y::n_series] for y in range(n_series)],
        "ready": [table.n_ready, len(table.figures)],
    }


def _rows(values: np.ndarray, two: bool) -> list[list[list[float] | None]]:
    """values: ``(n_first, n_second or none, n_seeds)``; a row a value of the second axis."""
    cells = values if two else values[:, None]
    return [[_spread(cells[x, y]) for x in range(cells.shape[0])] for y in range(cells.shape[1])]


def _spread(seeds: np.ndarray) -> list[float] | None:
    there = seeds[np.isfinite(seeds)]
    if not len(there):
        return None
    return [round(float(value), 4) for value in (np.median(there), there.min(), there.max())]
