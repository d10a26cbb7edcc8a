"""Engines ``parts`` and ``printed``: the paper's method, repaired and as printed (PCR sections 3 and 4).

Both cut every node of the body into segments, learn its patterns and keep every clip as eighteen lists of pattern
indices. ``parts`` compares lists by local alignment (core.retrieval.part_matching), ``printed`` by Algorithm 2.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from joblib import Parallel, delayed

from core.errors import AnalysisError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.poses.body_parts import LEAVES, NODES, leaves_of
from core.progress import Report
from core.retrieval import part_places, printed
from core.retrieval.compose import compose
from core.retrieval.explanation import explain
from core.retrieval.frames import FrameStore
from core.retrieval.hits import Explanation, Hit, IndexedClip
from core.retrieval.node_index import (
    NodeIndex,
    NodeReport,
    PatternSettings,
    SymbolList,
    build_node,
    node_columns,
)
from core.retrieval.part_matching import gains, propagate
from core.retrieval.part_verification import warped_spans
from core.retrieval.queries import Query, QueryPart
from core.retrieval.trajectories import path_distances


@dataclass(frozen=True)
class Matching:
    """How lists are compared. tolerance: dissimilarity, as a share of pairs of segments that are nearer, at which a

    pair gains nothing; gap: price of a pattern without a partner. alpha: share of a node's own score against what its
    children hand on. min_con_num, max_tolerance: of Algorithm 2, which ``printed`` takes (core.retrieval.printed).
    """

    tolerance: float = 0.2
    gap: float = 0.2
    alpha: float = 0.5
    min_con_num: int = printed.MIN_CON_NUM
    max_tolerance: float = printed.MAX_TOLERANCE


_VERIFIED = 4  # stretches whose frames are looked at, for each that is asked for


@dataclass(frozen=True, eq=False)
class QueryLists:
    """A query as the index sees it: node -> its pattern index list, and node -> number of frames of its stretch."""

    lists: Mapping[str, SymbolList]
    frames: Mapping[str, int]


class Parts:
    """The paper's engine with its repairs (docs/methods/search_parts.md)."""

    least = 0.0
    CENTRING, ARMS, EVENNESS = 1.0, 0.75, 0.8
    TRAVEL, SMOOTH, SHAPE = True, True, 0.5

    def __init__(
        self, store: FrameStore, nodes: Mapping[str, NodeIndex], settings: PatternSettings, matching: Matching
    ):
        self.store, self.nodes, self.settings, self.matching = store, dict(nodes), settings, matching

    @property
    def clips(self) -> tuple[IndexedClip, ...]:
        """The clips that are searched."""
        return self.store.clips

    @classmethod
    def build(cls, dataset: Dataset, parameters: Any, report: Report) -> Parts:
        """An engine of all clips of the data set. Raises AnalysisError where no body is recognised in any of them."""
        store = FrameStore.build(dataset.clips, parameters.analysis_fps, report)
        settings = PatternSettings(
            cls.CENTRING,
            parameters.pattern_error,
            cls.ARMS,
            cls.EVENNESS,
            parameters.seed,
            travel=cls.TRAVEL,
            smooth=cls.SMOOTH,
            first_k=parameters.k0,
            fps=store.fps,
            r=parameters.r,
            shape=cls.SHAPE,
        )
        matching = Matching(
            alpha=parameters.alpha, min_con_num=parameters.min_con_num, max_tolerance=parameters.max_tolerance
        )
        clips = range(len(store.clips))
        built: dict[str, NodeIndex] = {}
        with Parallel(n_jobs=2, prefer="threads", return_as="generator") as parallel:
            jobs = (delayed(build_node)(node, _tracks(store, node, clips, settings), settings) for node in NODES)
            for k, (node, index) in enumerate(zip(NODES, parallel(jobs), strict=True)):
                report("learning patterns", (k + 1) / len(NODES))
                if index is not None:
                    built[node] = index
        if not built:
            raise AnalysisError(
                "no clip has a skeleton in which a body is recognised, so there are no parts to search by"
            )
        return cls(store, built, settings, matching)

    def rank_clips(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int | None, root_path: float
    ) -> list[Hit]:
        """Clips ``(k,)`` by how much of the whole of them is like the whole query."""
        scores = self._with_path(query, weights, self._clip_scores(query, weights, among), among, root_path)
        order = np.argsort(-scores, kind="stable")[:top]
        ranked = [(self.clips[among[k]], float(scores[k])) for k in order]
        return [Hit(Segment(clip.name, 0, clip.frames), score) for clip, score in ranked]

    def rank_intervals(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int, root_path: float
    ) -> list[Hit]:
        """Stretches of the clips ``(k,)``: found by their patterns (core.retrieval.part_places), verified by frames."""
        lists = self.query_lists(query, weights)
        wanted, many = self._wanted(lists, weights), _VERIFIED * top + 10
        candidates = part_places.find_places(self.nodes, self.store.starts, self._gains(lists), wanted, among, many)
        composed = compose(self.store, query, weights)
        spans, warped = warped_spans(self.store, composed, candidates[:, :2].astype(np.int64))
        scores = candidates[:, 2] * (1 - warped)
        if root_path > 0:
            apart = path_distances(composed.codes, self.store.codes, spans[:, 0], spans[:, 1], self.store.fps)
            scores = (1 - root_path) * scores + root_path * (1 - apart)
        kept = part_places.apart(spans, scores, top)
        return [Hit(self._segment(*spans[k]), float(scores[k])) for k in kept]

    def explain(self, query: Query, segment: Segment, weights: Mapping[str, float]) -> Explanation:
        """Which parts of a stretch are like the query when: how alike the patterns are that the alignment pairs.

        The warp is that of the frames. Raises KeyError where the segment's clip is not indexed.
        """
        by_frames = explain(self.store, compose(self.store, query, weights), query, segment)
        lists = self.query_lists(query, dict.fromkeys(LEAVES, 1.0))
        clip, start, end = self.store.stretch(segment)
        span = self.store.starts[clip] + np.array([[start], [end]])
        times = len(by_frames.times)
        similarity = np.full((len(LEAVES), times), np.nan)
        for leaf, gain in self._gains(lists, LEAVES).items():
            node = self.nodes[leaf]
            first, last = (int(k[0]) for k in node.windows(*span))
            if last > first or np.isfinite(by_frames.similarity[LEAVES.index(leaf)]).any():
                similarity[LEAVES.index(leaf)] = part_places.paired_similarity(
                    node.symbols[first:last], gain, self.matching.gap, lists.lists[leaf].cuts, times
                )
        return Explanation(by_frames.times, similarity, by_frames.warp)

    def add(self, dataset: Dataset, report: Report) -> Parts:
        """With more clips: they get the nearest patterns, and nothing is learned anew."""
        known = len(self.clips)
        store = self.store.add(dataset.clips, report)
        added = range(known, len(store.clips))
        nodes = {
            node: index.extended(iter(_tracks(store, node, added, self.settings)), int(store.starts[known]))
            for node, index in self.nodes.items()
        }
        return type(self)(store, nodes, self.settings, self.matching)

    def diagnostics(self) -> tuple[NodeReport, ...]:
        """The paper's Tables 1 and 2 for this index, a row for each node, leaves last."""
        return tuple(index.report() for index in self.nodes.values())

    def query_lists(self, query: Query, weights: Mapping[str, float]) -> QueryLists:
        """The pattern index lists of the nodes of which one motion of the query has all parts, each with a weight.

        Raises AnalysisError where there is none.
        """
        lists: dict[str, SymbolList] = {}
        frames: dict[str, int] = {}
        for part in query.parts:
            wanted = [
                node
                for node in self.nodes
                if all(leaf in part.leaves and weights[leaf] > 0 for leaf in leaves_of(node))
            ]
            if wanted:
                codes, has, rows = self._with_surroundings(part)
                for node in wanted:
                    columns = node_columns(node, codes, has, self.settings, self.store.fps)[rows]
                    if columns.shape[1]:
                        lists[node], frames[node] = self.nodes[node].listed(columns), len(columns)
        if not lists:
            raise AnalysisError(
                f"{query.name}: no body with the parts that have a weight is recognised in its skeleton"
            )
        return QueryLists(lists, frames)

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays of any shape (n, ...)."""
        document, arrays = self.store.pack()
        nodes = []
        for name, index in self.nodes.items():
            head, kept = index.pack()
            nodes.append(head)
            arrays |= {f"{name}.{key}": value for key, value in kept.items()}
        settings = {"settings": asdict(self.settings), "matching": asdict(self.matching)}
        return {"frames": document, "nodes": nodes, **settings}, arrays

    @classmethod
    def unpack(cls, document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Parts:
        """Back from :meth:`pack` (n, ...)."""
        nodes = {}
        for head in document["nodes"]:
            prefix = f"{head['node']}."
            kept = {key.removeprefix(prefix): value for key, value in arrays.items() if key.startswith(prefix)}
            nodes[head["node"]] = NodeIndex.unpack(head, kept)
        settings, matching = PatternSettings(**document["settings"]), Matching(**document["matching"])
        return cls(FrameStore.unpack(document["frames"], arrays), nodes, settings, matching)

    def _clip_scores(self, query: Query, weights: Mapping[str, float], among: np.ndarray) -> np.ndarray:
        lists = self.query_lists(query, weights)
        windows = {node: (self.nodes[node].starts[among], self.nodes[node].starts[among + 1]) for node in lists.lists}
        return part_places.judged(self.nodes, self._gains(lists), self._wanted(lists, weights), windows)

    def _wanted(self, lists: QueryLists, weights: Mapping[str, float]) -> part_places.Wanted:
        return part_places.Wanted(lists.lists, lists.frames, weights, self.matching.alpha, self.matching.gap)

    def _gains(self, lists: QueryLists, nodes: Iterable[str] | None = None) -> dict[str, np.ndarray]:
        chosen = [node for node in lists.lists if nodes is None or node in nodes]
        return {
            node: gains(self.nodes[node].library.by_percentile[lists.lists[node].symbols], self.matching.tolerance)
            for node in chosen
        }

    def _with_path(
        self, query: Query, weights: Mapping[str, float], scores: np.ndarray, among: np.ndarray, root_path: float
    ) -> np.ndarray:
        if root_path == 0:
            return scores
        codes = compose(self.store, query, weights).codes
        starts, ends = self.store.starts[among], self.store.starts[among + 1]
        apart = path_distances(codes, self.store.codes, starts, ends, self.store.fps)
        return (1 - root_path) * scores + root_path * (1 - apart)

    def _with_surroundings(self, part: QueryPart) -> tuple[np.ndarray, Sequence[str], slice]:
        """Codes of a stretch and of what its recording has around it, the leaves there, and the stretch's rows.

        The surroundings count for the average posture alone, as they do for the clips of the index.
        """
        around = round(self.settings.around * part.clip.fps) if self.settings.centring > 0 else 0
        first, last = max(0, part.start - around), min(part.clip.n_frames, part.end + around)
        codes, has = self.store.encode(part.clip, first, last)
        rate = self.store.fps / part.clip.fps
        start = min(round((part.start - first) * rate), len(codes) - 1)
        end = len(codes) if last == part.end else max(start + 1, min(round((part.end - first) * rate), len(codes)))
        return codes, has, slice(start, end)

    def _segment(self, first: int, last: int) -> Segment:
        clip = int(np.searchsorted(self.store.starts, first, side="right")) - 1
        offset = self.store.starts[clip]
        return self.store.segment(clip, int(first - offset), int(last - offset))


class Printed(Parts):
    """The paper's engine as printed, for comparison. Its hits are whole clips."""

    CENTRING, ARMS, EVENNESS = 0.0, 0.0, 0.0
    TRAVEL, SMOOTH, SHAPE = False, False, 1.0

    def rank_intervals(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int, root_path: float
    ) -> list[Hit]:
        """The clips ``(k,)`` as a whole: Algorithm 2 says nothing of where in a clip the query is."""
        return self.rank_clips(query, weights, among=among, top=top, root_path=root_path)

    def query_lists(self, query: Query, weights: Mapping[str, float]) -> QueryLists:
        """The lists of all nodes of which one motion of the query has all parts, whatever they weigh."""
        return super().query_lists(query, dict.fromkeys(weights, 1.0))

    def _clip_scores(self, query: Query, weights: Mapping[str, float], among: np.ndarray) -> np.ndarray:
        lists = self.query_lists(query, weights)
        scores = {}
        for node, listed in lists.lists.items():
            index = self.nodes[node]
            # W of Algorithm 1: 1 where all leaves weigh the same
            weight = len(LEAVES) * float(np.mean([weights[leaf] for leaf in leaves_of(node)]))
            every = printed.scan(
                index.symbols,
                index.starts,
                listed.symbols,
                index.library.by_maximum,
                weight=weight,
                max_tolerance=self.matching.max_tolerance,
                min_con_num=self.matching.min_con_num,
            )
            scores[node] = every[among]
        return propagate(scores, dict.fromkeys(LEAVES, 0.1), self.matching.alpha)


def _tracks(store: FrameStore, node: str, clips: Iterable[int], settings: PatternSettings) -> list[np.ndarray]:
    """The centred columns ``(n, c)`` of a node, clip by clip."""
    names = [[leaf for leaf, has in zip(LEAVES, row, strict=True) if has] for row in store.has]
    return [node_columns(node, store.of(k), names[k], settings, store.fps) for k in clips]
