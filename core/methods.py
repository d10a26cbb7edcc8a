"""The methods that analyse a data set: their parameters, functions, and storage of results."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from core.progress import Report

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

Kept = tuple[dict[str, Any], dict[str, np.ndarray]]
"""A result as it is stored: a JSON document and named arrays of any shape (n, ...)."""


Need = tuple[str, dict[str, Any]]


@dataclass(frozen=True)
class Method:
    """A way to analyse a data set.

    version: goes into the keys of results; raise it when the same request would give another result.
    parameters: gives the dataclass of its parameters (see core.parameters); called late, imports are heavy.
    compute: (data set, parameters, report) -> result.
    pack, unpack: result and data set -> JSON document and arrays of any shape (n, ...), and back.
    needs: where it works on results of other methods, parameters -> (method, its parameters) of each; ``compute`` takes
    those results as further arguments.
    all_kinds: whether it takes clips whose bodies cannot be compared; other methods get those of the largest kind only
    (core.mocap.rigs).
    extends: where it goes on from an earlier result of its own, parameters -> that result's key, or ""; ``compute``
    takes that result as its last argument.
    """

    title: str
    version: int
    parameters: Callable[[], type]
    compute: Callable[..., Any]
    pack: Callable[[Any, Dataset], Kept]
    unpack: Callable[[dict[str, Any], dict[str, np.ndarray]], Any]
    needs: Callable[[Any], tuple[Need, ...]] = lambda values: ()
    extends: Callable[[Any], str] | None = None
    all_kinds: bool = False


def _read_graph(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Any:
    return import_module("core.motifs.graph").from_json(document)


def _method(
    title: str,
    version: int,
    module: str,
    parameters: str,
    compute: str,
    pack: Callable[[Any, Dataset], Kept] | None = None,
    unpack: Callable[[dict[str, Any], dict[str, np.ndarray]], Any] | None = None,
    result: str = "",
    extends: Callable[[Any], str] | None = None,
    all_kinds: bool = False,
) -> Method:
    """A method whose parts are names in ``module``, imported when first used.

    Where nothing else is said the result keeps itself: ``result.to_json()``, and ``from_json(document)`` of the module.
    result: the module of a result that has arrays: ``result.pack()``, and ``unpack(document, arrays)`` of that module.
    """
    if result:
        pack = lambda made, dataset: made.pack()  # noqa: E731
        unpack = lambda document, arrays: import_module(result).unpack(document, arrays)  # noqa: E731

    def named(name: str) -> Any:
        return getattr(import_module(module), name)

    return Method(
        title,
        version,
        lambda: named(parameters),
        lambda dataset, values, report, *given: named(compute)(dataset, values, report, *given),
        pack or (lambda result, dataset: (result.to_json(), {})),
        unpack or (lambda document, arrays: named("from_json")(document)),
        extends=extends,
        all_kinds=all_kinds,
    )


def _compress(dataset: Dataset, values: Any, report: Report, graph: Any) -> Any:
    from core.motifs.compressed_dataset import compress_dataset

    return compress_dataset(dataset, graph, report=report)


def _walk(dataset: Dataset, values: Any, report: Report, graph: Any) -> Any:
    from core.synthesis import make_walk

    return make_walk(dataset, graph, values.path, **values.options, report=report)


def _grammar(dataset: Dataset, values: Any, report: Report, terminals: Any) -> Any:
    from core.grammar.build import grammar_of_terminals

    return grammar_of_terminals(terminals, values, report)


def _derive(dataset: Dataset, values: Any, report: Report, learned: Any) -> Any:
    from core.synthesis.derivations import derive

    return derive(dataset, learned, values.sentence, keep_feet=values.keep_feet, seed=values.seed, report=report)


def _bake_off(dataset: Dataset, values: Any, report: Report, learned: Any, graph: Any) -> Any:
    from core.synthesis.bakeoff import bake_off

    return bake_off(dataset, learned, graph, values, report)


METHODS: dict[str, Method] = {
    "motifs": _method("Motif graph", 3, "core.motifs.build", "MotifParameters", "find_motifs", unpack=_read_graph),
    # these two, compression and walk look at the motifs of the first: a new version of that makes new ones of theirs
    "stability": _method("Stability", 3, "core.motifs.stability", "StabilityParameters", "stability"),
    "redundancy": _method("Coverage report", 3, "core.motifs.redundancy", "RedundancyParameters", "redundancy"),
    "map": _method(
        "Motion map",
        2,
        "core.motion_map.build",
        "MapParameters",
        "build_motion_map",
        result="core.motion_map.motion_map",
        extends=lambda values: values.model,
    ),
    "search": _method(
        "Search index",
        5,
        "core.retrieval.search",
        "SearchParameters",
        "build_search_index",
        result="core.retrieval.search",
        all_kinds=True,
    ),
    "ranking": _method(
        "Rankings by several engines",
        4,
        "core.rankings",
        "RankingParameters",
        "rank_dataset",
        result="core.rankings",
    ),
    "features": _method(
        "Features",
        1,
        "core.export",
        "FeatureParameters",
        "feature_table",
        pack=lambda table, dataset: import_module("core.export").pack_features(table),
        unpack=lambda document, arrays: import_module("core.export").unpack_features(document, arrays),
    ),
    "groups": Method(
        "Groups compared",
        2,
        lambda: import_module("core.comparing").CompareParameters,
        lambda dataset, values, report, *given: import_module("core.comparing").compare_dataset(
            dataset, values, report, *given
        ),
        lambda document, dataset: (document, {}),
        lambda document, arrays: document,
        needs=lambda values: values.need(),
    ),
    "compression": Method(
        "Compression",
        3,
        lambda: import_module("core.motifs.parameters").MotifParameters,
        _compress,
        lambda result, dataset: (result.to_json(), {}),
        lambda document, arrays: import_module("core.motifs.compressed_dataset").from_json(document),
        needs=lambda values: (("motifs", asdict(values)),),
    ),
    "walk": Method(
        "Walk",
        4,
        lambda: import_module("core.synthesis.parameters").WalkParameters,
        _walk,
        lambda walk, dataset: import_module("core.synthesis.kept_walks").pack_walk(walk),
        lambda document, arrays: import_module("core.synthesis.kept_walks").unpack_walk(document, arrays),
        needs=lambda values: (("motifs", values.graph),),
    ),
    "terminals": _method(
        "Terminals",
        3,
        "core.grammar.identification",
        "TerminalParameters",
        "find_terminals",
        unpack=lambda document, arrays: import_module("core.grammar.terminals").from_json(document),
    ),
    "grammar": Method(
        "Grammar",
        4,
        lambda: import_module("core.grammar.build").GrammarParameters,
        _grammar,
        lambda result, dataset: (result.to_json(), {}),
        lambda document, arrays: import_module("core.grammar.learned").from_json(document),
        needs=lambda values: (("terminals", values.terminals),),
    ),
    "derive": Method(
        "New routine",
        4,
        lambda: import_module("core.synthesis.parameters").DeriveParameters,
        _derive,
        lambda made, dataset: import_module("core.synthesis.kept_derivations").pack_derivation(made),
        lambda document, arrays: import_module("core.synthesis.kept_derivations").unpack_derivation(document, arrays),
        needs=lambda values: (("grammar", values.grammar),),
    ),
    "bakeoff": Method(
        "Comparison of four ways",
        4,
        lambda: import_module("core.synthesis.bakeoff").BakeoffParameters,
        _bake_off,
        lambda found, dataset: import_module("core.synthesis.kept_bakeoff").pack_bakeoff(found),
        lambda document, arrays: import_module("core.synthesis.kept_bakeoff").unpack_bakeoff(document, arrays),
        needs=lambda values: (("grammar", values.grammar), ("motifs", {"seed": values.seed})),
    ),
}
