"""What boards and reports show of a search: its hits, best first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.search.searching import find, read
from webapp.ui.filmstrip import segment_filmstrip
from webapp.ui.tables import labels_by_clip, majority_label

MOST_HITS = 24


def hits(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``hits``: clip, start, end, seconds, score, label, strip. Raises MotionscapeError for what cannot be searched."""
    if read(view) is None:
        raise ParameterError("Nothing was searched for when this block was added: search, then add it again.")
    found = find(workspace, dataset, view)
    if found is None:
        return None
    by_clip = labels_by_clip(dataset)
    return {
        "query": found.query.name,
        "hits": [
            {
                "clip": hit.segment.clip,
                "start": hit.segment.start,
                "end": hit.segment.end,
                "seconds": round(hit.segment.n_frames / dataset.clip(hit.segment.clip).fps, 2),
                "score": round(float(hit.score), 3),
                "label": majority_label([hit.segment], by_clip),
                "strip": segment_filmstrip(dataset, hit.segment),
            }
            for hit in found.hits[:MOST_HITS]
        ],
    }


def segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """The hits, best first."""
    return ((hit["clip"], hit["start"], hit["end"]) for hit in content["hits"])
