"""Does the setting that a sweep suggests agree with people's labels about as well as the best one?

usage: python -m benchmarks.bench_suggestion

The rule was made on the five exercise clips; the other collections are there to test it. Labels are never seen by it.
"""

from __future__ import annotations

import numpy as np

from benchmarks.recordings import SHARED, asfamc, exercises
from core.demo import make_demo
from core.figures import figures_of
from core.mocap.clip import Label
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.labels import read_labels
from core.motifs.axes import PAPER
from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import suggest
from core.motifs.sweep import sweep
from core.motifs.sweep_table import SweepTable

SEEDS = 8
TRIALS = ((1, 8), (3, 6), (5, 4), (8, 1))  # seeds a sweep, and how many sweeps with so many

Labelled = tuple[str, Dataset, tuple[Label, ...]]


def collections() -> list[Labelled]:
    """Name, recordings and labels; the demo alone where no others are here."""
    demo = make_demo(minutes=6)
    found: list[Labelled] = [("demo, 6 minutes", demo, demo.labels)]
    folder, labels = asfamc(), SHARED / "data" / "labels"
    if folder:
        pair = open_dataset(folder / "86", clips="86_01,86_09")
        found.insert(0, ("CMU 86_01, 86_09", pair, read_labels(labels / "cmu86")))
        found.insert(0, ("five exercise clips", exercises(), read_labels(labels / "mocap6")))
    return found


def table_of(dataset: Dataset, labels: tuple[Label, ...], base: MotifParameters) -> SweepTable:
    """The paper's ranges with eight seeds."""
    points = sweep(dataset, base, PAPER, SEEDS)
    return SweepTable(PAPER, SEEDS, [figures_of(point.graph, labels) for point in points])


def only(table: SweepTable, seeds: np.ndarray) -> SweepTable:
    """The same sweep with some of its seeds."""
    kept = [entry for k, entry in enumerate(table.figures) if k % SEEDS in set(seeds)]
    return SweepTable(table.axes, len(seeds), kept)


def chord_knee(table: SweepTable) -> tuple[int, ...]:
    """For comparison: of the cells that none beats in both error and coverage the one furthest from the chord."""
    error, coverage = table.middle("error_ratio"), table.middle("coverage")
    cells = [c for c in np.ndindex(error.shape) if np.isfinite(error[c])]  # without motifs there is no error
    front = sorted(
        (c for c in cells if not any(error[d] < error[c] and coverage[d] >= coverage[c] for d in cells)),
        key=lambda c: (error[c], coverage[c]),
    )
    x, y = np.array([error[c] for c in front]), np.array([coverage[c] for c in front])
    spans = max(np.ptp(x), 1e-9), max(np.ptp(y), 1e-9)
    return front[int(((y - y[0]) / spans[1] - (x - x[0]) / spans[0]).argmax())]


def row(name: str, table: SweepTable) -> str:
    """One row: what is suggested from all seeds, how it agrees, and how far fewer seeds stay behind the best."""
    f1, purity = table.middle("f1_majority"), table.middle("purity")
    found, rng, behind = suggest(table), np.random.default_rng(0), []
    for n, repeats in TRIALS:
        sets = [rng.choice(SEEDS, n, replace=False) for _ in range(repeats)]
        behind.append(np.mean([f1.max() - f1[suggest(only(table, s)).index] for s in sets]))
    at = ", ".join(f"{k} {v:g}" for k, v in found.at.items())
    cells = [
        name, at, found.verdict, f"{f1[found.index]:.3f}", f"{f1.max():.3f}", f"{np.median(f1):.3f}",
        f"{f1[chord_knee(table)]:.3f}", f"{purity[found.index]:.3f}", *(f"{loss:.3f}" for loss in behind),
    ]  # fmt: skip
    return "| " + " | ".join(cells) + " |"


def main() -> str:
    """The Markdown section, also printed."""
    rows = []
    for name, dataset, labels in collections():
        for adjacency in ("radius", "spheres"):
            rows.append(row(f"{name}, {adjacency}", table_of(dataset, labels, MotifParameters(adjacency=adjacency))))
            print(rows[-1], flush=True)
    head = ["collection", "suggested", "verdict", "F1", "best F1", "median F1", "F1 of chord knee", "purity"]
    head += [f"behind, {n} seed{'s' * (n > 1)}" for n, _ in TRIALS]
    text = "\n".join(
        [
            "## Suggestion",
            "",
            "Sweeps over the paper's ranges (6 x 5 settings, 8 seeds). F1 of the suggested setting beside the best and "
            "the median of the 30 (medians over seeds); chord knee: the setting on the error-coverage front furthest "
            "from the line between its ends. Behind: the F1 of the best setting minus that of the suggestion, "
            "with this many seeds. "
            "The rule was developed on the exercise clips. `python -m benchmarks.bench_suggestion`",
            "",
            "| " + " | ".join(head) + " |",
            "|---" * len(head) + "|",
            *rows,
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
