"""The bounded edit distance against the textbook's recursion."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.sequences.edit_distance import bounded_edit_distances


def naive(a: np.ndarray, b: np.ndarray, cap: float, gap: float) -> float:
    @cache
    def cost(i: int, j: int) -> float:
        if i == 0 or j == 0:
            return (i + j) * gap
        replaced = cost(i - 1, j - 1) + min(1.0, float(np.linalg.norm(a[i - 1] - b[j - 1])) / cap)
        return min(replaced, cost(i - 1, j) + gap, cost(i, j - 1) + gap)

    return cost(len(a), len(b)) / max(len(a), len(b))


@given(st.integers(1, 7), st.integers(1, 7), st.integers(0, 2**31), st.floats(0.2, 3), st.floats(0.1, 1))
def test_it_is_the_recursion(n, m, seed, cap, gap):
    rng = np.random.default_rng(seed)
    a, many = rng.normal(size=(n, 3)), rng.normal(size=(4, m, 3))
    found = bounded_edit_distances(a, many, cap, gap)
    np.testing.assert_allclose(found, [naive(a, b, cap, gap) for b in many], atol=1e-5)


def test_a_wide_band_changes_nothing_and_a_narrow_one_only_adds():
    rng = np.random.default_rng(0)
    a, many = rng.normal(size=(12, 3)), rng.normal(size=(20, 12, 3))
    free = bounded_edit_distances(a, many, 1.5, 0.4)
    np.testing.assert_array_equal(free, bounded_edit_distances(a, many, 1.5, 0.4, band=12))
    assert (bounded_edit_distances(a, many, 1.5, 0.4, band=2) >= free - 1e-6).all()
    straight = np.minimum(np.linalg.norm(a - many, axis=2) / 1.5, 1).mean(1)
    np.testing.assert_allclose(bounded_edit_distances(a, many, 1.5, 0.4, band=0), straight, atol=1e-5)


@pytest.mark.parametrize(
    ("a", "many", "cap", "gap"),
    [((0, 2), (1, 3, 2), 1, 1), ((3, 2), (1, 3, 4), 1, 1), ((3, 2), (1, 3, 2), 0, 1), ((3, 2), (1, 3, 2), 1, 0)],
)
def test_what_cannot_be_compared_is_refused(a, many, cap, gap):
    with pytest.raises(ValueError, match=r"compare|positive"):
        bounded_edit_distances(np.zeros(a), np.zeros(many), cap, gap)
