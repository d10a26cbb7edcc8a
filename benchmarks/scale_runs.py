"""Collections of many hours and what each method takes on them, every run measured in a process of its own.

Collections are made once and kept in the folder that ``MOTIONSCAPE_SCALE`` names (build/scale): ``demo-MINUTES``, the
demo at that length, and ``short-MINUTES``, the same cut into clips of a few seconds. Measurements are kept beside them
(``measured``), so that a benchmark that was interrupted goes on; delete that folder to measure anew.
"""

from __future__ import annotations

import json
import os
import resource
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path

import numpy as np

from core.analyses import normalise
from core.demo import write_demo
from core.demo.routines import routines
from core.estimates import amount_of_frames
from core.machine import PeakMemory
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.storage import load_dataset, writing_dataset
from core.motifs.axes import write_axis
from core.motifs.parameters import MotifParameters
from core.progress import Report
from core.requests import Request
from core.workspace import Workspace

ROOT = Path(__file__).resolve().parents[1]
FOLDER = Path(os.environ.get("MOTIONSCAPE_SCALE", ROOT / "build" / "scale"))
WARM = "demo-6"
SHORT_SECONDS = 4.3  # of a short clip: 2930 of them are three and a half hours
MOST_MEGABYTES = 8000
SWEPT = {"rho": (0.5, 1.0, 2.0)}


def _features(dataset: Dataset, report: Report) -> object:
    from core.export import FeatureParameters, feature_table

    return feature_table(dataset, FeatureParameters(), report)


def _motifs(dataset: Dataset, report: Report) -> object:
    from core.motifs.build import find_motifs

    return find_motifs(dataset, report=report)


def _exact(dataset: Dataset, report: Report) -> object:
    """Motifs by matching everything with everything."""
    from core.motifs.build import find_motifs

    return find_motifs(dataset, MotifParameters(sample=0), report)


def _grammar(dataset: Dataset, report: Report) -> object:
    from core.grammar.build import learn_grammar

    return learn_grammar(dataset, report=report)


def _map(dataset: Dataset, report: Report) -> object:
    from core.motion_map.build import build_motion_map

    return build_motion_map(dataset, report=report)


def _search(dataset: Dataset, report: Report) -> object:
    from core.retrieval.search import build_search_index

    return build_search_index(dataset, report=report)


def _sweep(dataset: Dataset, report: Report) -> object:
    from core.motifs.sweep import sweep

    return sweep(dataset, MotifParameters(), SWEPT, report=report)


def _stability(dataset: Dataset, report: Report) -> object:
    from core.motifs.stability import stability

    return stability(dataset, report=report)


def _redundancy(dataset: Dataset, report: Report) -> object:
    from core.motifs.redundancy import redundancy

    return redundancy(dataset, report=report)


def _import(dataset: Dataset, report: Report) -> object:
    """Reads the dataset's files, inspects and stores them."""
    minutes = dataset.name.partition("-")[2]
    files, imported = FOLDER / f"{dataset.name}-bvh", FOLDER / f"imported-{minutes}"
    shutil.rmtree(imported, ignore_errors=True)
    try:
        return Workspace(imported).import_dataset("imported", files, report=report)
    finally:
        shutil.rmtree(imported, ignore_errors=True)


METHODS: dict[str, Callable[[Dataset, Report], object]] = {
    "import": _import,
    "features": _features,
    "map": _map,
    "search": _search,
    "motifs": _motifs,
    "grammar": _grammar,
    "sweep": _sweep,
    "redundancy": _redundancy,
    "stability": _stability,
    "exact": _exact,
}


def prepared(name: str) -> str:
    """The name of a collection, ``demo-MINUTES`` or ``short-MINUTES``, made where it is not there yet."""
    if not (FOLDER / name / "dataset.json").exists():
        kind, minutes = name.split("-")
        with writing_dataset(FOLDER / name, name) as writer:
            labels = []
            for clip, clip_labels in routines(float(minutes), 0):
                for part in _cut(clip) if kind == "short" else (clip,):
                    writer.add(part)
                labels += clip_labels if kind == "demo" else ()
            writer.labels = labels
    return name


def prepared_files(name: str) -> None:
    """The collection ``name`` as BVH files, written where they are not there yet."""
    folder = FOLDER / f"{name}-bvh"
    if not (folder / "labels.csv").exists():
        write_demo(folder, float(name.partition("-")[2]))


def _cut(clip: Clip) -> Iterator[Clip]:
    """The clip in pieces of a few seconds."""
    n = max(1, round(clip.seconds / SHORT_SECONDS))
    edges = np.linspace(0, clip.n_frames, n + 1).astype(int)
    for a, b in pairwise(edges.tolist()):
        yield replace(clip.cut(a, b), name=f"{clip.name}_{a:06d}")


@dataclass
class Progress:
    """A report that notes for how long what it shows, the stage and whole percents, stood at one value.

    clock: processor time, which does not grow while others have the machine. standing: share of all of the longest
    stand; stood_at: where that was.
    """

    clock: Callable[[], float] = time.process_time
    standing: float = 0.0
    stood_at: str = ""
    _shown: str = ""

    def __post_init__(self) -> None:
        self._began = self._since = self.clock()
        self._longest = 0.0

    def __call__(self, stage: str, fraction: float) -> None:
        """As core.progress.Report."""
        shown = f"{stage} {100 * fraction:.0f} %"
        if shown != self._shown:
            self.end()
            self._shown = shown

    def end(self) -> None:
        """The last stand is over."""
        now = self.clock()
        if now - self._since > self._longest:
            self._longest, self.stood_at = now - self._since, self._shown
        self._since, self.standing = now, self._longest / max(now - self._began, 1e-9)


def measure(method: str, name: str) -> None:
    """Runs a method once, after it has run on a few minutes, and prints what it took as JSON."""
    resource.setrlimit(resource.RLIMIT_DATA, (MOST_MEGABYTES << 20,) * 2)
    METHODS[method](load_dataset(FOLDER / WARM), Progress())
    dataset, progress = load_dataset(FOLDER / name), Progress()
    wall, cpu = time.perf_counter(), time.process_time()
    with PeakMemory() as peak:
        METHODS[method](dataset, progress)
    progress.end()
    seconds, processor = time.perf_counter() - wall, time.process_time() - cpu
    found = {
        "hours": dataset.seconds / 3600,
        "seconds": seconds,
        "cpu": processor,
        "frames": dataset.n_frames,
        "own_megabytes": peak.bytes / 1e6,
        "megabytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "standing": progress.standing,
        "stood_at": progress.stood_at,
    }
    print(json.dumps(found))


def prior() -> dict[str, list[list[float]]]:
    """What estimates of jobs begin with: amount of work, seconds and bytes of every measurement, by method.

    Seconds: on the clock, or of the processor where the clock says more because others used the machine as well.
    """
    points: dict[str, list[list[float]]] = {}
    for method in METHODS:
        kept = (FOLDER / "measured" / f"{method}-demo-{minutes}.json" for minutes in (6, 15, 60, 600, 6000))
        for file in (file for file in kept if file.exists()):
            found = json.loads(file.read_text(encoding="utf-8"))
            seconds = min(found["seconds"], found["cpu"])
            amount = _amount(method, found["hours"] * 3600, found["frames"], file.stem.partition("-")[2])
            points.setdefault(method, []).append(
                [round(amount), round(seconds, 2), round(found["own_megabytes"] * 1e6)]
            )
    return points


def _amount(method: str, seconds: float, frames: int, name: str) -> float:
    if method == "import":
        return sum(file.stat().st_size for file in (FOLDER / f"{name}-bvh").iterdir())
    asked = {"axes": write_axis(*next(iter(SWEPT.items())))} if method == "sweep" else {}
    request = normalise(Request("", "motifs" if method == "exact" else method, asked))
    return amount_of_frames(request, seconds, frames)


def measured(method: str, name: str) -> dict[str, float] | None:
    """What a method took on a collection; None where it did not end well."""
    kept = FOLDER / "measured" / f"{method}-{name}.json"
    if not kept.exists():
        for needed in (WARM, name):
            prepared(needed)
            if method == "import":
                prepared_files(needed)
        command = [sys.executable, "-m", "benchmarks.scale_runs", method, name]
        done = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
        if done.returncode:
            print(method, name, done.stderr[-500:], file=sys.stderr)
            return None
        kept.parent.mkdir(exist_ok=True)
        kept.write_text(done.stdout.splitlines()[-1], encoding="utf-8")
    found: dict[str, float] = json.loads(kept.read_text(encoding="utf-8"))
    print(method, name, found, file=sys.stderr)
    return found


if __name__ == "__main__":
    measure(*sys.argv[1:])
