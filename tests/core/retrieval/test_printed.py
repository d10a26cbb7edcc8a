"""Algorithm 2 as printed, traced by hand; the failure function against its definition."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.retrieval.printed import algorithm_2, next_values, scan

A, B, C, D = range(4)
NEAR = np.array(  # A and B are a quasi-match at a tolerance of 0.02
    [
        [0.00, 0.01, 0.50, 1.00],
        [0.01, 0.00, 0.40, 0.90],
        [0.50, 0.40, 0.00, 0.30],
        [1.00, 0.90, 0.30, 0.00],
    ]
)


def test_algorithm_2_traced_by_hand():
    """S = C A B A C, Q = A B A D, MinConNum 2, weight 1; nextval(Q) = -1 0 -1 1.

    i j  S Q  D     MatchCount  Score
    0 0  C A  .50   0           -.50      nextval[0] = -1: i = 1, j = 0
    1 0  A A  0     1           -.50
    2 1  B B  0     2           +.50      two in a row: + 1
    3 2  A A  0     3           +1.50     + 1
    4 3  C D  .30   0           +1.20     nextval[3] = 1: j = 1
    4 1  C B  .40   0           +.80      nextval[1] = 0: j = 0
    4 0  C A  .50   0           +.30      nextval[0] = -1: i = 5, the end
    Score / Length(S) = .30 / 5
    """
    query = np.array([A, B, A, D])
    assert next_values(query).tolist() == [-1, 0, -1, 1]
    found = algorithm_2(np.array([C, A, B, A, C]), query, NEAR, min_con_num=2)
    assert found == pytest.approx(0.30 / 5)


def test_the_scan_stops_where_the_query_ends():
    """S = A B C A B, Q = A B, MinConNum 2: 1 after the second symbol; the third would read Q[2], which is not there."""
    assert algorithm_2(np.array([A, B, C, A, B]), np.array([A, B]), NEAR, min_con_num=2) == pytest.approx(1 / 5)


def test_quasi_matches_count_and_weight_scales_the_gain_alone():
    """S = B A C, Q = A B D: two quasi-matches (.01 each), then C against D costs .3, C against A (nextval 0) .5, C

    against A again nothing: nextval[0] = -1 ends it. nextval(Q) = -1 0 0.
    """
    query = np.array([A, B, D])
    assert next_values(query).tolist() == [-1, 0, 0]
    for weight in (0.0, 1.0, 2.5):
        found = algorithm_2(np.array([B, A, C]), query, NEAR, weight=weight, min_con_num=2)
        assert found == pytest.approx((weight - 0.3 - 0.5) / 3)


def test_what_is_wrong_with_it_stands_as_printed():
    """Fewer symbols than MinConNum never score; a query that only comes later in the source is still found so."""
    same = np.array([A, B, C, D])
    assert algorithm_2(same, same, NEAR) == 0
    assert algorithm_2(np.array([D, D, *same, A]), np.array([*same, A]), NEAR) == pytest.approx((1 - 1 - 1) / 7)


@given(st.lists(st.integers(0, 2), min_size=1, max_size=12))
def test_next_values_are_the_longest_border_with_another_symbol_after_it(symbols):
    found = next_values(np.array(symbols))
    for j in range(len(symbols)):
        borders = [k for k in range(j) if symbols[:k] == symbols[j - k : j] and symbols[k] != symbols[j]]
        assert found[j] == max(borders, default=-1)


@given(st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=9), min_size=1, max_size=5))
def test_a_scan_of_many_lists_is_each_of_them(lists):
    starts = np.concatenate([[0], np.cumsum([len(found) for found in lists])])
    query = np.array([A, C, A, B])
    found = scan(np.concatenate(lists).astype(np.int32), starts, query, NEAR, min_con_num=2, max_tolerance=0.3)
    expected = [algorithm_2(np.array(s), query, NEAR, min_con_num=2, max_tolerance=0.3) for s in lists]
    np.testing.assert_allclose(found, expected)


def test_an_empty_list_is_refused():
    with pytest.raises(ValueError, match="at least one"):
        algorithm_2(np.array([]), np.array([A]), NEAR)
