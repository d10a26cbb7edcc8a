"""Terminals: groups of alike segments that together cover every frame, and the strings they spell (SYN section 4)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from core.errors import FormatError
from core.mocap.clip import Segment

FORMAT = "motionscape/terminals/1"


@dataclass(frozen=True, eq=False)
class Terminals:
    """What :func:`core.grammar.identification.find_terminals` found. A terminal's id is its place, from 0.

    segments: per terminal its segments, at the clips' own rates, by clip and start; all together cover every frame of
    every clip once. medoids: per terminal the most central of its segments. objective: ``F``, ``R`` and ``E``, the
    paper's F, R and E'. description: where the number of terminals was chosen, number -> nats that describe a piece of
    motion, see :mod:`core.grammar.grouping`; else empty. parameters: as used; seconds: stage -> time; clips: (name,
    frames, fps) of every clip.
    """

    segments: tuple[tuple[Segment, ...], ...]
    medoids: tuple[Segment, ...]
    objective: Mapping[str, float]
    parameters: Mapping[str, Any] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    clips: tuple[tuple[str, int, float], ...] = ()
    dataset: Mapping[str, Any] = field(default_factory=dict)
    description: Mapping[int, float] = field(default_factory=dict)

    @property
    def n_terminals(self) -> int:
        """Number of terminals, K."""
        return len(self.segments)

    @cached_property
    def occurrences(self) -> Mapping[str, tuple[tuple[int, Segment], ...]]:
        """Clip -> its segments in time order, each with the terminal it belongs to."""
        by_clip: dict[str, list[tuple[int, Segment]]] = {name: [] for name, _, _ in self.clips}
        for terminal, segments in enumerate(self.segments):
            for segment in segments:
                by_clip.setdefault(segment.clip, []).append((terminal, segment))
        return {clip: tuple(sorted(items, key=lambda item: item[1].start)) for clip, items in by_clip.items()}

    @cached_property
    def strings(self) -> Mapping[str, tuple[int, ...]]:
        """Clip -> the terminals in time order: what the grammar is learned from."""
        return {clip: tuple(terminal for terminal, _ in items) for clip, items in self.occurrences.items()}

    def runs(self, clip: str) -> tuple[tuple[int, Segment], ...]:
        """As ``occurrences[clip]``, with neighbours of one terminal as one segment: a walk of five steps is one walk.

        Raises KeyError for an unknown clip.
        """
        runs: list[tuple[int, Segment]] = []
        for terminal, segment in self.occurrences[clip]:
            if runs and runs[-1][0] == terminal:
                runs[-1] = terminal, Segment(clip, runs[-1][1].start, segment.end)
            else:
                runs.append((terminal, segment))
        return tuple(runs)

    def to_json(self) -> dict[str, Any]:
        """The terminals as a JSON document."""
        return {
            "format": FORMAT,
            "dataset": dict(self.dataset),
            "clips": [{"name": name, "frames": int(frames), "fps": float(fps)} for name, frames, fps in self.clips],
            "parameters": dict(self.parameters),
            "seconds": {stage: round(t, 4) for stage, t in self.seconds.items()},
            "objective": {name: float(value) for name, value in self.objective.items()},
            "description": [[number, round(nats, 4)] for number, nats in self.description.items()],
            "terminals": [
                {"id": k, "segments": list(map(segment_json, segments)), "medoid": segment_json(self.medoids[k])}
                for k, segments in enumerate(self.segments)
            ],
        }


def segment_json(segment: Segment) -> dict[str, Any]:
    """A segment as JSON: clip, start, end."""
    return {"clip": segment.clip, "start": int(segment.start), "end": int(segment.end)}


def from_json(document: Mapping[str, Any]) -> Terminals:
    """The terminals back from :meth:`Terminals.to_json`. Raises FormatError for anything that is not such a
    document.
    """
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        format_name = document.get("format") if isinstance(document, Mapping) else type(document).__name__
        raise FormatError(f"these are no terminals: found {format_name!r}, expected {FORMAT!r}")
    try:
        terminals = document["terminals"]
        return Terminals(
            segments=tuple(tuple(map(_segment, terminal["segments"])) for terminal in terminals),
            medoids=tuple(_segment(terminal["medoid"]) for terminal in terminals),
            objective=dict(document["objective"]),
            parameters=dict(document["parameters"]),
            seconds=dict(document["seconds"]),
            clips=tuple((clip["name"], clip["frames"], clip["fps"]) for clip in document["clips"]),
            dataset=dict(document["dataset"]),
            description={int(number): float(nats) for number, nats in document.get("description", ())},
        )
    except (KeyError, TypeError) as error:
        raise FormatError(f"these terminals are incomplete: {error!r} is missing or misshapen") from error


def _segment(item: Mapping[str, Any]) -> Segment:
    return Segment(str(item["clip"]), int(item["start"]), int(item["end"]))
