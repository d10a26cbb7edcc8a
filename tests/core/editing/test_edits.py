"""Edits: nothing is lost, labels stay with the motion they speak of, refusals say why."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.editing.edits import at_rate, free_name, label_cuts, mirrored, renamed, split, trim
from core.mocap.clip import Label
from core.mocap.kinematics import joint_positions
from tests.core.editing.figures import action, moved, standing

CLIP = moved(standing(100), np.outer(np.arange(100), [0.01, 0, 0.02]))
LABELS = (Label("standing", 10, 30, "wave"), Label("standing", 30, 100, "go"), Label("other", 0, 5, "no"))
intervals = st.tuples(st.integers(0, 98), st.integers(2, 100)).map(lambda x: (x[0], min(x[0] + x[1], 100)))


def actions(edited, frame: int) -> set[str]:
    return {label.action for label in edited.labels if label.start <= frame < label.end}


@given(intervals)
def test_a_trimmed_clip_is_those_frames_and_their_labels(interval):
    start, end = interval
    if end - start < 2:
        return
    edited = trim(CLIP, LABELS, start, end)
    assert edited.clip.name == f"standing {start}-{end}" and edited.clip.fps == CLIP.fps
    assert np.array_equal(edited.clip.root_positions, CLIP.root_positions[start:end])
    for frame in range(start, end):
        assert actions(edited, frame - start) == {lab.action for lab in LABELS[:2] if lab.start <= frame < lab.end}
    assert all(
        label.clip == edited.clip.name and 0 <= label.start < label.end <= end - start for label in edited.labels
    )


@pytest.mark.parametrize(
    ("start", "end", "why"), [(-1, 5, "frames 0 to 100"), (5, 101, "frames 0 to"), (7, 8, "at least 2")]
)
def test_what_cannot_be_trimmed(start, end, why):
    with pytest.raises(ValueError, match=why):
        trim(CLIP, LABELS, start, end)


def test_a_mirrored_clip_keeps_its_labels_and_says_what_it_is():
    edited = mirrored(CLIP, LABELS)
    assert edited.clip.name == "standing mirrored" and edited.clip.notes == ("standing with left and right exchanged",)
    assert edited.labels == tuple(label._replace(clip="standing mirrored") for label in LABELS[:2])


@pytest.mark.parametrize("fps", [30, 25, 90, 7.5])
def test_another_rate_shows_the_same_motion_at_the_same_times(fps):
    clip = action("punch")
    labels = (Label(clip.name, 20, 61, "hit"),)
    edited = at_rate(clip, labels, fps)
    assert edited.clip.fps == fps and abs(edited.clip.seconds - clip.seconds) < 2 / fps
    old, new = joint_positions(clip), joint_positions(edited.clip)
    at = np.arange(edited.clip.n_frames) * clip.fps / fps
    low = np.minimum(at.astype(int), clip.n_frames - 2)
    between = old[low] * (1 - (at - low))[:, None, None] + old[low + 1] * (at - low)[:, None, None]
    assert np.abs(new - between).max() < 0.03
    label = edited.labels[0]
    assert label.start / fps == pytest.approx(20 / clip.fps, abs=0.6 / fps)
    assert label.end / fps == pytest.approx(61 / clip.fps, abs=0.6 / fps)


@pytest.mark.parametrize(("fps", "why"), [(60, "already"), (0, "from 1 to 1000"), (float("nan"), "from 1 to 1000")])
def test_rates_that_cannot_be(fps, why):
    with pytest.raises(ValueError, match=why):
        at_rate(CLIP, LABELS, fps)
    with pytest.raises(ValueError, match="single frame"):
        at_rate(CLIP.cut(0, 30), (), 1)


@given(st.lists(st.integers(1, 48).map(lambda k: 2 * k), min_size=1, max_size=8))
def test_parts_laid_end_to_end_are_the_clip(cuts):
    parts = split(CLIP, LABELS, cuts)
    assert np.array_equal(np.concatenate([part.clip.root_positions for part in parts]), CLIP.root_positions)
    assert len({part.clip.name for part in parts}) == len(parts) == len(set(cuts)) + 1
    at = 0
    for part in parts:
        for frame in range(part.clip.n_frames):
            assert actions(part, frame) == {lab.action for lab in LABELS[:2] if lab.start <= at + frame < lab.end}
        at += part.clip.n_frames


def test_split_at_labels_names_parts_after_them():
    parts = split(CLIP, LABELS, label_cuts(CLIP, LABELS))
    assert [part.clip.name for part in parts] == ["standing part 1", "standing wave", "standing go"]
    assert label_cuts(CLIP, (Label("standing", 1, 50, "a"), Label("standing", 51, 99, "b"))) == (50,)


@pytest.mark.parametrize(
    ("cuts", "why"), [([0, 100], "nothing to cut"), ([1], "single frame"), ([50, 51], "single frame")]
)
def test_what_cannot_be_split(cuts, why):
    with pytest.raises(ValueError, match=why):
        split(CLIP, LABELS, cuts)
    with pytest.raises(ValueError, match="no label"):
        label_cuts(CLIP, LABELS[2:])


def test_names_are_free():
    assert free_name("a", ["b"]) == "a" and free_name("a", ["a", "a (2)"]) == "a (3)"
    new = renamed(trim(CLIP, LABELS, 10, 40), "wave")
    assert new.clip.name == "wave" and {label.clip for label in new.labels} == {"wave"}
