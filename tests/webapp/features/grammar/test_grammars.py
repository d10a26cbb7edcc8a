"""Grammars in the app: what plays, new routines and their parts, what is kept, the routes and the recipes."""

from __future__ import annotations

import json
import shlex
from pathlib import Path

import pytest

from core import analyses
from core.demo import make_demo
from core.grammar.learned import from_json
from core.grammar.trees import at_path, leaves
from core.mocap.bvh import read_bvh
from core.workspace import Workspace, WorkspaceError
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.cli.main import main
from webapp.features.grammar import action_counts, compositions, grammars, names, playing
from webapp.features.grammar.figures.tiles import tiles
from webapp.jobs.job_bar import stage_words
from webapp.shell import playback, recipes, settings
from webapp.shell.virtual import open_any

VALUES = {"n_terminals": 8, "analysis_fps": 10.0}
VIEW = settings.view_of("grammar", VALUES)


@pytest.fixture(scope="module")
def workspace(tmp_path_factory) -> Workspace:
    """A workspace with a little demo and its grammar."""
    made = Workspace(tmp_path_factory.mktemp("grammars") / "workspace")
    made.add_dataset("demo", make_demo(minutes=0.8, seed=4))
    analyses.run(made, analyses.Request("demo", "grammar", VALUES))
    return made


@pytest.fixture(scope="module")
def client(workspace: Workspace):
    return create_app(workspace.path).server.test_client()


@pytest.fixture(scope="module")
def found(workspace: Workspace):
    return grammars.learned(workspace, "demo", VIEW)


def test_all_that_the_page_draws_is_json_and_whole(workspace, found):
    dataset, key = workspace.open("demo"), settings.key_of(workspace, "grammar", "demo", VIEW)
    data = grammars.page_data(dataset, found, key, {})
    assert misfit(data | {"names": ""}, names.GRAMMAR_DATA) is None
    assert json.loads(json.dumps(data)) == data
    assert [entry["count"] for entry in data["actions"]] == [len(own) for own in found.terminals.segments]
    assert sum(len(row["pieces"]) for row in data["rows"]) == sum(map(len, found.terminals.segments))
    for row, clip in zip(data["rows"], dataset.clips, strict=True):
        ends = [piece[1] for piece in row["pieces"]]
        assert [piece[0] for piece in row["pieces"]] == [0, *ends[:-1]] and ends[-1] == pytest.approx(
            clip.seconds, abs=2e-3
        )
    for routine, sentence in zip(data["routines"], found.sentences, strict=True):
        assert routine["actions"] == list(sentence.terminals) and len(routine["leaves"]) == len(sentence.pieces)
    assert {
        part for rule in data["rules"] for way in rule["ways"] for part in way["parts"] if isinstance(part, str)
    } <= {rule["id"] for rule in data["rules"]}


def test_the_tiles_tell_coverage_and_repetition(workspace, found):
    told = {name: value for name, value, _ in tiles(workspace.open("demo"), found)}
    often = [own for own in found.terminals.segments if len(own) > 1]
    frames = sum(frames for _, frames, _ in found.terminals.clips)
    assert told["Recurring"] == f"{100 * sum(s.n_frames for own in often for s in own) / frames:.0f} %"
    assert told["Repeated"] == f"{sum(map(len, found.terminals.segments)) / 8:.1f}×" and told["Actions"] == "8"
    assert told["Rules"] == str(len(found.grammar.rules)) and told["Bits"] == f"{found.bits.total:.0f}"


def test_a_selection_plays_all_occurrences_one_or_a_coloured_stretch(workspace, found):
    action = max(range(8), key=lambda k: len(found.terminals.segments[k]))
    own = found.terminals.segments[action]

    def played(selection):
        return playback.selected_request(workspace, "demo", selection, VIEW)

    together = played({"action": action})
    assert len(together["items"]) == min(len(own), playing.MOST_FIGURES)
    first = together["items"][0]
    assert (first["clip"], first["start"], first["end"]) == found.terminals.medoids[action]
    alone = played({"action": action, "segment": 1})
    assert [(i["clip"], i["start"], i["end"]) for i in alone["items"]] == [own[1]]
    clip = workspace.open("demo").clips[0]
    whole = played({"clip": clip.name, "as": "actions"})
    spans = whole["items"][0]["colours"]
    assert [(s["start"], s["end"]) for s in spans] == [
        (s.start, s.end) for _, s in found.terminals.occurrences[clip.name]
    ]
    assert "colours" not in played({"clip": clip.name})["items"][0]
    assert played({"action": 99}) is None
    assert "no action 99; it has 8" in playback.missing(workspace, "demo", {"action": 99}, VIEW)
    assert playback.missing(workspace, "demo", {"action": 7}, VIEW) is None


def test_what_plays_together_is_spread_over_the_list(found):
    own = max(found.terminals.segments, key=len)
    shown = playing.typical_first(own, own[2], 5)
    assert len(shown) == len(set(shown)) == 5 and shown[0] == own[2] and own[-1] in shown and own[0] in shown


def test_names_are_kept_by_the_frames_they_were_given_to(workspace, found):
    before = grammars.names_mark(workspace, "demo", VIEW)
    assert grammars.name_action(workspace, "demo", VIEW, 2, "  side   step ")
    assert not grammars.name_action(workspace, "demo", VIEW, 2, "side step")
    assert grammars.names_mark(workspace, "demo", VIEW) != before
    assert grammars.notes_of(workspace, "demo", VIEW)[2].name == "side step"
    assert not grammars.name_action(workspace, "demo", VIEW, 99, "nothing")
    with pytest.raises(WorkspaceError, match="at most"):
        grammars.name_action(workspace, "demo", VIEW, 1, "x" * 200)
    assert grammars.name_action(workspace, "demo", VIEW, 2, "")
    assert grammars.names_mark(workspace, "demo", VIEW) == before


def _composed(workspace, **view):
    return compositions.composed(workspace, "demo", {**VIEW, "show": "compose", **view})


def test_a_new_routine_is_shown_played_and_saved(workspace, client, found, tmp_path):
    data = _composed(workspace, sentence="random:3:12")
    assert misfit(data, names.COMPOSE_DATA) is None
    assert json.loads(json.dumps(data)) == data | {"chosen": None}
    assert found.grammar.accepts(data["actions"]) and len(data["spans"]) == len(data["actions"])
    assert data["spans"][0][0] == 0 and data["spans"][-1][1] == data["frames"]
    again = _composed(workspace, sentence=data["code"])
    assert (again["name"], again["actions"]) == (data["name"], data["actions"])
    assert open_any(workspace, data["name"]).clip(data["clip"]).n_frames == data["frames"]
    bvh = client.get(f"/api/bvh/{data['name']}/{data['clip']}")
    (tmp_path / "routine.bvh").write_bytes(bvh.data)
    assert read_bvh(tmp_path / "routine.bvh").n_frames == data["frames"]
    told = client.get(f"/api/derivation/{data['name'].rpartition('~')[2]}.json").json
    assert told["terminals"] == data["actions"] and told["frames"] == data["frames"]
    assert client.get("/api/derivation/0123456789abcdef.json").status_code == 404


def test_the_chosen_part_grows_to_the_whole_routine(workspace, found):
    data = _composed(workspace, sentence="random:3:12", pick="1")
    assert misfit(data, names.COMPOSE_DATA) is None
    sizes, up = [], 0
    while True:
        chosen = _composed(workspace, sentence="random:3:12", pick="1", up=str(up))["chosen"]
        assert chosen["first"] <= 1 < chosen["end"]
        tree = compositions.tree_of(found, data["code"])
        assert at_path(tree, chosen["at"]).end == chosen["end"]
        assert chosen["smaller"] == (up > 0)
        part = {**VIEW, "show": "compose", "sentence": "random:3:12", "pick": "1", "up": str(up), "alt": "1"}
        assert chosen["varies"] or not compositions.alternatives(workspace, "demo", part)["others"]
        sizes.append(chosen["end"] - chosen["first"])
        if not chosen["larger"]:
            break
        up += 1
    assert sizes == sorted(sizes) and sizes[-1] == len(data["actions"])
    assert _composed(workspace, sentence="random:3:12", pick="999")["chosen"] is None


def test_four_other_ways_keep_what_is_outside_the_part(workspace, found):
    view = {**VIEW, "show": "compose", "sentence": "random:3:12", "pick": "1", "up": "9", "alt": "2"}
    data = compositions.alternatives(workspace, "demo", view)
    assert misfit(data, names.COMPOSE_OTHER_DATA) is None
    assert json.loads(json.dumps(data)) == data and 1 <= len(data["others"]) <= 4
    assert len({tuple(other["actions"]) for other in data["others"]}) == len(data["others"])
    own = leaves(compositions.tree_of(found, "random:3:12"))
    for other in data["others"]:
        assert tuple(other["actions"]) != own and found.grammar.accepts(other["actions"])
        assert 0 <= other["start"] < other["stop"]
        assert list(leaves(compositions.tree_of(found, other["code"]))) == other["actions"]
    without = compositions.alternatives(workspace, "demo", {**view, "pick": ""})
    assert misfit(without, names.COMPOSE_OTHER_DATA) is None
    assert without["error"] == "Choose an action first."


@pytest.mark.parametrize("sentence", ["999.3", "random", "0..1", "<b>"])
def test_a_link_that_names_no_routine_says_why(workspace, sentence):
    assert _composed(workspace, sentence=sentence)["error"].endswith(".")


def test_a_routine_is_kept_with_its_actions_as_labels(workspace):
    view = {**VIEW, "sentence": "random:3:12"}
    with pytest.raises(WorkspaceError, match="name"):
        compositions.keep(workspace, "demo", view, "  ")
    assert "“demo routines”" in compositions.keep(workspace, "demo", view, "one")
    compositions.keep(workspace, "demo", {**view, "sentence": "random:4:12"}, "two")
    with pytest.raises(WorkspaceError, match="already"):
        compositions.keep(workspace, "demo", view, "two")
    kept = workspace.open("demo routines")
    assert kept.names == ("one", "two")
    made = _composed(workspace, sentence="random:3:12")
    assert [(label.start, label.end) for label in kept.labels if label.clip == "one"] == [
        tuple(span) for span in made["spans"]
    ]


def test_downloads_are_what_was_learned(workspace, client, found):
    query = "dataset=demo&grammar-n_terminals=8&grammar-analysis_fps=10.0"
    document = client.get(f"/api/grammar.json?{query}").json
    assert from_json(document).grammar == found.grammar
    assert client.get(f"/api/grammar-actions.csv?{query}").text.count("\n") == 1 + sum(
        map(len, found.terminals.segments)
    )
    assert client.get(f"/api/grammar-rules.csv?{query}").text.count("\n") == 1 + len(found.grammar.rules)
    assert client.get(f"/api/grammar-tree.svg?{query}&routine=0").text.count("tree-leaf") == len(
        found.trees[0].children and leaves(found.trees[0])
    )
    assert client.get(f"/api/grammar-tree.svg?{query}&sentence=random:3:12").text.startswith("<svg")
    for wrong, status in (("&sentence=99.9", 400), ("&sentence=x", 400)):
        answer = client.get(f"/api/grammar-tree.svg?{query}{wrong}")
        assert answer.status_code == status and answer.json["error"].endswith(".")
    assert client.get("/api/grammar.json?dataset=demo&grammar-n_terminals=7").status_code == 404
    assert client.get("/api/grammar.json?dataset=demo&grammar-n_terminals=0").status_code == 400
    assert client.get("/api/grammar.json?dataset=nobody").status_code == 404


def test_a_table_has_the_points_that_are_there(workspace):
    view = {**VIEW, "counts": "8,5"}
    points = action_counts.points(workspace, "demo", view)
    assert points[0] is None and points[1].actions == 8
    analyses.run(workspace, action_counts.request("demo", view))
    points = action_counts.points(workspace, "demo", view)
    assert [point.actions for point in points] == [5, 8]
    for point in points:
        there = grammars.learned(workspace, "demo", {k: v for k, v in point.change.items() if v})
        assert there.terminals.n_terminals == point.actions and point.rules == len(there.grammar.rules)
    assert (
        action_counts.counts_change("8, 12 20,30,40, 60") == ""
        and action_counts.counts_text({}) == "8, 12, 20, 30, 40, 60"
    )


def test_the_commands_give_the_routine_again(workspace, tmp_path, monkeypatch):
    data = _composed(workspace, sentence="random:3:12")
    monkeypatch.chdir(tmp_path)
    for line in data["recipes"]["Copy as commands"].split("\n"):
        assert main([*shlex.split(line)[1:], "--quiet"]) == 0
    assert read_bvh(Path("routine.bvh")).n_frames == data["frames"]
    request = settings.request_of("grammar", "demo", VIEW)
    assert "--n-terminals 8" in recipes.texts(workspace.path, request)["Copy as command"]


def test_stages_are_told_in_words_with_their_count(workspace):
    job = workspace.jobs.submit("key", {"method": "grammar-table"}, "Compare")
    claimed = workspace.jobs.claim(job.id)
    workspace.jobs.progress(claimed.id, "random starts (2 of 6)", 0.3)
    assert stage_words(workspace.jobs.get(job.id)) == "looking for actions (2 of 6)"
    workspace.jobs.stopped(job.id)
