"""What a page loads on a cold cache: how many requests, how many bytes, and no library that it does not show."""

from __future__ import annotations

import re
from collections import Counter
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Browser, Page, expect

from core import analyses
from tests.browser.app import address, demo_workspace, wait_for_graph, workspace
from tests.browser.conftest import WAIT
from tests.browser.wire import Wire

__all__ = ["address", "demo_workspace", "workspace"]

MOST = {"library": (60, 1_500_000)}  # page -> requests and bytes
MOST_OF_OTHERS = (80, 3_000_000)  # a page of many filmstrips asks for each of them
HEAVY = {"table": "/dash_ag_grid/", "graph": "/dash_cytoscape/", "chart": "/vendor/plotly"}
SHOWN = {  # page -> what of these it shows with the demo and its motif graph and map
    "library": {"table"},
    "motifs": {"table", "graph", "chart"},
    "sweeps": {"chart"},
    "map": {"chart"},
    "search": set(),
    "clip": {"chart"},
}
DRAWN = {"table": ".ag-row .ag-cell-value", "graph": "#motif-graph canvas", "chart": ".js-plotly-plot .main-svg"}


@pytest.fixture
def fresh(chromium: Browser) -> Page:
    """A tab of a context that has never loaded anything."""
    context = chromium.new_context(viewport={"width": 1280, "height": 800})
    context.set_default_timeout(WAIT)
    yield context.new_page()
    context.close()


def load(page: Page, address: str, shown: set[str]) -> Wire:
    """Opens an address and waits until everything is there."""
    wire = Wire(page)
    page.goto(address)
    expect(page.locator("#page h1, #page h2").first).to_be_visible()
    for kind in shown:
        expect(page.locator(DRAWN[kind]).first).to_be_attached()
    wire.wait_until_quiet(page)
    return wire


def heavy(wire: Wire) -> set[str]:
    return {kind for kind, part in HEAVY.items() if any(part in address for address in wire.addresses)}


@pytest.mark.parametrize("name", SHOWN)
def test_a_page_loads_what_it_shows_and_no_more(fresh, address, workspace, name):
    if name == "map":
        analyses.run(workspace, analyses.Request("demo", "map"))
    wire = load(fresh, f"{address}/{name}", SHOWN[name])
    assert heavy(wire) == SHOWN[name]
    requests, received = MOST.get(name, MOST_OF_OTHERS)
    assert len(wire.addresses) <= requests, Counter(urlsplit(a).path.split("/")[1] for a in wire.addresses)
    assert wire.received <= received
    scripts = Counter(a for a in wire.addresses if urlsplit(a).path.endswith(".js"))
    assert max(scripts.values()) == 1, "what was fetched ahead must be what is then used"
    assert not [a for a in wire.addresses if "_dash-layout" in a or "_dash-dependencies" in a]


def test_what_a_browser_has_is_not_sent_again(fresh, address):
    first = load(fresh, f"{address}/library", {"table"})
    again = load(fresh, f"{address}/library", {"table"})
    kept = [a for a in again.addresses if urlsplit(a).path.endswith((".js", ".css"))]
    assert [urlsplit(a).path.rpartition("/")[2] for a in kept] in ([], ["async-community.js"])
    assert again.received < first.received / 10


@pytest.mark.slow
def test_a_library_comes_when_its_page_is_opened_later(fresh, address):
    load(fresh, f"{address}/search", set())
    wire = Wire(fresh)
    fresh.locator("#nav-motifs").focus()  # the pointer or the focus on a link fetches ahead
    fresh.keyboard.press("Enter")
    wait_for_graph(fresh)
    expect(fresh.locator("#motif-table .ag-row").first).to_be_visible()
    assert heavy(wire) >= {"graph", "table"}
    scripts = Counter(a for a in wire.addresses if urlsplit(a).path.endswith(".js"))
    assert max(scripts.values()) == 1


def test_a_table_keeps_its_state_when_its_page_is_drawn_again(fresh, address):
    load(fresh, f"{address}/library", {"table"})
    fresh.locator("#clips-table .ag-row .ag-checkbox-input").first.click()
    expect(fresh.locator("#clips-chosen")).to_contain_text("1 clip chosen")
    fresh.set_viewport_size({"width": 1100, "height": 700})
    expect(fresh.locator("#clips-table .ag-row-selected")).to_have_count(1)


@pytest.mark.parametrize(
    ("name", "row", "selected"), [("library", "#clips-table a", "clip="), ("motifs", "svg a", "motif=")]
)
def test_before_any_script_has_run_a_page_can_be_read_and_followed(chromium, address, name, row, selected):
    context = chromium.new_context(viewport={"width": 1280, "height": 800}, java_script_enabled=False)
    page = context.new_page()
    page.goto(f"{address}/{name}")
    box = place_in_picture(page, row)
    page.mouse.click(box[0], box[1])
    page.wait_for_url(f"**{selected}**")
    context.close()


def place_in_picture(page: Page, selector: str) -> tuple[float, float]:
    """Where the first element that matches in the picture is; only the protocol sees into its shadow root."""
    protocol = page.context.new_cdp_session(page)
    root = protocol.send("DOM.getDocument", {"depth": -1, "pierce": True})["root"]
    shadow = next(found for found in nodes(root) if found.get("shadowRootType") == "closed")
    found = protocol.send("DOM.querySelector", {"nodeId": shadow["nodeId"], "selector": selector})
    corners = protocol.send("DOM.getContentQuads", {"nodeId": found["nodeId"]})["quads"][0]
    return sum(corners[::2]) / 4, sum(corners[1::2]) / 4


def nodes(node: dict):
    """A node of the protocol's document and all below it."""
    yield node
    for child in [*node.get("children", ()), *node.get("shadowRoots", ())]:
        yield from nodes(child)


@pytest.mark.parametrize("name", ["library", "motifs"])
def test_the_picture_goes_when_the_page_is_drawn(fresh, address, name):
    fresh.route(re.compile("ag_grid|cytoscape"), lambda route: (fresh.wait_for_timeout(300), route.continue_()))
    fresh.goto(f"{address}/{name}")
    picture = fresh.locator("#first-picture")
    expect(fresh.locator("#page h1")).to_be_visible()
    expect(picture).to_have_class(re.compile("passed"))
    expect(picture).to_have_count(0)
    assert fresh.evaluate("document.querySelectorAll('#page .ag-row, #page canvas').length") > 0
