"""The points of a sweep as rows and columns of a table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from core.motifs.parameters import MotifParameters
from core.motifs.sweep_table import SweepTable
from webapp.features.sweeps.figures.measures import MEASURES
from webapp.ui.tables import NUMBER, WRAPPED, Row, column, decimals


def columns(table: SweepTable) -> list[dict[str, Any]]:
    """Result (a link), the axes, the seed, and all measures that any point has."""
    link = {"field": "open", "headerName": "Result", "width": 84, "cellRenderer": "PointLink", "sortable": False}
    axes = [column(name, name.replace("_", " "), 98, **WRAPPED, **NUMBER) for name in table.axes]
    seed = [column("seed", "Seed", 74, "Number that starts the random choices", **WRAPPED, **NUMBER)]
    figures = [
        column(measure, words.title, 116, words.help, **WRAPPED, **decimals(words.digits))
        for measure, words in MEASURES.items()
        if table.has(measure)
    ]
    return [link, *axes, *(seed if table.seeds > 1 else []), *figures]


def rows(table: SweepTable, points: Sequence[MotifParameters], links: np.ndarray) -> list[Row]:
    """A row for each computed point; links: address of each point's result, as ``table.shape``."""
    figures = {measure: table.of(measure).ravel() for measure in MEASURES if table.has(measure)}
    ready = [k for k, entry in enumerate(table.figures) if entry is not None]
    addresses = links.ravel()
    return [
        {
            "key": str(k),
            "open": "Open",
            "href": addresses[k],
            **{name: getattr(points[k], name) for name in table.axes},
            "seed": points[k].seed,
            **{measure: MEASURES[measure].number(values[k]) for measure, values in figures.items()},
        }
        for k in ready
    ]
