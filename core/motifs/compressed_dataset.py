"""Compression of a data set by its motifs, compared with PCA of each clip at equal error.

Every part of the data set (the motions of one skeleton in a motif, the frames in no motif, a clip, everything) has its
curves of size against error (:mod:`core.motifs.compression`). For a tolerance each part takes its smallest step whose
mean error keeps within it; the sizes are summed. So nothing is gained by putting the error where one does not look.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, NamedTuple

import numpy as np

from core.editing.blending import place, turn_about_y
from core.errors import FormatError
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import resample
from core.mocap.skeleton import Skeleton
from core.motifs.blend_space import blend_space, blendable
from core.motifs.channels import channels_of
from core.motifs.compression import (
    METHODS,
    OWN,
    OWN_PCA,
    POSE_PCA,
    Curves,
    Point,
    Step,
    curves,
    posture_curves,
)
from core.motifs.graph import MotifGraph
from core.motifs.motion_matrices import motions_of
from core.progress import Report, silent

FORMAT = "motionscape/compression/1"
TOLERANCES = (0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 5.0)  # centimetres
MOTIF, REST, CLIP, ALL = "motif", "rest", "clip", "all"
WAYS = {
    "own": "Motifs: own motions",
    "motif-pca": "Motifs: PCA of each",
    "own-pca": "Motifs: own motions + PCA",
    "best": "Motifs: cheapest way each",
    "clips": "PCA clip by clip",
    "all": "PCA of all clips",
}


@dataclass(frozen=True)
class Unit:
    """A part of the data set with its curves. kind: :data:`MOTIF`, :data:`REST` (frames in no motif), :data:`CLIP` or
    :data:`ALL` (of one skeleton); name: of motif or clip, else empty."""

    kind: str
    name: str
    curves: Curves


class Total(NamedTuple):
    """A data set at a tolerance: numbers stored, numbers uncompressed, mean error (centimetres) over all frames."""

    tolerance: float
    numbers: int
    raw: int
    cm: float


@dataclass(frozen=True)
class Compression:
    """All parts of a data set under one motif graph."""

    units: tuple[Unit, ...]

    def motif(self, number: int) -> tuple[Unit, ...]:
        """The units of one motif, one a skeleton that has two or more of its motions."""
        return tuple(unit for unit in self.units if unit.kind == MOTIF and unit.name == str(number))

    def totals(self, way: str, tolerances: Iterable[float] = TOLERANCES) -> tuple[Total, ...]:
        """Size of the whole data set stored one of the :data:`WAYS`, at each tolerance in centimetres.

        Raises ValueError for another way.
        """
        if way not in WAYS:
            raise ValueError(f"a data set is stored one of these ways: {', '.join(WAYS)}; not {way!r}")
        kinds = {"clips": (CLIP,), "all": (ALL,)}.get(way, (MOTIF, REST))
        methods = {"own": (OWN,), "own-pca": (OWN_PCA,), "best": tuple(METHODS)}.get(way, (POSE_PCA,))
        parts = [unit.curves for unit in self.units if unit.kind in kinds]
        return tuple(_total(parts, methods, tolerance, self.raw) for tolerance in tolerances)

    @property
    def raw(self) -> int:
        """Numbers of the data set uncompressed: all frames, all joints that ever turn."""
        return sum(unit.curves.raw for unit in self.units if unit.kind == ALL)

    def to_json(self) -> dict[str, Any]:
        """Plain values; :func:`from_json` reads them."""
        return {"format": FORMAT, "units": [asdict(unit) for unit in self.units]}


def from_json(document: Mapping[str, Any]) -> Compression:
    """The compression back from :meth:`Compression.to_json`. Raises FormatError for anything else."""
    try:
        if document["format"] != FORMAT:
            raise KeyError("format")
        return Compression(tuple(Unit(u["kind"], u["name"], _read_curves(u["curves"])) for u in document["units"]))
    except (KeyError, TypeError, AttributeError) as error:
        raise FormatError(f"not a compression of a data set: {error!r}") from error


def compress_dataset(dataset: Dataset, graph: MotifGraph, fps: float = 30.0, report: Report = silent) -> Compression:
    """Curves of all parts of a data set, looked at ``fps`` times a second; a motion alone of its skeleton in a motif
    counts as in no motif. ``report`` is called for each part and may raise to stop the work."""
    units: list[Unit] = []
    covered: list[Segment] = []
    for done, motif in enumerate(graph.motifs):
        report("motifs", done / len(graph.motifs))
        for group in blendable(dataset, motif):
            if len(group) > 1:
                units.append(Unit(MOTIF, str(motif.id), curves(motions_of(blend_space(dataset, motif, group[0]), fps))))
                covered += [motif.segments[k] for k in group]
    for kind, stage, pieces in (
        (REST, "frames in no motif", _by_skeleton(_uncovered(dataset, covered))),
        (ALL, "all clips together", _by_skeleton(dataset.clips)),
        (CLIP, "clips", [(clip.name, [clip]) for clip in dataset.clips]),
    ):
        for done, (name, clips) in enumerate(pieces):
            report(stage, done / len(pieces))
            units.append(Unit(kind, name, _posture_unit(clips, fps)))
    return Compression(tuple(units))


def _posture_unit(clips: Sequence[Clip], fps: float) -> Curves:
    """Curves of PCA of postures for some clips of one skeleton, each seen from its own middle on the ground."""
    clips = [_centred(clip if clip.fps < fps else resample(clip, fps)) for clip in clips]
    channels = channels_of(clips)
    return posture_curves(channels, np.concatenate([channels.encode(clip) for clip in clips]), len(clips))


def _centred(clip: Clip) -> Clip:
    """The clip moved so that the middle of its way is over the origin, its first steps along Z."""
    root = np.asarray(clip.root_positions, np.float64)
    way = root[-1] - root[0]
    yaw = -float(np.arctan2(way[0], way[2])) if np.hypot(way[0], way[2]) > 0.1 else 0.0
    return place(clip, yaw, -turn_about_y(np.float64(yaw), root.mean(0) * [1, 0, 1]))


def _by_skeleton(clips: Iterable[Clip]) -> list[tuple[str, list[Clip]]]:
    groups: dict[Skeleton, list[Clip]] = {}
    for clip in clips:
        groups.setdefault(clip.skeleton, []).append(clip)
    return [("", group) for group in groups.values()]


def _uncovered(dataset: Dataset, covered: Iterable[Segment]) -> list[Clip]:
    """What is left of the clips without these segments."""
    left = []
    for clip in dataset.clips:
        mine = sorted((s.start, s.end) for s in covered if s.clip == clip.name)
        ends = [0, *(end for _, end in mine)]
        starts = [*(start for start, _ in mine), clip.n_frames]
        left += [clip.cut(a, b) for a, b in zip(ends, starts, strict=True) if b > a]
    return left


def _total(parts: Sequence[Curves], methods: Sequence[str], tolerance: float, raw: int) -> Total:
    numbers, error, frames = 0, 0.0, 0
    for part in parts:
        point = _cheapest(part, methods, tolerance)
        numbers, frames = numbers + point.numbers, frames + part.frames
        error += point.cm * part.frames
    return Total(tolerance, numbers, raw, error / max(frames, 1))


def _cheapest(part: Curves, methods: Sequence[str], tolerance: float) -> Point:
    """The smallest point within the tolerance; the frames as they are where there is none, or it is larger."""
    used = methods if any(part.points.get(m) for m in methods) else (POSE_PCA,)  # frames in no motif have no motions
    within = [p for m in used for p in part.points.get(m, ()) if p.cm <= tolerance and p.numbers < part.raw]
    return min(within, key=lambda p: p.numbers, default=Point(Step(), part.raw, 0.0, 0.0))


def _read_curves(entry: Mapping[str, Any]) -> Curves:
    points = {
        method: tuple(Point(Step(**p["step"]), int(p["numbers"]), float(p["cm"]), float(p["pose"])) for p in found)
        for method, found in entry["points"].items()
    }
    return Curves(int(entry["motions"]), int(entry["frames"]), int(entry["raw"]), points)
