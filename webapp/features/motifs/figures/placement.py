"""Places the boxes of a graph without overlaps, neighbours about one length apart, others as far as the graph says."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.linalg import cho_factor, cho_solve
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, shortest_path
from scipy.spatial.distance import cdist

Edges = Sequence[tuple[int, int]]


def place_boxes(sizes: np.ndarray, edges: Edges, gap: float = 28.0, aspect: float = 1.5) -> np.ndarray:
    """Centres ``(n, 2)`` in pixels, y down, of boxes of ``sizes (n, 2)`` so that no two come closer than ``gap``.

    edges: (source, target). Each connected part is laid out by itself; the parts then stand in rows, largest
    first, together about ``aspect`` times as wide as high. Deterministic: the same graph is always drawn the same way.
    """
    sizes = np.asarray(sizes, float).reshape(-1, 2)
    centres = np.zeros((len(sizes), 2))
    parts = _parts(len(sizes), edges)
    frames = np.zeros((len(parts), 2))
    for k, part in enumerate(parts):
        at = {node: i for i, node in enumerate(part)}
        inner = [(at[s], at[t]) for s, t in edges if s in at and s != t]
        wide = sizes[part] + gap
        local = spread(_turned(_layout(wide, inner), wide, aspect), wide) if len(part) > 1 else np.zeros((1, 2))
        low, high = (local - sizes[part] / 2).min(0), (local + sizes[part] / 2).max(0)
        centres[part], frames[k] = local - low, high - low
    corners = _rows(frames + gap, aspect) if len(parts) else frames
    for part, corner in zip(parts, corners, strict=True):
        centres[part] += corner
    return np.round(centres - (centres.min(0) + centres.max(0)) / 2, 1) if len(centres) else centres


def _parts(n: int, edges: Edges) -> list[np.ndarray]:
    """Nodes of each connected part, the largest part first."""
    ends = np.array(edges, np.int32).reshape(-1, 2)
    links = csr_array((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(n, n))
    count, part_of = connected_components(links, directed=False)
    parts = [np.nonzero(part_of == k)[0] for k in range(count)]
    return sorted(parts, key=lambda part: (-len(part), part[0]))


def _layout(sizes: np.ndarray, edges: Edges, rounds: int = 200) -> np.ndarray:
    """Centres ``(n, 2)`` of the boxes of a connected graph whose distances are like those along the edges.

    Weighted stress majorisation (E. Gansner, Y. Koren, S. North, *Graph Drawing by Stress Majorization*, 2004), from
    classical scaling as its start.
    """
    apart = _graph_distances(sizes, edges)
    weights = (apart + np.eye(len(apart))) ** -2 - np.eye(len(apart))
    pull, factor = weights * apart, cho_factor((np.diag(weights.sum(1)) - weights)[1:, 1:])
    centres = _classical_scaling(apart)
    for _ in range(rounds):
        ratio = pull / np.maximum(cdist(centres, centres), 1e-6)
        target = ratio.sum(1)[:, None] * centres - ratio @ centres
        moved = np.concatenate([np.zeros((1, 2)), cho_solve(factor, target[1:])])  # the first box stays where it is
        change, centres = np.abs(moved - centres).max(), moved
        if change < 0.05:
            break
    return centres


def _graph_distances(sizes: np.ndarray, edges: Edges) -> np.ndarray:
    """Lengths ``(n, n)`` of the shortest ways along the edges; those between busy boxes are longer, to make room."""
    ends = np.array(sorted({(min(edge), max(edge)) for edge in edges}), np.int32)
    degrees = np.bincount(ends.ravel())
    lengths = 1.1 * sizes.mean() * np.sqrt(np.maximum(degrees[ends].min(1) / 2, 1))
    links = csr_array((lengths, ends.T), shape=(len(sizes), len(sizes)))
    return shortest_path(links, directed=False)


def _classical_scaling(apart: np.ndarray) -> np.ndarray:
    """Points ``(n, 2)``, the first at 0, whose distances come near those of ``apart (n, n)``, in one step."""
    squares = apart**2
    centred = squares.mean(0) + squares.mean(1)[:, None] - squares.mean() - squares
    values, vectors = np.linalg.eigh(centred / 2)
    points = vectors[:, :-3:-1] * np.sqrt(np.maximum(values[:-3:-1], 0))
    # boxes that are alike to the graph, such as the leaves of a star, need places of their own to part from
    turns = np.arange(len(apart)) * np.pi * (3 - np.sqrt(5))
    points += 0.05 * apart.mean() * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return points - points[0]


def _turned(centres: np.ndarray, sizes: np.ndarray, aspect: float) -> np.ndarray:
    """Centres ``(n, 2)`` turned so that they fit the smallest frame ``aspect`` times as wide as high."""

    def height(places: np.ndarray) -> float:
        sides = (places + sizes / 2).max(0) - (places - sizes / 2).min(0)
        return float((sides / (aspect, 1)).max())

    turns = np.linspace(0, np.pi, 48, endpoint=False)
    return min((centres @ [[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]] for a in turns), key=height)


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
