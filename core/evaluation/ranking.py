"""How well rankings of clips agree with labels: the measures of PCR section 5.2 and those of retrieval at large.

Two regimes. ``ALL``: every other clip may be found, those of the query's content are relevant. ``XSTYLE``: clips of
the query's own content *and* style are taken away first, so that only the same content in other styles is left to find;
an engine that knows people by their manner gains nothing there.
"""

from __future__ import annotations

import math
import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from core.errors import AnalysisError
from core.mocap.dataset import Dataset

FIRST = 20
"""How many hits P@20 and its kind look at (PCR section 5.2: N = 20)."""

RECALLS = np.linspace(0, 1, 21)
"""Recalls at which precision-recall curves are read."""

_SAMPLES = 1000


@dataclass(frozen=True)
class ClipLabels:
    """One label a clip: content by clip, and style by clip where there is one."""

    content: Mapping[str, str]
    style: Mapping[str, str]

    @property
    def has_styles(self) -> bool:
        """Whether some content was performed in more than one style, so that XSTYLE says something."""
        styles = defaultdict(set)
        for clip, style in self.style.items():
            styles[self.content.get(clip)].add(style)
        return any(len(found) > 1 for found in styles.values())


class Measure(NamedTuple):
    """Mean over queries, its 95 % bootstrap interval over queries, and the mean over contents."""

    mean: float
    low: float
    high: float
    macro: float


@dataclass(frozen=True, eq=False)
class RegimeScores:
    """Rankings of many queries scored in one regime.

    measures: ``P@20``, ``nP@20``, ``mAP``, ``1-NN``; with all clips also ``nDCG@20`` and ``styleAUC``. recall,
    precision: ``(21,)`` mean interpolated precision. contents: names of rows and columns of confusion
    ``(n_contents, n_contents)``: row = content of queries, column = content of their nearest hits (as many as are
    relevant, at most 20), shares that sum to 1. queries: scored; skipped: without a relevant clip; short: lists that
    lack clips.
    """

    measures: Mapping[str, Measure]
    recall: np.ndarray
    precision: np.ndarray
    contents: tuple[str, ...]
    confusion: np.ndarray
    queries: int
    skipped: int
    short: int

    def to_json(self) -> dict[str, Any]:
        """Plain lists and numbers."""
        return {
            "queries": self.queries,
            "skipped": self.skipped,
            "short": self.short,
            "measures": {name: measure._asdict() for name, measure in self.measures.items()},
            "curve": {"recall": self.recall.round(4).tolist(), "precision": self.precision.round(5).tolist()},
            "confusion": {"contents": list(self.contents), "shares": self.confusion.round(5).tolist()},
        }


def clip_labels(dataset: Dataset) -> ClipLabels:
    """The content of each clip that has labels: that which most of its frames have; and its style where one is known.

    An action ``walk/angry`` gives content and style. Else the name of a clip may: a word of it that equals the content,
    between underscores, is followed by the style (``dataset-1_walk_angry_001``). Clips without labels are left out.
    """
    frames: dict[str, Counter[str]] = defaultdict(Counter)
    for label in dataset.labels:
        frames[label.clip][label.action] += label.end - label.start
    content, style = {}, {}
    for clip in dataset.names:
        if clip not in frames:
            continue
        most = max(frames[clip].values())
        action = min(action for action, n in frames[clip].items() if n == most)
        name, _, manner = action.partition("/")
        content[clip] = name.strip()
        style_name = manner.strip() or _style_in_name(clip, content[clip])
        if style_name:
            style[clip] = style_name
    return ClipLabels(content, style)


def score_rankings(
    rankings: Mapping[str, Sequence[str]],
    labels: ClipLabels,
    *,
    coarse: Mapping[str, str] | None = None,
    seed: int = 0,
) -> dict[str, RegimeScores]:
    """Scores of rankings, query clip -> clips, best first, by regime: ``ALL``, and ``XSTYLE`` where there are styles.

    The labelled clips are the database; a query itself and clips without a label do not count where they appear, and
    relevant clips that a list lacks are as good as never found. coarse: content -> a wider kind, which nDCG gives a
    little for. Raises ValueError for a query without a label or a clip twice in a list.
    """
    for query, found in rankings.items():
        if query not in labels.content:
            raise AnalysisError(f"the query {query!r} has no label")
        if len(set(found)) != len(found):
            raise ValueError(f"a clip is twice in the list of {query!r}")
    regimes = ("ALL", "XSTYLE") if labels.has_styles else ("ALL",)
    return {regime: _regime(rankings, labels, regime, dict(coarse or {}), seed) for regime in regimes}


class _Scored(NamedTuple):
    """One query: its content, measures, interpolated precision, and counts of contents among its nearest."""

    content: str
    measures: dict[str, float]
    precision: np.ndarray
    nearest: Counter[str]
    short: bool


def _regime(
    rankings: Mapping[str, Sequence[str]], labels: ClipLabels, regime: str, coarse: Mapping[str, str], seed: int
) -> RegimeScores:
    scored = [_query(query, found, labels, regime, coarse) for query, found in rankings.items()]
    kept = [one for one in scored if one is not None]
    contents = tuple(sorted(set(labels.content.values())))
    confusion = np.zeros((len(contents), len(contents)))
    for one in kept:
        total = sum(one.nearest.values())
        for content, n in one.nearest.items():
            confusion[contents.index(one.content), contents.index(content)] += n / total
    per_content = confusion.sum(1, keepdims=True)
    values: dict[str, list[tuple[str, float]]] = {}
    for one in kept:
        for name, value in one.measures.items():
            values.setdefault(name, []).append((one.content, value))
    return RegimeScores(
        measures={name: _measure(pairs, seed) for name, pairs in values.items()},
        recall=RECALLS,
        precision=np.mean([one.precision for one in kept], axis=0) if kept else np.zeros(len(RECALLS)),
        contents=contents,
        confusion=confusion / np.where(per_content > 0, per_content, 1),
        queries=len(kept),
        skipped=len(scored) - len(kept),
        short=sum(one.short for one in kept),
    )


def _query(
    query: str, found: Sequence[str], labels: ClipLabels, regime: str, coarse: Mapping[str, str]
) -> _Scored | None:
    own = labels.content[query]
    manner = labels.style.get(query)

    def as_query(clip: str) -> bool:
        return manner is not None and labels.content[clip] == own and labels.style.get(clip) == manner

    database = [c for c in labels.content if c != query and not (regime == "XSTYLE" and as_query(c))]
    relevant = sum(labels.content[clip] == own for clip in database)
    if relevant == 0 or (regime == "XSTYLE" and manner is None):
        return None
    there = set(database)
    listed = [clip for clip in found if clip in there]
    hit = np.array([labels.content[clip] == own for clip in listed], bool)
    places = np.flatnonzero(hit) + 1
    precisions = np.arange(1, len(places) + 1) / places
    most = min(FIRST, relevant)
    first = float(hit[:FIRST].sum())
    measures = {
        f"P@{FIRST}": first / FIRST,
        f"nP@{FIRST}": first / most,
        "mAP": float(precisions.sum() / relevant),
        "1-NN": float(len(hit) > 0 and hit[0]),
    }
    if regime == "ALL":
        measures |= _graded(listed, database, own, as_query, labels, coarse)
    best_after = np.maximum.accumulate(precisions[::-1])[::-1] if len(precisions) else np.zeros(0)
    needed = np.maximum(np.ceil(RECALLS * relevant - 1e-9).astype(int), 1) - 1
    curve = np.array([best_after[k] if k < len(best_after) else 0.0 for k in needed])
    nearest = Counter(labels.content[clip] for clip in listed[:most])
    return _Scored(own, measures, curve, nearest, len(listed) < len(database))


def _graded(
    listed: Sequence[str],
    database: Sequence[str],
    own: str,
    as_query: Callable[[str], bool],
    labels: ClipLabels,
    coarse: Mapping[str, str],
) -> dict[str, float]:
    """nDCG@20 (gain of 3: content and style, 2: content, 1: the wider kind), and the area under the curve by style."""

    def gain(clip: str) -> int:
        other = labels.content[clip]
        if as_query(clip):
            return 3
        return 2 if other == own else int(coarse.get(other, other) == coarse.get(own, own))

    def discounted(gains: Iterable[int]) -> float:
        return sum((float(2**g - 1) / math.log2(k + 2) for k, g in enumerate(gains)), 0.0)

    ideal = discounted(sorted(map(gain, database), reverse=True)[:FIRST])
    measures = {f"nDCG@{FIRST}": discounted(map(gain, listed[:FIRST])) / ideal}
    place = {clip: k for k, clip in enumerate(listed)}
    alike, unlike = (
        np.array([place.get(c, len(database)) for c in database if labels.content[c] == own and as_query(c) == same])
        for same in (True, False)
    )
    if len(alike) and len(unlike):
        measures["styleAUC"] = float(((alike[:, None] < unlike) + 0.5 * (alike[:, None] == unlike)).mean())
    return measures


def _measure(values: Sequence[tuple[str, float]], seed: int) -> Measure:
    """Mean, interval and mean over contents of (content, value) pairs."""
    numbers = np.array([value for _, value in values])
    by_content = defaultdict(list)
    for content, value in values:
        by_content[content].append(value)
    draws = np.random.default_rng(seed).integers(len(numbers), size=(_SAMPLES, len(numbers)))
    low, high = np.quantile(numbers[draws].mean(1), (0.025, 0.975))
    macro = float(np.mean([np.mean(found) for found in by_content.values()]))
    return Measure(float(numbers.mean()), float(low), float(high), macro)


def _style_in_name(clip: str, content: str) -> str | None:
    match = re.search(rf"(?:^|_){re.escape(content)}_([^_]*[^_\d][^_]*)(?:_|$)", clip)
    return match[1] if match else None
