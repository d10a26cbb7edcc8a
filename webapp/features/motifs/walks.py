"""Walks in the app: how a link describes one, the walk itself, and what the browser needs to show it.

``~walk~KEY`` holds the clip ``walk``; KEY is that of the walk's result (webapp/shell/virtual.py).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from itertools import groupby
from typing import Any

from core import analyses
from core.caching import RecentCache
from core.errors import MotionscapeError, ParameterError
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.synthesis import NoWay, Walk, Ways, open_ways
from core.synthesis.links import FURTHER, SEEN
from core.workspace import Workspace, WorkspaceError
from webapp.shell import recipes, results, settings
from webapp.shell.errors import sentence
from webapp.shell.virtual import virtual_name
from webapp.ui.timeline import motif_colour

WALK = "walk"
CLIP = "walk"
KEYS = ("walk", "extra", "gaps", "ends", "feet")  # of the link that say which walk it is


def walk_request(dataset: str, view: Mapping[str, str]) -> analyses.Request:
    """The request behind a link: the motif graph's parameters, and the walk's (see KEYS)."""
    return analyses.Request(
        dataset,
        WALK,
        {
            **settings.request_of(results.MOTIFS, dataset, view).parameters,
            "path": view.get("walk", ""),
            "further": view.get("extra") == "1",
            "gaps": view.get("gaps", "refuse"),
            "dead_end": "stop" if view.get("ends") == "stop" else "jump",
            "keep_feet": view.get("feet") != "0",
        },
    )


def open_walk(workspace: Workspace, key: str) -> Dataset:
    """The made-up data set of a kept walk. Raises WorkspaceError where there is none."""
    walk = analyses.kept(workspace, WALK, key) if re.fullmatch(r"[0-9a-f]{8,64}", key) else None
    if walk is None:
        raise WorkspaceError("This walk is no longer there; make it again on the Motifs page.")
    return Dataset(virtual_name(WALK, key), (walk.clip,))


def link_keys_of(view: Mapping[str, str] | None) -> dict[str, str]:
    """The keys of a link that say which walk it is."""
    return {key: text for key in KEYS if (text := (view or {}).get(key))}


def walk_data(
    workspace: Workspace,
    dataset: Dataset,
    graph: MotifGraph,
    graph_key: str,
    view: Mapping[str, str],
    names: Mapping[int, str],
) -> dict[str, Any]:
    """All that assets/motifs/walk.mjs shows: the ways of the graph, and the walk or why there is none.

    names: people's names of motifs.
    """
    link_values = link_keys_of(view)
    data = {"key": graph_key, "inputs": link_values, "dataset": dataset.name, "motifs": _motifs(graph, names)}
    if not graph.motifs:
        return data | {"error": "This graph has no motifs to walk through."}
    data |= ways_data(_ways(dataset, graph, graph_key, link_values.get("extra") == "1"))
    if not link_values.get("walk"):
        return data
    try:
        request = analyses.normalise(walk_request(dataset.name, view))
    except ParameterError as error:
        return data | {"error": sentence(error)}
    try:
        walk = analyses.result_now(workspace, request)
        again = {"recipes": recipes.texts(workspace.path, request)}
        return data | shown_walk(walk, analyses.key(workspace, request), names) | again
    except MotionscapeError as error:
        refused = {"error": sentence(error), "path": _listed(link_values["walk"])}
        if isinstance(error, NoWay):
            refused |= {"gap": [error.source, error.target], "detour": list(error.detour or ())}
        return data | refused


def ways_data(ways: Ways) -> dict[str, Any]:
    """Dead ends, parts that reach one another, and further links."""
    return {
        "dead": list(ways.dead_ends),
        "parts": [len(part) for part in ways.components],
        "further": [list(ends) for ends, links in ways.links.items() if links[0].kind == FURTHER],
    }


def shown_walk(walk: Walk, key: str, names: Mapping[int, str]) -> dict[str, Any]:
    """The walk itself: its path, the frames of each motif, its quality, and the name of its data set."""
    return {
        "name": virtual_name(WALK, key),
        "path": list(walk.path),
        "kinds": [link.kind for link in walk.links],
        "visits": visit_spans(walk),
        "frames": walk.clip.n_frames,
        "seconds": round(walk.clip.seconds, 2),
        "blends": len(walk.seams),
        "skate": [round(value, 4) for value in walk.skate],
        "speeds": [round(value, 2) for value in walk.speeds],
        "jump": walk.speeds.jump,
        "warnings": list(walk.warnings),
        "bands": bands(walk, names),
        "unseen": sum(kind != SEEN for kind in (link.kind for link in walk.links)),
    }


def visit_spans(walk: Walk) -> list[list[int]]:
    """First frame and one past the last of every motif on the path; empty at the same frame where none is its own."""
    spans: dict[int, list[int]] = {}
    for part in walk.parts:
        if part.visit >= 0:
            spans.setdefault(part.visit, [part.start, part.end])[1] = part.end
    found, last = [], 0
    for visit in range(len(walk.path)):
        found.append(spans.get(visit, [last, last]))
        last = found[-1][1]
    return found


def bands(walk: Walk, names: Mapping[int, str]) -> list[dict[str, Any]]:
    """Coloured spans for the Stage, one for each stretch of a motif; transitions have none."""
    runs = []
    for motif, group in groupby(walk.parts, key=lambda part: part.motif):
        parts = list(group)
        if motif >= 0:
            colour = motif_colour(motif)
            label = names.get(motif) or f"Motif {motif}"
            runs.append({"start": parts[0].start, "end": parts[-1].end, "colour": colour, "label": label})
    return runs


def _motifs(graph: MotifGraph, names: Mapping[int, str]) -> list[dict[str, Any]]:
    return [{"id": motif.id, "name": names.get(motif.id, "")} for motif in graph.motifs]


def _ways(dataset: Dataset, graph: MotifGraph, graph_key: str, further: bool) -> Ways:
    """The ways of a graph, cached because further links take a moment to find."""
    return _recent_ways.get_or_compute((graph_key, further), lambda: open_ways(dataset, graph, further))


def _listed(text: str) -> list[int]:
    """The motifs of a path that names them, for people to mend it."""
    return [int(number) for number in text.split("-")] if re.fullmatch(r"\d{1,6}(-\d{1,6})*", text) else []


_recent_ways: RecentCache[tuple[str, bool], Ways] = RecentCache(8)
