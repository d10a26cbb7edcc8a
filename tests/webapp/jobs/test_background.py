"""The manager of background callbacks: results come, nothing forks."""

from __future__ import annotations

import os
import threading
import time

from diskcache import Cache

from webapp.jobs.background import WaitingManager


def until(condition, patience: float = 60.0) -> None:
    deadline = time.monotonic() + patience
    while not condition():
        assert time.monotonic() < deadline, "waited in vain"
        time.sleep(0.01)


def test_a_callback_runs_in_a_thread_of_this_process(tmp_path):
    manager, go, seen = WaitingManager(Cache(str(tmp_path))), threading.Event(), []

    def wait(job):
        seen.append(os.getpid())
        go.wait(60)
        return f"done {job}"

    number = manager.call_job_fn("key", manager.make_job_fn(wait, False), [7], {})
    assert manager.job_running(number) and not manager.result_ready("key")
    go.set()
    until(lambda: manager.result_ready("key"))
    assert manager.get_result("key", number) == "done 7" and seen == [os.getpid()]
    until(lambda: not manager.job_running(number))
    assert not manager.job_running(None) and not manager.terminate_unhealthy_job(number)


def test_a_new_call_lets_go_of_the_old_one(tmp_path):
    manager, go = WaitingManager(Cache(str(tmp_path))), threading.Event()
    first = manager.call_job_fn("a", manager.make_job_fn(lambda: go.wait(60), False), [], {})
    manager.terminate_job(first)
    assert not manager.job_running(first)
    second = manager.call_job_fn("b", manager.make_job_fn(lambda: "b", False), [], {})
    assert second != first
    until(lambda: manager.get_result("b", second) == "b")
    go.set()
