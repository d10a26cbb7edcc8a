"""Cost against length: every method on made-up recordings of an hour, of ten and, if asked for, of a hundred.

usage: python -m benchmarks scale
       python -m benchmarks.bench_scale [--hundred] [--only motifs,grammar]

Recordings are made once and kept in the folder that ``MOTIONSCAPE_SCALE`` names (build/scale): six minutes for warming
up, one hour, ten hours, three and a half hours cut into short clips. Each measurement runs in a process of its own and
is kept beside them (``measured``), so that one that was interrupted goes on; delete that folder to measure anew.
"""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from core.demo import make_demo
from core.mocap.dataset import Dataset
from core.motifs.adjacency import nearest_pairs_radius, radius_adjacency
from core.motifs.discovery import largest_first
from core.motifs.matching import Matcher, Rule
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import automatic_kappa, k_means
from core.motifs.samples import sampled_first
from core.poses.features import pose_features
from core.sequences.repeats import remove_runs
from core.workspace import Workspace

ROOT = Path(__file__).resolve().parents[1]
FOLDER = Path(os.environ.get("MOTIONSCAPE_SCALE", ROOT / "build" / "scale"))
CHART = ROOT / "docs" / "images" / "scale.svg"
WARM, HOUR = "demo-6", "demo-60"
SHORT_SECONDS = 4.3  # of a short clip: 2930 of them are three and a half hours
MOST_MEGABYTES = 8000


def _features(dataset: Dataset) -> object:
    return pose_features(dataset)


def _motifs(dataset: Dataset) -> object:
    from core.motifs.build import find_motifs

    return find_motifs(dataset)


def _grammar(dataset: Dataset) -> object:
    from core.grammar.build import learn_grammar

    return learn_grammar(dataset)


def _map(dataset: Dataset) -> object:
    from core.motion_map.build import build_motion_map

    return build_motion_map(dataset)


def _search(dataset: Dataset) -> object:
    from core.retrieval.search import build_search_index

    return build_search_index(dataset)


METHODS: dict[str, Callable[[Dataset], object]] = {
    "features": _features,
    "motifs": _motifs,
    "grammar": _grammar,
    "map": _map,
    "search": _search,
}


def prepared(name: str) -> str:
    """The name of a collection, ``demo-MINUTES`` or ``short-MINUTES``, made where it is not there yet."""
    workspace = Workspace(FOLDER)
    if name not in {info.name for info in workspace.datasets()}:
        kind, minutes = name.split("-")
        dataset = make_demo(minutes=int(minutes))
        workspace.add_dataset(name, _cut(dataset) if kind == "short" else dataset)
    return name


def _cut(dataset: Dataset) -> Dataset:
    """The dataset as clips of a few seconds."""
    clips = []
    for clip in dataset.clips:
        n = max(1, round(clip.seconds / SHORT_SECONDS))
        edges = np.linspace(0, clip.n_frames, n + 1).astype(int)
        clips += [replace(clip.cut(a, b), name=f"{clip.name}_{a:06d}") for a, b in pairwise(edges.tolist())]
    return Dataset("short", tuple(clips))


def measure(method: str, name: str) -> None:
    """Runs a method once, after it has run on a few minutes, and prints what it took as JSON."""
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEGABYTES << 20,) * 2)
    workspace = Workspace(FOLDER)
    METHODS[method](workspace.open(WARM))
    dataset = workspace.open(name)
    wall, cpu = time.perf_counter(), time.process_time()
    METHODS[method](dataset)
    seconds, processor = time.perf_counter() - wall, time.process_time() - cpu
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(json.dumps({"hours": dataset.seconds / 3600, "seconds": seconds, "cpu": processor, "megabytes": peak}))


def measured(method: str, name: str) -> dict[str, float] | None:
    """What a method took on a collection, measured in a process of its own; None where it did not end well."""
    kept = FOLDER / "measured" / f"{method}-{name}.json"
    if not kept.exists():
        command = [sys.executable, "-m", "benchmarks.bench_scale", "--measure", method, prepared(name)]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
        if done.returncode:
            print(done.stderr[-500:], file=sys.stderr)
            return None
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(done.stdout.splitlines()[-1], encoding="utf-8")
    found: dict[str, float] = json.loads(kept.read_text(encoding="utf-8"))
    print(method, name, found, file=sys.stderr)
    return found


def quality(minutes: int = 15, seeds: int = 4) -> list[str]:
    """Motifs found in samples beside the exact ones, on recordings short enough for both: rows of a table."""
    parameters, poses = MotifParameters(), pose_features(make_demo(minutes=minutes))
    letters = k_means(poses.values, automatic_kappa(poses.values, poses.fps))
    runs = remove_runs(letters.labels, poses.clip_starts)
    adjacency = radius_adjacency(letters.centres, nearest_pairs_radius(letters.centres, parameters.reach))
    limits = parameters.strictness * adjacency.radius, parameters.min_seconds * poses.fps
    rule = Rule(parameters.min_letters, parameters.max_letters, parameters.gamma, parameters.slack, *limits)
    matcher, weighing = Matcher(runs, adjacency), {"tightness": parameters.tightness}

    def figures(motifs: list[np.ndarray]) -> tuple[float, float, int]:
        widths = [runs.middles[m[:, 1]] - runs.middles[m[:, 0]] for m in motifs]
        volume = sum((len(w) - 1) * float(w.mean()) for w in widths)
        return volume, float(sum(w.sum() for w in widths)) / len(poses.values), len(motifs)

    exact = figures(largest_first(runs, matcher.all(rule), rule, 1.0, **weighing))
    rows = [f"| everything at once (exact) | 1 | {exact[1]:.3f} | {exact[2]} |"]
    for size in (8000, 4000):
        found = [figures(sampled_first(runs, matcher, rule, 1.0, size, seed, **weighing)) for seed in range(seeds)]
        volumes, covered, numbers = np.array(found).T
        volumes /= exact[0]
        rows.append(
            f"| {size} of {len(runs.letters)} changes of pose | {np.median(volumes):.3f} "
            f"({volumes.min():.3f}-{volumes.max():.3f}) | {np.median(covered):.3f} | {np.median(numbers):.0f} |"
        )
    return rows


def exponent(points: list[dict[str, float]]) -> float:
    """By which power of the length processor time grows from the shortest to the longest collection."""
    low, high = points[0], points[-1]
    return float(np.log(high["cpu"] / low["cpu"]) / np.log(high["hours"] / low["hours"]))


def table(found: dict[str, list[dict[str, float]]]) -> list[str]:
    """A row a method, a column a length: processor seconds, seconds on the clock, megabytes."""
    lengths = max(found.values(), key=len)
    heads = [f"{point['hours']:.0f} h: CPU s | clock s | MB" for point in lengths]
    rows = [f"| method | {' | '.join(heads)} | exponent |", "|---" * (3 * len(heads) + 2) + "|"]
    for method, points in found.items():
        cells = [f"{p['cpu']:.1f} | {p['seconds']:.1f} | {p['megabytes']:.0f}" for p in points]
        cells += ["- | - | -"] * (len(lengths) - len(points))
        rows.append(f"| {method} | {' | '.join(cells)} | {f'{exponent(points):.2f}' if len(points) > 1 else '-'} |")
    return rows


def chart(found: dict[str, list[dict[str, float]]]) -> str:
    """Processor time against length as SVG, both logarithmic, with the line of equal growth."""
    width, height, left, bottom = 560, 380, 60, 330
    points = [p for row in found.values() for p in row]
    x0, x1 = np.log10(0.9 * min(p["hours"] for p in points)), np.log10(1.1 * max(p["hours"] for p in points))
    y0, y1 = np.log10(0.7 * min(p["cpu"] for p in points)), np.log10(1.5 * max(p["cpu"] for p in points))

    def at(hours: float, cpu: float) -> str:
        x = left + (np.log10(hours) - x0) / (x1 - x0) * (width - left - 110)
        y = bottom - (np.log10(cpu) - y0) / (y1 - y0) * (bottom - 20)
        return f"{x:.1f},{y:.1f}"

    names_at, lowest = {}, 0.0  # names beside the last points, one below the other
    for method, row in sorted(found.items(), key=lambda item: -item[1][-1]["cpu"]):
        lowest = names_at[method] = max(float(at(row[-1]["hours"], row[-1]["cpu"]).split(",")[1]) + 4, lowest + 14)
    colours = ("#3366aa", "#cc5522", "#338855", "#884499", "#777711")
    parts = []
    for cpu in (10.0**e for e in range(-1, 6) if y0 <= e <= y1):
        (a, y), (b, _) = at(10**x0, cpu).split(","), at(10**x1, cpu).split(",")
        parts.append(f'<path d="M{a} {y}H{b}" stroke="#ddd"/><text x="52" y="{y}" text-anchor="end">{cpu:g} s</text>')
    for hours in sorted({round(p["hours"]) for p in points}):
        x = at(hours, 1).split(",")[0]
        parts.append(f'<text x="{x}" y="{bottom + 18}" text-anchor="middle">{hours} h</text>')
    for colour, (method, row) in zip(colours, found.items(), strict=False):
        line = " ".join(at(p["hours"], p["cpu"]) for p in row)
        dots = "".join('<circle r="4" cx="{}" cy="{}"/>'.format(*place.split(",")) for place in line.split())
        x = float(line.split()[-1].split(",")[0]) + 10
        parts.append(
            f'<g fill="{colour}"><polyline points="{line}" fill="none" stroke="{colour}" stroke-width="2"/>{dots}'
            f'<text x="{x:.1f}" y="{names_at[method]:.1f}">{method}</text></g>'
        )
    longest = max(p["hours"] for p in points)
    shortest, base = min(p["hours"] for p in points), min(p["cpu"] for p in points)
    even = f"{at(shortest, base)} {at(longest, base * longest / shortest)}"
    parts.append(f'<polyline points="{even}" fill="none" stroke="#999" stroke-dasharray="4 4"/>')
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
        f'font-size="12"><rect width="{width}" height="{height}" fill="#fff"/>{"".join(parts)}'
        f'<text x="{left}" y="{height - 10}">Processor seconds against hours of motion; dashed: growth in proportion'
        f"</text></svg>\n"
    )


def main(hundred: bool = False, only: list[str] | None = None) -> str:
    """The Markdown section, also printed."""
    prepared(WARM)
    names = [HOUR, "demo-600", *(["demo-6000"] if hundred else [])]
    methods = only or list(METHODS)
    found = {method: [p for name in names if (p := measured(method, name))] for method in methods}
    found = {method: points for method, points in found.items() if points}
    short = {m: p for m in ("motifs", "grammar") if m in methods and (p := measured(m, "short-210"))}
    CHART.write_text(chart(found), encoding="utf-8")
    clips = [f"| {m} | {p['cpu']:.1f} | {p['seconds']:.1f} | {p['megabytes']:.0f} |" for m, p in short.items()]
    text = "\n".join(
        [
            "## Cost against length",
            "",
            "The demo made an hour and ten hours long: motion that repeats itself all the time. 30 frames a second are "
            "looked at, 15 for the grammar. Recordings lie in a workspace; reading them is part of the time. "
            "Megabytes: the most the process had, mapped files included. The machine was busy (load 10 to 14 on two "
            "cores), so processor seconds say more than seconds on the clock. Exponent: of the processor time. "
            "`python -m benchmarks scale`; with "
            "`python -m benchmarks.bench_scale --hundred` also a hundred hours.",
            "",
            *table(found),
            "",
            "![Processor time against length](images/scale.svg)",
            "",
            f"Three and a half hours as short clips of about {SHORT_SECONDS} seconds:",
            "",
            "| method | CPU s | clock s | MB |",
            "|---|---|---|---|",
            *clips,
            "",
            "Motifs found in samples beside the exact ones, demo of fifteen minutes: sum of the volumes (motions - 1) "
            "x (mean width) as a share of the exact one's, coverage, motifs; medians of 4 seeds of the sampling "
            "(least-most).",
            "",
            "| searched in | volume | coverage | motifs |",
            "|---|---|---|---|",
            *quality(),
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    if "--measure" in sys.argv:
        measure(*sys.argv[-2:])
    else:
        chosen = sys.argv[sys.argv.index("--only") + 1].split(",") if "--only" in sys.argv else None
        main("--hundred" in sys.argv, chosen)
