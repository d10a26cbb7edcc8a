"""Cost against length: every method on made-up recordings of an hour, of ten and, where it was measured, of a hundred.

usage: python -m benchmarks scale
       python -m benchmarks.bench_scale [--hundred] [--only motifs,grammar]

Recordings and measurements are kept, see :mod:`benchmarks.scale_runs`. A hundred hours take the night: they are
measured with ``--hundred`` only, and shown wherever they have been measured.
"""

from __future__ import annotations

import json
import sys

import numpy as np

from benchmarks.scale_runs import FOLDER, METHODS, ROOT, SHORT_SECONDS, SWEPT, WARM, measured, prior
from core.demo import make_demo
from core.estimates import PRIOR
from core.motifs.adjacency import nearest_pairs_radius, radius_adjacency
from core.motifs.discovery import largest_first
from core.motifs.matching import Matcher, Rule
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import automatic_kappa, k_means
from core.motifs.samples import sampled_first
from core.poses.features import pose_features
from core.sequences.repeats import remove_runs

CHART = ROOT / "docs" / "images" / "scale.svg"
HOUR, TEN, HUNDRED = "demo-60", "demo-600", "demo-6000"
IN_A_HUNDRED = ("features", "map", "search", "motifs", "grammar")


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
    rows = [f"| method | {' | '.join(heads)} | exponent | standing |", "|---" * (3 * len(heads) + 3) + "|"]
    for method, points in found.items():
        cells = [f"{p['cpu']:.1f} | {p['seconds']:.1f} | {p['megabytes']:.0f}" for p in points]
        cells += ["- | - | -"] * (len(lengths) - len(points))
        cells += [f"{exponent(points):.2f}" if len(points) > 1 else "-", f"{100 * points[-1]['standing']:.0f} %"]
        rows.append(f"| {method} | {' | '.join(cells)} |")
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
    colours = ("#3366aa", "#cc5522", "#338855", "#884499", "#777711", "#116677", "#aa3366", "#555555", "#996633")
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


def points(method: str, hundred: bool) -> list[dict[str, float]]:
    """What a method took on an hour, on ten, and on a hundred where that is asked for or was measured before."""
    names = [HOUR, TEN]
    if method in IN_A_HUNDRED and (hundred or (FOLDER / "measured" / f"{method}-{HUNDRED}.json").exists()):
        names.append(HUNDRED)
    return [point for name in names if (point := measured(method, name))]


def write_prior() -> None:
    """Writes what estimates of jobs begin with, from everything that was measured."""
    for method in METHODS:
        measured(method, WARM)
    measured("exact", "demo-15")
    PRIOR.write_text(json.dumps({"methods": prior()}, indent=1) + "\n", encoding="utf-8")


def main(hundred: bool = False, only: list[str] | None = None) -> str:
    """The Markdown section, also printed."""
    methods = only or [method for method in METHODS if method != "exact"]
    found = {method: row for method in methods if (row := points(method, hundred))}
    short = {m: p for m in ("motifs", "grammar") if m in methods and (p := measured(m, "short-210"))}
    CHART.write_text(chart(found), encoding="utf-8")
    write_prior()
    clips = [f"| {m} | {p['cpu']:.1f} | {p['seconds']:.1f} | {p['megabytes']:.0f} |" for m, p in short.items()]
    swept = ", ".join(f"{name} {', '.join(map(str, values))}" for name, values in SWEPT.items())
    text = "\n".join(
        [
            "## Cost against length",
            "",
            "The demo made an hour and ten hours long: motion that repeats itself all the time. 30 frames a second are "
            "looked at, 15 for the grammar. Recordings lie in a workspace, for the import as BVH files; reading them "
            f"is part of the time. The sweep has three points ({swept}), stability eleven analyses. "
            "Megabytes: the most the process had, mapped files included. Others used the two cores as well (load 4 to "
            "19), so processor seconds say more than seconds on the clock. Exponent: of the processor time. "
            "Standing: the longest time that stage and per cent on screen did not change, as a share of all. "
            "`python -m benchmarks scale`; with `python -m benchmarks.bench_scale --hundred` also a hundred hours.",
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
    chosen = sys.argv[sys.argv.index("--only") + 1].split(",") if "--only" in sys.argv else None
    main("--hundred" in sys.argv, chosen)
