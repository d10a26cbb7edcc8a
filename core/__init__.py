"""Motionscape's analysis package: numpy arrays in, small frozen dataclasses out.

    >>> from core import find_motifs, make_demo
    >>> graph = find_motifs(make_demo(minutes=1))
    >>> 0 < graph.metrics["coverage"] <= 1
    True

The verbs are loaded when first used, so that importing ``core`` costs nothing.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_VERBS = {
    "open_dataset": "core.mocap.dataset",
    "make_demo": "core.demo",
    "find_motifs": "core.motifs.build",
    "MotifParameters": "core.motifs.build",
    "sweep": "core.motifs.sweep",
    "build_motion_map": "core.motion_map.build",
    "MapParameters": "core.motion_map.build",
    "build_search_index": "core.retrieval.search",
    "SearchParameters": "core.retrieval.search",
    "learn_grammar": "core.grammar.build",
    "GrammarParameters": "core.grammar.build",
    "make_walk": "core.synthesis",
    "derive": "core.synthesis",
    "stitch": "core.synthesis",
    "Workspace": "core.workspace",
}
__all__ = sorted(_VERBS)


def __getattr__(name: str) -> Any:
    if name not in _VERBS:
        raise AttributeError(f"module 'core' has no attribute {name!r}")
    return getattr(import_module(_VERBS[name]), name)
