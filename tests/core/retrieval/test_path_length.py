"""Reading motions at equal steps of their way, against a plain version."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.retrieval.path_length import STILL, at_shares, path_lengths, sample_all


def naive(values: np.ndarray, way: int, n_samples: int) -> np.ndarray:
    lengths = [0.0]
    for a, b in itertools.pairwise(values):
        lengths.append(lengths[-1] + np.linalg.norm(b[:way] - a[:way]) + STILL)
    aims = np.linspace(0, lengths[-1], n_samples)
    return np.column_stack([np.interp(aims, lengths, column) for column in values.T])


@given(st.integers(1, 12), st.integers(2, 9), st.integers(0, 2**31))
def test_samples_are_those_of_the_plain_version(n, n_samples, seed):
    rng = np.random.default_rng(seed)
    codes = rng.integers(-127, 128, (n + 3, 6)).astype(np.int8)
    columns, scales, groups = np.array([0, 2, 3, 5]), np.array([0.5, 1.0, 0.1, 0.3]), np.array([0, 0, 1, -1])
    found = sample_all(codes, columns, scales, groups, np.array([2]), np.array([2 + n]), n_samples)
    values = codes[2 : 2 + n, columns] * scales
    np.testing.assert_allclose(found.values[0], naive(values, 3, n_samples), atol=0.02)
    np.testing.assert_allclose(found.means[0], values.mean(0), atol=1e-3)
    steps = np.abs(np.diff(values, axis=0))
    ways = [np.linalg.norm(steps[:, :2], axis=1), steps[:, 2]] if n > 1 else [np.zeros(1)] * 2
    np.testing.assert_allclose(found.steps[0], [way.mean() for way in ways], rtol=1e-3, atol=1e-4)


def test_a_slow_and_a_fast_performance_have_the_same_samples():
    codes = np.round(100 * np.sin(np.linspace(0, 3, 61)))[:, None].astype(np.int8)
    slow = np.repeat(codes, 3, axis=0)
    read = [
        sample_all(c, np.array([0]), np.ones(1), np.zeros(1, int), np.array([0]), np.array([len(c)]), 16).values
        for c in (codes, slow)
    ]
    np.testing.assert_allclose(*read, atol=1.0)


def test_standing_still_is_read_at_equal_steps_of_time():
    lengths = path_lengths(np.zeros((5, 2)))
    np.testing.assert_allclose(lengths, np.arange(5) * STILL)
    track = np.arange(5.0)[:, None]
    np.testing.assert_allclose(at_shares(track, lengths, np.array([0, 0.5, 1])), [[0], [2], [4]], atol=1e-5)


@pytest.mark.parametrize(("start", "end"), [(0, 0), (-1, 3), (2, 99)])
def test_a_stretch_that_is_not_there_is_refused(start, end):
    codes = np.zeros((4, 1), np.int8)
    with pytest.raises(ValueError, match="stretch"):
        sample_all(codes, np.array([0]), np.ones(1), np.zeros(1, int), np.array([start]), np.array([end]), 4)
