"""Do people agree with a search? The numbers of the paper's study (PCR section 5.3): Tables 4 and 5, Figure 6.

A person sees a query beside a hit, does not know which engine found it, and rates their likeness from 1 (completely
different) to 10 (identical). The paper quantifies agreement by canonical correlation of the two rankings; between two
single variables that is the size of their correlation, which for ranks is Spearman's. Here it stands with its sign,
beside Kendall's (tau-b) which ties and short lists disturb less, with the number of pairs and an interval.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from core.mocap.clip import Segment

LEAST, MOST = 1, 10
"""The scale of ratings."""


class Rating(NamedTuple):
    """What one person thinks of one hit. rank: its place in the engine's list, from 1; value: from 1 to 10."""

    query: Segment
    hit: Segment
    engine: str
    rank: int
    value: int
    person: str = ""


class Vote(NamedTuple):
    """Which of two hits is more like the query. choice: ``left``, ``right`` or ``same``; ranks from 1."""

    query: Segment
    left: Segment
    right: Segment
    left_engine: str
    right_engine: str
    left_rank: int
    right_rank: int
    choice: str
    person: str = ""


class Spread(NamedTuple):
    """Mean and standard deviation of ratings (Table 4) and how many there are."""

    mean: float
    deviation: float
    ratings: int


@dataclass(frozen=True)
class Correlation:
    """Computer's rank against people's (Table 5): Spearman's and Kendall's coefficient, each with its 95 % interval.

    pairs: (query, hit) pairs that were rated; nan where there are fewer than three or all are alike.
    """

    spearman: float
    spearman_interval: tuple[float, float]
    kendall: float
    kendall_interval: tuple[float, float]
    pairs: int


class RankPoint(NamedTuple):
    """A hit of Figure 6: its rank by the engine and by people (1 = most alike, ties share their mean rank).

    variance: of its ratings (the paper draws it as the circle's radius).
    """

    engine: str
    query: Segment
    hit: Segment
    computer_rank: int
    human_rank: float
    mean_rating: float
    variance: float
    ratings: int


class Share(NamedTuple):
    """A share of votes with its 95 % interval (Wilson 1927); nan of no votes."""

    share: float
    low: float
    high: float
    votes: int


@dataclass(frozen=True)
class Agreement:
    """The study's results; all mappings by engine.

    by_query: (engine, query) -> spread, the cells of Table 4; overall: engine -> spread. correlations: ranks within
    queries, pooled. query_correlations: (engine, query) -> correlation, the cells of Table 5. points: Figure 6.
    """

    overall: dict[str, Spread]
    by_query: dict[tuple[str, Segment], Spread]
    correlations: dict[str, Correlation]
    query_correlations: dict[tuple[str, Segment], Correlation]
    points: tuple[RankPoint, ...]

    def to_json(self) -> dict[str, Any]:
        """Plain lists and numbers, nan as None."""
        return {
            "engines": {
                engine: {**spread._asdict(), **_correlation_json(self.correlations[engine])}
                for engine, spread in self.overall.items()
            },
            "queries": [
                {
                    "engine": engine,
                    "query": list(query),
                    **spread._asdict(),
                    **_correlation_json(self.query_correlations[engine, query]),
                }
                for (engine, query), spread in self.by_query.items()
            ],
            "points": [{**p._asdict(), "query": list(p.query), "hit": list(p.hit)} for p in self.points],
        }


def agreement(ratings: Iterable[Rating], *, samples: int = 1000, seed: int = 0) -> Agreement:
    """The study's numbers from ratings; ``samples``: draws of the bootstrap over hits.

    Where a person rated a pair twice for one engine, the last counts. Raises ValueError for a value or rank out of
    range.
    """
    latest: dict[tuple[Any, ...], Rating] = {}
    for rating in ratings:
        if not LEAST <= rating.value <= MOST or rating.rank < 1:
            raise ValueError(
                f"ratings go from {LEAST} to {MOST} and ranks from 1, not {rating.value} and {rating.rank}"
            )
        latest[rating.engine, rating.query, rating.hit, rating.person] = rating
    kept = sorted(latest.values(), key=lambda r: (r.engine, r.query, r.rank, r.hit, r.person))
    engines = _grouped(kept, lambda r: r.engine)
    cells = _grouped(kept, lambda r: (r.engine, r.query))
    points = tuple(point for cell in cells.values() for point in _points(cell))
    generator = np.random.default_rng(seed)
    return Agreement(
        overall={engine: _spread(found) for engine, found in engines.items()},
        by_query={cell: _spread(found) for cell, found in cells.items()},
        correlations={
            engine: _correlation([p for p in points if p.engine == engine], samples, generator) for engine in engines
        },
        query_correlations={
            cell: _correlation([p for p in points if (p.engine, p.query) == cell], samples, generator) for cell in cells
        },
        points=points,
    )


@dataclass(frozen=True)
class WinRates:
    """What pairwise votes say. ``same`` counts half for either side.

    engines: engine -> share of votes against other engines' hits that its own hit won. pairs: (engine, other) -> the
    same between these two. higher_ranked: engine -> share of votes between two of its own hits that the one it ranks
    higher won: agreement with people without a scale.
    """

    engines: dict[str, Share]
    pairs: dict[tuple[str, str], Share]
    higher_ranked: dict[str, Share]


def win_rates(votes: Iterable[Vote]) -> WinRates:
    """Win rates from votes between two hits; the last vote of a person on one pair counts, whichever way it was shown.

    Raises ValueError for a choice other than left, right and same.
    """
    latest: dict[Hashable, Vote] = {}
    for vote in votes:
        if vote.choice not in ("left", "right", "same"):
            raise ValueError(f"a choice is left, right or same, not {vote.choice!r}")
        sides = frozenset([(vote.left, vote.left_engine), (vote.right, vote.right_engine)])
        latest[vote.query, sides, vote.person] = vote
    won: dict[tuple[str, str], list[float]] = defaultdict(list)
    consistent: dict[str, list[float]] = defaultdict(list)
    for vote in latest.values():
        left = {"left": 1.0, "right": 0.0, "same": 0.5}[vote.choice]
        if vote.left_engine != vote.right_engine:
            won[vote.left_engine, vote.right_engine].append(left)
            won[vote.right_engine, vote.left_engine].append(1 - left)
        elif vote.left_rank != vote.right_rank:
            consistent[vote.left_engine].append(left if vote.left_rank < vote.right_rank else 1 - left)
    engines: dict[str, list[float]] = defaultdict(list)
    for (engine, _), outcomes in won.items():
        engines[engine] += outcomes
    return WinRates(
        {engine: wilson(engines[engine]) for engine in sorted(engines)},
        {pair: wilson(won[pair]) for pair in sorted(won)},
        {engine: wilson(consistent[engine]) for engine in sorted(consistent)},
    )


def wilson(outcomes: Sequence[float]) -> Share:
    """Mean of outcomes between 0 and 1 with Wilson's 95 % interval for a share."""
    n = len(outcomes)
    if n == 0:
        return Share(float("nan"), float("nan"), float("nan"), 0)
    share, z = float(np.mean(outcomes)), 1.959964
    middle = (share + z * z / (2 * n)) / (1 + z * z / n)
    half = z * np.sqrt(share * (1 - share) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    return Share(share, float(max(0, middle - half)), float(min(1, middle + half)), n)


def _grouped(items: Iterable[Any], key: Callable[[Any], Any]) -> dict[Any, list[Any]]:
    groups: dict[Any, list[Any]] = {}
    for item in items:
        groups.setdefault(key(item), []).append(item)
    return groups


def _spread(ratings: Sequence[Rating]) -> Spread:
    values = np.array([rating.value for rating in ratings], float)
    return Spread(float(values.mean()), float(values.std(ddof=1)) if len(values) > 1 else 0.0, len(values))


def _points(cell: Sequence[Rating]) -> list[RankPoint]:
    """The hits of one engine for one query, in its order."""
    hits = _grouped(cell, lambda r: r.hit)
    means = np.array([np.mean([r.value for r in found]) for found in hits.values()])
    from scipy.stats import rankdata  # late: importing it takes a second, and every worker imports this module

    ranks = rankdata(-means)
    return [
        RankPoint(
            found[0].engine, found[0].query, hit, found[0].rank, float(rank), float(mean), _variance(found), len(found)
        )
        for (hit, found), rank, mean in zip(hits.items(), ranks, means, strict=True)
    ]


def _variance(ratings: Sequence[Rating]) -> float:
    return float(np.var([r.value for r in ratings], ddof=1)) if len(ratings) > 1 else 0.0


def _correlation(points: Sequence[RankPoint], samples: int, generator: np.random.Generator) -> Correlation:
    ranks = np.array([(p.computer_rank, p.human_rank) for p in points], float).reshape(-1, 2)
    n = len(ranks)
    if n < 3:
        unknown = (np.nan, np.nan)
        return Correlation(np.nan, unknown, np.nan, unknown, n)
    draws = np.concatenate([np.arange(n)[None], generator.integers(n, size=(samples, n))])

    def with_interval(coefficient: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> tuple[float, tuple[float, float]]:
        # a share of the draws at a time, as all pairs of a draw are looked at
        parts = np.array_split(ranks[draws], max(1, draws.size * n // 2_000_000))
        values = np.concatenate([coefficient(part[..., 0], part[..., 1]) for part in parts])
        known = values[1:][np.isfinite(values[1:])]
        low, high = np.quantile(known, (0.025, 0.975)) if len(known) else (np.nan, np.nan)
        return float(values[0]), (float(low), float(high))

    return Correlation(*with_interval(_spearman), *with_interval(_kendall), n)


def _spearman(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Spearman's coefficient of each row of two arrays (draws, n): (draws,); nan where a row is all alike."""
    from scipy.stats import rankdata  # late, see above

    a, b = (rankdata(x, axis=1) - (x.shape[1] + 1) / 2 for x in (a, b))
    return _ratio((a * b).sum(1), (a * a).sum(1), (b * b).sum(1))


def _kendall(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Kendall's tau-b of each row of two arrays (draws, n): (draws,); nan where a row is all alike."""
    a, b = (np.sign(x[:, :, None] - x[:, None, :]).reshape(len(x), -1) for x in (a, b))
    return _ratio((a * b).sum(1), (a * a).sum(1), (b * b).sum(1))


def _ratio(both: np.ndarray, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.where((a > 0) & (b > 0), both / np.sqrt(np.maximum(a * b, 1e-30)), np.nan)


def _correlation_json(found: Correlation) -> dict[str, Any]:
    def number(value: float) -> float | None:
        return float(value) if np.isfinite(value) else None

    return {
        "spearman": number(found.spearman),
        "spearman_interval": [number(v) for v in found.spearman_interval],
        "kendall": number(found.kendall),
        "kendall_interval": [number(v) for v in found.kendall_interval],
        "pairs": found.pairs,
    }
