"""What is got ready in the background after the first page."""

import logging
import threading

import pytest
from flask import Flask

from core.demo import make_demo
from core.workspace import Workspace
from webapp import serving
from webapp.app import create_app
from webapp.shell import warming


@pytest.fixture
def server(monkeypatch):
    monkeypatch.setattr(warming, "DELAY", 0)
    server = Flask("toy")
    server.add_url_rule("/page", view_func=lambda: "<p>page</p>", endpoint="page")
    server.add_url_rule("/data", view_func=lambda: {"a": 1}, endpoint="data")
    return server


def test_the_steps_are_taken_once_and_after_the_first_page(server, caplog):
    caplog.set_level(logging.INFO)
    done, taken = threading.Event(), []

    def fail():
        raise ValueError("the file is damaged")

    warming.after_first_page(server, lambda: {"one": lambda: taken.append(1), "two": fail, "three": done.set})
    client = server.test_client()
    client.get("/data")
    client.get("/nowhere")
    assert not taken
    client.get("/page")
    assert done.wait(10)
    client.get("/page")
    assert taken == [1]
    assert "got ready: one, in" in caplog.text
    assert "not got ready: two" in caplog.text and "the file is damaged" in caplog.text


def test_first_visits_of_all_pages_can_be_got_ready(tmp_path, caplog):
    caplog.set_level(logging.INFO)
    workspace = Workspace(tmp_path / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.3))
    app = create_app(workspace.path)
    steps = serving._first_visits(app, workspace)
    assert {"page library", "page clip", "form of map"} <= set(steps)
    warming.take(app.server, steps)
    assert all(f"got ready: {name}, in" in caplog.text for name in steps)
    assert "not got ready" not in caplog.text
