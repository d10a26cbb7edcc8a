"""Frame accuracy and boundaries on cases worked out by hand."""

from __future__ import annotations

import pytest

from core.evaluation.segmentation import (
    boundaries_of,
    boundary_intervals,
    confusion,
    frame_accuracy,
    score_boundaries,
)
from core.mocap.clip import Label, Segment

LABELS = (Label("a", 0, 40, "walk"), Label("a", 40, 60, "jump"), Label("b", 0, 40, "walk"))
TERMINALS = (
    (Segment("a", 0, 30), Segment("a", 50, 60)),
    (Segment("b", 0, 40),),
    (Segment("a", 30, 50), Segment("c", 0, 9)),
)


def test_confusion_counts_frames():
    table, total = confusion(TERMINALS, LABELS)
    assert table.tolist() == [[10, 30], [0, 40], [10, 10]] and total == 100


def test_accuracy_one_to_one_and_many_to_one():
    assert frame_accuracy(TERMINALS, LABELS) == (0.5, 0.8)
    assert frame_accuracy(((Segment("a", 0, 20),),), LABELS) == (0.2, 0.2)
    with pytest.raises(ValueError, match="no labels"):
        frame_accuracy(TERMINALS, ())


def test_boundaries_lie_where_the_terminal_changes():
    pieces = ((Segment("a", 0, 10), Segment("a", 10, 30), Segment("a", 50, 60)), (Segment("a", 30, 50),))
    assert boundaries_of(pieces) == {"a": (30, 50)}


def test_boundaries_within_intervals():
    accepted = {"a": [(10, 20), (30, 40)], "b": [(5, 9)]}
    scores = score_boundaries({"a": (10, 12, 41), "b": (9,), "c": (1, 2)}, accepted)
    assert (scores.precision, scores.recall) == (2 / 4, 2 / 3)
    assert score_boundaries({}, accepted) == (0, 0, 0)


def test_overlapping_intervals_take_a_boundary_each_where_that_is_possible():
    scores = score_boundaries({"a": (5, 15)}, {"a": [(0, 20), (10, 20)]})
    assert scores.recall == 1
    assert score_boundaries({"a": (15,)}, {"a": [(0, 20), (10, 20)]}).recall == 0.5


def test_intervals_around_changes_of_action():
    labels = (Label("a", 0, 40, "walk"), Label("a", 40, 60, "walk"), Label("a", 60, 90, "jump"))
    assert boundary_intervals(labels, 0.1, {"a": 60.0}) == {"a": [(54, 66)]}
