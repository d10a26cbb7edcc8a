"""Distances, medoids, cuts and their alternation, against plain versions and exhaustive search."""

from __future__ import annotations

from itertools import combinations, pairwise

import kmedoids
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.grammar.alternation import alternate, cut_by_medoids, even_cuts, recombine
from core.grammar.cuts import best_cuts
from core.grammar.medoids import seed_medoids, swap_medoids
from core.grammar.objective import clustering_of, span_distances
from core.grammar.segment_distance import segment_distances
from tests.core.grammar import naive

seeds = st.integers(0, 10_000)


@given(seeds)
@settings(max_examples=25)
def test_distances_are_equation_1(seed):
    rng = np.random.default_rng(seed)
    x, y = rng.normal(size=(2, 30, 3)).astype(np.float32)
    spans = np.sort(np.array([rng.choice(31, 2, replace=False) for _ in range(6)]), axis=1)
    expected = [[naive.distance(x, a, b, y) for b in spans[:4]] for a in spans]
    assert np.allclose(segment_distances(x, spans, spans[:4], y), expected, rtol=1e-4)
    among = segment_distances(x, spans)
    assert np.allclose(among, [[naive.distance(x, a, b) for b in spans] for a in spans], rtol=1e-4)
    assert (among == among.T).all()


@pytest.mark.parametrize("spans", [[(0, 0)], [(3, 2)], [(-1, 2)], [(0, 6)]])
def test_intervals_out_of_range_are_refused(spans):
    with pytest.raises(ValueError, match="intervals of the 5 poses"):
        segment_distances(np.zeros((5, 2)), np.array(spans))


@given(seeds, st.integers(1, 4), st.sampled_from([0.0, 0.4]))
@settings(max_examples=25)
def test_cuts_are_the_best_of_all(seed, shortest, price):
    rng = np.random.default_rng(seed)
    x = rng.normal(size=(9, 2)).astype(np.float32)
    medoids = [rng.normal(size=(int(rng.integers(1, 6)), 2)).astype(np.float32) for _ in range(3)]

    def cost(a, b):
        y = np.concatenate([x, *medoids])
        starts = len(x) + np.cumsum([0, *map(len, medoids)])
        return (b - a) * min(naive.distance(y, (a, b), span) for span in pairwise(starts)) + price

    ways = list(naive.segmentations(9, shortest, 2 * shortest))
    cuts, labels, total = best_cuts(x, medoids, shortest, 2 * shortest, price)
    assert total == pytest.approx(min(sum(cost(a, b) for a, b in spans) for spans in ways), rel=1e-4)
    spans = list(zip(cuts[:-1].tolist(), cuts[1:].tolist(), strict=True))
    assert spans in ways
    assert total == pytest.approx(sum(cost(a, b) for a, b in spans), rel=1e-4)
    assert labels.shape == (len(spans),) and set(labels.tolist()) <= {0, 1, 2}


def test_a_clip_too_short_to_cut_stays_whole():
    cuts, labels, _ = best_cuts(np.zeros((3, 2)), [np.zeros((5, 2)), np.ones((4, 2))], 5, 20)
    assert cuts.tolist() == [0, 3] and labels.tolist() == [0]


@given(seeds, st.integers(1, 3))
@settings(max_examples=25)
def test_no_swap_improves_the_medoids(seed, k):
    rng = np.random.default_rng(seed)
    points = rng.normal(size=(12, 2))
    distances = ((points[:, None] - points[None]) ** 2).sum(-1)
    weights, prices = rng.uniform(0.1, 1, (2, 12))

    def cost(medoids):
        return weights @ distances[:, list(medoids)].min(1) + prices[list(medoids)].sum()

    found = swap_medoids(distances, weights, prices, seed_medoids(distances, weights, k, rng))
    assert len(set(found.tolist())) == k
    for i in range(k):
        for other in set(range(12)) - set(found.tolist()):
            swapped = [*found[:i], other, *found[i + 1 :]]
            assert cost(swapped) >= cost(found) - 1e-5
    if k == 1:
        assert cost(found) == pytest.approx(min(cost([j]) for j in range(12)), rel=1e-5)


def test_without_prices_and_weights_the_medoids_are_as_good_as_those_of_fasterpam():
    rng = np.random.default_rng(3)
    points = rng.normal(size=(300, 2)) + rng.integers(0, 4, (300, 1)) * 5
    distances = np.sqrt(((points[:, None] - points[None]) ** 2).sum(-1)).astype(np.float32)
    start = np.arange(8)
    ours = swap_medoids(distances, np.ones(300), np.zeros(300), start)
    theirs = kmedoids.fasterpam(distances, start.astype(np.uint64))
    assert distances[:, ours].min(1).sum() <= 1.02 * theirs.loss


def test_the_alternation_comes_near_the_best_of_all():
    ratios = []
    for seed in range(4):
        rng = np.random.default_rng(seed)
        motions = rng.normal(size=(2, 3, 2))
        space = naive.toy_space(np.concatenate([motions[i] for i in (0, 1, 0, 1)]) + 0.05 * rng.normal(size=(12, 2)))
        best = naive.best_of_all(space, 2, 0.2, 2, 5)
        costs = []
        for start in range(4):
            spans = even_cuts(space, 2 + start % 3, (2, 5))
            clustering, cost = alternate(space, 2, 0.2, (2, 5), np.random.default_rng(start), spans=spans)
            spans = [tuple(span) for span in clustering.spans.tolist()]
            assert cost == pytest.approx(naive.cost(space, spans, clustering.medoids, 0.2), rel=1e-3)
            costs.append(cost)
        ratios.append(min(costs) / best)
    assert min(ratios) > 1 - 1e-5 and max(ratios) < 1.1 and np.median(ratios) < 1.02


def test_a_recombination_keeps_what_each_parent_has_right():
    rng = np.random.default_rng(0)
    motions = 4 * rng.normal(size=(4, 4, 2))
    order = [0, 1, 2, 3, 1, 0, 3, 2, 0, 2, 1, 3]
    space = naive.toy_space(np.concatenate([motions[i] for i in order]) + 0.01 * rng.normal(size=(48, 2)))
    spans = np.arange(0, 52, 4)[:13]
    spans = np.stack([spans[:-1], spans[1:]], axis=1)

    def knows(*places):  # a clustering whose medoids are these segments alone
        medoids = np.array(places)
        return clustering_of(spans, medoids, span_distances(space, spans, spans[medoids]))

    parents = knows(0, 1, 4, 5), knows(2, 3, 6, 7)  # motions 0 and 1 twice; motions 2 and 3 twice
    child, cost = recombine(space, parents, 4, 0.0, (3, 6), np.random.default_rng(0))
    assert sorted(order[i] for i in child.medoids) == [0, 1, 2, 3] and child.spans.tolist() == spans.tolist()
    assert cost < 0.1 * min(1 / parent.objective(space, 0.0)["F"] for parent in parents)
    assert recombine(space, parents, 40, 0.0, (3, 6), rng) is None
    with pytest.raises(ValueError, match="must be clusterings"):
        recombine(space, [], 4, 0.0, (3, 6), rng)


@given(seeds)
@settings(max_examples=15)
def test_spans_cover_every_clip_once(seed):
    rng = np.random.default_rng(seed)
    lengths = rng.integers(1, 40, 3)
    space = naive.toy_space(rng.normal(size=(lengths.sum(), 2)), [0, *np.cumsum(lengths)])
    medoids = np.array([[0, min(4, lengths[0])], [lengths[0], lengths[0] + 1]])
    for spans in (even_cuts(space, 7, (3, 9)), cut_by_medoids(space, medoids, (3, 9))[0]):
        assert spans[0, 0] == 0 and spans[-1, 1] == space.n
        assert (spans[1:, 0] == spans[:-1, 1]).all()
        assert set(space.clip_starts[1:].tolist()) <= set(spans[:, 1].tolist())
        for start, end in spans:
            clip = np.searchsorted(space.clip_starts, start, side="right") - 1
            whole = lengths[clip] == end - start
            assert whole or 3 <= end - start <= 9


def test_mirror_images_are_the_same():
    rng = np.random.default_rng(0)
    left = rng.normal(size=(4, 2))
    values = np.concatenate([left, left * [-1, 1]])
    space = naive.toy_space(values, mirrored=np.ascontiguousarray(values * [-1, 1], np.float32))
    distances = span_distances(space, np.array([[0, 4], [4, 8]]))
    assert np.allclose(distances, 0, atol=1e-6)
    clustering = clustering_of(np.array([[0, 4], [4, 8]]), np.array([1]), distances[:, [1]])
    assert clustering.objective(space, 0.5)["E"] == pytest.approx(0, abs=1e-6)


def test_a_thinned_space_and_back():
    space = naive.toy_space(np.arange(23.0)[:, None], [0, 10, 23])
    thin = space.thinned(3)
    assert thin.clip_starts.tolist() == [0, 4, 9]
    assert thin.values[:, 0].tolist() == [0, 3, 6, 9, 10, 13, 16, 19, 22]
    assert space.unthinned(np.array([[0, 2], [2, 4], [4, 9]]), 3, thin).tolist() == [[0, 6], [6, 10], [10, 23]]


def test_every_pair_is_tried_for_medoids_of_copies():
    distances = np.zeros((4, 4))
    found = seed_medoids(distances, np.ones(4), 3, np.random.default_rng(0))
    assert len(set(found.tolist())) == 3
    assert any(set(pair) <= set(found.tolist()) for pair in combinations(range(4), 2))
    with pytest.raises(ValueError, match="cannot choose 5 medoids"):
        seed_medoids(distances, np.ones(4), 5, np.random.default_rng(0))
