"""Where the boxes of a graph go: Graphviz's sfdp for the shape, then our own removal of overlaps.

sfdp is the layout that stays readable on cyclic graphs; the Graphviz that comes with pygraphviz has no triangulation,
so it cannot remove overlaps itself.
"""

from __future__ import annotations

import threading
import warnings
from collections.abc import Sequence

import numpy as np
import pygraphviz

_GRAPHVIZ = threading.Lock()  # cgraph keeps global state; threads of the server must take turns
_POINTS_PER_INCH = 72.0


def place_boxes(sizes: np.ndarray, edges: Sequence[tuple[int, int, float]], gap: float = 28.0) -> np.ndarray:
    """Centres ``(n, 2)`` in pixels, y down, of boxes of ``sizes (n, 2)`` so that no two come closer than ``gap``.

    edges: (source, target, weight). Deterministic: the same graph is always drawn the same way.
    """
    sizes = np.asarray(sizes, float).reshape(-1, 2)
    if len(sizes) < 2:
        return np.zeros((len(sizes), 2))
    centres = _sfdp(sizes, edges)
    centres = spread(centres, sizes + gap)
    return np.round(centres - (centres.min(0) + centres.max(0)) / 2, 1)


def _sfdp(sizes: np.ndarray, edges: Sequence[tuple[int, int, float]]) -> np.ndarray:
    with _GRAPHVIZ:
        graph = pygraphviz.AGraph(directed=False, strict=True, overlap="true", K=str(_ideal_length(sizes)), start="1")
        for i, (width, height) in enumerate(sizes / _POINTS_PER_INCH):
            graph.add_node(i, shape="box", fixedsize="true", width=f"{width:.3f}", height=f"{height:.3f}")
        for source, target, weight in edges:
            if source != target:
                graph.add_edge(source, target, weight=f"{1 + np.log1p(weight):.3f}")
        with warnings.catch_warnings():  # fontconfig's and sfdp's remarks are nobody's business here
            warnings.simplefilter("ignore", RuntimeWarning)
            graph.layout(prog="sfdp")
        places = [graph.get_node(i).attr["pos"].split(",") for i in range(len(sizes))]
    x, y = np.array(places, float).T
    return np.stack([x, -y], axis=1)


def _ideal_length(sizes: np.ndarray) -> float:
    return round(float(sizes.mean()) * 1.6 / _POINTS_PER_INCH, 3)


def spread(centres: np.ndarray, sizes: np.ndarray, rounds: int = 400) -> np.ndarray:
    """Centres ``(n, 2)`` moved as little as needed so that boxes of ``sizes (n, 2)`` do not overlap.

    Overlapping pairs push each other apart along the axis on which they overlap least; where pushing alone does not
    settle, the whole drawing grows a little and pushing goes on.
    """
    centres = np.array(centres, float)
    half = np.asarray(sizes, float) / 2
    a, b = np.triu_indices(len(centres), 1)
    reach = half[a] + half[b]
    # boxes at one and the same place need a direction to part in
    centres += np.stack([np.arange(len(centres)), -np.arange(len(centres))], 1) * 1e-3
    for step in range(rounds):
        between = centres[b] - centres[a]
        depth = reach - np.abs(between)
        clash = (depth > 0.01).all(1)
        if not clash.any():
            return centres
        push = np.zeros_like(between)
        axis = depth[clash].argmin(1)
        rows = np.nonzero(clash)[0]
        sign = np.where(between[rows, axis] < 0, -1.0, 1.0)
        push[rows, axis] = sign * (depth[rows, axis] / 2 + 0.05)
        np.add.at(centres, a[rows], -push[rows])
        np.add.at(centres, b[rows], push[rows])
        if step % 40 == 39:
            centres = centres.mean(0) + (centres - centres.mean(0)) * 1.1
    return _rows(centres, half * 2)


def _rows(centres: np.ndarray, sizes: np.ndarray) -> np.ndarray:
    """A plain shelf packing in reading order: the last resort that always ends without overlaps."""
    order = np.lexsort((centres[:, 0], centres[:, 1]))
    width = float(np.sqrt((sizes[:, 0] * sizes[:, 1]).sum()) * 1.2)
    placed, x, y, tallest = np.empty_like(centres), 0.0, 0.0, 0.0
    for i in order:
        w, h = sizes[i]
        if x > 0 and x + w > width:
            x, y, tallest = 0.0, y + tallest, 0.0
        placed[i] = x + w / 2, y + h / 2
        x, tallest = x + w, max(tallest, h)
    return placed
