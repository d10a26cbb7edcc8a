"""The settings of a comparison of groups."""

from __future__ import annotations

from dataclasses import dataclass, field

from core.errors import ParameterError


@dataclass(frozen=True)
class GroupParameters:
    """permutations: of each test, taken all where there are fewer ways. resamples: of the bootstrap of each interval.

    alpha: level after the correction up to which a difference counts. seed: of what is drawn.
    """

    permutations: int = field(
        default=1000,
        metadata={
            "min": 100,
            "max": 100_000,
            "help": "How often groups are exchanged in each test; more is more exact.",
        },
    )
    resamples: int = field(
        default=1000,
        metadata={"min": 100, "max": 100_000, "help": "How often subjects are drawn again for each interval."},
    )
    alpha: float = field(
        default=0.05,
        metadata={"min": 0.0001, "max": 0.5, "help": "Level after the correction up to which a difference counts."},
    )
    seed: int = field(default=0, metadata={"min": 0, "max": 2**31, "help": "Where random choices start."})

    def __post_init__(self) -> None:
        if not (100 <= self.permutations <= 100_000 and 100 <= self.resamples <= 100_000):
            raise ParameterError("permutations and resamples are whole numbers from 100 to 100000")
        if not 0 < self.alpha <= 0.5:
            raise ParameterError("alpha is a share above 0 and up to 0.5")
