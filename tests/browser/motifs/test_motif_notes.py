"""Names, tags, notes and the timeline of the Motifs page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_for_graph, wait_for_stage, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]


def wait_for_label(page: Page, motif: int, text: str) -> None:
    """Until the motif's box in the graph is called so."""
    page.wait_for_function(
        "([id, text]) => document.getElementById('motif-graph')._cyreg.cy.getElementById(id).data('label')"
        ".startsWith(text)",
        arg=[f"m{motif}", text],
    )


def test_a_motif_is_named_found_and_shown_along_the_clips(show, address):
    page = show("/motifs?dataset=demo&motif=1&side=notes")
    wait_for_graph(page)
    page.locator("#notes-name").fill("the <b>walk</b>")
    page.locator("#notes-name").press("Enter")
    expect(page.locator("#notes-status")).to_have_text("Saved.")
    page.locator("#notes-tags").fill("gait")
    page.locator("#notes-tags").press("Enter")
    page.locator("#notes-text").fill("calm and straight")
    page.locator("#notes-title").click()
    wait_for_label(page, 1, "the <b>")

    rows = page.locator("#motif-table .ag-center-cols-container .ag-row")
    for words in ("straight", "gait", "walk</b>"):
        page.locator("#motif-search").fill(words)
        expect(rows).to_have_count(1)
    page.wait_for_function("() => document.getElementById('motif-graph')._cyreg.cy.$('.unmatched').length > 0")
    page.locator("#motif-search").fill("")
    page.wait_for_function("() => document.getElementById('motif-graph')._cyreg.cy.$('.unmatched').length === 0")

    page.locator("#motif-view").get_by_text("Timeline").click()
    blocks = page.locator(".timeline-motion")
    expect(blocks.first).to_be_visible()
    expect(page.locator(".timeline-label").first).to_be_visible()
    other = page.locator(".timeline-motion:not([data-motif='1'])").first
    wanted = json.loads(other.get_attribute("data-value"))
    other.click()
    wait_for_stage(page, f"Motif {wanted['motif']}, motion {wanted['motion'] + 1}")
    expect(other).to_have_attribute("aria-pressed", "true")
    expect(page.locator(".timeline-now[style*='block']")).to_have_count(1)
    expect(page).to_have_url(re.compile(r"view=timeline"))
    other.press("ArrowDown")
    assert page.evaluate("() => document.activeElement.classList.contains('timeline-motion')")
    lengths = page.locator(".timeline-time").evaluate_all("all => new Set(all.map(one => one.style.width)).size")
    assert lengths > 1
    page.locator("#timeline-scale").get_by_text("Fill the width").click()
    page.wait_for_function(
        "() => [...document.querySelectorAll('.timeline-time')].every(one => one.style.width === '100%')"
    )
    for label, head in (("Drawing (SVG)", b"<svg "), ("Picture (PNG)", b"\x89PNG")):
        page.get_by_role("button", name="Save the drawing: timeline").click()
        with page.expect_download() as download:
            page.get_by_role("menuitem", name=label).click()
        saved = Path(download.value.path()).read_bytes()
        assert saved.startswith(head) and len(saved) > 5000 and "demo timeline." in download.value.suggested_filename
        expect(page.get_by_role("menuitem", name=label)).to_be_hidden()
    page.locator(".timeline-clip").first.click()
    expect(page.locator(".timeline-clip").first).to_have_class(re.compile("chosen"))

    saved = page.request.get(f"{address}/api/motifs.json?dataset=demo").json()
    named = next(motif for motif in saved["motifs"] if motif["id"] == 1)
    assert (named["name"], named["tags"], named["note"]) == ("the <b>walk</b>", ["gait"], "calm and straight")

    page.reload()
    wait_for_graph(page)
    wait_for_label(page, 1, "the <b>")


@pytest.mark.slow
def test_the_coverage_report_is_made_and_its_postures_play(show):
    page = show("/motifs?dataset=demo&view=report")
    wait_for_graph(page)
    page.get_by_role("button", name="Make the report").click()
    expect(page.locator("#report-chart .js-plotly-plot")).to_be_visible(timeout=PATIENCE)
    expect(page.locator(".report-sentence")).to_contain_text("of what is distinct")
    expect(page.locator("#report-clips .ag-center-cols-container .ag-row").nth(1)).to_be_visible()
    page.locator(".copy-chip").first.click()
    wait_for_stage(page, "motion")
    page.locator(".rare-posture").first.click()
    clip = page.locator(".rare-posture .ellipsis").first.text_content().split(",")[0]
    wait_for_stage(page, clip)
    with page.expect_download() as download:
        page.get_by_role("button", name="Save the chart: keep-list").click()
        page.get_by_role("menuitem", name="Numbers (CSV)").click()
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[0].startswith("series,") and len(lines) > 3
