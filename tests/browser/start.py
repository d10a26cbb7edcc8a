"""A headless Chromium and a server of this process, for the browser tests, the benchmarks and the screenshots."""

from __future__ import annotations

import shutil
import threading
from collections.abc import Iterator
from contextlib import contextmanager

from playwright.sync_api import Browser, Playwright
from werkzeug.serving import WSGIRequestHandler, make_server

FLAGS = [
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"),
    *("--disable-background-networking", "--disable-component-update"),
]


def start_chromium(playwright: Playwright) -> Browser:
    """The Chromium of this machine (as scripts/install_browser.sh looks for it), else Playwright's own.

    Raises playwright's Error where there is none.
    """
    here = shutil.which("chromium") or shutil.which("google-chrome")
    return playwright.chromium.launch(executable_path=here, args=FLAGS)


class Quiet(WSGIRequestHandler):
    """Does not log every request."""

    def log_request(self, code="-", size="-") -> None:
        """Nothing to say."""


@contextmanager
def running(application) -> Iterator[str]:
    """Serve a WSGI application on a free port of this machine; gives its address."""
    server = make_server("127.0.0.1", 0, application, threaded=True, request_handler=Quiet)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    try:
        yield f"http://127.0.0.1:{server.server_port}"
    finally:
        server.shutdown()
        thread.join(10)
        server.server_close()
