"""The server is killed in the middle of a job and started again: an open page recovers by itself."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from pathlib import Path
from urllib.request import urlopen

import psutil
import pytest
from playwright.sync_api import expect

from core import analyses
from core.workspace import Workspace
from tests.browser.app import demo_workspace, workspace
from tests.core.workspace.test_jobs import wait_for
from webapp import jobs

__all__ = ["demo_workspace", "workspace"]
pytestmark = pytest.mark.slow


@contextmanager
def server(path: Path, port: int):
    """The real command in a process of its own, killed without a chance to tidy up."""
    command = [sys.executable, "-m", "webapp.cli", "serve", str(path), "--port", str(port), "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, cwd=Path(__file__).parents[3])
    try:
        deadline = time.monotonic() + 60
        while True:
            try:
                urlopen(f"http://127.0.0.1:{port}/assets/motionscape.css", timeout=20).close()
                break
            except OSError:
                assert process.poll() is None and time.monotonic() < deadline, "the server does not start"
                time.sleep(0.1)
        yield
    finally:
        os.kill(process.pid, signal.SIGKILL)
        process.wait()


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def test_an_open_page_recovers_when_the_server_is_killed_and_started_again(workspace: Workspace, open_page):
    port = free_port()
    try:
        with server(workspace.path, port):
            page = open_page(f"http://127.0.0.1:{port}/library")
            page.watch.expected += ["ERR_", "fetch", "did not respond"]
            job = jobs.start(workspace, analyses.Request("long", "demo", {"minutes": 30}))
            row = page.locator(".job", has_text="Demo: long")
            expect(row).to_be_visible()
            page.locator(".ag-row").first.wait_for()  # all of the page has arrived
            while workspace.jobs.get(job.id).pid is None:
                page.wait_for_timeout(100)
        psutil.Process(workspace.jobs.get(job.id).pid).kill()  # the machine went down with all that ran on it
        page.wait_for_timeout(1500)  # the page asks, and nobody answers
        with server(workspace.path, port):
            wait_for(lambda: workspace.jobs.list()[0].id != job.id)  # the server starts it again by itself
            expect(page.locator(".job:not(.job-failed)", has_text="Demo: long")).to_be_visible()
            expect(page.locator(".job-failed")).to_have_count(0)
            page.get_by_role("button", name="Cancel").click()
            expect(page.locator(".job")).to_have_count(0)
            expect(page.locator(".spinner")).to_have_count(0)
    finally:
        for one in workspace.jobs.list():
            workspace.jobs.cancel(one.id)
