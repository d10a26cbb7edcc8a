"""Greedy discovery against brute force, and what holds for every result."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.motifs.discovery import largest_first, random_seeds
from core.motifs.leftovers import join_leftovers
from core.motifs.matching import Matcher, Rule
from core.progress import Cancelled
from tests.core.motifs.strings import (
    naive_matches,
    naive_motif,
    naive_volume,
    random_adjacency,
    random_runs,
    runs_of,
)
from tests.core.motifs.test_matching import near


def problem(seed, n_clips=2, n=10):
    rng = np.random.default_rng(seed)
    runs = random_runs(rng, n_clips, n, kappa=5)
    adjacency = random_adjacency(rng, 5, float(rng.uniform(0.3, 0.8)))
    return runs, adjacency, Rule(2, 5, 1.5, 0.5, np.inf, 0)


@settings(max_examples=60, deadline=None)
@given(
    seed=st.integers(0, 10**6),
    rho=st.sampled_from([0.2, 1.0, 5.0]),
    tightness=st.sampled_from([0.0, 0.7]),
)
def test_each_motif_is_the_largest_there_is(seed, rho, tightness):
    """Round by round: no seed's volume beats the chosen one; at the end no seed has a volume."""
    runs, adjacency, rule = problem(seed)
    rule = rule._replace(max_cost=adjacency.radius)
    matches = naive_matches(runs, adjacency, rule)
    seeds, cut = {key[:2] for key in matches}, set((runs.stops - 1).tolist())

    def largest():
        free = [s for s in seeds if not cut & set(range(*s))]
        return max((volume(naive_motif(runs, s, matches, cut)) for s in free), default=0.0)

    def volume(motif):
        costs = [matches[*motif[0], *other] for other in motif[1:]]
        return naive_volume(runs, motif, costs, rho, tightness / adjacency.radius)

    for motif in largest_first(runs, Matcher(runs, adjacency).all(rule), rule, rho, tightness=tightness):
        chosen = [(int(a), int(b)) for a, b in motif]
        assert chosen == naive_motif(runs, chosen[0], matches, cut)
        assert volume(chosen) == pytest.approx(largest(), rel=1e-6)
        cut |= {t for a, b in chosen for t in range(a, b)}
    assert largest() == 0


@pytest.mark.parametrize("rho", [0.2, 1.0, 5.0])
def test_brute_force_rounds_are_many(rho):
    """The comparison above is not about empty results, and volumes do rise later in some of them (the hard case)."""
    rounds = 0
    for seed in range(10):
        runs, adjacency, rule = problem(seed, n_clips=3, n=20)
        rounds += len(largest_first(runs, Matcher(runs, adjacency).all(rule), rule, rho))
    assert rounds > 15


@settings(max_examples=40, deadline=None)
@given(seed=st.integers(0, 10**6), method=st.sampled_from(["largest", "random"]), join=st.booleans())
def test_motions_never_overlap_nor_cross_clips(seed, method, join):
    runs, adjacency, rule = problem(seed, n_clips=3, n=25)
    matcher = Matcher(runs, adjacency)
    motifs = discover(method, runs, matcher, rule, seed)
    if join:
        motifs = join_leftovers(runs, matcher, motifs, rule)
    taken = np.zeros(len(runs.letters), int)
    for motif in motifs:
        assert len(motif) >= 2
        for a, b in motif:
            assert a < b < runs.stops[a]
            taken[a:b] += 1
    assert taken.max(initial=0) <= 1


def discover(method, runs, matcher, rule, seed=0):
    matches = matcher.all(rule)
    if method == "largest":
        return largest_first(runs, matches, rule, 1.0)
    return random_seeds(runs, matches, rule, 1.0, seed)


@pytest.mark.parametrize("method", ["largest", "random"])
def test_the_papers_toy_words_are_one_motif(method):
    runs = runs_of(["goacen", "xyzgoachcenxyz"])
    matcher = Matcher(runs, near(runs, "ch"))
    motifs = discover(method, runs, matcher, Rule(5, 30, 1.5, 0.5, np.inf, 0))
    assert [sorted(map(tuple, motif.tolist())) for motif in motifs] == [[(0, 5), (9, 16)]]


@pytest.mark.parametrize("method", ["largest", "random"])
def test_no_motif_where_nothing_recurs(method):
    runs = runs_of(["abcdefg", "hijklmn"])
    assert discover(method, runs, Matcher(runs, near(runs, "")), Rule(5, 30, 1.5, 0.5, np.inf, 0)) == []


def test_random_seeds_repeat_with_their_seed_and_cover_about_as_much():
    runs, adjacency, rule = problem(3, n_clips=4, n=60)
    matcher = Matcher(runs, adjacency)
    one, two = (discover("random", runs, matcher, rule, 7) for _ in range(2))
    assert [m.tolist() for m in one] == [m.tolist() for m in two]
    covered = [sum(int(b - a) for m in ms for a, b in m) for ms in (one, discover("largest", runs, matcher, rule))]
    assert covered[0] > 0.7 * covered[1] > 0


def test_leftovers_join_only_with_a_looser_rule():
    """Two equal words make a motif; a third, further off, joins it when the rule allows."""
    runs = runs_of(["abcde", "abcde", "abfde"])
    adjacency = near(runs, "cf")
    strict, loose = Rule(5, 30, 1.5, 0.5, 0.1, 0), Rule(5, 30, 1.5, 0.5, 0.3, 0)
    matcher = Matcher(runs, adjacency)
    motifs = largest_first(runs, matcher.all(strict), strict, 1.0)
    assert [len(m) for m in motifs] == [2]
    assert [len(m) for m in join_leftovers(runs, matcher, motifs, strict)] == [2]
    assert [len(m) for m in join_leftovers(runs, matcher, motifs, loose)] == [3]


def test_discovery_can_be_cancelled():
    runs, adjacency, rule = problem(0, n_clips=3, n=25)
    matches = Matcher(runs, adjacency).all(rule)

    def stop(stage, fraction):
        raise Cancelled

    with pytest.raises(Cancelled):
        largest_first(runs, matches, rule, 1.0, report=stop)
