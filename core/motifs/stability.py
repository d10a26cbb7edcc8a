"""How stable each motif is: found again under noise, from other seeds, with neighbouring parameters (MMG section 5.4).

The paper says that its graphs "are relatively stable when band-limited Gaussian noise is added to the joint angles" and
that other seeds give similar results (5.2); it names neither strength nor band. Here every motif gets a figure: the
analysis is repeated, and of each repeat the motif that overlaps it most (Jaccard, over time) is looked at.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from time import perf_counter
from typing import Any

import numpy as np

from core.editing.noise import shake_dataset
from core.errors import FormatError, ParameterError
from core.mocap.dataset import Dataset
from core.motifs.compare import Comparison, compare
from core.motifs.graph import MotifGraph, dataset_head
from core.motifs.neighbours import neighbours, other_seeds
from core.motifs.parameters import MotifParameters
from core.motifs.quantize import automatic_kappa
from core.motifs.stages import STAGES, Stage, Work, made
from core.motifs.sweep import graphs_of
from core.parameters import parameter
from core.poses.features import pose_features
from core.progress import Report, silent

FORMAT = "motionscape/stability/1"
KINDS = ("noise", "seed", "parameters")


@dataclass(frozen=True)
class StabilityParameters(MotifParameters):
    """The parameters of the motif graph, and of the repeats. Raises ParameterError as its base does."""

    repetitions: int = parameter(2, "How many times noise is added, and how many other seeds are tried.", 1, 20, 1)
    noise_degrees: float = parameter(2.0, "Strength of the noise on each axis of each joint, in degrees.", 0.0, 45, 1)
    noise_low: float = parameter(0.5, "Lowest frequency of the noise, in Hz.", 0.0, 100, 0.5)
    noise_high: float = parameter(5.0, "Highest frequency of the noise, in Hz.", 0.1, 200, 0.5)

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.noise_low >= self.noise_high:
            raise ParameterError(f"noise_low ({self.noise_low:g}) must be below noise_high ({self.noise_high:g})")

    @property
    def motifs(self) -> MotifParameters:
        """The parameters of the motif graph alone."""
        return MotifParameters(**{f.name: getattr(self, f.name) for f in fields(MotifParameters)})


@dataclass(frozen=True, eq=False)
class Repeat:
    """One more analysis, and how well each motif was found again in it.

    kind: one of KINDS; name: what differs ("noise 1", "seed 2", "kappa 250"). overlaps: ``(n_motifs,)`` highest overlap
    of each motif with any of the repeat's; kept: ``(n_motifs,)`` whether it is kept (see core.motifs.compare);
    agreement, adjusted_rand: of the two graphs; metrics: the repeat's own.
    """

    kind: str
    name: str
    overlaps: np.ndarray
    kept: np.ndarray
    agreement: float
    adjusted_rand: float
    metrics: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class Stability:
    """All repeats of one analysis. motifs: ids of the motifs judged; parameters: as used, ``kappa`` in numbers."""

    motifs: tuple[int, ...]
    repeats: tuple[Repeat, ...]
    parameters: Mapping[str, Any]
    seconds: Mapping[str, float] = field(default_factory=dict)
    dataset: Mapping[str, Any] = field(default_factory=dict)

    def by_kind(self) -> dict[str, np.ndarray]:
        """Mean highest overlap of each motif over the repeats of each kind: kind -> ``(n_motifs,)``."""
        kinds = {kind: [r.overlaps for r in self.repeats if r.kind == kind] for kind in KINDS}
        return {kind: np.mean(overlaps, axis=0) for kind, overlaps in kinds.items() if overlaps}

    @property
    def overall(self) -> np.ndarray:
        """Stability of each motif, ``(n_motifs,)``, 0 to 1: the mean of its means over each kind."""
        return np.mean(list(self.by_kind().values()), axis=0) if self.repeats else np.ones(len(self.motifs))

    @property
    def times_kept(self) -> np.ndarray:
        """In how many repeats each motif is kept: ``(n_motifs,)`` int."""
        times: np.ndarray = np.sum([r.kept for r in self.repeats], axis=0, dtype=int) + np.zeros(len(self.motifs), int)
        return times

    def to_json(self) -> dict[str, Any]:
        """The document that :func:`from_json` reads back."""
        overall, kinds, kept = self.overall, self.by_kind(), self.times_kept
        return {
            "format": FORMAT,
            "dataset": dict(self.dataset),
            "parameters": dict(self.parameters),
            "seconds": {stage: round(t, 4) for stage, t in self.seconds.items()},
            "motifs": [
                {"id": motif, "stability": round(float(overall[i]), 4), "kept": int(kept[i])}
                | {kind: round(float(values[i]), 4) for kind, values in kinds.items()}
                for i, motif in enumerate(self.motifs)
            ],
            "repeats": [_repeat_json(repeat) for repeat in self.repeats],
        }


def from_json(document: Mapping[str, Any]) -> Stability:
    """Back from :meth:`Stability.to_json`. Raises FormatError for anything that is not such a document."""
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        raise FormatError(f"not the stability of motifs: expected format {FORMAT}")
    try:
        return Stability(
            tuple(int(motif["id"]) for motif in document["motifs"]),
            tuple(_read_repeat(repeat, len(document["motifs"])) for repeat in document["repeats"]),
            dict(document["parameters"]),
            dict(document["seconds"]),
            dict(document["dataset"]),
        )
    except (KeyError, TypeError, AttributeError) as error:
        raise FormatError(f"the stability of the motifs is incomplete or damaged: {error!r}") from error


_DEFAULT = StabilityParameters()


def stability(dataset: Dataset, parameters: StabilityParameters = _DEFAULT, report: Report = silent) -> Stability:
    """How stable the motifs are that ``find_motifs`` finds with the same parameters. Deterministic.

    Repeats the analysis with noise on the joint angles (kappa "auto" is then chosen anew, as for any recording), other
    seeds, and kappa, rho and gamma a step up and down. Work that repeats share is done once. Raises ValueError as
    ``find_motifs`` does, and where the noise lies above half the frame rate; ``report`` may raise to stop the work.
    """
    started = perf_counter()
    tried = [_Tried("", "", _shaken(parameters, 0)), *_repeats(dataset, parameters, report)]
    graphs: dict[int, MotifGraph] = {}
    repeats: dict[int, Repeat] = {}

    def heard(_stage: str, fraction: float) -> None:
        report(f"analysis {len(graphs) + 1} of {len(tried)}", fraction)

    for k, graph in graphs_of(dataset, [one.parameters for one in tried], heard, stages=(_SHAKING, *STAGES)):
        graphs[k] = graph
        if 0 in graphs:
            for number in graphs.keys() - repeats.keys() - {0}:
                repeats[number] = _repeat(tried[number], compare(graphs[0], graphs[number]), graphs[number])
    base = graphs[0]
    return Stability(
        tuple(motif.id for motif in base.motifs),
        tuple(repeats[k] for k in sorted(repeats)),
        {name: getattr(parameters, name) for name in parameters.__dataclass_fields__}
        | {"kappa": base.parameters["kappa"]},
        {"total": perf_counter() - started},
        dataset_head(dataset),
    )


@dataclass(frozen=True)
class _Shaken(MotifParameters):
    """An analysis of the motion with noise number ``noise``; 0 is the motion as it is."""

    noise: int = parameter(0, "", 0, 100, 1)
    degrees: float = parameter(0.0, "", 0, 360, 1)
    band: tuple[float, float] = field(default=(0.0, 1.0), metadata={"choices": (), "min": None, "max": None})

    def __post_init__(self) -> None:
        """Its parts have been checked."""


@dataclass(frozen=True)
class _Tried:
    kind: str
    name: str
    parameters: _Shaken


def _shake(work: Work, parameters: MotifParameters, report: Report) -> Work:
    assert isinstance(parameters, _Shaken)
    if not parameters.noise:
        return work
    report("noise", 0.0)
    dataset = shake_dataset(made(work.dataset), parameters.degrees, parameters.band, parameters.noise)
    return work._replace(dataset=dataset)


_SHAKING = Stage("noise", ("noise", "degrees", "band"), _shake)


def _shaken(parameters: StabilityParameters, noise: int) -> _Shaken:
    motifs = {f.name: getattr(parameters, f.name) for f in fields(MotifParameters)}
    band = parameters.noise_low, parameters.noise_high
    return _Shaken(**motifs, noise=noise, degrees=parameters.noise_degrees if noise else 0.0, band=band)


def _repeats(dataset: Dataset, parameters: StabilityParameters, report: Report) -> list[_Tried]:
    own, kappa = _shaken(parameters, 0), parameters.kappa
    if isinstance(kappa, str):  # auto
        poses = pose_features(dataset, analysis_fps=parameters.analysis_fps, pose=parameters.pose, report=report)
        kappa = automatic_kappa(poses.values, poses.fps)
    noise = {f"noise {k}": _shaken(parameters, k) for k in range(1, parameters.repetitions + 1)}
    kinds = noise, other_seeds(own, parameters.repetitions), neighbours(own, kappa)
    return [_Tried(kind, name, p) for kind, group in zip(KINDS, kinds, strict=True) for name, p in group.items()]


def _repeat(tried: _Tried, comparison: Comparison, graph: MotifGraph) -> Repeat:
    return Repeat(
        tried.kind,
        tried.name,
        np.array([fate.best for fate in comparison.a]),
        np.array([fate.change == "kept" for fate in comparison.a], bool),
        comparison.agreement,
        comparison.adjusted_rand,
        dict(graph.metrics),
    )


def _repeat_json(repeat: Repeat) -> dict[str, Any]:
    return {
        "kind": repeat.kind,
        "name": repeat.name,
        "agreement": round(repeat.agreement, 4),
        "adjusted_rand": round(repeat.adjusted_rand, 4),
        "overlaps": [round(float(overlap), 4) for overlap in repeat.overlaps],
        "kept": [int(kept) for kept in repeat.kept],
        "metrics": dict(repeat.metrics),
    }


def _read_repeat(entry: Mapping[str, Any], n_motifs: int) -> Repeat:
    overlaps, kept = np.array(entry["overlaps"], float), np.array(entry["kept"], bool)
    if overlaps.shape != (n_motifs,) or kept.shape != (n_motifs,):
        raise FormatError("the stability of the motifs is damaged: a repeat speaks of another number of motifs")
    return Repeat(
        entry["kind"],
        entry["name"],
        overlaps,
        kept,
        float(entry["agreement"]),
        float(entry["adjusted_rand"]),
        dict(entry["metrics"]),
    )
