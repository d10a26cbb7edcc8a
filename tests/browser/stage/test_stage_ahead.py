"""A click finds its motions already there: they are fetched while the pointer rests on a motif."""

from __future__ import annotations

import pytest

from tests.browser.app import (
    address,
    click_in_graph,
    demo_workspace,
    show,
    wait_for_graph,
    wait_for_stage,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]

PLACE = """id => {
    const cy = document.getElementById('motif-graph')._cyreg.cy, at = cy.getElementById(id).renderedPosition();
    const box = cy.container().getBoundingClientRect();
    return [box.x + at.x, box.y + at.y];
}"""


@pytest.mark.slow
def test_motions_come_before_the_click_and_only_once(show):
    page = show("/motifs")
    wait_for_graph(page)
    page.wait_for_function("document.getElementById('motif-graph')._cyreg.cy.container().tabIndex === 0")
    asked = []
    page.on("request", lambda request: asked.append(request.url))
    place = page.evaluate(PLACE, "m0")
    with page.expect_response("**/api/motions?**"):
        page.mouse.move(*place, steps=3)
    assert any("/api/stage/motifs?" in url and "motif=0" in url for url in asked)
    assert page.evaluate("motionscape.stage.status") == "empty", "looking is not choosing"
    page.mouse.click(*place)
    wait_for_stage(page, "Motif 0")
    page.wait_for_function("location.search.includes('motif=0')")
    page.locator("#motif-selection h2", has_text="Motif 0").wait_for()
    assert len([url for url in asked if "/api/motions" in url]) == 1
    assert page.evaluate("motionscape.stage.requestCount") >= 1
    # the app's own answer says the same: it does not start again
    time = page.evaluate("motionscape.stage.pause(), motionscape.stage.seek(.2), motionscape.stage.time")
    page.wait_for_load_state("networkidle")
    assert page.evaluate("motionscape.stage.time") == time

    page.mouse.move(5, 5)
    for number in (1, 2):
        click_in_graph(page, f"m{number}")
    wait_for_stage(page, "Motif 2")
    page.wait_for_load_state("networkidle")
    wait_for_stage(page, "Motif 2")
    rows = page.locator(".motion-row")
    with page.expect_response("**/api/stage/motifs?**motion=1**"):
        rows.nth(1).hover()
    rows.nth(1).click()
    wait_for_stage(page, "motion 2 of")
