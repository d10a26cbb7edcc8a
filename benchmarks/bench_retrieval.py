"""Search engines against labels: ours, the paper's as printed, those it compares itself with, and chance.

usage: python -m benchmarks retrieval
"""

from __future__ import annotations

import time

from benchmarks.recordings import SHARED
from core.mocap.clip import Label
from core.mocap.dataset import Dataset, open_dataset
from core.rankings import BASELINE_NAMES, CHANCE, RankingParameters, evaluate, rank_dataset

ENGINES = ("bounded-edit", "parts", "printed", *BASELINE_NAMES, CHANCE)
WORDS = {
    "bounded-edit": "`bounded-edit` (the default)",
    "parts": "`parts` (the paper's, repaired)",
    "printed": "`printed` (the paper's as printed)",
    "weighted-pca": "weighted PCA + time warping (Forbes and Fiume 2005)",
    "pose-clusters": "pose clusters + edit distance (Liu et al. 2005, softened)",
    "position-dtw": "time warping of positions and velocities",
    "match-webs": "match webs (Kovar and Gleicher 2004), 10 Hz",
    "chance": "chance",
}


def recordings() -> tuple[Dataset, str]:
    """Labelled clips of one action each and what they are: real ones, or cuts of the demo where there are none."""
    folder = SHARED / "data" / "bandai_namco_1"
    if folder.is_dir():
        return open_dataset(folder), "`bandai_namco_1`: 16 contents in 15 styles"
    from core.demo import make_demo

    demo = make_demo(minutes=15)
    clips, labels = [], []
    for label in demo.labels:
        name = f"{label.clip}_{label.start}"
        clips.append(demo.clip(label.clip).cut(label.start, label.end, name))
        labels.append(Label(name, 0, clips[-1].n_frames, f"{label.action}/{label.clip.split('_')[0]}"))
    return Dataset("demo", tuple(clips), tuple(labels)), "cuts of the demo: the real recordings are not here"


def accuracy(dataset: Dataset) -> list[str]:
    """Rows of the table of accuracy, an engine each."""
    started = time.process_time()
    rankings = rank_dataset(dataset, RankingParameters(engines=",".join(ENGINES), queries=len(dataset.clips)))
    print(f"{time.process_time() - started:.0f} s of CPU time")
    rows = []
    for name, regimes in evaluate(rankings, dataset).engines.items():
        apart, every = (regimes[regime].measures for regime in ("XSTYLE", "ALL"))
        spread = f"{apart['mAP'].low:.2f}-{apart['mAP'].high:.2f}"
        figures = [f"{apart[m].mean:.3f}" for m in ("P@20", "nP@20", "mAP")]
        figures += [spread, f"{apart['1-NN'].mean:.3f}"]
        figures += [f"{every[m].mean:.3f}" for m in ("nP@20", "mAP", "1-NN", "styleAUC")]
        rows.append(f"| {WORDS[name]} | " + " | ".join(figures) + f" | {rankings.seconds[name]:.1f} |")
    return rows


def main() -> str:
    """The Markdown section, also printed."""
    dataset, source = recordings()
    text = "\n".join(
        [
            "## Search: accuracy",
            "",
            f"{len(dataset.clips)} clips ({source}), every clip a query against all others. XSTYLE: clips of the "
            "query's own content and style removed first. In brackets the 95 % bootstrap interval of mAP. Seconds "
            "(of a busy machine): index and all queries, or all pairs. `python -m benchmarks retrieval`",
            "",
            "| | XSTYLE P@20 | nP@20 | mAP | (95 %) | 1-NN | ALL nP@20 | mAP | 1-NN | style AUC | s |",
            "|---|---|---|---|---|---|---|---|---|---|---|",
            *accuracy(dataset),
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
