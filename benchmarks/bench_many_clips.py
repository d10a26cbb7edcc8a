"""The app with many clips: processor time of what the server does for the Library and for a search.

usage: python -m benchmarks many_clips

Datasets of 10 000 and of 150 000 clips of two thirds of a second, cut from the demo, are made once and kept in the
folder that ``MOTIONSCAPE_SCALE`` names (build/scale).
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import replace
from itertools import cycle
from typing import Any

from benchmarks.scale_runs import FOLDER
from core.demo import make_demo
from core.mocap.clip import Label
from core.mocap.dataset import Dataset, FileReport, ImportReport
from core.mocap.reports import Finding
from core.mocap.storage import load_dataset, writing_dataset
from core.retrieval.queries import whole_query
from core.retrieval.search import build_search_index
from webapp.features.library.figures.tables import ClipRows, report_table

SIZES = (10_000, 150_000)
SEARCHED = 10_000  # clips at most that an index is built of here
FRAMES = 40


def many(n: int) -> Dataset:
    """A dataset of ``n`` short clips, every third labelled, every fiftieth with a doubt."""
    folder = FOLDER / f"many-{n}"
    if not (folder / "dataset.json").exists():
        recordings = make_demo(6).clips
        pieces = cycle(
            [clip.cut(a, a + FRAMES) for clip in recordings for a in range(0, clip.n_frames - FRAMES, FRAMES)]
        )
        files, labels = [], []
        with writing_dataset(folder, f"many-{n}") as writer:
            for k, piece in zip(range(n), pieces, strict=False):
                name = f"take_{k:06d}"
                found = (Finding("jump", "hips jumps by 0.3 m", 3, 5),) if k % 50 == 0 else ()
                writer.add(replace(piece, name=name, findings=found), digest=f"{k:032x}")
                labels += [Label(name, 0, FRAMES, ("walk", "run", "kick", "wave")[k % 4])] if k % 3 == 0 else []
                words = tuple(finding.message for finding in found)
                files.append(FileReport(f"{name}.bvh", name, "warning" if found else "ok", words, findings=found))
            writer.labels, writer.report = labels, ImportReport(tuple(files))
    return load_dataset(folder)


def milliseconds(work: Callable[[], Any], times: int = 1) -> tuple[float, Any]:
    """Processor time of ``work``, the least of several times, and what it gives."""
    taken, made = [], None
    for _ in range(times):
        started = time.process_time()
        made = work()
        taken.append(1000 * (time.process_time() - started))
    return min(taken), made


def library(n: int) -> list[float]:
    """Milliseconds of each thing the Library does."""
    dataset = many(n)
    opened, _ = milliseconds(lambda: load_dataset(FOLDER / f"many-{n}"))
    made, table = milliseconds(lambda: ClipRows(dataset).long_table())

    def block(**more: Any) -> float:
        return milliseconds(lambda: table.block({"startRow": n // 2, "endRow": n // 2 + 100, **more}))[0]

    scrolled = (block(), block())[1]
    by_name = [{"colId": "clip", "sort": "desc"}]
    first, again = block(sortModel=by_name), block(sortModel=[{"colId": "clip", "sort": "asc"}])
    block(filterModel={"clip": {"filterType": "text", "type": "contains", "filter": "0012"}})
    filtered = block(filterModel={"clip": {"filterType": "text", "type": "contains", "filter": "0013"}})
    report, _ = milliseconds(lambda: report_table(dataset.report.files).first())
    return [opened, made, scrolled, first, again, filtered, report]


def search() -> dict[str, float]:
    """Milliseconds until the hits of a clip are there, by level; the first search of an index is not counted."""
    dataset = many(SEARCHED)
    index = build_search_index(dataset)
    taken = {}
    for level in ("clip", "interval"):
        queries = [whole_query(clip, 0, FRAMES) for clip in dataset.clips[100:104]]
        index.search(queries[0], level=level)
        taken[level] = max(
            milliseconds(lambda query=query, level=level: index.search(query, level=level))[0] for query in queries[1:]
        )
    return taken


def main() -> str:
    """The Markdown section, also printed."""
    rows = (
        "opening the dataset, once for a server",
        "making its table, once",
        "a block of 100 rows",
        "sorting by name, first time",
    )
    rows += ("sorting again", "filtering by name", "import report, first block")
    columns = [library(n) for n in SIZES]
    found = search()
    text = "\n".join(
        [
            "## Many clips",
            "",
            "Processor milliseconds of the server. Clips have two thirds of a second. Tables of more than "
            "2,000 clips stay "
            "on the server, which sends what is seen. `python -m benchmarks many_clips`",
            "",
            f"| Library | {' | '.join(f'{n:,} clips' for n in SIZES)} |",
            "|---|---|---|",
            *(
                f"| {row} | {' | '.join(f'{value:.0f}' for value in values)} |"
                for row, *values in zip(rows, *columns, strict=True)
            ),
            "",
            f"A search among {SEARCHED:,} clips takes {found['clip']:.0f} ms for whole clips and "
            f"{found['interval']:.0f} ms for moments of clips (the slowest of three; the first one "
            "after the start takes seconds).",
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
