"""What the Stage plays of motifs: all motions of one, one alone, or the transitions of an edge."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Edge, Motif, MotifGraph
from core.workspace import Workspace
from webapp.shell.feature import Shown
from webapp.shell.names import StageRequest
from webapp.shell.playback import MOST_FIGURES, clip_request, item, overlay
from webapp.shell.results import find_edge, find_motif, find_motifs, motif_graph, motif_notes
from webapp.ui.tables import clock

AROUND = 1.0  # seconds of motion before and after a transition


def plays(workspace: Workspace, dataset: Dataset, shown: Shown) -> StageRequest | None:
    """What plays for a selection of this page; None where there is nothing, or where a view plays it itself."""
    if "motif" in shown.selection and "motion" not in shown.selection and (comparing(shown.view) or mixing(shown.view)):
        return None  # the comparison plays both results (compare_view.py), the mixture itself (assets/motifs/blend)
    graph = motif_graph(workspace, shown.dataset, shown.view)
    notes = motif_notes(workspace, shown.dataset, shown.view) if "motif" in shown.selection else {}
    return stage_request(dataset, graph, shown.selection, {motif: note.name for motif, note in notes.items()})


def missing(workspace: Workspace, shown: Shown) -> str | None:
    """A sentence about what a selection names that does not exist; None where it exists or cannot be checked yet."""
    graph, selection = motif_graph(workspace, shown.dataset, shown.view), shown.selection
    if graph is None:
        return None
    if "motif" in selection and find_motif(graph, selection["motif"]) is None:
        return f"The result shown has no motif {selection['motif']}; it has {len(graph.motifs)} motifs."
    if "motifs" in selection and not find_motifs(graph, selection):
        return f"The result shown has none of the motifs of the link; it has {len(graph.motifs)} motifs."
    if "edge" in selection and find_edge(graph, selection["edge"]) is None:
        return f"In the result shown, no motion leads from motif {str(selection['edge']).replace('-', ' to ')}."
    return None


def stage_request(
    dataset: Dataset,
    graph: MotifGraph | None,
    selection: Mapping[str, Any],
    names: Mapping[int, str] = MappingProxyType({}),
) -> StageRequest | None:
    """What to play for ``selection``, None where it names nothing that exists; names: people's names of motifs."""
    if "clip" in selection:
        return clip_request(dataset, selection)
    if graph is None:
        return None
    if "motif" in selection:
        return _motif(dataset, graph, selection, names)
    return _edge(dataset, graph, selection) if "edge" in selection else None


def shown_motions(motif: Motif, most: int = MOST_FIGURES) -> list[int]:
    """Indices of the motions that play together: all, or the medoid and others spread evenly over the list."""
    n = len(motif.segments)
    if n <= most:
        return list(range(n))
    picked = {motif.medoid, *(round(i * (n - 1) / (most - 1)) for i in range(most))}
    return sorted(picked, key=lambda i: (i != motif.medoid, i))[:most]


def transition_segment(dataset: Dataset, graph: MotifGraph, edge: Edge, number: int) -> Segment:
    """End of the motion before, the frames in between, start of the motion after: one segment of the clip."""
    between = edge.transitions[number]
    source, target = find_motif(graph, edge.source), find_motif(graph, edge.target)
    clip = dataset.clip(between.clip)
    margin = round(AROUND * clip.fps)
    before = [s.start for s in source.segments if s.clip == between.clip and s.end == between.start] if source else []
    after = [s.end for s in target.segments if s.clip == between.clip and s.start == between.end] if target else []
    low, high = min(between.start, between.end), max(between.start, between.end)
    start = max(low - margin, min(before, default=0), 0)
    end = min(high + margin, max(after, default=clip.n_frames), clip.n_frames)
    return Segment(between.clip, start, max(end, start + 1))


def moment(dataset: Dataset, segment: Segment) -> str:
    """Where in its clip a segment lies: ``0:03.2 to 0:04.9``."""
    fps = dataset.clip(segment.clip).fps
    return f"{clock(segment.start / fps)} to {clock(segment.end / fps)}"


def comparing(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page compares the result with another: a motif then plays beside its partners there."""
    return (view or {}).get("view") == "compare" and bool((view or {}).get("other"))


def mixing(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page mixes motions: a motif then plays as its mixture (assets/motifs/blend.mjs)."""
    return (view or {}).get("side") == "blend"


def walking(view: Mapping[str, str] | None) -> bool:
    """Whether the Motifs page makes walks: clicks on motifs are then steps (assets/motifs/walk.mjs)."""
    return (view or {}).get("side") == "walk"


def _motif(
    dataset: Dataset, graph: MotifGraph, selection: Mapping[str, Any], names: Mapping[int, str]
) -> StageRequest | None:
    motif = find_motif(graph, selection["motif"])
    if motif is None:
        return None
    called = names.get(motif.id) or f"Motif {motif.id}"
    alone = selection.get("motion")
    if alone is not None and 0 <= int(alone) < len(motif.segments):
        segment = motif.segments[int(alone)]
        title = f"{called}, motion {int(alone) + 1} of {len(motif.segments)}"
        return overlay(dataset, [item(*segment, segment.clip)], title)
    shown = shown_motions(motif)
    items = [
        item(*motif.segments[i], motif.segments[i].clip, [round(float(f), 2) for f in motif.warps[i]]) for i in shown
    ]
    count = f"{len(shown)} of {len(motif.segments)}" if len(shown) < len(motif.segments) else f"{len(shown)}"
    return overlay(dataset, items, f"{called}: {count} motion{'s' if len(motif.segments) != 1 else ''}")


def _edge(dataset: Dataset, graph: MotifGraph, selection: Mapping[str, Any]) -> StageRequest | None:
    edge = find_edge(graph, selection["edge"])
    if edge is None or not edge.transitions:
        return None
    number = int(selection.get("transition", 0))
    number = number if 0 <= number < len(edge.transitions) else 0
    segment = transition_segment(dataset, graph, edge, number)
    title = f"From motif {edge.source} to {edge.target}, {number + 1} of {len(edge.transitions)}"
    return overlay(dataset, [item(*segment, segment.clip)], title)
