"""From a click to what it changes on the screen: twelve named interactions with what has been computed already.

usage: python -m benchmarks.bench_clicks [--runs N] [--data demo,cmu]

Headless Chromium, ``motionscape serve`` in a process of its own. A run starts where the interaction cannot be seen yet;
time runs from the release of the mouse to the second animation frame after the page shows what was wanted. The first
time after the server and the page have started is told apart from the others: it may not take twice as long.
"""

from __future__ import annotations

import argparse
import os
import statistics
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

from benchmarks.bench_first_screen import REPOSITORY, served
from benchmarks.recordings import SHARED
from core import analyses
from core.demo import make_demo
from core.mocap.dataset import open_dataset
from core.workspace import Workspace
from tests.browser.start import start_chromium

COMMAND = "python -m benchmarks.bench_clicks"
RUNS = 20
VIEW = {"width": 1440, "height": 900}
PATIENCE = 60_000  # milliseconds
METHODS = ("motifs", "map", "search", "grammar")
GRAPH = "document.getElementById('motif-graph')?._cyreg?.cy"


@dataclass(frozen=True)
class Interaction:
    """What is clicked in turn, each with what is then to be seen (JavaScript), after ``before`` has been clicked.

    A click is a CSS selector, or "m3" for a box of the motif graph. Several are taken in turn, so that each changes
    something.
    """

    name: str
    before: str
    clicks: tuple[tuple[str, str], ...]


def _page(path: str, seen: str) -> Interaction:
    back = "#nav-boards" if path != "boards" else "#nav-library"
    return Interaction(f"open {path.capitalize()}", back, ((f"#nav-{path}", seen),))


def _seen(selector: str) -> str:
    return f"[...document.querySelectorAll({selector!r})].some((one) => one.getClientRects().length)"


def _plays(title: str) -> str:
    return f"document.querySelector('.ms-stage-title').textContent.startsWith({title!r}) && motionscape.stage.time > 0"


def interactions(clips: Sequence[str]) -> list[Interaction]:
    """The twelve, for a dataset whose first clips have these names."""
    rows = tuple((f'#clips-table [row-id="{name}"] .ag-cell[col-id="seconds"]', _plays(name)) for name in clips[:3])
    boxes = tuple((f"m{k}", _plays(f"Motif {k}:")) for k in range(3))
    return [
        _page("library", _seen("#clips-table .ag-row .clip-link")),
        _page("motifs", f"{GRAPH}?.nodes().length > 0"),
        _page("map", _seen("#map-graph .hm image")),
        _page("search", _seen("#search-body svg.search-figure")),
        _page("grammar", _seen("#grammar-string .string-clip")),
        _page("clip", _seen("#clip-graph .scatterlayer .trace path")),
        Interaction("play a clip of the Library", "#nav-library", rows),
        Interaction(
            "tab of the Library",
            "#nav-library",
            (
                ('#dataset-tabs [role="tab"]:nth-of-type(2)', _seen("#report-table .ag-row")),
                ('#dataset-tabs [role="tab"]:nth-of-type(1)', _seen("#clips-table .ag-row")),
            ),
        ),
        Interaction("play a motif of the graph", "#nav-motifs", boxes),
        Interaction("view below the graph", "#nav-motifs", _switch("motif-view", "timeline", "table")),
        Interaction("view below the map", "#nav-map", _switch("map-below", "labels", "clips")),
        Interaction(
            "light and dark",
            "#nav-search",
            tuple(
                ("#scheme-toggle", f"document.documentElement.dataset.mantineColorScheme === '{scheme}'")
                for scheme in ("dark", "light")
            ),
        ),
    ]


def _switch(name: str, *values: str) -> tuple[tuple[str, str], ...]:
    """Clicks on the choices of a segmented control with this id, each seen when its panel is shown."""
    key = name.rpartition("-")[2]
    return tuple(
        (f"#{name} input[value='{value}'] + label", _seen(f'.view-panel[data-key="{key}"][data-value="{value}"]'))
        for value in values
    )


WATCH = """(seen) => {
    delete window.taken;
    const there = new Function(`return ${seen}`);
    addEventListener('pointerup', () => {
        const begun = performance.now();
        const look = () => {
            if (!there()) return requestAnimationFrame(look);
            requestAnimationFrame(() => requestAnimationFrame(() => { window.taken = performance.now() - begun; }));
        };
        requestAnimationFrame(look);
    }, { capture: true, once: true });
}"""


def click(page: Page, what: str) -> None:
    """The mouse on the middle of what a selector finds, or of a box of the motif graph."""
    if what.startswith("m") and what[1:].isdigit():
        place = page.evaluate(
            f"""(id) => {{
                const cy = {GRAPH}, at = cy.getElementById(id).renderedPosition();
                const box = cy.container().getBoundingClientRect();
                return [box.x + at.x, box.y + at.y];
            }}""",
            what,
        )
    else:
        found = page.locator(what).first
        found.wait_for(timeout=PATIENCE)
        found.scroll_into_view_if_needed()
        box = found.bounding_box()
        place = [box["x"] + box["width"] / 2, box["y"] + box["height"] / 2]
    page.mouse.click(*place)


def milliseconds(page: Page, what: str, seen: str) -> float:
    """How long a click takes until something is seen."""
    page.evaluate(WATCH, seen)
    click(page, what)
    return page.wait_for_function("window.taken", timeout=PATIENCE).json_value()


def measure(page: Page, one: Interaction, runs: int) -> list[float]:
    """Milliseconds of each run, the first included. Pages are opened again for each; other clicks follow."""
    times = []
    for k in range(runs + 1):
        if one.name.startswith("open ") or k == 0:
            click(page, one.before)
            page.wait_for_timeout(1000)
        times.append(milliseconds(page, *one.clicks[k % len(one.clicks)]))
        page.wait_for_timeout(300)
    return times


def prepare(folder: Path, data: str) -> list[str]:
    """A workspace with the dataset and all its results; names of its clips."""
    workspace = Workspace(folder)
    dataset = make_demo(6.0) if data == "demo" else open_dataset(SHARED / "data" / data)
    workspace.add_dataset(data.replace("/", "-"), dataset)
    for method in METHODS:
        analyses.run(workspace, analyses.Request(data.replace("/", "-"), method))
    workspace.close()
    return [clip.name for clip in dataset.clips]


def percentile(times: Sequence[float], share: float) -> float:
    """The time that ``share`` of the runs do not exceed (nearest rank)."""
    return sorted(times)[max(0, round(share * len(times)) - 1)]


def main(runs: int = RUNS, data: Sequence[str] = ("demo", "cmu/bvh")) -> str:
    """Measure, print and return the Markdown section."""
    lines = []
    for name in data:
        if name != "demo" and not (SHARED / "data" / name).is_dir():
            continue
        with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
            clips = prepare(Path(folder) / "workspace", name)
            browser = start_chromium(playwright)
            with served(REPOSITORY, Path(folder) / "workspace") as address:
                page = browser.new_page(viewport=VIEW)
                page.goto(f"{address}/boards")
                page.wait_for_timeout(5000)
                for one in interactions(clips):
                    first, *later = measure(page, one, runs)
                    middle, late = statistics.median(later), percentile(later, 0.95)
                    lines.append(f"| {name} | {one.name} | {first:.0f} | {later[0]:.0f} | {middle:.0f} | {late:.0f} |")
            browser.close()
    section = "\n".join(
        [
            "## Clicks",
            "",
            "Milliseconds from the release of the mouse to the second animation frame after the page shows what was "
            f"wanted, all results there already; headless Chromium, software rendering, {VIEW['width']} x "
            f"{VIEW['height']}. First: the first time after the server and the page have started; median and 95 % of "
            f"the {runs} after it. Machine load at the end: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores.",
            "",
            "| data | interaction | first | second | median | 95 % |",
            "|---|---|---|---|---|---|",
            *lines,
            "",
            f"`{COMMAND.replace('benchmarks.bench_', 'benchmarks ')}`",
        ]
    )
    print(section)
    return section


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--runs", type=int, default=RUNS)
    parser.add_argument("--data", default="demo,cmu/bvh")
    options = parser.parse_args()
    main(options.runs, options.data.split(","))
