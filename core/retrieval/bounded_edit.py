"""Engine ``bounded-edit``: how the postures of the parts change, by an edit distance with bounded prices."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.caching import RecentCache
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.progress import Report
from core.retrieval.chance import LEAST, chances, usual_distance, usual_of_clips
from core.retrieval.compose import Composed, compose
from core.retrieval.explanation import explain
from core.retrieval.frames import FrameStore
from core.retrieval.hits import Explanation, Hit, IndexedClip
from core.retrieval.locate import locate
from core.retrieval.metric import Metric, Motions
from core.retrieval.queries import Query
from core.retrieval.trajectories import path_distances

EXACT, RERANKED = 3000, 1000
"""With up to EXACT clips all get the exact distance; of more the nearest RERANKED, and the others follow in the order
of the rough one."""


class BoundedEdit:
    """The default engine (docs/methods/search.md)."""

    least = LEAST

    def __init__(self, store: FrameStore):
        self.store = store
        self._wholes = [Segment(clip.name, 0, clip.frames) for clip in store.clips]
        self._resampled: RecentCache[bytes, Motions] = RecentCache(3)  # by the metric of the weights

    @property
    def clips(self) -> tuple[IndexedClip, ...]:
        """The clips that are searched."""
        return self.store.clips

    @classmethod
    def build(cls, dataset: Dataset, parameters: Any, report: Report) -> BoundedEdit:
        """An engine of all clips of the data set."""
        return cls(FrameStore.build(dataset.clips, parameters.analysis_fps, report))

    def rank_clips(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int | None, root_path: float
    ) -> list[Hit]:
        """Clips ``(k,)`` by the distance of the whole of them to the query."""
        composed = compose(self.store, query, weights)
        metric = Metric(composed.weights)
        query_motion = metric.motions(self.store, composed.codes, np.array([0]), np.array([len(composed.codes)]))
        every = self._all(metric)
        others = every if len(among) == len(self.clips) else every[among]
        apart = _ranked_distances(metric, query_motion, others)
        if root_path > 0:
            starts, ends = self.store.starts[among], self.store.starts[among + 1]
            apart = (1 - root_path) * apart + root_path * path_distances(
                composed.codes, self.store.codes, starts, ends, self.store.fps
            )
        usual = usual_of_clips(metric, query_motion, every)
        scores = chances(apart, usual or usual_distance(self.store, metric, query_motion, len(composed.codes)))
        order = np.argsort(apart, kind="stable")[:top]
        ranked = zip(among[order].tolist(), scores[order].tolist(), strict=True)
        return [Hit(self._wholes[clip], score) for clip, score in ranked]

    def rank_intervals(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int, root_path: float
    ) -> list[Hit]:
        """Stretches of the clips ``(k,)``, see core.retrieval.locate."""
        composed = compose(self.store, query, weights)
        return [
            Hit(self.store.segment(place.clip, place.start, place.end), place.score, _part_of(composed, place.within))
            for place in locate(self.store, composed, among, top, root_path)
        ]

    def explain(self, query: Query, segment: Segment, weights: Mapping[str, float]) -> Explanation:
        """Which parts of a stretch are like the query when."""
        return explain(self.store, compose(self.store, query, weights), query, segment)

    def add(self, dataset: Dataset, report: Report) -> BoundedEdit:
        """With more clips; what is known of a skeleton's axes stays."""
        return BoundedEdit(self.store.add(dataset.clips, report))

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays (n, ...)."""
        return self.store.pack()

    @classmethod
    def unpack(cls, document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> BoundedEdit:
        """Back from :meth:`pack` (n, ...)."""
        return cls(FrameStore.unpack(document, arrays))

    def _all(self, metric: Metric) -> Motions:
        """All clips resampled for a metric."""
        return self._resampled.get_or_compute(metric.key, lambda: metric.clips(self.store))


def _ranked_distances(metric: Metric, query_motion: Motions, others: Motions) -> np.ndarray:
    """Distances ``(k,)``: exact for the nearest RERANKED, and beyond them growing with the rough distance."""
    if len(others.samples) <= EXACT:
        return metric.distances(query_motion, others)
    rough = metric.rough(query_motion, others)
    near = np.argpartition(rough, RERANKED)[:RERANKED]
    distances = np.empty(len(rough))
    distances[near] = metric.distances(query_motion, others[near])
    last, edge = distances[near].max(), rough[near].max()
    rest = np.ones(len(rough), bool)
    rest[near] = False
    distances[rest] = last + (1 - min(last, 1.0)) * (1 - edge / np.maximum(rough[rest], 1e-9))
    return distances


def _part_of(composed: Composed, within: tuple[int, int] | None) -> Segment | None:
    """Frames of the composed query as a segment of its leading part's clip."""
    if within is None:
        return None
    part, frames = composed.leading, composed.frames
    start = part.start + int(np.searchsorted(frames, within[0]))
    end = part.start + int(np.searchsorted(frames, within[1]))
    return Segment(part.clip.name, start, max(start + 1, min(end, part.end)))
