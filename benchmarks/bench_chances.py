"""Scores as chances: fitted on all labelled collections but one, checked on that one.

usage: python -m benchmarks chances
"""

from __future__ import annotations

import numpy as np
from sklearn.linear_model import LogisticRegression

from benchmarks.bench_transfer import EQUAL
from benchmarks.labelled import collections, some_clips
from core.evaluation.ranking import ClipLabels
from core.progress import silent
from core.retrieval import chance, metric
from core.retrieval.frames import FrameStore

SUBSETS, FEW = 6, 0.05  # smaller collections made of each, of 1, 2 and 4 of its actions, and what each size weighs
BINS = 10

Pairs = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Distance and its ratio to the usual one ``(n, 2)``, whether the action is the same ``(n,)``, weight ``(n,)``."""


def whole(store: FrameStore, labels: ClipLabels) -> Pairs:
    """All pairs of clips of a collection."""
    measure = metric.Metric(EQUAL)
    motions = measure.clips(store)
    content = np.array([labels.content[clip.name] for clip in store.clips])
    features, same = [], []
    for k in range(len(content)):
        query, others = motions[k : k + 1], np.arange(len(content)) != k
        apart = measure.distances(query, motions)[others]
        usual = chance.usual_distance(store, measure, query, int(store.starts[k + 1] - store.starts[k]))
        features.append(np.stack([apart, apart / usual], axis=1))
        same.append(content[others] == content[k])
    found, alike = np.concatenate(features), np.concatenate(same)
    return found, alike, np.full(len(alike), 1 / max(len(alike), 1))


def part(store: FrameStore, labels: ClipLabels, actions: np.ndarray) -> Pairs:
    """All pairs of clips of some of the actions, as if there were no others."""
    which = np.flatnonzero([labels.content[clip.name] in set(actions.tolist()) for clip in store.clips])
    return whole(some_clips(store, which), labels)


def pairs(store: FrameStore, labels: ClipLabels, rng: np.random.Generator) -> list[Pairs]:
    """Those of the whole collection first, then those of the smaller ones made of it."""
    found = [whole(store, labels)]
    actions = np.unique([labels.content[clip.name] for clip in store.clips])
    for size in (1, 2, 4):
        for _ in range(SUBSETS):
            features, same, weights = part(store, labels, rng.permutation(actions)[:size])
            found.append((features, same, weights * FEW / SUBSETS))
    return found


def fit(data: list[Pairs]) -> LogisticRegression:
    """The regression of the action's sameness on the two features."""
    features, same, weights = (np.concatenate(parts) for parts in zip(*data, strict=True))
    return LogisticRegression(C=1e6, max_iter=3000).fit(features, same, weights / weights.mean())


def row(name: str, model: LogisticRegression, data: Pairs) -> tuple[str, str]:
    """Rows of the two tables: Brier scores, and chance said : share that is the same in each tenth."""
    features, same, _ = data
    said = model.predict_proba(features)[:, 1]
    bins = np.minimum((said * BINS).astype(int), BINS - 1)
    base = same.mean() * (1 - same.mean())
    cells = [f"{same[bins == b].mean():.2f}" if (bins == b).sum() >= 20 else "" for b in range(BINS)]
    return (
        f"| {name} | {((said - same) ** 2).mean():.3f} | {base:.3f} |",
        f"| {name} | {' | '.join(cells)} |",
    )


def main() -> str:
    """The Markdown section, also printed."""
    rng = np.random.default_rng(0)
    data = {n: pairs(FrameStore.build(d.clips, 30.0, silent), labels, rng) for n, (d, labels) in collections().items()}
    brier, reliability = [], []
    for left, found in data.items():
        model = fit([one for name, those in data.items() if name != left for one in those])
        first, second = row(left, model, found[0])
        brier.append(first)
        reliability.append(second)
    model = fit([one for those in data.values() for one in those])
    (by_distance, by_ratio), even = model.coef_[0], model.intercept_[0]
    text = "\n".join(
        [
            "## Search: scores as chances",
            "",
            "Pairs of whole clips: is the action the same? The regression is fitted on all collections but the one it "
            f"is checked on, each with the same weight, beside {3 * SUBSETS} smaller collections made of each (of 1, "
            f"2 and 4 of its actions, weight {FEW} for each size). Fitted on all: log odds "
            f"{even:.1f} {by_distance:+.1f} distance {by_ratio:+.1f} distance / usual distance (shipped: "
            f"{chance.EVEN} {chance.BY_DISTANCE:+} {chance.BY_RATIO:+}). `python -m benchmarks chances`",
            "",
            "| collection, left out | Brier score | of the base rate |",
            "|---|---|---|",
            *brier,
            "",
            "Reliability: share of pairs of the same action, by the chance that was said (20 pairs or more).",
            "",
            f"| collection, left out | {' | '.join(f'{b / BINS:.1f} to {(b + 1) / BINS:.1f}' for b in range(BINS))} |",
            "|---|" + "---|" * BINS,
            *reliability,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
