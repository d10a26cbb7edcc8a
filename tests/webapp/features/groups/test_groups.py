"""The Groups page's routes and the command: what is compared, how far it is, files, and what cannot be compared."""

from __future__ import annotations

import csv
import json

import numpy as np
import pytest

from core import analyses
from core.demo.planted import planted_groups
from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from webapp.app import create_app
from webapp.cli.main import main

HEADERS = {"X-Motionscape": "test"}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("workspace"))
    dataset, properties = planted_groups("wider", 4, pieces=12)
    workspace.add_dataset("people", dataset)
    workspace.properties.put(workspace.info("people").id, properties)
    yield workspace
    workspace.close()


@pytest.fixture(scope="module")
def client(workspace):
    return create_app(workspace.path).server.test_client()


def test_a_comparison_is_made_shown_and_saved(client, workspace, monkeypatch):
    choices = client.get("/api/groups/people").get_json()
    assert choices["who"] == "subject" and choices["labels"] and choices["columns"][1]["name"] == "group"
    address = "/api/groups/people/comparison?by=group"
    assert client.get(address).get_json() == {"state": "missing"}
    monkeypatch.setattr("webapp.jobs.ensure_worker", lambda workspace: False, raising=False)
    monkeypatch.setattr("webapp.jobs.launching.ensure_worker", lambda workspace: False)
    job = client.post("/api/groups/people/comparison", json={"by": "group"}, headers=HEADERS).get_json()["job"]
    assert client.get(address).get_json()["state"] == "running"
    analyses.execute(workspace, workspace.jobs.claim(job))
    document = client.get(address).get_json()["document"]
    arms = [row for row in document["comparisons"] if "arm away" in row["name"]]
    assert all(row["difference"] > 3 and row["effect"] > 0 and row["n"] == [4, 4] for row in arms)
    assert document["unit"] == "subject" and not document["paired"]
    table = client.get("/api/groups/people/csv.file?by=group").get_data(as_text=True)
    rows = list(csv.DictReader(table.splitlines()))
    assert len(rows) == len(document["comparisons"]) + len(document["transitions"])
    assert {row["test_unit"] for row in rows} == {"subject"}
    script = client.get("/api/groups/people/py.file?by=group").get_data(as_text=True)
    compile(script, "groups.py", "exec")
    assert "--by group" in client.get("/api/groups/people/sh.file?by=group").get_data(as_text=True)
    assert client.get("/api/groups/people/xls.file?by=group").status_code == 400
    assert client.get("/api/groups/people/csv.file?by=group&counted=motifs").status_code == 404


@pytest.mark.parametrize(
    ("query", "words"),
    [
        ("by=height", "There is no property"),
        ("by=subject", "Groups need 2 clips at least"),
        ("by=group&first=A&second=C", "No clip has the group 'C'"),
        ("by=group&first=A", "One group alone"),
        ("by=group&counted=steps", "motifs, grammar or labels"),
        ("by=group&paired=yes", "Only 0 of 8"),
        ("", "There is no property"),
    ],
)
def test_what_cannot_be_compared_is_said_in_words(client, query, words):
    answer = client.get(f"/api/groups/people/comparison?{query}")
    assert answer.status_code == 200 and answer.get_json()["state"] == "refused"
    assert words in answer.get_json()["error"]
    assert client.get("/api/groups/nothing").status_code == 400


def test_the_command_writes_json_and_a_table(workspace, tmp_path, capsys):
    source, out = str(workspace.path / "people"), tmp_path / "groups.json"
    assert main(["compare-groups", source, "--by", "group", "--out", str(out), "--permutations", "200"]) == 0
    document = json.loads(out.read_text())
    assert document["format"] == "motionscape/groups/1" and document["by"] == "group"
    assert "Test: permutation of subjects between groups" in capsys.readouterr().out
    assert main(["compare-groups", source, "--by", "group", "--out", str(tmp_path / "groups.csv"), "--quiet"]) == 0
    assert (tmp_path / "groups.csv").read_text().startswith("kind,id,name,measure")
    for arguments, words in [
        (["--by", "height", "--out", str(out)], "There is no property 'height'"),
        (["--by", "group", "--out", str(tmp_path / "groups.xls")], "--out names a file .json or .csv"),
        (["--by", "group", "--properties", str(tmp_path / "none.csv"), "--out", str(out)], "none.csv"),
        (["--by", "group", "--from", str(out), "--out", str(tmp_path / "other.json")], "not a file that"),
    ]:
        assert main(["compare-groups", source, *arguments]) == 2
        assert words in capsys.readouterr().err


def test_recordings_in_a_folder_are_compared_by_a_table(workspace, tmp_path, capsys):
    dataset = workspace.open("people")
    for clip in (dataset.clips[0], dataset.clips[1], dataset.clips[4], dataset.clips[5]):
        write_bvh(tmp_path / f"{clip.name}.bvh", clip.cut(0, 400, clip.name))
    table = tmp_path / "clips.csv"
    table.write_text("clip,group\np000,A\np001,A\np004,B\np005,B\nnobody,B\n")
    arguments = ["compare-groups", str(tmp_path), "--by", "group", "--out", str(tmp_path / "out.json")]
    assert main(arguments) == 2 and "no labels to count" in capsys.readouterr().err
    assert main(["motifs", str(tmp_path), "--out", str(tmp_path / "motifs.json"), "--quiet"]) == 0
    arguments += ["--from", str(tmp_path / "motifs.json")]
    assert main(arguments) == 2 and "--properties clips.csv" in capsys.readouterr().err
    assert main([*arguments, "--properties", str(table)]) == 0
    said = capsys.readouterr()
    assert "nobody" in said.err and "clips are compared" in said.err and "So few clips" in said.out
    document = json.loads((tmp_path / "out.json").read_text())
    assert document["unit"] == "clip" and document["smallest_p"] == pytest.approx(1 / 3)
    assert not any(row["significant"] for row in document["comparisons"])
    assert np.isfinite([row["p"] for row in document["comparisons"] if row["p"] is not None]).all()
