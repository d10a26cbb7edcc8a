"""The gallery: boards to begin with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from core.workspace import Block


@dataclass(frozen=True)
class Template:
    """A board to begin with. blocks: (kind, title, x, y, width, height, more settings)."""

    title: str
    words: str
    blocks: tuple[tuple[str, str, int, int, int, int, Mapping[str, Any]], ...] = field(default=())


def _text(markdown: str) -> dict[str, Any]:
    return {"options": {"markdown": markdown}}


TEMPLATES: dict[str, Template] = {
    "empty": Template("Empty board", "Begin with nothing and add what you need."),
    "overview": Template(
        "Dataset overview",
        "What is in a dataset: its figures, clips, labels, motifs and postures.",
        (
            ("numbers", "", 0, 0, 12, 2, {"options": {"figures": "clips,seconds,labels,n_motifs,coverage"}}),
            ("graph", "Motif graph", 0, 2, 7, 7, {}),
            ("map", "Motion map", 7, 2, 5, 7, {}),
            ("tracks", "Labels and motifs over time", 0, 9, 7, 5, {}),
            ("overview", "Clips", 7, 9, 5, 5, {}),
        ),
    ),
    "motifs": Template(
        "Motif report",
        "Which movements recur, what follows what, and how well it is covered.",
        (
            ("text", "", 0, 0, 4, 3, _text("## What recurs\n\nSay here what you looked for and what you found.")),
            ("numbers", "", 4, 0, 8, 3, {"options": {"figures": "n_motifs,coverage,mean_motions,mean_frames"}}),
            ("graph", "Motif graph", 0, 3, 7, 7, {}),
            ("matrix", "What follows what", 7, 3, 5, 7, {}),
            ("motifs", "Motifs", 0, 10, 8, 6, {}),
            ("sweep", "Other settings", 8, 10, 4, 6, {}),
        ),
    ),
    "compare": Template(
        "Before and after",
        "The same results with two settings side by side. Change the settings of the blocks on the right.",
        (
            ("text", "", 0, 0, 6, 2, _text("### Before")),
            ("text", "", 6, 0, 6, 2, _text("### After")),
            ("numbers", "Before", 0, 2, 6, 3, {"options": {"figures": "n_motifs,coverage,average_frame_error"}}),
            (
                "numbers", "After", 6, 2, 6, 3,
                {"options": {"figures": "n_motifs,coverage,average_frame_error"}, "view": {"gamma": "2"}},
            ),
            ("graph", "Before", 0, 5, 6, 7, {}),
            ("graph", "After", 6, 5, 6, 7, {"view": {"gamma": "2"}}),
        ),
    ),
    "curation": Template(
        "Curation",
        "What to keep, mend or name: clips with their labels and remarks, and a place to discuss them.",
        (
            ("text", "", 0, 0, 5, 4, _text("## To do\n\n- name the motifs\n- clips to cut\n- labels to mend")),
            ("overview", "Clips", 5, 0, 7, 7, {}),
            ("motifs", "Motifs to name", 0, 4, 5, 8, {}),
            ("tracks", "Labels and motifs over time", 5, 7, 7, 5, {}),
        ),
    ),
}  # fmt: skip


def blocks_of(template: Template) -> list[Block]:
    """The blocks of a template as a board keeps them."""
    return [Block("", kind, x, y, w, h, {"title": title, **more}) for kind, title, x, y, w, h, more in template.blocks]
