"""The motif graph that a view shows, which most pages ask for: the graph, its motifs, and people's notes on them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from core.motifs.graph import Edge, Motif, MotifGraph
from core.workspace import MotifNote, Workspace
from webapp.shell import settings

MOTIFS = "motifs"  # the name of their settings in links


def motif_graph(workspace: Workspace, dataset: str | None, view: Mapping[str, Any] | None) -> MotifGraph | None:
    """The graph if it has been computed; kept in memory, so that it is not read again for every click."""
    return settings.result_of(workspace, MOTIFS, dataset, view)


def motif_graph_key(workspace: Workspace, dataset: str | None, view: Mapping[str, Any] | None) -> str | None:
    """Key of the graph where it is stored and this version can use it, else None."""
    return settings.key_of(workspace, MOTIFS, dataset, view)


def shown_graph(
    workspace: Workspace, key: str | None, dataset: str | None, view: Mapping[str, Any] | None
) -> MotifGraph | None:
    """The graph with this key where it is the one that ``view`` shows; None while a page has yet to learn of another.

    For callbacks that start with any change of the view: settings change there first, the key follows.
    """
    return motif_graph(workspace, dataset, view) if key and key == motif_graph_key(workspace, dataset, view) else None


def motif_notes(workspace: Workspace, dataset: str, view: Mapping[str, Any] | None) -> dict[int, MotifNote]:
    """People's notes on the motifs of this result, by motif id; empty where there is no result."""
    graph, key = motif_graph(workspace, dataset, view), motif_graph_key(workspace, dataset, view)
    if graph is None or key is None:
        return {}
    return workspace.notes.of(workspace.info(dataset).id, key, {motif.id: motif.segments for motif in graph.motifs})


def find_motif(graph: MotifGraph, number: Any) -> Motif | None:
    """The motif with this id, or None."""
    return next((motif for motif in graph.motifs if str(motif.id) == str(number)), None)


def find_motifs(graph: MotifGraph, selection: Mapping[str, Any]) -> list[Motif]:
    """The motifs that a selection names, one or several; without those that do not exist."""
    numbers = set(str(selection.get("motifs", selection.get("motif", ""))).split("-"))
    return [motif for motif in graph.motifs if str(motif.id) in numbers]


def find_edge(graph: MotifGraph, name: Any) -> Edge | None:
    """The edge called ``"source-target"``, or None."""
    return next((edge for edge in graph.edges if f"{edge.source}-{edge.target}" == str(name)), None)
