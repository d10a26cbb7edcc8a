"""The routes of boards, saved views and comments: what they keep, refuse and tell."""

from __future__ import annotations

import base64
from dataclasses import replace

import numpy as np
import pytest

from core import analyses
from core.workspace import Person, Workspace, acting_as
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.features.boards import contents
from webapp.features.boards.parts import Part
from webapp.features.boards.templates import TEMPLATES
from webapp.features.sweeps import reading
from webapp.shell import settings
from webapp.shell.feature import blocks

HEADERS = {"Host": "localhost", "X-Motionscape": "boards"}
JPEG = "data:image/jpeg;base64," + base64.b64encode(b"\xff\xd8\xff\xe0 small").decode()


@pytest.fixture
def workspace(tmp_path):
    found = Workspace(tmp_path)
    found.add_dataset("walks", walkers(("a", "b")))
    return found


@pytest.fixture
def ask(workspace):
    client = create_app(workspace.path).server.test_client()

    def ask_one(path: str, body: dict | None = None, **headers: str):
        method = client.get if body is None else client.post
        return method(f"/api/{path}", json=body, headers=HEADERS | headers)

    return ask_one


@pytest.fixture
def board(ask):
    return ask("boards", {"template": "overview", "title": "Walks", "dataset": "walks", "author": "Ana"}).json


def block_of(board: dict, kind: str) -> dict:
    return next(block for block in board["blocks"] if block["kind"] == kind)


def changed(block: dict, **settings) -> dict:
    return {"id": block["id"], "kind": block["kind"], "settings": block["settings"] | settings}


def test_every_template_is_made_of_blocks_that_exist_and_do_not_overlap():
    for template in TEMPLATES.values():
        cells = [(x + i, y + j) for _, _, x, y, w, h, _ in template.blocks for i in range(w) for j in range(h)]
        assert len(cells) == len(set(cells)) and all(x < 12 for x, _ in cells)
        assert {kind for kind, *_ in template.blocks} <= set(blocks())


@pytest.mark.parametrize("body", [b"", b"[]", b"{", b"\xff", b"[" * 100_000])
def test_what_is_no_json_object_is_refused(workspace, body):
    client = create_app(workspace.path).server.test_client()
    assert client.post("/api/boards", data=body, content_type="application/json", headers=HEADERS).status_code == 400


def test_an_open_board_costs_nothing_while_nothing_changes(ask, board, workspace):
    first = ask(f"boards/{board['id']}")
    mark = first.headers["ETag"]
    assert ask(f"boards/{board['id']}", **{"If-None-Match": mark}).status_code == 304
    ask("comments", {"action": "add", "place": f"board:{board['id']}", "text": "look @Ben", "author": "Ana"})
    second = ask(f"boards/{board['id']}", **{"If-None-Match": mark})
    assert second.status_code == 200 and second.json["comments"][0]["mentions"] == ["Ben"]
    mark = second.headers["ETag"]
    workspace.remove_clips("walks", ["b"])
    assert ask(f"boards/{board['id']}", **{"If-None-Match": mark}).status_code == 200


def test_two_who_change_one_block_are_told_and_nothing_is_lost(ask, board):
    block, where = block_of(board, "numbers"), f"boards/{board['id']}"
    mine = {"action": "change", "version": block["version"], "block": changed(block, title="Ana's"), "author": "Ana"}
    assert ask(where, mine).status_code == 200
    theirs = mine | {"block": changed(block, title="Ben's"), "author": "Ben"}
    answer = ask(where, theirs)
    assert answer.status_code == 409 and answer.json["conflict"] and answer.json["author"] == "Ana"
    assert answer.json["theirs"]["settings"]["title"] == "Ana's"
    assert ask(where, theirs | {"version": answer.json["theirs"]["version"]}).status_code == 200
    other = block_of(board, "map")
    assert ask(where, mine | {"version": other["version"], "block": changed(other, title="Map")}).status_code == 200


def test_blocks_are_moved_removed_brought_back_and_the_board_too(ask, board):
    where, block = f"boards/{board['id']}", block_of(board, "graph")
    moved = ask(where, {"action": "move", "places": {block["id"]: [1, 2, 3, 4]}}).json
    assert [block_of(moved, "graph")[k] for k in "xywh"] == [1, 2, 3, 4]
    gone = ask(where, {"action": "remove", "block": block["id"]}).json
    assert len(gone["blocks"]) == len(board["blocks"]) - 1
    back = ask(where, {"action": "add", "block": block}).json
    assert block_of(back, "graph")["id"] == block["id"]
    assert ask(where, {"action": "delete"}).json == {"deleted": True}
    assert ask(where).status_code == 404 and ask(where).json["gone"]
    assert ask(where, {"action": "undelete"}).json["title"] == "Walks"
    copy = ask(where, {"action": "duplicate"}).json
    assert copy["id"] != board["id"] and len(copy["blocks"]) == len(back["blocks"])
    assert [change["what"] for change in ask(f"{where}/history").json["history"]][-1] == "made"


def test_a_block_stays_as_it_was_until_it_is_renewed(ask, board, workspace):
    block, where = block_of(board, "overview"), f"boards/{board['id']}"
    address = f"{where}/blocks/{block['id']}"
    pinned = ask(where, {"action": "renew"}).json
    assert block_of(pinned, "overview")["settings"]["pinned"]["dataset"] == "walks"
    assert ask(address).json["state"] == "current"
    workspace.remove_clips("walks", ["b"])
    stale = ask(address).json
    assert stale["state"] == "changed" and "has changed since" in stale["words"]
    assert [clip["name"] for clip in stale["content"]["clips"]] == ["a", "b"]
    assert block_of(ask(where).json, "overview")["data"] == "changed"
    ask(where, {"action": "renew", "block": block["id"]})
    fresh = ask(address).json
    assert fresh["state"] == "current" and [clip["name"] for clip in fresh["content"]["clips"]] == ["a"]


def test_nothing_is_offered_to_compute_where_nothing_was_chosen(workspace):
    workspace.open("walks")
    for kind, words in (("hits", "search, then add it again"), ("stage", "select something")):
        found = contents.answer(workspace, "walks", Part(kind))
        assert found.state == "broken" and words in found.words
    assert contents.answer(workspace, "walks", Part("motifs")).state == "missing"


def test_map_and_sweep_say_what_lights_and_fades_them(ask, board, workspace):
    dataset = workspace.open("walks")
    analyses.run(workspace, analyses.Request("walks", "map"))
    content = contents.answer(workspace, "walks", Part("map")).content
    stays = np.reshape(content["stays"], (-1, 5))
    assert stays[:, 1].max() < len(content["heights"]) and stays[:, 4].max() < len(content["labels"])
    for clip, seconds in zip(content["clips"], (clip.seconds for clip in dataset.clips), strict=True):
        own = stays[stays[:, 0] == content["clips"].index(clip)]
        assert (own[:, 3] - own[:, 2]).sum() == pytest.approx(seconds * dataset.clip(clip).fps, rel=0.1)
    view = {"x": "kappa:4,6", "y": "rho:0.5,0.75,1.5", "seeds": "2"}
    asked = reading.sweep_of(reading.form_of(dataset, view), view)
    analyses.run(workspace, reading.request_of("walks", asked))
    chart = contents.answer(workspace, "walks", Part("sweep", view=view)).content
    shown = [[settings.request_of("motifs", "", place).parameters for place in row] for row in chart["settings"]]
    assert [[(values["kappa"], values["rho"]) for values in row] for row in shown] == [
        [(4, rho), (6, rho)] for rho in (0.5, 0.75, 1.5)
    ]
    assert "kappa" in chart["keys"] and "seed" not in chart["keys"]


def test_what_is_not_computed_or_gone_is_said(ask, board, workspace):
    address = f"boards/{board['id']}/blocks/{block_of(board, 'graph')['id']}"
    missing = ask(address).json
    assert missing["state"] == "missing" and "not computed" in missing["words"] and missing["content"] is None
    analyses.run(workspace, analyses.Request("walks", "motifs"))
    there = ask(address).json
    assert there["state"] == "current" and there["content"]["motifs"]
    ask(f"boards/{board['id']}", {"action": "renew"})
    ask(address)
    workspace.trash("walks")
    gone = ask(address).json
    assert gone["state"] == "gone" and "no longer here" in gone["words"] and gone["content"] == there["content"]


def test_what_another_version_computed_is_shown_until_it_is_computed_again(ask, board, workspace):
    address = f"boards/{board['id']}/blocks/{block_of(board, 'graph')['id']}"
    request = analyses.Request("walks", "motifs")
    analyses.run(workspace, request)
    before = ask(address).json
    workspace.results.remove(analyses.key(workspace, request))
    contents._made.clear()
    analyses._results.clear()
    after = ask(address).json
    assert after["state"] == "missing" and "as it was" in after["words"] and after["content"] == before["content"]


def test_names_of_motifs_reach_the_board(ask, board, workspace):
    request = analyses.Request("walks", "motifs")
    graph = analyses.run(workspace, request)
    address = f"boards/{board['id']}/blocks/{block_of(board, 'graph')['id']}"
    before = ask(address).json["content"]["motifs"][0]
    key, dataset = analyses.key(workspace, request), workspace.info("walks").id
    workspace.notes.put(dataset, key, before["id"], graph.motifs[0].segments, name="stroll")
    assert ask(address).json["content"]["motifs"][0]["name"] == f"{before['id']} stroll"


def test_saved_views_have_pictures_versions_and_conflicts(ask):
    view = {"address": "/motifs?dataset=walks", "title": "Graph", "tags": ["a", "b"], "author": "Ana", "picture": JPEG}
    saved = ask("views", view).json
    assert ask(f"views/{saved['id']}/picture").data.startswith(b"\xff\xd8")
    again = ask("views", view | {"id": saved["id"], "version": 1, "title": "The graph", "picture": ""}).json
    assert again["version"] == 2 and ask(f"views/{saved['id']}/picture").status_code == 200
    assert ask("views", view | {"id": saved["id"], "version": 1}).status_code == 409
    assert ask(f"views/{saved['id']}", {"action": "restore", "version": 1}).json["title"] == "Graph"
    assert ask(f"views/{saved['id']}", {"action": "delete"}).json == {"deleted": True}
    assert ask("boards").json["views"] == []
    assert ask(f"views/{saved['id']}", {"action": "undelete"}).json["title"] == "Graph"


def test_comments_are_answered_resolved_and_opened_again(ask, board):
    place = f"board:{board['id']}/block:{block_of(board, 'graph')['id']}"
    first = ask("comments", {"action": "add", "place": place, "text": "Why?", "author": "Ana"}).json
    answer = {"action": "add", "place": place, "text": "Because.", "author": "Ben", "parent": first["id"]}
    assert ask("comments", answer).json["parent"] == first["id"]
    assert ask("comments", {"action": "resolve", "id": first["id"]}).json["resolved"]
    assert not ask("comments", {"action": "reopen", "id": first["id"]}).json["resolved"]
    assert [c["block"] for c in ask(f"boards/{board['id']}").json["comments"]] == [first["block"]] * 2


@pytest.mark.parametrize(
    ("path", "body", "status"),
    [
        ("boards", {"template": "nonsense"}, 400),
        ("boards/nobody", None, 404),
        ("boards/nobody", {"action": "delete"}, 404),
        ("boards/{id}", {"action": "nonsense"}, 400),
        ("boards/{id}", {"action": "add", "block": {"kind": "<b>"}}, 400),
        ("boards/{id}", {"action": "add", "block": []}, 400),
        ("boards/{id}", {"action": "move", "places": {"x": [1]}}, 400),
        ("boards/{id}", {"action": "change", "block": {"id": "x", "kind": "text"}, "version": "1"}, 400),
        ("boards/{id}/blocks/nobody", None, 404),
        ("views", {"address": "https://elsewhere.example", "title": "x"}, 400),
        ("views", {"address": "/motifs", "title": "x", "picture": "data:text/html,x"}, 400),
        ("comments", {"action": "add", "place": "nowhere", "text": "x"}, 400),
        ("comments", {"action": "edit", "id": "nobody", "text": "x", "version": 1}, 404),
    ],
)
def test_wrong_requests_are_refused_in_words(ask, board, path, body, status):
    answer = ask(path.format(id=board["id"]), body)
    assert answer.status_code == status and len(answer.json["error"]) > 10


def test_other_sites_cannot_change_a_board(workspace, board):
    client = create_app(workspace.path).server.test_client()
    answer = client.post(f"/api/boards/{board['id']}", json={"action": "delete"}, headers={"Host": "localhost"})
    assert answer.status_code == 403 and workspace.boards.get(board["id"])


def test_a_viewer_sees_a_board_and_may_not_change_it(workspace, board):
    viewer = Person("Vera", "viewer")
    with acting_as(viewer):
        from webapp.features.boards.documents import board_data

        seen = board_data(workspace, board["id"])
        assert not seen["may_edit"] and "edit" not in seen["links"] and seen["me"] == "Vera"
    with acting_as(replace(viewer, role="editor")):
        assert board_data(workspace, board["id"])["may_edit"]


def test_motifs_and_moments_are_discussed_where_they_are_shown(ask):
    nothing = ask("comments?dataset=walks").json
    assert nothing == {}
    clip = ask("comments?dataset=walks&clip=a").json
    assert clip["moments"] and clip["comments"] == []
    ask("comments", {"action": "add", "place": f"{clip['place']}/30", "text": "look @Ben", "author": "Ana"})
    said = ask("comments?dataset=walks&clip=a").json["comments"]
    assert [comment["frame"] for comment in said] == [30] and said[0]["seconds"] > 0
    assert ask("comments?dataset=walks&motif=999").json == {}
    assert ask("comments?dataset=nothing&motif=1").status_code == 400
