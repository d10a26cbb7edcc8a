"""What the paper's engine makes of recordings: its Tables 1 to 3.

usage: python -m benchmarks patterns
"""

from __future__ import annotations

import time

from benchmarks.bench_retrieval import recordings
from core.mocap.dataset import Dataset
from core.retrieval.queries import whole_query
from core.retrieval.search import ENGINES, SearchParameters, build_search_index
from core.retrieval.storage import Storage, storage_of

QUERIES = 10


def measured(dataset: Dataset, method: str) -> tuple[Storage, float]:
    """What the index of an engine holds, and seconds of processor time for a query, the first one aside."""
    index = build_search_index(dataset, SearchParameters(method=method))
    queries = [whole_query(clip) for clip in dataset.clips[:: max(1, len(dataset.clips) // QUERIES)]]
    index.search(queries[0])
    started = time.process_time()
    for query in queries:
        index.search(query)
    return storage_of(index), (time.process_time() - started) / len(queries)


def segments(printed: Storage, parts: Storage) -> list[str]:
    """Rows of Tables 1 and 2, a node each."""
    return [
        f"| {a.node.replace('_', ' ')} | {a.level} | {a.mean_frames:.1f} ± {a.deviation:.1f} "
        f"| {b.mean_frames:.1f} ± {b.deviation:.1f} | {a.segments} | {b.segments} | {a.patterns} | {b.patterns} |"
        for a, b in zip(printed.nodes, parts.nodes, strict=True)
    ]


def sizes(found: dict[str, tuple[Storage, float]]) -> list[str]:
    """Rows of Table 3, an engine each."""
    rows = []
    for method, (storage, seconds) in found.items():
        megabytes = [getattr(storage, name) / 1e6 for name in ("library", "lists", "maps", "frames")]
        words = " | ".join(f"{size:.2f}" for size in megabytes)
        rows.append(f"| `{method}` | {storage.seconds:.1f} | {words} | {1000 * seconds:.0f} |")
    return rows


def main() -> str:
    """The Markdown section, also printed."""
    dataset, source = recordings()
    found = {method: measured(dataset, method) for method in ENGINES}
    text = "\n".join(
        [
            "## Search: segments and patterns",
            "",
            f"The paper's Tables 1 and 2 ({source}): frames of a segment at 30 a second (mean and standard deviation), "
            "segments and patterns of the engines `printed` and `parts`. `python -m benchmarks patterns`",
            "",
            "| node | level | frames: `printed` | `parts` | segments: `printed` | `parts` | patterns: "
            "`printed` | `parts` |",
            "|---|---|---|---|---|---|---|---|",
            *segments(found["printed"][0], found["parts"][0]),
            "",
            "Table 3: seconds of building the index, megabytes of pattern library, pattern index lists, dissimilarity "
            "maps and postures, and milliseconds of processor time for a query of a whole clip.",
            "",
            "| engine | built in | library | lists | maps | postures | query |",
            "|---|---|---|---|---|---|---|",
            *sizes(found),
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
