"""The frames of a film, painted by the app's own player in a browser without a window.

A server on the loopback serves one page (``assets/film``) and the motion; the page paints a frame, sends its pixels and
waits until they are taken, so that a film of any length needs the memory of a few frames.
"""

from __future__ import annotations

import contextlib
import json
import queue
import secrets
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from core.errors import AnalysisError
from webapp.shell.assets import PARTS, assets_folder
from webapp.shell.browser import find_browser, headless

Picture = npt.NDArray[np.uint8]
VIEWS = {"corner": (0.62, 0.2), "front": (0.0, 0.1), "side": (1.5708, 0.1), "back": (3.1416, 0.1), "top": (0.0, 1.55)}
THEMES = ("light", "dark")
_PATIENCE = 60.0  # seconds without a frame after which the browser is given up


class Film(NamedTuple):
    """What is painted: ``frames`` frames from ``first`` on of a motion of ``rate`` frames a second.

    view: one of VIEWS, directions in the frame of the recording. size: width and height in pixels.
    """

    first: int
    frames: int
    rate: float
    size: tuple[int, int] = (1280, 720)
    view: str = "corner"
    theme: str = "light"


def paint(motion: bytes, film: Film) -> Iterator[Picture]:
    """The frames in order, each (height, width, 3), red, green and blue.

    motion: as :func:`webapp.stage.motion_routes.encode_motion` has it. Raises AnalysisError where this machine has no
    browser, or it does not paint.
    """
    browser = find_browser("A film")
    with _Studio(motion, film) as studio, _running(browser, studio.address) as process:
        for index in range(film.frames):
            yield studio.frame(index, process)


class _Studio(ThreadingHTTPServer):
    """Serves the page and the motion below an address that cannot be guessed, and takes the frames."""

    daemon_threads = True

    def __init__(self, motion: bytes, film: Film) -> None:
        super().__init__(("127.0.0.1", 0), _Requests)
        self.film = film
        self.base = f"/{secrets.token_urlsafe(16)}/"
        self.answers = {"": (_page(film).encode(), "text/html; charset=utf-8")}
        self.answers["motion"] = motion, "application/octet-stream"
        self.arrived: queue.Queue[tuple[str, bytes]] = queue.Queue(maxsize=4)
        threading.Thread(target=self.serve_forever, daemon=True).start()

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_port}{self.base}"

    @property
    def frame_bytes(self) -> int:
        return 4 * self.film.size[0] * self.film.size[1]

    def __exit__(self, *error: object) -> None:
        self.shutdown()
        self.server_close()

    def frame(self, index: int, process: subprocess.Popen[bytes]) -> Picture:
        until = time.monotonic() + _PATIENCE
        while time.monotonic() < until and process.poll() is None:
            with contextlib.suppress(queue.Empty):
                name, body = self.arrived.get(timeout=0.5)
                if name != f"frame/{index}" or len(body) != self.frame_bytes:
                    raise AnalysisError(
                        f"The player could not paint frame {index}: {body[:300].decode(errors='replace')}"
                    )
                width, height = self.film.size
                return np.frombuffer(body, np.uint8).reshape(height, width, 4)[:, :, :3]
        ended = f"it ended with code {process.returncode}" if process.poll() is not None else "it does not answer"
        raise AnalysisError(f"The browser painted {index} of {self.film.frames} frames: {ended}.")


class _Requests(BaseHTTPRequestHandler):
    server: _Studio

    def do_GET(self) -> None:
        answer = self.server.answers.get(self.path.removeprefix(self.server.base))
        if answer is None or not self.path.startswith(self.server.base):
            self.send_error(404)
            return
        body, kind = answer
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def do_POST(self) -> None:
        size = int(self.headers.get("Content-Length") or 0)
        if not self.path.startswith(self.server.base) or size > self.server.frame_bytes:
            self.send_error(404)
            return
        body = self.rfile.read(size)
        self.server.arrived.put((self.path.removeprefix(self.server.base), body))
        self.send_response(204)
        self.end_headers()

    def log_message(self, format: str, *args: object) -> None:
        """Nothing: a film has thousands of requests."""


@contextmanager
def _running(browser: str, address: str) -> Iterator[subprocess.Popen[bytes]]:
    with tempfile.TemporaryDirectory(prefix="motionscape-", ignore_cleanup_errors=True) as folder:
        command = [
            *headless(browser, Path(folder)),
            "--force-device-scale-factor=1",
            "--remote-debugging-port=0",
            address,
        ]
        try:
            process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except OSError as error:
            raise AnalysisError(f"{browser} could not be started: {error.strerror}.") from error
        try:
            yield process
        finally:
            process.kill()
            process.wait()


def _page(film: Film) -> str:
    yaw, pitch = VIEWS[film.view]
    width, height = film.size
    parts = assets_folder() / PARTS
    script, styles = ((parts / f"film.{kind}").read_text(encoding="utf-8") for kind in ("js", "css"))
    times = {"first": film.first, "frames": film.frames, "rate": film.rate}
    said = json.dumps({**times, "width": width, "height": height, "yaw": yaw, "pitch": pitch, "theme": film.theme})
    return f"""<!doctype html>
<html lang="en" data-mantine-color-scheme="{film.theme}">
<head><meta charset="utf-8"><title>Film</title><style>{styles}</style></head>
<body><script type="application/json" data-film>{said}</script><script>{script}</script></body>
</html>
"""
