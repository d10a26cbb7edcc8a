"""Walks: foot skate and speed at the seams of ten random walks of 30 s, on the demo and on real recordings.

usage: python -m benchmarks.bench_walks
"""

from __future__ import annotations

import tempfile
import time
import warnings
from importlib import import_module
from itertools import pairwise
from pathlib import Path

import numpy as np

from benchmarks.recordings import asfamc
from core.demo import make_demo
from core.editing.blending import ground_fit
from core.editing.contacts import foot_contacts, slide
from core.mocap.bvh import write_bvh
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset, open_dataset
from core.mocap.kinematics import joint_positions
from core.motifs.build import find_motifs
from core.synthesis import Random, Walk, make_walk

WALKS, SECONDS = 10, 30.0
PATHS, BRIDGED = 25, 6


def rate(clip: Clip, contacts: np.ndarray) -> float:
    """Metres a second that feet slide in contacts ``(n_frames, 2)``."""
    metres, seconds = slide(clip, contacts, 0.0)
    return metres / max(seconds, 1e-9)


def cut_speed(dataset: Dataset, walk: Walk) -> float:
    """Metres a second of the fastest joint if the motions were cut, well laid, in the middles of their blends."""
    fastest = 0.0
    for before, after in pairwise(walk.parts):
        if before.fading is None or after.fading is None or before.source.clip != after.fading.clip:
            continue
        ends = before.source.clip, before.source.end - 1, after.source.clip, after.source.start
        if ends[0] == ends[2] and abs(ends[1] - ends[3]) <= 2:
            continue
        a, b = (joint_positions(dataset.clip(name).cut(frame, frame + 1)) for name, frame in ((ends[:2]), (ends[2:])))
        yaw, shift, _ = ground_fit(a, b)
        cosine, sine = np.cos(yaw[0]), np.sin(yaw[0])
        laid = b[0] @ np.array([[cosine, 0, -sine], [0, 1, 0], [sine, 0, cosine]]) + shift[0]
        level = (a[0, :, 1].min() - laid[:, 1].min()) * np.array([0.0, 1, 0])
        fastest = max(fastest, float(np.linalg.norm(laid + level - a[0], axis=1).max()) * walk.clip.fps)
    return fastest


def pybvh_speed(walk: Walk) -> float | None:
    """The same speed in the blends, as pybvh reads the walk's BVH; None where it is not installed."""
    try:
        pybvh = import_module("pybvh")
    except ImportError:
        return None
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")  # its doubts about which way is up
        path = Path(folder, "walk.bvh")
        write_bvh(path, walk.clip)
        places = np.asarray(pybvh.read_bvh_file(str(path)).joint_positions()) * walk.clip.skeleton.unit
    speed = np.linalg.norm(np.diff(places, axis=0), axis=-1).max(1) * walk.clip.fps
    return max((float(speed[max(0, a - 1) : b].max()) for a, b in walk.seams), default=0.0)


def rows_of(dataset: Dataset, **options) -> tuple[list[str], list[dict[str, float]]]:
    """A table row a walk, and its numbers."""
    graph = find_motifs(dataset)
    lines, numbers = [], []
    for seed in range(WALKS):
        started = time.perf_counter()
        walk = make_walk(dataset, graph, Random(SECONDS, seed), **options)
        took = time.perf_counter() - started
        plain = make_walk(dataset, graph, Random(SECONDS, seed), keep_feet=False, **options)
        anew = [rate(w.clip, foot_contacts(w.clip, 0.0)) for w in (plain, walk)]
        read = pybvh_speed(walk)
        one = {
            "ratio": walk.skate.kept / max(walk.skate.plain, 1e-9),
            "anew": anew[1] / max(anew[0], 1e-9),
            "seam": walk.speeds.seams / walk.speeds.sources,
            "read": (read or 0.0) / walk.speeds.sources,
            "took": took,
            **{name: 100 * value for name, value in walk.skate._asdict().items()},
        }
        numbers.append(one)
        cells = [
            f"{seed}",
            f"{walk.clip.seconds:.1f}",
            f"{len(walk.path)}",
            f"{len(walk.seams)}",
            f"{one['source']:.1f}",
            f"{one['plain']:.1f}",
            f"{one['kept']:.1f}",
            f"{one['ratio']:.2f}",
            f"{one['anew']:.2f}",
            f"{walk.speeds.sources:.1f}",
            f"{walk.speeds.seams:.1f}",
            "-" if read is None else f"{read:.1f}",
            f"{cut_speed(dataset, walk):.0f}",
        ]
        lines.append("| " + " | ".join(cells) + " |")
    return lines, numbers


def summary(name: str, numbers: list[dict[str, float]]) -> str:
    """One sentence about ten walks."""
    ratios, jumps = [n["ratio"] for n in numbers], sum(max(n["seam"], n["read"]) > 1.01 for n in numbers)
    anew = max(n["anew"] for n in numbers)
    return (
        f"{name}: foot skate {min(ratios):.2f} to {max(ratios):.2f} of that of blending alone (median "
        f"{np.median(ratios):.2f}; with contacts found anew in each result at most {anew:.2f}), "
        f"{jumps} of {len(numbers)} walks with a blend faster than the recordings; a walk is made in "
        f"{np.median([n['took'] for n in numbers]):.2f} s (median)."
    )


def bridged(name: str, dataset: Dataset) -> str:
    """One sentence about paths of motifs drawn at random, whatever leads from one to the next."""
    graph, rng = find_motifs(dataset), np.random.default_rng(0)
    ids = [motif.id for motif in graph.motifs]
    walks = [make_walk(dataset, graph, rng.choice(ids, BRIDGED).tolist(), gaps="bridge") for _ in range(PATHS)]
    faster = [walk.speeds.seams / walk.speeds.sources for walk in walks]
    return (
        f"{name}, {PATHS} paths of {BRIDGED} motifs drawn at random, gaps bridged: "
        f"{sum(walk.speeds.jump for walk in walks)} with a blend faster than the recordings "
        f"(at most {max(faster):.2f} times as fast), foot skate at most "
        f"{max(walk.skate.kept / walk.skate.plain for walk in walks):.2f} of that of blending alone."
    )


def main() -> str:
    """The Markdown section, also printed."""
    columns = (
        *("seed", "seconds", "motifs", "blends", "skate: recordings", "blending alone", "walk", "walk / alone"),
        *("same, contacts anew", "fastest joint: recordings", "blends", "blends, pybvh", "bare cuts"),
    )
    head = "| " + " | ".join(columns) + " |"
    lines = [
        "## Walks",
        "",
        f"{WALKS} random walks of about {SECONDS:g} s each; blends along whole motifs, jumps from dead ends bridged. "
        "Foot skate in cm per second of contact, speeds in m/s. Recordings slide by themselves: the feet of real "
        "people shuffle and pivot. Bare cuts: the fastest joint if the same motions were cut instead of blended. "
        "`python -m benchmarks.bench_walks`",
    ]
    sets = [
        ("Demo, 6 minutes", make_demo(), {}),
        ("Demo, further transition points on", make_demo(), {"further": True}),
    ]
    folder = asfamc()
    if folder:
        real = open_dataset(folder / "86")
        sets += [
            ("CMU subject 86", real, {}),
            ("CMU subject 86, further transition points on", real, {"further": True}),
        ]
    for name, dataset, options in sets:
        rows, numbers = rows_of(dataset, **options)
        lines += ["", summary(name, numbers), "", head, "|" + "---|" * len(columns), *rows]
    lines += ["", *(bridged(name, dataset) for name, dataset, options in sets if not options)]
    text = "\n".join(lines) + "\n"
    print(text)
    return text


if __name__ == "__main__":
    main()
