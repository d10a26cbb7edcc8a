"""Every route and every callback says what it does to the workspace, and refuses those who may not do that."""

from __future__ import annotations

import re

import pytest
from dash.exceptions import PreventUpdate
from flask import Blueprint

from core.workspace import Block, Workspace
from webapp.app import create_app
from webapp.marks import CALLBACKS, DASH, all_marks
from webapp.shell.rights import ASKS, BOARDS, CHANGES, MANAGES, OPEN, READS, callback_name, name_of

PASSWORD = "correct horse"


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("space"))
    for role in ("viewer", "editor", "owner"):
        workspace.users.add(role, PASSWORD, role)
    yield workspace
    workspace.close()


@pytest.fixture(scope="module")
def app(workspace):
    app = create_app(workspace.path)
    app._setup_server()
    return app


def signed_in(app, name):
    client = app.server.test_client()
    assert client.post("/sign-in", data={"name": name, "password": PASSWORD}).status_code == 303
    return client


@pytest.fixture(scope="module")
def viewer(app):
    return signed_in(app, "viewer")


def outputs(app):
    """The outputs of all callbacks of the server, each with the name of its function."""
    served = [entry["output"] for entry in app._callback_list if not entry.get("clientside_function")]
    return {output: callback_name(app.callback_map, output) for output in served}


def requests_of_routes(app):
    """A request for every rule and method: (method, path, endpoint)."""
    for rule in app.server.url_map.iter_rules():
        path = re.sub(r"<[^>]+>", "x", rule.rule)
        for method in rule.methods - {"HEAD", "OPTIONS"}:
            yield method, path, rule.endpoint


def asked(client, output):
    body = {"output": output, "outputs": [], "inputs": [], "state": [], "changedPropIds": []}
    return client.post(CALLBACKS, json=body)


def test_every_route_and_callback_is_marked_and_every_mark_names_one(app):
    views = app.server.view_functions
    routes = {
        name_of(views[endpoint]) for _, _, endpoint in requests_of_routes(app) if endpoint not in {*DASH, CALLBACKS}
    }
    found, marks = routes | set(outputs(app).values()), all_marks()
    assert sorted(found - set(marks)) == [], "name these in the rights.py of their feature"
    assert sorted(set(marks) - found) == [], "these marks name nothing any more"
    assert set(marks.values()) <= {READS, ASKS, CHANGES, BOARDS, MANAGES, OPEN}
    assert set(DASH) <= set(views), "endpoints of Dash that are not there"


def test_all_that_is_not_a_get_is_marked_as_a_change_or_open(app):
    views, marks = app.server.view_functions, all_marks()
    kinds = {
        (method, path): DASH.get(endpoint) or marks.get(name_of(views[endpoint]))
        for method, path, endpoint in requests_of_routes(app)
        if method != "GET" and endpoint != CALLBACKS
    }
    assert kinds and {kind for kind in kinds.values()} <= {CHANGES, BOARDS, MANAGES, OPEN}


def test_nobody_gets_anything_without_an_account(app):
    client, marks = app.server.test_client(), all_marks()
    for method, path, endpoint in requests_of_routes(app):
        kind = DASH.get(endpoint) or marks.get(name_of(app.server.view_functions[endpoint]))
        answer = client.open(path, method=method, headers={"X-Motionscape": "1"})
        if kind == OPEN:
            assert answer.status_code != 403, path
        else:
            assert answer.status_code == 401 or answer.location.startswith("/sign-in?next="), (method, path)
    for output in outputs(app):
        assert asked(client, output).status_code == 401, output


def test_a_viewer_is_refused_every_change_and_nothing_else(app, viewer):
    marks, refused = all_marks(), {CHANGES, BOARDS, MANAGES}
    for method, path, endpoint in requests_of_routes(app):
        kind = DASH.get(endpoint) or marks.get(name_of(app.server.view_functions[endpoint]))
        if endpoint != CALLBACKS and kind != OPEN:
            answer = viewer.open(path, method=method, headers={"X-Motionscape": "1"})
            assert (answer.status_code == 403) == (kind in refused), (method, path, answer.status_code)
    changing = {output: name for output, name in outputs(app).items() if marks[name] in refused}
    assert len(changing) > 8
    for output, name in changing.items():
        answer = asked(viewer, output)
        assert answer.status_code == 403 and "viewer may not" in answer.json["error"], name


def test_a_viewer_gets_past_the_door_of_every_reading_callback(app, viewer, monkeypatch):
    marks = all_marks()
    for output, name in outputs(app).items():
        if marks[name] in (READS, ASKS):
            monkeypatch.setitem(app.callback_map[output], "callback", _named_like(app.callback_map[output]["callback"]))
            assert asked(viewer, output).status_code == 204, name


def _named_like(function):
    """A function that answers nothing and is marked like another."""

    def stands_for(*_arguments, **_more):
        raise PreventUpdate

    stands_for.__wrapped__ = function
    return stands_for


def test_unknown_outputs_and_broken_requests_are_refused_to_viewers(app, viewer):
    for body in ({"output": "nothing.data"}, {"output": 3}, {}, [], "x", None):
        assert viewer.post(CALLBACKS, json=body).status_code == 403, body
    assert viewer.post(CALLBACKS, data="x").status_code == 403


def test_a_route_without_a_mark_is_refused_to_viewers_only(workspace):
    app = create_app(workspace.path)
    routes = Blueprint("forgotten", __name__)
    routes.get("/api/forgotten")(lambda: "secret")
    app.server.register_blueprint(routes)
    assert signed_in(app, "viewer").get("/api/forgotten").status_code == 403
    assert signed_in(app, "editor").get("/api/forgotten").data == b"secret"
    guest = app.server.test_client()
    board = workspace.boards.create("first", [Block("text", "text")])
    guest.get(f"/?key={board.edit_key}")
    assert guest.get("/api/forgotten").status_code == 403
