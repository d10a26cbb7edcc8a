"""How many actions: numbers compared as a job whose points appear, opened by a click, stopped, there after a reload."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from tests.browser.app import address, demo_workspace, show, wait_for_link
from tests.browser.grammar.app import LINK, PATIENCE, grammar_workspace, wait_for_string, workspace

__all__ = ["address", "demo_workspace", "grammar_workspace", "show", "workspace"]


POINTS = """() => {
    const plot = document.querySelector('#tune-quality .js-plotly-plot');
    const line = plot?._fullData?.find((trace) => trace.name === 'Score F');
    return line ? [...(line.x._inputArray || line.x)] : [];
}"""


def wait_for_points(page: Page, numbers: list[int]) -> None:
    """Until the chart of the score shows these numbers of actions."""
    page.wait_for_function(f"(numbers) => ({POINTS})().join() === numbers.join()", arg=numbers, timeout=PATIENCE)


@pytest.mark.slow
def test_numbers_are_compared_and_one_is_chosen(show):
    page = show(LINK + "&show=tune")
    wait_for_string(page)
    field = page.locator("#tune-counts")
    expect(field).to_have_value("8, 12, 20, 30, 40, 60", timeout=PATIENCE)
    field.fill("5, many")
    page.keyboard.press("Tab")
    expect(page.locator(".tune-view")).to_contain_text("'many' is no number of actions")
    field.fill("14 5")
    page.keyboard.press("Tab")
    expect(page.locator("#tune-plan")).to_have_text("2 numbers, 1 of them computed")
    page.click("#tune-run")
    wait_for_points(page, [5, 14])
    wait_for_link(page, counts="14,5")
    expect(page.locator("#tune-plan")).to_have_text("2 numbers, 2 of them computed")
    expect(page.locator("#tune-status")).to_be_empty(timeout=PATIENCE)
    rows = page.locator("#tune-table .ag-center-cols-container .ag-row")
    expect(rows).to_have_count(2)
    rows.first.click()
    expect(page.locator(".action-card")).to_have_count(5, timeout=PATIENCE)
    wait_for_link(page, **{"grammar-n_terminals": "5"})
    page.reload()
    wait_for_points(page, [5, 14])


@pytest.mark.slow
def test_a_comparison_can_be_stopped_and_sliders_learn(show, workspace):
    page = show(LINK + "&show=tune&counts=14,16,18,22,24,26,28,32,34,36")
    wait_for_string(page)
    expect(page.locator("#tune-plan")).to_contain_text("10 numbers", timeout=PATIENCE)
    page.click("#tune-run")
    stop = page.locator("#tune-status .job-cancel")
    stop.click(timeout=PATIENCE)
    expect(page.locator("#tune-status")).to_contain_text("Comparing was cancelled", timeout=PATIENCE)
    assert len(page.evaluate(POINTS)) < 10
    slider = page.locator("#tune-actions [role=slider]")
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    page.click("#tune-learn")
    expect(page.locator(".action-card")).to_have_count(9, timeout=PATIENCE)
    wait_for_link(page, **{"grammar-n_terminals": "9", "show": "tune"})
