"""Loading of every page in headless Chromium: requests, bytes sent, and the time until the first useful screen.

The first useful screen shows what the page is about: to be read, and with links to follow. It may come with the HTML
(webapp/shell/first_picture.py), before the scripts have drawn the page; when they have, is measured as well.

usage: python -m benchmarks.bench_first_screen [--before CHECKOUT] [--runs N] [--pages library,motifs]

The app runs as ``motionscape serve`` runs it, in a process of its own, on a workspace with the demo and its results.
With ``--before`` (or MOTIONSCAPE_BEFORE), another checkout with its own ``.venv`` is measured in turn with this one.
"""

from __future__ import annotations

import argparse
import os
import re
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Browser, BrowserContext, CDPSession, sync_playwright

from tests.browser.start import start_chromium
from tests.browser.wire import Wire

COMMAND = "python -m benchmarks first_screen"
REPOSITORY = Path(__file__).resolve().parents[1]
VIEW = {"width": 1280, "height": 800}
RUNS = 5
PATIENCE = 60_000  # milliseconds

USEFUL = {  # page -> what must be visible, and what that is in words
    "library": ("#clips-table .ag-row .ag-cell-value", "a row of the table of clips"),
    "motifs": ("cytoscape", "the boxes of the motif graph"),
    "sweeps": ("#page .empty-state, #page .js-plotly-plot .main-svg", "the form, and what it will show"),
    "map": ("#map-graph .hm image", "the map's heights (a chart)"),
    "search": ("#search-body svg.search-figure", "the form with the body"),
    "grammar": ("#grammar-string .string-clip", "the recordings cut into actions"),
    "clip": ("#clip-graph .scatterlayer .trace path", "the curves (a chart)"),
}

# The time is that of the frame which shows it: the second animation frame after it was found in the page.
# In the picture that comes with the HTML, what libraries draw is named in data-until of its place.
WATCH = """(selector, library) => {
    const picture = () => {
        const until = document.getElementById('first-picture')?.dataset.until ?? '';
        return library !== '' && until.split(' ').includes(library);
    };
    const there = () => {
        if (selector === 'cytoscape') return document.getElementById('motif-graph')?._cyreg?.cy?.nodes().length > 0;
        return [...document.querySelectorAll(selector)].some((one) => one.getBoundingClientRect().height > 0);
    };
    const shown = (name) => requestAnimationFrame(() => requestAnimationFrame(() => {
        window[name] ??= performance.now();
    }));
    let readable = false;
    const look = () => {
        const drawn = there();
        if (!readable && (drawn || picture())) { readable = true; shown('usefulAfter'); }
        if (drawn) return shown('drawnAfter');
        requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
}"""
PICTURED = {"library": "clips-table", "motifs": "motif-graph"}  # page -> what the HTML's picture shows of it


@dataclass(frozen=True)
class Load:
    """One opening of a page: requests that went over the wire, bytes received (compressed, with headers), seconds from
    the start of the navigation to the first useful screen and until the scripts have drawn it, and seconds that the
    page's main thread computed until then.
    """

    requests: int
    received: int
    seconds: float
    drawn: float
    computed: float


def open_page(context: BrowserContext, address: str, selector: str, library: str) -> Load:
    """Opens a page in a new tab of the context and closes it when it has loaded."""
    page = context.new_page()
    page.add_init_script(f"({WATCH})({selector!r}, {library!r})")
    wire = Wire(page)
    metrics = context.new_cdp_session(page)
    metrics.send("Performance.enable")
    before = thread_seconds(metrics)
    page.goto(address, wait_until="commit")
    page.wait_for_function("window.drawnAfter", timeout=PATIENCE)
    computed = thread_seconds(metrics) - before
    wire.wait_until_quiet(page)  # the bar of jobs asks for news every four seconds
    useful, drawn = page.evaluate("[window.usefulAfter, window.drawnAfter]")
    load = Load(len(wire.addresses), wire.received, useful / 1000, drawn / 1000, computed)
    page.close()
    return load


def thread_seconds(session: CDPSession) -> float:
    """CPU time of the page's main thread: it hardly depends on what else the machine does."""
    return next(m["value"] for m in session.send("Performance.getMetrics")["metrics"] if m["name"] == "ThreadTime")


def measure(browser: Browser, address: str, page: str) -> tuple[Load, Load]:
    """A page opened in a fresh context (nothing cached), and once more in the same context."""
    context = browser.new_context(viewport=VIEW)
    cold, warm = (open_page(context, f"{address}/{page}", USEFUL[page][0], PICTURED.get(page, "")) for _ in range(2))
    context.close()
    return cold, warm


# run by each checkout itself, because the files of a workspace change
PREPARE = """
import sys
from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
workspace = Workspace(sys.argv[1])
workspace.add_dataset("demo", make_demo(minutes=6.0))
for method in ("motifs", "map", "grammar"):
    analyses.run(workspace, analyses.Request("demo", method))
"""


def python_of(checkout: Path) -> str:
    """The interpreter that has what a checkout needs."""
    return sys.executable if checkout == REPOSITORY else str(checkout / ".venv" / "bin" / "python")


def prepare(checkout: Path, folder: Path) -> Path:
    """A workspace with six minutes of the demo, its motif graph, map and grammar, made by the code of a checkout."""
    subprocess.run([python_of(checkout), "-c", PREPARE, str(folder)], cwd=checkout, check=True)
    return folder


@contextmanager
def served(checkout: Path, workspace: Path) -> Iterator[str]:
    """``motionscape serve`` of a checkout on a workspace of its own; gives its address."""
    command = [python_of(checkout), "-m", "webapp.cli", "serve", str(workspace), "--port", "0", "--no-browser"]
    process = subprocess.Popen(command, cwd=checkout, stdout=subprocess.PIPE, text=True)
    try:
        yield next(found[0] for line in process.stdout if (found := re.search(r"http://[^/\s]+", line)))
    finally:
        process.terminate()
        process.wait(30)


def compare(
    browser: Browser, addresses: dict[str, str], pages: Sequence[str], runs: int
) -> dict[tuple[str, str], list[tuple[Load, Load]]]:
    """Loads by (page, checkout's name). The checkouts take turns, so that both see the same machine."""
    loads: dict[tuple[str, str], list[tuple[Load, Load]]] = {}
    for address in addresses.values():  # what the server computes at the first request
        measure(browser, address, "library")
    for page in pages:
        for _ in range(runs):
            for name, address in addresses.items():
                loads.setdefault((page, name), []).append(measure(browser, address, page))
    return loads


def row(page: str, name: str, loads: list[tuple[Load, Load]]) -> str:
    """A line of the table."""
    cells = []
    for cache in zip(*loads, strict=True):
        seconds = [load.seconds for load in cache]
        cells += [
            f"{statistics.median(load.requests for load in cache):.0f}",
            f"{statistics.median(load.received for load in cache) / 1e6:.2f}",
            f"{min(seconds):.2f}",
            f"{statistics.median(seconds):.2f}",
            f"{statistics.median(load.drawn for load in cache):.2f}",
            f"{statistics.median(load.computed for load in cache):.2f}",
        ]
    return f"| {page} | {name} | {' | '.join(cells)} |"


def ratios(loads: dict[tuple[str, str], list[tuple[Load, Load]]]) -> Iterator[str]:
    """For pages that were measured in two checkouts: medians of the ratios of runs that followed one another."""
    for page, name in loads:
        if name != "now" or (page, "before") not in loads:
            continue
        pairs = [(old[0], new[0]) for old, new in zip(loads[page, "before"], loads[page, "now"], strict=True)]
        shares = [
            f"{statistics.median(getattr(new, what) / getattr(old, what) for old, new in pairs):.2f} ({words})"
            for what, words in (("seconds", "first useful screen"), ("drawn", "drawn"), ("computed", "CPU"))
        ]
        yield f"\n{page}, cold, now / before, medians of {len(pairs)} pairs of runs: {', '.join(shares)}."


def report(loads: dict[tuple[str, str], list[tuple[Load, Load]]], version: str, runs: int) -> str:
    """The Markdown section."""
    return "\n".join(
        [
            "## First screen",
            "",
            f"Every page opened on its own in headless Chromium {version}, {VIEW['width']} x {VIEW['height']}, from "
            "`motionscape serve` on localhost with the six minutes of the demo and its motif graph, map and grammar. "
            f"Cold: fresh context, nothing cached; warm: the same page again in a new tab. {runs} runs each; requests "
            "and MB (received over the wire, with headers) are medians, seconds run from the start of the navigation "
            "to the first useful screen; drawn: until the scripts have drawn it. Machine load at the end: "
            f"{os.getloadavg()[0]:.1f} on {os.cpu_count()} cores. CPU: seconds that the page's main thread computed "
            "until then, which say more where the machine is busy.",
            "",
            "| page | code | requests | MB | least s | median s | drawn s | CPU s "
            "| warm: requests | MB | least | median | drawn | CPU |",
            "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|",
            *(row(page, name, found) for (page, name), found in loads.items()),
            *ratios(loads),
            "",
            "First useful screen: " + "; ".join(f"{page}: {words}" for page, (_, words) in USEFUL.items()) + ".",
            "",
            f"`{COMMAND}`, with MOTIONSCAPE_BEFORE naming the checkout to compare with",
        ]
    )


def main(
    before: str | None = os.environ.get("MOTIONSCAPE_BEFORE"), runs: int = RUNS, pages: Sequence[str] = tuple(USEFUL)
) -> str:
    """Measure, print and return the Markdown section."""
    checkouts = ({"before": Path(before).resolve()} if before else {}) | {"now": REPOSITORY}
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = start_chromium(playwright)
        with ExitStack() as servers:
            addresses = {
                name: servers.enter_context(served(checkout, prepare(checkout, Path(folder) / name)))
                for name, checkout in checkouts.items()
            }
            loads = compare(browser, addresses, pages, runs)
        section = report(loads, browser.version, runs)
        browser.close()
    print(section)
    return section


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--before", default=os.environ.get("MOTIONSCAPE_BEFORE"))
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--pages", default=",".join(USEFUL))
    options = parser.parse_args()
    main(options.before, options.runs, options.pages.split(","))
