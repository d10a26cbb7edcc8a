"""Motifs: ours against LoCoMotif and stumpy on labelled exercises, and a long run with its stages.

usage: python -m benchmarks.bench_motifs

Judged with eval_motifs.py of the shared folder where that is present (its time warping replaced by our jitted one).
Parsing is excluded everywhere.
"""

from __future__ import annotations

import importlib.util
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np

from benchmarks.recordings import EXERCISES, SHARED, all_recordings, asfamc, exercises
from core.motifs.build import MotifParameters, find_motifs, motifs_of_poses
from core.poses.features import pose_features
from core.sequences.warping import registration, warp_path

SEEDS = range(8)
FIGURES = ("coverage", "purity", "pure", "f1_majority", "f1_one_to_one", "error_ratio")
GRID = [(s, t) for s in (0.5, 0.55, 0.6) for t in (0.0, 0.6)]  # strictness, tightness: what leave-one-out chooses from


def load_judge():
    """The outside judge as a module, None where it is not here."""
    path = SHARED / "eval" / "eval_motifs.py"
    if not path.is_file():
        return None
    spec = importlib.util.spec_from_file_location("judge", path)
    judge = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(judge)
    judge.warp = _warp
    return judge


class Judge:
    """Labels and judge, read once."""

    def __init__(self):
        self.judge = load_judge()
        self.labels, self.actions = self.judge.read_labels(str(SHARED / "data" / "labels" / "mocap6"))

    def __call__(self, document: dict, clips=EXERCISES, error: bool = True) -> list[float]:
        """The figures for one result, on some of the clips."""
        labels = {c: self.labels[c] for c in clips}
        found = self.judge.score(document, labels, len(self.actions), 120.0)
        if error:
            found["error_ratio"] = self.judge.error_ratio(document, sorted(labels), str(asfamc()), 120.0)
        return [float(found[f]) for f in FIGURES if f in found]


def locomotif(dataset, rho: float = 0.95, fps: int = 30) -> dict:
    """LoCoMotif on our pose features at 30 fps, motifs of 1 to 3 s (its best setting here), clips joined."""
    from locomotif.locomotif import apply_locomotif

    poses = pose_features(dataset, analysis_fps=fps)
    x = (poses.values / poses.values.std()).astype(np.float32)
    sets = apply_locomotif(x, l_min=fps, l_max=3 * fps, rho=rho)
    return _document(poses, [[(int(b), int(e)) for b, e in motions] for _, motions in sets])


def stumpy_motifs(dataset, fps: int = 30) -> dict:
    """stumpy's multidimensional matrix profile at 30 fps: greedy motifs of one second by nearest distance."""
    import stumpy

    poses, window = pose_features(dataset, analysis_fps=fps), fps
    x = poses.values[:, :6].astype(np.float64).T
    profile, _ = stumpy.mstump(x, window)
    distance, free, motifs = profile[-1], np.ones(x.shape[1] - window + 1, bool), []
    limit = np.quantile(distance, 0.5)
    for at in np.argsort(distance):
        if not free[at] or distance[at] > limit:
            continue
        to_all = np.mean([stumpy.mass(row[at : at + window], row) for row in x], axis=0)
        starts: list[int] = []
        for k in np.argsort(to_all):
            if to_all[k] > 1.5 * max(distance[at], limit):
                break
            if free[k]:
                starts.append(int(k))
                free[max(0, k - window + 1) : k + window] = False
        if len(starts) > 1:
            motifs.append([(k, k + window) for k in starts])
    return _document(poses, motifs)


def _document(poses, motifs: list[list[tuple[int, int]]]) -> dict:
    """What the judge reads; motions across a clip's end are cut there."""
    clips = [
        {"name": n, "frames": f, "fps": r}
        for n, f, r in zip(poses.clips, poses.clip_frames, poses.clip_fps, strict=True)
    ]
    found = []
    for motif in motifs:
        motions = []
        for start, end in motif:
            c = int(np.searchsorted(poses.clip_starts, start, side="right")) - 1
            first, stop = int(poses.clip_starts[c]), min(end, int(poses.clip_starts[c + 1]))
            motions.append(
                {
                    "clip": poses.clips[c],
                    "start": poses.frame_of(c, start - first),
                    "end": poses.frame_of(c, stop - first),
                }
            )
        found.append({"motions": [m for m in motions if m["end"] > m["start"]]})
    return {"clips": clips, "motifs": found}


def race(runs: dict, rounds: int = 5) -> dict[str, float]:
    """The best time of each, taken in turns so that a busy machine slows all alike."""
    best = dict.fromkeys(runs, np.inf)
    for _ in range(rounds):
        for name, run in runs.items():
            started = time.perf_counter()
            run()
            best[name] = min(best[name], time.perf_counter() - started)
    return best


def _warp(x: np.ndarray, ref: np.ndarray) -> np.ndarray:
    """The judge's time warping by our jitted one: the same figures, minutes sooner."""
    return registration(warp_path(ref, x), len(ref))


def quality() -> list[str]:
    """Table against the peers on the labelled exercises."""
    dataset = exercises()
    if dataset is None or load_judge() is None:
        return ["The labelled recordings or their judge are not here: no comparison with peers."]
    judge = Judge()
    variants = {
        "**ours, default**": MotifParameters(),
        "ours, default at 60 fps": MotifParameters(analysis_fps=60),
        "ours, random start": MotifParameters(init="random"),
        "ours, random seeding": MotifParameters(seeding="random"),
        "paper: spheres, kappa 200, V as printed": MotifParameters(
            adjacency="spheres",
            kappa=200,
            tightness=0.0,
            join=0.0,
            min_seconds=0.0,
            hold=0.0,
            analysis_fps=120,
            init="random",
        ),
    }
    runs, cells = {}, {}
    for name, parameters in variants.items():
        figures = [judge(find_motifs(dataset, replace(parameters, seed=s)).to_json()) for s in SEEDS]
        low, middle, high = np.min(figures, axis=0), np.median(figures, axis=0), np.max(figures, axis=0)
        cells[name] = [f"{m:.3f} ({a:.2f}-{b:.2f})" for a, m, b in zip(low, middle, high, strict=True)]
        runs[name] = lambda p=parameters: find_motifs(dataset, p)
    for name, peer in (("LoCoMotif, rho .95, 30 fps", locomotif), ("stumpy, 30 fps", stumpy_motifs)):
        try:
            cells[name] = [f"{v:.3f}" for v in judge(peer(dataset))]
            runs[name] = lambda peer=peer: peer(dataset)
        except ImportError as error:
            cells[name] = [f"{error.name} is not installed"] + [""] * (len(FIGURES) - 1)
    seconds = race(runs)
    rows = [f"| {name} | {' | '.join(cells[name])} | {seconds.get(name, np.nan):.2f} |" for name in cells]
    head = ["| | " + " | ".join(FIGURES) + " | seconds |", "|---" * (len(FIGURES) + 2) + "|"]
    return [
        "Five labelled exercise clips (2.7 minutes), median of 8 seeds (least-most); seconds: the whole pipeline but "
        "parsing, warm, best of five taken in turns.",
        "",
        *head,
        *rows,
        "",
        *leave_one_out(dataset, judge),
    ]


def leave_one_out(dataset, judge: Judge) -> list[str]:
    """Parameters chosen on four clips (most f1_majority at purity .975 or more), tested on the fifth."""
    poses, figures = pose_features(dataset), {}
    for strictness, tightness in GRID:
        parameters = MotifParameters(strictness=strictness, tightness=tightness)
        graphs = [motifs_of_poses(poses, replace(parameters, seed=s)).to_json() for s in SEEDS]
        for clip in EXERCISES:
            rest = [c for c in EXERCISES if c != clip]
            for key, clips in ((clip, [clip]), (f"not {clip}", rest)):
                cell = [judge(graph, clips, error=False) for graph in graphs]
                figures[strictness, tightness, key] = np.median(cell, axis=0)
    rows, held_out = [], []
    for clip in EXERCISES:
        best = max(GRID, key=lambda g: _worth(figures[(*g, f"not {clip}")]))
        held_out.append(figures[(*best, clip)])
        cells = " | ".join(f"{v:.3f}" for v in held_out[-1])
        rows.append(f"| {clip} | {best[0]}, {best[1]} | {cells} |")
    rows.append(f"| mean | | {' | '.join(f'{v:.3f}' for v in np.mean(held_out, axis=0))} |")
    return [
        "Leave one clip out: strictness and tightness chosen by the labels of four clips (most f1_majority at a purity "
        "of .975 or more), tested on the fifth; medians of 8 seeds. The F1 figures count actions over that clip alone.",
        "",
        "| held out | strictness, tightness | " + " | ".join(FIGURES[:-1]) + " |",
        "|---" * (len(FIGURES) + 1) + "|",
        *rows,
    ]


def _worth(figures: np.ndarray) -> tuple[bool, float]:
    named = dict(zip(FIGURES, figures, strict=False))
    return named["purity"] >= 0.975, named["f1_majority"]


def long_run() -> list[str]:
    """Stages and peak memory of a long run, in a process of its own."""
    done = subprocess.run([sys.executable, "-m", "benchmarks.bench_motifs", "--long"], capture_output=True, text=True)
    return done.stdout.splitlines() if done.returncode == 0 else [f"The long run failed: {done.stderr.strip()[-300:]}"]


def _long_run() -> None:
    import resource

    dataset, source = all_recordings()
    small = dataset.select(dataset.names[:1])
    find_motifs(small, MotifParameters(kappa=50))
    print(
        f"{dataset.n_frames} frames ({source}), {dataset.seconds / 60:.0f} minutes of many different motions that "
        "hardly recur. For motion that repeats itself all the time see Cost against length. Peak memory includes the "
        "recordings and the compiler.\n"
    )
    stages = ("poses", "quantisation", "matching", "discovery", "alignment", "graph")
    print("| analysis | kappa | " + " | ".join(stages) + " | total s | motifs | coverage | error ratio | peak MB |")
    print("|---" * (len(stages) + 7) + "|")
    for fps, kappa in ((30, "auto"), (120, 2000)):
        graph = find_motifs(dataset, MotifParameters(analysis_fps=fps, kappa=kappa))
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
        m, seconds = graph.metrics, graph.seconds
        ratio = m["average_frame_error"] / m["mean_pose_distance"]
        print(
            f"| {fps} fps | {graph.parameters['kappa']} | "
            + " | ".join(f"{seconds[s]:.2f}" for s in stages)
            + f" | {sum(seconds.values()):.1f} | {len(graph.motifs)} | {m['coverage']:.3f} | {ratio:.3f} | {peak:.0f} |"
        )


def main() -> str:
    """The Markdown section, also printed."""
    text = "\n".join(["## Motifs", "", "`python -m benchmarks.bench_motifs`", "", *quality(), "", *long_run()])
    print(text)
    return text


if __name__ == "__main__":
    _long_run() if "--long" in sys.argv else main()
