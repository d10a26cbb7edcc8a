"""The study: what people see says nothing of engines, and their answers reach every engine that found the hit."""

from __future__ import annotations

import json

import pytest

from core import analyses
from core.evaluation.agreement import agreement, win_rates
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.retrieval.search import ENGINES
from core.workspace import Workspace, WorkspaceError
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.search import names, study_rounds
from webapp.features.search.engines import ENGINES as CALLED
from webapp.features.search.figures import agreement as figures
from webapp.features.search.queries import write_hit
from webapp.features.search.study import person_of, results, study_data

NAMES = tuple("abcdefgh")
QUERY = Segment("a", 0, 120)
VIEW = {"asks": write_hit(QUERY), "look": "agree"}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Eight walks and their index."""
    clips = tuple(walk(name, pace=0.6 + 0.15 * k, turn=0.3 * k, seconds=2.0) for k, name in enumerate(NAMES))
    made = Workspace(tmp_path_factory.mktemp("study") / "workspace")
    made.add_dataset("walkers", Dataset("walkers", clips, (Label("b", 0, 60, "slow"), Label("c", 10, 90, "fast"))))
    analyses.run(made, analyses.Request("walkers", "search"))
    return made


@pytest.fixture(scope="module")
def dataset(workspace: Workspace) -> Dataset:
    return workspace.open("walkers")


def test_each_query_stands_beside_the_first_hits_of_the_engines_that_are_there(workspace, dataset):
    ready = study_rounds.ready_engines(workspace, "walkers", VIEW)
    assert set(ready) == set(ENGINES) and ready["bounded-edit"]
    pairs = study_rounds.pairs(workspace, dataset, VIEW)
    assert len(pairs) == study_rounds.PER_QUERY and {pair.query for pair in pairs} == {QUERY}
    assert sorted(pair.ranks["bounded-edit"] for pair in pairs) == list(range(1, 7))


def test_nobody_is_told_which_engine_found_what(workspace, dataset):
    data = study_data(workspace, dataset, VIEW, "someone")
    assert (
        misfit({"inputs": {"dataset": "demo", "link": {}, "person": "", "finished": ""}} | data, names.STUDY_DATA)
        is None
    )
    shown = json.dumps([data["pairs"], data["duels"]])
    assert data["pairs"] and data["duels"]
    assert not any(engine in shown for engine in ENGINES) and "rank" not in shown
    assert [row["hit"] for row in data["pairs"]] == [
        r["hit"] for r in study_data(workspace, dataset, VIEW, "someone")["pairs"]
    ]
    orders = {tuple(row["hit"] for row in study_data(workspace, dataset, VIEW, who)["pairs"]) for who in "abcdef"}
    assert len(orders) > 1


def test_a_rating_is_kept_for_the_engines_that_found_the_hit(workspace, dataset):
    store = workspace.info("walkers").id
    row = study_data(workspace, dataset, VIEW, "ann")["pairs"][0]
    answer = {"query": row["query"], "hit": row["hit"], "value": 7, "person": "ann"}
    study_rounds.keep_rating(workspace, dataset, VIEW, answer)
    (kept,) = workspace.ratings.list_ratings(store, person="ann")
    assert kept.value == 7 and write_hit(kept.hit) == row["hit"] and kept.engine == "bounded-edit"
    again = study_data(workspace, dataset, VIEW, "ann")["pairs"]
    assert [r["value"] for r in again if r["hit"] == row["hit"]] == [7]
    with pytest.raises(WorkspaceError, match="no part of the study"):
        study_rounds.keep_rating(workspace, dataset, VIEW, answer | {"hit": "a:0-5"})
    with pytest.raises(WorkspaceError, match="1 to 10"):
        study_rounds.keep_rating(workspace, dataset, VIEW, answer | {"value": 11})


def test_a_vote_knows_its_sides_however_they_are_shown(workspace, dataset):
    store = workspace.info("walkers").id
    ranks = {pair.hit: pair.ranks["bounded-edit"] for pair in study_rounds.pairs(workspace, dataset, VIEW)}
    turned = set()
    for person in "pqrstu":
        duel = study_rounds.duels(workspace, dataset, VIEW, person)[0]
        turned.add(ranks[duel.left] < ranks[duel.right])
        answer = {key: write_hit(getattr(duel, key)) for key in ("query", "left", "right")}
        study_rounds.keep_vote(workspace, dataset, VIEW, answer | {"choice": "left", "person": person})
        (vote,) = workspace.ratings.list_votes(store, person=person)
        assert (vote.left_rank, vote.right_rank) == (ranks[duel.left], ranks[duel.right])
    assert turned == {True, False}  # the better one stands left for some, right for others
    with pytest.raises(WorkspaceError, match="A vote is"):
        study_rounds.keep_vote(workspace, dataset, VIEW, answer | {"choice": "both", "person": "u"})


def test_results_are_the_papers_tables(workspace, dataset):
    store = workspace.info("walkers").id
    for value, row in zip((9, 8, 6, 5, 3, 2), study_data(workspace, dataset, VIEW, "bob")["pairs"], strict=True):
        answer = {"query": row["query"], "hit": row["hit"], "value": value, "person": "bob"}
        study_rounds.keep_rating(workspace, dataset, VIEW, answer)
    duel = study_rounds.duels(workspace, dataset, VIEW, "bob")[0]
    vote = {key: write_hit(getattr(duel, key)) for key in ("query", "left", "right")}
    study_rounds.keep_vote(workspace, dataset, VIEW, vote | {"choice": "left", "person": "bob"})
    text = str(results(workspace, "walkers", "light"))
    assert "Mean rating ± standard deviation" in text and "The engine's rank against people's" in text
    found = agreement(workspace.ratings.list_ratings(store))
    chart = figures.rank_chart(found, CALLED, "dark")
    assert len(chart.data[1].x) == len(found.points)
    assert "–" in str(figures.means_table(found, {"nobody": "Nobody"})) or "bounded-edit" in str(
        figures.means_table(found, {"nobody": "Nobody"})
    )
    assert "votes)" in str(figures.votes_table(win_rates(workspace.ratings.list_votes(store)), CALLED))
    client = create_app(workspace.path).server.test_client()
    assert client.get("/api/search/ratings.csv?dataset=walkers").text.count("bounded-edit") == len(
        workspace.ratings.list_ratings(store)
    )
    assert client.get("/api/search/votes.csv?dataset=walkers").text.startswith("query,left,right")
    assert client.get("/api/search/votes.csv?dataset=none").status_code == 404


def test_drawn_queries_are_labelled_stretches_else_clips(dataset):
    drawn = study_rounds.draw_queries(dataset, 3)
    assert sorted(drawn) == [Segment("b", 0, 60), Segment("c", 10, 90)]
    plain = Dataset("plain", (walk("long", seconds=14), walk("short", seconds=2)))
    for segment in study_rounds.draw_queries(plain, 5):
        assert segment.n_frames == (180 if segment.clip == "long" else 120) and segment.start >= 0


def test_who_answers_is_a_name_or_the_browsers_mark():
    assert person_of({"id": "x1", "name": "Ann"}) == "Ann" and person_of({"id": "x1"}) == "x1" and person_of(None) == ""
