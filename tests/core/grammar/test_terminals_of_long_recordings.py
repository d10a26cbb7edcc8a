"""The search for terminals of long recordings begins in a sample of them."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from core.demo import make_demo
from core.grammar import identification
from core.grammar.identification import find_terminals
from core.grammar.parameters import TerminalParameters
from core.grammar.pose_space import PoseSpace, pose_space

QUICK = TerminalParameters(n_terminals=6, starts=3, crossings=4)


@cache
def space() -> PoseSpace:
    return pose_space(make_demo(minutes=3), analysis_fps=6)


def test_a_sample_is_of_whole_pieces_and_knows_where_they_come_from():
    part, rows = space().sampled(400, 60, np.random.default_rng(0))
    assert 400 <= part.n < 460
    assert np.all(np.diff(rows) > 0)
    np.testing.assert_array_equal(part.values, space().values[rows])
    for start, end, name in zip(part.clip_starts[:-1], part.clip_starts[1:], part.clips, strict=True):
        assert 0 < end - start <= 60
        np.testing.assert_array_equal(np.diff(rows[start:end]), 1)
        clip = np.searchsorted(space().clip_starts, rows[[start, end - 1]], side="right") - 1
        assert [space().clips[k] for k in clip] == [name, name]


def test_recordings_no_longer_than_the_sample_are_searched_whole():
    part, rows = space().sampled(space().n, 60, np.random.default_rng(0))
    assert part is space()
    np.testing.assert_array_equal(rows, np.arange(space().n))


def test_terminals_found_from_a_sample_are_nearly_as_good(monkeypatch):
    demo = make_demo(minutes=4)
    whole = find_terminals(demo, QUICK).objective["F"]
    monkeypatch.setattr(identification, "_SEARCHED_SECONDS", 90)
    monkeypatch.setattr(identification, "_PIECE_SECONDS", 20)
    sampled = find_terminals(demo, QUICK)
    assert sampled.objective["F"] > 0.8 * whole
    assert find_terminals(demo, QUICK).to_json()["terminals"] == sampled.to_json()["terminals"]
    covered = sum(s.n_frames for segments in sampled.segments for s in segments)
    assert covered == demo.n_frames


def test_the_search_looks_at_no_more_of_longer_recordings(monkeypatch):
    """Turns of the search on all poses are few; what is cut again and again is the sample."""
    monkeypatch.setattr(identification, "_SEARCHED_SECONDS", 60)
    sizes: list[int] = []
    cut = identification.cut_by_medoids
    monkeypatch.setattr(
        identification,
        "cut_by_medoids",
        lambda space, *rest, **more: sizes.append(space.n) or cut(space, *rest, **more),
    )
    find_terminals(make_demo(minutes=4), QUICK)
    assert sum(size > 0.9 * max(sizes) for size in sizes) == 1
    assert sorted(sizes)[-2] < 0.4 * max(sizes)


@pytest.mark.parametrize("n", [40, 60])
def test_many_terminals_get_a_sample_large_enough_for_them(monkeypatch, n):
    monkeypatch.setattr(identification, "_SEARCHED_SECONDS", 5)
    found = find_terminals(make_demo(minutes=4), TerminalParameters(n_terminals=n, starts=1, crossings=0))
    assert found.n_terminals == n
