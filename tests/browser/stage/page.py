"""A small app with nothing but the Stage, and what its tests have in common."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from dash import Dash, html
from playwright.sync_api import Page

from core.mocap.dataset import Dataset
from tests.browser.start import running
from tests.webapp.generated import walkers
from webapp.shell.assets import PARTS, VENDOR
from webapp.stage import player
from webapp.stage.motion_routes import motion_blueprint

ASSETS = Path(__file__).resolve().parents[3] / "assets" / "bundle"
NAMES = tuple(f"walk {k}/a" for k in range(12))
DATASETS: dict[str, Dataset] = {
    "walkers": walkers(NAMES, seconds=3.0),
    "~made~1": walkers(("walk",), name="~made~1", seconds=2.0, fps=120.0),
}
PIXELS = """() => {
    const c = document.getElementById('stage-canvas');
    const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    let sum = 0;
    for (let k = 0; k < data.length; k += 4) sum = (sum * 31 + data[k] + 7 * data[k + 1] + 13 * data[k + 2]) >>> 0;
    return sum;
}"""
INK = """() => {  // centre and width of what is much darker or more colourful than the ground
    const c = document.getElementById('stage-canvas');
    const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    const xs = [];
    for (let k = 0; k < data.length; k += 4) {
        const [r, g, b] = [data[k], data[k + 1], data[k + 2]];
        if (Math.max(r, g, b) - Math.min(r, g, b) > 70) xs.push((k / 4) % c.width);
    }
    xs.sort((a, b) => a - b);
    return { count: xs.length, left: xs[Math.floor(xs.length * .01)], right: xs[Math.floor(xs.length * .99)] };
}"""


@pytest.fixture(scope="session")
def stage_app() -> str:
    app = Dash(__name__, assets_folder=str(ASSETS), assets_path_ignore=[VENDOR, PARTS])
    app.layout = html.Div(player.stage(), style={"height": "90vh"})
    player.register(app)
    app.server.register_blueprint(motion_blueprint(lambda name: DATASETS[name]))
    with running(app.server) as address:
        yield address


@pytest.fixture
def page(open_page: Callable[..., Page], stage_app: str) -> Page:
    page = open_page(stage_app)
    page.wait_for_selector("#stage-canvas")
    page.wait_for_function("window.dash_clientside?.set_props && motionscape.stage.status !== 'absent'")
    return page


def request(n: int = 1, **more) -> dict:
    items = [{"clip": name, "start": 0, "end": 180, "label": name} for name in NAMES[:n]]
    return {"dataset": "walkers", "items": items, "title": "Walks", **more}


def warped(n: int = 3) -> dict:
    """All in step with the first, which takes 100 frames; the others run faster, their starts slower still."""
    asked = request(n)
    for k, item in enumerate(asked["items"]):
        item["warp"] = [99 * (i / 99) ** (1 + 0.5 * k) * (1 + 0.2 * k) for i in range(100)]
    return asked


def play(page: Page, request: dict, *, pause: bool = False) -> None:
    """Show as the app does: through the store."""
    requests = page.evaluate(
        "data => { const { requestCount } = motionscape.stage; dash_clientside.set_props('stage-request', { data });"
        " return requestCount; }",
        request,
    )
    page.wait_for_function(
        "([n, requests]) => motionscape.stage.requestCount > requests && motionscape.stage.status === 'ready'"
        " && motionscape.stage.figures === n",
        arg=[len(request["items"]), requests],
    )
    if pause:
        page.evaluate("motionscape.stage.pause(); motionscape.stage.seek(0)")
        settle(page)


def get(page: Page, what: str):
    return page.evaluate(f"motionscape.stage.{what}")


def settle(page: Page, frames: int = 3) -> None:
    page.evaluate("""async n => { for (let k = 0; k < n; k++) await new Promise(requestAnimationFrame); }""", frames)
