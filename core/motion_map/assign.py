"""Puts new clips on an existing map without training, and measures how well each fits."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from core.errors import AnalysisError
from core.mocap.dataset import Dataset
from core.mocap.kinematics import resample
from core.motion_map.key_poses import runs_of
from core.motion_map.motion_map import MotionMap
from core.motion_map.som import best_nodes
from core.progress import Report, silent


def assign_clips(motion_map: MotionMap, dataset: Dataset, report: Report = silent) -> MotionMap:
    """The same map with the clips of ``dataset`` on it instead of its own: nodes, regions and icons stay.

    Searching, trajectories and layers then speak of these clips; ``fits`` says how far each lies from the map's
    postures. Raises AnalysisError where there are no clips, or where one lacks a joint of the map.
    """
    started = time.perf_counter()
    clips = sorted(dataset.clips, key=lambda clip: clip.name)
    if not clips:
        raise AnalysisError("the dataset has no clips to put on the map")
    nodes, distances, velocities = [], [], []
    for k, clip in enumerate(clips):
        vectors, velocity = motion_map.vectors_of(resample(clip, motion_map.fps))
        best = best_nodes(vectors, motion_map.weights)
        nodes.append(best[0])
        distances.append(best[1])
        velocities.append(velocity)
        report("runs", (k + 1) / len(clips))
    starts = np.concatenate([[0], np.cumsum([len(n) for n in nodes])]).astype(np.int64)
    return replace(
        motion_map,
        runs=runs_of(np.concatenate(nodes), np.concatenate(distances), starts, np.concatenate(velocities)),
        clips=tuple(clip.name for clip in clips),
        clip_fps=tuple(float(clip.fps) for clip in clips),
        clip_frames=tuple(clip.n_frames for clip in clips),
        seconds={"runs": time.perf_counter() - started},
        dataset={"name": dataset.name, "fingerprint": dataset.fingerprint},
    )
