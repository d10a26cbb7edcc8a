"""The real app for browser tests: a workspace with a small demo, served in this process; workers as in real life."""

from __future__ import annotations

import fcntl
import os
import shutil
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from urllib.parse import parse_qs

import pytest
from playwright.sync_api import Locator, Page, expect

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from webapp.app import create_app

PATIENCE = 90_000  # milliseconds for a job on a busy machine
QUICK = {"analysis_fps": 15}


@pytest.fixture(scope="session")
def demo_workspace(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace with a minute of demo and its motif graph, copied for each test.

    It is made once a run, whichever modules and processes (pytest-xdist) ask for it.
    """
    here = tmp_path_factory.getbasetemp()
    shared = here.parent if "PYTEST_XDIST_WORKER" in os.environ else here
    path = shared / "demo-workspace"
    with (shared / "demo-workspace.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not path.exists():
            workspace = Workspace(shared / "demo-workspace.unfinished")
            workspace.add_dataset("demo", make_demo(minutes=1.0))
            analyses.run(workspace, analyses.Request("demo", "motifs"))
            workspace.close()
            workspace.path.rename(path)
    return path


@pytest.fixture
def workspace(demo_workspace: Path, tmp_path: Path) -> Workspace:
    """A fresh copy of the demo workspace."""
    shutil.copytree(demo_workspace, tmp_path / "workspace")
    return Workspace(tmp_path / "workspace")


@pytest.fixture
def address(workspace: Workspace, door) -> Iterator[str]:
    """The app on that workspace."""
    entrance, address = door
    entrance.application = create_app(workspace.path).server
    yield address
    for job in workspace.jobs.list():
        workspace.jobs.cancel(job.id)


@pytest.fixture
def show(address: str, open_page: Callable[..., Page]) -> Callable[..., Page]:
    """``show("/motifs")`` opens a page of the app and waits until its frame is there."""

    def open_one(path: str, **options) -> Page:
        page = open_page(address + path, **({"viewport": {"width": 1280, "height": 800}} | options))
        expect(page.locator("#page h1, #page h2").first).to_be_visible()
        return page

    return open_one


def setting(page: Page, name: str) -> Locator:
    """The control of a parameter; the settings must be open."""
    return page.locator(f"""input[id*='"name":"{name}"']""")


def wait_until(page: Page, condition: Callable[[], object]) -> None:
    """Until a condition on this side holds, while the page goes on."""
    deadline = time.monotonic() + PATIENCE / 1000
    while not condition():
        assert time.monotonic() < deadline, "waited in vain"
        page.wait_for_timeout(50)


def wait_for_graph(page: Page) -> None:
    """Until the motif graph is drawn."""
    page.wait_for_function(
        "() => document.getElementById('motif-graph')?._cyreg?.cy?.nodes().length > 0", timeout=PATIENCE
    )


def place_in_graph(page: Page, element: str) -> tuple[float, float]:
    """Where a node or an edge of the graph is drawn, in pixels of the page, once the graph stands still."""
    place = page.wait_for_function(
        """(id) => {
            const cy = document.getElementById('motif-graph')?._cyreg?.cy, one = cy?.getElementById(id);
            if (!one?.nonempty() || cy.animated()) return false;
            const at = one.isNode() ? one.renderedPosition() : one.renderedMidpoint();
            const box = cy.container().getBoundingClientRect(), place = [box.x + at.x, box.y + at.y];
            const known = window.graphPlace, key = id + place;
            if (known?.key !== key) window.graphPlace = { key, since: performance.now() };
            return known?.key === key && performance.now() - known.since > 100 && place;
        }""",
        arg=element,
    )
    return tuple(place.json_value())


def click_in_graph(page: Page, element: str) -> None:
    """Clicks a node or an edge of the graph with the mouse, where it is drawn."""
    page.mouse.click(*place_in_graph(page, element))


def click_in_chart(page: Page, chart: str, x: float, y: float) -> None:
    """A click where the chart (a CSS selector) has noticed the pointer, as a hand does it."""
    page.mouse.move(x - 2, y)
    page.mouse.move(x, y)
    expect(page.locator(f"{chart} .hoverlayer .hovertext").first).to_be_visible()
    page.mouse.click(x, y)


def link_of(page: Page) -> dict[str, str]:
    """What the address says, by key."""
    return {key: values[0] for key, values in parse_qs(page.evaluate("location.search.slice(1)")).items()}


def wait_for_link(page: Page, **wanted: str | None) -> None:
    """Until the address says so, key by key; None: the key is not in it. It is written a moment after the page."""
    page.wait_for_function(
        """(wanted) => {
            const link = new URLSearchParams(location.search);
            return Object.entries(wanted).every(([key, value]) => link.get(key) === value);
        }""",
        arg=wanted,
    )


def wait_for_stage(page: Page, title: str) -> None:
    """Until the Stage shows figures under a title that contains ``title``."""
    page.wait_for_function(
        "title => motionscape.stage.status === 'ready'"
        " && document.querySelector('.ms-stage-title').textContent.includes(title)",
        arg=title,
        timeout=PATIENCE,
    )


CANVAS_SUM = """() => {
    const c = document.getElementById('stage-canvas');
    const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    let sum = 0;
    for (let k = 0; k < data.length; k += 4) sum = (sum * 31 + data[k] + 7 * data[k + 1]) >>> 0;
    return sum;
}"""


def canvas_sum(page: Page) -> int:
    """A number that changes with the picture on the Stage."""
    return page.evaluate(CANVAS_SUM)


def wait_until_moved(page: Page, before: int) -> None:
    """Until the picture differs from one with the sum ``before``."""
    page.wait_for_function(f"before => ({CANVAS_SUM})() !== before", arg=before)
