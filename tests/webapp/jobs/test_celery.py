"""Jobs on Celery's workers: a real redis-server, two workers as processes of their own, and kills of each of them."""

from __future__ import annotations

import shutil
import socket
import sqlite3
import subprocess
import sys
import time
from contextlib import closing

import pytest

from core import analyses
from core.workspace import Workspace
from tests import toy_method
from tests.core.workspace.test_jobs import wait_for
from tests.toy_method import REPOSITORY, make_dataset
from webapp import jobs
from webapp.jobs import launching

pytest.importorskip("celery", reason="Celery is not installed: pip install 'motionscape[celery]'")
if not shutil.which("redis-server"):
    pytest.skip("there is no redis-server (Debian: apt-get install redis-server)", allow_module_level=True)
QUIET = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}


class Engine:
    """A Redis at a port, and workers, by name."""

    def __init__(self, folder):
        with closing(socket.socket()) as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.folder, self.processes = folder, {}
        self.environment = toy_method.environment() | {launching.REDIS: f"redis://127.0.0.1:{self.port}/0"}

    def start_redis(self):
        options = ["--port", str(self.port), "--bind", "127.0.0.1", "--save", "", "--dir", str(self.folder)]
        self.processes["redis"] = subprocess.Popen(["redis-server", *options], **QUIET)
        wait_for(self._answers)

    def start_worker(self, name):
        command = [sys.executable, "-m", "celery", "--app", "webapp.jobs.celery_workers", "worker"]
        command += ["--hostname", f"{name}@test", "--without-gossip", "--without-mingle"]
        self.processes[name] = subprocess.Popen(command, env=self.environment, cwd=REPOSITORY, **QUIET)

    def kill(self, name):
        process = self.processes.pop(name)
        process.kill()
        process.wait()

    def name_of(self, pid):
        return next(name for name, process in self.processes.items() if process.pid == pid)

    def _answers(self):
        with closing(socket.socket()) as probe:
            return probe.connect_ex(("127.0.0.1", self.port)) == 0


@pytest.fixture(scope="module")
def engine(tmp_path_factory):
    engine = Engine(tmp_path_factory.mktemp("redis"))
    try:
        engine.start_redis()
        engine.start_worker("first")
        engine.start_worker("second")
        yield engine
    finally:
        for name in list(engine.processes):
            engine.kill(name)


@pytest.fixture
def workspace(engine, tmp_path, monkeypatch):
    for name, value in engine.environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr(launching, "launch", lambda path: pytest.fail("a worker of this machine was started"))
    workspace = Workspace(tmp_path / "space")
    jobs.get_ready(workspace)
    workspace.add_dataset("toy", make_dataset())
    yield workspace
    for job in workspace.jobs.list():
        workspace.jobs.cancel(job.id)
    wait_for(lambda: workspace.jobs.running() == 0)


def looking(workspace, condition):
    """Waits for ``condition`` while the server looks after the jobs, as it does for every open page."""

    def look():
        jobs.resume(workspace)
        jobs.ensure_worker(workspace)
        return condition()

    return wait_for(look, 40)


def state_of(workspace, job):
    return workspace.jobs.get(job.id).state


def counting(workspace, job):
    return looking(workspace, lambda: (now := workspace.jobs.get(job.id)).stage == "counting" and now)


def test_two_workers_compute_at_once_and_the_result_is_kept(workspace, engine, tmp_path):
    gate = str(tmp_path / "gate")
    requests = [toy_method.request(gate=gate, seconds=seconds) for seconds in (0.1, 0.2)]
    both = [counting(workspace, jobs.start(workspace, request)) for request in requests]  # neither ends before the gate
    assert {engine.name_of(job.pid) for job in both} == {"first", "second"}
    third = jobs.start(workspace, toy_method.request(seconds=0.3))
    assert state_of(workspace, third) == "queued"  # as many run as there are workers
    (tmp_path / "gate").touch()
    for job in (*both, third):
        looking(workspace, lambda job=job: state_of(workspace, job) == "done")
    assert analyses.stored(workspace, requests[0])["frames"] == 81


def test_a_job_is_cancelled_where_it_is_computed(workspace):
    for mode in ("count", "deaf"):
        job = jobs.start(workspace, toy_method.request(seconds=300, mode=mode))
        looking(workspace, lambda job=job: state_of(workspace, job) == "running")
        workspace.jobs.cancel(job.id)
        wait_for(lambda job=job: state_of(workspace, job) == "cancelled")


def test_a_job_that_ends_its_process_is_told_and_the_worker_goes_on(workspace):
    job = jobs.start(workspace, toy_method.request(mode="die"))
    failed = looking(workspace, lambda: (now := workspace.jobs.get(job.id)).state == "failed" and now)
    assert "run it again" in failed.error


def test_a_killed_worker_is_noticed_and_another_takes_the_job_once(workspace, engine, tmp_path):
    job = counting(workspace, jobs.start(workspace, toy_method.request(gate=str(tmp_path / "gate"))))
    name = engine.name_of(job.pid)
    engine.kill(name)
    again = looking(workspace, lambda: (now := workspace.jobs.list()[0]).id != job.id and now)
    assert state_of(workspace, job) == "failed" and workspace.jobs.get(job.id).died
    (tmp_path / "gate").touch()
    looking(workspace, lambda: state_of(workspace, again) == "done")
    engine.start_worker(name)


def test_redis_killed_in_the_middle_loses_no_job(workspace, engine, tmp_path):
    gate = str(tmp_path / "gate")
    running = counting(workspace, jobs.start(workspace, toy_method.request(gate=gate)))
    engine.kill("redis")
    waiting = jobs.start(workspace, toy_method.request(seconds=0.1))  # nobody can be called, and nothing breaks
    assert not jobs.ensure_worker(workspace) and state_of(workspace, waiting) == "queued"
    (tmp_path / "gate").touch()
    wait_for(lambda: state_of(workspace, running) == "done")  # its worker does not need Redis
    looking(workspace, lambda: state_of(workspace, waiting) == "done")  # the same worker took it, being awake
    time.sleep(2.0)  # until that worker has seen that nothing is left
    last = jobs.start(workspace, toy_method.request(seconds=0.2))  # now all of them sleep
    assert state_of(workspace, last) == "queued"
    engine.start_redis()  # with nothing in it
    looking(workspace, lambda: state_of(workspace, last) == "done")


def test_the_job_table_can_be_used_by_several_machines(workspace):
    with closing(sqlite3.connect(workspace.path / "workspace.sqlite")) as table:
        assert table.execute("PRAGMA journal_mode").fetchone()[0] == "delete"
    with closing(Workspace(workspace.path)) as again:  # and stays so, whoever opens it
        assert again.jobs.list() is not None
    assert not list(workspace.path.glob("*.sqlite-wal"))
