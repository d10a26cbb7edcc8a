"""Measures of rankings: by hand on a small case, against the judge's own script on made-up rankings."""

from __future__ import annotations

import importlib.util
import random
from dataclasses import replace

import numpy as np
import pytest

from core.evaluation.ranking import ClipLabels, clip_labels, score_rankings
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from tests.core.editing.figures import standing

CONTENTS = ("walk", "walk-left", "bow", "run", "bye")
STYLES = ("angry", "happy", "old")


def names() -> list[str]:
    return [f"dataset-1_{c}_{s}_{take:03}" for c in CONTENTS for s in STYLES for take in (1, 2)]


def labels_of(clips) -> ClipLabels:
    parts = {clip: clip.split("_") for clip in clips}
    return ClipLabels({c: p[1] for c, p in parts.items()}, {c: p[2] for c, p in parts.items()})


def test_measures_of_one_query_worked_out_by_hand():
    labels = ClipLabels(dict(q="a", x="a", y="a", z="b", w="b"), dict(q="s", x="s", y="t", z="s", w="t"))
    found = score_rankings({"q": ["z", "x", "w", "y"]}, labels)
    measures = found["ALL"].measures
    assert measures["mAP"].mean == pytest.approx((1 / 2 + 2 / 4) / 2)
    assert (measures["1-NN"].mean, measures["nP@20"].mean, measures["P@20"].mean) == (0, 1, 0.1)
    gained = 7 / np.log2(3) + 3 / np.log2(5)
    assert measures["nDCG@20"].mean == pytest.approx(gained / (7 + 3 / np.log2(3)))
    assert measures["styleAUC"].mean == 1
    assert found["ALL"].precision[0] == 0.5 and found["ALL"].precision[-1] == 0.5
    apart = found["XSTYLE"]  # without x: z, w, y
    assert apart.measures["mAP"].mean == pytest.approx(1 / 3) and "nDCG@20" not in apart.measures
    assert found["ALL"].confusion.tolist() == [[0.5, 0.5], [0, 0]] and apart.confusion.tolist() == [[0, 1], [0, 0]]


def test_what_is_missing_counts_as_not_found():
    labels = ClipLabels(dict(q="a", x="a", y="a", z="b"), {})
    found = score_rankings({"q": ["x"]}, labels)
    assert set(found) == {"ALL"} and found["ALL"].short == 1
    assert found["ALL"].measures["mAP"].mean == 0.5 and found["ALL"].precision[-1] == 0
    assert score_rankings({"q": []}, labels)["ALL"].measures["1-NN"].mean == 0
    assert score_rankings({"z": ["x"]}, labels)["ALL"].skipped == 1


def test_faulty_rankings_are_refused():
    labels = ClipLabels(dict(q="a", x="a"), {})
    with pytest.raises(ValueError, match="no label"):
        score_rankings({"x2": ["q"]}, labels)
    with pytest.raises(ValueError, match="twice"):
        score_rankings({"q": ["x", "x"]}, labels)


def test_it_agrees_with_the_judges_script(shared_data):
    path = shared_data.parent / "eval" / "eval_ranking.py"
    if not path.is_file():
        pytest.skip("the judge's script is not here")
    spec = importlib.util.spec_from_file_location("eval_ranking", path)
    judge = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(judge)
    clips, draw = names(), random.Random(3)
    rankings = {}
    for query in clips:
        others = [clip for clip in clips if clip != query]
        draw.shuffle(others)
        others.sort(key=lambda clip: (clip.split("_")[1] != query.split("_")[1]) * draw.random())
        rankings[query] = others[: draw.choice([3, 12, len(others)])]
    expected = judge.score(rankings, clips)
    found = score_rankings(rankings, labels_of(clips), coarse=judge.COARSE)
    for regime, measures in expected.items():
        ours = found[regime]
        counts = (ours.queries, ours.skipped, ours.short)
        assert counts == (measures["queries"], measures["skipped_R0"], measures["short_lists"])
        known = {name: value for name, value in measures.items() if isinstance(value, dict)}
        assert set(known) == set(ours.measures)
        for name, value in known.items():
            assert ours.measures[name].mean == pytest.approx(value["mean"], abs=1e-12), (regime, name)
            assert ours.measures[name].macro == pytest.approx(value["macro"], abs=1e-12)
            assert ours.measures[name].low == pytest.approx(value["lo"], abs=0.03)
            assert ours.measures[name].high == pytest.approx(value["hi"], abs=0.03)


def test_the_curve_falls_and_its_ends_are_those_of_the_list():
    clips = names()
    best = {q: sorted((c for c in clips if c != q), key=lambda c: c.split("_")[1] != q.split("_")[1]) for q in clips}
    found = score_rankings(best, labels_of(clips))["XSTYLE"]
    assert np.allclose(found.precision, 1) and np.allclose(found.confusion, np.eye(len(CONTENTS)))
    worst = score_rankings({q: found[::-1] for q, found in best.items()}, labels_of(clips))["ALL"]
    assert (np.diff(worst.precision) <= 1e-12).all() and worst.measures["mAP"].mean < 0.3
    assert worst.measures["mAP"].low <= worst.measures["mAP"].mean <= worst.measures["mAP"].high


def test_a_clip_has_the_label_of_most_of_its_frames_and_a_style_by_label_or_name():
    clips = [replace(standing(50), name=n) for n in ("dataset-1_walk_angry_001", "b", "walk_7", "unlabelled")]
    labels = (
        Label("dataset-1_walk_angry_001", 0, 10, "bow"),
        Label("dataset-1_walk_angry_001", 10, 40, "walk"),
        Label("b", 0, 5, "run/happy"),
        Label("walk_7", 0, 9, "walk"),
    )
    found = clip_labels(Dataset("made up", tuple(clips), labels))
    assert found.content == {"dataset-1_walk_angry_001": "walk", "b": "run", "walk_7": "walk"}
    assert found.style == {"dataset-1_walk_angry_001": "angry", "b": "happy"}
    assert not found.has_styles
