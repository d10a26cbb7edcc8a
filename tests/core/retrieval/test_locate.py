"""Stretches: warping against a plain dynamic programme, and cuts that are found again."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.demo import make_demo
from core.mocap import quaternions as quat
from core.mocap.kinematics import resample
from core.retrieval.locate import warped_stretch
from core.retrieval.queries import whole_query
from core.retrieval.search import build_search_index


def naive_cost(query: np.ndarray, frames: np.ndarray, cap: float, start: int, end: int) -> float:
    """Cost of warping all of the query onto frames [start, end), from first to first and last to last."""
    n, m = len(query), end - start
    table = np.full((n, m), np.inf)
    for i, j in itertools.product(range(n), range(m)):
        before = [table[a, b] for a, b in ((i - 1, j - 1), (i - 1, j), (i, j - 1)) if a >= 0 and b >= 0]
        here = min(1.0, float(np.linalg.norm(query[i] - frames[start + j])) / cap)
        table[i, j] = here + (min(before) if before else 0.0)
    return table[-1, -1]


@given(st.integers(1, 5), st.integers(1, 8), st.integers(0, 2**31))
def test_warping_finds_the_cheapest_stretch(n, m, seed):
    rng = np.random.default_rng(seed)
    query, frames = rng.normal(size=(n, 2)), rng.normal(size=(m, 2))
    start, end, cost = warped_stretch(query, frames, 1.7)
    best = min(naive_cost(query, frames, 1.7, a, b) for a in range(m) for b in range(a + 1, m + 1))
    assert cost == pytest.approx(best, abs=1e-5)
    assert naive_cost(query, frames, 1.7, start, end) == pytest.approx(best, abs=1e-5)


def test_what_cannot_be_looked_for_is_refused():
    with pytest.raises(ValueError, match="cannot look"):
        warped_stretch(np.zeros((0, 2)), np.zeros((3, 2)), 1.0)
    with pytest.raises(ValueError, match="cannot look"):
        warped_stretch(np.zeros((2, 2)), np.zeros((3, 3)), 1.0)


def test_noised_and_retimed_cuts_are_found_where_they_were():
    demo = make_demo(minutes=2, seed=2)
    index, rng = build_search_index(demo), np.random.default_rng(0)
    right = 0
    for _ in range(24):
        clip = demo.clips[rng.integers(len(demo.clips))]
        n = int(rng.uniform(1, 3) * clip.fps)
        start = int(rng.integers(0, clip.n_frames - n))
        slower = resample(clip.cut(start, start + n), clip.fps * rng.uniform(0.8, 1.25))
        noise = quat.from_rotvec(rng.normal(size=(*slower.rotations.shape[:2], 3)) * np.radians(1.0))
        rotations = quat.multiply(slower.rotations, noise).astype(np.float32)
        asked = replace(slower, name="asked", fps=clip.fps, rotations=rotations)
        hit = index.search(whole_query(asked), level="interval", top=3)[0].segment
        shared = min(hit.end, start + n) - max(hit.start, start)
        right += hit.clip == clip.name and shared >= 0.5 * (hit.n_frames + n - shared)
    assert right >= 22


def test_hits_hardly_overlap_and_lie_within_their_clips():
    demo = make_demo(minutes=1)
    found = build_search_index(demo).search(whole_query(demo.clips[0], 30, 90), level="interval", top=40)
    frames = {clip.name: clip.n_frames for clip in demo.clips}
    assert all(0 <= hit.segment.start < hit.segment.end <= frames[hit.segment.clip] for hit in found)
    for a, b in itertools.combinations([hit.segment for hit in found], 2):
        shared = min(a.end, b.end) - max(a.start, b.start)
        assert a.clip != b.clip or shared <= 0.5 * min(a.n_frames, b.n_frames) + 4


def test_standing_still_gives_stretches_and_no_single_frames():
    demo = make_demo(minutes=1)
    still = next(label for label in demo.labels if label.action == "idle")
    query = whole_query(demo.clip(still.clip), still.start, min(still.end, still.start + 60))
    n = query.parts[0].end - query.parts[0].start
    hits = build_search_index(demo).search(query, level="interval")
    assert hits and all(hit.segment.n_frames >= 0.4 * n for hit in hits)


def test_a_clip_shorter_than_the_query_says_which_part_it_is_like():
    demo = make_demo(minutes=0.5)
    clip = demo.clips[0]
    short = replace(clip.cut(300, 380), name="short")
    index = build_search_index(replace(demo, clips=(short,), digests=()))
    hit = index.search(whole_query(clip, 200, 500), level="interval")[0]
    assert hit.segment.clip == "short" and hit.query_segment is not None
    assert abs(hit.query_segment.start - 300) < 20 and abs(hit.query_segment.end - 380) < 20
