"""A click on Run counts at once: before the form has come, the settings of the link are those that are meant."""

from __future__ import annotations

import re
from types import SimpleNamespace

import pytest
from playwright.sync_api import expect

from tests.browser.app import address, demo_workspace, show, wait_until, workspace
from webapp import jobs

__all__ = ["address", "demo_workspace", "show", "workspace"]

# page and its link, the button, what the answer that fills the form is for, and the setting of the link
PAGES = {
    "motifs": ("/motifs?dataset=demo&kappa=23", "#motifs-run", "motifs-form.children", ("kappa", 23)),
    "map": ("/map?dataset=demo&map-grid=7x9", "#map-run", "map-form.children", ("grid", "7x9")),
    "search": ("/search?dataset=demo&search-method=parts", "#search-run", "search-form.children", ("method", "parts")),
    "evaluation": (
        "/search?dataset=demo&look=evaluate&ranking-queries=7&ranking-engines=parts",
        "#ranking-run",
        "ranking-form.children",
        ("queries", 7),
    ),
    "grammar": ("/grammar?dataset=demo&grammar-seed=3", "#grammar-run", "grammar-form.children", ("seed", 3)),
    "sweeps": (
        "/sweeps?dataset=demo&x=kappa:21,22&y=none&seeds=1",
        "#sweep-run",
        "sweep-x-name.value",
        ("axes", "kappa:21,22"),
    ),
    "sweeps, other settings": (
        "/sweeps?dataset=demo&x=kappa:21,22&y=none&seeds=1&min_letters=3",
        "#sweep-run",
        "sweep-base.children",
        ("base", '"min_letters": 3'),
    ),
}


@pytest.fixture
def requests(monkeypatch):
    """The requests of jobs that were to be started; none is."""
    started = []
    monkeypatch.setattr(jobs, "start", lambda _workspace, request: started.append(request) or SimpleNamespace(id=1))
    return started


@pytest.mark.parametrize("page_name", PAGES)
def test_run_means_the_settings_of_the_link_while_the_form_is_not_there(open_page, address, requests, page_name):
    link, button, form, (name, value) = PAGES[page_name]
    held = []
    page = open_page(address + "/_favicon.ico")
    page.route(
        re.compile("_dash-update-component"),
        lambda route: held.append(route) if form in (route.request.post_data or "") else route.continue_(),
    )
    page.goto(address + link)
    expect(page.locator(button)).to_be_visible()
    wait_until(page, lambda: held)
    page.click(button)
    wait_until(page, lambda: requests)
    shown = requests[0].parameters[name]
    assert value in shown if name == "base" else shown == value
    for route in held:
        route.continue_()
