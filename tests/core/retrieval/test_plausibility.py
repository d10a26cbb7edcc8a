"""Whether a hybrid looks like anything a body does."""

from __future__ import annotations

import numpy as np

from core.demo import make_demo
from core.poses.body_parts import LEAVES
from core.retrieval.compose import compose
from core.retrieval.descriptors import BLOCKS
from core.retrieval.plausibility import ODD, plausibility
from core.retrieval.queries import hybrid_query, whole_query
from core.retrieval.search import build_search_index


def test_halves_of_one_stretch_are_that_stretch_even_where_the_recording_was_opened_twice():
    demo, again = make_demo(minutes=1), make_demo(minutes=1)
    index = build_search_index(demo)
    store, equal = index.engine.store, dict.fromkeys(LEAVES, 0.1)
    halves = {"upper_body": (demo.clips[0], 30, 200), "lower_body": (again.clips[0], 30, 200)}
    query = hybrid_query(halves)
    assert not query.hybrid and plausibility(index, query).ratio == 0
    whole = compose(store, whole_query(demo.clips[0], 30, 200), equal)
    assert np.array_equal(compose(store, query, equal).codes, whole.codes)


def test_parts_of_one_recording_keep_their_time():
    clip = make_demo(minutes=1).clips[0]
    store, equal = build_search_index(make_demo(minutes=1)).engine.store, dict.fromkeys(LEAVES, 0.1)
    shifted = compose(store, hybrid_query({"upper_body": (clip, 40, 140), "lower_body": (clip, 30, 130)}), equal).codes
    upper, lower = (compose(store, whole_query(clip, s, s + 100), equal).codes for s in (40, 30))
    arm, leg = BLOCKS["left_arm"], BLOCKS["left_leg"]
    assert np.array_equal(shifted[:, arm], upper[:, arm]) and np.array_equal(shifted[:, leg], lower[:, leg])


def test_real_motion_is_plausible_and_an_odd_combination_is_not():
    demo = make_demo(minutes=2)
    index = build_search_index(demo)
    real = plausibility(index, whole_query(demo.clips[0], 0, 200))
    assert real.ratio < 1 and real.message is None
    same = plausibility(
        index, hybrid_query({"upper_body": (demo.clips[0], 0, 200), "lower_body": (demo.clips[0], 0, 201)})
    )
    assert same.ratio < ODD and same.message is None
    by_action = {label.action: label for label in demo.labels}
    roll, run = (demo.clip(by_action[a].clip) for a in ("roll", "run"))
    odd = plausibility(
        index,
        hybrid_query(
            {
                "upper_body": (roll, by_action["roll"].start, by_action["roll"].end),
                "lower_body": (run, by_action["run"].start, by_action["run"].end),
            }
        ),
    )
    assert odd.ratio > ODD and "No recording" in odd.message and np.isfinite(odd.ratio)
