"""Which points a sweep visits: parameters of the motif graph, each with the values it takes, and seeds."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from itertools import product
from typing import Any

from core.errors import ParameterError
from core.motifs.parameters import MotifParameters
from core.parameters import Parameter, build, parameters_of, read_object, write_value

Axes = Mapping[str, Sequence[Any]]
"""Name of a parameter -> the values it takes, in the order in which they are shown."""

PAPER = {"kappa": (50, 100, 200, 500, 1000, 2000), "rho": (0.2, 0.5, 1.0, 2.0, 5.0)}
"""The ranges of the paper's Figures 5 and 6, and what lies between."""

USUAL = PAPER | {
    "gamma": (1.2, 1.35, 1.5, 1.75, 2.0),
    "min_letters": (3, 5, 7, 10),
    "max_letters": (15, 30, 60),
    "adjacency": ("radius", "spheres"),
    "pose": ("angles", "positions"),
    "analysis_fps": (15.0, 30.0, 60.0),
    "reach": (0.03, 0.05, 0.07, 0.1, 0.15),
    "strictness": (0.45, 0.5, 0.545, 0.6, 0.7),
    "join": (0.0, 0.6, 0.8, 1.0),
    "tightness": (0.0, 0.3, 0.6, 0.9),
    "min_seconds": (0.0, 0.35, 0.7, 1.0),
    "hold": (0.0, 0.25, 0.5),
    "slack": (0.0, 0.5, 1.0, 2.0),
    "seeding": ("largest", "random"),
    "init": ("random", "split"),
    "sample": (4000, 8000, 16000),
}
"""Values to begin with, for every parameter that can be an axis."""

MOST_POINTS = 3000
MOST_VALUES = 60
_SWEPT = {p.name: p for p in parameters_of(MotifParameters) if p.name != "seed"}


def sweepable() -> tuple[Parameter, ...]:
    """The parameters that can be an axis: all but the seed, which has its own place."""
    return tuple(_SWEPT.values())


def read_values(name: str, text: str) -> tuple[Any, ...]:
    """The values of parameter ``name`` in ``text`` (``50, 100, auto``), sorted, each once.

    Raises ParameterError, naming the value that cannot be used, or where there is none or too many.
    """
    if name not in _SWEPT:
        raise ParameterError(f"{str(name)[:60]}: no parameter to sweep; there are {', '.join(_SWEPT)}")
    words = [word for word in text.replace(",", " ").split() if word]
    if not words:
        raise ParameterError(f"{name}: name at least one value; expected {_SWEPT[name].expected}")
    values = dict.fromkeys(_SWEPT[name].parse(word) for word in words)
    if len(values) > MOST_VALUES:
        raise ParameterError(f"{name}: {len(values)} values are more than the {MOST_VALUES} that one axis may have")
    return tuple(sorted(values, key=_order))


def read_axis(text: str) -> tuple[str, tuple[Any, ...]]:
    """Name and values of an axis written as ``kappa:50,100,200``; raises ParameterError."""
    name, colon, values = text.partition(":")
    if not colon:
        raise ParameterError(f"{text[:60]!r}: an axis is written as name:value,value, such as kappa:50,100,200")
    return name.strip(), read_values(name.strip(), values)


def write_axis(name: str, values: Sequence[Any]) -> str:
    """An axis as text that :func:`read_axis` reads back."""
    return f"{name}:{','.join(map(write_value, values))}"


def points_of(base: MotifParameters, axes: Axes, seeds: int = 1) -> tuple[MotifParameters, ...]:
    """Every combination of the axes' values, each with seeds base.seed, base.seed + 1, ...; the first axis varies
    slowest, the seed fastest. Raises ParameterError for a value or a combination that cannot be used, or for too many.
    """
    if not 1 <= seeds <= 100:
        raise ParameterError(f"seeds: expected a whole number from 1 to 100, not {seeds}")
    n = seeds
    for name, values in axes.items():
        if name not in _SWEPT:
            raise ParameterError(f"{str(name)[:60]}: no parameter to sweep; there are {', '.join(_SWEPT)}")
        n *= len(values)
    if not 1 <= n <= MOST_POINTS:
        raise ParameterError(f"a sweep has 1 to {MOST_POINTS} points, not {n}: give fewer values or seeds")
    return tuple(
        replace(base, **dict(zip(axes, values, strict=True)), seed=base.seed + k)
        for values in product(*axes.values())
        for k in range(seeds)
    )


@dataclass(frozen=True)
class SweepParameters:
    """A sweep as a request asks for it, in text, so that it can stand in a link and in the job table.

    axes: ``kappa:50,100;rho:0.2,1``; seeds: how many, from that of ``base`` on; base: the other parameters of the motif
    graph as a JSON object, defaults left out; with several seeds they start from random groups of poses. Equal sweeps
    have equal texts. Raises ParameterError.
    """

    axes: str
    seeds: int = field(default=1, metadata={"min": 1, "max": 100, "help": "Seeds at every point of the sweep."})
    base: str = "{}"

    def __post_init__(self) -> None:
        axes, base = self.values_of_axes(), self._base()
        if self.seeds > 1:  # several seeds are to show what chance does
            base = replace(base, init="random")
        defaults = asdict(MotifParameters())
        kept = {name: value for name, value in sorted(asdict(base).items()) if value != defaults[name]}
        object.__setattr__(self, "axes", ";".join(write_axis(*axis) for axis in axes.items()))
        object.__setattr__(self, "base", json.dumps({name: v for name, v in kept.items() if name not in axes}))
        self.points()

    def points(self) -> tuple[MotifParameters, ...]:
        """All points of the sweep, see :func:`points_of`."""
        return points_of(self._base(), self.values_of_axes(), self.seeds)

    def values_of_axes(self) -> dict[str, tuple[Any, ...]]:
        """Name of each axis -> its values, in order."""
        axes = [read_axis(text) for text in self.axes.split(";") if text.strip()]
        if len(dict(axes)) < len(axes):
            raise ParameterError("axes: the two axes of a sweep must be different parameters")
        return dict(axes)

    def _base(self) -> MotifParameters:
        base: MotifParameters = build(MotifParameters, read_object(self.base, "base"))
        return base


def _order(value: Any) -> tuple[int, str, float]:
    """Words first, then numbers."""
    return (0, str(value), 0) if isinstance(value, str) else (1, "", value)
