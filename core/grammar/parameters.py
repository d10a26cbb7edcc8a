"""Parameters of the search for terminals."""

from __future__ import annotations

from dataclasses import dataclass

from core.errors import ParameterError
from core.parameters import parameter

METHODS = ("alternation", "paper", "annealing")


@dataclass(frozen=True)
class TerminalParameters:
    """How terminals are found. Each field's metadata: ``help``, ``min``, ``max``, ``step``, ``choices``, ``advanced``.

    Raises ParameterError, in plain words, for a value out of range.
    """

    n_terminals: int | str = parameter(
        "auto",
        "How many elementary actions to tell apart. auto: as many as describe the motion in the least space.",
        1, 500, 1, label="Number of actions",
    )  # fmt: skip
    weight: float = parameter(
        0.02,
        "Higher: fewer, longer repeats count more; lower: likeness within an action counts more.",
        0.0,
        1.0,
        0.01,
        label="Repeated or alike",
    )
    min_seconds: float = parameter(
        1.25, "The shortest piece an action may have, in seconds.", 0.1, 10.0, 0.1, label="Shortest piece (s)"
    )
    max_seconds: float = parameter(
        4.0, "The longest piece an action may have, in seconds.", 0.2, 30.0, 0.1, label="Longest piece (s)"
    )
    method: str = parameter(
        "alternation",
        "alternation = fast; paper = the 2011 paper's genetic search and fine tuning (slow); annealing = the same, "
        "with true annealing.",
        choices=METHODS,
        label="Search method",
    )
    mirror: bool = parameter(
        True, "Whether a motion to the left and the same to the right are one action.", label="Left and right alike"
    )
    pose: str = parameter(
        "positions",
        "What is compared: positions = where the joints are, seen from the pelvis; angles = how the joints are bent.",
        choices=("positions", "angles"), advanced=True, label="Posture features",
    )  # fmt: skip
    velocity: float = parameter(
        0.25,
        "How much speed counts beside posture: the seconds over which it would lead.",
        0.0,
        2.0,
        0.05,
        advanced=True,
        label="Weight of movement",
    )
    starts: int = parameter(
        8,
        "With alternation: random starts, of which the best goes on.",
        1,
        1000,
        1,
        advanced=True,
        label="Random starts",
    )
    crossings: int = parameter(
        16, "With alternation: attempts to make a better one of several beginnings' results.", 0, 10_000, 1,
        advanced=True,
    )  # fmt: skip
    grid: int = parameter(
        15,
        "With paper and annealing: frames between possible cuts.",
        1,
        1000,
        1,
        advanced=True,
        label="Frames between cuts",
    )
    population: int = parameter(
        100, "With paper and annealing: segmentations alive at a time.", 2, 10_000, 1, advanced=True
    )
    generations: int = parameter(500, "With paper and annealing: generations.", 1, 100_000, 10, advanced=True)
    iterations: int = parameter(
        1000,
        "With paper and annealing: attempts to move single cuts.",
        0,
        1_000_000,
        100,
        advanced=True,
        label="Refinement steps",
    )
    analysis_fps: float = parameter(
        15.0, "Frames a second that are looked at.", 5.0, 240.0, 5.0, advanced=True, label="Frames per second"
    )
    seed: int = parameter(
        0,
        "Number that starts the random choices; the same number gives the same result.",
        0,
        None,
        1,
        label="Random seed",
    )

    @property
    def number(self) -> int:
        """How many terminals a search looks for. Raises ValueError where the number is to be chosen."""
        return int(self.n_terminals)

    def __post_init__(self) -> None:
        number = self.n_terminals
        if number != "auto" and (isinstance(number, str) or not 1 <= number <= 500):
            raise ParameterError(f"n_terminals must be auto or 1 to 500, not {number!r}")
        if not (0 <= self.weight <= 1 and 5 <= self.analysis_fps <= 240):
            raise ParameterError("weight must be 0 to 1, analysis_fps 5 to 240")
        if not 0.1 <= self.min_seconds <= 10 or not 2 * self.min_seconds <= self.max_seconds <= 30:
            raise ParameterError("min_seconds must be 0.1 to 10, max_seconds at least twice as long and at most 30")
        if not (1 <= self.grid <= 1000 and 2 <= self.population <= 10_000 and 1 <= self.generations <= 100_000):
            raise ParameterError("grid must be 1 to 1000, population 2 to 10000, generations 1 to 100000")
        if not (1 <= self.starts <= 1000 and 0 <= self.crossings <= 10_000):
            raise ParameterError("starts must be 1 to 1000, crossings 0 to 10000")
        if not 0 <= self.iterations <= 1_000_000:
            raise ParameterError("iterations must be 0 to 1000000")
        if not 0 <= self.velocity <= 2 or self.pose not in ("positions", "angles"):
            raise ParameterError("velocity must be 0 to 2 seconds, pose positions or angles")
        if self.method not in METHODS:
            raise ParameterError(f"method must be one of {', '.join(METHODS)}, not {self.method!r}")
