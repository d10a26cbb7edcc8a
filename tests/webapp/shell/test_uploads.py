"""The upload routes: what is accepted, what is refused and how it is said; nothing leaves the workspace."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from flask import Flask
from flask.testing import FlaskClient

from core.workspace import Workspace
from webapp.shell.uploads import HEADER, Limits, megabytes, upload_blueprint

OURS = {HEADER: "upload"}
LIMITS = Limits(file_bytes=1000, total_bytes=2500, files=3)


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    return Workspace(tmp_path / "workspace")


@pytest.fixture
def client(workspace: Workspace) -> FlaskClient:
    server = Flask(__name__)
    server.register_blueprint(upload_blueprint(workspace, LIMITS))
    return server.test_client()


@pytest.fixture
def token(client: FlaskClient) -> str:
    return client.post("/api/uploads", headers=OURS).json["token"]


def put(client: FlaskClient, token: str, name: str, body: bytes = b"HIERARCHY"):
    return client.put(f"/api/uploads/{token}/{name}", data=body, headers=OURS)


def test_files_arrive_with_their_folders(client, token, workspace):
    assert put(client, token, "walks/a.bvh", b"one").status_code == 200
    assert put(client, token, "b.amc.gz", b"two").json == {"name": "b.amc.gz", "bytes": 3, "recording": True}
    assert put(client, token, "labels.csv", b"clip,action\n").json["recording"] is False
    folder = workspace.uploads.path(token)
    assert (folder / "walks" / "a.bvh").read_bytes() == b"one"


@pytest.mark.parametrize("name", ["a.exe", "a.bvh.exe", "a", "notes.md", "a.tar.gz"])
def test_other_kinds_of_files_are_refused(client, token, name):
    answer = put(client, token, name)
    assert answer.status_code == 415 and ".bvh" in answer.json["error"]


@pytest.mark.parametrize("name", ["..%2F..%2Fevil.bvh", "a/..%2F../evil.bvh", "%2Fetc/evil.bvh", "C:%5Cevil.bvh"])
def test_no_name_leaves_the_upload(client, token, workspace, name):
    answer = put(client, token, name)
    assert answer.status_code in (400, 404, 308)
    assert not list(workspace.path.parent.rglob("evil.bvh"))


def test_too_large_too_much_and_too_many_are_said(client, token, workspace):
    assert "1001" not in put(client, token, "a.bvh", b"x" * 1001).json["error"]
    assert put(client, token, "a.bvh", b"x" * 1001).status_code == 413
    for name in ("a.bvh", "b.bvh"):
        assert put(client, token, name, b"x" * 1000).status_code == 200
    assert "altogether" in put(client, token, "c.bvh", b"x" * 900).json["error"]
    assert put(client, token, "c.bvh", b"x" * 10).status_code == 200
    assert "at most 3 files" in put(client, token, "d.bvh", b"x").json["error"]
    assert sorted(path.name for path in workspace.uploads.path(token).iterdir()) == ["a.bvh", "b.bvh", "c.bvh"]


def test_a_body_that_ends_early_leaves_nothing(client, token, workspace):
    answer = client.put(
        f"/api/uploads/{token}/a.bvh",
        input_stream=io.BytesIO(b"half"),
        headers=OURS,
        environ_overrides={"CONTENT_LENGTH": "400"},
    )
    assert answer.status_code == 400
    assert not list(workspace.uploads.path(token).iterdir())


def test_only_our_own_page_may_ask(client, token):
    assert client.post("/api/uploads").status_code == 403
    assert client.put(f"/api/uploads/{token}/a.bvh", data=b"x").status_code == 403


def test_unknown_uploads_and_giving_one_up(client, token, workspace):
    assert put(client, "0" * 32, "a.bvh").status_code == 400
    assert put(client, "nonsense", "a.bvh").status_code == 400
    put(client, token, "a.bvh")
    assert client.delete(f"/api/uploads/{token}", headers=OURS).status_code == 200
    assert put(client, token, "a.bvh").status_code == 400


def test_limits_come_from_the_environment(monkeypatch):
    monkeypatch.setenv("MOTIONSCAPE_MAX_FILE_MB", "3")
    monkeypatch.setenv("MOTIONSCAPE_MAX_UPLOAD_MB", "2")
    monkeypatch.setenv("MOTIONSCAPE_MAX_FILES", "many")
    limits = Limits.from_environment()
    assert (limits.file_bytes, limits.total_bytes, limits.files) == (2 << 20, 2 << 20, 2000)
    assert "2 MB a file" in limits.sentence() and "2,000 files" in limits.sentence()
    assert megabytes(3 << 30) == "3 GB"
