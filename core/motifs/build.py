"""From recordings to the motion-motif graph: the whole pipeline of MMG, stage by stage."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, replace

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.adjacency import Adjacency, nearest_pairs_radius, radius_adjacency, sphere_adjacency
from core.motifs.alignment import AlignedMotif, align_motifs, entry_frames, spans_of
from core.motifs.discovery import join_leftovers, largest_first, random_seeds
from core.motifs.graph import Motif, MotifGraph, dataset_head, succession_edges
from core.motifs.matching import Matcher, Rule
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import Letters, automatic_kappa, k_means
from core.poses.features import Poses, pose_features
from core.progress import Report, silent
from core.sequences.repeats import remove_runs

__all__ = ["MotifParameters", "find_motifs", "motifs_of_poses"]


_DEFAULT = MotifParameters()


def find_motifs(dataset: Dataset, parameters: MotifParameters = _DEFAULT, report: Report = silent) -> MotifGraph:
    """The motion-motif graph of a data set. Deterministic: the same clips, in any order, and seed give the same graph.

    Raises ValueError where there are no clips or no common joints. ``report`` is called several times a second and may
    raise to stop the work.
    """
    started = time.perf_counter()
    poses = pose_features(dataset, analysis_fps=parameters.analysis_fps, pose=parameters.pose, report=report)
    seconds = {"poses": time.perf_counter() - started}
    graph = motifs_of_poses(poses, parameters, report)
    return replace(graph, seconds=seconds | dict(graph.seconds), dataset=dataset_head(dataset))


def motifs_of_poses(poses: Poses, parameters: MotifParameters, report: Report = silent) -> MotifGraph:
    """The graph from pose features that are already there, as a sweep over parameters needs it."""
    seconds: dict[str, float] = {}
    kappa = automatic_kappa(poses.values, poses.fps) if parameters.kappa == "auto" else parameters.kappa
    with _timed("quantisation", seconds):
        letters = k_means(poses.values, kappa, parameters.seed, report=report)
        runs = remove_runs(letters.labels, poses.clip_starts)
    with _timed("matching", seconds):
        report("matching", 0.0)
        matcher = Matcher(runs, adjacency := _adjacency(letters, parameters))
        rule = _rule(parameters, adjacency, parameters.strictness)
        matches = matcher.all(rule, report)
    with _timed("discovery", seconds):
        greedy = {"tightness": parameters.tightness, "report": report}
        if parameters.seeding == "random":
            found = random_seeds(runs, matches, rule, parameters.rho, parameters.seed, **greedy)
        else:
            found = largest_first(runs, matches, rule, parameters.rho, **greedy)
        del matches
        if parameters.adjacency == "radius" and parameters.join > parameters.strictness:
            found = join_leftovers(runs, matcher, found, _rule(parameters, adjacency, parameters.join), report)
    with _timed("alignment", seconds):
        frames = entry_frames(runs, found, poses.values, parameters.seed)
        spans = spans_of(runs, found, frames, round(parameters.hold * parameters.analysis_fps))
        aligned = align_motifs(spans, poses.values, report)
    with _timed("graph", seconds):
        graph = _graph(poses, aligned, asdict(parameters) | {"kappa": len(letters.centres)})
    return replace(graph, seconds=seconds)


def _adjacency(letters: Letters, parameters: MotifParameters) -> Adjacency:
    if parameters.adjacency == "spheres":
        return sphere_adjacency(letters.centres, letters.labels, letters.distances)
    return radius_adjacency(letters.centres, nearest_pairs_radius(letters.centres, parameters.reach))


def _rule(parameters: MotifParameters, adjacency: Adjacency, share: float) -> Rule:
    """The matching rule; the paper's spheres know no limit of the mean distance."""
    return Rule(
        parameters.min_letters,
        parameters.max_letters,
        parameters.gamma,
        parameters.slack,
        share * adjacency.radius if parameters.adjacency == "radius" else np.inf,
        parameters.min_seconds * parameters.analysis_fps,
    )


@contextmanager
def _timed(stage: str, seconds: dict[str, float]) -> Iterator[None]:
    started = time.perf_counter()
    yield
    seconds[stage] = time.perf_counter() - started


def _graph(poses: Poses, aligned: list[AlignedMotif], parameters: dict) -> MotifGraph:
    motifs = tuple(_motif(poses, i, motif) for i, motif in enumerate(aligned))
    segments = [s for motif in motifs for s in motif.segments]
    total = sum(poses.clip_frames)
    errors = sum(m.error_sum for m in aligned) / max(sum(m.error_count for m in aligned), 1)
    metrics = {
        "coverage": sum(s.n_frames for s in segments) / max(total, 1),
        "average_frame_error": errors,
        "mean_pose_distance": poses.mean_distance,
        "n_motifs": len(motifs),
        "mean_motions": len(segments) / max(len(motifs), 1),
        "mean_frames": float(np.mean([s.n_frames for s in segments])) if segments else 0.0,
    }
    clips = tuple(zip(poses.clips, poses.clip_frames, poses.clip_fps, strict=True))
    return MotifGraph(motifs, succession_edges(motifs), metrics, parameters, clips=clips)


def _motif(poses: Poses, number: int, motif: AlignedMotif) -> Motif:
    """A motif in frames of the clips' own rates."""
    clips = np.searchsorted(poses.clip_starts, motif.spans[:, 0], side="right") - 1
    segments = tuple(_segment(poses, c, s, e) for c, (s, e) in zip(clips, motif.spans, strict=True))
    rate = poses.clip_fps[clips[motif.medoid]] / poses.fps
    at = np.arange(segments[motif.medoid].n_frames) / rate
    warps = []
    for c, segment, warp in zip(clips, segments, motif.warps, strict=True):
        own = np.interp(at, np.arange(len(warp)), warp) * poses.clip_fps[c] / poses.fps
        warps.append(np.clip(own, 0, segment.n_frames - 1).astype(np.float32))
    return Motif(number, segments, motif.medoid, tuple(warps))


def _segment(poses: Poses, clip: int, start: int, end: int) -> Segment:
    """Analysis frames [start, end) as a segment of the clip; its last pose reaches to the clip's end."""
    first, frames = poses.clip_starts[clip], poses.clip_frames[clip]
    stop = frames if end == poses.clip_starts[clip + 1] else poses.frame_of(clip, end - first)
    return Segment(poses.clips[clip], poses.frame_of(clip, start - first), stop)
