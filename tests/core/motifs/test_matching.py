"""The alignment programme against every path tried by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.motifs.adjacency import Adjacency, nearest_pairs_radius, radius_adjacency, sphere_adjacency
from core.motifs.matching import Matcher, Matches, Rule
from core.progress import Cancelled
from tests.core.motifs.strings import hangs_on_rounding, naive_matches, random_adjacency, random_runs, runs_of


def as_dict(matches: Matches, rule: Rule) -> dict[tuple[int, int, int, int], float]:
    lengths, found = rule.max_letters - rule.min_letters + 1, {}
    for k in range(len(matches.pointers) - 1):
        j = k // lengths
        for q in range(matches.pointers[k], matches.pointers[k + 1]):
            key = j, j + k % lengths + rule.min_letters - 1, int(matches.starts[q]), int(matches.ends[q])
            assert key not in found
            found[key] = float(matches.costs[q])
    return found


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    gamma=st.sampled_from([1.0, 1.5, 3.0]),
    slack=st.sampled_from([0.0, 0.5, 2.0]),
    cap=st.sampled_from([0.2, 0.5, np.inf]),
    min_frames=st.sampled_from([0, 6]),
)
def test_same_matches_as_trying_every_path(seed, gamma, slack, cap, min_frames):
    rng = np.random.default_rng(seed)
    runs, adjacency = random_runs(rng, n=9), random_adjacency(rng, density=float(rng.uniform(0.3, 0.9)))
    rule = Rule(2, 5, gamma, slack, cap * adjacency.radius, min_frames)
    expected = naive_matches(runs, adjacency, rule)
    found = as_dict(Matcher(runs, adjacency).all(rule), rule)
    certain = found.keys() & expected.keys()
    assert all(hangs_on_rounding(runs, adjacency, rule, key) for key in found.keys() ^ expected.keys())
    assert {key: found[key] for key in certain} == pytest.approx({key: expected[key] for key in certain}, rel=1e-4)


def test_no_limit_of_the_cost_is_still_no_match_without_a_path():
    rng = np.random.default_rng(28)
    runs, adjacency = random_runs(rng, n=9), random_adjacency(rng, density=float(rng.uniform(0.3, 0.9)))
    rule = Rule(2, 5, 1.0, 2.0, np.inf, 0)
    found = as_dict(Matcher(runs, adjacency).all(rule), rule)
    assert found.keys() == naive_matches(runs, adjacency, rule).keys() and np.isfinite(list(found.values())).all()


def test_random_strings_do_have_matches():
    """The test above would pass on empty results; it does not compare empty results."""
    sizes = []
    for seed in range(20):
        rng = np.random.default_rng(seed)
        runs, adjacency = random_runs(rng, n=9), random_adjacency(rng, density=0.7)
        sizes.append(len(naive_matches(runs, adjacency, Rule(2, 5, 1.5, 0.5, np.inf, 0))))
    assert np.mean(sizes) > 20


def test_matches_of_one_seed_are_those_of_all_seeds():
    rng = np.random.default_rng(5)
    runs, adjacency = random_runs(rng, n_clips=3, n=40, kappa=6), random_adjacency(rng, 6, 0.6)
    rule, matcher = Rule(3, 8, 1.5, 0.5, adjacency.radius, 0), Matcher(runs, adjacency)
    everything = as_dict(matcher.all(rule), rule)
    assert everything
    for j, k in {key[:2] for key in everything}:
        one = matcher.of(j, k, rule)
        expected = sorted((a, b) for (j2, k2, a, b) in everything if (j2, k2) == (j, k))
        assert sorted(zip(one.starts.tolist(), one.ends.tolist(), strict=True)) == expected


def test_blocks_join_to_the_same_whole(monkeypatch):
    rng = np.random.default_rng(1)
    runs, adjacency = random_runs(rng, n_clips=4, n=60, kappa=8), random_adjacency(rng, 8, 0.4)
    rule = Rule(3, 10, 1.5, 0.5, np.inf, 0)
    whole = Matcher(runs, adjacency).all(rule)
    monkeypatch.setattr("core.motifs.matching._BLOCK", 50)
    parts = Matcher(runs, adjacency).all(rule)
    assert len(whole.costs) > 100
    for a, b in zip(whole, parts, strict=True):
        np.testing.assert_array_equal(a, b)


def test_the_papers_toy_words_match():
    """GOACEN and GOACHCEN: h lies near c, so the detour c-h-c is the same motion (MMG section 3.2)."""
    runs = runs_of(["goacen", "goachcen"])
    matches = Matcher(runs, near(runs, "ch")).all(Rule(5, 30, 1.5, 0.5, np.inf, 0))
    assert (0, 5, 6, 13) in as_dict(matches, Rule())
    alone = Matcher(runs, near(runs, "")).all(Rule(5, 30, 1.5, 0.5, np.inf, 0))
    assert (0, 5, 6, 13) not in as_dict(alone, Rule())


def near(runs, pair: str) -> Adjacency:
    kappa = int(runs.letters.max()) + 1
    distances = np.full((kappa, kappa), 5, np.float32) + np.random.default_rng(0).random((kappa, kappa), np.float32)
    distances = (distances + distances.T) / 2
    np.fill_diagonal(distances, 0)
    if pair:
        a, b = (ord(c) - ord("a") for c in pair)
        distances[a, b] = distances[b, a] = 1
    return Adjacency(distances, np.where(distances <= 1, distances, np.inf).astype(np.float32), 1.0)


def test_a_cancelled_search_stops_with_the_callers_exception():
    rng = np.random.default_rng(0)
    runs, adjacency = random_runs(rng, n_clips=2, n=50), random_adjacency(rng)

    def stop(stage, fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        Matcher(runs, adjacency).all(Rule(), stop)


def test_radius_adjacency_takes_the_share_asked_for():
    centres = np.random.default_rng(0).normal(size=(200, 5)).astype(np.float32)
    adjacency = radius_adjacency(centres, nearest_pairs_radius(centres, 0.07))
    off_diagonal = np.isfinite(adjacency.costs).sum() - 200
    assert off_diagonal / (200 * 199) == pytest.approx(0.07, abs=0.002)
    assert (np.diag(adjacency.costs) == 0).all()


def test_spheres_touch_where_the_paper_says():
    centres = np.array([[0, 0], [4, 0], [20, 0]], np.float32)
    labels, to_centre = np.array([0, 0, 1, 1, 2]), np.array([0.5, 2.5, 1.0, 1.6, 3.0], np.float32)
    adjacent = np.isfinite(sphere_adjacency(centres, labels, to_centre).costs)
    assert adjacent.tolist() == [[True, True, False], [True, True, False], [False, False, True]]
