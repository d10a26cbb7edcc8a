"""Rankings of the clips of a data set by several engines, and their evaluation by labels.

The rankings do not depend on labels, so they are kept as a result; they are scored anew whenever they are looked at.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from core.errors import AnalysisError, FormatError, ParameterError
from core.evaluation.ranking import RegimeScores, clip_labels, score_rankings
from core.mocap.dataset import Dataset
from core.parameters import parameter
from core.progress import Report, silent
from core.retrieval.queries import whole_query
from core.retrieval.search import ENGINES, SearchParameters, build_search_index

FORMAT = "motionscape/rankings/1"
CHANCE = "chance"
BASELINE_NAMES = ("weighted-pca", "pose-clusters", "position-dtw", "match-webs")
"""Baselines of core.retrieval.baselines: all pairs of clips are compared, so they are slow on large data sets."""

KNOWN = (*ENGINES, *BASELINE_NAMES, CHANCE)
"""Everything that can rank clips: the engines of the search, the baselines, and chance."""


@dataclass(frozen=True)
class RankingParameters:
    """What ranks the clips. Each field's metadata: ``help``, ``min``, ``max``, ``step``, ``choices``, ``advanced``.

    Raises ParameterError, in plain words, for a value out of range.
    """

    engines: str = parameter(
        "bounded-edit,parts,printed", "What is compared, with commas between: " + ", ".join(KNOWN) + "."
    )
    queries: int = parameter(
        300,
        "Clips that are searched for, spread evenly over all; each is compared with every other.",
        1,
        100_000,
        1,
        label="Clips searched for",
    )
    seed: int = parameter(0, "Number that starts the random choices.", 0, None, 1, advanced=True, label="Random seed")

    def __post_init__(self) -> None:
        if not self.names:
            raise ParameterError(f"engines must name at least one of {', '.join(KNOWN)}")
        if unknown := [name for name in self.names if name not in KNOWN]:
            raise ParameterError(f"there is no engine called {unknown[0][:40]!r}; there are {', '.join(KNOWN)}")
        if not 1 <= self.queries <= 100_000:
            raise ParameterError(f"queries must be 1 to 100000, not {self.queries}")

    @property
    def names(self) -> tuple[str, ...]:
        """The engines, each once."""
        return tuple(dict.fromkeys(name.strip() for name in self.engines.split(",") if name.strip()))


@dataclass(frozen=True, eq=False)
class Rankings:
    """Rankings of clips. orders: engine -> ``(n_queries, n_clips - 1)`` int32 indices into ``clips``, best first.

    queries: ``(n_queries,)`` indices of the clips that were searched for. seconds: engine -> what it took.
    """

    clips: tuple[str, ...]
    queries: np.ndarray
    orders: Mapping[str, np.ndarray]
    parameters: Mapping[str, Any]
    seconds: Mapping[str, float]

    def of(self, engine: str) -> dict[str, list[str]]:
        """Query clip -> clips, best first, by one engine; KeyError where it was not asked."""
        return {
            self.clips[query]: [self.clips[k] for k in order]
            for query, order in zip(self.queries, self.orders[engine], strict=True)
        }

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """As a JSON document and arrays (n, ...)."""
        head = {"format": FORMAT, "clips": list(self.clips), "parameters": dict(self.parameters)}
        arrays = {"queries": self.queries, **{f"order {name}": order for name, order in self.orders.items()}}
        return head | {"seconds": dict(self.seconds)}, arrays


@dataclass(frozen=True, eq=False)
class Evaluation:
    """Scores: engine -> regime ("ALL", "XSTYLE") -> scores. queries: labelled clips that were searched for."""

    engines: Mapping[str, Mapping[str, RegimeScores]]
    queries: int

    def to_json(self) -> dict[str, Any]:
        """``{"queries", "engines": {engine: {regime: {"measures", "curve", "confusion", ...}}}}``, plain numbers."""
        engines = {
            name: {regime: scores.to_json() for regime, scores in regimes.items()}
            for name, regimes in self.engines.items()
        }
        return {"queries": self.queries, "engines": engines}


def rank_dataset(dataset: Dataset, parameters: RankingParameters | None = None, report: Report = silent) -> Rankings:
    """The clips of a data set, each ranked for each query by each engine. Deterministic.

    Raises AnalysisError where there are fewer than two clips; ``report`` may raise to stop the work.
    """
    parameters = parameters or RankingParameters()
    if len(dataset.clips) < 2:
        raise AnalysisError("a ranking needs at least two clips")
    n = len(dataset.clips)
    queries = np.unique(np.linspace(0, n - 1, min(parameters.queries, n)).round().astype(np.int64))
    orders, seconds = {}, {}
    for name in parameters.names:
        started = time.perf_counter()
        orders[name] = _orders(name, dataset, queries, parameters.seed, _of_engine(report, name))
        seconds[name] = time.perf_counter() - started
    return Rankings(dataset.names, queries, orders, asdict(parameters), seconds)


def evaluate(rankings: Rankings, dataset: Dataset) -> Evaluation:
    """Scores of rankings by the labels of a data set. Raises AnalysisError where no query has a label."""
    labels = clip_labels(dataset)
    labelled_queries = [rankings.clips[k] for k in rankings.queries if rankings.clips[k] in labels.content]
    if not labelled_queries:
        raise AnalysisError(
            "no clip that was searched for has a label, so there is nothing to compare the rankings with"
        )
    engines = {}
    for name in rankings.orders:
        order = rankings.of(name)
        engines[name] = score_rankings({query: order[query] for query in labelled_queries}, labels)
    return Evaluation(engines, len(labelled_queries))


def unpack(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Rankings:
    """Rankings back from the arrays (n, ...) of :meth:`Rankings.pack`. Raises FormatError for anything else."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not rankings: expected format {FORMAT}, found {document.get('format')}")
    orders = {key.removeprefix("order "): value for key, value in arrays.items() if key.startswith("order ")}
    names = [name for name in RankingParameters(**document["parameters"]).names if name in orders]
    return Rankings(
        tuple(document["clips"]),
        arrays["queries"],
        {name: orders[name] for name in names},
        document["parameters"],
        document["seconds"],
    )


def _orders(name: str, dataset: Dataset, queries: np.ndarray, seed: int, report: Report) -> np.ndarray:
    n = len(dataset.clips)
    if name in ENGINES:
        return _searched(name, dataset, queries, seed, report)
    if name == CHANCE:
        generator = np.random.default_rng(seed)
        apart = generator.random((n, n))
    else:
        from core.retrieval.baselines import BASELINES

        apart = BASELINES[name](dataset, report)
    order = [np.argsort(apart[query], kind="stable") for query in queries]
    return np.array([row[row != query] for query, row in zip(queries, order, strict=True)], np.int32)


def _searched(name: str, dataset: Dataset, queries: np.ndarray, seed: int, report: Report) -> np.ndarray:
    index = build_search_index(dataset, SearchParameters(method=name, seed=seed), report)
    place = {clip: k for k, clip in enumerate(dataset.names)}
    rows = []
    for k, query in enumerate(queries):
        hits = index.search(whole_query(dataset.clips[query]))
        rows.append([place[hit.segment.clip] for hit in hits if place[hit.segment.clip] != query])
        report("searching", (k + 1) / len(queries))
    return np.array(rows, np.int32)


def _of_engine(report: Report, name: str) -> Report:
    """A report whose stages say which engine they belong to."""
    return lambda stage, fraction: report(f"{name}: {stage}", fraction)
