"""The engine ``parts`` on collections that its constants were not chosen on: choose on all but one, judge on that one.

usage: python -m benchmarks parts
"""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np

from benchmarks.labelled import Collection, collections
from core.evaluation.ranking import ClipLabels
from core.mocap.dataset import Dataset
from core.poses.body_parts import LEAVES
from core.progress import silent
from core.retrieval.parts_index import Matching, Parts
from core.retrieval.queries import whole_query
from core.retrieval.search import SearchParameters

EVENNESS = (0.0, 0.8)  # Parts.EVENNESS
TOLERANCES = (0.2, 0.3, 0.4)  # Matching.tolerance
ALPHAS = (0.25, 0.5, 0.75)
MOST = 120  # clips of a collection, spread evenly over all: all pairs of them are compared


def some(collection: Collection, most: int = MOST) -> Collection:
    """At most ``most`` clips of a collection."""
    dataset, labels = collection
    chosen = np.unique(np.linspace(0, len(dataset.clips) - 1, min(most, len(dataset.clips))).round().astype(int))
    return Dataset(dataset.name, tuple(dataset.clips[k] for k in chosen)), labels


def engine_of(dataset: Dataset, evenness: float = Parts.EVENNESS) -> Parts:
    """An engine with another constant than that which is shipped."""
    kind: type[Parts] = type("Changed", (Parts,), {"EVENNESS": evenness})
    return kind.build(dataset, SearchParameters(method="parts"), silent)


def mean_precision(engine: Parts, dataset: Dataset, labels: ClipLabels, **matching: float) -> float:
    """The mAP of XSTYLE, as core.evaluation.ranking defines it, quickly; ``matching``: constants of Matching."""
    changed = Parts(engine.store, engine.nodes, engine.settings, replace(engine.matching, **matching))
    weights, everyone = dict.fromkeys(LEAVES, 1 / len(LEAVES)), np.arange(len(engine.clips))
    means = []
    for clip in dataset.clips:
        hits = changed.rank_clips(whole_query(clip), weights, among=everyone, top=None, root_path=0.0)
        names = [hit.segment.clip for hit in hits if hit.segment.clip != clip.name]
        content = np.array([labels.content[name] == labels.content[clip.name] for name in names])
        own = content & np.array([labels.style[name] == labels.style[clip.name] for name in names])
        relevant = content[~own]
        if relevant.any():
            means.append((np.cumsum(relevant) / np.arange(1, len(relevant) + 1))[relevant].mean())
    return float(np.mean(means))


def said(point: tuple[float, ...]) -> str:
    """Constants in words."""
    return ", ".join(f"{name} {value:g}" for name, value in zip(("evenness", "tolerance", "alpha"), point, strict=True))


def main() -> str:
    """The Markdown section, also printed."""
    data = {name: some(collection) for name, collection in collections().items()}
    points = list(itertools.product(EVENNESS, TOLERANCES, ALPHAS))
    found = np.zeros((len(points), len(data)))
    for c, (dataset, labels) in enumerate(data.values()):
        engines = {evenness: engine_of(dataset, evenness) for evenness in EVENNESS}
        for p, (evenness, tolerance, alpha) in enumerate(points):
            found[p, c] = mean_precision(engines[evenness], dataset, labels, tolerance=tolerance, alpha=alpha)
    lost = found.max(0) - found
    rows = []
    for c, name in enumerate(data):
        chosen = int(np.argmin(np.delete(lost, c, axis=1).max(1)))
        shipped = found[points.index((Parts.EVENNESS, Matching().tolerance, SearchParameters().alpha)), c]
        rows.append(f"| {name} | {found[chosen, c]:.3f} | {said(points[chosen])} | {shipped:.3f} |")
    best = points[int(np.argmin(lost.max(1)))]
    text = "\n".join(
        [
            "## Search: body parts on collections not chosen on",
            "",
            f"XSTYLE mAP of `parts`, whole clips, at most {MOST} of a collection. Left out: evenness, tolerance and "
            f"alpha are chosen on all other collections, of {len(points)} points, as those that lose least where they "
            f"lose most against the best point for that collection. The choice on all: {said(best)}. "
            "`python -m benchmarks parts`",
            "",
            "| collection | left out | chosen on the others | as shipped |",
            "|---|---|---|---|",
            *rows,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
