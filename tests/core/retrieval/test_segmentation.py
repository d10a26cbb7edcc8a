"""Cuts against a plain reading of Barbic et al. 2004; normalised segments against scipy's spline."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.interpolate import CubicSpline

from core.retrieval.segmentation import (
    AHEAD,
    ENERGY,
    FLOOR,
    SHORTEST,
    WINDOW,
    at_rate,
    cuts_at,
    median_surprise,
    normalise_segments,
    ppca_cuts,
)


def surprise(fitted: np.ndarray, ahead: np.ndarray, energy: float) -> float:
    """Mean squared Mahalanobis distance to the probabilistic PCA of some frames, written down with matrices."""
    d = fitted.shape[1]
    variances, axes = np.linalg.eigh(np.cov(fitted.T).reshape(d, d))
    variances, axes = np.maximum(variances[::-1], 0), axes[:, ::-1]
    share = np.cumsum(variances) / max(variances.sum(), 1e-300)
    kept = int(np.argmax(share >= energy - 1e-12)) + 1 if variances.sum() > 0 else 0
    rest = max(variances[kept:].mean(), FLOOR) if kept < d else FLOOR
    model = axes @ np.diag([max(v, rest) if k < kept else rest for k, v in enumerate(variances)]) @ axes.T
    apart = ahead - fitted.mean(0)
    return float(np.einsum("fi,ij,fj->f", apart, np.linalg.inv(model), apart).mean())


def oracle(x: np.ndarray, threshold: float, window=WINDOW, ahead=AHEAD, shortest=SHORTEST) -> list[int]:
    """The cuts by a loop over all sizes of the model."""
    cuts, start = [0], 0
    while True:
        sizes = range(window, len(x) - start - ahead + 1)
        values = [surprise(x[start : start + k], x[start + k : start + k + ahead], ENERGY) for k in sizes]
        cut = None
        for k in range(len(values)):
            rises = values[k] - min(values[: k + 1]) > threshold
            if rises:
                top = k
                while top + 1 < len(values) and values[top + 1] > values[top]:
                    top += 1
                cut = start + sizes[top] if top + 1 < len(values) else None
                break
        if cut is None or len(x) - max(cut, start + shortest) < shortest:
            return [*cuts, len(x)]
        start = max(cut, start + shortest)
        cuts.append(start)


@settings(max_examples=20)
@given(st.integers(0, 10_000), st.integers(1, 50), st.integers(1, 4), st.sampled_from([0.05, 0.1, 1.0, 15.0]))
def test_cuts_agree_with_a_plain_loop(seed, n, d, threshold):
    rng = np.random.default_rng(seed)
    x = np.cumsum(rng.normal(size=(n, d)) * rng.uniform(0.01, 0.2), axis=0)
    assert ppca_cuts(x, threshold).tolist() == oracle(x, threshold)
    assert ppca_cuts(x, threshold, window=5, ahead=4).tolist() == oracle(x, threshold, window=5, ahead=4)


def test_a_change_of_behaviour_is_a_cut():
    t = np.arange(60) / 30
    swing = np.column_stack([0.5 * np.sin(6 * t), 0.02 * np.cos(6 * t)])
    other = np.column_stack([0.02 * np.sin(6 * t), 0.5 * np.cos(9 * t)])
    cuts = ppca_cuts(np.concatenate([swing, other]), 15.0, window=20, ahead=10)
    assert np.abs(cuts - 60).min() <= 5


@given(st.integers(1, 40), st.integers(0, 100))
def test_cuts_cover_the_clip_and_no_segment_is_too_short(n, seed):
    cuts = ppca_cuts(np.random.default_rng(seed).normal(size=(n, 3)), 0.05)
    assert cuts[0] == 0 and cuts[-1] == n and (np.diff(cuts) >= min(3, n)).all()


@settings(max_examples=10)
@given(st.integers(0, 10_000), st.lists(st.integers(1, 40), min_size=1, max_size=3), st.integers(1, 3))
def test_the_unit_of_r_is_the_median_of_plain_measures(seed, lengths, step):
    rng = np.random.default_rng(seed)
    tracks = [np.cumsum(rng.normal(size=(n, 2)) * 0.1, axis=0) for n in lengths]
    plain = [
        surprise(x[k : k + WINDOW], x[k + WINDOW : k + WINDOW + AHEAD], ENERGY)
        for x in tracks
        for k in range(0, len(x) - WINDOW - AHEAD + 1, step)
    ]
    assert median_surprise(tracks, 30.0, step) == pytest.approx(max(np.median(plain), 1.0) if plain else 1.0)


def motion(fps: float, seconds: float = 40.0) -> np.ndarray:
    """The same smooth motion looked at at any rate."""
    t = np.arange(round(seconds * fps)) / fps
    rng = np.random.default_rng(3)
    waves = [
        np.sin(2 * np.pi * rng.uniform(0.2, 1.5) * t + rng.uniform(0, 6))
        * np.sin(2 * np.pi * rng.uniform(0.05, 0.3) * t)
        for _ in range(3)
    ]
    return np.column_stack(waves) * 0.5


@pytest.mark.parametrize("fps", [15.0, 24.0, 60.0, 120.0])
def test_segments_last_equally_long_at_all_rates(fps):
    unit = median_surprise([motion(30.0)], 30.0)
    expected = np.diff(cuts_at(motion(30.0), 30.0, 0.5 * unit)).mean() / 30
    found = np.diff(cuts_at(motion(fps), fps, 0.5 * median_surprise([motion(fps)], fps))).mean() / fps
    assert found == pytest.approx(expected, rel=0.05 if fps > 30 else 0.3)


@given(st.integers(1, 60), st.sampled_from([5.0, 24.0, 30.0, 60.0, 240.0]))
def test_cuts_at_any_rate_cover_the_clip(n, fps):
    cuts = cuts_at(np.random.default_rng(n).normal(size=(n, 2)), fps, 0.1)
    assert cuts[0] == 0 and cuts[-1] == n and (np.diff(cuts) > 0).all()


@given(st.integers(2, 30), st.floats(5, 240))
def test_another_rate_runs_along_the_same_line(n, fps):
    line = np.arange(n)[:, None] / fps * [[1.0, -2.0]]
    found = at_rate(line, fps)
    np.testing.assert_allclose(found, np.arange(len(found))[:, None] / 30 * [[1.0, -2.0]], atol=1e-9)
    assert len(found) / 30 > line[-1, 0]


def test_stillness_is_one_segment():
    assert ppca_cuts(np.zeros((50, 3)), 0.05).tolist() == [0, 50]


def test_what_cannot_be_cut_is_refused():
    with pytest.raises(ValueError, match="no frames"):
        ppca_cuts(np.zeros((0, 3)), 0.1)
    with pytest.raises(ValueError, match="threshold"):
        ppca_cuts(np.zeros((9, 3)), -1)


@given(st.lists(st.integers(1, 12), min_size=1, max_size=6), st.integers(1, 12), st.integers(0, 99))
def test_segments_are_the_spline_through_their_frames(lengths, length, seed):
    ends = np.cumsum(lengths)
    x = np.random.default_rng(seed).normal(size=(ends[-1], 2)).astype(np.float32)
    found = normalise_segments(x, ends - lengths, ends, length)
    for k, (frames, end) in enumerate(zip(lengths, ends, strict=True)):
        own = x[end - frames : end].astype(float)
        at = np.linspace(0, frames - 1, length) if length > 1 else np.array([(frames - 1) / 2])
        expected = CubicSpline(np.arange(frames), own)(at) if frames > 1 else np.repeat(own, length, axis=0)
        np.testing.assert_allclose(found[k], expected, atol=1e-4)


def test_an_empty_segment_is_refused():
    with pytest.raises(ValueError, match="at least one frame"):
        normalise_segments(np.zeros((5, 2)), np.array([2]), np.array([2]), 4)
