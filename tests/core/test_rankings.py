"""Rankings by several engines as a job: kept without labels, scored with them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.demo import make_demo
from core.methods import METHODS
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.progress import Cancelled
from core.rankings import KNOWN, RankingParameters, evaluate, rank_dataset


@pytest.fixture(scope="module")
def dataset():
    """Cuts of the demo's labelled actions, each performer a style."""
    demo = make_demo(minutes=2)
    clips, labels, counts = [], [], {}
    for label in demo.labels:
        if label.end - label.start >= 60 and counts.setdefault(label.action, 0) < 4:
            counts[label.action] += 1
            name = f"{label.clip}_{label.start}"
            clips.append(demo.clip(label.clip).cut(label.start, label.end, name))
            labels.append(Label(name, 0, clips[-1].n_frames, f"{label.action}/{label.clip.split('_')[0]}"))
    kept = [k for k, label in enumerate(labels) if counts[label.action.split("/")[0]] > 1][:14]
    return Dataset("actions", tuple(clips[k] for k in kept), tuple(labels[k] for k in kept))


def test_engines_baselines_and_chance_are_ranked_and_scored(dataset):
    told = []
    rankings = rank_dataset(
        dataset, RankingParameters(engines=",".join(KNOWN)), lambda stage, share: told.append((stage, share))
    )
    n = len(dataset.clips)
    assert tuple(rankings.orders) == KNOWN and set(rankings.seconds) == set(KNOWN)
    for order in rankings.orders.values():
        assert order.shape == (n, n - 1)
        assert all(sorted([*row, k]) == list(range(n)) for k, row in enumerate(order))
    assert {stage.split(":")[0] for stage, _ in told} == set(KNOWN) - {"chance"}
    assert all(0 <= share <= 1 for _, share in told)
    found = evaluate(rankings, dataset)
    scores = {name: regimes["ALL"].measures["mAP"].mean for name, regimes in found.engines.items()}
    assert scores["parts"] > scores["chance"] and scores["bounded-edit"] > scores["chance"]
    document = found.to_json()
    assert document["queries"] == n and set(document["engines"]) == set(KNOWN)
    one = document["engines"]["parts"]["ALL"]
    assert len(one["curve"]["recall"]) == len(one["curve"]["precision"])
    assert np.array(one["confusion"]["shares"]).shape == (len(one["confusion"]["contents"]),) * 2


def test_kept_rankings_are_scored_with_the_labels_of_the_day(dataset):
    method = METHODS["ranking"]
    rankings = rank_dataset(dataset, RankingParameters(engines="chance", queries=5))
    assert len(rankings.queries) == 5
    again = method.unpack(*method.pack(rankings, dataset))
    assert again.of("chance") == rankings.of("chance") and again.parameters == rankings.parameters
    relabelled = replace(dataset, labels=tuple(Label(c.name, 0, c.n_frames, "same") for c in dataset.clips))
    assert evaluate(again, relabelled).engines["chance"]["ALL"].measures["mAP"].mean == pytest.approx(1)
    with pytest.raises(ValueError, match="no clip that was searched for has a label"):
        evaluate(again, replace(dataset, labels=()))


def test_it_is_a_method_with_parameters_and_can_be_stopped(dataset):
    assert {p.name for p in analyses.parameters("ranking")} == {"engines", "queries", "seed"}

    def stop(stage, share):
        raise Cancelled

    with pytest.raises(Cancelled):
        rank_dataset(dataset, RankingParameters(engines="position-dtw"), stop)


@pytest.mark.parametrize("values", [{"engines": "best"}, {"engines": " ,"}, {"queries": 0}])
def test_what_cannot_be_ranked_is_refused_in_plain_words(values):
    with pytest.raises(ValueError, match=r"engine|queries"):
        RankingParameters(**values)


def test_one_clip_has_no_ranking(dataset):
    with pytest.raises(ValueError, match="two clips"):
        rank_dataset(Dataset("one", dataset.clips[:1]))
