"""The measures of a sweep: their names, units and explanations, and which two share a chart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from core.motifs.sweep_table import SweepTable
from core.parameters import write_value


class Measure(NamedTuple):
    """name: on axes and in lists; factor: what the figure is multiplied by to be shown, in ``unit``, with so many
    digits behind the point.
    """

    name: str
    help: str
    digits: int
    factor: float = 1.0
    unit: str = ""

    def text(self, value: float) -> str:
        """The figure with its unit, as people read it."""
        return f"{value * self.factor:.{self.digits}f}{f' {self.unit}' if self.unit else ''}"

    def number(self, value: float) -> float | None:
        """The figure as a table shows it; None for NaN."""
        return None if value != value else round(float(value) * self.factor, self.digits)

    @property
    def title(self) -> str:
        """For an axis."""
        return f"{self.name} ({self.unit})" if self.unit else self.name


MEASURES = {
    "explained": Measure(
        "Motion explained",
        "The share of all motion that motifs explain: coverage times one minus the error ratio.",
        1, 100, "%",
    ),
    "coverage": Measure("Coverage", "Share of all frames that belong to some motif.", 1, 100, "%"),
    "average_frame_error": Measure(
        "Average frame error", "Mean distance of a frame to the same moment of its motif's average motion.", 2
    ),
    "error_ratio": Measure(
        "Error ratio", "Average frame error over the mean distance of a pose to the average pose.", 3
    ),
    "n_motifs": Measure("Motifs", "How many movements recur.", 0),
    "mean_motions": Measure("Motions per motif", "Mean number of motions of a motif.", 2),
    "mean_frames": Measure("Frames per motion", "Mean length of a motion.", 0),
    "purity": Measure(
        "Purity", "Share of the labelled frames in motifs that have their motif's most frequent label.", 1, 100, "%"
    ),
    "f1_majority": Measure(
        "F1", "F1 of the motifs as predictions of labels, each with its most frequent label; mean over actions.",
        1, 100, "%",
    ),
    "seconds": Measure("Seconds", "Time of all stages behind the result, shared ones included.", 2, 1, "s"),
}  # fmt: skip

_AXES = {"kappa": "Distinct poses (kappa)", "rho": "Long or frequent (rho)"}

PAIRS = {  # chart -> figure on the left scale, on the right scale
    "error-coverage": ("average_frame_error", "coverage"),
    "motifs": ("n_motifs", "mean_motions"),
    "labels": ("purity", "f1_majority"),
}


def pairs_of(table: SweepTable) -> dict[str, tuple[str, str]]:
    """The charts that this sweep has figures for."""
    return {name: pair for name, pair in PAIRS.items() if name != "labels" or table.has(pair[0])}


def axis_name(parameter: str) -> str:
    """A parameter as an axis title."""
    return _AXES.get(parameter, parameter.replace("_", " ").capitalize())


def is_even(values: Sequence[Any]) -> bool:
    """Whether values are shown as words side by side, and not as numbers on a scale."""
    return any(isinstance(value, str) for value in values)


def is_log(values: Sequence[Any]) -> bool:
    """Whether numbers are shown on a logarithmic scale: those that span more than about one order of magnitude."""
    return not is_even(values) and min(values) > 0 and max(values) / min(values) >= 8


def place(at: Mapping[str, Any]) -> str:
    """Values of parameters in words: ``rho 1, gamma 1.5``."""
    return ", ".join(f"{name.replace('_', ' ')} {write_value(value)}" for name, value in at.items())
