"""The figures of motif graphs that a workspace keeps, quick to read however large the graphs are.

Beside each motif graph lies a small summary: its metrics, how long it took and, where the data set has labels, how well
its motifs agree with them. Summaries are made when they are first asked for, and again when the labels have changed.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path

from core.caching import RecentCache
from core.errors import FormatError
from core.evaluation.coverage import score_motifs
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph, from_json
from core.workspace import ResultDamaged, Workspace

METRICS = ("n_motifs", "mean_motions", "mean_frames", "coverage", "average_frame_error", "mean_pose_distance")
SCORES = ("purity", "f1_majority")
"""Agreement with labels; only where a data set has any."""

_VERSION = 1  # goes into the names of summaries: raise it when figures are counted in another way

Figures = dict[str, float]
"""METRICS, kappa (letters in use), seconds (of all stages together) and, where there are labels, SCORES."""


def figures_of(graph: MotifGraph, labels: Iterable[Label] = ()) -> Figures:
    """The figures of one motif graph. ``labels``: of its data set, in frames of the clips' own rates."""
    figures = {name: float(graph.metrics[name]) for name in METRICS}
    figures |= {"kappa": float(graph.parameters["kappa"]), "seconds": float(sum(graph.seconds.values()))}
    labels = tuple(labels)
    if labels:
        scores = score_motifs([motif.segments for motif in graph.motifs], labels)
        figures |= {name: float(getattr(scores, name)) for name in SCORES}
    return figures


def keep_figures(workspace: Workspace, key: str, graph: MotifGraph, dataset: Dataset) -> Figures:
    """The figures of the motif graph stored under ``key``, from now on quick to read. Raises WorkspaceError."""
    figures, place = figures_of(graph, dataset.labels), _place(key, _label_mark(dataset))
    workspace.results.put(place, figures)
    _known.put((workspace.path, place), figures)
    return figures


def read_figures(workspace: Workspace, dataset: Dataset, keys: Sequence[str]) -> list[Figures | None]:
    """The figures of the motif graphs of ``dataset`` stored under ``keys``; None where there is no graph (yet)."""
    mark = _label_mark(dataset)
    return [_read(workspace, dataset, key, _place(key, mark)) for key in keys]


def _read(workspace: Workspace, dataset: Dataset, key: str, place: str) -> Figures | None:
    if (figures := _known.get((workspace.path, place))) is not None:
        return figures
    if not workspace.results.has(key):
        return None
    with suppress(ResultDamaged):  # it has been set aside: count again
        stored = workspace.results.get(place)
        if stored is not None:
            _known.put((workspace.path, place), stored.document)
            return stored.document
    try:
        graph = workspace.results.get(key)
        return keep_figures(workspace, key, from_json(graph.document), dataset) if graph else None
    except (ResultDamaged, FormatError):  # set aside, or of another version: as if it had not been computed
        return None


def _place(key: str, mark: str) -> str:
    """Where the summary of the graph under ``key`` lies: it depends on the labels too, which the key does not know."""
    return hashlib.blake2b(json.dumps([_VERSION, key, mark]).encode(), digest_size=16).hexdigest()


def _label_mark(dataset: Dataset) -> str:
    return hashlib.blake2b(json.dumps(dataset.labels).encode(), digest_size=16).hexdigest() if dataset.labels else ""


_known: RecentCache[tuple[Path, str], Figures] = RecentCache(20_000)
