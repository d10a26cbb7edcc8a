"""The motif graph as Cytoscape elements: boxes as in the paper, wide for long motions, high for many of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from core.motifs.graph import Edge, Motif, MotifGraph
from webapp.features.motifs.figures.placement import place_boxes
from webapp.shell import theme

MANY_EDGES = 150  # from here on rare successions start hidden
_SMALLEST, _LARGEST = 46.0, 150.0  # sides of a box, pixels

Element = dict[str, Any]


def box_sizes(motifs: Sequence[Motif]) -> np.ndarray:
    """Width from mean frames a motion, height from the number of motions: ``(n, 2)`` pixels."""
    if not motifs:
        return np.zeros((0, 2))
    raw = np.array([(motif.mean_frames, motif.n_motions) for motif in motifs], float)
    return _SMALLEST + (_LARGEST - _SMALLEST) * raw / raw.max(axis=0)


def graph_elements(graph: MotifGraph, icons: Mapping[int, Mapping[str, str]]) -> list[Element]:
    """Nodes and edges with stable ids (``m3``, ``e3-5``). ``icons``: motif id -> theme -> image address."""
    at = {motif.id: i for i, motif in enumerate(graph.motifs)}
    sizes = box_sizes(graph.motifs)
    places = place_boxes(sizes, [(at[e.source], at[e.target]) for e in graph.edges])
    colours, loops = component_colours(graph), _in_loops(graph)
    nodes = [
        {
            "data": {
                "id": f"m{motif.id}",
                "motif": motif.id,
                "label": f"{motif.id} · {motif.n_motions}×",
                "width": round(float(sizes[i, 0]), 1),
                "height": round(float(sizes[i, 1]), 1),
                "colour": colours[motif.id],
                **{f"icon_{name}": address for name, address in icons.get(motif.id, {}).items()},
            },
            "position": {"x": float(places[i, 0]), "y": float(places[i, 1])},
            "classes": "" if motif.id in loops else "one-way",
        }
        for i, motif in enumerate(graph.motifs)
    ]
    edges = [
        {
            "data": {
                "id": f"e{edge.source}-{edge.target}",
                "edge": f"{edge.source}-{edge.target}",
                "source": f"m{edge.source}",
                "target": f"m{edge.target}",
                "count": edge.count,
                "width": edge_width(edge.count),
            },
            **_loop(edge, sizes[at[edge.source]]),
        }
        for edge in graph.edges
    ]
    return nodes + edges


def _loop(edge: Edge, size: np.ndarray) -> dict[str, Any]:
    """The edge of a motif that follows itself, drawn as a loop outside its box."""
    return {"classes": f"loop loop-{math.ceil(size.max() / 40)}"} if edge.source == edge.target else {}


def edge_width(count: int) -> float:
    """Pixels: grows with the square root of the count, at most 9."""
    return round(min(9.0, 1.0 + 1.4 * (math.sqrt(count) - 1)), 2)


def component_colours(graph: MotifGraph) -> dict[int, str]:
    """Motif id -> colour of the part it belongs to: the largest has the first; those that stand alone are grey."""
    return {
        motif: theme.COMPONENTS[i % len(theme.COMPONENTS)] if len(ids) > 1 or i == 0 else theme.ALONE
        for i, ids in enumerate(graph.components("weak"))
        for motif in ids
    }


def _in_loops(graph: MotifGraph) -> set[int]:
    """Motifs that can be reached again from themselves."""
    loops = {motif for ids in graph.components("strong") if len(ids) > 1 for motif in ids}
    return loops | {edge.source for edge in graph.edges if edge.source == edge.target}


def counts_of(elements: Iterable[Mapping[str, Any]]) -> list[int]:
    """How often each drawn edge was seen."""
    return [element["data"]["count"] for element in elements if "count" in element["data"]]


def first_threshold(counts: Sequence[int], most: int = MANY_EDGES) -> int:
    """Smallest count to show at first: 1, or the count above which about ``most`` edges remain."""
    if len(counts) <= most:
        return 1
    ranked = sorted(counts, reverse=True)
    return min(ranked[most - 1] + (ranked[most] == ranked[most - 1]), ranked[0])


def stylesheet(name: str) -> list[dict[str, Any]]:
    """How nodes and edges look in the theme ``name`` ("light" or "dark")."""
    c = theme.CANVAS[name]
    font = "system-ui, -apple-system, Segoe UI, Roboto, Noto Sans, Liberation Sans, Arial, sans-serif"
    return [
        {
            "selector": "node",
            "style": {
                "shape": "round-rectangle",
                "width": "data(width)",
                "height": "data(height)",
                "background-color": c["surface"],
                "background-image": f"data(icon_{name})",
                "background-fit": "contain",
                "background-clip": "node",
                "background-width": "86%",
                "background-height": "86%",
                "border-width": 2,
                "border-color": "data(colour)",
                "label": "data(label)",
                "font-family": font,
                "font-size": 12,
                "color": c["text"],
                "text-valign": "bottom",
                "text-margin-y": 4,
                "text-background-color": c["page"],
                "text-background-opacity": 0.85,
                "text-background-padding": "1px",
                "min-zoomed-font-size": 7,
                "overlay-opacity": 0,
            },
        },
        {"selector": "node.one-way", "style": {"border-style": "dashed"}},
        {
            "selector": "node.rated",
            "style": {
                "label": "data(rated)",
                "outline-width": 5,
                "outline-offset": 3,
                "outline-color": f"mapData(stability, 0, 1, {theme.STABILITY[0]}, {theme.STABILITY[1]})",
                "text-margin-y": 11,
            },
        },
        {
            "selector": "edge",
            "style": {
                "width": "data(width)",
                "line-color": c["line"],
                "target-arrow-color": c["line"],
                "target-arrow-shape": "triangle",
                "arrow-scale": 1.0,
                "curve-style": "bezier",
                "control-point-step-size": 34,
                "loop-sweep": "-38deg",
                "opacity": 0.85,
                "overlay-opacity": 0,
            },
        },
        *(
            {
                "selector": f"edge.loop-{k}",
                "style": {"control-point-step-size": 24 * k + 26, "loop-direction": "-45deg"},
            }
            for k in range(1, 5)
        ),
        {"selector": "edge.rare", "style": {"display": "none"}},
        {"selector": ".faded", "style": {"opacity": 0.38}},
        {"selector": ".unmatched", "style": {"opacity": 0.12}},
        {
            "selector": "node.near",
            "style": {"border-width": 3, "opacity": 1},
        },
        {
            "selector": "node.chosen",
            "style": {
                "border-width": 5,
                "border-color": c["accent"],
                "border-style": "solid",
                "opacity": 1,
                "font-weight": 700,
            },
        },
        {
            "selector": "edge.near, edge.chosen",
            "style": {
                "opacity": 1,
                "label": "data(count)",
                "font-family": font,
                "font-size": 12,
                "color": c["text"],
                "text-background-color": c["page"],
                "text-background-opacity": 0.9,
                "text-background-padding": "2px",
            },
        },
        {
            "selector": "edge.chosen",
            "style": {
                "line-color": c["accent"],
                "target-arrow-color": c["accent"],
                "z-index": 9,
            },
        },
        # what is pointed at or chosen, in letters that assets/motifs/graph.mjs keeps readable from afar
        {
            "selector": "node.readable",
            "style": {"font-size": "data(letters)", "min-zoomed-font-size": 0, "z-index": 10},
        },
        {"selector": "edge.readable[count]", "style": {"font-size": "data(letters)", "z-index": 9}},
        *walk_styles(c),
    ]


def walk_styles(c: Mapping[str, str]) -> list[dict[str, Any]]:
    """What a walk marks (assets/motifs/walk_graph.mjs): its way, the motif that plays, dead ends, further links."""
    return [
        {
            "selector": "edge.further",
            "style": {
                "label": "",
                "line-style": "dashed",
                "line-dash-pattern": [8, 5],
                "line-color": c["accent"],
                "target-arrow-color": c["accent"],
                "opacity": 0.9,
            },
        },
        {"selector": "node.walked", "style": {"border-color": c["accent"], "border-width": 4}},
        {
            "selector": "node.dead-end",
            "style": {"border-color": theme.DEAD_END, "border-style": "double", "border-width": 6},
        },
        {
            "selector": "edge.walked",
            "style": {"line-color": c["accent"], "target-arrow-color": c["accent"], "opacity": 1, "z-index": 8},
        },
        {
            "selector": "node.lit",
            "style": {
                "border-color": c["accent"],
                "border-width": 5,
                "overlay-color": c["accent"],
                "overlay-opacity": 0.22,
                "overlay-padding": 6,
                "opacity": 1,
            },
        },
    ]


def legend(graph: MotifGraph) -> str:
    """What the colours and borders mean in this graph."""
    parts = sum(len(ids) > 1 for ids in graph.components("weak"))
    loops = _in_loops(graph)
    words = "Wide boxes: long motions. High boxes: many motions. Arrows: what follows what."
    if parts > 1:
        words += " Colours: parts that never meet."
    if len(loops) < len(graph.motifs):
        words += " Dashed: no way back."
    return words


def icon_addresses(graph: MotifGraph, draw: Callable[[Any, str], str]) -> dict[int, dict[str, str]]:
    """Images for all motifs and themes: ``draw(segment, theme)`` gives the address of one."""
    return {
        motif.id: {name: draw(motif.segments[motif.medoid], name) for name in theme.CANVAS} for motif in graph.motifs
    }
