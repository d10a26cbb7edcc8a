"""The methods that analyse a data set: what each takes, what it gives, and how its result is kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from core.progress import Report

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

Kept = tuple[dict[str, Any], dict[str, np.ndarray]]
"""A result as it is stored: a JSON document and named arrays of any shape (n, ...)."""


@dataclass(frozen=True)
class Method:
    """A way to analyse a data set.

    version: goes into the keys of results; raise it when the same request would give another result.
    parameters: gives the dataclass of its parameters (see core.parameters); called late, imports are heavy.
    compute: (data set, parameters, report) -> result.
    pack, unpack: result and data set -> JSON document and arrays of any shape (n, ...), and back.
    """

    title: str
    version: int
    parameters: Callable[[], type]
    compute: Callable[[Dataset, Any, Report], Any]
    pack: Callable[[Any, Dataset], Kept]
    unpack: Callable[[dict[str, Any], dict[str, np.ndarray]], Any]


def _later(module: str, name: str) -> Callable[..., Any]:
    """A function of ``module`` that imports it when it is first called."""

    def call(*arguments: Any) -> Any:
        return getattr(import_module(module), name)(*arguments)

    return call


def _pack_motifs(graph: Any, dataset: Dataset) -> Kept:
    return graph.to_json(dataset), {}


def _unpack_motifs(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Any:
    from core.motifs.graph import from_json

    return from_json(document)


def _motif_parameters() -> type:
    from core.motifs.parameters import MotifParameters

    return MotifParameters


def _stability_parameters() -> type:
    from core.motifs.stability import StabilityParameters

    return StabilityParameters


def _pack_stability(result: Any, dataset: Dataset) -> Kept:
    return result.to_json(), {}


def _unpack_stability(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Any:
    from core.motifs.stability import from_json

    return from_json(document)


def _feature_parameters() -> type:
    from core.export import FeatureParameters

    return FeatureParameters


def _features(dataset: Dataset, values: Any, report: Report) -> Any:
    from core.export import feature_table

    return feature_table(dataset, analysis_fps=values.analysis_fps, test_share=values.test_share, report=report)


def _pack_features(table: Any, dataset: Dataset) -> Kept:
    from core.export import pack_features

    return pack_features(table)


METHODS: dict[str, Method] = {
    "motifs": Method(
        "Motif graph", 1, _motif_parameters, _later("core.motifs.build", "find_motifs"), _pack_motifs, _unpack_motifs
    ),
    "stability": Method(  # judges the motifs of the method above: a new version of that makes a new version of this
        "Stability",
        1,
        _stability_parameters,
        _later("core.motifs.stability", "stability"),
        _pack_stability,
        _unpack_stability,
    ),
    "features": Method(
        "Features",
        1,
        _feature_parameters,
        _features,
        _pack_features,
        _later("core.export", "unpack_features"),
    ),
}
