"""The measures of a sweep as arrays over its axes and seeds, also while only some have been computed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.motifs.axes import Axes

Figures = Mapping[str, float]
"""Of one motif graph: its metrics and more, see core.figures."""


@dataclass(frozen=True, eq=False)
class SweepTable:
    """figures: of every point in the order of :func:`core.motifs.axes.points_of`, None where it is not there yet.

    Raises ValueError where their number is not that of the points.
    """

    axes: Axes
    seeds: int
    figures: Sequence[Figures | None]

    def __post_init__(self) -> None:
        if int(np.prod(self.shape)) != len(self.figures):
            raise ValueError(f"{len(self.figures)} figures do not fill a sweep of {self.shape}")

    @property
    def shape(self) -> tuple[int, ...]:
        """Number of values of each axis, and of seeds."""
        return (*(len(values) for values in self.axes.values()), self.seeds)

    @property
    def n_ready(self) -> int:
        """Number of computed points."""
        return sum(figures is not None for figures in self.figures)

    def of(self, measure: str) -> np.ndarray:
        """A figure, or one of DERIVED, of every point: ``(*shape,)`` float64, NaN where it is not there.

        Where there is no motif, there is nothing to say of motifs either: no error, no number of motions, no purity.
        """
        read = DERIVED.get(measure, lambda figures: figures.get(measure, np.nan))
        without = [f is None or (measure in _OF_MOTIFS and not f.get("n_motifs", 1)) for f in self.figures]
        values = [np.nan if gone else read(f) for f, gone in zip(self.figures, without, strict=True)]
        return np.array(values, np.float64).reshape(self.shape)

    def middle(self, measure: str) -> np.ndarray:
        """Median over the seeds that are there: ``(n_first, n_second)``, NaN where there is none."""
        cells = self.of(measure)
        middle = np.full(cells.shape[:-1], np.nan)
        there = np.isfinite(cells).any(axis=-1)
        middle[there] = np.nanmedian(cells[there], axis=-1)
        return middle

    def along(self, measure: str, name: str, at: Mapping[str, Any]) -> np.ndarray:
        """A figure along the axis ``name``, the other axes at the values ``at``: ``(n_values, n_seeds)``.

        Raises KeyError or ValueError where an axis or a value is not there.
        """
        places = [slice(None) if axis == name else list(values).index(at[axis]) for axis, values in self.axes.items()]
        return self.of(measure)[tuple(places)]

    def has(self, measure: str) -> bool:
        """Whether any point has this figure."""
        return bool(np.isfinite(self.of(measure)).any())


_OF_MOTIFS = ("average_frame_error", "error_ratio", "mean_motions", "mean_frames", "purity")


def error_ratio(figures: Figures) -> float:
    """Average frame error over the mean distance to the average pose, as the paper puts them side by side."""
    distance = figures["mean_pose_distance"]
    return figures["average_frame_error"] / distance if distance > 0 else 0.0


def explained(figures: Figures) -> float:
    """Ours: the share of the motion that the motifs explain, 0 to 1: coverage times one minus the error ratio.

    A frame in no motif counts nothing; one in a motif counts less the further the motions of its motif lie apart,
    nothing where they are as far apart as any poses. The mean distance of n motions to their own average is too small
    by sqrt((n - 1) / n): corrected, so that motifs of two motions do not look tighter than they are.
    """
    n = figures["mean_motions"]
    if n <= 1:
        return 0.0
    return figures["coverage"] * (1 - min(1.0, error_ratio(figures) * float(np.sqrt(n / (n - 1)))))


DERIVED: dict[str, Any] = {"error_ratio": error_ratio, "explained": explained}
