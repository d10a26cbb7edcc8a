"""Dynamic time warping against the textbook recursion."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.sequences.warping import registration, warp_path


def naive_cost(a: np.ndarray, b: np.ndarray) -> float:
    @lru_cache(None)
    def best(i: int, j: int) -> float:
        here = float(np.linalg.norm(a[i] - b[j]))
        if i == j == 0:
            return here
        before = [(i - 1, j - 1), (i - 1, j), (i, j - 1)]
        return here + min(best(p, q) for p, q in before if p >= 0 and q >= 0)

    return best(len(a) - 1, len(b) - 1)


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10**6), n=st.integers(1, 12), m=st.integers(1, 12), band=st.sampled_from([None, 1.0]))
def test_cost_is_the_least_and_the_path_is_a_path(seed, n, m, band):
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=(n, 3)).astype(np.float32), rng.normal(size=(m, 3)).astype(np.float32)
    path = warp_path(a, b, band)
    assert path[0].tolist() == [0, 0] and path[-1].tolist() == [n - 1, m - 1]
    assert {tuple(step) for step in np.diff(path, axis=0).tolist()} <= {(1, 1), (1, 0), (0, 1)}
    assert np.linalg.norm(a[path[:, 0]] - b[path[:, 1]], axis=1).sum() == pytest.approx(naive_cost(a, b), rel=1e-5)


@settings(max_examples=60, deadline=None)
@given(n=st.integers(1, 40), m=st.integers(1, 40), band=st.sampled_from([0.0, 0.05, 0.3]))
def test_a_narrow_band_still_has_a_path_that_keeps_to_it(n, m, band):
    rng = np.random.default_rng(n * 41 + m)
    path = warp_path(rng.normal(size=(n, 2)), rng.normal(size=(m, 2)), band)
    off = np.abs(path[:, 0] * (m - 1) / max(n - 1, 1) - path[:, 1])
    assert off.max() <= max(band * max(n, m), 1, m / n) + 1e-9 or n == 1
    assert path[-1].tolist() == [n - 1, m - 1]


def test_registration_finds_a_known_slowing():
    time = np.linspace(0, 1, 60)
    a = np.column_stack([np.sin(6 * time), np.cos(5 * time)])
    b = np.column_stack([np.sin(6 * time**1.5), np.cos(5 * time**1.5)])
    partner = registration(warp_path(a, b), len(a))
    assert (np.diff(partner) >= 0).all()
    assert np.abs((partner / 59) ** 1.5 - time).max() < 0.03


@pytest.mark.parametrize("a, b, band", [((0, 2), (3, 2), None), ((3, 2), (3, 1), None), ((3, 2), (3, 2), 1.5)])
def test_what_cannot_be_aligned_is_refused(a, b, band):
    with pytest.raises(ValueError):
        warp_path(np.zeros(a), np.zeros(b), band)
