"""What runs Dash's background callbacks on this machine: threads that wait, where Dash itself would fork."""

from __future__ import annotations

import itertools
import threading
from typing import Any

from dash import DiskcacheManager


class WaitingManager(DiskcacheManager):
    """Dash's manager, but a callback runs in a thread of the server.

    Ours only wait for a worker (webapp/jobs.work). A fork for that may lock the server for good: where another thread
    is in linear algebra at that moment, the fork waits for the library's threads while it keeps the interpreter.
    """

    def __init__(self, cache: Any):
        super().__init__(cache)
        self._numbers = itertools.count(1)
        self._threads: dict[int, threading.Thread] = {}
        self._lock = threading.Lock()

    def call_job_fn(self, key: str, job_fn: Any, args: Any, context: Any) -> int:
        """Starts the callback; the number by which Dash asks for it."""
        arguments = (key, self._make_progress_key(key), args, context)
        thread = threading.Thread(target=job_fn, args=arguments, daemon=True)
        with self._lock:
            number = next(self._numbers)
            self._threads = {n: t for n, t in self._threads.items() if t.is_alive()} | {number: thread}
            thread.start()
        return number

    def job_running(self, job: Any) -> bool:
        """Whether the callback of this number still waits."""
        thread = self._threads.get(int(job or 0))
        return thread is not None and thread.is_alive()

    def terminate_job(self, job: Any) -> None:
        """Lets go of a callback: its thread ends with what it waits for."""
        with self._lock:
            self._threads.pop(int(job or 0), None)

    def terminate_unhealthy_job(self, job: Any) -> bool:
        """A thread is never unhealthy."""
        return False
