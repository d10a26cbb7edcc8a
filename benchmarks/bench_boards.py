"""A board that many browsers have open: what their questions cost, and how soon a change reaches them.

usage: python -m benchmarks.bench_boards

Everyone is signed in and asks once a second, as the page does; one of them changes a block now and then.
"""

from __future__ import annotations

import http.client
import json
import random
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlencode

import psutil

from core import Workspace, make_demo
from core.workspace.blocks import Block

COMMAND = "python -m benchmarks.bench_boards"
BROWSERS = (20, 50)
BLOCKS = 12
CHANGES = 20
EVERY = 1.0  # seconds between two questions of a browser (assets/boards/board.mjs)
BETWEEN = 1.5  # seconds between two changes, give or take
PASSWORD = "only for measuring"


@dataclass
class Browser:
    """Asks for a board until told to stop. arrivals: version -> when it was first seen; times: seconds of answers."""

    address: tuple[str, int]
    cookie: str
    path: str
    stop: threading.Event
    arrivals: dict[int, float] = field(default_factory=dict)
    times: list[float] = field(default_factory=list)
    sent: int = 0  # bytes of bodies

    def run(self) -> None:
        """Asks once a second, beginning at any moment of the first."""
        connection, tag = http.client.HTTPConnection(*self.address, timeout=30), ""
        self.stop.wait(EVERY * random.random())
        while not self.stop.is_set():
            begun = time.perf_counter()
            connection.request("GET", self.path, headers={"Cookie": self.cookie, "If-None-Match": tag})
            answer = connection.getresponse()
            body = answer.read()
            now = time.perf_counter()
            self.times.append(now - begun)
            self.sent += len(body)
            if answer.status == 200:
                tag = answer.headers["ETag"]
                self.arrivals.setdefault(json.loads(body)["version"], now)
            elif answer.status != 304:
                raise RuntimeError(f"status {answer.status}: {body[:200]!r}")
            self.stop.wait(EVERY)


def prepare(folder: Path) -> tuple[Workspace, str]:
    """A workspace with the small demo, a board of twelve blocks and an account; the board's id."""
    workspace = Workspace(folder)
    workspace.add_dataset("demo", make_demo(minutes=1, seed=0))
    workspace.users.add("ann", PASSWORD, "owner")
    text = {"options": {"markdown": "Some words that stand on the board. " * 10}}
    blocks = [Block(f"b{k}", "text", 4 * (k % 3), 4 * (k // 3), 4, 4, text) for k in range(BLOCKS)]
    board = workspace.boards.create("Measured", blocks)
    return workspace, workspace.boards.set_filters(board.id, {"dataset": "demo"}).id


def start(folder: Path) -> tuple[subprocess.Popen[str], tuple[str, int]]:
    """A server of the workspace in a process of its own, and its address."""
    command = [sys.executable, "-m", "webapp.cli", "serve", str(folder), "--port", "0", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None
    for line in process.stdout:
        if found := re.search(r"http://([^:/]+):(\d+)", line):
            return process, (found[1], int(found[2]))
    raise RuntimeError("the server did not start")


def sign_in(address: tuple[str, int]) -> str:
    """The cookie of a session."""
    connection = http.client.HTTPConnection(*address, timeout=60)
    form = urlencode({"name": "ann", "password": PASSWORD})
    connection.request("POST", "/sign-in", form, {"Content-Type": "application/x-www-form-urlencoded"})
    answer = connection.getresponse()
    answer.read()
    if answer.status != 303:
        raise RuntimeError(f"signing in: status {answer.status}")
    return answer.headers["Set-Cookie"].partition(";")[0]


def change(address: tuple[str, int], cookie: str, path: str, number: int) -> tuple[int, float, float]:
    """Changes a block over HTTP, as someone who has the board open: new version, when it was sent, seconds it took."""
    connection = http.client.HTTPConnection(*address, timeout=30)
    connection.request("GET", path, headers={"Cookie": cookie})
    block = json.loads(connection.getresponse().read())["blocks"][number % BLOCKS]
    block["settings"]["options"] = {"markdown": f"Words number {number}"}
    body = json.dumps({"action": "change", "block": block, "version": block["version"]})
    headers = {"Cookie": cookie, "Content-Type": "application/json", "X-Motionscape": "1"}
    begun = time.perf_counter()
    connection.request("POST", path, body, headers)
    answer = connection.getresponse()
    said = json.loads(answer.read())
    if answer.status != 200:
        raise RuntimeError(f"status {answer.status}: {said}")
    return said["version"], begun, time.perf_counter() - begun


def measure(address: tuple[str, int], cookie: str, path: str, browsers: int, pid: int) -> dict[str, float]:
    """What so many browsers cost and see while a block is changed; times in milliseconds."""
    stop, server = threading.Event(), psutil.Process(pid)
    open_ones = [Browser(address, cookie, path, stop) for _ in range(browsers)]
    threads = [threading.Thread(target=browser.run) for browser in open_ones]
    for thread in threads:
        thread.start()
    time.sleep(2 * EVERY)
    begun, cpu = time.perf_counter(), sum(server.cpu_times()[:2])
    asked_before = sum(len(browser.times) for browser in open_ones)
    changes = []
    for number in range(CHANGES):
        changes.append(change(address, cookie, path, number))
        time.sleep(BETWEEN * random.uniform(0.6, 1.4))
    time.sleep(3 * EVERY)
    seconds, cpu = time.perf_counter() - begun, sum(server.cpu_times()[:2]) - cpu
    asked = sum(len(browser.times) for browser in open_ones) - asked_before
    stop.set()
    for thread in threads:
        thread.join()
    delays = [1000 * (seen_at(browser, version) - when) for version, when, _ in changes for browser in open_ones]
    times = [1000 * one for browser in open_ones for one in browser.times]
    return {
        "median": statistics.median(delays),
        "p95": statistics.quantiles(delays, n=20)[-1],
        "most": max(delays),
        "answer": statistics.median(times),
        "answer95": statistics.quantiles(times, n=20)[-1],
        "save": 1000 * statistics.median(took for _, _, took in changes),
        "cpu": 1000 * cpu / asked,
        "core": 100 * cpu / seconds,
    }


def seen_at(browser: Browser, version: int) -> float:
    """When a browser first saw this version or a later one; raises RuntimeError where it never did."""
    times = [when for seen, when in browser.arrivals.items() if seen >= version]
    if not times:
        raise RuntimeError(f"a browser never saw version {version}")
    return min(times)


def main() -> str:
    """The section of docs/benchmarks.md."""
    random.seed(0)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        workspace, board = prepare(Path(folder))
        process, address = start(Path(folder))
        try:
            cookie, path = sign_in(address), f"/api/boards/{board}"
            for browsers in BROWSERS:
                m = measure(address, cookie, path, browsers, process.pid)
                rows.append(
                    f"| {browsers} | {m['median']:.0f} | {m['p95']:.0f} | {m['most']:.0f} | {m['answer']:.0f} | "
                    f"{m['answer95']:.0f} | {m['save']:.0f} | {m['cpu']:.1f} | {m['core']:.0f} % |"
                )
        finally:
            process.terminate()
            process.wait()
            workspace.close()
    load = ", ".join(f"{value:.1f}" for value in psutil.getloadavg())
    words = (
        f"A board of {BLOCKS} blocks that many browsers have open. Each is signed in and asks once a second whether\n"
        f"something has changed; {CHANGES} changes of a block come from one of them. Arrival: from sending a change\n"
        "until another browser has it. Times in ms; CPU of the server's process, for each question and of a core.\n"
        f"Load of the two cores during the last 1, 5 and 15 minutes: {load}."
    )
    head = (
        "| browsers | arrival: median | 95 % | longest | answer: median | 95 % | saving | CPU a question | of a core |"
    )
    return "\n".join(
        ["## Boards", "", words, "", head, f"|{9 * '---|'}", *rows, "", f"`{COMMAND.replace('.bench_', ' ')}`"]
    )


if __name__ == "__main__":
    print(main())
