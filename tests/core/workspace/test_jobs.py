"""The job table, seen from several threads and processes."""

import multiprocessing
import os
import signal
import sqlite3
import threading
import time

import pytest

from core.progress import Cancelled
from core.workspace import Workspace, WorkspaceError
from core.workspace import jobs as job_table
from core.workspace.database import Database

spawn = multiprocessing.get_context("spawn")  # a fork of a process that has used OpenMP cannot compute


@pytest.fixture
def workspace(tmp_path):
    return Workspace(tmp_path / "space")


def wait_for(condition, seconds=120.0):
    deadline = time.monotonic() + seconds
    while not (found := condition()):
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.02)
    return found


def edit(workspace, statement, *values):
    with sqlite3.connect(workspace.path / "workspace.sqlite") as table:
        table.execute(statement, values)


def test_the_same_request_is_one_job_while_it_lives(workspace):
    first = workspace.jobs.submit("aa", {"n": 1}, "one")
    assert workspace.jobs.submit("aa", {"n": 1}, "one").id == first.id
    other = workspace.jobs.submit("bb", {"n": 2}, "two")
    assert other.id != first.id
    assert workspace.jobs.claim(first.id).pid == os.getpid()
    assert workspace.jobs.claim(first.id) is None
    assert workspace.jobs.submit("aa", {"n": 1}, "one").id == first.id
    workspace.jobs.finish(first.id)
    done = workspace.jobs.get(first.id)
    assert done.state == "done" and done.finished >= done.started >= done.created
    assert workspace.jobs.submit("aa", {"n": 1}, "one").id != first.id
    assert workspace.jobs.latest("bb").request == {"n": 2}


def test_progress_is_seen_through_another_connection(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    workspace.jobs.progress(job.id, "matching", 0.25)
    seen = Workspace(workspace.path).jobs.get(job.id)
    assert (seen.state, seen.stage, seen.fraction) == ("running", "matching", 0.25)
    workspace.jobs.progress(job.id, "matching", 7)
    assert workspace.jobs.get(job.id).fraction == 1.0


def test_at_most_so_many_run_and_the_oldest_is_next(workspace):
    ids = [workspace.jobs.submit(f"{k:02x}", {}, str(k)).id for k in range(4)]
    assert [workspace.jobs.claim_next(2).id for _ in range(2)] == ids[:2]
    assert workspace.jobs.claim_next(2) is None
    workspace.jobs.fail(ids[0], "no")
    assert workspace.jobs.claim_next(2).id == ids[2]
    assert workspace.jobs.running() == 2 and workspace.jobs.newest_queued() == ids[3]


def test_cancel_ends_a_queued_job_at_once_and_asks_a_running_one(workspace):
    queued = workspace.jobs.submit("aa", {}, "one")
    assert workspace.jobs.cancel(queued.id).state == "cancelled"
    running = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    assert running.id != queued.id
    assert workspace.jobs.cancel(running.id).cancelling
    assert workspace.jobs.submit("aa", {}, "one").id != running.id  # asked again: not the dying one
    workspace.jobs.stopped(running.id)
    assert workspace.jobs.get(running.id).state == "cancelled"
    assert workspace.jobs.cancel(10_000) is None


def test_a_worker_hears_of_a_cancel(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    with pytest.raises(Cancelled), workspace.jobs.working(job.id) as report:
        report("counting", 0.0)
        Workspace(workspace.path).jobs.cancel(job.id)
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline:
            report("counting", 0.5)
            time.sleep(0.01)


def test_progress_is_throttled(workspace, monkeypatch):
    written = []
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    monkeypatch.setattr(workspace.jobs, "progress", lambda *values: written.append(values))
    with workspace.jobs.working(job.id) as report:
        for k in range(20_000):
            report("counting", k / 20_000)
    assert 1 <= len(written) < 200


def _work_forever(path, job_id):
    workspace = Workspace(path)
    workspace.jobs.claim(job_id)
    with workspace.jobs.working(job_id):
        time.sleep(600)


def test_a_killed_worker_is_noticed_and_the_job_can_be_run_again(workspace):
    job = workspace.jobs.submit("aa", {}, "one")
    worker = spawn.Process(target=_work_forever, args=(workspace.path, job.id))
    worker.start()
    wait_for(lambda: workspace.jobs.get(job.id).state == "running")
    os.kill(worker.pid, signal.SIGKILL)
    dead = wait_for(lambda: (j := workspace.jobs.get(job.id)).state == "failed" and j)
    worker.join()
    assert dead.died and "run it again" in dead.error
    again = workspace.jobs.submit("aa", {}, "one")
    assert again.id != job.id and workspace.jobs.claim(again.id)


def test_a_worker_elsewhere_is_judged_by_its_heartbeat(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    edit(workspace, "UPDATE jobs SET host = 'another machine'")
    assert workspace.jobs.get(job.id).state == "running"
    edit(workspace, "UPDATE jobs SET heartbeat = heartbeat - ?", job_table.STALE_ELSEWHERE + 1)
    assert workspace.jobs.get(job.id).state == "failed"


def test_an_id_that_was_used_again_is_not_the_worker(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    edit(workspace, "UPDATE jobs SET born = born - 1000")
    assert workspace.jobs.get(job.id).died


def test_a_worker_that_ignores_a_cancel_is_given_up(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    workspace.jobs.cancel(job.id)
    late = job_table.CANCEL_PATIENCE + 1
    edit(workspace, "UPDATE jobs SET heartbeat = heartbeat - ?, cancel = cancel - ?", late, late)
    assert workspace.jobs.get(job.id).state == "cancelled"


def test_work_that_was_given_up_too_early_still_counts(workspace):
    job = workspace.jobs.claim(workspace.jobs.submit("aa", {}, "one").id)
    workspace.jobs.fail(job.id, "seemed dead")
    workspace.jobs.finish(job.id)
    done = workspace.jobs.get(job.id)
    assert (done.state, done.error) == ("done", "")


def test_history_is_pruned_but_living_jobs_are_not(workspace, monkeypatch):
    monkeypatch.setattr(job_table, "KEPT", 5)
    waiting = workspace.jobs.submit("ffff", {}, "waits")
    for k in range(12):
        workspace.jobs.cancel(workspace.jobs.submit(f"{k:02x}", {}, str(k)).id)
    workspace.jobs.cancel(workspace.jobs.submit("eeee", {}, "last").id)
    jobs = workspace.jobs.list(1000)
    assert len(jobs) <= 7 and workspace.jobs.get(waiting.id).state == "queued"
    assert jobs[0].title == "last"


def _submit_and_claim(path, start, claimed):
    workspace = Workspace(path)
    start.wait()
    for k in range(20):
        job = workspace.jobs.submit(f"{k:04x}", {}, str(k))
        if workspace.jobs.claim(job.id):
            claimed.put(job.id)


def test_of_many_processes_one_gets_each_job(workspace):
    start, claimed = spawn.Event(), spawn.Queue()
    workers = [spawn.Process(target=_submit_and_claim, args=(workspace.path, start, claimed)) for _ in range(4)]
    for worker in workers:
        worker.start()
    start.set()
    got = []
    for worker in workers:
        worker.join(120)
        assert worker.exitcode == 0
    while not claimed.empty():
        got.append(claimed.get())
    # A worker that ends before the others asked leaves a failed job behind, which may be claimed anew under a new id.
    assert len(got) == len(set(got)) and len(got) >= 20


def _open(path, start, failures):
    start.wait()
    try:
        Workspace(path).jobs.list()
    except Exception as error:
        failures.put(repr(error))


def test_many_processes_may_make_the_workspace_at_once(tmp_path):
    start, failures = spawn.Event(), spawn.Queue()
    openers = [spawn.Process(target=_open, args=(tmp_path / "new", start, failures)) for _ in range(6)]
    for opener in openers:
        opener.start()
    start.set()
    for opener in openers:
        opener.join(120)
    assert failures.empty()


def test_threads_and_children_use_connections_of_their_own(workspace):
    failures = []

    def submit(k):
        try:
            for i in range(10):
                workspace.jobs.submit(f"{k:02x}{i:02x}", {}, "t")
        except Exception as error:
            failures.append(error)

    threads = [threading.Thread(target=submit, args=(k,)) for k in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    child = multiprocessing.get_context("fork").Process(target=workspace.jobs.submit, args=("cccc", {}, "child"))
    child.start()
    child.join(120)
    assert not failures and child.exitcode == 0
    assert len(workspace.jobs.list(1000)) == 61


def test_a_busy_table_is_said_plainly(tmp_path):
    path = tmp_path / "t.sqlite"
    database = Database(path, patience=0.2)
    holder = sqlite3.connect(path, isolation_level=None)
    holder.execute("BEGIN IMMEDIATE")
    with pytest.raises(WorkspaceError, match="busy"), database.transaction("enter the job"):
        pass
    holder.execute("ROLLBACK")
    with database.transaction("enter the job"):
        pass
    holder.close()


def test_a_damaged_table_is_said_plainly_and_can_be_replaced(tmp_path):
    (tmp_path / "workspace.sqlite").write_bytes(b"this is no table" * 300)
    with pytest.raises(WorkspaceError, match="rename that file"):
        Workspace(tmp_path)
    (tmp_path / "workspace.sqlite").rename(tmp_path / "old")
    assert Workspace(tmp_path).jobs.list() == []


def test_the_table_of_an_older_workspace_gets_the_columns_that_came_later(tmp_path):
    path = tmp_path / "old"
    job = Workspace(path).jobs.submit("aa", {}, "one")
    with sqlite3.connect(path / "workspace.sqlite") as table:
        for column in ("expected", "held"):
            table.execute(f"ALTER TABLE jobs DROP COLUMN {column}")
        table.execute("DROP TABLE costs")
    again = Workspace(path)
    assert again.jobs.get(job.id).held == "" and again.costs.newest() == []
    assert again.jobs.submit("bb", {}, "two", held="too long").held == "too long"
