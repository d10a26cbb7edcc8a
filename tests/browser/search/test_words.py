"""Motion found by words: typed on the Search page, played, and asked for with Ctrl+K."""

from __future__ import annotations

from playwright.sync_api import expect

from tests.browser.app import PATIENCE, address, demo_workspace, link_of, show, wait_for_link, wait_for_stage, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]


def test_words_find_stretches_that_play(show):
    page = show("/search?dataset=demo&look=words")
    page.fill("#search-words", "walking")
    expect(page.locator(".words-hit").first).to_be_visible(timeout=PATIENCE)
    wait_for_link(page, words="walking")
    page.locator(".words-play").first.click()
    wait_for_link(page, words="walking")
    wait_for_stage(page, page.locator(".words-name b").first.inner_text())
    assert link_of(page)["clip"]
    page.keyboard.press("Control+k")
    page.fill("dialog[open] input", "stand still")
    page.get_by_role("button", name="Find “stand still” in the motion").click()
    wait_for_link(page, words="stand still")
    expect(page.locator(".words-seen").first).to_contain_text("stand still", timeout=PATIENCE)
