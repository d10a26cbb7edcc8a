"""The paper's own search: genetic on a grid, then slide and resize."""

from __future__ import annotations

from itertools import pairwise, product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.demo import make_demo
from core.grammar.fine_tuning import _State, fine_tune
from core.grammar.genetic import GeneticSettings, _stretches, genetic_spans, pam
from core.grammar.identification import find_terminals
from core.grammar.objective import clustering_of, span_distances
from core.grammar.parameters import TerminalParameters
from tests.core.grammar import naive


def repeated(rng, order=(0, 1, 2, 1, 0, 2, 2, 1), length=6, noise=0.1):
    """A space in which three motions recur."""
    motions = rng.normal(size=(3, length, 2))
    values = np.concatenate([motions[i] for i in order])
    return naive.toy_space(values + noise * rng.normal(size=values.shape))


def score(space, spans, k, weight):
    distances = span_distances(space, spans)
    medoids = pam(distances, k)
    return clustering_of(spans, medoids, distances[:, medoids]).objective(space, weight)["F"]


def test_the_genetic_search_finds_the_best_cuts_on_the_grid():
    space = repeated(np.random.default_rng(0), order=(0, 1, 2, 1, 0))
    grid, limits = 3, (3, 12)
    places = np.arange(grid, space.n - limits[0] + 1, grid)
    best = 0.0
    for chosen in product([False, True], repeat=len(places)):
        cuts = [0, *places[list(chosen)], space.n]
        spans = np.array(list(pairwise(cuts)))
        if np.diff(spans).max() <= limits[1] and len(spans) >= 3:
            best = max(best, score(space, spans, 3, 0.2))
    found = genetic_spans(space, 3, 0.2, limits, np.random.default_rng(1), GeneticSettings(grid, 30, 40))
    assert score(space, found, 3, 0.2) == pytest.approx(best, rel=1e-5)


@given(st.integers(0, 1000), st.integers(1, 9))
@settings(max_examples=20)
def test_genetic_spans_lie_on_the_grid_and_within_limits(seed, grid):
    rng = np.random.default_rng(seed)
    lengths = rng.integers(1, 60, 3)
    space = naive.toy_space(rng.normal(size=(lengths.sum(), 2)), [0, *np.cumsum(lengths)])
    spans = genetic_spans(space, 4, 0.1, (4, 20), rng, GeneticSettings(grid, 4, 2))
    assert spans[0, 0] == 0 and spans[-1, 1] == space.n and (spans[1:, 0] == spans[:-1, 1]).all()
    assert set(space.clip_starts.tolist()) <= {0, *spans[:, 1].tolist()}
    for start, end in spans:
        clip = np.searchsorted(space.clip_starts, start, side="right") - 1
        assert (start - space.clip_starts[clip]) % grid == 0
        assert end - start >= 4 or end - start == lengths[clip]
        assert end - start <= 20 + grid or lengths[clip] < 8


def test_long_recordings_are_searched_stretch_by_stretch():
    space = naive.toy_space(np.zeros((700, 1)), [0, 40, 660, 700])
    stretches = _stretches(space, 2, (4, 20))
    assert len(stretches) > 1
    places = [p for stretch in stretches for piece in stretch for p in piece.tolist()]
    assert places[0] == 0 and places[-1] == 700 and places == sorted(places)
    shares = []
    report = lambda stage, share: shares.append(share)  # noqa: E731
    genetic_spans(space, 4, 0.1, (4, 20), np.random.default_rng(0), GeneticSettings(2, 4, 2), report)
    assert shares == sorted(shares) and shares[0] >= 0 and shares[-1] < 1


@pytest.mark.parametrize("annealing", [False, True])
def test_fine_tuning_only_improves(annealing):
    space = repeated(np.random.default_rng(2))
    rng = np.random.default_rng(5)
    spans = np.array(list(pairwise([0, 5, 14, 20, 23, 30, 37, 41, 48])))
    before = score(space, spans, 3, 0.2)
    found = fine_tune(space, spans, 3, 0.2, (3, 12), rng, iterations=400, furthest=4, annealing=annealing)
    after = found.objective(space, 0.2)["F"]
    assert after > 1.02 * before
    assert (found.lengths >= 3).all() and (found.lengths <= 12).all()
    spans, own = [tuple(span) for span in found.spans.tolist()], found.medoids[found.labels]
    apart = [naive.distance(space.values, span, spans[m]) for span, m in zip(spans, own, strict=True)]
    true = found.lengths @ np.array(apart)
    assert found.objective(space, 0.2)["E"] == pytest.approx(true / space.n / space.largest, rel=1e-3)


def test_a_step_undone_leaves_no_trace():
    rng = np.random.default_rng(8)
    space = repeated(rng)
    state = _State(space, np.array(list(pairwise(range(0, 49, 6)))), 3, 0.2, (2, 12))
    tried = 0
    for _ in range(60):
        kept = state.spans.copy(), state.distances.copy(), state.labels.copy(), state.medoids.copy(), state.cost
        changed = state.moved(int(rng.integers(8)), int(rng.integers(1, 4)), bool(rng.integers(2)))
        before = state.apply(changed) if changed else None
        if before is None:
            continue
        tried += 1
        assert np.allclose(state.distances, span_distances(space, state.spans), atol=1e-6)
        state.undo(before)
        for now, then in zip(
            (state.spans, state.distances, state.labels, state.medoids, state.cost), kept, strict=True
        ):
            assert np.array_equal(now, then)
    assert tried > 20


def test_clips_keep_their_ends_in_fine_tuning():
    rng = np.random.default_rng(1)
    space = naive.toy_space(rng.normal(size=(40, 2)), [0, 17, 40])
    spans = np.array([(0, 5), (5, 11), (11, 17), (17, 23), (23, 30), (30, 40)])
    found = fine_tune(space, spans, 2, 0.1, (2, 15), rng, iterations=300, furthest=5)
    assert 17 in found.spans[:, 0] and not np.array_equal(found.spans, spans)
    with pytest.raises(ValueError, match="only 6 segments for 7"):
        fine_tune(space, spans, 7, 0.1, (2, 15), rng)


@pytest.mark.parametrize("method", ["paper", "annealing"])
def test_the_papers_way_from_end_to_end(method):
    stages = set()
    demo = make_demo(minutes=0.3)
    parameters = TerminalParameters(n_terminals=6, method=method, generations=5, population=10, iterations=50)
    terminals = find_terminals(demo, parameters, lambda stage, share: stages.add(stage))
    assert terminals.n_terminals == 6 and {"genetic search", "fine tuning"} <= stages
    assert sum(s.n_frames for segments in terminals.segments for s in segments) == demo.n_frames
