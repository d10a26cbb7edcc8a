"""Four ways of making motion compared in a real browser: the job, the figures, motions side by side, a link to it."""

from __future__ import annotations

import csv

import pytest
from playwright.sync_api import Page, expect

from tests.browser.app import address, demo_workspace, show, wait_for_stage
from tests.browser.grammar.app import LINK, PATIENCE, grammar_workspace, wait_for_string, workspace
from tests.browser.grammar.test_grammar import base
from webapp.features.grammar import bakeoffs
from webapp.shell import settings

__all__ = ["address", "demo_workspace", "grammar_workspace", "show", "workspace"]


def bars(page: Page, title: str) -> dict[str, float]:
    """Name and height of the bars of one of the small charts, by its place (0 to 5)."""
    return page.evaluate(
        "axis => { const plot = document.querySelector('#bakeoff-chart .js-plotly-plot');"
        " const own = plot._fullData.filter((trace) => trace.type === 'bar' && trace.yaxis === axis);"
        " return Object.fromEntries(own.map((trace) => [trace.name, (trace.y._inputArray || trace.y)[0]])); }",
        title,
    )


@pytest.mark.slow
def test_four_ways_are_compared_and_play_side_by_side(show, workspace):
    page = show(LINK + "&show=compare")
    wait_for_string(page)
    expect(page.locator("#bakeoff-place")).to_contain_text("Not compared yet", timeout=PATIENCE)
    page.get_by_role("button", name="Compare four ways").click()
    expect(page.locator("#bakeoff-table .ag-row")).not_to_have_count(0, timeout=2 * PATIENCE)
    view = settings.view_of("grammar", {"n_terminals": 14, "analysis_fps": 15.0})
    found, key = bakeoffs.find(workspace, "demo", view)
    accepted = {c.name: 100 * c.accepted for c in found.contenders}
    page.wait_for_function(  # the chart is drawn
        "document.querySelector('#bakeoff-chart .js-plotly-plot')?._fullData?.some((trace) => trace.type === 'bar')"
    )
    assert bars(page, "y") == {
        "These rules": pytest.approx(accepted["grammar"]),
        "Only what follows next": pytest.approx(accepted["state machine"]),
        "Only what is repeated": pytest.approx(accepted["sequitur"]),
        "Walk on the motif graph": pytest.approx(accepted["motif walk"]),
    }
    page.get_by_role("button", name="All side by side").click()
    wait_for_stage(page, f"{len(found.clips)} ways side by side")
    assert page.evaluate("motionscape.stage.figures") == len(found.clips)
    page.locator("[data-store=bakeoff-play]", has_text="These rules").click()
    wait_for_stage(page, "These rules")
    document = page.request.get(f"{base(page)}/api/bakeoff/{key}.json").json()
    assert [entry["name"] for entry in document["contenders"]] == [c.name for c in found.contenders]
    with page.expect_download() as saved:
        page.get_by_role("button", name="Save the table as CSV: four ways").click()
    assert len(list(csv.reader(saved.value.path().open(encoding="utf-8")))) == 1 + len(found.contenders)
    page.reload()
    expect(page.locator("#bakeoff-table .ag-row").first).to_be_visible(timeout=PATIENCE)
    assert page.evaluate("motionscape.stage.figures") == 0
