"""From recordings to a motion map, stage by stage (MAP section 3)."""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass, replace
from functools import partial

import numpy as np

from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.motion_map.assign import assign_clips
from core.motion_map.bones import bone_lengths
from core.motion_map.key_poses import runs_of
from core.motion_map.motion_map import MotionMap
from core.motion_map.regions import find_regions, region_icons
from core.motion_map.samples import reduce_samples, threshold_for
from core.motion_map.som import PASSES, batch_som, best_nodes, errors, online_som
from core.parameters import parameter
from core.poses.postures import postures_of
from core.progress import Report, silent, timed


@dataclass(frozen=True)
class MapParameters:
    """How a motion map is made. Each field's metadata: ``help``, ``min``, ``max``, ``step``, ``choices``, ``advanced``.

    Raises ParameterError, in plain words, for a value out of range.
    """

    grid: str = parameter(
        "30x30",
        "Nodes across and down: more show finer differences between postures, and give more icons to choose from.",
        label="Nodes across and down",
    )
    analysis_fps: float = parameter(
        30.0, "Frames a second that are looked at.", 5.0, 240.0, 5.0, label="Frames per second"
    )
    samples: int = parameter(
        2000,
        "About how many different postures the map learns from; near-equal ones count once.",
        50,
        100_000,
        50,
        label="Postures to learn from",
    )
    sigma: float = parameter(
        0.7,
        "How smooth the map ends up: higher keeps neighbours more alike, lower follows single postures.",
        0.2, 5.0, 0.1, label="Smoothness (sigma)",
    )  # fmt: skip
    ridge: float = parameter(
        0.15,
        "How high a ridge between two regions must be, in standard deviations of all heights; 0: every ridge divides, "
        "as in the 2004 paper.",
        0.0, 5.0, 0.05, label="Height of ridges",
    )  # fmt: skip
    epochs: int = parameter(24, "How many times the map is adapted.", 1, 1000, 1, advanced=True, label="Rounds")
    training: str = parameter(
        "batch",
        "batch = fast, all postures at once; online = the 2004 paper's own schedule, one posture at a time (slow).",
        choices=("batch", "online"), advanced=True,
    )  # fmt: skip
    passes: int = parameter(
        PASSES, "With online: passes over all samples.", 1, 10_000, 1, advanced=True, label="Passes (online)"
    )
    seed: int = parameter(
        0, "Number that starts the random choices; the same number gives the same map.", 0, None, 1, label="Random seed"
    )
    model: str = parameter(
        "",
        "Key of an earlier map in the workspace: its postures stay, and the clips are only put on them. "
        "Then the other settings do nothing.",
        advanced=True, label="Earlier map",
    )  # fmt: skip

    def __post_init__(self) -> None:
        parse_grid(self.grid)
        if not (50 <= self.samples <= 100_000 and 0.2 <= self.sigma <= 5.0 and 1 <= self.epochs <= 1000):
            raise ParameterError("samples must be 50 to 100000, sigma 0.2 to 5, epochs 1 to 1000")
        if not 0 <= self.ridge <= 5:
            raise ParameterError("ridge must be 0 to 5")
        if self.training not in ("batch", "online") or not 1 <= self.passes <= 10_000:
            raise ParameterError("training must be batch or online, with 1 to 10000 passes")
        if self.model and not re.fullmatch(r"[0-9a-f]{8,64}", self.model):
            raise ParameterError("model must be the key of an earlier map")


def parse_grid(text: str) -> tuple[int, int]:
    """``21x21`` as numbers; raises ParameterError unless both are whole numbers from 2 to 100."""
    parts = str(text).lower().replace("×", "x").split("x")
    if len(parts) != 2 or not all(part.strip().isdecimal() and 2 <= int(part) <= 100 for part in parts):
        raise ParameterError(f"grid must look like 21x21, with 2 to 100 nodes either way, not {str(text)[:40]!r}")
    return int(parts[0]), int(parts[1])


def build_motion_map(
    dataset: Dataset,
    parameters: MapParameters | None = None,
    report: Report = silent,
    model: MotionMap | None = None,
) -> MotionMap:
    """The motion map of a data set. Deterministic: the same clips and seed give the same map.

    With an earlier map as ``model`` nothing is learned: the clips are put on its nodes. Raises ValueError where there
    are no clips or no common joints; ``report`` may raise to stop the work.
    """
    parameters = parameters or MapParameters()
    if model is not None:
        return replace(assign_clips(model, dataset, report), parameters=asdict(parameters))
    seconds: dict[str, float] = {}
    with timed("postures", seconds):
        postures = postures_of(dataset, analysis_fps=parameters.analysis_fps, report=report)
    with timed("samples", seconds):
        report("samples", 0.0)
        threshold = threshold_for(postures.vectors, parameters.samples, seed=parameters.seed)
        kept = reduce_samples(postures.vectors, threshold, report)
        samples = postures.vectors[kept]
    with timed("map", seconds):
        grid = parse_grid(parameters.grid)
        if parameters.training == "online":
            weights = online_som(samples, grid, passes=parameters.passes, seed=parameters.seed, report=report)
        else:
            sigma = (max((grid[0] + grid[1]) / 4, parameters.sigma), parameters.sigma)
            weights = batch_som(
                samples, grid, epochs=parameters.epochs, sigma=sigma, seed=parameters.seed, report=report
            )
    with timed("regions", seconds):
        regions = find_regions(weights, parameters.ridge)
    with timed("runs", seconds):
        report("runs", 0.0)
        nodes, distances = best_nodes(postures.vectors, weights, partial(report, "runs"))
        runs = runs_of(nodes, distances, postures.clip_starts, postures.velocity)
        quantisation, topographic = errors(samples, weights)
    return MotionMap(
        weights=weights,
        regions=regions,
        icons=region_icons(regions),
        runs=runs,
        joints=postures.joints,
        roles=postures.roles,
        sides=postures.sides,
        parents=postures.parents,
        lengths=bone_lengths(postures.values[kept], postures.parents),
        clips=postures.clips,
        clip_fps=postures.clip_fps,
        clip_frames=postures.clip_frames,
        fps=postures.fps,
        metrics={
            "quantisation_error": quantisation,
            "topographic_error": topographic,
            "samples": float(len(samples)),
            "threshold": threshold,
            "n_regions": float(regions.max() + 1),
            "usual_distance": float(np.median(distances)),
        },
        parameters=asdict(parameters),
        seconds=seconds,
        dataset={"name": dataset.name, "fingerprint": dataset.fingerprint},
    )
