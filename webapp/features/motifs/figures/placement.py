"""Where the boxes of a graph go: Graphviz's sfdp for the shape, then our own removal of overlaps.

sfdp is the layout that stays readable on cyclic graphs; the Graphviz that comes with pygraphviz has no triangulation,
so it cannot remove overlaps itself.
"""

from __future__ import annotations

import ctypes
import logging
import threading
from collections.abc import Sequence
from contextlib import suppress

import numpy as np
import pygraphviz
from pygraphviz import _graphviz as graphviz
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

log = logging.getLogger(__name__)

_GRAPHVIZ = threading.Lock()  # cgraph keeps global state; threads of the server must take turns
_POINTS_PER_INCH = 72.0


def place_boxes(
    sizes: np.ndarray, edges: Sequence[tuple[int, int, float]], gap: float = 28.0, aspect: float = 1.5
) -> np.ndarray:
    """Centres ``(n, 2)`` in pixels, y down, of boxes of ``sizes (n, 2)`` so that no two come closer than ``gap``.

    edges: (source, target, weight). Each connected part is laid out by itself; the parts then stand in rows, largest
    first, together about ``aspect`` times as wide as high. Deterministic: the same graph is always drawn the same way.
    """
    sizes = np.asarray(sizes, float).reshape(-1, 2)
    centres = np.zeros((len(sizes), 2))
    parts = _parts(len(sizes), edges)
    frames = np.zeros((len(parts), 2))
    for k, part in enumerate(parts):
        at = {node: i for i, node in enumerate(part)}
        inner = [(at[s], at[t], w) for s, t, w in edges if s in at and s != t]
        local = spread(_sfdp(sizes[part], inner), sizes[part] + gap) if len(part) > 1 else np.zeros((1, 2))
        low, high = (local - sizes[part] / 2).min(0), (local + sizes[part] / 2).max(0)
        centres[part], frames[k] = local - low, high - low
    corners = _rows(frames + gap, aspect) if len(parts) else frames
    for part, corner in zip(parts, corners, strict=True):
        centres[part] += corner
    return np.round(centres - (centres.min(0) + centres.max(0)) / 2, 1) if len(centres) else centres


def _parts(n: int, edges: Sequence[tuple[int, int, float]]) -> list[np.ndarray]:
    """Nodes of each connected part, the largest part first."""
    ends = np.array([(source, target) for source, target, _ in edges], int).reshape(-1, 2)
    links = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(n, n))
    count, part_of = connected_components(links, directed=False)
    parts = [np.nonzero(part_of == k)[0] for k in range(count)]
    return sorted(parts, key=lambda part: (-len(part), part[0]))


def _sfdp(sizes: np.ndarray, edges: Sequence[tuple[int, int, float]]) -> np.ndarray:
    with _GRAPHVIZ:
        _seed_c_library()
        _hear_graphviz()
        graph = pygraphviz.AGraph(directed=False, strict=True, overlap="true", K=str(_ideal_length(sizes)), start="1")
        for i, (width, height) in enumerate(sizes / _POINTS_PER_INCH):
            graph.add_node(i, label="", shape="box", fixedsize="true", width=f"{width:.3f}", height=f"{height:.3f}")
        for source, target, weight in edges:
            if source != target:
                graph.add_edge(source, target, weight=f"{1 + np.log1p(weight):.3f}")
        graph.layout(prog="sfdp")
        places = [graph.get_node(i).attr["pos"].split(",") for i in range(len(sizes))]
    x, y = np.array(places, float).T
    return np.stack([x, -y], axis=1)


def _seed_c_library() -> None:
    """sfdp's coarsening draws from the C library's rand() before it takes its own seed; Windows keeps its own way."""
    with suppress(OSError, AttributeError, TypeError):
        ctypes.CDLL(None).srand(1)


_said: list[bytes] = []


def _heard(piece: bytes) -> int:
    """Takes a message in the pieces it comes in."""
    _said.append(piece)
    if piece.endswith(b"\n"):
        words = b"".join(_said).decode(errors="replace").strip()
        _said.clear()
        if "triangulation" not in words:  # it cannot remove overlaps; we do that
            log.warning("Graphviz: %s", words)
    return 0


_HEARD = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_char_p)(_heard)  # lives as long as Graphviz may call it


def _hear_graphviz() -> None:
    """What Graphviz would write to stderr comes to us; where its library cannot be reached it goes on as it was."""
    with suppress(OSError, AttributeError, TypeError):
        ctypes.CDLL(graphviz.__file__).agseterrf(_HEARD)


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
    order = np.lexsort((centres[:, 0], centres[:, 1]))
    placed = np.empty_like(centres)  # the last resort, which always ends without overlaps: plain rows
    placed[order] = _rows(2 * half[order], 1.0) + half[order]
    return placed


def _rows(sizes: np.ndarray, aspect: float) -> np.ndarray:
    """Upper left corners ``(n, 2)`` of boxes set in rows one after another, about ``aspect`` times as wide as high."""
    least, area = float(sizes[:, 0].max()), float(sizes.prod(axis=1).sum())
    widths = np.maximum(np.sqrt(area * aspect) * np.linspace(0.9, 2.4, 16), least)
    tried = [_rows_of(sizes, width) for width in widths]
    return min(tried, key=lambda corners: ((corners + sizes).max(axis=0) / (aspect, 1.0)).max())


def _rows_of(sizes: np.ndarray, width: float) -> np.ndarray:
    corners, x, y, tallest = np.empty_like(sizes), 0.0, 0.0, 0.0
    for i, (w, h) in enumerate(sizes):
        if x > 0 and x + w > width:
            x, y, tallest = 0.0, y + tallest, 0.0
        corners[i] = x, y
        x, tallest = x + w, max(tallest, h)
    return corners
