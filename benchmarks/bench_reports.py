"""A report of the demo, and a board of twelve blocks in headless Chromium.

usage: python -m benchmarks.bench_reports

The results are there already; measured are drawing them and packing the motion, and how long a browser takes from
the start of the navigation until the last block is drawn.
"""

from __future__ import annotations

import statistics
import sys
import tempfile
import time

from playwright.sync_api import sync_playwright

from core import Workspace, analyses, make_demo
from core.workspace.boards import Block
from tests.browser.start import running, start_chromium
from webapp.app import create_app
from webapp.features.boards.report import make_report

COMMAND = "python -m benchmarks.bench_reports"
RUNS = 5
VIEW = {"width": 1440, "height": 900}
METHODS = ("motifs", "map", "grammar")
KINDS = (
    *("text", "numbers", "graph", "matrix", "motifs", "map", "tracks", "overview", "actions"),
    *("stage", "graph", "numbers"),
)
DRAWN = f"document.querySelectorAll('.grid-stack-item .board-content').length === {len(KINDS)}"


def twelve_blocks(workspace: Workspace) -> str:
    """The id of a board with a block of each kind that the demo has results for, and two more."""
    options = {"text": {"markdown": "## Demo"}, "stage": {"selection": '{"motif": 0}'}}
    blocks = [
        Block("", kind, 4 * (k % 3), 5 * (k // 3), 4, 5, {"title": kind, "options": options.get(kind, {})})
        for k, kind in enumerate(KINDS)
    ]
    board = workspace.boards.create("Twelve blocks", blocks)
    return workspace.boards.set_filters(board.id, {"dataset": "demo"}).id


def opening(address: str) -> list[float]:
    """Seconds until all blocks are drawn, each time in a browser that knows nothing."""
    times = []
    with sync_playwright() as playwright:
        browser = start_chromium(playwright)
        for _ in range(RUNS + 1):
            page = browser.new_context(viewport=VIEW).new_page()
            begun = time.perf_counter()
            page.goto(address)
            page.wait_for_function(DRAWN)
            times.append(time.perf_counter() - begun)
            page.context.close()
        browser.close()
    return times


def main() -> str:
    """The section of docs/benchmarks.md."""
    with tempfile.TemporaryDirectory() as folder:
        workspace = Workspace(folder)
        workspace.add_dataset("demo", make_demo(6.0))
        for method in METHODS:
            analyses.run(workspace, analyses.Request("demo", method))
        walls, processor = [], []
        for _ in range(RUNS):
            begun, used = time.perf_counter(), time.process_time()
            made = make_report(workspace, "demo")
            walls.append(time.perf_counter() - begun)
            processor.append(time.process_time() - used)
        board = twelve_blocks(workspace)
        with running(create_app(workspace.path).server) as address:
            first, *later = opening(f"{address}/boards?dataset=demo&board={board}")
    median = statistics.median
    kept = " ".join(made.motion.split())
    return f"""## Reports and boards

Six minutes of demo; medians of {RUNS} runs. The report has {made.size / 1e6:.1f} MB.
{kept}
The board has {len(KINDS)} blocks; the browser knows nothing of the app, the server has drawn the blocks once.

| | seconds | processor time |
|---|---|---|
| writing the report | {median(walls):.2f} | {median(processor):.2f} |
| opening the board | {median(later):.2f} (fastest {min(later):.2f}) | |
| opening it after the server has started | {first:.2f} | |

`{COMMAND.replace("benchmarks.bench_", "benchmarks ")}`
"""


if __name__ == "__main__":
    sys.stdout.write(main())
