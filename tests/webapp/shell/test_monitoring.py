"""Health, readiness and metrics: what they say, and to whom."""

from __future__ import annotations

import re
import sqlite3
from collections import namedtuple

import pytest

from core.workspace import Workspace
from tests.toy_method import make_dataset
from webapp.app import create_app
from webapp.shell import monitoring

LINE = re.compile(r'(# TYPE \w+ (gauge|counter|histogram))|(\w+(\{\w+="[^"]+"\})? -?[0-9.e+]+)')


@pytest.fixture
def workspace(tmp_path):
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("secret name", make_dataset())
    return workspace


def values(text):
    return dict(line.rsplit(" ", 1) for line in text.splitlines() if not line.startswith("#"))


def test_metrics_are_in_prometheus_text_format_and_count(workspace):
    client = create_app(workspace.path).server.test_client()
    workspace.jobs.submit("a", {"dataset": "secret name", "method": "toy"}, "toy")
    assert [client.get("/health").status_code, client.post("/api/uploads").status_code] == [200, 403]
    client.get("/ready")
    answer = client.get("/metrics")
    text = answer.get_data(as_text=True)
    assert answer.content_type.startswith("text/plain; version=0.0.4")
    assert all(LINE.fullmatch(line) for line in text.splitlines()) and text.endswith("\n")
    found = values(text)
    assert found['motionscape_jobs{state="queued"}'] == "1" and found['motionscape_jobs{state="failed"}'] == "0"
    assert found["motionscape_datasets"] == "1" and found["motionscape_ready"] == "1"
    assert found["motionscape_answer_seconds_count"] == found['motionscape_answer_seconds_bucket{le="+Inf"}'] == "3"
    assert int(found['motionscape_answers_total{status="4xx"}']) >= 1
    assert "secret" not in text


def test_health_needs_no_account_and_metrics_do(workspace):
    client = create_app(workspace.path, token="mine").server.test_client()
    assert client.get("/health").json == {"status": "ok"}
    assert client.get("/ready").json == {"status": "ready"}
    assert client.get("/metrics").status_code == 401


def test_a_server_that_cannot_work_is_not_ready(workspace, monkeypatch):
    client = create_app(workspace.path).server.test_client()
    with monkeypatch.context() as patch:
        patch.setattr(monitoring.shutil, "disk_usage", lambda path: namedtuple("Usage", "free")(1000))
        assert client.get("/ready").status_code == 503 and client.get("/ready").json["reason"] == "the disk is full"
    assert client.get("/ready").status_code == 200

    def broken(*_):
        raise sqlite3.DatabaseError("file is not a database")

    monkeypatch.setattr(type(workspace._database), "_connection", broken)
    assert client.get("/ready").json["reason"] == "the job table cannot be read"
    assert client.get("/health").status_code == 200
