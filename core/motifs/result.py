"""The graph of what was found, in frames of the clips' own rates, and how good it is (MMG sections 4 and 5.1)."""

from __future__ import annotations

from typing import Any

import numpy as np

from core.mocap.clip import Segment
from core.motifs.alignment import AlignedMotif
from core.motifs.graph import Motif, MotifGraph, succession_edges
from core.poses.features import Poses


def graph_of(
    poses: Poses, aligned: list[AlignedMotif], parameters: dict[str, Any], dataset: dict[str, Any]
) -> MotifGraph:
    """The graph of motifs found among ``poses``, with its metrics; parameters: as used; dataset: what it says of it."""
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
    return MotifGraph(motifs, succession_edges(motifs), metrics, parameters, clips=clips, dataset=dataset)


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
