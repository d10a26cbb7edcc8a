"""The study's numbers, each checked against one worked out by hand or by definition."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import kendalltau, spearmanr

from core.evaluation.agreement import Rating, Vote, agreement, wilson, win_rates
from core.mocap.clip import Segment

QUERY = Segment("q", 0, 100)


def hit(k: int) -> Segment:
    return Segment(f"clip {k}", 0, 50)


def rated(values, engine="parts", query=QUERY, person="") -> list[Rating]:
    """One person's ratings of an engine's hits, in its order."""
    return [Rating(query, hit(k), engine, k + 1, value, person) for k, value in enumerate(values)]


def test_table_4_is_mean_and_standard_deviation_per_engine_and_query():
    found = agreement(rated([9, 7, 5], person="ann") + rated([7, 7, 1], person="bob") + rated([2], "printed"))
    spread = found.by_query["parts", QUERY]
    assert spread.mean == pytest.approx(6.0) and spread.ratings == 6
    assert spread.deviation == pytest.approx(math.sqrt((9 + 1 + 1 + 1 + 1 + 25) / 5))
    assert found.overall["printed"] == (2.0, 0.0, 1)


def test_table_5_is_plus_one_for_agreement_and_minus_one_for_the_contrary():
    up, down = agreement(rated([9, 7, 5, 3])), agreement(rated([3, 5, 7, 9]))
    assert up.query_correlations["parts", QUERY].spearman == pytest.approx(1)
    assert up.correlations["parts"].kendall == pytest.approx(1) and up.correlations["parts"].pairs == 4
    assert down.correlations["parts"].spearman == pytest.approx(-1)


def test_the_papers_coefficients_are_those_of_six_ranks():
    """PCR Table 5 has .9428 and .8285: Spearman's of six places with squared differences of 2 and 6."""
    swapped = agreement(rated([10, 9, 8, 7, 5, 6])).correlations["parts"]
    assert swapped.spearman == pytest.approx(1 - 6 * 2 / (6 * 35)) and round(swapped.spearman, 4) == 0.9429
    assert swapped.kendall == pytest.approx(1 - 2 / 15)
    low, high = swapped.spearman_interval
    assert low < swapped.spearman <= high <= 1


@given(st.permutations(range(7)))
def test_coefficients_agree_with_their_definitions(order):
    found = agreement(rated([10 - place for place in order]), samples=2).correlations["parts"]
    squared = sum((k - place) ** 2 for k, place in enumerate(order))
    assert found.spearman == pytest.approx(1 - 6 * squared / (7 * 48))
    pairs = list(itertools.combinations(range(7), 2))
    concordant = sum(order[a] < order[b] for a, b in pairs)
    assert found.kendall == pytest.approx(2 * concordant / len(pairs) - 1)


def test_too_few_pairs_have_no_coefficient():
    found = agreement(rated([9, 3])).correlations["parts"]
    assert math.isnan(found.spearman) and math.isnan(found.kendall_interval[0]) and found.pairs == 2
    assert agreement(rated([9, 3])).to_json()["engines"]["parts"]["spearman"] is None


def test_figure_6_has_ranks_within_the_query_and_the_spread_of_the_ratings():
    points = agreement(rated([5, 9, 5], person="a") + rated([5, 7, 5], person="b")).points
    assert [(p.computer_rank, p.human_rank) for p in points] == [(1, 2.5), (2, 1.0), (3, 2.5)]
    assert [p.variance for p in points] == [0, 2, 0] and points[1].mean_rating == 8


def test_a_changed_rating_counts_once_and_ranges_are_checked():
    assert agreement([*rated([2]), *rated([8])]).overall["parts"] == (8.0, 0.0, 1)
    for bad in (Rating(QUERY, hit(0), "parts", 1, 11), Rating(QUERY, hit(0), "parts", 0, 5)):
        with pytest.raises(ValueError, match="1 to 10"):
            agreement([bad])


def test_no_ratings_are_an_empty_study():
    assert agreement([]).to_json() == {"engines": {}, "queries": [], "points": []}


def votes(*choices, left="parts", right="printed", ranks=(1, 1)) -> list[Vote]:
    return [Vote(QUERY, hit(2 * k), hit(2 * k + 1), left, right, *ranks, c) for k, c in enumerate(choices)]


def test_win_rates_count_the_side_an_engine_was_on_and_half_for_the_same():
    found = win_rates(votes("left", "left", "same") + votes("right", left="printed", right="bounded-edit"))
    assert found.pairs["parts", "printed"].share == pytest.approx(2.5 / 3)
    assert found.pairs["printed", "parts"].share == pytest.approx(0.5 / 3)
    assert found.engines["printed"][::3] == (pytest.approx(0.5 / 4), 4)
    assert found.engines["bounded-edit"].share == 1 and found.higher_ranked == {}


def test_votes_within_an_engine_say_whether_its_order_is_people_s():
    found = win_rates(votes("left", "right", right="parts", ranks=(1, 5)))
    assert found.higher_ranked["parts"].share == 0.5 and found.engines == {}


def test_turning_the_sides_round_changes_nothing_and_the_last_vote_counts():
    one = Vote(QUERY, hit(0), hit(1), "parts", "printed", 1, 2, "left")
    turned = Vote(QUERY, hit(1), hit(0), "printed", "parts", 2, 1, "right")
    assert win_rates([one]) == win_rates([turned]) == win_rates([one._replace(choice="right"), turned])
    with pytest.raises(ValueError, match="left, right or same"):
        win_rates([one._replace(choice="up")])


def test_wilson_contains_the_share_and_narrows():
    few, many = wilson([1, 1, 0, 1]), wilson([1, 1, 0, 1] * 50)
    assert few.low < 0.75 < few.high and many.high - many.low < few.high - few.low
    assert wilson([1] * 8).high == pytest.approx(1) and np.isnan(wilson([]).share)


@given(st.lists(st.integers(1, 10), min_size=3, max_size=9).filter(lambda values: len(set(values)) > 1))
def test_coefficients_with_ties_agree_with_scipy(values):
    found = agreement(rated(values), samples=2).correlations["parts"]
    ranks = np.arange(len(values))
    assert found.spearman == pytest.approx(spearmanr(ranks, -np.array(values)).statistic)
    assert found.kendall == pytest.approx(kendalltau(ranks, -np.array(values)).statistic)
