"""The Motifs page in a real browser."""

from __future__ import annotations

import json

from playwright.sync_api import expect

from tests.browser.app import (
    PATIENCE,
    address,
    canvas_sum,
    click_in_graph,
    demo_workspace,
    setting,
    show,
    wait_for_graph,
    wait_for_link,
    wait_for_stage,
    wait_until_moved,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]


def test_a_click_on_a_box_plays_its_motions_together(show):
    page = show("/motifs")
    wait_for_graph(page)
    click_in_graph(page, "m0")
    wait_for_stage(page, "Motif 0")
    expect(page.locator("#motif-selection h2")).to_have_text("Motif 0")
    expect(page.locator(".motion-row").nth(1)).to_be_visible()
    motions = page.locator(".motion-row").count()
    assert page.evaluate("motionscape.stage.figures") == min(motions, 24)
    assert page.evaluate("motionscape.stage.sync") == "warp"
    wait_until_moved(page, canvas_sum(page))
    wait_for_link(page, motif="0")


def test_speed_changes_and_one_motion_plays_alone(show):
    page = show("/motifs?motif=0")
    wait_for_stage(page, "Motif 0")
    page.click("#stage [data-action=faster]")
    page.wait_for_function("motionscape.stage.speed > 1")
    page.locator(".motion-row").nth(1).click()
    wait_for_stage(page, "motion 2 of")
    assert page.evaluate("motionscape.stage.figures") == 1
    expect(page.locator(".motion-row").nth(1)).to_have_attribute("aria-pressed", "true")


def test_graph_and_table_show_one_selection_and_obey_the_keyboard(show):
    page = show("/motifs")
    wait_for_graph(page)
    row = page.locator("#motif-table .ag-row[row-id='1'] .ag-cell").first
    row.scroll_into_view_if_needed()
    row.focus()
    page.keyboard.press("Enter")
    wait_for_stage(page, "Motif 1")
    page.wait_for_function("document.getElementById('motif-graph')._cyreg.cy.getElementById('m1').hasClass('chosen')")
    tap(page, 0)
    expect(page.locator("#motif-table .row-chosen")).to_have_attribute("row-id", "0")


def tap(page, number: int) -> None:
    # nothing is returned: Playwright would copy the whole graph
    page.evaluate(
        "n => { document.getElementById('motif-graph')._cyreg.cy.getElementById('m' + n).emit('tap'); }", number
    )


def test_an_arrow_plays_the_transition(show):
    page = show("/motifs")
    wait_for_graph(page)
    edge = page.evaluate(
        "document.getElementById('motif-graph')._cyreg.cy.edges()"
        ".filter(e => !e.isLoop()).max(e => e.data('count')).ele.id()"
    )
    click_in_graph(page, edge)
    source, target = edge[1:].split("-")
    wait_for_stage(page, f"From motif {source} to {target}")
    expect(page.locator("#motif-selection h2")).to_have_text(f"From {source} to {target}")


def test_downloads(show, tmp_path):
    page = show("/motifs")
    wait_for_graph(page)
    for label, name in (("JSON", "demo-motifs.json"), ("SVG", "demo-motifs.svg"), ("PNG", "demo-graph.png")):
        page.get_by_role("button", name="Download").click()
        with page.expect_download() as download:
            page.get_by_role("menuitem", name=label).click()
        assert download.value.suggested_filename == name
        download.value.save_as(tmp_path / name)
        assert (tmp_path / name).stat().st_size > 500
        expect(page.get_by_role("menuitem", name=label)).to_be_hidden()
    document = json.loads((tmp_path / "demo-motifs.json").read_text())
    assert document["format"] == "motionscape/motifs/1" and document["motifs"]


def test_settings_are_checked_before_anything_runs(show, workspace):
    page = show("/motifs")
    page.get_by_role("button", name="Settings").click()
    setting(page, "gamma").fill("99")
    before = len(workspace.jobs.list())
    page.click("#motifs-run")
    expect(page.get_by_text("Expected a number from 1 to 4")).to_be_visible()
    assert len(workspace.jobs.list()) == before


def test_no_motif_is_no_dead_end(show):
    page = show("/motifs")
    wait_for_graph(page)
    page.get_by_role("button", name="Settings").click()
    setting(page, "gamma").fill("1")
    setting(page, "min_letters").fill("100")
    setting(page, "max_letters").fill("101")
    page.click("#motifs-run")
    expect(page.get_by_text("No motif found")).to_be_visible(timeout=PATIENCE)
    expect(page.locator("#motifs-run")).to_be_enabled()
