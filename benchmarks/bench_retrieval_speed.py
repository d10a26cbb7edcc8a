"""Searching: how long a query takes at 1.77 million frames, what an index takes, and how long it takes to make.

usage: python -m benchmarks retrieval_speed, or python -m benchmarks.bench_retrieval_speed MILLIONS for another number
of frames (1.77 million is the largest set of the 2009 paper)
"""

from __future__ import annotations

import json
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from core.demo import make_demo, write_demo
from core.demo.routines import routines
from core.mocap.clip import Clip
from core.mocap.dataset import open_dataset
from core.progress import silent
from core.retrieval.bounded_edit import BoundedEdit
from core.retrieval.frames import FrameStore
from core.retrieval.queries import whole_query
from core.retrieval.search import SearchIndex, SearchParameters, build_search_index

MILLIONS = 1.77
QUERIES = 60
LEFT_ARM = {"left_arm_hand": 1.0}


def large_index(frames: int) -> tuple[SearchIndex, list[Clip]]:
    """An index of at least so many made-up frames at 60 a second, added to clip by clip, and some of the clips."""
    store, some, waiting, total = None, [], [], 0
    for clip, _ in routines(frames / 3600, 7):
        total += clip.n_frames
        waiting.append(replace(clip, name=f"{clip.name}_{total}"))
        if len(some) < 40:
            some.append(waiting[-1])
        if len(waiting) == 50:
            store = FrameStore.build(waiting, 30.0, silent) if store is None else store.add(waiting, silent)
            waiting = []
        if total >= frames:
            break
    if waiting:
        store = FrameStore.build(waiting, 30.0, silent) if store is None else store.add(waiting, silent)
    return SearchIndex(BoundedEdit(store), SearchParameters()), some


def short_clips(index: SearchIndex, seconds: float) -> SearchIndex:
    """The same frames as many short clips."""
    store = index.engine.store
    n = round(seconds * store.fps)
    starts = np.unique(
        np.concatenate([np.arange(a, b, n) for a, b in zip(store.starts, store.starts[1:], strict=False)])
    )
    ends = np.append(starts[1:], store.starts[-1])
    owner = np.searchsorted(store.starts, starts, side="right") - 1
    clips = tuple(
        replaced._replace(name=f"{replaced.name}_{k}", frames=int((ends[k] - starts[k]) * replaced.fps / store.fps))
        for k, replaced in enumerate(store.clips[o] for o in owner)
    )
    cut = replace(store, clips=clips, starts=np.append(starts, store.starts[-1]), has=store.has[owner])
    return replace(index, engine=BoundedEdit(cut))


def stretches(clips: list[Clip], rng: np.random.Generator, low: float, high: float) -> Iterator:
    """Queries of ``low`` to ``high`` seconds from anywhere."""
    for _ in range(QUERIES):
        clip = clips[rng.integers(len(clips))]
        n = min(clip.n_frames, round(rng.uniform(low, high) * clip.fps))
        start = int(rng.integers(0, clip.n_frames - n + 1))
        yield whole_query(clip, start, start + n)


def times(ask: Callable, queries: Iterator) -> list[float]:
    """Milliseconds: of the first query, then median and 95th percentile of the others, and the median of CPU time."""
    taken, worked = [], []
    for query in queries:
        wall, cpu = time.perf_counter(), time.process_time()
        ask(query)
        taken.append(1000 * (time.perf_counter() - wall))
        worked.append(1000 * (time.process_time() - cpu))
    return [taken[0], float(np.median(taken[1:])), float(np.percentile(taken[1:], 95)), float(np.median(worked[1:]))]


def latency(millions: float) -> str:
    """The section about queries."""
    index, clips = large_index(round(millions * 1e6))
    rng = np.random.default_rng(0)
    for level in ("clip", "interval"):  # the first of all compiles
        index.search(whole_query(clips[0], 0, 120), level=level)
    lines = []
    cut = short_clips(index, 5.0)
    for name, found in ((f"{len(index.clips)} clips", index), (f"the same as {len(cut.clips)} clips of 5 s", cut)):
        for what, options, seconds in (
            ("clip", {"level": "clip"}, (1, 4)),
            ("clip, 10 s", {"level": "clip"}, (9, 11)),
            ("clip, left arm alone", {"level": "clip", "weights": LEFT_ARM}, (1, 4)),
            ("interval", {"level": "interval"}, (1, 3)),
            ("interval, 10 s", {"level": "interval"}, (9, 11)),
            ("interval, left arm alone", {"level": "interval", "weights": LEFT_ARM}, (1, 3)),
        ):
            row = times(lambda q, o=options, f=found: f.search(q, **o), stretches(clips, rng, *seconds))
            lines.append(f"| {name} | {what} | " + " | ".join(f"{value:.0f}" for value in row) + " |")
    frames = sum(clip.frames for clip in index.clips)
    store = index.engine.store
    document, arrays = index.pack()
    size = (sum(a.nbytes for a in arrays.values()) + len(json.dumps(document))) / 1e6
    kept = sum(m.samples.nbytes for m in index.engine._resampled.values()) / len(index.engine._resampled) / 1e6
    more = sum(m.samples.nbytes for m in cut.engine._resampled.values()) / len(cut.engine._resampled) / 1e6
    return (
        f"{frames / 1e6:.2f} million made-up frames at 60 a second ({len(store.codes) / 1e6:.2f} million analysed, at "
        f"30), engine bounded-edit, milliseconds for each query; "
        f"the first query with other weights prepares all clips again.\n\n"
        "| clips | query | first | median | 95 % | median of CPU time |\n|---|---|---|---|---|---|\n"
        + "\n".join(lines)
        + f"\n\nThe index takes {size:.0f} MB, {size / frames * 1e6:.0f} MB a million frames "
        f"({store.codes.shape[1]} bytes for each analysed frame, so {store.codes.shape[1]:.0f} MB where recordings "
        f"have 30 a "
        f"second). In memory, each of the last three settings of weights keeps {kept:.0f} MB ({more:.0f} MB for the "
        "short clips) of clips prepared for these weights. Most of the time goes into the edit distance for clips, and "
        "for intervals into the distance of every fourth frame to eight of the query."
    )


def preprocessing(minutes: float = 30.0) -> str:
    """The section about reading and indexing."""
    with tempfile.TemporaryDirectory() as folder:
        write_demo(folder, minutes)
        build_search_index(make_demo(minutes=0.5))  # compiles
        started = time.perf_counter(), time.process_time()
        dataset = open_dataset(folder)
        read = time.perf_counter(), time.process_time()
        build_search_index(dataset)
        ended = time.perf_counter(), time.process_time()
    rows = []
    for name, a, b in (("parsing BVH", started, read), ("index", read, ended), ("together", started, ended)):
        scale = 1e6 / dataset.n_frames
        rows.append(f"| {name} | {(b[0] - a[0]) * scale:.0f} | {(b[1] - a[1]) * scale:.0f} |")
    return (
        f"{dataset.n_frames} made-up frames in {len(dataset.clips)} BVH files; seconds a million frames (the paper: "
        "4100 to 4700).\n\n| stage | wall | CPU |\n|---|---|---|\n" + "\n".join(rows)
    )


def main(millions: float = MILLIONS) -> str:
    """All sections as Markdown."""
    parts = {
        "Search: queries and memory": latency(millions),
        "Search: preprocessing": preprocessing(),
    }
    made = "`python -m benchmarks retrieval_speed`"
    return "\n\n".join(f"## {title}\n\n{text}\n\nMade by {made}." for title, text in parts.items()) + "\n"


if __name__ == "__main__":
    print(main(*(float(word) for word in sys.argv[1:2])))
