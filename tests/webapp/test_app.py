"""The app as a whole, without a browser: access, headers, errors, jobs in words, downloads."""

from __future__ import annotations

from pathlib import Path

import pytest

from core.workspace import Workspace
from tests.webapp.generated import walkers
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.jobs import job_bar, names
from webapp.shell import messages
from webapp.shell.state import choose_dataset


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    workspace = Workspace(tmp_path / "workspace")
    workspace.add_dataset("walkers", walkers(("a", "b"), seconds=2.0))
    return workspace


@pytest.fixture
def client(workspace: Workspace):
    return create_app(workspace.path).server.test_client()


def test_pages_are_served_with_safety_headers_and_nothing_from_outside(client):
    answer = client.get("/motifs?dataset=walkers")
    assert answer.status_code == 200
    assert "default-src 'self'" in answer.headers["Content-Security-Policy"]
    assert answer.headers["X-Content-Type-Options"] == "nosniff"
    assert b"https://" not in answer.data and b"http://" not in answer.data


def test_a_token_is_asked_for_once(workspace):
    client = create_app(workspace.path, token="s3cret").server.test_client()
    refused = client.get("/library")
    assert refused.status_code == 401 and b"token" in refused.data and b"s3cret" not in refused.data
    assert client.get("/_dash-layout").status_code == 401
    assert client.get("/api/motion/walkers/a").status_code == 401
    assert client.get("/library?token=wrong").status_code == 401
    let_in = client.get("/library?token=s3cret&dataset=walkers")
    assert let_in.status_code == 302 and let_in.headers["Location"] == "/library?dataset=walkers"
    assert "HttpOnly" in let_in.headers["Set-Cookie"]
    assert client.get("/library?dataset=walkers").status_code == 200


@pytest.mark.parametrize("host", ["localhost", "LOCALHOST:8050", "127.0.0.1:1", "127.0.0.1", "[::1]:8050", "[::1]"])
def test_this_machine_is_known_under_its_own_names(client, host):
    assert client.get("/library", headers={"Host": host}).status_code == 200


@pytest.mark.parametrize(
    "host",
    [
        *("evil.example", "evil.example:8050", "localhost.evil.example", "127.0.0.1.evil.example", "192.168.0.7"),
        *("[::2]", "evil@localhost", "localhost@evil.example", "local host", "[::1", ""),
    ],
)
def test_a_foreign_name_that_leads_here_is_refused(client, host):
    for path in ("/library", "/_dash-layout", "/api/motion/walkers/a", "/api/uploads", "/assets/motionscape.css"):
        answer = client.get(path, headers={"Host": host})
        assert answer.status_code == 403
        assert b"not known here" in answer.data and b"walkers" not in answer.data
    assert client.post("/api/uploads", headers={"Host": host}).status_code == 403


def test_a_reverse_proxy_may_bring_its_own_name(workspace, monkeypatch):
    monkeypatch.setenv("MOTIONSCAPE_HOSTS", " Motion.Team.example , other.example:8443,")
    client = create_app(workspace.path).server.test_client()
    for host in ("motion.team.example", "motion.team.example:443", "OTHER.example", "localhost"):
        assert client.get("/library", headers={"Host": host}).status_code == 200
    assert client.get("/library", headers={"Host": "team.example"}).status_code == 403


def test_with_a_token_the_name_does_not_matter(workspace):
    client = create_app(workspace.path, token="s3cret").server.test_client()
    assert client.get("/library?token=s3cret", headers={"Host": "lab.example"}).status_code == 302


def test_errors_show_no_internals(client):
    answer = client.post("/_dash-update-component", data="{", content_type="application/json")
    assert answer.status_code >= 400
    assert b"Traceback" not in answer.data and b"site-packages" not in answer.data


def test_downloads_say_what_is_missing(client):
    assert client.get("/api/motifs.json?dataset=nothing").status_code == 404
    assert "not been computed" in client.get("/api/motifs.json?dataset=walkers").json["error"]
    assert client.get("/api/motifs.svg?dataset=walkers&kappa=many").status_code == 400


def test_files_outside_the_workspace_are_out_of_reach(client):
    for path in ("/assets/../pyproject.toml", "/assets/%2e%2e/pyproject.toml", "/api/motion/..%2F..%2Fetc/passwd"):
        assert b"[project]" not in client.get(path).data and b"root:" not in client.get(path).data


def test_the_dataset_of_a_link_or_the_first():
    assert choose_dataset("b", ["a", "b"]) == ("b", ())
    assert choose_dataset(None, ["a", "b"]) == ("a", ())
    dataset, problems = choose_dataset("gone", ["a"])
    assert dataset == "a" and "gone" in problems[0]
    assert choose_dataset(None, []) == (None, ())


def test_the_bar_shows_what_runs_and_what_failed(workspace):
    job = workspace.jobs.submit("k1", {"method": "motifs"}, "Motif graph: walkers")
    pulse = job_bar.read_pulse(workspace)
    assert pulse.busy and [j.id for j in pulse.jobs] == [job.id]
    waits = {"id": job.id, "title": job.title, "stage": "waiting for its turn", "percent": None, "stopping": False}
    waits |= {"held": False, "expected": ""}
    assert job_bar.rows(pulse.jobs) == [waits] and misfit([waits], names.JOBS_SHOWN) is None
    workspace.jobs.fail(job.id, "The disk is full.")
    failed = job_bar.read_pulse(workspace)
    assert not failed.busy and failed.finished != pulse.finished
    assert job_bar.rows(failed.jobs) == [{"id": job.id, "title": job.title, "error": "The disk is full."}]
    assert job_bar.read_pulse(workspace, dismissed=[job.id]).jobs == ()
    again = workspace.jobs.submit("k1", {"method": "motifs"}, "Motif graph: walkers")
    assert [j.id for j in job_bar.read_pulse(workspace).jobs] == [again.id]  # the failure is superseded
    workspace.jobs.cancel(again.id)
    assert job_bar.read_pulse(workspace).jobs == ()  # and does not come back when the second try is cancelled


def test_the_revision_changes_with_the_datasets(workspace):
    before = job_bar.read_pulse(workspace).revision
    assert job_bar.read_pulse(workspace).revision == before
    workspace.rename("walkers", "strollers")
    renamed = job_bar.read_pulse(workspace).revision
    assert renamed != before
    workspace.rename("strollers", "walkers")  # as it was: a page that has read the other name must hear of it
    assert job_bar.read_pulse(workspace).revision not in (before, renamed)


def test_words_of_the_error_page_are_escaped():
    page, status = messages.error_page(404, "<b>", "a & b")
    assert status == 404 and "&lt;b&gt;" in page and "a &amp; b" in page
