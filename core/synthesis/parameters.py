"""What a walk can be told, besides what its motif graph was told."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from typing import Any, Literal

from core.errors import ParameterError
from core.grammar.build import GrammarParameters
from core.motifs.parameters import MotifParameters
from core.synthesis.paths import parse_path


@dataclass(frozen=True)
class WalkParameters(MotifParameters):
    """A walk through the motif graph that the inherited parameters stand for.

    Raises ParameterError, in plain words, for a path that cannot be read or a value out of range.
    """

    path: str = field(
        default="",
        metadata={"help": "The way: 3-7-9, fewest:3:9, used:3:9 (along the most-used edges) or random:SECONDS:SEED."},
    )
    further: bool = field(
        default=False, metadata={"help": "Also pass at good transition points inside motifs that no edge joins."}
    )
    gaps: Literal["refuse", "detour", "bridge"] = field(
        default="refuse",
        metadata={"help": "Where no edge leads on: refuse, take the shortest way round, or bridge the gap by a blend."},
    )
    dead_end: Literal["jump", "stop"] = field(
        default="jump", metadata={"help": "What a random walk does where nothing leads on: jump, or stop there."}
    )
    keep_feet: bool = field(
        default=True, metadata={"help": "Keep standing feet where they stand; false leaves plain blending."}
    )

    def __post_init__(self) -> None:
        MotifParameters(**self.graph)  # checks them
        if not self.path:
            raise ParameterError("path: must be given, such as 3-7-9 or random:30:7")
        parse_path(self.path)

    @property
    def graph(self) -> dict[str, Any]:
        """The parameters of the motif graph alone."""
        return {entry.name: getattr(self, entry.name) for entry in fields(MotifParameters)}

    @property
    def options(self) -> dict[str, Any]:
        """What :func:`core.synthesis.walks.make_walk` takes besides the path."""
        return {name: getattr(self, name) for name in ("further", "gaps", "dead_end", "keep_feet")}


@dataclass(frozen=True)
class DeriveParameters(GrammarParameters):
    """A sentence of the grammar that the inherited parameters stand for.

    Raises ParameterError, in plain words, for a value out of range.
    """

    sentence: str = field(
        default="random:0:40",
        metadata={"help": "The routine: random:SEED:MOST (actions), or the rule indices of one, 0.3.1."},
    )
    keep_feet: bool = field(
        default=True, metadata={"help": "Keep standing feet where they stand; false leaves plain blending."}
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if not 1 <= len(self.sentence) <= 10_000:
            raise ParameterError("sentence: must be given, such as random:7:40")

    @property
    def grammar(self) -> dict[str, Any]:
        """The parameters of the grammar alone."""
        return {entry.name: getattr(self, entry.name) for entry in fields(GrammarParameters)}
