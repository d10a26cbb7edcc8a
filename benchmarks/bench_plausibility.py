"""Combined queries: do halves of one motion and halves of two different actions separate?

usage: python -m benchmarks plausibility
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from sklearn.metrics import roc_auc_score

from benchmarks.labelled import Collection, collections, some_clips
from core.retrieval.bounded_edit import BoundedEdit
from core.retrieval.plausibility import plausibility
from core.retrieval.queries import hybrid_query
from core.retrieval.search import SearchIndex, build_search_index

TRIES = 60


def ratios(collection: Collection, held_out: bool, seed: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Ratios of real and of made combinations ``(TRIES,)`` each. held_out: whether the index lacks their clips."""
    dataset, labels = collection
    rng = np.random.default_rng(seed)
    whole = build_search_index(dataset)
    found: tuple[list[float], list[float]] = ([], [])
    for _ in range(TRIES):
        upper = dataset.clips[rng.integers(len(dataset.clips))]
        others = [clip for clip in dataset.clips if labels.content[clip.name] != labels.content[upper.name]]
        for made, lower in enumerate((upper, others[rng.integers(len(others))])):
            query = hybrid_query({"upper_body": (upper, None, None), "lower_body": (lower, None, None)})
            index = without(whole, {upper.name, lower.name}) if held_out else whole
            found[made].append(plausibility(index, query).ratio)
    return np.array(found[0]), np.array(found[1])


def without(index: SearchIndex, names: set[str]) -> SearchIndex:
    """An index of the default engine without some clips."""
    others = np.flatnonzero([clip.name not in names for clip in index.clips])
    return replace(index, engine=BoundedEdit(some_clips(index.engine.store, others)))


def main() -> str:
    """The Markdown section, also printed."""
    rows = []
    for name, collection in collections().items():
        cells = []
        for held_out in (False, True):
            real, made = ratios(collection, held_out)
            is_made = np.repeat([0, 1], TRIES)
            cells.append(f"{roc_auc_score(is_made, np.concatenate([real, made])):.3f}")
            cells.append(f"{np.median(real):.1f} / {np.median(made):.1f}")
        rows.append(f"| {name} | {' | '.join(cells)} |")
    text = "\n".join(
        [
            "## Search: plausible combinations",
            "",
            f"{TRIES} times the halves of one clip, and of two clips of different actions. AUC: how well the "
            "ratio of `core/retrieval/plausibility.py` tells them apart; beside it the median ratio of real and made "
            "ones. Once with the clips in the index, as in the app, and once without both. "
            "`python -m benchmarks plausibility`",
            "",
            "| collection | AUC, in the index | real / made | AUC, not in it | real / made |",
            "|---|---|---|---|---|",
            *rows,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
