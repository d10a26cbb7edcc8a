"""The motif graph as Cytoscape draws it, cached for each result, because layout and icons take time."""

from __future__ import annotations

from typing import Any

from core.caching import RecentCache
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from webapp.features.motifs import graph_parts
from webapp.features.motifs.figures import graph as graph_figure
from webapp.ui.filmstrip import icon_data_uri


def graph_elements(
    dataset: Dataset, key: str, graph: MotifGraph, part: str = graph_parts.LARGEST, centre: int | None = None
) -> list[dict[str, Any]]:
    """The Cytoscape elements of a graph, with positions and icons; cached for each result.

    part, centre: of a large graph, see graph_parts.
    """
    ids = graph_parts.ids_of_part(graph, part, centre)

    def draw() -> list[dict[str, Any]]:
        graph = graph_parts.part_of(whole, ids)
        icons = graph_figure.icon_addresses(graph, lambda segment, scheme: icon_data_uri(dataset, segment, scheme))
        return graph_figure.graph_elements(graph, icons)

    whole = graph
    return _drawn.get_or_compute((key, ids), draw)


_drawn: RecentCache[tuple[str, frozenset[int]], list[dict[str, Any]]] = RecentCache(16)  # by the result's key and part
