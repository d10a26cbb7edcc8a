"""Datasets stored by their motifs, against PCA: sizes at equal error, every number counted.

usage: python -m benchmarks.bench_compression
"""

from __future__ import annotations

import sys
import time

from benchmarks.recordings import all_recordings
from core.demo import make_demo
from core.mocap.dataset import Dataset
from core.motifs.build import find_motifs
from core.motifs.compressed_dataset import MOTIF, WAYS, Compression, compress_dataset
from core.motifs.compression import METHODS, OWN, POSE_PCA, Curves

COMMAND = "python -m benchmarks.bench_compression"
TOLERANCES = (0.2, 0.5, 1.0, 2.0, 5.0)  # centimetres
SHARES = (0.05, 0.1, 0.2, 0.4)


def by_ways(result: Compression) -> list[str]:
    """The data set: size at each tolerance, a row for each way."""
    lines = ["| way \\ mean error of every part at most | " + " | ".join(f"{t:g} cm" for t in TOLERANCES) + " |"]
    lines.append("|---" * (len(TOLERANCES) + 1) + "|")
    for way, name in WAYS.items():
        totals = result.totals(way, TOLERANCES)
        lines.append(f"| {name} | " + " | ".join(f"{100 * t.numbers / t.raw:.0f} %" for t in totals) + " |")
    return lines


def by_shares(curves: Curves, number: str) -> list[str]:
    """One motif: error at each size, a row for each method."""
    lines = [
        f"| motif {number}, {curves.motions} motions \\ size | " + " | ".join(f"{100 * s:.0f} %" for s in SHARES) + " |"
    ]
    lines.append("|---" * (len(SHARES) + 1) + "|")
    for method, name in METHODS.items():
        cells = []
        for share in SHARES:
            within = [p for p in curves.points[method] if p.numbers <= share * curves.raw]
            best = min(within, key=lambda p: p.cm, default=None)
            cells.append(f"{best.cm:.1f} cm, {best.pose:.0f}" if best else "-")
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return lines


def wins(result: Compression, tolerance: float = 1.0) -> str:
    """In how many motifs own motions alone take less than PCA of postures."""
    count, total = 0, 0
    for unit in result.units:
        if unit.kind == MOTIF:
            sizes = [
                min((p.numbers for p in unit.curves.points[m] if p.cm <= tolerance), default=unit.curves.raw)
                for m in (OWN, POSE_PCA)
            ]
            count, total = count + (sizes[0] < sizes[1]), total + 1
    rivals = "Own motions alone take less than PCA of postures"
    return f"{rivals}, within {tolerance:g} cm, in {count} of {total} motifs (bodies counted apart)."


def section(name: str, dataset: Dataset) -> list[str]:
    """The tables of one data set."""
    graph = find_motifs(dataset)
    started = time.process_time()
    result = compress_dataset(dataset, graph)
    taken = time.process_time() - started
    motifs = [unit for unit in result.units if unit.kind == MOTIF]
    largest = max(motifs, key=lambda unit: unit.curves.motions)
    seconds = dataset.seconds
    head = f"**{name}**: {seconds / 60:.1f} minutes, {len(graph.motifs)} motifs; {taken:.0f} s of CPU time."
    return [head, "", *by_ways(result), "", *by_shares(largest.curves, largest.name), "", wins(result), ""]


def main() -> str:
    """Measure and write the section."""
    recordings, called = all_recordings()
    lines = [
        "## Compression",
        "",
        "Share of the uncompressed size (30 frames a second, all joints that turn; numbers of 16 bits). In the second "
        "table of each: mean error of joints, and mean distance in pose space (degrees, MMG's measure).",
        "",
    ]
    for name, dataset in (("demo", make_demo(6)), (called, recordings)):
        lines += section(name, dataset)
        print("\n".join(lines), file=sys.stderr)
    return "\n".join([*lines, f"Made by `{COMMAND}`."]) + "\n"


if __name__ == "__main__":
    print(main())
