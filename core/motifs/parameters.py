"""Parameters of the motif graph, each with a help text, range and choices that the command line and the app show."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from core.errors import ParameterError
from core.parameters import parameter

_SMALLEST_SAMPLE = 500


@dataclass(frozen=True)
class MotifParameters:
    """How motifs are found. Each field's metadata: ``help``, ``min``, ``max``, ``step``, ``choices``, ``advanced``.

    ``advanced`` fields are not in the paper. Their defaults were tuned on five labelled exercise clips (see
    benchmarks/bench_motifs.py, which also judges left-out clips); with tightness, join, hold and min_seconds at 0,
    adjacency "spheres", seeding and init "random" the method is nearly the paper's.

    Raises ParameterError, in plain words, for a value out of range.
    """

    kappa: int | str = parameter(
        "auto",
        "How many different poses to tell apart. More: stricter motifs, less of the motion covered. "
        "auto: 50 times the square root of how far the motion travels through different poses.",
        2, 20_000, 1, label="Distinct poses (kappa)",
    )  # fmt: skip
    rho: float = parameter(
        1.0,
        "Below 1 prefers motifs with many motions, above 1 prefers motifs with long motions.",
        0.2,
        5.0,
        0.1,
        label="Long or frequent (rho)",
    )
    gamma: float = parameter(
        1.5,
        "How much faster or slower one motion of a motif may be than another (1.5: by half).",
        1.0,
        4.0,
        0.05,
        label="Speed tolerance (gamma)",
    )
    min_letters: int = parameter(
        5,
        "Shortest motion, counted in changes of pose. Lower finds shorter motions, and more chance hits.",
        2,
        100,
        1,
        label="Shortest motion",
    )
    max_letters: int = parameter(30, "Longest motion, counted in changes of pose.", 2, 400, 1, label="Longest motion")
    adjacency: str = parameter(
        "radius",
        "Which poses may stand for each other: radius = all within one distance; spheres = the 2008 paper's rule, "
        "whose reach depends on how many poses are told apart.",
        choices=("radius", "spheres"),
        label="Alike poses",
    )
    pose: str = parameter(
        "angles",
        "What makes poses alike: joint angles, or positions of the joints.",
        choices=("angles", "positions"),
        label="Compare",
    )
    analysis_fps: float = parameter(
        30.0,
        "Frames a second that are looked at. 30 is fast and enough for most motion.",
        5.0,
        240.0,
        5.0,
        label="Frames per second",
    )
    seed: int = parameter(
        0,
        "Number that starts the random choices; the same number gives the same result.",
        0,
        None,
        1,
        label="Random seed",
    )
    init: str = parameter(
        "split",
        "Where the grouping of poses starts: split = always the same, so that another seed changes nothing; "
        "random = k-means++ from the seed.",
        choices=("split", "random"), advanced=True, label="Start of the grouping",
    )  # fmt: skip
    reach: float = parameter(
        0.07,
        "With radius: the share of all pairs of pose clusters that count as alike.",
        0.001,
        0.5,
        0.005,
        advanced=True,
    )
    strictness: float = parameter(
        0.545, "Mean distance along two motions up to which they match, as a share of the radius.", 0.05, 1.0, 0.05,
        advanced=True,
    )  # fmt: skip
    join: float = parameter(
        0.8,
        "Leftover motions join a motif they match up to this mean distance, as a share of the radius; 0: none.",
        0.0, 1.5, 0.05, advanced=True,
    )  # fmt: skip
    tightness: float = parameter(
        0.6,
        "How much less a motion counts for a motif that is only just near enough; 0: all count alike, as in the paper.",
        0.0, 1.0, 0.1, advanced=True,
    )  # fmt: skip
    min_seconds: float = parameter(
        0.35, "Shortest motion in seconds, whatever its number of letters.", 0.0, 10.0, 0.1, advanced=True
    )
    hold: float = parameter(
        0.25,
        "Seconds of a held first or last pose that count as part of a motion.",
        0.0, 2.0, 0.01, advanced=True,
    )  # fmt: skip
    slack: float = parameter(
        1.0, "Freedom of the time alignment around a pose that is held, in shares of its duration.", 0.0, 4.0, 0.1,
        advanced=True,
    )  # fmt: skip
    seeding: str = parameter(
        "largest",
        "largest = always the largest motif next, the same every time; random = the paper's random seeds.",
        choices=("largest", "random"), advanced=True,
    )  # fmt: skip
    sample: int = parameter(
        8000,
        "Recordings with more changes of pose than this (about seven minutes have so many) are searched in samples of "
        "so many; 0: always all at once, which is exact, but time and memory grow with the square.",
        0, 1_000_000, 1000, advanced=True,
    )  # fmt: skip

    def __post_init__(self) -> None:
        for f in fields(self):
            _check(f.name, getattr(self, f.name), f.default, f.metadata)
        if self.min_letters > self.max_letters:
            raise ParameterError(f"min_letters ({self.min_letters}) must not exceed max_letters ({self.max_letters})")
        if 0 < self.sample < _SMALLEST_SAMPLE:
            raise ParameterError(f"sample must be 0 or at least {_SMALLEST_SAMPLE}, not {self.sample}")


def _check(name: str, value: Any, default: Any, allowed: Any) -> None:
    if allowed["choices"]:
        if value not in allowed["choices"]:
            raise ParameterError(f"{name} must be one of {', '.join(allowed['choices'])}, not {value!r}")
        return
    if name == "kappa" and value == "auto":
        return
    whole = isinstance(default, int) or name == "kappa"
    kind = "a whole number" if whole else "a number"
    if isinstance(value, bool) or not isinstance(value, int if whole else (int, float)):
        raise ParameterError(f"{name} must be {kind}{' or auto' if name == 'kappa' else ''}, not {value!r}")
    low, high = allowed["min"], allowed["max"]
    if not (low is None or value >= low) or not (high is None or value <= high):
        limits = f"at least {low}" if high is None else f"from {low} to {high}"
        raise ParameterError(f"{name} must be {kind} {limits}, not {value}")
