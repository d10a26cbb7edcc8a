"""Which motifs of a large graph are drawn: as many as one can read. The table below lists them all."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from heapq import heappop, heappush
from typing import Any

from core.motifs.graph import MotifGraph
from webapp.shell.results import find_edge

MOST = 120  # motifs that are drawn at once
NEAR = 50  # motifs that are drawn around a chosen one
MOST_EDGES = 200  # successions that are drawn at once: those seen most often
LARGEST, AROUND = "largest", "around"
_LISTED = 30  # components to choose from


def is_large(graph: MotifGraph) -> bool:
    """Whether only a part of the graph is drawn."""
    return len(graph.motifs) > MOST


def choices(graph: MotifGraph) -> list[dict[str, str]]:
    """The parts that one can choose, for a select."""
    parts = [component for component in graph.components("weak") if len(component) > 1][:_LISTED]
    several = [
        {"value": f"c{k}", "label": f"Component {k + 1}: {len(component):,} motifs"}
        for k, component in enumerate(parts)
    ]
    first = [{"value": LARGEST, "label": "The largest motifs"}, {"value": AROUND, "label": "Around the chosen motif"}]
    return first + (several if len(parts) > 1 else [])


def words_of(graph: MotifGraph, drawn: Collection[int]) -> str:
    """How many motifs are drawn, of how many."""
    return f"{len(drawn):,} of {len(graph.motifs):,}"


def chosen_motif(graph: MotifGraph, selection: Mapping[str, Any] | None) -> int | None:
    """The motif that a selection is about; that from which a chosen succession comes."""
    selection = selection or {}
    ids = {motif.id for motif in graph.motifs}
    if "motif" in selection:
        return int(selection["motif"]) if int(selection["motif"]) in ids else None
    edge = find_edge(graph, str(selection["edge"])) if "edge" in selection else None
    return edge.source if edge else None


def ids_of_part(graph: MotifGraph, part: str, centre: int | None) -> frozenset[int]:
    """The motifs of a part: those with most frames of all, of a component, or those nearest to ``centre``."""
    if not is_large(graph):
        return frozenset(motif.id for motif in graph.motifs)
    if part == AROUND and centre is not None:
        return _nearest(graph, centre)
    within = {motif.id for motif in graph.motifs}
    number = int(part[1:]) if part[:1] == "c" and part[1:].isdigit() else -1
    components = graph.components("weak")
    if 0 <= number < len(components):
        within = set(components[number])
    sizes = {motif.id: motif.n_motions * motif.mean_frames for motif in graph.motifs if motif.id in within}
    return frozenset(sorted(sizes, key=lambda motif: -sizes[motif])[:MOST])


def part_of(graph: MotifGraph, ids: frozenset[int]) -> MotifGraph:
    """The graph with these motifs alone, and the successions between them that were seen most often."""
    if len(ids) == len(graph.motifs):
        return graph
    edges = [edge for edge in graph.edges if edge.source in ids and edge.target in ids]
    often = {id(edge) for edge in sorted(edges, key=lambda edge: -edge.count)[:MOST_EDGES]}
    return replace(
        graph,
        motifs=tuple(motif for motif in graph.motifs if motif.id in ids),
        edges=tuple(edge for edge in edges if id(edge) in often),
    )


def _nearest(graph: MotifGraph, centre: int) -> frozenset[int]:
    """Motifs in the order of their distance along successions, which are the shorter the more often they were seen."""
    beside: dict[int, list[tuple[int, int]]] = {}
    for edge in graph.edges:
        beside.setdefault(edge.source, []).append((edge.target, edge.count))
        beside.setdefault(edge.target, []).append((edge.source, edge.count))
    found: set[int] = set()
    waiting = [(0.0, centre)]
    while waiting and len(found) < NEAR:
        distance, motif = heappop(waiting)
        if motif not in found:
            found.add(motif)
            for other, count in beside.get(motif, ()):
                heappush(waiting, (distance + 1 + 1 / count, other))
    return frozenset(found)
