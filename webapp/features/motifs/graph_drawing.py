"""The motif graph as Cytoscape draws it, kept by result: placing the boxes and drawing the icons is the slow part."""

from __future__ import annotations

import threading
from typing import Any

from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from webapp.features.motifs.figures import graph as graph_figure
from webapp.ui.filmstrip import icon_data_uri


def graph_elements(dataset: Dataset, key: str, graph: MotifGraph) -> list[dict[str, Any]]:
    """Cytoscape elements, placed and drawn once a result: the layout and the icons are the slow part of showing it."""
    with _lock:
        if key not in _drawn:
            icons = graph_figure.icon_addresses(graph, lambda segment, scheme: icon_data_uri(dataset, segment, scheme))
            _drawn[key] = graph_figure.graph_elements(graph, icons)
            while len(_drawn) > _KEPT_DRAWINGS:
                _drawn.pop(next(iter(_drawn)))
        return _drawn[key]


_drawn: dict[str, list[dict[str, Any]]] = {}  # by the result's key: the same key always stands for the same drawing
_lock = threading.Lock()
_KEPT_DRAWINGS = 16
