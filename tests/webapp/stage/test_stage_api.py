"""What the Stage would play for a link: the same as the callback's answer, and never an error page."""

from __future__ import annotations

import json

import pytest

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from webapp.app import create_app
from webapp.shell import playback


@pytest.fixture(scope="module")
def workspace(tmp_path_factory) -> Workspace:
    workspace = Workspace(tmp_path_factory.mktemp("stage") / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.5))
    analyses.run(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))
    return workspace


@pytest.fixture(scope="module")
def client(workspace):
    return create_app(workspace.path).server.test_client()


@pytest.mark.parametrize(
    "selection", [{"motif": 0}, {"motif": 0, "motion": 1}, {"clip": "grammar_1", "start": 3, "end": 9}]
)
def test_a_link_gives_what_its_selection_plays(client, workspace, selection):
    clip = workspace.open("demo").names[0]
    selection = {**selection, **({"clip": clip} if "clip" in selection else {})}
    answer = client.get(
        "/api/stage/motifs", query_string={"dataset": "demo", "analysis_fps": 15, "time": 1, **selection}
    )
    expected = playback.selected_request(workspace, "demo", selection, {"analysis_fps": "15"})
    assert expected["items"]
    assert answer.text == json.dumps(expected), "in the same order, because the Stage compares the two"


@pytest.mark.parametrize(
    "query", ["", "dataset=demo", "dataset=nix&motif=0", "dataset=demo&motif=x", "dataset=demo&motif=0&kappa=77"]
)
def test_where_nothing_plays_there_is_null(client, query):
    answer = client.get(f"/api/stage/motifs?{query}")
    assert answer.status_code == 200 and answer.get_json() is None


def test_what_is_not_there_is_named(workspace):
    def said(**selection):
        return playback.missing(workspace, "demo", selection, {"analysis_fps": "15"})

    assert said(motif=0) is None and said() is None
    assert "no motif 999" in said(motif=999)
    assert "leads from motif 998 to 999" in said(edge="998-999")
    assert "no clip called “swim”" in said(clip="swim")
    assert playback.missing(workspace, "demo", {"motif": 999}, {"kappa": "77"}) is None, "nobody has looked yet"
    assert playback.missing(workspace, "nix", {"motif": 0}) is None
