"""The timeline: copies stay exact, blends last whole frames, whichever motion leads plays at its own speed."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.mocap.clip import Segment
from core.synthesis.timeline import Overlap, crossfade, schedule, smooth_warp
from tests.core.editing.figures import standing


def test_one_piece_is_a_copy() -> None:
    line = schedule([Segment("a", 7, 40)], [60.0], [], 60.0)
    assert np.array_equal(line.frames[:, 0], np.arange(7, 40)) and not line.weights.any() and len(line.seams) == 0


def test_another_rate_keeps_the_duration() -> None:
    line = schedule([Segment("a", 0, 120)], [120.0], [], 30.0)
    assert np.allclose(line.frames[:, 0], np.arange(0, 120, 4))


@given(st.integers(0, 2**32 - 1))
def test_frames_rise_weights_rise_and_copies_are_whole_frames(seed: int) -> None:
    rng = np.random.default_rng(seed)
    n = int(rng.integers(2, 5))
    pieces = [Segment(f"c{k}", 0, 300) for k in range(n)]
    overlaps = []
    for _ in range(n - 1):
        rows = np.sort(rng.integers(0, 60, (int(rng.integers(5, 50)), 2)), axis=0).astype(float)
        rows[-1] = rows[0] + np.maximum(rows[-1] - rows[0], 10)
        overlaps.append(Overlap(rows + np.array([200, 20])))
    rates = [float(rng.choice([30.0, 60.0])) for _ in range(n)]
    line = schedule(pieces, rates, overlaps, 60.0)
    assert len(line.seams) == n - 1
    for k in range(n):
        for side in range(2):
            assert (np.diff(line.frames[line.pieces[:, side] == k, side]) >= -1e-9).all()
    for start, end in line.seams:
        assert (np.diff(line.weights[start:end]) >= 0).all() and line.weights[start] == 0
        assert line.weights[end - 1] < 1
    for k in (k for k, rate in enumerate(rates) if rate == 60):  # copies are whole frames
        own = line.frames[(line.pieces == k).all(1), 0]
        assert np.array_equal(own, np.round(own)) and (np.diff(own) == 1).all()


def test_the_leading_motion_keeps_its_speed_where_the_other_dawdles() -> None:
    slow = np.concatenate([np.full(30, 100.0), np.linspace(100, 130, 30)])  # stands still, then runs
    line = schedule(
        [Segment("a", 0, 400), Segment("b", 0, 400)],
        [60.0, 60.0],
        [Overlap(np.column_stack([np.arange(60.0) + 200, slow]))],
        60.0,
    )
    start, end = line.seams[0]
    speed = np.diff(line.frames[start:end, 0])
    assert np.allclose(speed[:5], 1, atol=0.1)  # the first leads at first
    assert np.allclose(np.diff(line.frames[start:end, 1])[-5:], 1, atol=0.15)  # and the second in the end


def test_pieces_that_do_not_fit_are_refused() -> None:
    rows = np.column_stack([np.arange(200.0, 220), np.arange(20)])
    with pytest.raises(ValueError, match="need 1 overlaps"):
        schedule([Segment("a", 0, 300), Segment("b", 0, 300)], [60.0, 60.0], [], 60.0)
    early = [Overlap(rows + np.array([0, 30])), Overlap(rows - np.array([190, 0]))]
    with pytest.raises(ValueError, match="two blends meet in b"):
        schedule([Segment(c, 0, 300) for c in "abc"], [60.0] * 3, early, 60.0)


def test_a_warp_is_evened_out_and_keeps_its_ends() -> None:
    stairs = np.repeat(np.arange(0, 60, 6.0), 6)
    stairs[-1] = 59
    even = smooth_warp(stairs, 60.0)
    assert even[0] == 0 and even[-1] == 59 and (np.diff(even) >= 0).all()
    assert np.diff(even)[5:-8].max() < 2.0 < np.diff(stairs).max()


def test_a_crossfade_lies_about_its_frames_and_inside_both_clips() -> None:
    a, b = standing(100), standing(100)
    middle = crossfade(a, 50, b, 40, 0.5)
    assert np.allclose(middle.mean(0), [50, 40]) and np.allclose(middle[-1] - middle[0], 30)
    end = crossfade(a, 99, b, 0, 0.5)  # neither recording goes on
    assert np.allclose(end[[0, -1]], [[69, 0], [99, 30]])
    short = crossfade(a, 99, standing(10), 0, 0.5)
    assert short.max(0)[1] <= 9 and short.min() >= 0


def test_a_blend_that_needs_time_slows_down_in_its_middle() -> None:
    rows = np.column_stack([np.arange(200.0, 231), np.arange(20.0, 51)])
    pieces, rates = [Segment("a", 0, 300), Segment("b", 0, 300)], [60.0, 60.0]
    for seconds, length in ((0.2, 30), (1.0, 60), (9.0, 90)):  # at least its natural half second, at most thrice that
        line = schedule(pieces, rates, [Overlap(rows, seconds)], 60.0)
        start, end = line.seams[0]
        assert end - start == length
        speed = np.diff(line.frames[start:end, 0])
        assert (speed >= -1e-9).all() and np.allclose(speed[[0, -1]], 1, atol=0.12)
        assert speed.min() == pytest.approx(1.5 * 30 / length - 0.5, abs=0.1)
