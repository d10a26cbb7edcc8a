"""Local alignment against brute force, windows, pairs; propagation worked out by hand."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.poses.body_parts import LEAVES, NODES, leaves_of, normalise_weights
from core.retrieval.part_matching import aligned_pairs, gains, own_share, places, propagate, window_scores

GAP = 0.5
EVEN = dict.fromkeys(LEAVES, 0.1)
symbols = st.lists(st.integers(0, 3), min_size=1, max_size=6)
tables = st.integers(0, 10_000).map(lambda seed: np.random.default_rng(seed).uniform(-1, 1, (5, 4)).astype(np.float32))


def best_alignment(found: list[int], gain: np.ndarray) -> float:
    """The best score of all ways to pair symbols in order, gaps between the first and last pair paid for."""
    best = 0.0
    m, n = len(gain), len(found)
    for k in range(1, min(m, n) + 1):
        for rows in itertools.combinations(range(m), k):
            for columns in itertools.combinations(range(n), k):
                paired = sum(float(gain[i, found[j]]) for i, j in zip(rows, columns, strict=True))
                unpaired = (rows[-1] - rows[0] + 1 - k) + (columns[-1] - columns[0] + 1 - k)
                best = max(best, paired - GAP * unpaired)
    return best


@settings(max_examples=40)
@given(symbols, tables)
def test_scores_pairs_and_places_are_the_best_of_all_alignments(found, gain):
    expected = best_alignment(found, gain)
    array = np.array(found, np.int32)
    whole = np.array([0]), np.array([len(found)])
    score = window_scores(array, *whole, gain, GAP)[0]
    assert score == pytest.approx(expected / np.sqrt(len(gain) * len(found)), abs=1e-5)
    there = places(array, *whole, gain, GAP)
    assert there.score.max() == pytest.approx(expected, abs=1e-5)
    pairs = aligned_pairs(array, gain, GAP)
    if expected == 0:
        assert len(pairs) == 0
        return
    paired = sum(float(gain[i, found[j]]) for i, j in pairs)
    unpaired = np.ptp(pairs, axis=0).sum() + 2 - 2 * len(pairs)
    assert paired - GAP * unpaired == pytest.approx(expected, abs=1e-5)
    end = int(there.score.argmax())
    again = window_scores(array, there.start[end : end + 1], np.array([end + 1]), gain, GAP)[0]
    assert again * np.sqrt(len(gain) * (end + 1 - there.start[end])) == pytest.approx(expected, abs=1e-5)


@given(st.lists(symbols, min_size=1, max_size=4), tables)
def test_windows_do_not_see_one_another(lists, gain):
    array = np.concatenate(lists).astype(np.int32)
    ends = np.cumsum([len(found) for found in lists])
    starts = ends - [len(found) for found in lists]
    alone = [window_scores(np.array(s, np.int32), np.array([0]), np.array([len(s)]), gain, GAP)[0] for s in lists]
    np.testing.assert_allclose(window_scores(array, starts, ends, gain, GAP), alone)
    there = places(array, starts, ends, gain, GAP)
    for start, end in zip(starts, ends, strict=True):
        assert (there.start[start:end][there.score[start:end] > 0] >= start).all()


def test_equal_lists_score_one_and_an_empty_window_nothing():
    distances = 1 - np.eye(4)
    query = np.array([0, 2, 1, 2, 3])
    gain = gains(distances[query], tolerance=0.5)
    array = np.array([3, *query, 0], np.int32)
    scores = window_scores(array, np.array([1, 3, 0]), np.array([6, 3, 7]), gain, GAP)
    assert scores[0] == pytest.approx(1) and scores[1] == 0 and 0 < scores[2] < 1
    there = places(array, np.array([0]), np.array([7]), gain, GAP)
    assert (there.start[5], there.query_start[5], there.query_end[5]) == (1, 0, 5)


def test_gains_fall_from_one_to_minus_one():
    assert gains(np.array([[0, 0.25, 0.5, 1.0, 3.0]]), 0.5).tolist() == [[1, 0.5, 0, -1, -1]]
    with pytest.raises(ValueError, match="positive"):
        gains(np.zeros((1, 1)), 0)


def some_scores(seed: int = 0) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    return {node: rng.uniform(size=3) for node in NODES}


def test_propagation_with_equal_weights_is_the_papers():
    """PCR 4.1's own example: the right foot and right leg, half each, then alpha of their parent's score."""
    s, alpha = some_scores(), 0.5
    limbs = {}
    for node, below in (
        ("head_torso", ("head", "torso")),
        *((f"{side}_{a}_{b}", (f"{side}_{a}", f"{side}_{b}")) for side in ("left", "right") for a, b in
          (("arm", "hand"), ("leg", "foot"))),
    ):  # fmt: skip
        limbs[node] = alpha * s[node] + (1 - alpha) * (s[below[0]] / 2 + s[below[1]] / 2)
    upper = (
        alpha * s["upper_body"]
        + (1 - alpha) * sum(limbs[n] for n in ("head_torso", "left_arm_hand", "right_arm_hand")) / 3
    )
    lower = alpha * s["lower_body"] + (1 - alpha) * (limbs["left_leg_foot"] + limbs["right_leg_foot"]) / 2
    expected = alpha * s["whole_body"] + (1 - alpha) * (upper + lower) / 2
    np.testing.assert_allclose(propagate(s, EVEN, alpha), expected)


@pytest.mark.parametrize("leaf", LEAVES)
def test_a_leaf_without_weight_and_all_that_holds_it_has_no_influence(leaf):
    weights = normalise_weights({other: 1.0 for other in LEAVES if other != leaf})
    s = some_scores()
    changed = {node: score + (leaf in leaves_of(node)) for node, score in s.items()}
    assert np.array_equal(propagate(s, weights, 0.5), propagate(changed, weights, 0.5))
    only = propagate(s, normalise_weights({leaf: 1}), 0.5)
    np.testing.assert_allclose(only, s[leaf])


def test_the_papers_weights_give_the_arms_and_legs_their_ratio():
    """35 % left arm, 45 % right arm: between the two arms alone 35 to 45 remains."""
    s = some_scores()
    found = propagate(s, normalise_weights({"left_arm": 0.35, "right_arm": 0.45}), 0.5)
    np.testing.assert_allclose(found, (0.35 * s["left_arm"] + 0.45 * s["right_arm"]) / 0.8)


def test_a_node_that_is_not_scored_hands_on_its_children():
    s = some_scores()
    arms = {node: s[node] for node in ("left_arm", "left_hand", "left_arm_hand", "right_leg")}
    weights = normalise_weights(dict.fromkeys(("left_arm", "left_hand", "right_leg"), 1.0))
    limb = 0.5 * s["left_arm_hand"] + 0.25 * (s["left_arm"] + s["left_hand"])
    upper, lower = 2 / 6, 1 / 4  # mean weights below, in thirds
    expected = (upper * limb + lower * s["right_leg"]) / (upper + lower)
    np.testing.assert_allclose(propagate(arms, weights, 0.5), expected)
    with pytest.raises(ValueError, match="none of the parts"):
        propagate({"whole_body": s["whole_body"]}, EVEN, 0.5)


def test_a_nodes_own_share_fades_with_its_least_weight():
    assert own_share("whole_body", EVEN, 0.3) == pytest.approx(0.3)
    assert own_share("left_arm_hand", normalise_weights({"left_arm": 3, "left_hand": 1}), 0.3) == pytest.approx(0.15)
    assert own_share("left_arm_hand", normalise_weights({"left_arm": 1}), 0.3) == 0
    assert own_share("left_arm", normalise_weights({"left_arm": 1}), 0.3) == 1
