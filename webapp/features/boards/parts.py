"""Blocks as boards and reports list them, and the contents that the features give for them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from core.errors import MotionscapeError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.shell.feature import blocks


@dataclass(frozen=True)
class Part:
    """A block. view: the settings that its result has, as they stand in a link; columns: of 12 on a screen."""

    kind: str
    title: str = ""
    note: str = ""
    view: Mapping[str, str] = field(default_factory=dict)
    options: Mapping[str, str] = field(default_factory=dict)
    columns: int = 12


OVERVIEW = (
    Part("numbers", columns=12),
    Part(
        "graph", "Motif graph", "Click a box to see its motions. Drag to move, buttons or + and − to zoom.", columns=12
    ),
    Part(
        "map",
        "Motion map",
        "Every place is a posture: point at it to see it, click to see motion that passes.",
        columns=6,
    ),
    Part("matrix", "What follows what", "Rows lead to columns; the darker, the more often.", columns=6),
    Part("tracks", "Labels and motifs over time", columns=12),
    Part(
        "actions", "Actions over time", "Each clip as a string of the actions that the grammar is made of.", columns=12
    ),
    Part("sweep", "Sweep of settings", columns=12),
    Part("motifs", "Motifs", columns=12),
    Part("overview", "Clips", columns=12),
)
"""What a report shows where no board says otherwise; what has not been computed is left out."""


@dataclass(frozen=True)
class Filled:
    """A part with what it shows; or why it shows nothing, as a sentence. missing: because it has not been computed."""

    part: Part
    content: dict[str, Any] | None
    problem: str = ""
    missing: bool = False


def fill(workspace: Workspace, dataset: Dataset, part: Part) -> Filled:
    """The part with its content, or with the reason why there is none."""
    block = blocks().get(part.kind)
    if block is None:
        return Filled(part, None, f"There is no block of the kind “{part.kind}” in this version.")
    try:
        content = block.content(workspace, dataset, part.view, part.options)
    except MotionscapeError as error:
        return Filled(part, None, str(error))
    if content is None:
        where = "" if block.method else " It is computed on its own page."
        return Filled(part, None, f"{block.label}: not computed yet with these settings.{where}", missing=True)
    return Filled(part, content)


def segments_of(filled: Sequence[Filled], dataset: Dataset) -> Iterator[Segment]:
    """What the contents play, in turns, so that each has its most important first; frames that exist only."""
    frames = {clip.name: clip.n_frames for clip in dataset.clips}
    contents = [(one.part.kind, one.content) for one in filled if one.content is not None]
    lists = [iter(blocks()[kind].segments(content)) for kind, content in contents]
    while lists:
        for segments in list(lists):
            segment = next(segments, None)
            if segment is None:
                lists.remove(segments)
            elif 0 <= segment[1] < segment[2] <= frames.get(segment[0], 0):
                yield Segment(*segment)
