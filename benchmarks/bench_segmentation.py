"""Motifs, actions and usual baselines as a segmentation, beside labels.

usage: python -m benchmarks segmentation

Where the outside judge eval_segmentation.py is here, every result is also scored by it and the largest difference told.
"""

from __future__ import annotations

import collections
import importlib.util
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np

from benchmarks.recordings import SHARED
from benchmarks.segmented import COLLECTIONS, demo
from benchmarks.segmenters import PENALTIES, Classes, change_points, hidden_markov, locomotif
from core.evaluation.action_segmentation import SegmentationScores, score_segmentation
from core.grammar.identification import find_terminals
from core.grammar.parameters import TerminalParameters
from core.mocap.dataset import Dataset
from core.motifs.build import MotifParameters, find_motifs

SEEDS = range(3)
TUNED = (0, 1)  # seeds of the demos on which the penalty of a change point is chosen; the demo of the table has another
SHOWN = (2, 4, 6, 8, 10, 12, 14, 16, 20, 25, 30, 40)  # numbers of actions in the table of the curve

Method = Callable[[Dataset, int, int], Classes]  # of a data set, its number of actions, and a seed


def motifs(dataset: Dataset, k: int, seed: int) -> Classes:
    """Motifs with the defaults."""
    return [motif.segments for motif in find_motifs(dataset, MotifParameters(seed=seed)).motifs]


def actions(dataset: Dataset, k: int, seed: int, number: int | str = "auto") -> Classes:
    """Actions of the grammar with the defaults; ``number`` 0: as many as there are labelled actions."""
    return find_terminals(dataset, TerminalParameters(n_terminals=number or k, seed=seed)).segments


METHODS: dict[str, tuple[Method, bool]] = {
    "**actions, number chosen**": (actions, True),
    "actions, as many as labels": (partial(actions, number=0), True),
    "actions, 20": (partial(actions, number=20), True),
    "motifs": (motifs, True),
    "LoCoMotif": (lambda dataset, k, seed: locomotif(dataset), False),
    "k-means + HMM, as many as labels": (hidden_markov, True),
}
"""Name -> method, and whether another seed may give another result."""


class Judge:
    """The outside judge, where it is here, and the largest difference from our scores."""

    def __init__(self) -> None:
        path, self.apart, self.module = SHARED / "eval" / "eval_segmentation.py", 0.0, None
        if path.is_file():
            spec = importlib.util.spec_from_file_location("segmentation_judge", path)
            self.module = importlib.util.module_from_spec(spec)
            spec.loader.exec_module(self.module)

    def check(self, classes: Classes, dataset: Dataset, ours: SegmentationScores) -> None:
        """Scores the classes as the judge's command does, and keeps the largest difference."""
        if self.module is None:
            return
        found, labels = collections.defaultdict(list), collections.defaultdict(list)
        for k, segments in enumerate(classes):
            for clip, start, end in segments:
                found[clip].append((start, end, f"#{k}"))
        for clip, start, end, action in dataset.labels:
            labels[clip].append((start, end, action))
        P, G = [], []
        for clip in sorted(c for c in labels if c in found):
            n = max(end for _, end, _ in (*labels[clip], *found[clip]))
            true, said = self.module.frames(labels[clip], n), self.module.frames(found[clip], n)
            P.append(said[true != ""])
            G.append(true[true != ""])
        for matching, by_all, by_clip in (
            (self.module.one_to_one, ours.one_to_one, ours.clip_one_to_one),
            (self.module.many_to_one, ours.many_to_one, ours.clip_many_to_one),
        ):
            for mine, maps in (
                (by_all, [matching(P, G)] * len(P)),
                (by_clip, [matching([p], [g]) for p, g in zip(P, G, strict=True)]),
            ):
                theirs = self.module.score(P, G, maps)
                self.apart = max(self.apart, *(abs(theirs[name] - value) for name, value in mine.to_json().items()))


def main() -> str:
    """The Markdown section, also printed."""
    text = "\n".join(["## Segmentation", "", "`python -m benchmarks segmentation`", "", *tables()])
    print(text)
    return text


def tables() -> Iterator[str]:
    """The rows of the tables."""
    judge, penalty = Judge(), best_penalty()
    methods = METHODS | {
        "change points + Ward, as many as labels": (
            lambda dataset, k, seed: change_points(dataset, k, penalty),
            False,
        )
    }
    yield (
        "MoF, Edit and F1 as in `core/evaluation/action_segmentation.py`, from 0 to 100: the median of three seeds "
        "(least-most). One to one: a class stands for at most one action. Many to one: for the action that covers most "
        "of it. A clip: classes matched anew in every clip. Baselines with “as many as labels” are told the number of "
        "actions. LoCoMotif has its best settings on the exercises (bench_motifs.py), at 30 frames a second, or at 10 "
        "where there are more than 20 000 of them, as its memory grows with their square. Change points: kernel change "
        f"point detection of `ruptures`, penalty {penalty:g}, best of {', '.join(f'{p:g}' for p in PENALTIES)} (mean "
        "F1@50) on two demos that are not in the table. The joined clips are one action each, cross-faded into takes "
        "of twelve in random order."
    )
    curves = {}
    for name, make in COLLECTIONS.items():
        dataset = make()
        if dataset is None:
            continue
        k = len({label.action for label in dataset.labels})
        yield from ["", f"**{name}**: {len(dataset.clips)} clips, {dataset.seconds / 60:.1f} minutes, {k} actions.", ""]
        yield (
            "| | classes | MoF | Edit | F1@10 | F1@25 | F1@50 | many to one: MoF | Edit | F1@50 | MoF a clip |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|"
        )
        for method, (run, seeded) in methods.items():
            found = [run(dataset, k, seed) for seed in (SEEDS if seeded else SEEDS[:1])]
            scores = [score_segmentation(classes, dataset.labels) for classes in found]
            for classes, score in zip(found, scores, strict=True):
                judge.check(classes, dataset, score)
            yield f"| {method} | " + " | ".join(_cells(scores)) + " |"
        curves[name, k] = find_terminals(dataset, TerminalParameters()).description
    yield from _curve(curves)
    yield ""
    yield (
        f"The largest difference from `eval_segmentation.py` in all these results: {judge.apart:.4f}."
        if judge.module
        else "The outside judge is not here."
    )


def _curve(curves: dict[tuple[str, int], dict[int, float]]) -> Iterator[str]:
    yield from [
        "",
        "How many actions: nats that describe a piece of motion (`core/grammar/grouping.py`) by the number of actions; "
        "the least is chosen. The noise in the rule is measured in the recordings, so no constant was fitted.",
        "",
        "| | actions labelled | chosen | " + " | ".join(map(str, SHOWN)) + " |",
        "|" + "---|" * (len(SHOWN) + 3),
    ]
    for (name, k), curve in curves.items():
        cells = [f"{curve[n]:.2f}" if n in curve else "" for n in SHOWN]
        yield f"| {name} | {k} | {min(curve, key=curve.__getitem__)} | " + " | ".join(cells) + " |"


def _cells(scores: list[SegmentationScores]) -> list[str]:
    one, many = [s.one_to_one for s in scores], [s.many_to_one for s in scores]
    values = [
        [s.classes for s in scores],
        [s.mof for s in one],
        [s.edit for s in one],
        *([s.f1[i] for s in one] for i in range(3)),
        [s.mof for s in many],
        [s.edit for s in many],
        [s.f1[2] for s in many],
        [s.clip_one_to_one.mof for s in scores],
    ]
    return [f"{np.median(values[0]):.0f}", *map(_spread, values[1:])]


def _spread(values: list[float]) -> str:
    low, middle, high = np.percentile(values, [0, 50, 100])
    return f"{middle:.1f}" if len(values) == 1 else f"{middle:.1f} ({low:.0f}-{high:.0f})"


def best_penalty() -> float:
    """The penalty with the best mean F1@50 on demos that are not in the table."""
    worth = dict.fromkeys(PENALTIES, 0.0)
    for seed in TUNED:
        dataset = demo(seed)
        k = len({label.action for label in dataset.labels})
        for penalty in PENALTIES:
            score = score_segmentation(change_points(dataset, k, penalty), dataset.labels)
            worth[penalty] += score.one_to_one.f1[2]
    return max(worth, key=worth.__getitem__)


if __name__ == "__main__":
    main()
