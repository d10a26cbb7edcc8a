"""Sweep: 6 x 5 points in one go against 30 separate analyses, one after the other, in the same process.

usage: python -m benchmarks.bench_sweep

Both sides are warm and exclude reading the recordings. A separate analysis uses all cores where the engine can.
"""

from __future__ import annotations

import time

from benchmarks.recordings import exercises
from core.mocap.dataset import Dataset
from core.motifs.axes import PAPER, points_of
from core.motifs.build import find_motifs
from core.motifs.graph import MotifGraph
from core.motifs.parameters import MotifParameters
from core.motifs.sweep import graphs_of

SETTINGS = {
    "default": MotifParameters(),
    "spheres": MotifParameters(adjacency="spheres"),
    "default at 120 fps": MotifParameters(analysis_fps=120),
}


def separate(dataset: Dataset, points: tuple[MotifParameters, ...]) -> list[MotifGraph]:
    """Every point by itself."""
    return [find_motifs(dataset, point) for point in points]


def together(dataset: Dataset, points: tuple[MotifParameters, ...], workers: int | None = None) -> list[MotifGraph]:
    """All points as one sweep."""
    found = dict(graphs_of(dataset, points, workers=workers))
    return [found[k] for k in range(len(points))]


def row(name: str, dataset: Dataset, base: MotifParameters) -> str:
    """One row of the table: the sweep, the sweep with one thread, the separate runs; all must give the same graphs."""
    points = points_of(base, PAPER)
    together(dataset, points[:1])
    seconds, graphs = {}, {}
    for way, run in {
        "sweep": together,
        "one": lambda d, p: together(d, p, 1),
        "separate": separate,
    }.items():
        started = time.perf_counter()
        graphs[way] = run(dataset, points)
        seconds[way] = time.perf_counter() - started
    same = all(_content(a) == _content(b) for a, b in zip(graphs["sweep"], graphs["separate"], strict=True))
    share = seconds["sweep"] / seconds["separate"]
    return (
        f"| {name} | {seconds['sweep']:.1f} | {seconds['one']:.1f} | {seconds['separate']:.1f} | {share:.2f} | "
        f"{'yes' if same else 'NO'} |"
    )


def _content(graph: MotifGraph) -> dict:
    return graph.to_json() | {"seconds": None}


def main() -> str:
    """The Markdown section, also printed."""
    dataset, source = exercises(), "five labelled exercise clips (CMU)"
    if dataset is None:
        from core.demo import make_demo

        dataset, source = make_demo(minutes=3), "made-up recordings: the real ones are not here"
    axes = ", ".join(f"{name} {', '.join(f'{v:g}' for v in values)}" for name, values in PAPER.items())
    text = "\n".join(
        [
            "## Sweep",
            "",
            f"30 points ({axes}) on {dataset.n_frames} frames, {source}; seconds, one run each, warm, reading "
            "excluded. Separate: the same 30 analyses one after the other. `python -m benchmarks.bench_sweep`",
            "",
            "| | sweep | sweep, one thread | separate | sweep / separate | same graphs |",
            "|---|---|---|---|---|---|",
            *(row(name, dataset, base) for name, base in SETTINGS.items()),
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
