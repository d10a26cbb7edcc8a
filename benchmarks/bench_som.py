"""Self-organising maps of postures: ours beside XPySom, MiniSom and fastersom: time and both errors, in one run.

usage: python -m benchmarks.bench_som
fastersom needs PyTorch (pip install fastersom: gigabytes, so it is not among the extras); it is left out where it is
not there.
"""

from __future__ import annotations

import contextlib
import io
import os
import time
from collections.abc import Callable

import numpy as np

from benchmarks.recordings import exercises
from core.demo import make_demo
from core.mocap import quaternions as quat
from core.mocap.dataset import Dataset
from core.mocap.kinematics import forward_kinematics
from core.motion_map.build import MapParameters, build_motion_map
from core.motion_map.samples import reduce_samples, threshold_for
from core.motion_map.som import batch_som, errors

UNIT = 0.056444  # metres of CMU's unit, in which the joints are compared here
SIGMAS = (0.7, 0.35)  # what the maps end with; .35 is about what XPySom makes of a sigmaN of .7 by its own std_coeff
EPOCHS = 20
SMALL, LARGE = (21, 21), (40, 40)


def joint_vectors(dataset: Dataset) -> np.ndarray:
    """All frames at their own rate as ``(n, 90)``: 30 joints relative to the root, facing one way, in CMU's unit."""
    rows = []
    for clip in dataset.clips:
        positions, world = forward_kinematics(clip)
        yaw = quat.split_yaw(world[:, 0])[0]
        offsets = (positions[:, 1:31] - positions[:, :1]).astype(np.float64)
        rows.append(quat.rotate(quat.from_yaw(-yaw)[:, None], offsets).reshape(len(offsets), -1) / UNIT)
    return np.concatenate(rows).astype(np.float32)


def make_samples() -> tuple[np.ndarray, np.ndarray, str]:
    """Samples (436, 90), those of the 2004 paper's size, and (20000, 90); and what they are made from."""
    dataset = exercises()
    source = "the five labelled exercise clips (CMU 13_29, 13_30, 13_31, 14_14, 14_20, 120 Hz)"
    if dataset is None:
        dataset, source = make_demo(minutes=6), "the demo, as the exercise clips are not here"
    frames = joint_vectors(dataset)
    rng = np.random.default_rng(0)
    more = max(20_000 - len(frames), 0)
    large = np.concatenate([frames, frames[rng.integers(0, len(frames), more)]])[:20_000]
    large[len(frames) :] += rng.normal(0, 0.05, (more, large.shape[1])).astype(np.float32)
    small = frames[reduce_samples(frames, threshold_for(frames, 436))][:436]
    return small, np.ascontiguousarray(large, np.float32), source


def ours(samples: np.ndarray, grid: tuple[int, int], sigma: float) -> np.ndarray:
    """Our batch map; as the default setting makes it apart from sigma's end."""
    return batch_som(samples, grid, sigma=(sum(grid) / 4, sigma))


def widths(grid: tuple[int, int], sigma: float) -> tuple[float, float]:
    """First and last width for peers whose last epoch stops a step short of the last: then it has ``sigma``."""
    first = grid[0] / 4
    return first, first * (sigma / first) ** (EPOCHS / (EPOCHS - 1))


def xpysom(samples: np.ndarray, grid: tuple[int, int], sigma: float) -> np.ndarray:
    """XPySom's; with std_coeff 1 its neighbourhood is as wide as ours."""
    with contextlib.redirect_stdout(io.StringIO()):
        from xpysom import XPySom

    first, last = widths(grid, sigma)
    model = XPySom(*grid, samples.shape[1], sigma=first, sigmaN=last, std_coeff=1.0, random_seed=0)
    model.random_weights_init(samples)
    model.train(samples, EPOCHS)
    return np.asarray(model.get_weights())


def minisom(samples: np.ndarray, grid: tuple[int, int], sigma: float) -> np.ndarray:
    """MiniSom's, one sample at a time, 20 for each node; its sigma falls to a third of the first."""
    from minisom import MiniSom

    model = MiniSom(*grid, samples.shape[1], sigma=max(3 * sigma, 1.0), learning_rate=0.5, random_seed=0)
    model.pca_weights_init(samples)
    model.train(samples, 20 * grid[0] * grid[1], random_order=True)
    return model.get_weights()


def fastersom(samples: np.ndarray, grid: tuple[int, int], sigma: float) -> np.ndarray:
    """fastersom's batch map on the processor."""
    from fastersom import BatchSOM

    first, last = widths(grid, sigma)
    model = BatchSOM(
        *grid, EPOCHS, sigma_initial=first, sigma_final=last, init="sample", random_state=0, device="cpu"
    )  # fmt: skip
    model.fit(samples)
    return np.asarray(model.weights_, np.float32)


PEERS: dict[str, Callable[[np.ndarray, tuple[int, int], float], np.ndarray]] = {
    "ours": ours,
    "XPySom": xpysom,
    "MiniSom": minisom,
    "fastersom": fastersom,
}
FREE_SIGMA = ("ours", "XPySom", "fastersom")  # the others end where they end


def measured(name: str, samples: np.ndarray, grid: tuple[int, int], sigma: float, repeats: int) -> tuple | None:
    """Median seconds (of the processor), quantisation and topographic error; None where the peer is not installed."""
    seconds = []
    try:
        for _ in range(repeats):
            started = time.process_time()
            weights = PEERS[name](samples, grid, sigma)
            seconds.append(time.process_time() - started)
    except ImportError as error:
        print(f"{name} is left out: {error}")
        return None
    shaped = np.asarray(weights, np.float32).reshape(*grid, -1)
    return float(np.median(seconds)), *errors(samples, shaped)


def demo_seconds() -> tuple[float, float]:
    """Wall and processor time of the demo's 21 x 21 map, from clips to regions, the second of two runs."""
    demo = make_demo(minutes=6)
    for _ in range(2):
        wall, busy = time.perf_counter(), time.process_time()
        build_motion_map(demo, MapParameters(grid="21x21"))
        taken = time.perf_counter() - wall, time.process_time() - busy
    return taken


def main() -> str:
    """Measure, print and return the Markdown section."""
    small, large, source = make_samples()
    ours(large[:2000], SMALL, 0.7)  # what is compiled first
    rows = []
    for what, samples, grid, repeats in (("436", small, SMALL, 3), ("20000", large, LARGE, 2)):
        for sigma in SIGMAS:
            found = {}
            for name in PEERS:
                if name in FREE_SIGMA or sigma == SIGMAS[0]:
                    found[name] = measured(name, samples, grid, sigma, 1 if name == "MiniSom" else repeats)
            peer = found.get("XPySom")
            for name, row in found.items():
                if row is not None:
                    ratio = f"{row[0] / peer[0]:.2f}" if peer else "-"
                    end = f"{sigma:g}" if name in FREE_SIGMA else "its own"
                    rows.append(f"| {what} x 90 on {grid[0]} x {grid[1]} | {name} | {end} | {row[0]:.2f} | {ratio} | {row[1]:.2f} | {row[2]:.3f} |")  # fmt: skip  # noqa: E501
                    print(rows[-1], flush=True)
    wall, busy = demo_seconds()
    lines = [
        "## Motion map",
        "",
        f"Samples from {source}: joints relative to the root, facing one way, in CMU's unit ({UNIT} m). 20000: all "
        "frames, and some again with noise of .05; 436: thinned as in the 2004 paper. Sigma: width of the "
        "neighbourhood in the last epoch, in nodes (XPySom with std_coeff = 1). "
        "Processor seconds, both errors over all samples; ratio = time / XPySom's. Topographic error: the second "
        "best node is none of the eight around the best.",
        "",
        "| samples | | sigma | seconds | ratio | quantisation error | topographic error |",
        "|---|---|---|---|---|---|---|",
        *rows,
        "",
        f"The demo's 21 x 21 map, from clips to regions: {busy:.2f} s of the processor, {wall:.2f} s on the clock at a "
        f"machine load of {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores. `python -m benchmarks.bench_som`",
    ]
    section = "\n".join(lines)
    print(section)
    return section


if __name__ == "__main__":
    main()
