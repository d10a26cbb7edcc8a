"""The motion-motif graph: motifs as nodes, observed successions as edges (MMG section 4)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any, Literal

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from core.errors import FormatError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset

FORMAT = "motionscape/motifs/1"


@dataclass(frozen=True, eq=False)
class Motif:
    """A set of similar motions.

    segments: its motions, at the clips' own rates, never overlapping; medoid: index of the motion nearest the average.
    warps: per motion ``(n_medoid_frames,)`` float32: the frame of that motion, from its start and at its own rate, that
    stands beside each frame of the medoid.
    """

    id: int
    segments: tuple[Segment, ...]
    medoid: int
    warps: tuple[np.ndarray, ...]

    @property
    def mean_frames(self) -> float:
        """Mean number of frames of a motion: the paper's width B_w."""
        return float(np.mean([s.n_frames for s in self.segments]))

    @property
    def n_motions(self) -> int:
        """Number of motions: the paper's height B_h."""
        return len(self.segments)


@dataclass(frozen=True)
class Edge:
    """A motion of motif ``source`` is followed by one of ``target`` with no motif between, ``count`` times.

    transitions: the frames in between, one segment a succession; empty (start == end) where the motions meet.
    """

    source: int
    target: int
    count: int
    transitions: tuple[Segment, ...]


@dataclass(frozen=True, eq=False)
class MotifGraph:
    """Motifs, the successions between them, and how good they are.

    metrics: coverage, average_frame_error, mean_pose_distance, n_motifs, mean_motions, mean_frames; parameters: as
    used, ``kappa`` in numbers; seconds: stage -> time; clips: (name, frames, fps) of every clip.
    """

    motifs: tuple[Motif, ...]
    edges: tuple[Edge, ...]
    metrics: Mapping[str, float]
    parameters: Mapping[str, Any]
    seconds: Mapping[str, float] = field(default_factory=dict)
    clips: tuple[tuple[str, int, float], ...] = ()
    dataset: Mapping[str, Any] = field(default_factory=dict)

    def components(self, connection: Literal["strong", "weak"] = "strong") -> tuple[tuple[int, ...], ...]:
        """Groups of motif ids, largest first: "strong", each reaches the others along edges, or "weak", any way.

        Raises ValueError for another connection.
        """
        if connection not in ("strong", "weak"):
            raise ValueError(f"connection must be strong or weak, not {connection!r}")
        n = len(self.motifs)
        if n == 0:
            return ()
        at = {motif.id: i for i, motif in enumerate(self.motifs)}
        ends = np.array([(at[e.source], at[e.target]) for e in self.edges], np.int64).reshape(-1, 2)
        links = coo_matrix((np.ones(len(ends)), (ends[:, 0], ends[:, 1])), shape=(n, n))
        _, group = connected_components(links, directed=True, connection=connection)
        groups: dict[int, list[int]] = {}
        for motif, g in zip(self.motifs, group, strict=True):
            groups.setdefault(int(g), []).append(motif.id)
        return tuple(sorted(map(tuple, groups.values()), key=lambda ids: (-len(ids), ids)))

    def to_json(self, dataset: Dataset | None = None, notes: Mapping[int, Any] | None = None) -> dict[str, Any]:
        """The document ``motifs.json``; ``dataset`` fills its head where the graph itself does not know it.

        notes: motif id -> what people said of it (``name``, ``tags``, ``note``), written beside its motions.
        """
        clips = self.clips or tuple((c.name, c.n_frames, c.fps) for c in getattr(dataset, "clips", ()))
        head = dict(self.dataset) or dataset_head(dataset)
        return {
            "format": FORMAT,
            "dataset": head,
            "clips": [{"name": name, "frames": int(frames), "fps": float(fps)} for name, frames, fps in clips],
            "parameters": dict(self.parameters),
            "seconds": {stage: round(t, 4) for stage, t in self.seconds.items()},
            "metrics": dict(self.metrics),
            "motifs": [_motif_json(motif) | _note_json((notes or {}).get(motif.id)) for motif in self.motifs],
            "edges": [_edge_json(edge) for edge in self.edges],
            "components": [list(ids) for ids in self.components()],
        }


def dataset_head(dataset: Dataset | None) -> dict[str, Any]:
    """What a result says of its data set: name and fingerprint."""
    return {"name": getattr(dataset, "name", ""), "fingerprint": getattr(dataset, "fingerprint", "")}


def from_json(document: Mapping[str, Any]) -> MotifGraph:
    """The graph back from :meth:`MotifGraph.to_json`. Raises FormatError for anything that is not such a document."""
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        format_name = document.get("format") if isinstance(document, Mapping) else type(document).__name__
        raise FormatError(f"not a motif graph: expected format {FORMAT}, found {format_name}")
    try:
        return MotifGraph(
            motifs=tuple(_read_motif(motif) for motif in document["motifs"]),
            edges=tuple(_read_edge(edge) for edge in document["edges"]),
            metrics=dict(document["metrics"]),
            parameters=dict(document["parameters"]),
            seconds=dict(document["seconds"]),
            clips=tuple((c["name"], int(c["frames"]), float(c["fps"])) for c in document["clips"]),
            dataset=dict(document["dataset"]),
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise FormatError(f"the motif graph is incomplete or damaged: {error!r}") from error


def succession_edges(motifs: tuple[Motif, ...]) -> tuple[Edge, ...]:
    """Edges from all pairs of motions that follow one another in a clip with no motion between."""
    motions = sorted((s, motif.id) for motif in motifs for s in motif.segments)
    transitions: dict[tuple[int, int], list[Segment]] = {}
    for (a, source), (b, target) in pairwise(motions):
        if a.clip == b.clip:
            transitions.setdefault((source, target), []).append(Segment(a.clip, a.end, b.start))
    return tuple(Edge(s, t, len(transitions[s, t]), tuple(transitions[s, t])) for s, t in sorted(transitions))


def _segment_json(segment: Segment) -> dict[str, Any]:
    return {"clip": segment.clip, "start": int(segment.start), "end": int(segment.end)}


def _read_segment(entry: Mapping[str, Any]) -> Segment:
    return Segment(entry["clip"], int(entry["start"]), int(entry["end"]))


def _motif_json(motif: Motif) -> dict[str, Any]:
    return {
        "id": motif.id,
        "motions": [_segment_json(s) for s in motif.segments],
        "medoid": motif.medoid,
        "warps": [[round(float(f), 2) for f in warp] for warp in motif.warps],
    }


def _note_json(note: Any) -> dict[str, Any]:
    return {"name": note.name, "tags": list(note.tags), "note": note.note} if note else {}


def _read_motif(entry: Mapping[str, Any]) -> Motif:
    warps = tuple(np.asarray(warp, np.float32) for warp in entry["warps"])
    return Motif(int(entry["id"]), tuple(map(_read_segment, entry["motions"])), int(entry["medoid"]), warps)


def _edge_json(edge: Edge) -> dict[str, Any]:
    return {
        "source": edge.source,
        "target": edge.target,
        "count": edge.count,
        "transitions": [_segment_json(s) for s in edge.transitions],
    }


def _read_edge(entry: Mapping[str, Any]) -> Edge:
    transitions = tuple(map(_read_segment, entry["transitions"]))
    return Edge(int(entry["source"]), int(entry["target"]), int(entry["count"]), transitions)
