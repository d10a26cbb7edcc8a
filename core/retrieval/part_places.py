"""Where in the clips a query fits: stretches found by the parts and judged by all of them together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.poses.body_parts import leaves_of
from core.retrieval.node_index import NodeIndex, SymbolList
from core.retrieval.part_matching import aligned_pairs, own_share, places, propagate, window_scores

_PROPOSED = 6  # stretches that each node proposes for each hit that is asked for
_LEAST = 40  # and at least so many
_FASTEST = 2.0  # a stretch lasts no longer than so many times the query, nor shorter than by as much
OVERLAP, NEAR = 0.5, 0.8
"""Of two stretches that share more than this of the shorter one the better is kept: in the end, and until verified."""

_ROOM = 0.25  # of a stretch either side, within which its ends are looked for again


@dataclass(frozen=True, eq=False)
class Wanted:
    """A query: node -> list, node -> frames of its stretch; weights of the leaves, alpha and gap of the matching."""

    lists: Mapping[str, SymbolList]
    frames: Mapping[str, int]
    weights: Mapping[str, float]
    alpha: float
    gap: float

    def say(self, node: str) -> float:
        """Weight of a node when the ends of stretches are chosen."""
        leaves = leaves_of(node)
        return own_share(node, self.weights, self.alpha) * sum(self.weights[leaf] for leaf in leaves)


def find_places(
    nodes: Mapping[str, NodeIndex],
    clip_starts: np.ndarray,
    gains: Mapping[str, np.ndarray],
    wanted: Wanted,
    among: np.ndarray,
    top: int,
) -> np.ndarray:
    """At most ``top`` stretches, best first, no two nearly the same: rows ``(k, 3)`` of first frame, end and score.

    Every node proposes the stretches where its own list fits best; all nodes then judge all proposals, as they judge
    whole clips, and the best are fitted once more. clip_starts: ``(n_clips + 1,)`` frames, of all clips one after
    another, as are those given back. gains: node -> ``(m, k)``; among: ``(c,)`` clips that count.
    """
    bounds = np.stack([clip_starts[among], clip_starts[among + 1]], axis=1).astype(float)
    proposals = [
        _proposed(nodes[node], gain, wanted, node, among, bounds, max(_LEAST, _PROPOSED * top))
        for node, gain in gains.items()
        if wanted.say(node) > 0
    ]
    spans = np.unique(np.round(np.concatenate(proposals)).astype(np.int64), axis=0)
    if len(spans) == 0:
        return np.zeros((0, 3))
    judged = _judged(nodes, gains, wanted, spans)
    best = apart(spans, judged, max(10, 2 * top), NEAR)
    fitted = np.stack([_fitted(nodes, gains, wanted, span, clip_starts) for span in spans[best]])
    again = _judged(nodes, gains, wanted, fitted)
    better = again > judged[best]
    spans = np.where(better[:, None], fitted, spans[best])
    scores = np.where(better, again, judged[best])
    kept = apart(spans, scores, top, NEAR)
    return np.column_stack([spans[kept], scores[kept]])


def judged(
    nodes: Mapping[str, NodeIndex],
    gains: Mapping[str, np.ndarray],
    wanted: Wanted,
    windows: Mapping[str, tuple[np.ndarray, np.ndarray]],
) -> np.ndarray:
    """How alike windows of the clips and the query are by all nodes together: ``(n,)``, 0 to 1.

    windows: node -> its ranges of segments, ``(n,)`` first and end. The nodes' scores go through the hierarchy as
    cube roots: what is somewhat alike in all parts comes before what is very much so in some and not in others.
    """
    scores = {
        node: np.cbrt(window_scores(nodes[node].symbols, *windows[node], gain, wanted.gap))
        for node, gain in gains.items()
    }
    return propagate(scores, wanted.weights, wanted.alpha)


def paired_similarity(symbols: np.ndarray, gain: np.ndarray, gap: float, cuts: np.ndarray, frames: int) -> np.ndarray:
    """How alike a stretch is at each of the query's ``frames``: ``(frames,)``, 0 to 1.

    symbols: ``(n,)`` of the stretch; gain: ``(m, k)``; cuts: ``(m + 1,)`` of the query's segments, stretched to
    ``frames`` where they last longer or shorter. A segment without a partner is like nothing.
    """
    similarity = np.zeros(frames)
    edges = np.round(np.asarray(cuts) * frames / cuts[-1]).astype(np.int64)
    for i, j in aligned_pairs(symbols, gain, gap):
        similarity[edges[i] : edges[i + 1]] = max(float(gain[i, symbols[j]]), 0.0)
    return similarity


def _proposed(
    index: NodeIndex, gain: np.ndarray, wanted: Wanted, node: str, among: np.ndarray, bounds: np.ndarray, most: int
) -> np.ndarray:
    """Stretches ``(k, 2)`` in frames where the node's own list fits best."""
    best_places = places(index.symbols, index.starts[among], index.starts[among + 1], gain, wanted.gap)
    score = best_places.score
    # alignments with one beginning are the same, cut short or drawn out: the best end stands for them
    order = np.lexsort((-score, best_places.start))
    first = np.ones(len(order), bool)
    first[1:] = best_places.start[order][1:] != best_places.start[order][:-1]
    ends = order[first & (score[order] > 0)]
    ends = ends[np.argsort(-score[ends], kind="stable")[:most]]
    query = (best_places.query_start[ends], best_places.query_end[ends])
    spans = _projected(index, wanted, node, (best_places.start[ends], ends + 1), query)
    clip = np.searchsorted(bounds[:, 0], index.begins[ends], side="right") - 1
    inside: np.ndarray = np.clip(spans, bounds[clip, :1], bounds[clip, 1:])
    return inside


_Ranges = tuple[np.ndarray, np.ndarray]  # first and last segments


def _projected(index: NodeIndex, wanted: Wanted, node: str, listed: _Ranges, query: _Ranges) -> np.ndarray:
    """Where the whole query lies, ``(k, 2)``, when ranges of its segments lie beside ranges of the node's segments."""
    cuts, frames = wanted.lists[node].cuts, wanted.frames[node]
    first, last = index.begins[listed[0]].astype(float), index.ends[listed[1] - 1].astype(float)
    since, until = cuts[query[0]].astype(float), cuts[query[1]].astype(float)
    rate = np.clip((last - first) / np.maximum(until - since, 1), 1 / _FASTEST, _FASTEST)
    return np.stack([first - rate * since, last + rate * (frames - until)], axis=1)


def _judged(
    nodes: Mapping[str, NodeIndex], gains: Mapping[str, np.ndarray], wanted: Wanted, spans: np.ndarray
) -> np.ndarray:
    windows = {node: nodes[node].windows(spans[:, 0], spans[:, 1]) for node in gains}
    return judged(nodes, gains, wanted, windows)


def _fitted(
    nodes: Mapping[str, NodeIndex],
    gains: Mapping[str, np.ndarray],
    wanted: Wanted,
    span: np.ndarray,
    clip_starts: np.ndarray,
) -> np.ndarray:
    """The stretch ``(2,)`` once more: where the nodes, each on its own, see it, and the middle one of them."""
    clip = int(np.searchsorted(clip_starts, span[0], side="right")) - 1
    room = _ROOM * (span[1] - span[0])
    low, high = max(span[0] - room, clip_starts[clip]), min(span[1] + room, clip_starts[clip + 1])
    seen, say = [], []
    for node, gain in gains.items():
        index, voice = nodes[node], wanted.say(node)
        first, last = (int(k[0]) for k in index.windows(np.array([low]), np.array([high])))
        if voice == 0 or last <= first:
            continue
        best_places = places(index.symbols[first:last], np.array([0]), np.array([last - first]), gain, wanted.gap)
        end = int(best_places.score.argmax())
        if best_places.score[end] > 0:
            listed = (np.array([first + best_places.start[end]]), np.array([first + end + 1]))
            query = (best_places.query_start[end : end + 1], best_places.query_end[end : end + 1])
            seen.append(_projected(index, wanted, node, listed, query)[0])
            say.append(voice * best_places.score[end])
    if not seen:
        return span
    ends = np.array([_weighted_median(np.array(seen)[:, k], np.array(say)) for k in (0, 1)])
    ends = np.clip(np.round(ends), low, high).astype(np.int64)
    return ends if ends[1] > ends[0] else span


def _weighted_median(values: np.ndarray, weights: np.ndarray) -> float:
    order = np.argsort(values, kind="stable")
    sums = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(sums, sums[-1] / 2)])


def apart(spans: np.ndarray, scores: np.ndarray, top: int, overlap: float = OVERLAP) -> np.ndarray:
    """Indices ``(k,)`` of at most ``top`` stretches (n, 2), best first, none of which shares much with a better one."""
    kept: list[int] = []
    for k in np.argsort(-scores, kind="stable"):
        others = spans[kept] if kept else np.zeros((0, 2))
        shared = np.minimum(spans[k, 1], others[:, 1]) - np.maximum(spans[k, 0], others[:, 0])
        shorter = np.minimum(spans[k, 1] - spans[k, 0], others[:, 1] - others[:, 0])
        if not (shared > overlap * shorter).any():
            kept.append(int(k))
            if len(kept) == top:
                break
    return np.array(kept, np.int64)
