"""k-means and the automatic number of letters."""

from __future__ import annotations

import numpy as np
import pytest
from sklearn.cluster import KMeans

from core.motifs.quantize import automatic_kappa, k_means, split_start


def blobs(n=3000, d=6, seed=0):
    rng = np.random.default_rng(seed)
    return (rng.normal(size=(40, d)) * 5)[rng.integers(0, 40, n)] + rng.normal(size=(n, d))


def test_inertia_is_that_of_an_independent_implementation():
    x = blobs()
    ours = np.median([(k_means(x, 60, seed).distances ** 2).sum() for seed in range(5)])
    theirs = np.median([KMeans(60, n_init=1, random_state=seed).fit(x).inertia_ for seed in range(5)])
    assert ours < 1.03 * theirs


def test_labels_are_the_nearest_centres_and_all_are_used():
    x = blobs(500).astype(np.float32)
    letters = k_means(x, 50)
    distances = np.linalg.norm(x[:, None] - letters.centres[None], axis=2)
    np.testing.assert_allclose(distances.min(1), letters.distances, atol=2e-3)
    assert np.abs(distances[np.arange(500), letters.labels] - distances.min(1)).max() < 2e-3
    assert sorted(set(letters.labels.tolist())) == list(range(len(letters.centres)))


def test_same_seed_same_letters():
    one, two, other = k_means(blobs(), 50, 3), k_means(blobs(), 50, 3), k_means(blobs(), 50, 4)
    np.testing.assert_array_equal(one.labels, two.labels)
    assert (one.labels != other.labels).any()


@pytest.mark.parametrize("x", [np.ones((20, 3)), np.ones((1, 3)), np.repeat(np.eye(3), 4, axis=0)])
def test_never_more_letters_than_different_poses(x):
    letters = k_means(x, 10)
    assert len(letters.centres) == len(np.unique(x, axis=0)) and letters.distances.max() < 1e-3


@pytest.mark.parametrize("x, kappa", [(np.ones((5, 2)), 0), (np.ones((0, 2)), 3)])
def test_nothing_to_cluster_is_said(x, kappa):
    with pytest.raises(ValueError, match="k-means"):
        k_means(x, kappa)


def test_automatic_kappa_grows_with_frames_and_variety():
    rng = np.random.default_rng(0)
    walk = np.cumsum(rng.normal(size=(4000, 8)), axis=0)
    assert automatic_kappa(walk[:500]) < automatic_kappa(walk)
    still = np.repeat(walk[:400], 10, axis=0)
    assert automatic_kappa(still) < automatic_kappa(walk)
    assert automatic_kappa(np.ones((1, 3))) >= 2


def test_a_split_start_is_the_same_for_every_seed_and_about_as_good():
    x = blobs()
    one, other = k_means(x, 60, 0, start="split"), k_means(x, 60, 7, start="split")
    assert np.array_equal(one.labels, other.labels) and np.array_equal(one.centres, other.centres)
    random = [(k_means(x, 60, seed).distances ** 2).sum() for seed in range(5)]
    assert (one.distances**2).sum() < 1.1 * np.median(random)
    with pytest.raises(ValueError, match="start"):
        k_means(x, 3, start="middle")


def test_split_start_divides_the_widest_group_across_its_widest_direction():
    x = np.array([[0, 0], [0, 1], [10, 0], [10, 1], [30, 0], [30, 6]], np.float32)
    assert sorted(split_start(x, 2).tolist()) == [[5, 0.5], [30, 3]]
    assert sorted(split_start(x, 3).tolist()) == [[0, 0.5], [10, 0.5], [30, 3]]
    assert len(split_start(x, 100)) == 6
    assert len(split_start(np.zeros((5, 2), np.float32), 3)) == 1
