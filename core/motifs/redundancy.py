"""Near-duplicates and rare postures of a collection, and which clips to keep."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from itertools import pairwise
from typing import Any

import faiss
import numpy as np
from scipy.cluster.hierarchy import fcluster, linkage
from scipy.spatial.distance import squareform

from core.errors import FormatError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.build import motifs_of_poses
from core.motifs.graph import Motif, MotifGraph, dataset_head
from core.motifs.parameters import MotifParameters
from core.poses.features import Poses, pose_features
from core.progress import Report, silent

FORMAT = "motionscape/redundancy/1"
_SAMPLES = 32  # moments at which two motions are compared
_MOST_COMPARED = 600  # motions of one motif compared pair by pair
_NEIGHBOURS = 64
_LOOKED_AT = 40_000  # postures among which the rare ones are sought
_APART = 2.0  # seconds within one clip that count as one occasion
_ENOUGH = 0.95  # share of all that is distinct that the keep-list holds


@dataclass(frozen=True)
class RedundancyParameters(MotifParameters):
    """The parameters of the motif graph that is looked at, and what counts as a copy. Raises ValueError as its base."""

    alike: float = field(
        default=0.12,
        metadata={
            "help": "Motions nearer to each other than this share of the mean distance between poses count as copies.",
            "min": 0.01, "max": 1.0, "step": 0.01, "choices": (),
        },
    )  # fmt: skip
    rare: int = field(
        default=24,
        metadata={"help": "How many rare postures to list.", "min": 1, "max": 500, "step": 1, "choices": ()},
    )

    @property
    def motifs(self) -> MotifParameters:
        """The parameters of the motif graph alone."""
        return MotifParameters(**{f.name: getattr(self, f.name) for f in fields(MotifParameters)})


@dataclass(frozen=True)
class Copies:
    """Motions of one motif that are near-duplicates: their places among the motif's segments, the one to keep first."""

    motif: int
    motions: tuple[int, ...]


@dataclass(frozen=True)
class ClipContent:
    """One clip. shares: of its frames in motifs; gain: seconds of content that no clip before it on the list has;

    total: share of all distinct content that the list holds up to here; keep: whether the keep-list has it.
    """

    clip: str
    seconds: float
    share: float
    gain: float
    total: float
    keep: bool


@dataclass(frozen=True)
class RarePosture:
    """A posture far from all others: where it is (frame of the clip's own rate) and how far the nearest other occasion

    is, as a multiple of the median over all postures.
    """

    clip: str
    frame: int
    distance: float


@dataclass(frozen=True, eq=False)
class Redundancy:
    """The report. metrics: coverage, copies (share of all frames that are copies of a motion kept), distinct_seconds,

    seconds, kept_clips, kept_seconds; clips: the most telling first; copies, rare: as above; parameters: as used.
    """

    metrics: Mapping[str, float]
    clips: tuple[ClipContent, ...]
    copies: tuple[Copies, ...]
    rare: tuple[RarePosture, ...]
    parameters: Mapping[str, Any]
    dataset: Mapping[str, Any] = field(default_factory=dict)

    def to_json(self) -> dict[str, Any]:
        """The report as a JSON document."""
        return {
            "format": FORMAT,
            "dataset": dict(self.dataset),
            "parameters": dict(self.parameters),
            "metrics": dict(self.metrics),
            "clips": [asdict(clip) for clip in self.clips],
            "copies": [asdict(copies) for copies in self.copies],
            "rare": [asdict(posture) for posture in self.rare],
        }


def from_json(document: Mapping[str, Any]) -> Redundancy:
    """The report back from :meth:`Redundancy.to_json`. Raises FormatError for anything else."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not a report on redundancy: expected format {FORMAT}, found {document.get('format')}")
    return Redundancy(
        metrics=dict(document["metrics"]),
        clips=tuple(ClipContent(**clip) for clip in document["clips"]),
        copies=tuple(Copies(c["motif"], tuple(c["motions"])) for c in document["copies"]),
        rare=tuple(RarePosture(**posture) for posture in document["rare"]),
        parameters=dict(document["parameters"]),
        dataset=dict(document["dataset"]),
    )


def redundancy(dataset: Dataset, parameters: RedundancyParameters | None = None, report: Report = silent) -> Redundancy:
    """The report on a data set; its motifs are those of :func:`core.motifs.find_motifs` with the same parameters.

    Raises ValueError as that does; ``report`` may raise to stop the work.
    """
    parameters = parameters or RedundancyParameters()
    poses = pose_features(dataset, analysis_fps=parameters.analysis_fps, pose=parameters.pose, report=report)
    graph = motifs_of_poses(poses, parameters.motifs, report)
    return redundancy_of(dataset, poses, graph, parameters, report)


def redundancy_of(
    dataset: Dataset, poses: Poses, graph: MotifGraph, parameters: RedundancyParameters, report: Report = silent
) -> Redundancy:
    """The report from pose features and the motif graph made of them."""
    limit = parameters.alike * poses.mean_distance
    copies: list[Copies] = []
    for k, motif in enumerate(graph.motifs):
        copies += _copies(motif, poses, limit)
        report("comparing motions", (k + 1) / len(graph.motifs))
    clips = keep_list(dataset, graph, copies)
    rare = rare_postures(poses, parameters.rare, report)
    dropped = [graph.motifs[c.motif].segments[i] for c in copies for i in c.motions[1:]]
    kept = [clip for clip in clips if clip.keep]
    metrics = {
        "coverage": float(graph.metrics["coverage"]),
        "copies": sum(s.n_frames for s in dropped) / max(sum(clip.n_frames for clip in dataset.clips), 1),
        "distinct_seconds": sum(clip.gain for clip in clips),
        "seconds": sum(clip.seconds for clip in clips),
        "kept_clips": float(len(kept)),
        "kept_seconds": sum(clip.seconds for clip in kept),
    }
    used = asdict(parameters) | {"kappa": graph.parameters["kappa"]}
    return Redundancy(metrics, clips, tuple(copies), rare, used, dataset_head(dataset))


def _copies(motif: Motif, poses: Poses, limit: float) -> list[Copies]:
    """Groups of motions of which every two are nearer than ``limit``: mean distance of poses along the alignment."""
    curves = _curves(motif, poses)[:_MOST_COMPARED]
    apart = np.zeros((len(curves), len(curves)))
    for moment in np.swapaxes(curves, 0, 1):
        apart += np.linalg.norm(moment[:, None] - moment[None], axis=-1)
    apart /= curves.shape[1]
    np.fill_diagonal(apart, 0)
    groups = fcluster(linkage(squareform((apart + apart.T) / 2, checks=False), "complete"), limit, "distance")
    copies = []
    for group in np.unique(groups):
        members = np.flatnonzero(groups == group)
        if len(members) > 1:
            middle = members[np.argmin(apart[np.ix_(members, members)].sum(axis=0))]
            copies.append(Copies(motif.id, (int(middle), *(int(i) for i in members if i != middle))))
    return copies


def _curves(motif: Motif, poses: Poses) -> np.ndarray:
    """Poses of every motion at the same moments of the motif: ``(n_motions, 32, n_features)``."""
    place = {name: k for k, name in enumerate(poses.clips)}
    moments = np.linspace(0, len(motif.warps[motif.medoid]) - 1, _SAMPLES)
    curves = np.empty((len(motif.segments), _SAMPLES, poses.values.shape[1]), np.float32)
    for i, (segment, warp) in enumerate(zip(motif.segments, motif.warps, strict=True)):
        k = place[segment.clip]
        own = segment.start + np.interp(moments, np.arange(len(warp)), warp)
        at = np.round(own * poses.fps / poses.clip_fps[k]).astype(int)
        low, high = poses.clip_starts[k], poses.clip_starts[k + 1] - 1
        curves[i] = poses.values[np.clip(low + at, low, high)]
    return curves


def keep_list(dataset: Dataset, graph: MotifGraph, copies: list[Copies]) -> tuple[ClipContent, ...]:
    """All clips, each time the one that brings most that is new; the first so many as hold 95 % of it are to be kept.

    A clip's content: its frames outside motifs, which are its own, and of each group of copies (a motion that has none
    is a group of one) the length of its motion, which counts once. Greedy, as is usual for such covers: at worst 63 %
    of the best choice of as many clips (Nemhauser, Wolsey, Fisher 1978).
    """
    rates = {clip.name: clip.fps for clip in dataset.clips}
    group_of = {(c.motif, i): (c.motif, c.motions[0]) for c in copies for i in c.motions}
    worth: dict[tuple[int, int], float] = {}
    holds: dict[str, set[tuple[int, int]]] = {clip.name: set() for clip in dataset.clips}
    inside = dict.fromkeys(rates, 0)
    for motif in graph.motifs:
        for i, segment in enumerate(motif.segments):
            group = group_of.get((motif.id, i), (motif.id, i))
            worth[group] = max(worth.get(group, 0.0), segment.n_frames / rates[segment.clip])
            holds[segment.clip].add(group)
            inside[segment.clip] += segment.n_frames
    own = {clip.name: (clip.n_frames - inside[clip.name]) / clip.fps for clip in dataset.clips}
    everything = sum(own.values()) + sum(worth.values())
    ordered: list[ClipContent] = []
    held: set[tuple[int, int]] = set()
    total = 0.0
    left = {clip.name: clip for clip in sorted(dataset.clips, key=lambda clip: clip.name)}
    while left:
        gains = {name: own[name] + sum((worth[group] for group in holds[name] - held), 0.0) for name in left}
        name = max(gains, key=gains.__getitem__)
        keep = total < _ENOUGH * everything - 1e-9
        total += gains[name]
        held |= holds[name]
        clip = left.pop(name)
        share = inside[name] / clip.n_frames
        ordered.append(ClipContent(name, clip.seconds, share, gains[name], total / max(everything, 1e-9), keep))
    return tuple(ordered)


def rare_postures(poses: Poses, number: int, report: Report = silent) -> tuple[RarePosture, ...]:
    """Postures whose nearest other occasion is farthest, one an occasion, the rarest first.

    Frames of the same clip within two seconds are one occasion. Of long collections every so many-th posture is looked
    at, 40 000 in all, so that the cost has a bound.
    """
    step = max(1, round(poses.fps / 10), int(np.ceil(len(poses.values) / _LOOKED_AT)))
    at = np.concatenate([np.arange(low, high, step) for low, high in pairwise(poses.clip_starts)])
    clip = np.searchsorted(poses.clip_starts, at, side="right") - 1
    values = np.ascontiguousarray(poses.values[at], np.float32)
    index = faiss.IndexFlatL2(values.shape[1])
    index.add(values)
    lonely = np.empty(len(at))
    for low in range(0, len(at), 2000):
        squared, near = index.search(values[low : low + 2000], min(_NEIGHBOURS, len(at)))
        here = np.arange(low, min(low + 2000, len(at)))[:, None]
        same = (clip[near] == clip[here]) & (np.abs(at[near] - at[here]) <= _APART * poses.fps)
        squared = np.where(same, np.inf, squared)
        lonely[here[:, 0]] = np.sqrt(np.maximum(np.min(squared, axis=1), 0))
        report("rare postures", min(1.0, (low + 2000) / len(at)))
    # where all neighbours looked at are of the same occasion, the farthest of them is a lower bound
    bound = np.isinf(lonely)
    if bound.any():
        lonely[bound] = np.sqrt(np.maximum(_farthest_looked_at(index, values[bound]), 0))
    usual = max(float(np.median(lonely)), 1e-9)
    rare: list[RarePosture] = []
    taken: list[tuple[int, int]] = []
    for k in np.argsort(-lonely, kind="stable"):
        if len(rare) == number:
            break
        if all(clip[k] != c or abs(at[k] - a) > _APART * poses.fps for c, a in taken):
            taken.append((int(clip[k]), int(at[k])))
            frame = poses.frame_of(int(clip[k]), int(at[k] - poses.clip_starts[clip[k]]))
            rare.append(RarePosture(poses.clips[clip[k]], frame, float(lonely[k] / usual)))
    return tuple(rare)


def _farthest_looked_at(index: faiss.Index, values: np.ndarray) -> np.ndarray:
    """Squared distance ``(n,)`` of each row to the farthest of its nearest neighbours that were looked at."""
    squared: np.ndarray = index.search(np.ascontiguousarray(values), min(_NEIGHBOURS, index.ntotal))[0]
    return squared[:, -1]


def kept_segments(graph: MotifGraph, copies: tuple[Copies, ...]) -> list[tuple[Segment, int, bool]]:
    """Every motion with its motif and whether to keep it: of copies the one in their middle stays."""
    dropped = {(c.motif, i) for c in copies for i in c.motions[1:]}
    return [
        (segment, motif.id, (motif.id, i) not in dropped)
        for motif in graph.motifs
        for i, segment in enumerate(motif.segments)
    ]
