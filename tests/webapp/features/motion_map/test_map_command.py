"""``motionscape map`` on a workspace's data set and on files."""

from __future__ import annotations

import json

import pytest

from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.cli.main import main


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    made = Workspace(tmp_path_factory.mktemp("map") / "ws")
    made.add_dataset("walkers", walkers(("a_01", "b_01"), seconds=4.0))
    yield made
    made.close()


def test_a_map_is_written_as_the_contract_says(workspace, tmp_path, capsys):
    out = tmp_path / "map.json"
    assert main(["map", f"{workspace.path}/walkers", "--grid", "8x6", "--out", str(out)]) == 0
    found = json.loads(out.read_text())
    assert found["format"] == "motionscape/map/1" and found["grid"] == [8, 6] and found["samples"] > 10
    assert {run["clip"] for run in found["runs"]} == {"a_01", "b_01"} and len(found["regions"]) >= 1
    assert "8 x 6 nodes" in capsys.readouterr().out


def test_a_file_is_mapped_without_a_workspace(tmp_path):
    write_bvh(tmp_path / "walk.bvh", walkers(("walk",), seconds=2.0).clips[0])
    source, out = str(tmp_path / "walk.bvh"), tmp_path / "m.json"
    assert main(["map", source, "--grid", "4x4", "--samples", "50", "--out", str(out), "--quiet"]) == 0
    assert json.loads(out.read_text())["clips"][0]["name"] == "walk"


def test_a_grid_that_is_none_is_one_clear_line(workspace, tmp_path, capsys):
    assert main(["map", f"{workspace.path}/walkers", "--grid", "9", "--out", str(tmp_path / "m.json")]) == 2
    assert "21x21" in capsys.readouterr().err
