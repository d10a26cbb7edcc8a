"""Do people agree? Pairs rated by keys, duels, results, and nothing on the page that tells who found what."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.workspace import Workspace
from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_for_stage, wait_until, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.mark.slow
def test_pairs_are_rated_duels_are_won_and_results_are_shown(show, workspace) -> None:
    page = show("/search?dataset=demo&look=agree", viewport={"width": 1500, "height": 900})
    page.locator("[data-study='draw']").click(timeout=PATIENCE)
    page.wait_for_url(re.compile("asks="), timeout=PATIENCE)
    expect(page.locator(".study-query")).to_have_count(3, timeout=PATIENCE)
    expect(page.locator("#study-rate")).to_contain_text("Build the index of at least one engine", timeout=PATIENCE)
    page.locator("[data-study='build'][data-method='bounded-edit']").click()
    expect(page.locator(".study-question")).to_be_visible(timeout=PATIENCE)
    wait_for_stage(page, "How alike?")
    assert "bounded" not in page.locator("#study-rate").inner_html().lower()
    page.locator("#study-name").fill("Ann")
    page.locator("#study-name").press("Tab")
    expect(page.locator("#study-rate")).to_contain_text("1 of ", timeout=PATIENCE)  # Ann's own order is here
    for key in "7031":
        page.keyboard.press(key)
    expect(page.locator("#study-rate")).to_contain_text("4 answered")
    page.keyboard.press("Backspace")
    expect(page.locator(".study-value[aria-pressed='true']")).to_have_text("1completely different")
    page.keyboard.press("5")
    _wait_for_values(page, workspace, [3, 5, 7, 10])

    page.get_by_text("Which is more alike?", exact=True).click()
    expect(page.locator("#study-vote")).to_contain_text("A or B?", timeout=PATIENCE)
    page.keyboard.press("a")
    page.locator("[data-study='answer'][data-value='same']").click()
    expect(page.locator("#study-vote")).to_contain_text("2 answered")

    page.get_by_text("Results", exact=True).click()
    expect(page.locator("#study-results")).to_contain_text("4 ratings and 2 votes of 1 person", timeout=PATIENCE)
    expect(page.locator("#study-results table")).to_have_count(3)
    expect(page.locator("#study-chart .js-plotly-plot")).to_be_visible()
    page.reload()
    expect(page.locator("#study-results")).to_contain_text("4 ratings and 2 votes", timeout=PATIENCE)
    page.get_by_text("Rate pairs", exact=True).click()
    expect(page.locator("#study-rate")).to_contain_text("4 answered", timeout=PATIENCE)

    page.get_by_text("Results", exact=True).click()
    page.on("dialog", lambda dialog: dialog.accept())
    page.locator("[data-study='clear']").click()
    expect(page.locator("#study-results")).to_contain_text("No answers yet", timeout=PATIENCE)


def _wait_for_values(page: Page, workspace: Workspace, wanted: list[int]) -> None:
    """Until Ann's ratings are these: an answer reaches the workspace a moment after its key."""
    store = workspace.info("demo").id

    def values() -> list[int]:
        return sorted(rating.value for rating in workspace.ratings.list_ratings(store, person="Ann"))

    wait_until(page, lambda: values() == wanted)


def test_the_query_of_the_search_can_be_studied(show, workspace) -> None:
    analyses.run(workspace, analyses.Request("demo", "search"))
    name = workspace.open("demo").names[0]
    page = show(f"/search?dataset=demo&look=agree&query={name}:60-160", viewport={"width": 1500, "height": 900})
    page.locator("[data-study='add']").click(timeout=PATIENCE)
    page.wait_for_url(re.compile(f"asks={name}:60-160"))
    expect(page.locator("#study-rate")).to_contain_text("of 6", timeout=PATIENCE)
    page.locator("[data-study='remove']").click()
    expect(page.locator("#study-rate")).to_contain_text("Choose queries above", timeout=PATIENCE)


@pytest.mark.slow
def test_engines_are_compared_with_the_labels(show, workspace) -> None:
    page = show("/search?dataset=demo&look=evaluate", viewport={"width": 1500, "height": 900})
    expect(page.locator("#ranking-status")).to_contain_text("No evaluation yet", timeout=PATIENCE)
    chips = page.locator("#ranking-engines, .ranking-engines").first
    for name in ("Body parts (2009)", "As printed (2009)", "Chance"):
        chips.get_by_text(name, exact=True).click()
    page.wait_for_url(re.compile("ranking-engines=bounded-edit,chance(&|$)"))
    page.locator("#ranking-run").click()
    expect(page.locator("#ranking-result table tbody tr")).to_have_count(2, timeout=PATIENCE)
    expect(page.locator("#ranking-curves .js-plotly-plot")).to_be_visible()
    page.locator("#ranking-confused").click()
    page.get_by_role("option", name="Chance").click()
    page.wait_for_url(re.compile("measure=ALL:chance"))
    page.reload()
    expect(page.locator("#ranking-confused")).to_have_value("Chance", timeout=PATIENCE)
