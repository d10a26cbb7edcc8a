"""MoF, Edit and F1@k on cases worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from core.errors import AnalysisError
from core.evaluation.action_segmentation import (
    edit_score,
    f1_counts,
    levenshtein,
    many_to_one,
    one_to_one,
    runs_of,
    score_segmentation,
)
from core.mocap.clip import Label, Segment


def labels(*rows):
    return tuple(Label(*row) for row in rows)


def test_levenshtein_and_edit():
    assert levenshtein("kitten", "sitting") == 3
    assert levenshtein([], [1, 2]) == 2 and levenshtein([1, 2], [1, 2]) == 0
    assert edit_score([1, 2, 1], [1, 2]) == pytest.approx(100 * 2 / 3)
    assert edit_score([], []) == 0


def test_f1_counts_take_each_true_segment_once():
    true = [(0, 0, 10), (1, 10, 20)]
    assert f1_counts([(0, 0, 5), (0, 5, 10), (1, 10, 20)], true, 0.5) == (2, 1, 0)
    assert f1_counts([(0, 0, 4), (0, 4, 10), (1, 10, 20)], true, 0.5) == (2, 1, 0)
    assert f1_counts([(0, 0, 4)], true, 0.5) == (0, 1, 2)
    assert f1_counts([(1, 0, 10)], true, 0.1) == (0, 1, 2)
    assert f1_counts([], true, 0.1) == (0, 0, 2) and f1_counts([(0, 0, 3)], [], 0.1) == (0, 1, 0)


def test_matching_of_classes_with_actions():
    table = np.array([[9, 3], [8, 0], [0, 0]])
    assert one_to_one(table).tolist() == [1, 0, 4]  # 3 + 8 frames; 9 + 0 are fewer
    assert many_to_one(table).tolist() == [0, 0, 4]
    assert one_to_one(np.array([[9, 0], [7, 0]])).tolist() == [0, 3]  # an action without a common frame is none


def test_runs_leave_out_nothing():
    assert runs_of(np.array([1, 1, -1, 1, 2])) == [(1, 0, 2), (1, 3, 4), (2, 4, 5)]
    assert runs_of(np.zeros(0, int)) == []


def test_scores_by_hand():
    """Clip of 20 frames, ten of walk and ten of jump, in three classes of 8, 6 and 6 frames."""
    truth = labels(("a", 0, 10, "walk"), ("a", 10, 20, "jump"))
    found = ((Segment("a", 0, 8),), (Segment("a", 14, 20),), (Segment("a", 8, 14),))
    scores = score_segmentation(found, truth)
    # one to one: walk (8 frames), jump (6 frames) and in between a class of its own: distance 1 of 3;
    # walk overlaps by .8, jump by .6, the other is wrong: 2 right, 1 wrong, none missed
    assert scores.one_to_one == (70.0, pytest.approx(100 * 2 / 3), pytest.approx((80, 80, 80)))
    # many to one: that class is jump too, so two of its frames are wrong; walk overlaps by .8, jump by 10 / 12
    assert scores.many_to_one == (90.0, 100.0, (100.0, 100.0, 100.0))
    assert (scores.clips, scores.missing, scores.frames, scores.actions, scores.classes) == (1, 0, 20, 2, 3)


def test_f1_falls_where_more_overlap_is_asked_for():
    truth = labels(("a", 0, 10, "walk"), ("a", 10, 20, "jump"))
    scores = score_segmentation(((Segment("a", 0, 4),), (Segment("a", 10, 12),)), truth)
    assert scores.one_to_one == (30.0, 100.0, (100.0, 50.0, 0.0))  # overlaps .4 and .2


def test_frames_without_label_are_left_out_and_without_class_are_wrong():
    truth = labels(("a", 0, 10, "walk"), ("a", 30, 40, "walk"), ("b", 0, 10, "walk"))
    found = ((Segment("a", 0, 35),),)
    scores = score_segmentation(found, truth)
    # clip b has no segment and does not count; in a, 10 + 5 of 20 frames; one run of walk against one of 20
    assert scores.one_to_one == (75.0, 100.0, (100.0, 100.0, 100.0))
    assert scores.missing == 1 and scores.frames == 20


def test_a_clip_may_match_classes_differently():
    truth = labels(("a", 0, 10, "walk"), ("b", 0, 8, "jump"))
    found = ((Segment("a", 0, 10), Segment("b", 0, 8)),)
    scores = score_segmentation(found, truth)
    assert scores.one_to_one.mof == pytest.approx(100 * 10 / 18) and scores.one_to_one.edit == 50
    assert scores.clip_one_to_one == (100.0, 100.0, (100.0, 100.0, 100.0))


def test_perfect_and_nothing():
    truth = labels(("a", 0, 10, "walk"), ("a", 10, 20, "jump"), ("a", 20, 30, "walk"))
    found = ((Segment("a", 10, 20),), (Segment("a", 0, 10), Segment("a", 20, 30)))
    assert score_segmentation(found, truth).one_to_one == (100.0, 100.0, (100.0, 100.0, 100.0))
    with pytest.raises(AnalysisError, match="no labels"):
        score_segmentation(found, ())
    with pytest.raises(AnalysisError, match="no clip"):
        score_segmentation(((Segment("b", 0, 3),),), truth)


def test_order_of_classes_does_not_matter():
    rng = np.random.default_rng(0)
    truth = tuple(Label("a", 10 * k, 10 * k + 10, "xyz"[k % 3]) for k in range(30))
    cuts = np.sort(rng.choice(np.arange(1, 300), 40, replace=False)).tolist()
    pieces = [Segment("a", a, b) for a, b in zip([0, *cuts], [*cuts, 300], strict=True)]
    owner = rng.integers(5, size=len(pieces))
    classes = [tuple(p for p, k in zip(pieces, owner, strict=True) if k == c) for c in range(5)]
    assert score_segmentation(classes, truth).many_to_one == score_segmentation(classes[::-1], truth).many_to_one
    mof = score_segmentation(classes, truth).one_to_one.mof
    assert mof == score_segmentation(classes[::-1], truth).one_to_one.mof
