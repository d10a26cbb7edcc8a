"""Finding by keys, the list of keys, undo, and what axe finds on every page."""

from __future__ import annotations

from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from tests.browser.app import address, demo_workspace, show, wait_for_stage, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]

AXE = Path(__file__).parents[3] / "assets" / "node_modules" / "axe-core" / "axe.min.js"
FIND = """() => axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(' | ')}`))"""


def go_to(page: Page, text: str, found: str) -> None:
    """Ctrl+K, some letters, and Enter on the first that is found."""
    page.keyboard.press("Control+k")
    page.get_by_role("searchbox", name="Go to").fill(text)
    first = page.locator(".boards-found button").first
    expect(first).to_contain_text(found)
    page.keyboard.press("Enter")
    expect(page.locator("dialog")).to_have_count(0)


def test_clips_motifs_and_settings_are_found_by_keys(show, workspace):
    page = show("/map?dataset=demo")
    clip = workspace.open("demo").clips[0].name
    go_to(page, clip, clip)
    page.wait_for_url(f"**/map?*clip={clip}*")
    wait_for_stage(page, clip)
    go_to(page, "motif 1", "Motif 1")
    page.wait_for_url("**/motifs?*motif=1*")
    go_to(page, "distinct poses (kappa)", "Distinct poses")
    expect(page.locator("#motifs-fold [aria-expanded]").first).to_have_attribute("aria-expanded", "true")


def test_a_question_mark_lists_the_keys_and_ctrl_z_takes_a_change_back(show):
    page = show("/motifs?dataset=demo")
    page.locator("#motif-graph").focus()
    page.keyboard.press("?")
    window = page.get_by_role("dialog", name="Keyboard shortcuts")
    expect(window.get_by_text("undo the last change")).to_be_visible()
    expect(window.get_by_text("play, pause")).to_be_visible()
    page.keyboard.press("Escape")
    expect(window).to_have_count(0)
    page.locator("#nav-library").click()
    page.get_by_role("button", name="More for demo").click()
    page.get_by_role("menuitem", name="Delete").click()
    expect(page.locator('[data-store="undo"]')).to_be_visible()
    expect(page.locator(".dataset-card")).to_have_count(0)
    page.keyboard.press("Control+z")
    expect(page.locator(".dataset-card")).to_have_count(1)


@pytest.mark.skipif(not AXE.is_file(), reason="axe comes with the front end's tools: make test-js")
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious_on_any_page(show, workspace, scheme):
    analyses.run(workspace, analyses.Request("demo", "map"))
    clip = workspace.open("demo").clips[0].name
    page = show("/library?dataset=demo", color_scheme=scheme)
    script = AXE.read_text(encoding="utf-8")
    found = {}
    for name, drawn in {
        "library": "#clips-table .ag-row",
        "motifs": "#motif-table .ag-row",
        "sweeps": "#page .empty-state",
        "map": "#map-graph .main-svg",
        "search": "#search-body svg",
        "grammar": "#page .empty-state",
        "groups": "#page h1",
        "clip": "#clip-graph .main-svg",
        "boards": "#page h2",
    }.items():
        page.goto(f"{base(page)}/{name}?dataset=demo&clip={clip}")
        expect(page.locator(drawn).first).to_be_attached()
        expect(page.locator("#first-picture")).to_have_count(0)
        page.evaluate(script)
        if problems := page.evaluate(FIND):
            found[name] = problems
    assert found == {}


def base(page: Page) -> str:
    """Scheme, host and port of what a page shows."""
    return page.evaluate("location.origin")
