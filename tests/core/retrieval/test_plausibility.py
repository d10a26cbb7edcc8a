"""Whether a hybrid looks like anything a body does."""

from __future__ import annotations

import numpy as np

from core.demo import make_demo
from core.retrieval.plausibility import ODD, plausibility
from core.retrieval.queries import hybrid_query, whole_query
from core.retrieval.search import build_search_index


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
