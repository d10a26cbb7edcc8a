"""Searches in the app: what a link asks for, what is found, exports and recipes that give the same."""

from __future__ import annotations

import csv
import io
import json
from contextlib import redirect_stdout
from pathlib import Path
from urllib.parse import urlencode

import numpy as np
import pytest

from core import analyses
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.poses.body_parts import LEAVES, leaves_of
from core.retrieval.bounded_edit import BoundedEdit
from core.retrieval.hits import Explanation, Hit
from core.retrieval.queries import Query, QueryPart
from core.workspace import Workspace, WorkspaceError
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.search import names, recipes, searching
from webapp.features.search.callbacks import found_data
from webapp.features.search.figures import hits as figures
from webapp.features.search.queries import Piece, read_hit, write_query
from webapp.shell import settings
from webapp.ui.tables import labels_by_clip

NAMES = ("walk", "stroll", "rush", "turn", "dash")


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Five walks, labelled, and their search index."""
    clips = tuple(walk(name, pace=0.7 + 0.25 * k, turn=0.4 * k, seconds=2.5 + 0.5 * k) for k, name in enumerate(NAMES))
    labels = (Label("walk", 0, 150, "slow"), Label("stroll", 0, 90, "slow"), Label("rush", 0, 100, "fast"))
    made = Workspace(tmp_path_factory.mktemp("search") / "workspace")
    made.add_dataset("walkers", Dataset("walkers", clips, labels))
    analyses.run(made, analyses.Request("walkers", "search"))
    return made


@pytest.fixture(scope="module")
def dataset(workspace: Workspace) -> Dataset:
    return workspace.open("walkers")


def view(clip: str = "walk", start: int = 0, end: int = 150, **more: str) -> dict[str, str]:
    return {"query": write_query([Piece(clip, start, end)]), **more}


def test_a_link_says_what_is_looked_for_within_limits():
    asked = searching.read(view(route="50", lasting="1.5-4", top="99999", parts="left_arm:3", level="nonsense"))
    assert asked.route == 0.5 and asked.lasting == (1.5, 4.0) and asked.top == searching.MOST
    assert asked.weights == {"left_arm": 3} and asked.level == ""
    assert searching.read(view(lasting="-2")).lasting == (0, 2)
    assert searching.read(view(lasting="2-")).lasting == (2, float("inf"))
    assert searching.read({}) is None and searching.read(None) is None
    with pytest.raises(ValueError, match="looks like"):
        searching.read({"query": "what?"})


def test_whole_clips_come_for_a_whole_clip_and_never_its_own(workspace, dataset):
    found = searching.find(workspace, dataset, view(), unlike_too=True)
    assert found.level == "clip" and {hit.segment.clip for hit in found.hits} == set(NAMES) - {"walk"}
    scores = [hit.score for hit in found.hits]
    assert scores == sorted(scores, reverse=True)
    assert searching.find(workspace, dataset, view(), unlike_too=True) is found  # kept ready


def test_the_list_ends_where_the_chance_of_the_same_action_ends(workspace, dataset, monkeypatch):
    every = searching.find(workspace, dataset, view("rush"), unlike_too=True).hits
    least = (every[1].score + every[2].score) / 2  # so that two of them are likely enough
    monkeypatch.setattr(BoundedEdit, "least", least)
    found = searching.find(workspace, dataset, view("rush"))
    assert found.chances and found.hits == every[:2] and found.total == 2
    assert found.unlike == len(every) - 2 > 0
    data = found_data(workspace, dataset, view("rush"))
    assert data["unlike"] == found.unlike and data["chances"] and len(data["hits"]) == 2


def test_a_tag_says_the_share_of_the_label_that_covers_most():
    labels = {"a": [Label("a", 0, 49, "kick"), Label("a", 49, 100, "idle")]}
    assert searching.tag_of(labels, Segment("a", 0, 100)) == "idle 51 %"
    assert searching.tag_of(labels, Segment("a", 0, 40)) == "kick"
    assert searching.tag_of(labels, Segment("a", 40, 60)) == "idle 55 %"
    assert searching.tag_of(labels, Segment("b", 0, 10)) == ""


def test_moments_come_for_a_moment_and_never_itself(workspace, dataset):
    found = searching.find(workspace, dataset, view("dash", 60, 150))
    assert found.level == "interval" and found.hits
    for hit in found.hits:
        common = min(hit.segment.end, 150) - max(hit.segment.start, 60) if hit.segment.clip == "dash" else 0
        assert common < 0.75 * 90


def test_filters_leave_only_what_was_asked_for(workspace, dataset):
    def clips(**more: str) -> set[str]:
        return {hit.segment.clip for hit in searching.find(workspace, dataset, view(**more), unlike_too=True).hits}

    assert clips(label="slow") == {"stroll"}
    assert clips(named="S") == {"stroll", "rush", "dash"}
    assert clips(lasting="3.4-4.1") == {"rush", "turn"}
    assert clips(label="fast", named="x") == set()
    moments = searching.find(workspace, dataset, view("dash", 60, 150, label="slow", level="interval")).hits
    labels = labels_by_clip(dataset)
    assert all(searching.label_of(labels, hit.segment) == "slow" for hit in moments)


def test_what_cannot_be_searched_for_is_said_in_words(workspace, dataset):
    with pytest.raises(WorkspaceError, match="no clip called “gone”"):
        searching.find(workspace, dataset, view("gone"))
    with pytest.raises(ValueError, match="frames 0 to"):
        searching.find(workspace, dataset, view("walk", 0, 9999))
    with pytest.raises(ValueError, match="switch on at least one"):
        found_data(workspace, dataset, view(parts="left_arm:0"))


def test_without_an_index_there_are_no_hits_but_a_query(workspace, dataset):
    data = found_data(workspace, dataset, view(**{"search-analysis_fps": "15"}))
    assert misfit({"inputs": {}} | data, names.SEARCH_FOUND) is None
    assert "hits" not in data and data["pieces"][0]["clip"] == "walk" and data["request"]["items"]


def test_an_index_is_opened_before_anybody_waits_for_it(workspace, dataset):
    thread = searching.warm(workspace, dataset, {})
    assert thread is not None
    thread.join(120)
    assert not thread.is_alive() and searching.warm(workspace, dataset, {}) is None
    assert searching.warm(workspace, dataset, {"search-analysis_fps": "15"}) is None  # there is none


def test_a_query_in_pieces_names_its_parts(workspace, dataset):
    pieces = [Piece("walk", 0, 90, leaves_of("upper_body")), Piece("dash", 10, 130, leaves_of("lower_body"))]
    data = found_data(workspace, dataset, {"query": write_query(pieces)})
    assert misfit({"inputs": {}} | data, names.SEARCH_FOUND) is None
    assert [piece["gives"] for piece in data["pieces"]] == ["Upper body", "Lower body"]
    assert isinstance(data["doubt"], str)
    assert data["hits"] and data["level"] == "interval"


def explanation(n: int, q: int, hit: Segment) -> Explanation:
    similarity = np.linspace(0, 1, n)[None].repeat(len(LEAVES), 0)
    similarity[3] = np.nan
    return Explanation(np.arange(n) / 30, similarity, np.linspace(hit.start, hit.end - 1, q))


def test_the_strip_is_short_and_knows_what_it_does_not_know():
    strip = figures.strip_of(explanation(200, 100, Segment("a", 0, 50)))
    assert {len(row) for row in strip["rows"]} == {figures.COLUMNS}
    assert strip["rows"][0][0] < 5 and strip["rows"][0][-1] > 95 and set(strip["rows"][3]) == {-1}
    assert strip["means"][0] == pytest.approx(0.5) and strip["means"][3] is None


def test_query_and_hit_stand_in_step_on_the_stage():
    clips = tuple(walk(name, seconds=2.0) for name in ("a", "b"))
    dataset, hit = Dataset("pair", clips), Segment("b", 20, 80)
    parts = (
        QueryPart(leaves_of("upper_body"), clips[0], 0, 60),
        QueryPart(leaves_of("lower_body"), clips[1], 10, 110),
    )
    query = Query(parts, "both")
    why = explanation(50, 100, hit)
    request = figures.pair_request(dataset, [dataset, dataset], query, hit, why)
    upper, lower, found = request["items"]
    assert lower["warp"] == list(range(100)) and len(upper["warp"]) == 100
    assert upper["warp"][0] == 0 and upper["warp"][-1] == 59
    assert found["warp"][0] == 0 and found["warp"][-1] == 59 and max(found["warp"]) < hit.n_frames
    assert request["layout"] == "side" and len({item["colour"] for item in request["items"]}) == 3


def test_exports_hold_the_hits_of_the_link(workspace, dataset):
    client = create_app(workspace.path).server.test_client()
    link = urlencode({"dataset": "walkers", **view()})
    found = searching.find(workspace, dataset, view())
    rows = list(csv.DictReader(io.StringIO(client.get(f"/api/search/hits.csv?{link}").text)))
    assert [row["clip"] for row in rows] == [hit.segment.clip for hit in found.hits]
    assert rows[0].keys() >= {"rank", "start_frame", "end_seconds", "score", "label"}
    document = json.loads(client.get(f"/api/search/hits.json?{link}").text)
    assert document["format"] == "motionscape/hits/1"
    (answers,) = document["queries"].values()
    assert [hit["clip"] for hit in answers["hits"]] == [hit.segment.clip for hit in found.hits]
    name = found_data(workspace, dataset, view())["hits"][0]["name"]
    why = client.get(f"/api/search/explain?{link}&hit={name}").get_json()
    assert len(why["strip"]["rows"]) == len(LEAVES) and len(why["request"]["items"]) == 2
    assert why["request"]["items"][1]["clip"] == read_hit(name).clip
    for bad, status in ((link, 400), (f"{link}&hit=gone:0-9", 404), ("dataset=none&query=a:0-9&hit=a:0-9", 404)):
        answer = client.get(f"/api/search/explain?{bad}")
        assert answer.status_code == status and answer.get_json()["error"]


@pytest.mark.parametrize("more", [{}, {"parts": "left_arm:2,right_leg:1", "route": "30", "top": "2"}])
def test_the_python_recipe_gives_the_hits_of_the_page(workspace, dataset, more):
    asked_view = view("dash", 60, 150, level="clip", **more)
    asked, request = searching.read(asked_view), settings.request_of("search", "walkers", asked_view)
    said = io.StringIO()
    with redirect_stdout(said):
        exec(recipes.script(workspace.path, request, asked, "clip"), {})
    printed = [line.split()[1] for line in said.getvalue().splitlines()]
    page = [hit.segment.clip for hit in searching.find(workspace, dataset, asked_view).hits]
    assert [name for name in printed if name != "dash"][: len(page)] == page[: len([n for n in printed if n != "dash"])]


def test_recipes_are_offered_only_where_they_can_be_run():
    request = analyses.Request("walkers", "search")
    halves = (Piece("a", 0, 9, leaves_of("upper_body")), Piece("b", 1, 8, leaves_of("lower_body")))
    both = recipes.texts(Path("w"), request, searching.Search(halves), "interval")
    assert "--query a:0-9 --lower b:1-8" in both["Copy as command"] and "hybrid_query" in both["Copy as Python"]
    odd = (Piece("a", 0, 9, ("head",)),)
    assert set(recipes.texts(Path("w"), request, searching.Search(odd), "clip")) == {"Copy as Python"}
    uploaded = (Piece("a", 0, 9, LEAVES, "~upload~0123456789abcdef"),)
    assert (
        "kept_query(workspace, '0123456789abcdef')"
        in recipes.texts(Path("w"), request, searching.Search(uploaded), "clip")["Copy as Python"]
    )
    walked = (Piece("walk", 0, 9, LEAVES, "~walk~0123456789abcdef"),)
    assert recipes.texts(Path("w"), request, searching.Search(walked), "clip") == {}


def test_rows_say_where_a_hit_lies(dataset):
    row = figures.hit_row(dataset, Hit(Segment("walk", 60, 120), 0.5), 3, "slow")
    assert row["when"] == "0:01.0 to 0:02.0" and row["name"] == "walk:60-120" and row["rank"] == 3
    whole = figures.hit_row(dataset, Hit(Segment("walk", 0, 150), 0.5), 1, "")
    assert whole["when"] == "2.5 s" and "/api/filmstrip/walkers/walk?" in whole["strip"]
