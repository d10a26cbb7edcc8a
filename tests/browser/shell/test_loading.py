"""What a page loads on a cold cache: how many requests, how many bytes, and no library that it does not show."""

from __future__ import annotations

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
