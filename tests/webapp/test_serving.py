"""The command serve: listens where it may, asks for a token where others can come in, brings the demo."""

import os
import re
import signal
import socket
import subprocess
import sys
import urllib.error
import urllib.request

import pytest

from core.analyses import DEMO, Request, stored
from core.workspace import Workspace, WorkspaceError
from tests.core.workspace.test_jobs import wait_for
from tests.toy_method import REPOSITORY
from webapp import serving


@pytest.fixture
def start(tmp_path):
    processes = []

    def start(*arguments, **environment):
        command = [sys.executable, "-m", "webapp.cli", "serve", str(tmp_path / "space"), "--no-browser", *arguments]
        process = subprocess.Popen(
            command,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            cwd=REPOSITORY,
            env=os.environ | environment,
        )
        processes.append(process)
        return process

    yield start
    for process in processes:
        process.kill()
        process.communicate()


def address(process):
    for line in process.stdout:
        if found := re.search(r"http://\S+", line):
            return found[0]
    raise AssertionError(process.stderr.read())


def get(url):
    with urllib.request.build_opener(urllib.request.HTTPCookieProcessor()).open(url, timeout=120) as answer:
        return answer.status, answer.read().decode()


def test_serve_shows_the_app_and_ends_cleanly(start):
    process = start("--port", "0")
    url = address(process)
    assert url.startswith("http://127.0.0.1:") and "token" not in url
    status, page = get(url)
    assert status == 200 and "Motionscape" in page
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 130 and "Traceback" not in said


def test_serve_says_when_the_port_is_in_use(start):
    with socket.create_server(("127.0.0.1", 0)) as holder:
        process = start("--port", str(holder.getsockname()[1]))
        _, said = process.communicate(timeout=120)
    assert process.returncode == 2 and "is in use" in said and said.count("\n") == 1


def test_others_need_the_token(start):
    process = start("--host", "0.0.0.0", "--port", "0", MOTIONSCAPE_TOKEN="open-sesame")
    url = re.sub(r"//[^:]+:", "//127.0.0.1:", address(process))
    assert url.endswith("?token=open-sesame")
    assert get(url)[0] == 200
    for wrong in (url.split("?")[0], url.replace("sesame", "barley")):
        with pytest.raises(urllib.error.HTTPError) as refusal:
            get(wrong)
        assert refusal.value.code in (401, 403)


def test_with_accounts_people_sign_in_and_no_token_is_printed(start, tmp_path):
    Workspace(tmp_path / "space").users.add("ann", "correct horse")
    process = start("--host", "0.0.0.0", "--port", "0")
    url = re.sub(r"//[^:]+:", "//127.0.0.1:", address(process))
    assert "token" not in url
    assert "Sign in to Motionscape" in get(url)[1]
    signed_in = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
    signed_in.open(f"{url}sign-in", data=b"name=ann&password=correct+horse", timeout=120).read()
    assert b'"name":"ann"' in signed_in.open(f"{url}api/me", timeout=120).read()


def test_a_token_is_made_up_for_other_hosts_only(monkeypatch):
    monkeypatch.delenv(serving.TOKEN, raising=False)
    assert serving.token_for("127.0.0.1") is serving.token_for("localhost") is serving.token_for("::1") is None
    tokens = {serving.token_for(host) for host in ("0.0.0.0", "192.168.1.5", "::", "example.org")}
    assert len(tokens) == 4 and all(len(token) >= 20 for token in tokens)
    monkeypatch.setenv(serving.TOKEN, "mine")
    assert serving.token_for("127.0.0.1") == serving.token_for("0.0.0.0") == "mine"


@pytest.mark.parametrize("host", ["192.0.2.1", "no such host", "x" * 300])
def test_a_host_that_is_not_ours_is_refused(host):
    with pytest.raises(WorkspaceError, match="no address of this machine"):
        serving.listen(host, 0)


def test_the_demo_and_its_graph_are_there_soon(start, tmp_path):
    process = start("--port", "0", "--demo")
    assert get(address(process))[0] == 200
    workspace = Workspace(tmp_path / "space")
    wait_for(lambda: any(info.name == DEMO for info in workspace.datasets()), 120)
    graph = wait_for(lambda: stored(workspace, Request(DEMO, "motifs")), 200)
    assert graph.motifs
    assert {job.state for job in workspace.jobs.list()} <= {"done", "running", "queued"}


def test_the_demo_is_not_made_twice(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr("webapp.jobs.start", lambda _, request: asked.append(request.method))
    workspace = Workspace(tmp_path / "space")
    serving.prepare_demo(workspace)
    from tests.toy_method import make_dataset

    workspace.add_dataset(DEMO, make_dataset())
    serving.prepare_demo(workspace)
    assert asked == ["demo", "motifs", "map", "search", "grammar"]
