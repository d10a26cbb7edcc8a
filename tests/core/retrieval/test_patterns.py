"""Adaptive k-means keeps its promise; the library finds the nearest pattern; dissimilarities are what they say."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.retrieval.patterns import FIRST_K, adaptive_k_means, build_library


def blobs(n: int, centres: int, seed: int = 0, spread: float = 0.05) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    places = rng.normal(size=(centres, 6)) * 3
    which = rng.integers(centres, size=n)
    return (places[which] + rng.normal(size=(n, 6)) * spread).astype(np.float32), which


@settings(max_examples=30)
@given(st.integers(1, 40), st.floats(0.0, 1.5), st.integers(0, 50))
def test_no_segment_is_farther_from_its_pattern_than_the_error(n, error, seed):
    x, _ = blobs(n, 5, seed)
    centres, labels = adaptive_k_means(x, max_error=error, most=n, seed=seed)
    apart = np.linalg.norm(x[:, None].astype(float) - centres, axis=2)
    spread = np.sqrt(((x - x.mean(0)) ** 2).sum(1).mean())
    assert (apart[np.arange(n), labels] <= error * spread + 2e-3).all() or len(centres) >= len(np.unique(x, axis=0))
    assert (apart[np.arange(n), labels] <= apart.min(1) + 2e-3).all()
    assert set(labels) == set(range(len(centres)))


def test_a_small_error_makes_more_patterns_and_a_large_one_the_first_k():
    x, _ = blobs(400, 30)
    sizes = [len(adaptive_k_means(x, max_error=error, most=400)[0]) for error in (3.0, 0.5, 0.05)]
    assert sizes[0] <= FIRST_K < sizes[1] <= sizes[2]
    assert len(adaptive_k_means(x, max_error=0.0, most=25)[0]) == 25


def test_separate_kinds_of_segments_get_patterns_of_their_own():
    x, which = blobs(500, 12)
    _, labels = adaptive_k_means(x, max_error=0.2, most=100)
    for pattern in np.unique(labels):
        assert len(np.unique(which[labels == pattern])) == 1


def test_it_is_deterministic_and_refuses_nothing_to_cluster():
    x, _ = blobs(100, 5)
    assert np.array_equal(*(adaptive_k_means(x, max_error=0.1, most=50, seed=3)[1] for _ in range(2)))
    with pytest.raises(ValueError, match="needs segments"):
        adaptive_k_means(np.zeros((0, 3)), max_error=0.1, most=5)


def test_the_library_finds_the_nearest_pattern_and_knows_its_own():
    x, _ = blobs(300, 20)
    library, labels = build_library(x, max_error=0.1, most=60)
    queries = np.random.default_rng(1).normal(size=(40, 6)).astype(np.float32) * 3
    brute = np.linalg.norm(queries[:, None].astype(float) - library.patterns, axis=2).argmin(1)
    assert np.array_equal(library.nearest(queries), brute) and np.array_equal(library.assign(queries), brute)
    assert np.array_equal(library.nearest(library.patterns), np.arange(len(library.patterns)))
    assert np.array_equal(library.nearest(x), labels)
    assert library.nearest(x[:0]).shape == (0,)


def test_dissimilarities_are_shares_of_pairs_and_of_the_greatest():
    x, _ = blobs(300, 20)
    library, labels = build_library(x, max_error=0.1, most=60)
    own = np.linalg.norm(library.patterns[:, None].astype(float) - library.patterns, axis=2)
    np.testing.assert_allclose(library.distances, own, atol=5e-3)
    assert library.by_maximum.max() == pytest.approx(1) and (library.by_percentile.diagonal() == 0).all()
    pairs = own[labels[:, None], labels]
    a, b = 0, int(own[0].argsort()[len(own) // 2])
    assert library.by_percentile[a, b] == pytest.approx((pairs < own[a, b]).mean(), abs=0.03)
    assert np.array_equal(library.by_percentile, library.by_percentile.T)
