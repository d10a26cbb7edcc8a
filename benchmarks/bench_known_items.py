"""Known items: is a stretch of a long recording, retimed and noised, the first that a search for stretches finds?

usage: python -m benchmarks known_items
"""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from benchmarks.recordings import all_recordings
from core.editing.noise import shake_joints
from core.mocap.clip import Clip, Segment
from core.mocap.dataset import Dataset
from core.mocap.kinematics import resample
from core.retrieval.queries import whole_query
from core.retrieval.search import SearchParameters, build_search_index

METHODS = ("bounded-edit", "parts")
ITEMS, FIRST = 200, 20
DEGREES, BAND = 1.0, (0.0, 30.0)  # noise on all joint angles: standard deviation, Hz
FACTORS, SECONDS = (0.8, 1.25), (1.0, 3.0)


def items(dataset: Dataset, n: int, seed: int = 0) -> list[tuple[Clip, Segment]]:
    """Queries and where each was taken from: retimed and noised cuts, from clips by their length."""
    rng = np.random.default_rng(seed)
    clips = [clip for clip in dataset.clips if clip.seconds > 10]
    shares = np.array([clip.seconds for clip in clips])
    found = []
    for k in rng.choice(len(clips), size=n, p=shares / shares.sum()):
        clip, length = clips[k], round(rng.uniform(*SECONDS) * clips[k].fps)
        start = int(rng.integers(clip.n_frames - length))
        cut = clip.cut(start, start + length, "query")
        retimed = resample(replace(cut, fps=cut.fps * rng.uniform(*FACTORS)), cut.fps)
        found.append((shake_joints(retimed, DEGREES, BAND, rng), Segment(clip.name, start, start + length)))
    return found


def overlap(a: Segment, b: Segment) -> float:
    """Frames in both as a share of those in either."""
    shared = max(0, min(a.end, b.end) - max(a.start, b.start)) if a.clip == b.clip else 0
    return shared / (a.n_frames + b.n_frames - shared)


def row(method: str, dataset: Dataset, wanted: list[tuple[Clip, Segment]]) -> str:
    """A row of the table."""
    started = time.process_time()
    index = build_search_index(dataset, SearchParameters(method=method))
    index.search(whole_query(wanted[0][0]), level="interval")
    built = time.process_time() - started
    started, first, among = time.process_time(), [], []
    for query, place in wanted:
        shares = [overlap(hit.segment, place) for hit in index.search(whole_query(query), level="interval", top=FIRST)]
        first.append(shares[0])
        among.append(max(shares))
    each = (time.process_time() - started) / len(wanted) * 1e3
    first, here, among = np.array(first), np.array(first) >= 0.5, np.array(among) >= 0.5
    figures = f"{here.mean():.3f} | {first[here].mean() if here.any() else 0:.2f} | {among.mean():.3f}"
    return f"| `{method}` | {figures} | {built:.0f} | {each:.0f} |"


def main() -> str:
    """The Markdown section, also printed."""
    dataset, source = all_recordings()
    wanted = items(dataset, ITEMS)
    text = "\n".join(
        [
            "## Search: known items",
            "",
            f"{ITEMS} cuts of 1 to 3 s out of {len(dataset.clips)} clips, {dataset.seconds / 60:.0f} minutes "
            f"({source}), {FACTORS[0]} to {FACTORS[1]} times as fast, with {DEGREES:g} degree of noise on every joint "
            "angle. Found: overlap (IoU) of at least half. CPU seconds and milliseconds. "
            "`python -m benchmarks known_items`",
            "",
            f"| | first | its mean IoU | among the first {FIRST} | index, s | query, ms |",
            "|---|---|---|---|---|---|",
            *(row(method, dataset, wanted) for method in METHODS),
        ]
    )
    print(text)
    return text


if __name__ == "__main__":
    main()
