"""Runs Dash's background callbacks in threads, where Dash itself would fork."""

from __future__ import annotations

import itertools
import threading
from typing import Any

from dash import DiskcacheManager


class WaitingManager(DiskcacheManager):
    """Dash's manager, except that callbacks run in threads of the server.

    Our callbacks only wait for a worker (``jobs.wait_for``). Forking for that can block the server forever: if another
    thread is inside a linear algebra library, the fork waits for the library's threads while it holds the interpreter.
    """

    def __init__(self, cache: Any):
        super().__init__(cache)
        self._numbers = itertools.count(1)
        self._threads: dict[int, threading.Thread] = {}
        self._lock = threading.Lock()

    def call_job_fn(self, key: str, job_fn: Any, args: Any, context: Any) -> int:
        """Starts the callback; returns the number by which Dash refers to it."""
        arguments = (key, self._make_progress_key(key), args, context)
        thread = threading.Thread(target=job_fn, args=arguments, daemon=True)
        with self._lock:
            number = next(self._numbers)
            self._threads = {n: t for n, t in self._threads.items() if t.is_alive()} | {number: thread}
            thread.start()
        return number

    def job_running(self, job: Any) -> bool:
        """Whether the callback with this number still runs."""
        thread = self._threads.get(int(job or 0))
        return thread is not None and thread.is_alive()

    def terminate_job(self, job: Any) -> None:
        """Forgets a callback; its thread ends when the job that it waits for does."""
        with self._lock:
            self._threads.pop(int(job or 0), None)

    def terminate_unhealthy_job(self, job: Any) -> bool:
        """A thread is never unhealthy."""
        return False
