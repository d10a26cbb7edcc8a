"""Every place that shows errors: one meant for people in its own words, any other as a bug with an id, logged."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from dash import Input, Output

from core import analyses
from core.errors import AnalysisError, FormatError, LoggedBug, MotionscapeError, ParameterError
from core.mocap.errors import RecordingError
from core.sequences.envelope import envelope
from core.synthesis import NoWay
from core.workspace import NameRefused, ResultDamaged, Workspace, WorkspaceError
from tests import toy_method
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.cli import main
from webapp.features.search.queries import read_query
from webapp.shell.errors import sentence

BUG_ID = re.compile(r"error ([0-9a-f]{6})\b")
WORDS = "These clips are too short."
KINDS = (AnalysisError, FormatError, ParameterError, WorkspaceError, NameRefused, ResultDamaged)
MEANT = [kind(WORDS) for kind in KINDS]


def stray_value_error(*_arguments, **_options):
    """What core raises where one of its own functions is used wrongly."""
    envelope(np.zeros(3), 1)


def raises(error: Exception):
    """A function that raises ``error`` whatever it is given."""

    def function(*_arguments, **_options):
        raise error

    return function


def bug_id(text: str) -> str:
    """The id that a person is shown; nothing of the error itself may stand beside it."""
    assert "curve" not in text and "Traceback" not in text
    return BUG_ID.search(text)[1]


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    workspace = Workspace(tmp_path / "workspace")
    workspace.add_dataset("walkers", walkers(("a", "b"), seconds=2.0))
    workspace.add_dataset("toy", toy_method.make_dataset())
    return workspace


@pytest.fixture
def app(workspace: Workspace):
    return create_app(workspace.path)


def test_all_errors_meant_for_people_are_of_one_tree_and_still_value_errors():
    for kind in (*KINDS, RecordingError, NoWay, LoggedBug):
        assert issubclass(kind, MotionscapeError) and issubclass(kind, ValueError)


def test_a_message_is_shown_as_a_sentence():
    with pytest.raises(ValueError) as refused:
        read_query("what?")
    assert sentence(refused.value).startswith("A piece of a query looks like")
    assert sentence(refused.value).endswith(".")
    assert sentence(WorkspaceError("Gone.")) == "Gone."


# jobs


def compute_with(monkeypatch, compute):
    monkeypatch.setitem(analyses.METHODS, "toy", replace(analyses.METHODS["toy"], compute=compute))


@pytest.mark.parametrize("error", MEANT, ids=lambda error: type(error).__name__)
def test_a_job_says_what_is_wrong(workspace, monkeypatch, error):
    compute_with(monkeypatch, raises(error))
    with pytest.raises(AnalysisError) as shown:
        analyses.run(workspace, toy_method.request())
    assert str(shown.value) == WORDS and not isinstance(shown.value, LoggedBug)
    (job,) = workspace.jobs.list()
    assert job.error == WORDS and not list(workspace.logs.glob("*"))


def test_a_job_logs_a_bug(workspace, monkeypatch):
    compute_with(monkeypatch, stray_value_error)
    with pytest.raises(LoggedBug) as shown:
        analyses.run(workspace, toy_method.request())
    (job,) = workspace.jobs.list()
    assert job.error == str(shown.value) and bug_id(job.error) == shown.value.bug_id
    log = (workspace.logs / f"job-{job.id}.log").read_text()
    assert shown.value.bug_id in log and "at least 4 points" in log


def test_who_waits_for_the_job_of_another_process_is_told_of_its_bug_too(workspace, monkeypatch):
    compute_with(monkeypatch, stray_value_error)
    with pytest.raises(LoggedBug) as first:
        analyses.run(workspace, toy_method.request())
    (job,) = workspace.jobs.list()
    waiting = type(workspace.jobs)
    monkeypatch.setattr(waiting, "claim", lambda *_: None)  # as where another process was quicker
    monkeypatch.setattr(waiting, "submit", lambda *_, **__: job)
    with pytest.raises(LoggedBug) as shown:
        analyses.run(workspace, toy_method.request())
    assert str(shown.value) == str(first.value) and shown.value.bug_id == first.value.bug_id


# callbacks


def answer_of_callback(app, function) -> str:
    """The notice that a callback's error brings to the page."""
    app.callback(Output("test-out", "data"), Input("test-in", "data"))(function)
    body = {
        "output": "test-out.data",
        "outputs": {"id": "test-out", "property": "data"},
        "inputs": [{"id": "test-in", "property": "data", "value": 1}],
        "changedPropIds": ["test-in.data"],
    }
    answer = app.server.test_client().post("/_dash-update-component", json=body)
    (notice,) = json.loads(answer.data)["sideUpdate"]["notices"]["sendNotifications"]
    return f"{notice['title']}: {notice['message']}"


@pytest.mark.parametrize("error", MEANT, ids=lambda error: type(error).__name__)
def test_a_callback_says_what_is_wrong(app, caplog, error):
    assert answer_of_callback(app, raises(error)) == f"That cannot be done: {WORDS}"
    assert not caplog.records


def test_a_callback_logs_a_bug(app, caplog):
    shown = answer_of_callback(app, stray_value_error)
    assert shown.startswith("Something went wrong: The view stays as it was.")
    assert bug_id(shown) in caplog.text and "at least 4 points" in caplog.text


# routes

JSON_ROUTES = ["/api/motion/walkers/a", "/api/bvh/walkers/a", "/api/clip-table/walkers/a", "/api/search/explain?"]
PAGE_ROUTES = ["/api/motifs.json?dataset=walkers", "/api/grammar.json?dataset=walkers"]


@pytest.mark.parametrize("path", JSON_ROUTES + PAGE_ROUTES)
def test_a_route_says_what_is_wrong(app, monkeypatch, caplog, path):
    monkeypatch.setattr(Workspace, "open", raises(WorkspaceError(WORDS)))
    answer = app.server.test_client().get(path)
    assert answer.status_code == 404 and answer.get_json() == {"error": WORDS}
    assert not caplog.records


@pytest.mark.parametrize("path", JSON_ROUTES)
def test_a_route_logs_a_bug(app, monkeypatch, caplog, path):
    monkeypatch.setattr(Workspace, "open", stray_value_error)
    answer = app.server.test_client().get(path)
    assert answer.status_code == 500
    assert bug_id(answer.get_json()["error"]) in caplog.text and "at least 4 points" in caplog.text


@pytest.mark.parametrize("path", PAGE_ROUTES)
def test_a_download_that_meets_a_bug_is_a_page_that_says_so(app, monkeypatch, caplog, path):
    monkeypatch.setattr(Workspace, "open", stray_value_error)
    answer = app.server.test_client().get(path)
    assert answer.status_code == 500 and "Something went wrong" in answer.text
    assert bug_id(answer.text) in caplog.text and "at least 4 points" in caplog.text


@pytest.mark.parametrize("error", MEANT, ids=lambda error: type(error).__name__)
def test_a_download_that_cannot_be_made_is_a_page_with_its_reason(app, error):
    app.server.add_url_rule("/api/test", view_func=raises(error), endpoint="test")
    answer = app.server.test_client().get("/api/test")
    assert answer.status_code == 400 and WORDS in answer.text


def test_one_part_of_many_says_its_own_error(app, monkeypatch, caplog):
    first = [WorkspaceError(WORDS), ValueError("secret")]
    monkeypatch.setattr(Workspace, "open", lambda *_: raises(first.pop(0))())
    answer = app.server.test_client().get("/api/motions?dataset=walkers&clip=a&clip=b")
    head = json.loads(answer.data[4 : 4 + int(np.frombuffer(answer.data, "<u4", 1)[0])])
    told, broken = (part["error"] for part in head["parts"])
    assert told == WORDS and "secret" not in broken and bug_id(broken) in caplog.text


# commands


def run_command(monkeypatch, capsys, tmp_path, run) -> tuple[int, str]:
    changed = {**main.commands(), "demo": replace(main.commands()["demo"], run=run)}
    monkeypatch.delenv(main.DEBUG, raising=False)
    monkeypatch.setattr(main, "commands", lambda: changed)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    code = main.main(["demo", str(tmp_path)])
    return code, capsys.readouterr().err


@pytest.mark.parametrize("error", MEANT, ids=lambda error: type(error).__name__)
def test_a_command_says_what_is_wrong(monkeypatch, capsys, tmp_path, error):
    assert run_command(monkeypatch, capsys, tmp_path, raises(error)) == (2, f"motionscape demo: {WORDS}\n")


def test_a_command_logs_a_bug(monkeypatch, capsys, tmp_path):
    code, shown = run_command(monkeypatch, capsys, tmp_path, stray_value_error)
    assert code == 1 and shown.count("\n") == 1
    (log,) = tmp_path.glob("motionscape-error-*.log")
    assert BUG_ID.search(shown)[1] in log.name and str(log) in shown
    assert "at least 4 points" in log.read_text() and "Traceback" in log.read_text()


def test_a_command_whose_job_met_a_bug_says_where_it_is_logged(workspace, monkeypatch, capsys, tmp_path):
    compute_with(monkeypatch, stray_value_error)
    run = lambda _asked: analyses.run(workspace, toy_method.request())  # noqa: E731
    code, shown = run_command(monkeypatch, capsys, tmp_path, run)
    (job,) = workspace.jobs.list()
    assert code == 1 and bug_id(shown) in (workspace.logs / f"job-{job.id}.log").read_text()
