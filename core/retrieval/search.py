"""The search index: one interface over the engines (docs/methods/search.md says how each reads the paper)."""

from __future__ import annotations

import time
from collections.abc import Collection, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from importlib import import_module
from typing import Any, Protocol

import numpy as np

from core.errors import AnalysisError, FormatError, ParameterError
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.rigs import PEOPLE, comparable_groups
from core.mocap.skeleton import Skeleton
from core.parameters import parameter
from core.poses.body_parts import LEAVES, normalise_weights
from core.progress import Report, silent
from core.retrieval.frames import FrameStore
from core.retrieval.hits import Explanation, Hit, IndexedClip
from core.retrieval.queries import Query

FORMAT = "motionscape/search/1"
ENGINES = {
    "bounded-edit": ("core.retrieval.bounded_edit", "BoundedEdit"),
    "parts": ("core.retrieval.parts_index", "Parts"),
    "printed": ("core.retrieval.parts_index", "Printed"),
}
"""Method -> module and class of its engine."""

INTERVALS = 20
"""Hits of a search for intervals, where nothing else is said."""


@dataclass(frozen=True)
class SearchParameters:
    """What an index is built from. Each field's metadata: ``help``, ``min``, ``max``, ``step``, ``choices``,
    ``advanced``.

    Raises ParameterError, in plain words, for a value out of range.
    """

    method: str = parameter(
        "bounded-edit",
        "bounded-edit = how the postures change, by an edit distance; the default. parts = the 2009 paper's patterns "
        "of parts of the body, repaired. printed = the same with the paper's own matching, to compare with.",
        choices=tuple(ENGINES),
    )
    analysis_fps: float = parameter(
        30.0, "Frames a second that are looked at.", 5.0, 240.0, 5.0, advanced=True, label="Frames per second"
    )
    pattern_error: float = parameter(
        0.6,
        "With parts and printed: how far a movement may be from its pattern, as a share of their spread; "
        "less makes more patterns.",
        0.1, 5.0, 0.1, advanced=True,
    )  # fmt: skip
    r: float = parameter(
        1.0,
        "With parts and printed: factor on the paper's R. How much a part must do something new before a segment ends, "
        "in its own usual measure; more makes longer segments.",
        0.05, 50.0, 0.25, advanced=True, label="R",
    )  # fmt: skip
    k0: int = parameter(
        10,
        "With parts and printed: the paper's K0. Patterns of a part that adaptive k-means begins with.",
        1, 1000, 1, advanced=True, label="K0",
    )  # fmt: skip
    alpha: float = parameter(
        0.5,
        "With parts and printed: the paper's alpha. Share of what is seen of several parts together, against what is "
        "seen of each by itself.",
        0.0, 1.0, 0.05, advanced=True, label="Alpha",
    )  # fmt: skip
    min_con_num: int = parameter(
        5,
        "With printed: the paper's MinConNum. Patterns in a row that must be alike before they count.",
        1, 100, 1, advanced=True, label="MinConNum",
    )  # fmt: skip
    max_tolerance: float = parameter(
        0.02,
        "With printed: the paper's MaxTolerance. How far apart patterns may be that count as alike, as a share of the "
        "greatest distance.",
        0.0, 1.0, 0.01, advanced=True, label="MaxTolerance",
    )  # fmt: skip
    seed: int = parameter(
        0, "Number that starts the random choices; equal numbers give equal indexes.", 0, None, 1, label="Random seed"
    )

    def __post_init__(self) -> None:
        if self.method not in ENGINES:
            raise ParameterError(f"method must be one of {', '.join(ENGINES)}, not {str(self.method)[:40]!r}")
        for own in fields(self):
            low, high, value = own.metadata["min"], own.metadata["max"], getattr(self, own.name)
            if low is not None and high is not None and not low <= value <= high:
                raise ParameterError(f"{own.name} must be {low:g} to {high:g}, not {value}")


class Engine(Protocol):
    """The interface of engines. Weights are those of all ten leaves and sum to 1; leaves of weight 0 have no influence.

    ``among``: ``(k,)`` ascending indices into ``clips`` of those that count. Hits come best first; equal scores in the
    order of the clips. Frames of hits are of the clips' own rates.
    """

    store: FrameStore
    least: float  # chance below which a clip is no hit; 0 where scores are no chances

    @property
    def clips(self) -> tuple[IndexedClip, ...]:
        """The clips that are searched."""

    @classmethod
    def build(cls, dataset: Dataset, parameters: SearchParameters, report: Report) -> Engine:
        """An engine of all clips of the data set."""

    def rank_clips(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int | None, root_path: float
    ) -> list[Hit]:
        """One hit a clip ``(k,)``: all of ``among``, or the ``top`` best."""

    def rank_intervals(
        self, query: Query, weights: Mapping[str, float], *, among: np.ndarray, top: int, root_path: float
    ) -> list[Hit]:
        """At most ``top`` stretches of the clips ``(k,)`` that hardly overlap."""

    def explain(self, query: Query, segment: Segment, weights: Mapping[str, float]) -> Explanation:
        """Which parts of a stretch are like the query when."""

    def add(self, dataset: Dataset, report: Report) -> Engine:
        """With more clips, by what was learned from the first ones."""

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays of any shape (n, ...)."""

    @classmethod
    def unpack(cls, document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Engine:
        """Back from :meth:`pack` (n, ...)."""


@dataclass(frozen=True, eq=False)
class SearchIndex:
    """An index of a data set that answers queries. ``seconds``: what each stage of building it took.

    engine: of the people among the clips; of a data set without any, of the rig with most frames. others: an engine for
    each rig that cannot be compared with those: a query is looked for among clips of its own kind only.
    """

    engine: Engine
    parameters: SearchParameters
    dataset: Mapping[str, Any] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    others: tuple[Engine, ...] = ()

    @property
    def clips(self) -> tuple[IndexedClip, ...]:
        """The clips that are searched, of all kinds."""
        return tuple(clip for engine in (self.engine, *self.others) for clip in engine.clips)

    def engine_for(self, query: Query) -> Engine:
        """The engine of the clips that can be compared with a query.

        Raises AnalysisError where there is none, or the parts of the query are of several kinds.
        """
        engines = {_engine_of(part.clip.skeleton, (self.engine, *self.others)) for part in query.parts}
        if len(engines) > 1:
            raise AnalysisError(f"{query.name}: its parts are of bodies that cannot be compared")
        (engine,) = engines
        if engine is None:
            raise AnalysisError(f"{query.name}: no clip here has a body that can be compared with it")
        return engine

    def not_compared(self, query: Query) -> int:
        """How many clips a query is not compared with, for their bodies cannot be."""
        return len(self.clips) - len(self.engine_for(query).clips)

    def search(
        self,
        query: Query,
        *,
        weights: Mapping[str, float] | None = None,
        level: str = "clip",
        top: int | None = None,
        root_path: float = 0.0,
        only: Collection[str] | None = None,
        exclude: Collection[str] = (),
    ) -> list[Hit]:
        """The stretches that are most like the query, best first.

        Clips whose bodies cannot be compared with the query's are no hits.

        weights: node or leaf of the body -> weight (see core.poses.body_parts), None for all alike; parts of the body
        that the query lacks count nothing. level: "clip" gives one hit a clip, all of them unless ``top`` says
        fewer; "interval" gives stretches of clips: the ``top`` best, or if ``top`` is None at most 20 whose score is at
        least ``least``. root_path: from 0 (not at all) to 1, how much the path over the ground counts. only, exclude:
        names of the clips that count, or do not. Raises ParameterError for weights, level, top or root_path that cannot
        be used, AnalysisError as :meth:`engine_for`.
        """
        if level not in ("clip", "interval"):
            raise ParameterError(f"level must be clip or interval, not {str(level)[:40]!r}")
        if top is not None and top < 1:
            raise ParameterError(f"top must be at least 1, not {top}")
        if not 0 <= root_path <= 1:
            raise ParameterError(f"root_path must be 0 to 1, not {root_path}")
        engine = self.engine_for(query)
        wanted, unwanted = None if only is None else set(only), set(exclude)
        among = [
            k for k, c in enumerate(engine.clips) if (wanted is None or c.name in wanted) and c.name not in unwanted
        ]
        shares = weights_for(query, weights)
        if not among:
            return []
        clips, path = np.array(among, np.int64), float(root_path)
        if level == "clip":
            return engine.rank_clips(query, shares, among=clips, top=top, root_path=path)
        most = INTERVALS if top is None else top
        hits = engine.rank_intervals(query, shares, among=clips, top=most, root_path=path)
        return hits if top else [hit for hit in hits if hit.score >= self.least]

    @property
    def least(self) -> float:
        """The chance below which a clip is no hit, such as .01; 0 where the engine's scores are no chances."""
        return self.engine.least

    def explain(self, query: Query, hit: Hit | Segment, *, weights: Mapping[str, float] | None = None) -> Explanation:
        """Which parts of a hit are like the query when, and which frames stand beside one another.

        Raises KeyError for a clip that is not indexed, ParameterError for a stretch that is none of it.
        """
        segment = hit.segment if isinstance(hit, Hit) else hit
        clip = next((clip for clip in self.clips if clip.name == segment.clip), None)
        if clip is None:
            raise KeyError(f"the index has no clip {segment.clip!r}")
        if not 0 <= segment.start < segment.end <= clip.frames:
            raise ParameterError(f"{clip.name} has frames 0 to {clip.frames}, not {segment.start} to {segment.end}")
        engine = self.engine_for(query)
        if clip not in engine.clips:
            raise ParameterError(f"{query.name} and {clip.name} are of bodies that cannot be compared")
        return engine.explain(query, segment, weights_for(query, weights))

    def add(self, dataset: Dataset, report: Report = silent) -> SearchIndex:
        """The index with the clips of another data set as well, without building it anew.

        What was learned from the first clips (principal components, scales) stays. Raises AnalysisError where a name is
        there already.
        """
        known = {clip.name for clip in self.clips}
        twice = [name for name in dataset.names if name in known]
        if twice:
            raise AnalysisError(f"the index has a clip called {twice[0]!r} already")
        engines = [self.engine, *self.others]
        for group in comparable_groups(dataset, parts_with_people=True):
            some = dataset.select(group.clips)
            own = _engine_of(some.clips[0].skeleton, tuple(engines))
            if own is None:
                engines.append(_engine(self.parameters.method).build(some, self.parameters, report))
            else:
                engines[engines.index(own)] = own.add(some, report)
        return replace(self, engine=engines[0], others=tuple(engines[1:]))

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """The index as a JSON document and arrays (n, ...), to be kept."""
        document, arrays = self.engine.pack()
        others = []
        for k, engine in enumerate(self.others):
            more, own = engine.pack()
            others.append(more)
            arrays = arrays | {f"other {k} {name}": array for name, array in own.items()}
        head = {"format": FORMAT, "parameters": asdict(self.parameters), "dataset": dict(self.dataset)}
        return head | {"seconds": dict(self.seconds), "engine": document, "others": others}, arrays


def _engine_of(skeleton: Skeleton, engines: tuple[Engine, ...]) -> Engine | None:
    """The engine whose clips have bodies that a skeleton can be compared with."""
    human = find_anatomy(skeleton).body != "other"
    for engine in engines:
        own = any(axes.bones for axes in engine.store.axes)
        if (human and not own) or (not human and own and any(rig.fits(skeleton) for rig in engine.store.rigs)):
            return engine
    return None


def weights_for(query: Query, weights: Mapping[str, float] | None) -> dict[str, float]:
    """Weights of the ten leaves, summing to 1, with none on parts that the query lacks. Raises ParameterError."""
    shares = dict.fromkeys(LEAVES, 1.0) if weights is None else normalise_weights(weights)
    shares = {leaf: weight if leaf in query.leaves else 0.0 for leaf, weight in shares.items()}
    if not any(shares.values()):
        raise ParameterError(f"{query.name}: the query has none of the parts of the body that have a weight")
    return normalise_weights(shares)


def build_search_index(
    dataset: Dataset, parameters: SearchParameters | None = None, report: Report = silent
) -> SearchIndex:
    """An index of all clips of a data set. Deterministic: the same clips and parameters give the same index.

    >>> from core import build_search_index, make_demo
    >>> from core.retrieval.queries import whole_query
    >>> demo = make_demo(minutes=1)
    >>> hits = build_search_index(demo).search(whole_query(demo.clips[0], 60, 150), level="interval")
    >>> hits[0].segment.clip == demo.clips[0].name
    True

    Raises AnalysisError where there are no clips; ``report`` may raise to stop the work.
    """
    parameters = parameters or SearchParameters()
    if not dataset.clips:
        raise AnalysisError("the dataset has no clips, so there is nothing to search")
    started = time.perf_counter()
    groups = sorted(comparable_groups(dataset, parts_with_people=True), key=lambda group: group.words != PEOPLE)
    parts = [dataset] if len(groups) == 1 else [dataset.select(group.clips) for group in groups]
    engine, *others = (_engine(parameters.method).build(part, parameters, report) for part in parts)
    return SearchIndex(
        engine,
        parameters,
        dataset={"name": dataset.name, "fingerprint": dataset.fingerprint},
        seconds={"index": time.perf_counter() - started},
        others=tuple(others),
    )


def unpack(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> SearchIndex:
    """The index back from the arrays (n, ...) of :meth:`SearchIndex.pack`. Raises FormatError for anything else."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not a search index: expected format {FORMAT}, found {document.get('format')}")
    parameters = SearchParameters(**document["parameters"])
    kind = _engine(parameters.method)
    others = []
    for k, other in enumerate(document["others"]):
        mark = f"other {k} "
        own = {name.removeprefix(mark): array for name, array in arrays.items() if name.startswith(mark)}
        others.append(kind.unpack(other, own))
    engine = kind.unpack(document["engine"], {n: array for n, array in arrays.items() if not n.startswith("other ")})
    return SearchIndex(engine, parameters, dict(document["dataset"]), dict(document["seconds"]), tuple(others))


def _engine(method: str) -> type[Engine]:
    module, name = ENGINES[method]
    engine: type[Engine] = getattr(import_module(module), name)
    return engine
