"""What people say of motifs: kept, removed, found again in other results."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.workspace import MotifNote, Workspace, WorkspaceError
from core.workspace.notes import LONGEST_NAME, overlap

JACK = (("a", 0, 100), ("b", 50, 150))
PUNCH = (("a", 200, 260), ("b", 300, 360))


@pytest.fixture
def notes(tmp_path):
    workspace = Workspace(tmp_path)
    yield workspace.notes
    workspace.close()


def said(notes, result, motifs) -> dict[int, tuple[str, bool]]:
    return {motif: (note.name, note.carried) for motif, note in notes.of("d1", result, motifs).items()}


def test_a_note_is_kept_with_its_name_tags_and_text(notes):
    notes.put("d1", "aa", 3, JACK, name=" jumping\n jack ", tags=["warm-up", "", "warm-up", "legs"], note=" both feet ")
    (found,) = notes.of("d1", "aa", {3: JACK, 4: PUNCH}).values()
    assert (found.name, found.tags, found.note) == ("jumping jack", ("warm-up", "legs"), "both feet")
    assert found.segments == JACK and not found.carried


def test_a_note_is_found_again_in_another_result_by_its_frames(notes):
    notes.put("d1", "aa", 3, JACK, name="jumping jack")
    shifted = tuple((clip, start + 10, end + 10) for clip, start, end in JACK)
    assert said(notes, "bb", {0: PUNCH, 7: shifted}) == {7: ("jumping jack", True)}
    assert said(notes, "bb", {0: PUNCH}) == {}
    assert notes.of("d2", "aa", {3: JACK}) == {}


def test_of_two_motifs_only_the_nearer_gets_the_name_and_its_own_note_goes_first(notes):
    notes.put("d1", "aa", 3, JACK, name="jumping jack")
    halves = {0: (("a", 0, 100), ("b", 50, 149)), 1: (("a", 0, 90), ("b", 50, 140))}
    assert said(notes, "bb", halves) == {0: ("jumping jack", True)}
    notes.put("d1", "bb", 0, halves[0], name="star jump")
    assert said(notes, "bb", halves) == {0: ("star jump", False), 1: ("jumping jack", True)}


def test_saying_nothing_removes_a_note_and_hides_a_carried_one(notes):
    notes.put("d1", "aa", 3, JACK, name="jumping jack")
    notes.put("d1", "bb", 7, JACK)
    assert said(notes, "bb", {7: JACK}) == {}
    assert said(notes, "aa", {3: JACK}) == {3: ("jumping jack", False)}
    notes.put("d1", "aa", 3, JACK)
    assert said(notes, "aa", {3: JACK}) == {} == said(notes, "cc", {3: JACK})


def test_too_much_is_refused_in_plain_words(notes):
    with pytest.raises(WorkspaceError, match="at most 80 letters"):
        notes.put("d1", "aa", 3, JACK, name="x" * (LONGEST_NAME + 1))
    with pytest.raises(WorkspaceError, match="tags"):
        notes.put("d1", "aa", 3, JACK, tags=[str(i) for i in range(50)])
    with pytest.raises(WorkspaceError, match="note"):
        notes.put("d1", "aa", 3, JACK, note="x" * 5000)
    assert said(notes, "aa", {3: JACK}) == {}


def test_notes_go_with_their_data_set(notes):
    notes.put("gone", "aa", 3, JACK, name="jumping jack")
    notes.forget_deleted()
    assert notes.of("gone", "aa", {3: JACK}) == {}
    assert MotifNote().is_empty


def spans():
    cuts = st.lists(st.integers(0, 30), min_size=2, max_size=8, unique=True).map(sorted)
    return st.lists(st.tuples(st.sampled_from("ab"), cuts), max_size=2, unique_by=lambda pair: pair[0]).map(
        lambda parts: [(clip, c[i], c[i + 1]) for clip, c in parts for i in range(0, len(c) - 1, 2)]
    )


@given(spans(), spans())
def test_overlap_is_the_share_of_common_frames(a, b):
    frames = [{(clip, f) for clip, start, end in part for f in range(start, end)} for part in (a, b)]
    either = frames[0] | frames[1]
    assert overlap(a, b) == pytest.approx(len(frames[0] & frames[1]) / len(either) if either else 0.0)
