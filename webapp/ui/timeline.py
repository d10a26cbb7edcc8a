"""Every clip as a row with its labels and the motions of the motifs that were found."""

from __future__ import annotations

import colorsys
from collections.abc import Mapping
from typing import Any

from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.workspace import MotifNote
from webapp.ui.brief_names import brief_names

ACTIONS = ("#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#76b7b2", "#d4a720", "#ff9da7", "#79706e")
GOLDEN = 0.6180339887498949  # turns of the colour circle from one motif to the next: neighbours never look alike


def motif_colour(motif: int) -> str:
    """The colour of a motif in all views: its hue follows from its id, its lightness suits both themes."""
    hue = (0.58 + motif * GOLDEN) % 1.0
    red, green, blue = colorsys.hls_to_rgb(hue, 0.52 + 0.08 * (motif // 3 % 2), 0.55)
    return f"#{round(255 * red):02x}{round(255 * green):02x}{round(255 * blue):02x}"


def timeline(dataset: Dataset, graph: MotifGraph, notes: Mapping[int, MotifNote] | None = None) -> dict[str, Any]:
    """What assets/motifs/timeline.mjs draws, in seconds of the clips:

    ``rows``: {clip, brief (its name), fps, seconds, share (of its frames in motifs), motions: [[start, end, motif,
    number]], labels: [[start, end, action number]]}; ``motifs``: id -> {name, colour, motions}; ``actions``: names by
    number; ``colours``: theirs.
    """
    rates = {clip.name: clip.fps for clip in dataset.clips}
    motions: dict[str, list[list[float]]] = {name: [] for name in rates}
    covered = dict.fromkeys(rates, 0)
    for motif in graph.motifs:
        for number, (clip, start, end) in enumerate(motif.segments):
            if clip in rates:
                motions[clip].append([_short(start / rates[clip]), _short(end / rates[clip]), motif.id, number])
                covered[clip] += end - start
    actions = sorted({label.action for label in dataset.labels})
    numbers = {action: number for number, action in enumerate(actions)}
    labels: dict[str, list[list[float]]] = {name: [] for name in rates}
    for label in dataset.labels:
        fps = rates[label.clip]
        labels[label.clip].append([_short(label.start / fps), _short(label.end / fps), numbers[label.action]])
    rows = [
        {
            "clip": clip.name,
            "brief": brief,
            "fps": clip.fps,
            "seconds": _short(clip.seconds),
            "share": round(covered[clip.name] / max(clip.n_frames, 1), 3),
            "motions": sorted(motions[clip.name]),
            "labels": sorted(labels[clip.name]),
        }
        for clip, brief in zip(dataset.clips, brief_names(dataset.names), strict=True)
    ]
    return {
        "dataset": dataset.name,
        "rows": rows,
        "motifs": {
            str(m.id): {"name": motif_name(m.id, notes or {}), "colour": motif_colour(m.id), "motions": m.n_motions}
            for m in graph.motifs
        },
        "actions": actions,
        "colours": [ACTIONS[number % len(ACTIONS)] for number in range(len(actions))],
    }


def motif_name(motif: int, notes: Mapping[int, MotifNote]) -> str:
    """The label of a motif: its number and the name that someone gave it."""
    named = notes[motif].name if motif in notes else ""
    return f"{motif} {named}" if named else f"Motif {motif}"


def _short(value: float) -> float:
    return round(float(value), 3)
