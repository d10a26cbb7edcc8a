"""Our BVH reader beside pybvh and bvhio: time, joint positions, and the files each refuses.

usage: python -m benchmarks.bench_readers [DATA_FOLDER]
"""

from __future__ import annotations

import os
import sys
import time
import warnings
from collections.abc import Callable
from importlib import import_module
from importlib.metadata import version
from pathlib import Path

import numpy as np

from core.mocap.asfamc import read_amc, read_asf
from core.mocap.bvh import read_bvh
from core.mocap.kinematics import joint_positions
from core.mocap.recordings import find_recordings, find_skeleton

COMMAND = "python -m benchmarks.bench_readers"
FOLDERS = ("cmu/bvh", "bandai_namco_1", "fairmotion")
COMPARED_FRAMES = 20  # of each compared file
COMPARED_FILES = 12  # the smallest of each folder: bvhio needs minutes to place the joints of them all
Positions = Callable[[list[int]], dict[str, np.ndarray]]


def read_ours(path: Path) -> Positions:
    """Our reader; positions by joint name, ``(n, 3)``, in file units."""
    clip = read_bvh(path)

    def positions(frames: list[int]) -> dict[str, np.ndarray]:
        world = joint_positions(clip)[frames] / clip.skeleton.unit
        return {n: world[:, j] for j, n in enumerate(clip.skeleton.names) if not clip.skeleton.end_sites[j]}

    return positions


def read_pybvh(path: Path) -> Positions:
    """pybvh; positions by joint name, ``(n, 3)``, in file units."""
    bvh = import_module("pybvh").read_bvh_file(str(path))

    def positions(frames: list[int]) -> dict[str, np.ndarray]:
        world = np.asarray(bvh.joint_positions())[frames]
        return {name: world[:, j] for j, name in enumerate(bvh.joint_names)}

    return positions


def read_bvhio(path: Path) -> Positions:
    """bvhio, read as a table of key frames (its fastest way); positions by joint name, ``(n, 3)``, in file units."""
    bvhio = import_module("bvhio")
    bvhio.readAsBvh(str(path))

    def positions(frames: list[int]) -> dict[str, np.ndarray]:
        root = bvhio.readAsHierarchy(str(path))
        found: dict[str, list] = {}
        for frame in frames:
            for joint, _, _ in root.loadPose(frame).layout():
                found.setdefault(joint.Name, []).append(list(joint.PositionWorld))
        return {name: np.array(rows) for name, rows in found.items()}

    return positions


READERS = {"ours": read_ours, "pybvh": read_pybvh, "bvhio": read_bvhio}


def available() -> dict[str, str]:
    """Readers that are installed, with their versions."""
    found = {"ours": ""}
    for name in ("pybvh", "bvhio"):
        try:
            import_module(name)
            found[name] = version(name)
        except ImportError:
            print(f"{name} is not installed: left out", file=sys.stderr)
    return found


def read_all(name: str, files: list[Path]) -> tuple[dict[Path, float], dict[Path, str], dict[Path, Positions]]:
    """Seconds and positions of every file read, and why others were refused."""
    seconds, refused, read = {}, {}, {}
    for path in files:
        start = time.process_time()
        try:
            read[path] = READERS[name](path)
        except Exception as error:  # whatever a peer raises is a refusal
            refused[path] = f"{type(error).__name__}: {error}"
        else:
            seconds[path] = time.process_time() - start
    return seconds, refused, read


def furthest(ours: dict[Path, Positions], theirs: dict[Path, Positions]) -> float:
    """Largest distance of a joint between two readers, as a share of the figure's size in that frame."""
    worst = 0.0
    both = sorted(ours.keys() & theirs.keys(), key=lambda path: path.stat().st_size)
    for path in both[:COMPARED_FILES]:
        n = read_bvh(path).n_frames
        frames = np.unique(np.linspace(0, n - 1, COMPARED_FRAMES).astype(int)).tolist()
        a, b = ours[path](frames), theirs[path](frames)
        shared = a.keys() & b.keys()
        size = np.ptp(np.stack([a[name] for name in shared]), axis=0).max()
        worst = max(worst, max(np.abs(a[name] - b[name]).max() for name in shared) / size)
    return worst


def compare(data: Path, label: str) -> list[str]:
    """Rows of the table for the folder ``label`` of ``data``."""
    folder = data / label
    files = [p for p in find_recordings(folder) if p.suffix == ".bvh"]
    for path in files:  # who comes first would pay for the disk
        path.read_bytes()
    READERS["ours"](files[0])  # compiled, or loaded from numba's cache, before the clock runs
    results = {name: read_all(name, files) for name in available()}
    ours_seconds, _, ours_read = results["ours"]
    rows = []
    for name, (seconds, refused, read) in results.items():
        both = seconds.keys() & ours_seconds.keys()
        total, own = sum(seconds[p] for p in both), sum(ours_seconds[p] for p in both)
        ratio = f"{total / own:.1f}" if both else "-"
        apart = f"{furthest(ours_read, read):.0e}" if name != "ours" and both else "-"
        taken = f"{total:.2f} s" if both else "-"
        rows.append(f"| {label} | {len(files)} | {name} | {taken} | {ratio} | {apart} | {len(refused)} |")
        for path, why in list(refused.items())[:1]:
            print(f"{name} refuses {len(refused)} files, such as {path.name}: {' '.join(why.split())[:160]}")
    return rows


def amc_row(folder: Path) -> str:
    """One line on our ASF/AMC reader, which has no peer among the installed readers."""
    borrowed = folder / "86/86.asf"
    files = [p for p in find_recordings(folder) if ".amc" in p.name]
    read_amc(files[0], read_asf(find_skeleton(files[0], borrowed)))
    start = time.process_time()
    frames = sum(read_amc(path, read_asf(find_skeleton(path, borrowed))).n_frames for path in files)
    seconds = time.process_time() - start
    counts = f"{len(files)} files, {frames} frames"
    return f"ASF/AMC (no other reader to compare with): {counts} in {seconds:.2f} s of CPU time."


def main(data: Path | None = None) -> str:
    """Measure, print and return the Markdown section "Readers"."""
    here = Path(__file__).resolve().parents[1]
    shared = Path(os.environ.get("MOTIONSCAPE_SHARED", here.parent / "shared"))
    data = data or shared / "data"
    lines = ["## Readers", ""]
    if not data.is_dir():
        lines.append("Not measured: the recordings are not beside the checkout.")
    else:
        peers = ", ".join(f"{name} {number}" for name, number in available().items() if number)
        lines += [
            f"BVH files read one after another in one process, beside {peers or 'no peer: none is installed'}. Time is",
            "CPU time of parsing alone (the machine is shared: wall-clock time says little), files in the disk",
            "cache, over the files that both readers take; ratio = time / ours. Apart = largest distance of a",
            f"joint from ours at {COMPARED_FRAMES} frames of each of the {COMPARED_FILES} smallest files,",
            "as a share of the figure's size.",
            "",
            "| recordings | files | reader | time | ratio | apart | refused |",
            "|---|---|---|---|---|---|---|",
        ]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # pybvh's doubts about which way is up
            for folder in FOLDERS:
                lines += compare(data, folder)
        lines += ["", amc_row(data / "cmu/asfamc")]
    lines += ["", f"Made by `{COMMAND}`."]
    text = "\n".join(lines) + "\n"
    print(text)
    return text


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
