"""Workers: processes of their own that take jobs from the table, outlive who started them, and can be ended."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections import namedtuple
from types import SimpleNamespace

import psutil
import pytest

import webapp.jobs
from core import analyses, estimates
from core.workspace import Workspace, WorkspaceError
from core.workspace.jobs import STOPPED
from core.workspace.people import Person, acting_as
from tests import toy_method
from tests.core.workspace.test_jobs import wait_for
from tests.toy_method import REPOSITORY, make_dataset
from webapp import jobs
from webapp.jobs import job_bar, launching, worker
from webapp.jobs.background import WaitingManager


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    for name, value in toy_method.environment().items():
        monkeypatch.setenv(name, value)
    workspace = Workspace(tmp_path / "space")
    workspace.add_dataset("toy", make_dataset())
    yield workspace
    for job in workspace.jobs.list():
        workspace.jobs.cancel(job.id)
    wait_for(lambda: workspace.jobs.running() == 0)


def ended(workspace, job):
    return wait_for(lambda: (now := workspace.jobs.get(job.id)) and not now.alive and now)


def counting(workspace, job):
    return wait_for(lambda: (now := workspace.jobs.get(job.id)).stage == "counting" and now)


def test_a_job_is_worked_on_in_another_process(workspace):
    job = jobs.start(workspace, toy_method.request(seconds=0.5))
    assert job.state == "queued"
    done = ended(workspace, job)
    assert done.state == "done" and done.pid != os.getpid()
    assert analyses.stored(workspace, toy_method.request(seconds=0.5))["frames"] == 81


def test_who_waits_gets_the_end(workspace):
    assert jobs.wait_for(str(workspace.path), jobs.start(workspace, toy_method.request()).id) == "done"
    assert jobs.wait_for(str(workspace.path), jobs.start(workspace, toy_method.request(mode="refuse")).id) == "failed"
    assert jobs.wait_for(str(workspace.path), 10_000) == "unknown"


def test_faults_are_told_in_plain_words(workspace):
    refused = ended(workspace, jobs.start(workspace, toy_method.request(mode="refuse")))
    assert (refused.state, refused.error) == ("failed", "These clips are too short.")
    broken = ended(workspace, jobs.start(workspace, toy_method.request(mode="break")))
    assert broken.state == "failed" and "secret" not in broken.error and "Traceback" not in broken.error
    assert "secret detail" in (workspace.logs / f"job-{broken.id}.log").read_text()
    died = ended(workspace, jobs.start(workspace, toy_method.request(mode="die")))
    assert died.died and "run it again" in died.error


def test_cancel_stops_work_that_listens_and_work_that_does_not(workspace):
    for mode in ("count", "deaf"):
        job = jobs.start(workspace, toy_method.request(seconds=300, mode=mode))
        running = wait_for(lambda job=job: (now := workspace.jobs.get(job.id)).state == "running" and now)
        if mode == "count":
            counting(workspace, job)
        worker = psutil.Process(running.pid)
        children = wait_for(worker.children)
        workspace.jobs.cancel(job.id)
        assert ended(workspace, job).state == "cancelled"
        wait_for(lambda children=children: not any(child.is_running() for child in children))


def test_a_killed_worker_is_noticed_its_child_leaves_and_the_job_can_be_restarted(workspace):
    job = jobs.start(workspace, toy_method.request(seconds=300))
    pid = counting(workspace, job).pid
    children = psutil.Process(pid).children()
    os.kill(pid, signal.SIGKILL)
    dead = ended(workspace, job)
    assert dead.state == "failed" and dead.died and "run it again" in dead.error
    again = jobs.restart(workspace, job.id)
    assert again.id != job.id and again.request == job.request
    assert counting(workspace, again).pid != pid
    wait_for(lambda: not any(child.is_running() for child in children))
    with pytest.raises(WorkspaceError):
        jobs.restart(workspace, 10_000)


def test_a_child_that_the_system_ends_is_put_down_to_memory(workspace):
    job = jobs.start(workspace, toy_method.request(seconds=300))
    (child,) = psutil.Process(counting(workspace, job).pid).children()
    child.kill()
    assert "memory" in ended(workspace, job).error


def test_more_jobs_than_cores_wait_their_turn_in_order(workspace, monkeypatch):
    job_ids = [jobs.start(workspace, toy_method.request(seconds=0.2 + k / 1000)).id for k in range(5)]
    most = 0
    while any(workspace.jobs.get(job_id).alive for job_id in job_ids):
        most = max(most, workspace.jobs.running())
        time.sleep(0.02)
    done = [workspace.jobs.get(job_id) for job_id in job_ids]
    assert {job.state for job in done} == {"done"}
    assert 1 <= most <= jobs.limit()
    assert [job.id for job in sorted(done, key=lambda job: job.started)] == job_ids


def test_a_worker_outlives_the_server_that_started_it(workspace, tmp_path):
    gate = tmp_path / "gate"
    server = subprocess.Popen(
        [
            sys.executable,
            "-c",
            "import sys, time, tests.toy_method as toy\nfrom core.workspace import Workspace\nfrom webapp import jobs\n"
            "jobs.start(Workspace(sys.argv[1]), toy.request(gate=sys.argv[2]))\ntime.sleep(600)",
            str(workspace.path),
            str(gate),
        ],
        cwd=REPOSITORY,
        start_new_session=True,
    )
    job = wait_for(lambda: next(iter(workspace.jobs.list()), None))
    counting(workspace, job)
    os.killpg(server.pid, signal.SIGKILL)  # with all that hangs on it
    server.wait()
    gate.touch()
    assert ended(workspace, job).state == "done"


def test_jobs_left_waiting_are_taken_up_later(workspace):
    job = analyses.submit(workspace, toy_method.request(seconds=0.1))
    assert jobs.ensure_worker(workspace)
    assert ended(workspace, job).state == "done"
    assert not jobs.ensure_worker(workspace)


def test_two_who_ask_at_once_share_one_job(workspace, tmp_path):
    gate = tmp_path / "gate"
    request, found = toy_method.request(gate=str(gate), log=str(tmp_path / "log")), []
    threads = [threading.Thread(target=lambda: found.append(jobs.start(workspace, request).id)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(found)) == 1
    gate.touch()
    assert ended(workspace, workspace.jobs.get(found[0])).state == "done"
    assert (tmp_path / "log").read_text().count("\n") == 1


def test_callbacks_of_dash_wait_in_threads_and_leave_nothing_in_the_workspace(workspace):
    before = sorted(workspace.path.rglob("*"))
    assert isinstance(jobs.background_manager(), WaitingManager)
    assert sorted(workspace.path.rglob("*")) == before


def test_a_server_with_redis_but_without_celery_says_what_to_install(workspace, monkeypatch):
    monkeypatch.setenv(launching.REDIS, "redis://localhost:1/0")
    monkeypatch.setitem(sys.modules, "celery", None)
    monkeypatch.delitem(sys.modules, "webapp.jobs.celery_workers", raising=False)
    monkeypatch.delattr(webapp.jobs, "celery_workers", raising=False)
    with pytest.raises(RuntimeError, match="pip install"):
        jobs.get_ready(workspace)


def test_a_job_that_would_take_too_much_asks_first(workspace, monkeypatch):
    monkeypatch.setattr(estimates, "_prior", lambda: {"toy": [(1.0, 1e6, 1e8)]})
    job = jobs.start(workspace, toy_method.request())
    assert "This would take" in job.held and not jobs.ensure_worker(workspace)
    (row,) = job_bar.rows([workspace.jobs.get(job.id)])
    assert row["held"] and row["stage"] == job.held and row["expected"].startswith("expected:")
    assert not job_bar.read_pulse(workspace).busy
    workspace.jobs.release(job.id)
    assert jobs.ensure_worker(workspace) and ended(workspace, job).state == "done"


def test_a_job_that_broke_off_starts_again_with_the_next_server_but_only_once(workspace, monkeypatch):
    monkeypatch.setattr(launching, "launch", lambda path: None)
    table = workspace._database
    for seconds, error in ((1, STOPPED), (2, worker.OUT_OF_MEMORY), (3, STOPPED)):
        job = jobs.start(workspace, toy_method.request(seconds=seconds))
        workspace.jobs.claim(job.id)
        workspace.jobs.fail(job.id, error, died=True)
    with table.transaction("make it old") as rows:
        rows.execute("UPDATE jobs SET finished = 5 WHERE id = ?", (job.id,))
    assert jobs.resume(workspace) == 1  # neither what took the memory, nor what nobody has missed for long
    again = workspace.jobs.list()[0]
    assert again.state == "queued" and again.request["parameters"]["seconds"] == 1
    assert jobs.resume(workspace) == 0
    workspace.jobs.claim(again.id)
    workspace.jobs.fail(again.id, STOPPED, died=True)
    assert jobs.resume(workspace) == 0


def test_a_job_whose_worker_is_killed_starts_again_with_the_next_look_of_a_page_but_only_once(workspace):
    look = open_bar(workspace)
    first = jobs.start(workspace, toy_method.request(seconds=300))
    os.kill(counting(workspace, first).pid, signal.SIGKILL)
    assert wait_for(lambda: workspace.jobs.get(first.id).state == "failed")
    with acting_as(Person("guest", "viewer")):  # the page of someone who may start nothing is as good as any
        look()
    second = workspace.jobs.list()[0]
    assert second.id != first.id and second.request == first.request
    assert workspace.audit.who_started(second.id) == workspace.audit.who_started(first.id)
    os.kill(counting(workspace, second).pid, signal.SIGKILL)
    assert wait_for(lambda: workspace.jobs.get(second.id).state == "failed")
    look()
    assert workspace.jobs.list()[0].id == second.id


def open_bar(workspace):
    """The poll of the job bar, as a page calls it."""
    functions = {}
    app = SimpleNamespace(
        clientside_callback=lambda *arguments: None,
        callback=lambda *arguments, **more: lambda function: functions.setdefault(function.__name__, function),
    )
    job_bar.register(app, workspace)
    return lambda: functions["poll"](1, None, [], {})


@pytest.mark.parametrize("exit_code", [7, -signal.SIGKILL])
def test_a_disk_that_fills_up_is_named(workspace, monkeypatch, exit_code):
    monkeypatch.setattr(launching, "launch", lambda path: None)
    job = workspace.jobs.claim(jobs.start(workspace, toy_method.request()).id)
    monkeypatch.setattr(worker.shutil, "disk_usage", lambda path: namedtuple("Usage", "free")(1000))
    fail, tries = workspace.jobs.fail, []

    def busy_at_first(*arguments, **more):
        tries.append(1)
        if len(tries) == 1:
            raise WorkspaceError("Could not note the end of the job: the disk is full.")
        fail(*arguments, **more)

    monkeypatch.setattr(workspace.jobs, "fail", busy_at_first)
    worker._note_end(workspace, job, False, exit_code)
    assert workspace.jobs.get(job.id).error == worker.DISK_FULL and len(tries) == 2
