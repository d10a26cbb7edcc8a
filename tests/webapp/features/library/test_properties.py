"""Properties of clips over HTTP and on the command line: preview, keep, undo, and groups of a board."""

from __future__ import annotations

import pytest

from core.demo import make_demo
from core.workspace import Workspace
from core.workspace.blocks import Block
from webapp.app import create_app
from webapp.cli.main import main

HEADERS = {"X-Motionscape": "test"}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("workspace"))
    workspace.add_dataset("demo", make_demo(1.0))
    yield workspace
    workspace.close()


@pytest.fixture(scope="module")
def client(workspace):
    return create_app(workspace.path).server.test_client()


def change(client, **body):
    return client.post("/api/properties/demo", json=body, headers=HEADERS)


def test_properties_are_previewed_kept_and_undone(client, workspace):
    names = workspace.open("demo").names
    shown = change(client, action="names", pattern="{who}_{take}", preview=True).get_json()
    assert [column["name"] for column in shown["columns"]] == ["who", "take"]
    assert shown["rows"][0] == {"clip": names[0], "who": names[0].split("_")[0], "take": names[0].split("_")[1]}
    assert client.get("/api/properties/demo").get_json()["columns"] == []
    assert change(client, action="names", pattern="{who}_{take}").status_code == 200
    kept = change(client, action="set", column="state", value="tired", clips=names[:1]).get_json()
    assert kept["columns"][-1]["missing"] == len(names) - 1
    assert f"{names[0]},{names[0].split('_')[0]}," in client.get("/api/properties/demo/csv").get_data(as_text=True)
    after = change(client, action="restore", version=kept["before"]).get_json()
    assert [column["name"] for column in after["columns"]] == ["who", "take"]


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ({"action": "names", "pattern": "{a}-{b}"}, "No name of a clip has this form"),
        ({"action": "set", "column": "a", "value": "b", "clips": ["nobody"]}, "no clip"),
        ({"action": "set", "column": "a", "value": "b"}, "No clip is chosen"),
        ({"action": "set", "column": "", "value": "b", "clips": ["ana_01"]}, "needs a name"),
        ({"action": "kind", "column": "who", "kind": "number"}, "is no number"),
        ({"action": "kind", "column": "who", "kind": "colour"}, "one of text, number, date"),
        ({"action": "remove", "column": "height"}, "There is no property"),
        ({"action": "table", "table": "a,b\n1,2"}, "no column “clip”"),
        ({"action": "fly"}, "no such change"),
        ({"action": "restore", "version": "x"}, "whole number"),
    ],
)
def test_what_cannot_be_is_said(client, body, words):
    change(client, action="names", pattern="{who}_{take}")
    answer = change(client, **body)
    assert answer.status_code == 400 and words in answer.get_json()["error"]


def test_other_sites_and_unknown_datasets_are_refused(client):
    assert client.post("/api/properties/demo", json={"action": "remove"}).status_code == 403
    assert client.get("/api/properties/nothing").status_code == 400


def test_the_command_reads_and_writes_a_table(workspace, tmp_path, capsys):
    source, table = str(workspace.path / "demo"), tmp_path / "clips.csv"
    assert main(["properties", source, "--names", "{who}_*", "--out", str(table), "--quiet"]) == 0
    assert table.read_text().startswith("clip,")
    table.write_text(table.read_text() + "nobody,1,2\n")
    assert main(["properties", source, "--table", str(table)]) == 0
    out = capsys.readouterr()
    assert "nobody" in out.err and "who (text): ana" in out.out
    assert main(["properties", source, "--names", "{a}+{b}"]) == 2


def test_a_board_is_narrowed_to_a_group(client, workspace):
    change(client, action="names", pattern="{who}_{take}")
    board = workspace.boards.create("Board", [Block("a", "overview")])
    workspace.boards.set_filters(board.id, {"dataset": "demo", "group": "who=ana"})
    data = client.get(f"/api/boards/{board.id}").get_json()
    groups = dict(data["groups"])
    assert "ana" in groups["who"] and data["filters"]["group"] == "who=ana"
    clips = client.get(f"/api/boards/{board.id}/group?of=who=ana").get_json()["clips"]
    assert clips == {"demo": [name for name in workspace.open("demo").names if name.startswith("ana_")]}
    etag = client.get(f"/api/boards/{board.id}").headers["ETag"]
    change(client, action="set", column="who", value="eve", clips=["ana_01"])
    assert client.get(f"/api/boards/{board.id}", headers={"If-None-Match": etag}).status_code == 200
