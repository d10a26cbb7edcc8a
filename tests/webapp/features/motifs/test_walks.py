"""Walks in the app: what a link says, the walk made of it, what the browser gets, and its files."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from core import analyses
from core.demo import make_demo
from core.mocap.bvh import read_bvh
from core.synthesis import open_ways
from core.workspace import Workspace, WorkspaceError
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.motifs import names, walks
from webapp.shell import links, results
from webapp.shell.virtual import open_any


@pytest.fixture(scope="module")
def place(tmp_path_factory) -> Path:
    """A workspace with a little demo and its motif graph."""
    path = tmp_path_factory.mktemp("walks") / "workspace"
    workspace = Workspace(path)
    workspace.add_dataset("demo", make_demo(minutes=0.7, seed=3))
    analyses.run(workspace, analyses.Request("demo", "motifs"))
    workspace.close()
    return path


def data_of(workspace: Workspace, **view: str) -> dict:
    """What the browser gets for a link that says this."""
    dataset, graph = workspace.open("demo"), results.motif_graph(workspace, "demo", {})
    key = results.motif_graph_key(workspace, "demo", {})
    data = walks.walk_data(workspace, dataset, graph, key, {"side": "walk", **view}, {0: "first"})
    assert misfit(data, names.WALK_DATA) is None
    return data


def test_a_walk_is_shown_played_and_saved(place: Path) -> None:
    workspace = Workspace(place)
    data = data_of(workspace, walk="random:6:2")
    assert data["path"] and len(data["visits"]) == len(data["path"]) and data["inputs"] == {"walk": "random:6:2"}
    spans = [tuple(span) for span in data["visits"]]
    assert all(a <= b for a, b in spans) and spans == sorted(spans) and spans[-1][1] <= data["frames"]
    assert data["skate"][2] < data["skate"][1] and not data["jump"]
    assert all(0 <= band["start"] < band["end"] <= data["frames"] for band in data["bands"])
    assert json.loads(json.dumps(data)) == data
    played = open_any(workspace, data["name"])
    assert played.clip("walk").n_frames == data["frames"]
    client = create_app(place).server.test_client()
    bvh = client.get(f"/api/bvh/{data['name']}/walk")
    (place / "walk.bvh").write_bytes(bvh.data)
    assert bvh.status_code == 200 and read_bvh(place / "walk.bvh").n_frames == data["frames"]
    parts = client.get(f"/api/walk/{data['name'].rpartition('~')[2]}.json").json
    assert parts["path"] == data["path"] and parts["parts"][-1]["end"] == data["frames"]
    motion = client.get(f"/api/motion/{data['name']}/walk?start=0&end={data['frames']}")
    assert motion.status_code == 200
    assert not workspace.jobs.list() or all(job.request["method"] == "motifs" for job in workspace.jobs.list())


def test_the_same_link_is_the_same_walk_and_other_words_another(place: Path) -> None:
    workspace = Workspace(place)
    first = data_of(workspace, walk="random:6:2")
    assert data_of(workspace, walk="random:6:2") == first
    assert data_of(workspace, walk="random:6:2", feet="0")["name"] != first["name"]
    further = data_of(workspace, walk="random:6:2", extra="1")
    assert further["further"] and not first["further"]


def test_without_a_path_the_ways_are_there(place: Path) -> None:
    workspace = Workspace(place)
    data = data_of(workspace)
    ways = open_ways(workspace.open("demo"), results.motif_graph(workspace, "demo", {}))
    assert data["dead"] == list(ways.dead_ends) and data["parts"] == [len(part) for part in ways.components]
    assert "name" not in data and "error" not in data
    assert data["motifs"][0] == {"id": 0, "name": "first"}


def test_a_gap_comes_with_its_detour_and_a_bridge_mends_it(place: Path) -> None:
    workspace = Workspace(place)
    ways = open_ways(workspace.open("demo"), results.motif_graph(workspace, "demo", {}))
    ids = list(ways.following)
    a, b = next((a, b) for a in ids for b in ids if a != b and (a, b) not in ways.links)
    data = data_of(workspace, walk=f"{a}-{b}")
    assert data["gap"] == [a, b] and data["path"] == [a, b] and f"No edge leads from motif {a}" in data["error"]
    mended = data_of(workspace, walk=f"{a}-{b}", gaps="bridge")
    assert mended["kinds"] == ["bridge"] and mended["unseen"] == 1
    for walk, words in (
        ("0-99999", "There is no motif 99999"),
        ("nonsense", "is no path"),
        ("random:0:1", "more than 0"),
    ):
        assert words in data_of(workspace, walk=walk)["error"]
    assert "gaps" in data_of(workspace, walk="0", gaps="nonsense")["error"]


def test_walks_that_are_not_there_are_refused(place: Path) -> None:
    workspace = Workspace(place)
    for name in ("~walk~", "~walk~../../etc", "~walk~" + "0" * 32):
        with pytest.raises(WorkspaceError, match="no longer there"):
            open_any(workspace, name)
    client = create_app(place).server.test_client()
    for key in ("0" * 32, "xyz"):
        answer = client.get(f"/api/walk/{key}.json")
        assert answer.status_code == 404 and "no longer there" in answer.json["error"]


def test_links_keep_what_says_which_walk_it_is() -> None:
    view = {"side": "walk", "walk": "random:30:7", "extra": "1", "gaps": "bridge", "ends": "stop", "feet": "0"}
    link = links.format_link(links.View("motifs", "demo", view=view))
    back, problems = links.parse(*link.split("?"))
    assert dict(back.view) == view and not problems
    asked = walks.walk_request("demo", {"kappa": "50", **back.view})
    assert asked.parameters == {
        **{"kappa": 50, "path": "random:30:7", "further": True, "gaps": "bridge"},
        **{"dead_end": "stop", "keep_feet": False},
    }
