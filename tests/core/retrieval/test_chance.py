"""Distances as chances."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.demo import make_demo
from core.mocap.dataset import Dataset
from core.poses.body_parts import LEAVES
from core.progress import silent
from core.retrieval.chance import LEAST, chances, usual_distance
from core.retrieval.frames import FrameStore
from core.retrieval.metric import Metric
from core.retrieval.queries import whole_query
from core.retrieval.search import build_search_index


@pytest.fixture(scope="module")
def demo():
    return make_demo(minutes=2, seed=5)


@given(st.lists(st.floats(0, 1), min_size=2, max_size=20), st.floats(0.4, 1))
def test_chances_fall_with_the_distance_and_are_one_for_equal_motions(distances, usual):
    found = chances(np.array(distances), usual)
    assert ((found >= 0) & (found <= 1)).all()
    assert (np.diff(found[np.argsort(distances, kind="stable")]) <= 1e-12).all()
    assert chances(np.zeros(1), usual)[0] == pytest.approx(1)


def test_the_same_distance_says_less_where_everything_is_near():
    assert chances(np.array([0.3]), 0.8)[0] > chances(np.array([0.3]), 0.4)[0] + 0.2


def test_the_usual_distance_is_the_median_over_stretches_drawn_towards_the_typical_one(demo):
    store, metric = FrameStore.build(demo.clips, 30.0, silent), Metric(dict.fromkeys(LEAVES, 1 / len(LEAVES)))
    n = 60
    query = metric.motions(store, store.codes, np.array([100]), np.array([100 + n]))
    every = []
    for k in range(len(store.clips)):
        first, last = store.starts[k], store.starts[k + 1]
        starts = np.arange(first, max(first + 1, last - n))
        every.append(metric.distances(query, metric.motions(store, store.codes, starts, np.minimum(starts + n, last))))
    held = len(store.codes) / n  # stretches as long as the query
    wanted = (held * np.median(np.concatenate(every)) + 30 * 0.7) / (held + 30)
    assert usual_distance(store, metric, query, n) == pytest.approx(wanted, abs=0.04)


def test_one_more_clip_in_a_small_collection_hardly_changes_what_others_score(demo):
    walks = [label for label in demo.labels if label.action in ("walk", "run")][:8]
    clips = tuple(demo.clip(w.clip).cut(w.start, w.end, f"{k}") for k, w in enumerate(walks))
    roll = next(label for label in demo.labels if label.action in ("roll", "jump", "cartwheel"))
    odd = demo.clip(roll.clip).cut(roll.start, roll.end, "odd")
    before, after = (
        {hit.segment.clip: hit.score for hit in build_search_index(Dataset("few", few)).search(whole_query(clips[0]))}
        for few in (clips, (*clips, odd))
    )
    assert len(before) >= 6 and all(abs(after[name] - score) < 0.06 for name, score in before.items())


def test_hits_of_the_same_action_are_likely_and_others_are_not(demo):
    index = build_search_index(demo)
    kicks = [label for label in demo.labels if label.action == "kick"]
    query = whole_query(demo.clip(kicks[0].clip), kicks[0].start, kicks[0].end)
    hits = index.search(query, level="interval")
    assert hits[0].score > 0.95 and all(hit.score >= LEAST for hit in hits)
    everything = index.search(query, level="interval", top=40)
    assert len(everything) > len(hits) and min(hit.score for hit in everything) < LEAST
    likely = [hit for hit in everything if hit.score > 0.5]

    def is_kick(hit):
        return any(
            k.clip == hit.segment.clip and min(k.end, hit.segment.end) - max(k.start, hit.segment.start) > 0
            for k in kicks
        )

    assert len(likely) >= min(3, len(kicks)) and np.mean([is_kick(hit) for hit in likely]) > 0.9
