"""Terminals: our search beside the paper's, and both beside labels.

usage: python -m benchmarks.bench_terminals
"""

from __future__ import annotations

import csv
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from joblib import Parallel, delayed

from benchmarks.recordings import asfamc, exercises
from core.demo import make_demo
from core.evaluation.segmentation import (
    boundaries_of,
    boundary_intervals,
    frame_accuracy,
    score_boundaries,
)
from core.grammar.identification import find_several, find_terminals, search, space_of
from core.grammar.parameters import TerminalParameters
from core.grammar.terminals import Terminals
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.labels import read_labels

SEEDS = range(100, 108)  # of demos; none of them was looked at while parameters were chosen
MINUTES = 8
TOLERANCE = 0.5  # seconds by which a boundary of the demo may be off
USUAL = 20
DEFAULTS = TerminalParameters(n_terminals=USUAL)


def main() -> str:
    """The Markdown section, also printed."""
    small = make_demo(0.3)
    find_terminals(small, TerminalParameters(n_terminals=3))  # compiles
    find_terminals(small, TerminalParameters(n_terminals=3, method="paper", generations=2, iterations=5))
    parts = [*optimisers(), *agreement(), *length()]
    text = "\n".join(["## Terminals", "", "`python -m benchmarks terminals`", "", *parts])
    print(text)
    return text


def optimisers() -> Iterator[str]:
    """Rows: the same poses and objective, ours and the paper's way on three grids."""
    yield from [
        "The same poses, limits, weight and number of terminals for all; processor seconds of the search alone. Paper: "
        "100 segmentations, 500 generations on a grid of the given seconds, then 1000 moves and changes of length.",
        "",
        "| recordings | search | F | R | E' | segments | seconds | F / ours | seconds / ours |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    collections = {
        "demo, 2 minutes": (make_demo(2, seed=200), 12),
        "demo, 3.6 minutes": (make_demo(3.6, seed=300), 16),
        "CMU exercises": (exercises(), 9),
    }
    for name, (dataset, k) in collections.items():
        if dataset is None:
            continue
        base = replace(DEFAULTS, n_terminals=k)
        space, ours = space_of(dataset, base), None
        searches = {"ours": base, "ours, beginnings alone": replace(base, crossings=0)}
        searches["ours, one beginning"] = replace(base, starts=1)
        for grid in (15, 8, 4):
            searches[f"paper, {grid / base.analysis_fps:.2g} s"] = replace(base, method="paper", grid=grid)
        searches["annealing, 0.53 s"] = replace(base, method="annealing", grid=8)
        for label, parameters in searches.items():
            started = time.process_time()
            found = search(space, parameters)
            seconds, value = time.process_time() - started, found.objective(space, base.weight)
            ours = ours or (value["F"], seconds)
            row = (
                f"| {name} | {label} | {value['F']:.1f} | {value['R']:.4f} | {value['E']:.5f} | {len(found.spans)} "
                f"| {seconds:.1f} | {value['F'] / ours[0]:.2f} | {seconds / ours[1]:.1f} |"
            )
            print(row, flush=True)
            yield row


def agreement() -> Iterator[str]:
    """Rows: agreement with labels; demos first, each number of terminals over all seeds."""
    yield from [
        "",
        f"Agreement with labels. Demos of {MINUTES} minutes, seeds {SEEDS.start} to {SEEDS.stop - 1} (parameters were "
        "chosen on seeds 0 to 3). One to one: each terminal stands for at most one action and each action for at "
        "most one terminal; many to one: each terminal for its most frequent action. Boundaries of demos and exercises "
        f"count within {TOLERANCE:g} s, those of CMU 86 within the intervals of its labels.",
        "",
        "| recordings | actions | terminals | one to one | many to one | boundary precision | boundary recall |",
        "|---|---|---|---|---|---|---|",
    ]
    scored = Parallel(n_jobs=4)(delayed(_demo_scores)(seed) for seed in SEEDS)
    for name in scored[0][1]:
        for seed, (actions, scores) in zip(SEEDS, scored, strict=True):
            k, values = scores[name]
            yield f"| demo {seed} | {actions} | {k} | " + " | ".join(f"{value:.3f}" for value in values) + " |"
        rows = np.array([scores[name][1] for _, scores in scored])
        yield f"| **demos, median (lowest to highest)** | | {name} | " + " | ".join(map(_spread, rows.T)) + " |"
    for name, dataset, accepted in _real():
        actions = len({label.action for label in dataset.labels})
        for k in (actions, 2 * actions):
            chosen = [replace(DEFAULTS, n_terminals=k, seed=seed) for seed in range(4)]
            rows = np.array([_scores(find_terminals(dataset, p), dataset, accepted) for p in chosen])
            yield f"| {name}, 4 seeds of the search | {actions} | {k} | " + " | ".join(map(_spread, rows.T)) + " |"


def _demo_scores(seed: int) -> tuple[int, dict[str, tuple[int, tuple[float, ...]]]]:
    demo = make_demo(MINUTES, seed)
    actions = len({label.action for label in demo.labels})
    found = find_several(demo, DEFAULTS, (actions, USUAL))
    names = ("as many as actions", f"{USUAL}")
    return actions, {name: (t.n_terminals, _scores(t, demo)) for name, t in zip(names, found, strict=True)}


def _scores(found: Terminals, dataset: Dataset, accepted: dict | None = None) -> tuple[float, ...]:
    if accepted is None:
        rates = {clip.name: clip.fps for clip in dataset.clips}
        accepted = boundary_intervals(dataset.labels, TOLERANCE, rates)
    boundaries = score_boundaries(boundaries_of(found.segments), accepted)
    return (*frame_accuracy(found.segments, dataset.labels), boundaries.precision, boundaries.recall)


def _spread(values: Sequence[float]) -> str:
    low, middle, high = np.percentile(values, [0, 50, 100])
    return f"{middle:.3f} ({low:.3f} to {high:.3f})"


def _real() -> Iterator[tuple[str, Dataset, dict | None]]:
    """The labelled recordings that are here: name, data set with labels, accepted intervals of its boundaries."""
    folder = asfamc()
    if folder is None:
        return
    marks = folder.parents[1] / "labels"
    dataset = open_dataset(folder / "86", clips=("86_01", "86_09"), labels=marks / "cmu86")
    yield "CMU 86_01, 86_09", dataset, accepted_intervals(marks / "cmu86")
    yield "CMU exercises", replace(exercises(), labels=read_labels(marks / "mocap6")), None


def accepted_intervals(folder: Path) -> dict[str, list[tuple[int, int]]]:
    """Clip -> the intervals (earliest, latest) in which each inner boundary counts, as the label files give them."""
    accepted = {}
    for path in sorted(folder.glob("*.csv")):
        with path.open(encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        accepted[path.stem] = [(int(row["end_earliest"]), int(row["end_latest"])) for row in rows[:-1]]
    return accepted


def length() -> Iterator[str]:
    """How long recordings of about 13 000 frames take, as many as the paper's longest."""
    yield from ["", "Recordings as long as the paper's longest (12 908 frames), 20 terminals:", ""]
    yield from ["| recordings | frames | poses looked at | seconds | of the processor |", "|---|---|---|---|---|"]
    demo = make_demo(3.6, seed=300)
    for fps in (DEFAULTS.analysis_fps, 60.0):
        wall, own = time.perf_counter(), time.process_time()
        find_terminals(demo, replace(DEFAULTS, analysis_fps=fps))
        wall, own = time.perf_counter() - wall, time.process_time() - own
        yield f"| demo, {fps:g} poses a second | {demo.n_frames} | {demo.seconds * fps:.0f} | {wall:.1f} | {own:.1f} |"


if __name__ == "__main__":
    main()
