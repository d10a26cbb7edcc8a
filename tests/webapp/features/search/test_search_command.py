"""``motionscape search`` on a workspace's data set and on files."""

from __future__ import annotations

import json

import pytest

from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.cli.main import main


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    made = Workspace(tmp_path_factory.mktemp("search") / "ws")
    made.add_dataset("walkers", walkers(("a_01", "b_01", "c_01"), seconds=4.0))
    yield made
    made.close()


@pytest.fixture
def source(workspace):
    return f"{workspace.path}/walkers"


def found(tmp_path, *line):
    out = tmp_path / "hits.json"
    assert main(["search", *line, "--out", str(out), "--quiet"]) == 0
    return json.loads(out.read_text())


def test_a_whole_clip_gives_every_other_clip(source, tmp_path):
    document = found(tmp_path, source, "--query", "a_01")
    assert document["format"] == "motionscape/hits/1" and {c["name"] for c in document["clips"]} >= {"a_01", "b_01"}
    answer = document["queries"]["a_01"]
    assert {hit["clip"] for hit in answer["hits"]} == {"b_01", "c_01"} and answer["milliseconds"] >= 0
    scores = [hit["score"] for hit in answer["hits"]]
    assert scores == sorted(scores, reverse=True)
    assert answer["hits"][0]["start"] == 0 and answer["hits"][0]["end"] == document["clips"][1]["frames"]


def test_a_stretch_gives_stretches(source, tmp_path):
    document = found(tmp_path, source, "--query", "a_01:20-80", "--top", "3")
    hits = document["queries"]["a_01:20-80"]["hits"]
    assert hits[0]["clip"] == "a_01" and abs(hits[0]["start"] - 20) <= 6 and 1 <= len(hits) <= 3


def test_many_queries_at_once(source, tmp_path):
    listed = tmp_path / "queries.json"
    listed.write_text(json.dumps(["a_01", "b_01:0-40", "c_01"]))
    document = found(tmp_path, source, "--queries", str(listed), "--level", "clip", "--top", "1")
    assert list(document["queries"]) == ["a_01", "b_01:0-40", "c_01"]
    assert all(len(answer["hits"]) == 1 for answer in document["queries"].values())


def test_weights_legs_from_elsewhere_and_chosen_clips(source, tmp_path):
    line = ["--query", "a_01", "--lower", "b_01:10-90", "--weights", "left_arm=.35,right_arm=.45,lower_body=.2"]
    document = found(tmp_path, source, *line, "--clips", "c_01")
    assert {hit["clip"] for hit in next(iter(document["queries"].values()))["hits"]} == {"c_01"}
    assert document["parameters"]["weights"]["left_arm"] == 0.35


def test_files_are_searched_for_a_recording_that_is_not_among_them(tmp_path):
    folder = tmp_path / "clips"
    folder.mkdir()
    for clip in walkers(("d_01", "e_01"), seconds=2.0).clips:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    write_bvh(tmp_path / "asked.bvh", walkers(("asked",), seconds=2.0).clips[0])
    document = found(tmp_path, str(folder), "--query", f"{tmp_path}/asked.bvh:10-50")
    assert {hit["clip"] for hit in next(iter(document["queries"].values()))["hits"]} <= {"d_01", "e_01"}
    document = found(tmp_path, str(folder), "--query", "d_01", "--clips", "e_01")
    assert [hit["clip"] for hit in document["queries"]["d_01"]["hits"]] == ["e_01"]


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ([], "--query"),
        (["--query", "nobody"], "no clip 'nobody'"),
        (["--query", "a_01:9-3"], "frames"),
        (["--query", "a_01", "--weights", "tail=1"], "no part of the body"),
        (["--query", "a_01", "--weights", "left_arm"], "not a number"),
        (["--query", "a_01", "--method", "guess"], "bounded-edit"),
        (["--query", "a_01", "--top", "0"], "at least 1"),
        (["--query", "a_01", "--root-path", "3"], "0 to 1"),
        (["--queries", "/nowhere.json"], "no such file"),
    ],
)
def test_what_cannot_be_asked_is_one_clear_line(source, tmp_path, capsys, line, words):
    try:
        code = main(["search", source, *line, "--out", str(tmp_path / "h.json"), "--quiet"])
    except SystemExit as ended:
        code = ended.code
    said = capsys.readouterr().err
    assert code == 2 and words in said and said.count("\n") == 1


def test_words_find_clips_and_stretches(source, tmp_path):
    document = found(tmp_path, source, "--words", "walking", "--words", "walk then lie down")
    assert document["format"] == "motionscape/hits/1" and list(document["queries"]) == ["walking", "walk then lie down"]
    answer = document["queries"]["walking"]
    assert {hit["clip"] for hit in answer["hits"]} == {"a_01", "b_01", "c_01"} and answer["milliseconds"] >= 0
    assert all(
        0 <= hit["score"] <= 1 and {"word", "start", "end", "score"} == set(hit["words"][0]) for hit in answer["hits"]
    )
    assert document["queries"]["walk then lie down"]["hits"][0]["score"] < 0.5 < answer["hits"][0]["score"]
    stretches = found(tmp_path, source, "--words", "walking", "--level", "interval", "--top", "2")["queries"]["walking"]
    assert 1 <= len(stretches["hits"]) <= 2 and stretches["hits"][0]["start"] < stretches["hits"][0]["end"]


def test_words_that_are_not_known_are_said(source, tmp_path, capsys):
    answer = found(tmp_path, source, "--words", "somersalt")["queries"]["somersalt"]
    assert answer["hits"] == [] and "somersault" in answer["unknown"]["somersalt"]
    assert "'somersalt' is not known; known are" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("line", "said"),
    [
        (["--words", " "], "say what to look for"),
        (["--words", "walk", "--query", "a_01"], "--words goes without --query"),
    ],
)
def test_words_that_cannot_be_searched_for_are_refused(source, tmp_path, capsys, line, said):
    assert main(["search", source, *line, "--out", str(tmp_path / "hits.json"), "--quiet"]) == 2
    assert said in capsys.readouterr().err and not (tmp_path / "hits.json").exists()
