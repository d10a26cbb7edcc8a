"""Accounts: signing in and out, sessions that expire, tries that are limited, proxies, links of boards, other sites."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from core.workspace import Block, Workspace
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.shell import sessions
from webapp.shell.rights import callback_name

PASSWORD = "correct horse"


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("walkers", walkers(("a", "b"), seconds=2.0))
    workspace.add_dataset("secret", walkers(("c",), seconds=2.0))
    workspace.users.add("ann", PASSWORD, "owner")
    workspace.users.add("vic", PASSWORD, "viewer")
    return workspace


@pytest.fixture
def server(workspace):
    return create_app(workspace.path).server


@pytest.fixture
def client(server):
    return server.test_client()


def sign_in(client, name="ann", password=PASSWORD, **more):
    return client.post("/sign-in", data={"name": name, "password": password, **more})


def test_who_is_not_signed_in_is_sent_to_the_form_and_back(client):
    away = client.get("/motifs?dataset=walkers&motif=3")
    assert away.status_code == 302
    assert away.location == "/sign-in?next=/motifs%3Fdataset%3Dwalkers%26motif%3D3"
    form = client.get(away.location)
    assert form.status_code == 200 and b'value="/motifs?dataset=walkers&amp;motif=3"' in form.data
    assert "script-src 'self'" in form.headers["Content-Security-Policy"] and b"http" not in form.data
    back = sign_in(client, next="/motifs?dataset=walkers&motif=3")
    assert back.status_code == 303 and back.location == "/motifs?dataset=walkers&motif=3"
    assert client.get(back.location).status_code == 200
    assert client.get("/api/me").json == {"name": "ann", "role": "owner", "roles": {}, "guest": False}


def test_the_session_cookie_is_out_of_reach_for_scripts_and_other_sites(client):
    cookie = sign_in(client).headers["Set-Cookie"]
    assert "HttpOnly" in cookie and "SameSite=Lax" in cookie and "Secure" not in cookie
    assert PASSWORD not in cookie
    encrypted = client.post("/sign-in", data={"name": "ann", "password": PASSWORD}, base_url="https://localhost")
    assert "Secure" in encrypted.headers["Set-Cookie"]


@pytest.mark.parametrize(
    "next", ["https://evil.example", "//evil.example", "/\\evil.example", "javascript:alert(1)", ""]
)
def test_signing_in_leads_to_no_other_site(client, next):
    assert sign_in(client, next=next).location == "/"


def test_a_form_that_is_filled_in_wrongly_says_so_and_no_more(client):
    for name, password in (("ann", "wrong horse"), ("nobody", PASSWORD), ('"><b>', PASSWORD)):
        answer = sign_in(client, name, password)
        assert answer.status_code == 401 and b"do not fit" in answer.data and b"<b>" not in answer.data
    assert client.get("/api/me").status_code == 401


def test_tries_are_limited_for_an_account_and_an_address(server, workspace, monkeypatch):
    client, clock = server.test_client(), [1000.0]
    monkeypatch.setattr(sessions.time, "monotonic", lambda: clock[0])
    monkeypatch.setattr(type(workspace.users), "sign_in", lambda _self, name, password: None)
    assert [sign_in(client).status_code for _ in range(6)] == [401] * 5 + [429]
    assert int(sign_in(client).headers["Retry-After"]) > 200
    assert sign_in(client, "vic").status_code == 401, "another account is not locked"
    elsewhere = {"REMOTE_ADDR": "10.0.0.9"}
    assert client.post("/sign-in", data={"name": "ann"}, environ_base=elsewhere).status_code == 401
    statuses = [sign_in(client, f"user{number}").status_code for number in range(40)]
    assert statuses[-1] == 429 and statuses[0] == 401, "one address may not try all names"
    clock[0] += sessions.WINDOW + 1
    assert sign_in(client).status_code == 401


def test_the_right_password_is_not_counted_as_a_try(client):
    assert {sign_in(client).status_code for _ in range(7)} == {303}


def test_signing_out_ends_the_session(client):
    sign_in(client)
    assert client.post("/sign-out").location == "/sign-in"
    assert client.get("/api/me").status_code == 401


def test_a_session_ends_when_nobody_does_anything_and_after_a_week(client, monkeypatch):
    now = [time.time()]
    monkeypatch.setattr(sessions.time, "time", lambda: now[0])
    sign_in(client)
    now[0] += 11 * 3600
    assert client.get("/library").status_code == 200
    now[0] += 11 * 3600
    assert client.get("/api/me").status_code == 200, "the visit of the page counted"
    now[0] += 2 * 3600
    assert client.get("/api/me").status_code == 401, "asking for news did not"
    sign_in(client)
    for _ in range(16):
        now[0] += 10 * 3600
        assert client.get("/library").status_code == 200
    now[0] += 10 * 3600
    assert client.get("/library").status_code == 302, "a week has passed"


def test_how_long_a_session_lasts_can_be_set(client, monkeypatch):
    now = [time.time()]
    monkeypatch.setattr(sessions.time, "time", lambda: now[0])
    monkeypatch.setenv("MOTIONSCAPE_SESSION_IDLE_HOURS", "0.5")
    sign_in(client)
    now[0] += 1700
    assert client.get("/api/me").status_code == 200
    now[0] += 200
    assert client.get("/api/me").status_code == 401


def test_a_session_survives_a_restart_and_ends_with_the_account_or_its_password(server, workspace):
    client = server.test_client()
    cookie = sign_in(client).headers["Set-Cookie"].partition(";")[0].partition("=")[2]
    again = create_app(workspace.path).server.test_client()
    again.set_cookie(sessions.COOKIE, cookie)
    assert again.get("/api/me").json["name"] == "ann"
    workspace.users.set_role("ann", "viewer")
    assert again.get("/api/me").json["role"] == "viewer"
    workspace.users.set_password("ann", "battery staple")
    assert again.get("/api/me").status_code == 401
    again.set_cookie(sessions.COOKIE, cookie[:-3] + "abc")
    assert again.get("/api/me").status_code == 401


def test_a_viewer_reads_and_an_editor_of_one_dataset_changes_that_one(workspace, server):
    workspace.users.set_role("vic", "editor", "walkers")
    client = server.test_client()
    sign_in(client, "vic")
    assert client.get("/api/me").json["roles"] == {"walkers": "editor"}
    assert client.get("/api/motion/secret/c").status_code == 200
    undo = {"inputs": [{"id": "undo", "property": "data", "value": {"trash": "secret"}}]}
    app = create_app(workspace.path)
    app._setup_server()
    named = {callback_name(app.callback_map, output): output for output in app.callback_map}
    output = named["webapp.jobs.changes.undo"]
    body = {"output": output, "outputs": [], "changedPropIds": ["undo.data"], **undo}
    answer = client.post("/_dash-update-component", json=body)
    assert b"Only an editor may delete this dataset" in answer.data
    undo["inputs"][0]["value"] = {"trash": "walkers"}
    client.post("/_dash-update-component", json=body)
    assert [info.name for info in workspace.datasets()] == ["secret"]


@pytest.mark.parametrize(
    ("headers", "refused"),
    [
        ({"Sec-Fetch-Site": "cross-site"}, True),
        ({"Sec-Fetch-Site": "same-site"}, True),
        ({"Sec-Fetch-Site": "same-origin"}, False),
        ({"Sec-Fetch-Site": "same-origin", "Origin": "https://behind.a.proxy"}, False),
        ({"Sec-Fetch-Site": "none"}, False),
        ({"Origin": "https://evil.example"}, True),
        ({"Origin": "http://localhost:9999"}, True),
        ({"Origin": "null"}, True),
        ({"Origin": "http://localhost"}, False),
        ({}, False),
    ],
)
def test_a_page_of_another_site_can_change_nothing(client, headers, refused):
    sign_in(client)
    asked = [client.post("/api/uploads", headers={"X-Motionscape": "1", **headers})]
    asked += [client.post("/sign-in", data={"name": "ann", "password": PASSWORD}, headers=headers)]
    assert [answer.status_code == 403 for answer in asked] == [refused] * 2
    assert client.get("/api/me", headers=headers).status_code == 200, "reading is the browser's business"


def test_without_accounts_another_site_can_change_nothing_either(tmp_path):
    client = create_app(tmp_path / "space").server.test_client()
    foreign = {"Origin": "https://evil.example", "X-Motionscape": "1"}
    assert client.post("/api/uploads", headers=foreign).status_code == 403
    assert client.post("/_dash-update-component", json={}, headers=foreign).status_code == 403
    assert client.post("/api/uploads", headers={"X-Motionscape": "1"}).status_code == 200


def test_a_trusted_proxy_says_who_it_is(server, monkeypatch):
    monkeypatch.setenv("MOTIONSCAPE_USER_HEADER", "X-Remote-User")
    monkeypatch.setenv("MOTIONSCAPE_TRUSTED_PROXIES", "10.1.0.0/16, nonsense")
    client = server.test_client()

    def me(name, address):
        return client.get("/api/me", headers={"X-Remote-User": name}, environ_base={"REMOTE_ADDR": address})

    assert me("vic", "10.1.2.3").json["name"] == "vic"
    assert me("ann", "10.2.2.3").status_code == 401, "anyone can send a header"
    unknown = me("mallory", "10.1.2.3")
    assert unknown.status_code == 403 and "no account" in unknown.json["error"]
    assert me("vic,ann", "10.1.2.3").status_code == 403
    assert me("", "10.1.2.3").status_code == 401


def test_behind_a_proxy_tries_are_counted_for_the_browser_and_cookies_are_for_encrypted_connections(
    server, monkeypatch
):
    monkeypatch.setenv("MOTIONSCAPE_TRUSTED_PROXIES", "10.1.2.3")
    client = server.test_client()

    def post(name, forwarded, proxy="10.1.2.3"):
        headers = {"X-Forwarded-For": forwarded, "X-Forwarded-Proto": "https"}
        form = {"name": name, "password": PASSWORD if name == "ann" else "wrong"}
        return client.post("/sign-in", data=form, headers=headers, environ_base={"REMOTE_ADDR": proxy})

    statuses = [post("vic", "made-up, 7.7.7.7").status_code for _ in range(6)]
    assert statuses == [401] * 5 + [429] and post("vic", "8.8.8.8").status_code == 401
    assert "Secure" in post("ann", "7.7.7.7").headers["Set-Cookie"]
    assert "Secure" not in post("ann", "7.7.7.7", proxy="10.9.9.9").headers["Set-Cookie"]


def test_a_proxy_that_signs_in_opens_nothing_by_itself(tmp_path, monkeypatch):
    monkeypatch.setenv("MOTIONSCAPE_USER_HEADER", "X-Remote-User")
    client = create_app(tmp_path / "space").server.test_client()
    assert client.get("/api/me", headers={"X-Remote-User": "ann"}).status_code == 401
    assert client.get("/library").status_code == 302


def test_the_token_opens_the_app_beside_accounts(workspace):
    client = create_app(workspace.path, token="s3cret").server.test_client()
    assert client.get("/library").status_code == 302
    client.get("/library?token=s3cret")
    assert client.get("/api/me").json["role"] == "owner"


def test_when_the_last_account_goes_a_server_with_a_token_still_asks_for_it(workspace):
    client = create_app(workspace.path, token="s3cret").server.test_client()
    for name in ("ann", "vic"):
        workspace.users.remove(name)
    assert client.get("/library").status_code == 401


@pytest.fixture
def board(workspace):
    return workspace.boards.create("first", [Block("text", "text", settings={"dataset": "walkers"})])


def test_a_read_link_opens_one_board_and_its_data_and_is_taken_out_of_the_address(client, workspace, board):
    other = workspace.boards.create("other")
    opened = client.get(f"/library?dataset=walkers&key={board.read_key}")
    assert opened.location == "/library?dataset=walkers" and "HttpOnly" in opened.headers["Set-Cookie"]
    assert client.get(opened.location).status_code == 200
    assert client.get("/api/me").json == {"name": "guest", "role": "viewer", "roles": {}, "guest": True}
    assert client.get("/api/motion/walkers/a").status_code == 200
    assert client.get("/api/motion/secret/c").status_code == 404
    page = client.get("/library").data
    assert b"walkers" in page and b"secret" not in page
    assert client.post("/api/uploads", headers={"X-Motionscape": "1"}).status_code == 403
    client.get(f"/library?key={other.read_key}")
    assert client.get("/api/me").json["guest"], "a second link is kept beside the first"


def test_a_link_that_opens_nothing_lets_nobody_in(client, workspace, board):
    workspace.boards.renew_keys(board.id)
    for key in (board.read_key, board.edit_key, "x", board.id, ""):
        answer = client.get(f"/library?key={key}")
        assert answer.status_code == 403 and b"opens no board" in answer.data
        assert client.get("/api/me").status_code == 401
    client.get(f"/library?key={workspace.boards.get(board.id).read_key}")
    assert client.get("/api/me").status_code == 200
    workspace.boards.delete(board.id)
    assert client.get("/api/me").status_code == 401


def test_a_link_of_a_board_opens_it_where_others_need_the_token(tmp_path):
    workspace = Workspace(tmp_path / "without accounts")
    board = workspace.boards.create("first")
    client = create_app(workspace.path, token="s3cret").server.test_client()
    assert client.get("/library").status_code == 401
    client.get(f"/library?key={board.edit_key}")
    assert client.get("/library").status_code == 200 and client.get("/api/me").json["guest"]
    client.get("/library?token=s3cret")
    assert client.get("/api/me").json == {"name": "", "role": "owner", "roles": {}, "guest": False}


def test_after_a_request_the_next_one_starts_as_nobody(server, workspace):
    from core.workspace import acting

    client = server.test_client()
    sign_in(client, "vic")
    client.get("/api/me")
    assert acting().name == ""
    assert server.test_client().get("/api/me").status_code == 401


def test_signing_in_is_on_record_and_no_password_is(client, workspace):
    sign_in(client, "ann", "wrong horse")
    sign_in(client)
    entries = workspace.audit.entries()[-2:]
    assert [(entry.what, entry.subject) for entry in entries] == [("sign-in refused", "ann"), ("signed in", "ann")]
    assert "horse" not in repr(workspace.audit.entries())


@pytest.mark.parametrize(("name", "role"), [("ann", "owner"), ("vic", "viewer")])
def test_the_page_says_who_one_is_and_by_which_role_it_hides(client, name, role):
    sign_in(client, name)
    page = client.get("/library").get_data(as_text=True)
    assert f'"data-role": "{role}"' in page and f'"{name}, {role}"' in page and "Sign out" in page


def test_an_editor_of_one_dataset_finds_the_controls(client, workspace):
    workspace.users.set_role("vic", "editor", "walkers")
    sign_in(client, "vic")
    assert '"data-role": "editor"' in client.get("/library").get_data(as_text=True)


def test_a_guest_is_offered_to_sign_in(client, board):
    client.get(f"/library?key={board.read_key}")
    page = client.get("/library").get_data(as_text=True)
    assert '"data-role": "viewer"' in page and '"href": "/sign-in"' in page and "Sign out" not in page
