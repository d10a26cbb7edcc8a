"""``--unit``, ``--up``, ``--fps`` and ``--body`` on the command line, ``reread`` and ``body``."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from core.workspace import Workspace
from tests.core.mocap.odd_clips import dog, in_other_axes, walking, written
from tests.core.mocap.test_reading import FROM_Y
from webapp.cli import main


@pytest.fixture
def folder(tmp_path):
    return written(tmp_path / "files", walking(), replace(in_other_axes(walking(), FROM_Y["z"]), name="turned"), dog())


def test_inspect_says_what_was_read(folder, capsys):
    (folder / "bad.bvh").write_text("HIERARCHY\n")
    assert main.main(["inspect", "--json", "--quiet", str(folder)]) == 2
    files = {entry["path"].rpartition("/")[2]: entry for entry in json.loads(capsys.readouterr().out)["files"]}
    turned = files["turned.bvh"]
    assert (turned["frames"], turned["fps"], turned["unit"], turned["up"]) == (180, 60.0, "cm", "z")
    assert turned["body"] == "human" and 1.7 < turned["height"] < 1.9 and turned["verdict"] == "ok"
    assert turned["joints"]["left_knee"] == "LeftLeg"
    assert files["dog.bvh"]["body"] == "other" and files["dog.bvh"]["findings"][0]["kind"] == "body"
    assert "frames" not in files["bad.bvh"] and files["bad.bvh"]["verdict"] == "error"


def test_what_is_said_counts_on_every_command(folder, tmp_path, capsys):
    assert main.main(["inspect", "--json", "--quiet", str(folder), "--up", "x", "--unit", "in", "--fps", "25"]) == 0
    for entry in json.loads(capsys.readouterr().out)["files"]:
        assert (entry["up"], entry["unit"], entry["fps"]) == ("x", "in", 25.0)
    assert main.main(["import", str(tmp_path / "space"), str(folder), "--name", "a", "--fps", "25", "--quiet"]) == 0
    assert {clip.fps for clip in Workspace(tmp_path / "space").open("a").clips} == {25}
    for source in (str(folder), f"{tmp_path}/space/a"):
        out = tmp_path / "walk.bvh"
        line = ["export", source, "--clips", "walk", "--out", str(out), "--fps", "50", "--unit", "dm", "--quiet"]
        assert main.main(line) == 0
        assert "Frame Time: 0.02\n" in out.read_text()
    assert {clip.fps for clip in Workspace(tmp_path / "space").open("a").clips} == {25}  # stored as it was


def test_reread_and_body(folder, tmp_path, capsys):
    space = tmp_path / "space"
    main.main(["import", str(space), str(folder), "--name", "a", "--quiet"])
    assert main.main(["body", f"{space}/a", "--out", str(tmp_path / "body.json")]) == 0
    document = json.loads((tmp_path / "body.json").read_text())
    (person,) = (rig for rig in document["rigs"] if rig["body"] == "human")
    person["joints"]["left_toe"] = None
    (tmp_path / "body.json").write_text(json.dumps(document))
    assert main.main(["reread", f"{space}/a", "--body", str(tmp_path / "body.json"), "--fps", "24"]) == 0
    from core.mocap.anatomy import find_anatomy

    clips = Workspace(space).open("a").clips
    assert {clip.fps for clip in clips} == {24}
    assert all("left_toe" not in find_anatomy(clip.skeleton).joints for clip in clips)
    capsys.readouterr()
    for line, words in [
        (["reread", f"{space}/a"], "Say what to change"),
        (["reread", str(folder), "--fps", "24"], "WORKSPACE/NAME"),
        (["reread", f"{space}/a", "--fps", "24"], "Nothing changes"),
        (["inspect", str(folder), "--body", str(folder / "walk.bvh")], "walk.bvh: not JSON"),
    ]:
        assert main.main(line) == 2
        assert words in capsys.readouterr().err
    for line in (["inspect", ".", "--up", "w"], ["inspect", ".", "--unit", "stone"]):
        with pytest.raises(SystemExit):
            main.main(line)
