"""A result's recipes give the very result again."""

from __future__ import annotations

import json
import shlex
import subprocess
import sys

import pytest

from core import analyses
from core.mocap.bvh import read_bvh
from core.motifs.compare import compare
from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.cli.main import main
from webapp.features.motifs.recipes import compare_commands, compare_script
from webapp.shell import recipes


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    made = Workspace(tmp_path_factory.mktemp("re cipes") / "work's")
    made.add_dataset("two walkers", walkers(("a", "b"), seconds=6.0))
    yield made
    made.close()


REQUEST = analyses.Request(
    "two walkers", "motifs", {"kappa": 30, "rho": 0.5, "min_letters": 3, "adjacency": "spheres", "init": "random"}
)


def test_the_command_gives_the_result_again(workspace, tmp_path, monkeypatch):
    wanted = analyses.run(workspace, REQUEST)
    program, *words = shlex.split(recipes.command(workspace.path, REQUEST))
    assert program == "motionscape"
    monkeypatch.chdir(tmp_path)
    workspace.results.remove(analyses.key(workspace, REQUEST))
    assert main([*words, "--quiet"]) == 0
    found = json.loads((tmp_path / "motifs.json").read_text())
    assert found["motifs"] == wanted.to_json()["motifs"] and found["metrics"] == dict(wanted.metrics)


def test_the_script_gives_the_result_again(workspace):
    wanted = analyses.run(workspace, REQUEST)
    text = recipes.script(workspace.path, REQUEST)
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=240, check=True)
    assert done.stdout.strip() == str(dict(wanted.metrics))


@pytest.mark.parametrize("path", ["0-1-0", "random:5:3", "fewest:0:1"])
def test_a_walk_has_two_commands(workspace, tmp_path, monkeypatch, path):
    values = dict(REQUEST.parameters) | {"path": path, "gaps": "bridge"}
    request = analyses.Request("two walkers", "walk", values)
    wanted = analyses.run(workspace, request)
    monkeypatch.chdir(tmp_path)
    first, second = recipes.texts(workspace.path, request)["Copy as commands"].split("\n")
    assert main([*shlex.split(first)[1:], "--quiet"]) == 0 and main([*shlex.split(second)[1:], "--quiet"]) == 0
    assert read_bvh(tmp_path / "walk.bvh").n_frames == wanted.clip.n_frames


def test_any_result_has_a_script(workspace):
    request = analyses.Request("two walkers", "redundancy", {"kappa": 30, "alike": 0.2})
    assert list(recipes.texts(workspace.path, request)) == ["Copy as Python"]
    found = {}
    exec(recipes.script(workspace.path, request), found)
    assert found["result"].to_json() == analyses.run(workspace, request).to_json()


def test_stability_has_a_command(workspace, tmp_path, monkeypatch):
    request = analyses.Request("two walkers", "stability", dict(REQUEST.parameters) | {"repetitions": 1})
    wanted = analyses.run(workspace, request).to_json()
    monkeypatch.chdir(tmp_path)
    workspace.results.remove(analyses.key(workspace, request))
    text = recipes.texts(workspace.path, request)["Copy as command"]
    assert main([*shlex.split(text)[1:], "--quiet"]) == 0
    found = json.loads((tmp_path / "stability.json").read_text())
    assert found["motifs"] == wanted["motifs"] and found["repeats"] == wanted["repeats"]


def test_comparing_has_commands_and_a_script(workspace, tmp_path, monkeypatch):
    other = analyses.Request("two walkers", "motifs", {**REQUEST.parameters, "seed": 1})
    wanted = compare(analyses.run(workspace, REQUEST), analyses.run(workspace, other))
    monkeypatch.chdir(tmp_path)
    for line in compare_commands(workspace.path, REQUEST, other).split("\n"):
        assert main([*shlex.split(line)[1:], "--quiet"]) == 0
    assert json.loads((tmp_path / "comparison.json").read_text()) == json.loads(json.dumps(wanted.to_json()))
    found = {}
    exec(compare_script(workspace.path, REQUEST, other), found)
    assert found["result"].to_json() == wanted.to_json()


def test_defaults_are_left_out(workspace):
    text = recipes.command(workspace.path, analyses.Request("two walkers", "motifs", {"kappa": "auto", "seed": 3}))
    assert "kappa" not in text and "--seed 3" in text
