"""From a click on a box of the motif graph until its motions move on the Stage, in headless Chromium.

usage: python -m benchmarks.bench_click
"""

from __future__ import annotations

import os
import statistics
import tempfile
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from core import analyses
from core.demo import make_demo
from core.motifs.graph import MotifGraph
from core.workspace import Workspace
from tests.browser.app import wait_for_graph
from tests.browser.start import running, start_chromium
from webapp.app import create_app
from webapp.shell.playback import MOST_FIGURES

COMMAND = "python -m benchmarks.bench_click"
VIEW = {"width": 1280, "height": 800}
CLICKS = 12  # motifs of the most motions, each clicked once a row of the table
PAUSE = 1500  # milliseconds between clicks
RESTS = {"pointer rests .3 s before the click": 300, "click without a pause": 0}

# "released" is marked before any listener of the app hears of the click, "moving" at the first frame whose time runs.
WATCH = """() => {
    addEventListener('pointerup', () => {
        performance.clearMarks();
        performance.mark('released');
        const look = () => {
            const right = document.querySelector('.ms-stage-title').textContent.startsWith(window.wanted);
            if (right && motionscape.stage.status === 'ready' && motionscape.stage.time > 0) performance.mark('moving');
            else requestAnimationFrame(look);
        };
        requestAnimationFrame(look);
    }, true);
}"""
MEASURE = """() => {
    const moving = performance.getEntriesByName('moving')[0];
    return moving ? moving.startTime - performance.getEntriesByName('released')[0].startTime : null;
}"""
PLACE = """(id) => {
    const cy = document.getElementById('motif-graph')._cyreg.cy, at = cy.getElementById(id).renderedPosition();
    const box = cy.container().getBoundingClientRect();
    return [box.x + at.x, box.y + at.y];
}"""


def click_milliseconds(page: Page, motif: int, rest: int) -> float:
    """Milliseconds from releasing the mouse on a motif until its motions move."""
    page.mouse.move(5, 5)
    place = page.evaluate(PLACE, f"m{motif}")
    page.evaluate("title => { window.wanted = title; }", f"Motif {motif}:")
    page.mouse.move(*place)
    page.wait_for_timeout(rest)
    page.mouse.click(*place)
    taken = page.wait_for_function(MEASURE, timeout=60_000).json_value()
    page.wait_for_timeout(PAUSE)
    return taken


def prepare(folder: Path) -> MotifGraph:
    """A workspace with six minutes of the demo and its motif graph."""
    workspace = Workspace(folder)
    workspace.add_dataset("demo", make_demo(minutes=6.0))
    return analyses.run(workspace, analyses.Request("demo", "motifs"))


def main() -> str:
    """Measure, print and return the Markdown section."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        graph = prepare(Path(folder) / "workspace")
        busiest = sorted(graph.motifs, key=lambda motif: -motif.n_motions)[: 2 * CLICKS]
        browser = start_chromium(playwright)
        rows = []
        with running(create_app(Path(folder) / "workspace").server) as address:
            page = browser.new_page(viewport=VIEW)
            page.goto(f"{address}/motifs")
            wait_for_graph(page)
            page.wait_for_timeout(4000)
            page.evaluate(WATCH)
            click_milliseconds(page, graph.motifs[-1].id, 0)  # what is compiled at the first click
            for k, (how, rest) in enumerate(RESTS.items()):
                motifs = busiest[k::2]  # a motif that was shown before would be there already
                times = [click_milliseconds(page, motif.id, rest) for motif in motifs]
                figures = [min(motif.n_motions, MOST_FIGURES) for motif in motifs]
                rows.append((how, len(times), statistics.median(figures), max(figures), times))
        version = browser.version
        browser.close()
    lines = [
        "## Click to view",
        "",
        f"Milliseconds from the release of the mouse on a box of the demo's motif graph ({len(graph.motifs)} boxes, "
        f"{len(graph.edges)} arrows) until its motions move on the Stage, in headless Chromium {version}, software "
        f"rendering, {VIEW['width']} x {VIEW['height']}; each motif for the first time. Machine load at the end: "
        f"{os.getloadavg()[0]:.1f} on {os.cpu_count()} cores.",
        "",
        "| | clicks | figures, median (most) | median | worst |",
        "|---|---|---|---|---|",
        *(
            f"| {how} | {n} | {figures:.0f} ({most}) | {statistics.median(times):.0f} | {max(times):.0f} |"
            for how, n, figures, most, times in rows
        ),
        "",
        f"`{COMMAND}`",
    ]
    section = "\n".join(lines)
    print(section)
    return section


if __name__ == "__main__":
    main()
