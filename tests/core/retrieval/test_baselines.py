"""Baselines: their dynamic programmes against plain ones, and that they find what is plainly alike."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.mocap.dataset import Dataset
from core.retrieval.baselines import BASELINES, baseline_rankings
from core.retrieval.baselines.match_webs import by_steps, web_distance
from core.retrieval.baselines.warping import edit_distance, warping_distance
from tests.core.editing.figures import action

sizes = st.integers(1, 6)


@given(sizes, sizes, st.integers(0, 999))
def test_warping_distance_is_the_cheapest_of_all_paths(n, m, seed):
    rng = np.random.default_rng(seed)
    a, b = rng.normal(size=(n, 2)), rng.normal(size=(m, 2))
    cost = np.linalg.norm(a[:, None] - b, axis=2)

    @cache
    def cheapest(i: int, j: int) -> float:
        if (i, j) == (0, 0):
            return 2 * cost[0, 0]
        before = [cheapest(i - 1, j - 1) + 2 * cost[i, j]] if i and j else []
        before += [cheapest(i - 1, j) + cost[i, j]] if i else []
        before += [cheapest(i, j - 1) + cost[i, j]] if j else []
        return min(before)

    assert warping_distance(a, b) == pytest.approx(cheapest(n - 1, m - 1) / (n + m), rel=1e-4)


@given(st.lists(st.integers(0, 3), min_size=1, max_size=6), st.lists(st.integers(0, 3), min_size=1, max_size=6))
def test_edit_distance_is_the_cheapest_of_all_edits(a, b):
    prices = np.abs(np.subtract.outer(np.arange(4), np.arange(4))) / 3

    @cache
    def cheapest(i: int, j: int) -> float:
        if i == 0 or j == 0:
            return 0.5 * (i + j)
        put = cheapest(i - 1, j - 1) + prices[a[i - 1], b[j - 1]]
        return min(put, cheapest(i - 1, j) + 0.5, cheapest(i, j - 1) + 0.5)

    expected = cheapest(len(a), len(b)) / max(len(a), len(b))
    assert edit_distance(np.array(a), np.array(b), prices, 0.5) == pytest.approx(expected, abs=1e-6)


def test_nothing_cannot_be_compared():
    with pytest.raises(ValueError, match="cannot compare"):
        warping_distance(np.zeros((0, 2)), np.zeros((3, 2)))
    with pytest.raises(ValueError, match="empty list"):
        edit_distance(np.array([]), np.array([1]), np.eye(2), 0.5)


def test_a_web_follows_a_valley_and_charges_what_it_leaves_uncovered():
    grid = np.ones((6, 8))
    grid[np.arange(6), np.arange(6) + 1] = 0.1
    assert web_distance(grid) == pytest.approx(0.1)
    assert web_distance(grid[:, :4]) == pytest.approx((3 * 0.1 + 3) / 6)
    assert web_distance(np.ones((4, 4))) == pytest.approx(1)


def test_steps_reach_what_lies_behind_a_neighbour():
    apart = np.array([[0, 0.2, 0.9, 1], [0.2, 0, 0.3, 1], [0.9, 0.3, 0, 0.4], [1, 1, 0.4, 0]])
    assert by_steps(apart, 1)[0, 2] == pytest.approx(0.9, abs=1e-5)
    assert by_steps(apart, 2)[0, 2] == pytest.approx(0.3, abs=1e-5)
    assert by_steps(apart, 2)[0, 3] == pytest.approx(0.9, abs=1e-5)
    assert by_steps(apart, 3)[0, 3] == pytest.approx(0.4, abs=1e-5)


@pytest.fixture(scope="module")
def actions():
    names = ("jump", "backflip", "crawl")
    clips = [replace(action(name, seed=seed), name=f"{name}{seed}") for seed in (1, 2) for name in names]
    return Dataset("actions", tuple(clips))


@pytest.mark.parametrize("name", BASELINES)
def test_a_baseline_finds_the_other_performance_of_an_action(actions, name):
    apart = BASELINES[name](actions, lambda *_: None)
    assert apart.shape == (6, 6) and np.allclose(apart.diagonal(), 0, atol=1e-3) and np.isfinite(apart).all()
    rankings = baseline_rankings(name, actions)
    assert set(rankings) == set(actions.names)
    found = [rankings[query][0][:-1] == query[:-1] for query in actions.names]
    assert sum(found) >= 5
