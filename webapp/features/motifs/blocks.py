"""What boards and reports show of a motif graph: the graph, its table, what follows what, and its figures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif
from core.workspace import MotifNote, Workspace
from webapp.features.motifs.figures.graph import box_sizes, component_colours, edge_width
from webapp.features.motifs.figures.placement import place_boxes
from webapp.features.motifs.playing import shown_motions
from webapp.shell.results import motif_graph, motif_notes
from webapp.ui.filmstrip import page_icon, segment_filmstrip
from webapp.ui.tables import labels_by_clip, majority_label
from webapp.ui.timeline import motif_colour, motif_name

MOST_STRIPS = 60
USUAL = ("clips", "seconds", "labels", "n_motifs", "coverage", "mean_motions")
FIGURES = {  # name -> what it is called, its unit, digits, explanation
    "clips": ("Clips", "", 0, "Recordings in the dataset"),
    "seconds": ("Duration", "s", 0, "Of all clips together"),
    "labels": ("Labels", "", 0, "Labelled stretches"),
    "n_motifs": ("Motifs", "", 0, "Movements that recur"),
    "coverage": ("Coverage", "%", 1, "Share of all frames that belong to some motif"),
    "mean_motions": ("Motions per motif", "", 1, "Mean number of motions of a motif"),
    "mean_frames": ("Frames per motion", "", 0, "Mean length of a motion"),
    "average_frame_error": (
        "Frame error", "", 2, "Mean distance of a frame to the same moment of its motif's average motion",
    ),
}  # fmt: skip


def graph(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``motifs``: id, name, colour, part (the colour of its connected part), count, seconds, label, place, size, icon,
    and its motions as [clip, start, end] with warps; ``edges``: [source, target, count, width]."""
    found = motif_graph(workspace, dataset.name, view)
    if found is None:
        return None
    notes, by_clip = motif_notes(workspace, dataset.name, view), labels_by_clip(dataset)
    sizes, at = box_sizes(found.motifs), {motif.id: i for i, motif in enumerate(found.motifs)}
    places = place_boxes(sizes, [(at[e.source], at[e.target]) for e in found.edges])
    parts = component_colours(found)
    return {
        "motifs": [
            {
                **_motif(dataset, motif, notes, by_clip),
                "part": parts[motif.id],
                "place": places[i].tolist(),
                "size": sizes[i].round(1).tolist(),
                "icon": _icon(dataset, motif),
            }
            for i, motif in enumerate(found.motifs)
        ],
        "edges": [[e.source, e.target, e.count, edge_width(e.count)] for e in found.edges],
    }


def motif_table(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``motifs`` with a filmstrip each, those with most motions first."""
    found = motif_graph(workspace, dataset.name, view)
    if found is None:
        return None
    notes, by_clip = motif_notes(workspace, dataset.name, view), labels_by_clip(dataset)
    ordered = sorted(found.motifs, key=lambda motif: (-motif.n_motions, motif.id))
    return {
        "motifs": [
            {
                **_motif(dataset, motif, notes, by_clip),
                "clips": len({segment.clip for segment in motif.segments}),
                "note": notes[motif.id].note if motif.id in notes else "",
                "strip": segment_filmstrip(dataset, motif.segments[motif.medoid]),
            }
            for motif in ordered[:MOST_STRIPS]
        ],
        "more": max(0, len(ordered) - MOST_STRIPS),
    }


def matrix(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """What follows what: ``motifs`` in order, with the label of most of each;
    ``cells``: [row, column, count] by their places in it."""
    found = motif_graph(workspace, dataset.name, view)
    if found is None:
        return None
    notes, by_clip = motif_notes(workspace, dataset.name, view), labels_by_clip(dataset)
    order = [motif for part in found.components("weak") for motif in part]
    by_id, at = {motif.id: motif for motif in found.motifs}, {motif: k for k, motif in enumerate(order)}
    return {
        "motifs": [_motif(dataset, by_id[motif], notes, by_clip) for motif in order],
        "cells": sorted([at[e.source], at[e.target], e.count] for e in found.edges),
    }


def numbers(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``figures``: [name, value as text, unit, explanation]; those that ``options`` name, in its order, or USUAL."""
    known = {"clips": len(dataset.clips), "seconds": dataset.seconds, "labels": len(dataset.labels)}
    found = motif_graph(workspace, dataset.name, view)
    if found is not None:
        known |= dict(found.metrics) | {"coverage": 100 * found.metrics["coverage"]}
    wanted = [name.strip() for name in options.get("figures", "").split(",") if name.strip()] or list(USUAL)
    shown = [(FIGURES[name], known[name]) for name in wanted if name in FIGURES and name in known]
    return {"figures": [[name, f"{value:,.{digits}f}", unit, words] for (name, unit, digits, words), value in shown]}


def segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """The motions of a content: first the most typical of each motif, then the second of each, and so on."""
    motions = [[motif["medoid"], *motif["motions"]] for motif in content["motifs"]]
    for k in range(max(map(len, motions), default=0)):
        yield from (tuple(own[k]) for own in motions if k < len(own))


def _motif(
    dataset: Dataset, motif: Motif, notes: Mapping[int, MotifNote], by_clip: dict[str, list[Label]]
) -> dict[str, Any]:
    """What all blocks say of a motif; ``label``: of most of it."""
    rates = {clip.name: clip.fps for clip in dataset.clips}
    seconds = sum(segment.n_frames / rates[segment.clip] for segment in motif.segments) / motif.n_motions
    return {
        "id": motif.id,
        "name": motif_name(motif.id, notes),
        "colour": motif_colour(motif.id),
        "count": motif.n_motions,
        "seconds": round(seconds, 2),
        "label": majority_label(motif.segments, by_clip),
        **_motions(motif),
    }


def _motions(motif: Motif) -> dict[str, Any]:
    """Those that play together; warps in whole frames, as the Stage takes them."""
    shown = shown_motions(motif)
    return {
        "medoid": list(motif.segments[motif.medoid]),
        "motions": [list(motif.segments[k]) for k in shown],
        "warps": [motif.warps[k].round().astype(int).tolist() for k in shown] if motif.warps else [],
    }


def _icon(dataset: Dataset, motif: Motif) -> str:
    clip, start, end = motif.segments[motif.medoid]
    return page_icon(dataset, clip, (start + end) // 2)
