"""Ratings and votes on search results: kept, replaced, exported, forgotten with their data set."""

from __future__ import annotations

import csv
import io

import pytest

from core.evaluation.agreement import Rating, Vote
from core.mocap.clip import Segment
from core.workspace import Workspace, WorkspaceError

QUERY, NEAR, FAR = Segment("walk a/1", 10, 90), Segment("walk b", 0, 80), Segment("run", 5, 60)


@pytest.fixture
def ratings(tmp_path):
    workspace = Workspace(tmp_path)
    yield workspace.ratings
    workspace.close()


def vote(choice="left", left=NEAR, right=FAR, left_engine="parts", right_engine="printed", person="ann") -> Vote:
    return Vote(QUERY, left, right, left_engine, right_engine, 1, 2, choice, person)


def test_a_rating_is_kept_and_a_changed_mind_replaces_it(ratings):
    ratings.put_rating("d1", QUERY, NEAR, "parts", 1, 7, person="ann")
    ratings.put_rating("d1", QUERY, NEAR, "parts", 1, 9, person="ann")
    ratings.put_rating("d1", QUERY, NEAR, "parts", 1, 3, person="bob")
    ratings.put_rating("d1", QUERY, NEAR, "printed", 4, 9, person="ann")
    assert ratings.list_ratings("d1") == [
        Rating(QUERY, NEAR, "parts", 1, 9, "ann"),
        Rating(QUERY, NEAR, "parts", 1, 3, "bob"),
        Rating(QUERY, NEAR, "printed", 4, 9, "ann"),
    ]
    assert [r.person for r in ratings.list_ratings("d1", person="bob")] == ["bob"]
    assert ratings.list_ratings("d2") == []


@pytest.mark.parametrize(("rank", "value"), [(0, 5), (1, 0), (1, 11)])
def test_what_is_off_the_scale_is_refused(ratings, rank, value):
    with pytest.raises(WorkspaceError, match="1 to 10"):
        ratings.put_rating("d1", QUERY, NEAR, "parts", rank, value)
    assert ratings.list_ratings("d1") == []


def test_an_empty_segment_is_refused(ratings):
    with pytest.raises(WorkspaceError, match="ends after it starts"):
        ratings.put_rating("d1", QUERY, Segment("a", 4, 4), "parts", 1, 5)


def test_a_vote_on_the_same_two_hits_replaces_the_earlier_whichever_way_they_were_shown(ratings):
    ratings.put_vote("d1", vote("left"))
    ratings.put_vote("d1", vote("same"))
    assert [v.choice for v in ratings.list_votes("d1")] == ["same"]
    turned = vote("right", FAR, NEAR, "printed", "parts")
    ratings.put_vote("d1", turned)
    assert ratings.list_votes("d1") == [turned]
    ratings.put_vote("d1", vote("left", person="bob"))
    assert len(ratings.list_votes("d1")) == 2 and ratings.list_votes("d1", person="bob") == [vote(person="bob")]


def test_votes_that_say_nothing_are_refused(ratings):
    with pytest.raises(WorkspaceError, match="left, right, same"):
        ratings.put_vote("d1", vote("neither"))
    with pytest.raises(WorkspaceError, match="two different hits"):
        ratings.put_vote("d1", vote(right=NEAR, right_engine="parts"))


def test_the_export_names_segments_as_queries_do_and_is_safe_in_a_spreadsheet(ratings):
    ratings.put_rating("d1", QUERY, Segment("=cmd", 0, 9), "parts", 1, 7, person="ann")
    ratings.put_vote("d1", vote())
    (row,) = csv.DictReader(io.StringIO(ratings.export_ratings("d1")))
    assert (row["query"], row["hit"], row["engine"], row["rating"]) == ("walk a/1:10-90", "'=cmd:0-9", "parts", "7")
    (row,) = csv.DictReader(io.StringIO(ratings.export_votes("d1")))
    assert (row["left"], row["right"], row["choice"]) == ("walk b:0-80", "run:5-60", "left")
    assert (row["left_engine"], row["right_rank"], row["person"]) == ("parts", "2", "ann")


def test_clearing_takes_one_person_or_all(ratings):
    for person in ("ann", "bob"):
        ratings.put_rating("d1", QUERY, NEAR, "parts", 1, 7, person=person)
        ratings.put_vote("d1", vote(person=person))
    assert ratings.clear("d1", person="ann") == 2
    assert [r.person for r in ratings.list_ratings("d1")] == ["bob"]
    assert ratings.clear("d1") == 2 and ratings.list_votes("d1") == []


def test_ratings_of_a_data_set_that_is_gone_are_forgotten(ratings):
    ratings.put_rating("gone", QUERY, NEAR, "parts", 1, 7)
    ratings.forget_deleted()
    assert ratings.list_ratings("gone") == []
