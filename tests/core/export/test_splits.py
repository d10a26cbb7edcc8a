"""Groups of clips that belong together, and their split."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.export.splits import motion_groups, split_groups, subject_of
from tests.webapp.generated import walk


def test_subjects_by_name():
    assert [subject_of(n) for n in ("86_03", "ana_01", "walk1_subject5", "bow_normal_001", "a/86_03", "17")] == [
        "86", "ana", "subject5", "bow_normal", "86", "17",
    ]  # fmt: skip


def test_copies_and_pieces_of_a_clip_stay_with_it():
    clips = [walk("86_01", pace=1.0), walk("copy", pace=1.0), walk("86_02", pace=1.7), walk("86_01 mirrored", pace=0.6)]
    clips.append(walk("9_01", pace=0.7, seconds=7.0))
    groups = motion_groups(clips)
    assert groups[0] == groups[1] == groups[2] == groups[3] != groups[4]


GROUPS = st.lists(st.tuples(st.sampled_from("abcdefgh"), st.integers(1, 1000)), min_size=1, max_size=20)


@given(GROUPS, st.sampled_from([0.0, 0.1, 0.2, 0.5]))
def test_a_split_never_divides_a_group_and_both_parts_exist(clips, share):
    groups, sizes = zip(*clips, strict=True)
    found = split_groups(groups, sizes, share)
    assert set(found) == set(groups) and set(found.values()) <= {"train", "test"}
    assert "train" in found.values()
    assert ("test" in found.values()) == (len(set(groups)) > 1 and share > 0)
    assert found == split_groups(groups[::-1], sizes[::-1], share)


def test_the_test_has_about_its_share():
    groups = [f"person {k}" for k in range(50)]
    found = split_groups(groups, [100] * 50, 0.2)
    assert 8 <= sum(part == "test" for part in found.values()) <= 12
    with pytest.raises(ValueError, match="share"):
        split_groups(groups, [1] * 50, 1.5)
