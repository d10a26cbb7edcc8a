"""What the server loads or compiles once is got ready in the background, when the first page has been sent.

So the first visit of each other page finds its results read and its compiled functions loaded, and the first page of
all does not wait for any of it.
"""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Mapping

from flask import Flask, Response

log = logging.getLogger(__name__)
DELAY = 1.5  # seconds after the first page, when its own requests have been answered


def after_first_page(server: Flask, steps: Callable[[], Mapping[str, Callable[[], object]]]) -> None:
    """Takes the steps one after another, in a thread, when the first page has been sent; each is logged with its time.

    steps: gives what to get ready: its name -> a function that does it. One that fails is logged and left out, because
    whoever opens that page is told why.
    """
    started = threading.Event()

    @server.after_request
    def _start(response: Response) -> Response:
        if response.status_code == 200 and response.mimetype == "text/html" and not started.is_set():
            started.set()
            timer = threading.Timer(DELAY, take, [server, steps()])
            timer.daemon = True
            timer.start()
        return response


def take(server: Flask, steps: Mapping[str, Callable[[], object]]) -> None:
    """Takes the steps, each as if a request had come for it."""
    for name, step in steps.items():
        begun = time.perf_counter()
        try:
            with server.test_request_context():
                step()
        except Exception:
            log.exception("not got ready: %s", name)
        else:
            log.info("got ready: %s, in %.2f s", name, time.perf_counter() - begun)
