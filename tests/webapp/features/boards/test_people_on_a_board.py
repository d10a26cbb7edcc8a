"""Two people on one board over HTTP: accounts, read and edit links, and what each of them may do."""

from __future__ import annotations

import pytest

from core.workspace import Block, Workspace
from tests.webapp.generated import walkers
from webapp.app import create_app

PASSWORD = "correct horse"
OWN = {"X-Motionscape": "1"}


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    for name, clip in (("walkers", "a"), ("secret", "b")):
        workspace.add_dataset(name, walkers((clip,), seconds=2.0))
    for name, role in (("ann", "editor"), ("vic", "viewer")):
        workspace.users.add(name, PASSWORD, role)
    return workspace


@pytest.fixture
def server(workspace):
    return create_app(workspace.path).server


@pytest.fixture
def board(workspace):
    board = workspace.boards.create("Overview", [Block("one", "text", settings={"options": {"markdown": "hello"}})])
    return workspace.boards.set_filters(board.id, {"dataset": "walkers"})


class Visitor:
    """A browser of its own."""

    def __init__(self, server):
        self.client = server.test_client()

    def get(self, path, tag=""):
        return self.client.get(f"/api/{path}", headers={"If-None-Match": tag})

    def post(self, path, **body):
        return self.client.post(f"/api/{path}", json=body, headers=OWN)


@pytest.fixture
def signed_in(server):
    def signed_in(name):
        visitor = Visitor(server)
        visitor.client.post("/sign-in", data={"name": name, "password": PASSWORD})
        return visitor

    return signed_in


@pytest.fixture
def with_link(server, board):
    def with_link(key):
        visitor = Visitor(server)
        assert visitor.client.get(f"/boards?board={board.id}&key={key}").location == f"/boards?board={board.id}"
        return visitor

    return with_link


def changed(board, text, version=1, **more):
    block = {"id": "one", "kind": "text", "settings": {"options": {"markdown": text}, **more}}
    return {"path": f"boards/{board.id}", "action": "change", "block": block, "version": version}


def test_a_change_of_one_reaches_the_other_and_costs_nothing_before(signed_in, with_link, board):
    ann, guest, path = signed_in("ann"), with_link(board.read_key), f"boards/{board.id}"
    tag = guest.get(path).headers["ETag"]
    same = guest.get(path, tag)
    assert same.status_code == 304 and same.data == b""
    assert ann.post(**changed(board, "new")).status_code == 200
    news = guest.get(path, tag)
    assert news.status_code == 200 and news.headers["ETag"] != tag
    (block,) = news.json["blocks"]
    assert (block["settings"]["options"], block["author"]) == ({"markdown": "new"}, "ann")
    ann.post("comments", action="add", place=f"board:{board.id}/block:one", text="look @vic")
    assert guest.get(path, news.headers["ETag"]).json["comments"][0]["mentions"] == ["vic"]


def test_two_who_save_at_once_are_told_by_name(signed_in, with_link, board):
    ann, guest = signed_in("ann"), with_link(board.edit_key)
    assert ann.post(**changed(board, "ann's")).status_code == 200
    refused = guest.post(**changed(board, "guest's"))
    assert refused.status_code == 409 and refused.json["author"] == "ann"
    theirs = refused.json["theirs"]
    assert theirs["settings"]["options"] == {"markdown": "ann's"}
    assert guest.post(**changed(board, "both", version=theirs["version"])).status_code == 200


def test_those_who_can_be_mentioned_are_the_accounts_and_for_guests_those_who_worked_on_it(signed_in, with_link, board):
    assert signed_in("vic").get(f"boards/{board.id}").json["names"] == ["ann", "vic"]
    assert with_link(board.read_key).get(f"boards/{board.id}").json["names"] == []


def test_a_read_link_shows_the_board_and_changes_nothing(with_link, board, workspace):
    guest, other = with_link(board.read_key), workspace.boards.create("Other")
    shown = guest.get(f"boards/{board.id}")
    assert shown.json["may_edit"] is False and shown.json["datasets"] == ["walkers"]
    assert board.edit_key not in shown.text
    assert [entry["id"] for entry in guest.get("boards").json["boards"]] == [board.id]
    assert guest.get(f"boards/{other.id}").status_code == 404
    assert guest.get(f"boards/{other.id}/history").status_code == 404
    assert guest.get("motion/secret/b").status_code == 404 and guest.get("motion/walkers/a").status_code == 200
    for refused in (
        guest.post(**changed(board, "x")),
        guest.post("boards", title="mine"),
        guest.post("comments", action="add", place=f"board:{board.id}", text="x"),
        guest.post("views", address="/map", title="x"),
    ):
        assert refused.status_code == 403
    assert workspace.boards.get(board.id) == board


def test_an_edit_link_changes_this_board_and_no_more(with_link, board, workspace):
    guest, path = with_link(board.edit_key), f"boards/{board.id}"
    other = workspace.boards.create("Other")
    assert guest.post(**changed(board, "by a guest")).json["blocks"][0]["author"] == "guest"
    assert (
        guest.post("comments", action="add", place=f"board:{board.id}", text="x", author="ann").json["author"]
        == "guest"
    )
    for refused in (
        guest.post(**changed(board, "x", version=3, dataset="secret")),
        guest.post(path, action="filter", filters={"dataset": "secret"}),
        guest.post(path, action="delete"),
        guest.post(path, action="duplicate"),
        guest.post(path, action="renew-links"),
        guest.post("comments", action="add", place="motif:secret/aa/1", text="x"),
        guest.post("boards", title="mine"),
    ):
        assert refused.status_code == 403, refused.text
    assert guest.post(f"boards/{other.id}", action="rename", title="x").status_code in (403, 404)
    assert workspace.boards.get(other.id).title == "Other"
    assert guest.client.delete("/api/uploads/0123456789abcdef", headers=OWN).status_code == 403


def test_a_viewer_with_an_edit_link_edits_under_their_own_name(signed_in, board):
    vic = signed_in("vic")
    assert vic.post(**changed(board, "x")).status_code == 403
    vic.client.get(f"/boards?board={board.id}&key={board.edit_key}")
    assert vic.post(**changed(board, "x")).json["blocks"][0]["author"] == "vic"
    assert vic.post("boards", title="mine").status_code == 403


def test_a_link_that_was_renewed_is_said_to_be_gone(signed_in, with_link, board):
    ann, guest = signed_in("ann"), with_link(board.read_key)
    assert ann.post(f"boards/{board.id}", action="renew-links").status_code == 200
    assert guest.get(f"boards/{board.id}").status_code == 401
    assert ann.get(f"boards/{board.id}").status_code == 200


def test_who_changed_what_on_a_board_is_on_record(signed_in, with_link, board, workspace):
    signed_in("ann").post(**changed(board, "new"))
    with_link(board.edit_key).post(f"boards/{board.id}", action="rename", title="Report")
    found = [(entry.who, entry.what, entry.subject) for entry in workspace.audit.entries()]
    assert ("ann", "board: block one changed", "Overview") in found
    assert found[-1] == ("guest", "board: renamed", "Report")
