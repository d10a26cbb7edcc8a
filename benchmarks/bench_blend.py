"""Mixtures of the motions of motifs: how long one takes, how its feet slide, how hard it moves.

usage: python -m benchmarks.bench_blend
"""

from __future__ import annotations

import sys
import time

import numpy as np

from benchmarks.recordings import all_recordings
from core.demo import make_demo
from core.editing.contacts import foot_skate
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.motifs.blend_space import BlendSpace, blend_space, blendable
from core.motifs.build import find_motifs

COMMAND = "python -m benchmarks.bench_blend"
MIXED = 8  # motions of a mixture at most
LENGTH = 2.0  # seconds, for the time of one mixture


def hardest(clip: Clip) -> float:
    """Greatest acceleration of a joint, metres a second squared."""
    steps = np.diff(joint_positions(clip), 2, axis=0)
    return float(np.linalg.norm(steps, axis=-1).max(initial=0.0)) * clip.fps**2


def milliseconds(space: BlendSpace, weights: dict[int, float]) -> float:
    """CPU time of one mixture, the median of five."""
    taken = []
    for _ in range(5):
        started = time.process_time()
        space.blend(weights)
        taken.append(1000 * (time.process_time() - started))
    return float(np.median(taken))


def measure(dataset: Dataset) -> dict[str, float]:
    """Over all motifs with two motions of one body: even mixtures of their most different motions."""
    graph = find_motifs(dataset)
    rows, eight = [], []
    for motif in graph.motifs:
        if len(blendable(dataset, motif)[0]) < 2:
            continue
        space = blend_space(dataset, motif)
        chosen = space.most_different(MIXED)
        weights = dict.fromkeys(chosen, 1.0)
        sources = [space.blend({k: 1.0}) for k in chosen]
        plain, clean = space.blend(weights, clean=False), space.blend(weights)
        skate = [np.mean([foot_skate(c) for c in sources]), foot_skate(plain), foot_skate(clean)]
        force = max(map(hardest, sources))
        rows.append([*skate, hardest(plain) / force, hardest(clean) / force])
        if len(chosen) == MIXED:
            eight.append(milliseconds(space, weights) * LENGTH / plain.seconds)
    found = np.array(rows)
    return {
        "motifs": len(rows),
        "sources": found[:, 0].mean(),
        "plain": found[:, 1].mean(),
        "clean": found[:, 2].mean(),
        "hardest": float(np.median(found[:, 4])),
        "milliseconds": float(np.median(eight)) if eight else float("nan"),
    }


def main() -> str:
    """Measure and write the section."""
    recordings, called = all_recordings()
    lines = [
        "## Mixtures of motions",
        "",
        f"Even mixtures of up to {MIXED} motions, the most different of one body, of every motif that has two. Skate: "
        "metres that standing feet slide a second of contact, mean over motifs. Hardest: greatest acceleration of a "
        "joint against the greatest in its sources, median. Time: CPU time for 8 motions, scaled to 2 s of motion.",
        "",
        "| recordings | motifs | skate of the motions | plain mixture | cleaned mixture | hardest | ms |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, dataset in (("demo, 6 minutes", make_demo(6)), (called, recordings)):
        m = measure(dataset)
        lines.append(
            f"| {name} | {m['motifs']} | {m['sources']:.3f} | {m['plain']:.3f} | {m['clean']:.3f} | "
            f"{m['hardest']:.2f} | {m['milliseconds']:.0f} |"
        )
        print(lines[-1], file=sys.stderr)
    return "\n".join([*lines, "", f"Made by `{COMMAND}`."]) + "\n"


if __name__ == "__main__":
    print(main())
