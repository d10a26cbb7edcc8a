"""Workers that stay for the next job: called by one, ready to run, gone when nobody needs them."""

import os
import signal
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

import psutil
import pytest

from core.analyses import Request
from core.workspace import Workspace
from tests import toy_method
from tests.core.workspace.test_jobs import wait_for
from tests.toy_method import make_dataset
from tests.webapp.jobs.test_jobs import counting, ended
from webapp import jobs
from webapp.jobs import idle, launching, worker

posix = pytest.mark.skipif(not idle.POSSIBLE, reason="workers stay where there are local sockets")


@pytest.fixture
def home(monkeypatch):
    """A place for sockets that no other test uses."""
    with tempfile.TemporaryDirectory(prefix="ms") as folder:  # short, as the path of a socket must be
        monkeypatch.setenv("TMPDIR", folder)
        monkeypatch.setattr(tempfile, "tempdir", None)
        yield folder
    monkeypatch.setattr(tempfile, "tempdir", None)


@pytest.fixture
def workspace(tmp_path, monkeypatch, home):
    for name, value in toy_method.environment().items():
        monkeypatch.setenv(name, value)
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset())
    yield workspace
    for process in map(psutil.Process, waiting()):
        process.kill()


def waiting():
    return [int(place.stem) for place in idle._folder().glob("*.idle")]


def done(workspace, **parameters):
    job = ended(workspace, jobs.start(workspace, toy_method.request(**parameters)))
    assert job.state == "done"
    return job


@posix
def test_the_next_job_finds_the_worker_and_a_fresh_child(workspace, tmp_path):
    log = tmp_path / "log"
    first = done(workspace, log=str(log))
    wait_for(waiting)
    other = Workspace(tmp_path / "other")  # a worker goes where it is called
    other.add_dataset("toy", make_dataset())
    second = done(other, log=str(log), seconds=0.01)
    assert first.pid == second.pid
    children = log.read_text().split()
    assert len(set(children)) == 2 and str(first.pid) not in children  # memory of a job is free when it ends
    wait_for(waiting)
    assert psutil.Process(first.pid).num_threads() == 1 and not psutil.Process(first.pid).children()


@posix
def test_an_idle_worker_that_was_killed_is_replaced(workspace):
    pid = done(workspace).pid
    wait_for(waiting)
    os.kill(pid, signal.SIGKILL)
    job = jobs.start(workspace, toy_method.request(seconds=0.01))
    assert jobs.wait_for(str(workspace.path), job.id) == "done"  # also where it dies after it was called
    assert workspace.jobs.get(job.id).pid != pid
    assert pid not in waiting()


@posix
def test_a_worker_that_fails_itself_leaves_its_job_to_others(workspace):
    job = jobs.start(workspace, toy_method.request(seconds=300))
    worker = psutil.Process(counting(workspace, job).pid)
    (child,) = worker.children()
    worker.send_signal(signal.SIGINT)  # as any fault in the worker
    assert ended(workspace, job).died
    wait_for(lambda: not child.is_running() and not worker.is_running())


@posix
def test_a_called_worker_hears_one_caller(home):
    heard = []
    thread = threading.Thread(target=lambda: heard.append(idle.wait(os.getpid(), stay=60)))
    thread.start()
    wait_for(waiting)
    assert sorted(idle.call(f"/space/{k}") for k in range(3)) == [False, False, True]
    thread.join()
    assert heard == [("/space/0", os.getpid())]
    assert not waiting()


@posix
def test_a_worker_leaves_when_nobody_calls_or_the_caller_is_gone(home, monkeypatch):
    assert idle.wait(os.getpid(), stay=0.05) is None
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    monkeypatch.setattr(idle, "_CALL", 0.02)
    monkeypatch.setattr(idle, "ALONE", 0.05)
    assert idle.wait(gone.pid, stay=3600) is None
    assert not list(Path(home).iterdir())


@posix
def test_no_more_than_a_few_wait(home, monkeypatch):
    monkeypatch.setattr(idle, "MOST", 0)
    assert idle.wait(os.getpid(), stay=3600) is None


@posix
def test_only_workers_of_the_same_surroundings_are_called(home, monkeypatch):
    here = idle._folder()
    monkeypatch.setenv("MOTIONSCAPE_MEMORY_GB", "3")
    assert idle._folder() != here
    monkeypatch.delenv("MOTIONSCAPE_MEMORY_GB")
    assert idle._folder() == here
    here.chmod(0o755)
    with pytest.raises(OSError, match="not ours alone"):
        idle._folder()
    assert not idle.call("/space")  # so one is started


def test_a_worker_can_do_without_forks(workspace, monkeypatch):
    """As on Windows: the child imports everything anew."""
    monkeypatch.setattr(worker, "FORKS", False)
    monkeypatch.setattr(launching, "launch", lambda path: None)
    job = jobs.start(workspace, Request("toy", "features"))
    assert worker.serve_queue(workspace) == 1
    assert workspace.jobs.get(job.id).state == "done"
