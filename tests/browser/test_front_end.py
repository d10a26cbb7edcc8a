"""The front end: whenever its script arrives, Dash finds its functions, and it adds one name to the page."""

from __future__ import annotations

import time

import pytest
from playwright.sync_api import expect

from tests.browser.app import address, demo_workspace, show, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]
DELAY = 2.0  # seconds


@pytest.mark.parametrize("late", ["**/motionscape*.js*", "**/dash_renderer*.js*"], ids=["ours", "renderer"])
def test_the_app_comes_up_whichever_script_is_late(open_page, address, late):
    page = open_page("about:blank")
    page.watch.host = address.split("//")[1]
    delayed = []

    def hold(route):
        delayed.append(route.request.url)
        time.sleep(DELAY)
        route.continue_()

    page.route(late, hold)
    page.goto(address + "/motifs?motif=1")
    expect(page.locator("#motif-selection h2")).to_have_text("Motif 1")
    page.wait_for_function("motionscape.stage.status === 'ready'")
    page.wait_for_function("new URLSearchParams(location.search).get('dataset') === 'demo'")
    assert len(delayed) == 1


def test_one_name_beside_those_of_dash_is_global(show):
    page = show("/library")
    page.wait_for_function("location.search.includes('dataset=demo')")
    assert page.evaluate("Object.keys(window).filter((name) => /motionscape/i.test(name))") == ["motionscape"]
