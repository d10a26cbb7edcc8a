"""From a click on the motion map until the updated view is painted, on 40 x 40 nodes, in headless Chromium.

usage: python -m benchmarks.bench_map_click
"""

from __future__ import annotations

import os
import statistics
import tempfile
from pathlib import Path

import numpy as np
from playwright.sync_api import Page, sync_playwright

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from tests.browser.motion_map.page import place_of, wait_for_map
from tests.browser.start import running, start_chromium
from webapp.app import create_app
from webapp.shell import settings

COMMAND = "python -m benchmarks.bench_map_click"
VIEW = {"width": 1280, "height": 800}
GRID = {"map-grid": "40x40"}
CLICKS = 20

# "down" is marked before any listener of the app hears of it; "shown" in the frame after the one in which the strip of
# keys, the number of hits and the list of hits all speak of the new key: by then that frame has been painted
WATCH = """(event) => {
    addEventListener(event, () => {
        const asked = performance.now();
        const look = () => {
            if (!window.isShown()) return requestAnimationFrame(look);
            requestAnimationFrame(() => { window.taken = performance.now() - asked; });
        };
        requestAnimationFrame(look);
    }, true);
}"""
SHOWN = """([keys, hits]) => {
    window.taken = null;
    window.isShown = () => document.querySelectorAll('.map-key-card').length === keys
        && document.querySelectorAll('.map-key').length === keys
        && document.getElementById('map-count').textContent.startsWith(hits === 1 ? '1 hit' : `${hits} hits`)
        && document.querySelectorAll('.map-hit').length >= Math.min(hits, 12);
}"""


def measured(page: Page, keys: int, hits: int, act) -> float:
    """Milliseconds from what ``act`` does until ``keys`` keys and ``hits`` hits are on the screen."""
    page.evaluate(SHOWN, [keys, hits])
    act()
    return page.wait_for_function("() => window.taken", timeout=60_000).json_value()


def clicks(page: Page, motion_map, nodes: np.ndarray) -> list[float]:
    """Clicks two keys, again and again on other nodes: the time of every click, the first two left out."""
    times = []
    for first, second in zip(nodes[::2], nodes[1::2], strict=True):
        page.evaluate("motionscapeMap.setKeys([])")
        page.wait_for_timeout(400)
        for keys in ([tuple(first)], [tuple(first), tuple(second)]):
            place = place_of(page, *map(int, keys[-1]))
            page.mouse.move(*place)
            page.wait_for_timeout(200)
            hits = len(motion_map.search(keys, 0.6))
            times.append(measured(page, len(keys), hits, lambda place=place: page.mouse.click(*place)))
    return times[2:]


def main() -> str:
    """Measure, print and return the Markdown section."""
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        workspace = Workspace(Path(folder) / "workspace")
        workspace.add_dataset("demo", make_demo(minutes=6.0))
        motion_map = analyses.run(workspace, settings.request_of("map", "demo", GRID))
        browser = start_chromium(playwright)
        with running(create_app(workspace.path).server) as address:
            page = browser.new_page(viewport=VIEW)
            page.goto(f"{address}/map?dataset=demo&map-grid=40x40&within=0.60")
            wait_for_map(page)
            page.wait_for_timeout(3000)
            page.evaluate(WATCH, "click")
            busy = np.argwhere(motion_map.density > np.median(motion_map.density[motion_map.density > 0]))
            rng = np.random.default_rng(0)
            times = clicks(page, motion_map, busy[rng.choice(len(busy), CLICKS + 2, replace=False)])
        version = browser.version
        browser.close()
    lines = [
        "## Click on the map",
        "",
        f"Milliseconds from a click on a node of the demo's 40 x 40 map ({len(motion_map.runs.node)} runs, T = .6 m) "
        "until the grown key, the strip of keys, the number of hits and the first 12 of their list are painted, "
        f"in headless Chromium {version}, software rendering, {VIEW['width']} x {VIEW['height']}; {len(times)} clicks: "
        f"median {statistics.median(times):.0f}, worst {max(times):.0f}. Machine load at the end: "
        f"{os.getloadavg()[0]:.1f} on {os.cpu_count()} cores. `{COMMAND}`",
    ]
    section = "\n".join(lines)
    print(section)
    return section


if __name__ == "__main__":
    main()
