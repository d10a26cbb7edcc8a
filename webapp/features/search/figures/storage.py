"""What the engines' indexes hold: segments and patterns of each part (Tables 1 and 2 of PCR), time and sizes (3)."""

from __future__ import annotations

from collections.abc import Mapping

from dash.development.base_component import Component

from core.retrieval.storage import Storage
from webapp.features.search.figures.agreement import table

Indexes = Mapping[str, Storage | None]
"""Engine -> figures of its index, None where it has not been built."""

_SIZES = ("library", "lists", "maps", "frames")
NOTHING = "–"


def nodes_tables(indexes: Indexes, engines: Mapping[str, str]) -> list[Component]:
    """For each engine with patterns a table with a row for each part. engines: name -> its everyday name."""
    head = ["Part", "Level", "Frames of a segment", "Seconds", "Segments", "Patterns"]
    return [
        table(
            f"{engines.get(name, name)}: segments and patterns of each part",
            head,
            [
                [
                    row.node.replace("_", " ").capitalize(),
                    str(row.level),
                    f"{row.mean_frames:.1f} ± {row.deviation:.1f}",
                    f"{row.mean_frames / index.fps:.2f}",
                    f"{row.segments:,}",
                    f"{row.patterns:,}",
                ]
                for row in index.nodes
            ],
        )
        for name, index in indexes.items()
        if index is not None and index.nodes
    ]


def storage_table(indexes: Indexes, engines: Mapping[str, str]) -> Component:
    """Time and sizes, a row for each engine."""
    head = ["Engine", "Clips", "Built in", "Pattern library", "Index lists", "Dissimilarity maps", "Postures", "Query"]
    rows = [[engines.get(name, name), *_cells(index)] for name, index in indexes.items()]
    return table("Time and sizes of the indexes", head, rows)


def _cells(index: Storage | None) -> list[str]:
    if index is None:
        return ["not built", *([NOTHING] * (2 + len(_SIZES)))]
    sizes = [size(getattr(index, name)) if getattr(index, name) else NOTHING for name in _SIZES]
    query = NOTHING if index.query is None else f"{index.query * 1e3:.0f} ms"
    return [f"{index.clips:,}", f"{index.seconds:.1f} s", *sizes, query]


def size(count: int) -> str:
    """Bytes as people read them, such as ``1.4 MB``."""
    return f"{count / 1e6:.1f} MB" if count >= 1e6 else f"{count / 1e3:.1f} kB"
