"""The motion map as an object: postures on a grid, regions, where every clip passes; as JSON and arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from core.errors import AnalysisError, FormatError
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip, Segment
from core.motion_map.bones import refine, with_real_bones
from core.motion_map.key_poses import KeyHit, Pace, Runs, key_nodes, search_keys
from core.motion_map.som import best_nodes, u_matrix
from core.poses.features import posture_joints
from core.poses.postures import clip_postures

FORMAT = "motionscape/map/1"
_TEXT = ("joints", "roles", "sides", "parents", "clips", "clip_fps", "clip_frames", "fps")


class Fit(NamedTuple):
    """How well a clip that the map has not learned fits it: its node per frame ``(n,)``, the distance ``(n,)``, and the

    mean distance as a multiple of what is usual among the clips of the map.
    """

    nodes: np.ndarray
    distances: np.ndarray
    ratio: float


@dataclass(frozen=True, eq=False)
class MotionMap:
    """A motion map.

    weights: ``(nx, ny, 3 n_joints)`` float32 model vectors, positions as in core.poses.postures (metres). regions:
    ``(nx, ny)`` int; icons: ``(n_regions, 2)`` node of each region's icon. runs: stays of the clips on nodes, in
    analysis frames. joints, roles, sides, parents, lengths: of the postures. clips, clip_fps, clip_frames, fps: as in
    Postures.
    metrics: quantisation_error, topographic_error, samples, threshold, n_regions, usual_distance.
    """

    weights: np.ndarray
    regions: np.ndarray
    icons: np.ndarray
    runs: Runs
    joints: tuple[str, ...]
    roles: tuple[str, ...]
    sides: tuple[str, ...]
    parents: tuple[int, ...]
    lengths: np.ndarray
    clips: tuple[str, ...]
    clip_fps: tuple[float, ...]
    clip_frames: tuple[int, ...]
    fps: float
    metrics: Mapping[str, float]
    parameters: Mapping[str, Any]
    seconds: Mapping[str, float] = field(default_factory=dict)
    dataset: Mapping[str, Any] = field(default_factory=dict)

    @property
    def grid(self) -> tuple[int, int]:
        """Nodes across and down."""
        return self.weights.shape[0], self.weights.shape[1]

    @cached_property
    def heights(self) -> np.ndarray:
        """The U-matrix ``(nx, ny)``, metres."""
        return u_matrix(self.weights)

    @cached_property
    def postures(self) -> np.ndarray:
        """Model vectors as postures with real bone lengths: ``(nx, ny, n_joints, 3)``."""
        shaped = self.weights.reshape(*self.grid, -1, 3)
        return with_real_bones(shaped.astype(np.float64), self.parents, self.lengths).astype(np.float32)

    @cached_property
    def fits(self) -> np.ndarray:
        """How badly each clip fits, ``(n_clips,)``: its mean distance to the nodes it passes, as a multiple of what is

        usual among the clips that the map has learned.
        """
        frames = (self.runs.end - self.runs.start).astype(np.float64)
        total = np.bincount(self.runs.clip, self.runs.distance * frames, len(self.clips))
        mean = total / np.maximum(np.bincount(self.runs.clip, frames, len(self.clips)), 1)
        return mean / max(self.metrics["usual_distance"], 1e-9)

    @cached_property
    def density(self) -> np.ndarray:
        """Seconds of motion on every node: ``(nx, ny)``."""
        frames = np.bincount(self.runs.node, self.runs.end - self.runs.start, self.grid[0] * self.grid[1])
        return frames.reshape(self.grid) / self.fps

    def segment(self, clip: int, start: int, end: int) -> Segment:
        """Analysis frames ``[start, end)`` of a clip as a segment in frames of its own rate."""
        scale, frames = self.clip_fps[clip] / self.fps, self.clip_frames[clip]
        first = min(round(start * scale), frames - 1)
        return Segment(self.clips[clip], first, max(min(round(end * scale), frames), first + 1))

    def nodes_of(self, clip: str) -> np.ndarray:
        """Node ``(n, 2)`` of each analysis frame of a clip of the map. Raises KeyError for another clip."""
        if clip not in self.clips:
            raise KeyError(f"the map has no clip {clip!r}")
        mine = self.runs.clip == self.clips.index(clip)
        nodes = np.repeat(self.runs.node[mine], self.runs.end[mine] - self.runs.start[mine])
        return np.column_stack(np.divmod(nodes, self.grid[1]))

    def trajectory(self, clip: Clip, factor: int = 4, step: int = 1) -> np.ndarray:
        """Path ``(n, 2)`` of a clip over the map, in node units, one point every ``step`` frames of its own rate.

        Nearest of the real and virtual nodes (MAP 3.3), ``factor`` to a node spacing. Raises ValueError for a clip
        whose skeleton lacks a joint of the map.
        """
        fine = self._refined(factor)
        best, _ = best_nodes(self.vectors_of(clip)[0][::step], fine)
        return np.column_stack(np.divmod(best, fine.shape[1])) / factor

    def fit(self, clip: Clip) -> Fit:
        """Assigns a clip the map has not seen, and says how badly it fits; raises as :meth:`trajectory`."""
        nodes, distances = best_nodes(self.vectors_of(clip)[0], self.weights)
        return Fit(nodes, distances, float(distances.mean() / max(self.metrics["usual_distance"], 1e-9)))

    def nearest(self, posture: np.ndarray) -> tuple[tuple[int, int], float]:
        """The node nearest to a posture ``(n_joints, 3)`` or ``(3 n_joints,)``, and the distance to it, metres."""
        best, apart = best_nodes(np.asarray(posture, np.float32).reshape(1, -1), self.weights)
        return (int(best[0]) // self.grid[1], int(best[0]) % self.grid[1]), float(apart[0])

    def search(
        self, keys: Sequence[tuple[int, int]], threshold: float = 0.0, pace: Pace | None = None
    ) -> list[tuple[Segment, KeyHit]]:
        """Stretches that pass through the key nodes in order, best first (MAP section 4); threshold: the paper's T.

        pace: how the body must travel at the keys.
        """
        hits = search_keys(self.runs, [key_nodes(self.weights, key, threshold) for key in keys], pace)
        return [(self.segment(hit.clip, hit.start, hit.end), hit) for hit in hits]

    def _refined(self, factor: int) -> np.ndarray:
        cache: dict[int, np.ndarray] = self.__dict__.setdefault("_fine", {})
        if factor not in cache:
            shaped = self.weights.reshape(*self.grid, -1, 3)
            fine = refine(shaped, self.parents, self.lengths, factor)
            # real nodes stay what they learned: only those between are made up
            fine[::factor, ::factor] = shaped
            cache[factor] = fine.reshape(*fine.shape[:2], -1)
        return cache[factor]

    def vectors_of(self, clip: Clip) -> tuple[np.ndarray, np.ndarray]:
        """Every frame of any clip as the map compares it, ``(n, 3 n_joints)``, and its velocity ``(n, 2)`` in m/s.

        Raises AnalysisError for a clip whose skeleton lacks a joint of the map.
        """
        own = posture_joints([clip.skeleton])[clip.skeleton]
        body = find_anatomy(clip.skeleton).joints
        joints: dict[str, int] = {}
        missing: list[str] = []
        for name, role in zip(self.joints, self.roles, strict=True):
            joint = own.get(name, body.get(role))
            if joint is None:
                missing.append(name)
            else:
                joints[name] = joint
        if missing:
            raise AnalysisError(f"{clip.name} lacks joints of this map: {', '.join(missing[:5])}")
        values, _, velocity = clip_postures(clip, joints)
        return values.reshape(len(values), -1), velocity

    def to_json(self) -> dict[str, Any]:
        """The document ``map.json``: grid, errors, regions with their icons, and runs at the clips' own rates."""
        segments = [
            self.segment(c, s, e) for c, s, e in zip(self.runs.clip, self.runs.start, self.runs.end, strict=True)
        ]
        nodes = np.column_stack(np.divmod(self.runs.node, self.grid[1])).tolist()
        return {
            "format": FORMAT,
            "dataset": dict(self.dataset),
            "clips": [
                {"name": n, "frames": int(f), "fps": float(r)}
                for n, f, r in zip(self.clips, self.clip_frames, self.clip_fps, strict=True)
            ],
            "parameters": dict(self.parameters),
            "seconds": {stage: round(t, 4) for stage, t in self.seconds.items()},
            "metrics": dict(self.metrics),
            "grid": list(self.grid),
            "quantisation_error": self.metrics["quantisation_error"],
            "topographic_error": self.metrics["topographic_error"],
            "samples": int(self.metrics["samples"]),
            "regions": [
                {"id": k, "nodes": np.argwhere(self.regions == k).tolist(), "icon": icon.tolist()}
                for k, icon in enumerate(self.icons)
            ],
            "runs": [
                {"clip": s.clip, "start": int(s.start), "end": int(s.end), "node": node}
                for s, node in zip(segments, nodes, strict=True)
            ],
        }

    def pack(self) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
        """The map as a small JSON document and arrays, to be kept."""
        document = {"format": FORMAT, "dataset": dict(self.dataset), "metrics": dict(self.metrics)}
        document |= {"parameters": dict(self.parameters), "seconds": dict(self.seconds)}
        document |= {name: list(v) if isinstance(v := getattr(self, name), tuple) else v for name in _TEXT}
        arrays = {"weights": self.weights, "regions": self.regions, "icons": self.icons, "lengths": self.lengths}
        return document, arrays | {f"runs_{name}": values for name, values in self.runs._asdict().items()}


def unpack(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> MotionMap:
    """The map back from the arrays ``(n, ...)`` of :meth:`MotionMap.pack`. Raises FormatError for anything else."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not a motion map: expected format {FORMAT}, found {document.get('format')}")
    kept: dict[str, Any] = {name: tuple(v) if isinstance(v := document[name], list) else v for name in _TEXT}
    kept |= {name: arrays[name] for name in ("weights", "regions", "icons", "lengths")}
    kept |= {name: dict(document[name]) for name in ("metrics", "parameters", "seconds", "dataset")}
    return MotionMap(runs=Runs(*(arrays[f"runs_{name}"] for name in Runs._fields)), **kept)
