"""Maps against slow and obvious ones."""

from __future__ import annotations

import numpy as np
import pytest

from core.motion_map.som import batch_som, best_nodes, errors, online_som, principal_axes, u_matrix


def cloud(n: int = 300, d: int = 6, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return (rng.normal(size=(n, 2)) @ rng.normal(size=(2, d)) * 2 + 0.3 * rng.normal(size=(n, d))).astype(np.float32)


def textbook_online(samples, grid, passes, seed):
    """The paper's update, node by node, all nodes every time."""
    nx, ny = grid
    weights = np.zeros((nx, ny, samples.shape[1]))
    rng, n, t = np.random.default_rng(seed), passes * len(samples), 0
    places = np.stack(np.meshgrid(np.arange(nx), np.arange(ny), indexing="ij"), axis=-1)
    for _ in range(passes):
        for x in samples[rng.permutation(len(samples))].astype(np.float64):
            apart = ((weights - x) ** 2).sum(axis=-1)
            best = np.array(np.unravel_index(np.argmin(apart), apart.shape))
            alpha = max(0.8 * (1 - 6 * t / n), 0.01)
            sigma = max(0.25 * (nx + ny) * (1 - t / n), 0.3)
            near = alpha * np.exp(-((places - best) ** 2).sum(axis=-1) / (2 * sigma**2))
            weights += near[..., None] * (x - weights)
            t += 1
    return weights


def test_the_papers_schedule_is_the_textbooks():
    samples = cloud(60)
    found = online_som(samples, (5, 4), passes=5, seed=3)
    np.testing.assert_allclose(found, textbook_online(samples, (5, 4), 5, 3), atol=2e-3)


def textbook_batch(samples, weights, sigma):
    """Every node: the mean of all samples, weighted by the grid distance of their best nodes."""
    nx, ny, _ = weights.shape
    places = np.argwhere(np.ones((nx, ny)))
    best = [np.argmin(((weights.reshape(nx * ny, -1) - x) ** 2).sum(axis=1)) for x in samples]
    near = np.exp(-((places[:, None] - places[best]) ** 2).sum(axis=-1) / (2 * sigma**2))
    return ((near @ samples.astype(np.float64)) / near.sum(axis=1, keepdims=True)).reshape(weights.shape)


def test_a_batch_step_is_the_textbooks():
    samples = cloud(200)
    before = batch_som(samples, (6, 5), epochs=4, sigma=(2.0, 1.0))
    after = batch_som(samples, (6, 5), epochs=5, sigma=(2.0, 1.0))  # another schedule: compare one step from one map
    from core.motion_map.som import _moved

    stepped = _moved(samples, best_nodes(samples, before)[0], before, 1.0)
    np.testing.assert_allclose(stepped, textbook_batch(samples, before, 1.0), atol=1e-4)
    assert not np.allclose(before, after)


def test_best_nodes_and_errors_agree_with_all_pairs():
    samples = cloud(500)
    weights = batch_som(samples, (7, 6), epochs=6)
    models = weights.reshape(42, -1).astype(np.float64)
    apart = np.linalg.norm(samples[:, None] - models[None], axis=-1)
    index, distance = best_nodes(samples, weights)
    np.testing.assert_array_equal(index, apart.argmin(axis=1))
    np.testing.assert_allclose(distance, apart.min(axis=1), atol=1e-3)
    two = np.argsort(apart, axis=1)[:, :2]
    torn = [max(abs(a // 6 - b // 6), abs(a % 6 - b % 6)) > 1 for a, b in two]
    found = errors(samples, weights)
    assert found == (pytest.approx(apart.min(axis=1).mean(), abs=1e-4), pytest.approx(np.mean(torn)))


def test_a_map_of_a_sheet_is_flat_and_ordered():
    rng = np.random.default_rng(1)
    place = rng.uniform(-1, 1, size=(3000, 2))
    samples = np.column_stack([place, np.zeros((3000, 3))]).astype(np.float32)
    weights = batch_som(samples, (12, 12))
    quantisation, topographic = errors(samples, weights)
    assert quantisation < 0.09 and topographic < 0.05
    axis = np.abs([np.corrcoef(weights[:, 6, k], np.arange(12))[0, 1] for k in (0, 1)])
    assert axis.max() > 0.95


def test_few_samples_in_early_epochs_cost_no_quality():
    samples = cloud(9000, 10, seed=2)
    fast = errors(samples, batch_som(samples, (15, 15), seed=1))
    import core.motion_map.som as som

    everything = som._enough
    try:
        som._enough = lambda n, first, width: n
        slow = errors(samples, batch_som(samples, (15, 15), seed=1))
    finally:
        som._enough = everything
    assert fast[0] <= 1.03 * slow[0] and fast[1] <= slow[1] + 0.03


def test_the_same_seed_gives_the_same_map():
    samples = cloud(3000)
    np.testing.assert_array_equal(batch_som(samples, (8, 8), seed=4), batch_som(samples, (8, 8), seed=4))


def test_the_u_matrix_by_hand():
    weights = np.zeros((2, 3, 1), np.float32)
    weights[:, :, 0] = [[0, 1, 5], [0, 3, 5]]
    np.testing.assert_allclose(u_matrix(weights), [[0.5, 7 / 3, 2.0], [1.5, 7 / 3, 1.0]])


def test_nonsense_is_refused_in_plain_words():
    with pytest.raises(ValueError, match="at least 2 x 2"):
        batch_som(cloud(), (1, 5))
    with pytest.raises(ValueError, match="samples"):
        batch_som(np.zeros((0, 3)), (5, 5))
    with pytest.raises(ValueError, match="sigma"):
        batch_som(cloud(), (5, 5), sigma=(1.0, 2.0))


def test_axes_of_little_data_are_there_all_the_same():
    mean, axes = principal_axes(np.ones((1, 4), np.float32), 2)
    assert mean.shape == (4,) and axes.shape == (4, 2) and np.isfinite(axes).all()
    assert np.isfinite(batch_som(np.ones((1, 4), np.float32), (3, 3))).all()
