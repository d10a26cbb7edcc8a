"""How recordings are read, chosen on import and changed afterwards, in a real browser."""

from __future__ import annotations

from pathlib import Path

from playwright.sync_api import Page, expect

from core.mocap.bvh import write_bvh
from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_until, workspace
from tests.webapp.generated import walk

__all__ = ["address", "demo_workspace", "show", "workspace"]


def choose_option(page: Page, control: str, words: str) -> None:
    """Chooses from a select."""
    page.click(f"#{control}")
    page.get_by_role("option", name=words).locator("visible=true").click()


def test_unit_and_rate_are_said_on_import_and_changed_afterwards(show, workspace, tmp_path: Path):
    write_bvh(tmp_path / "stroll.bvh", walk("stroll", seconds=1.0))
    page = show("/library")
    page.click("#upload-open")
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Choose files").click()
    chooser.value.set_files([tmp_path / "stroll.bvh"])
    expect(page.locator("#upload-unit")).not_to_be_visible()
    page.get_by_text("Reading", exact=True).click()
    choose_option(page, "upload-unit", "Decimetres")
    page.fill("#upload-fps", "24")
    page.click("#upload-import")
    expect(page.locator(".dataset-card.chosen")).to_contain_text("stroll", timeout=PATIENCE)
    clip = workspace.open("stroll").clip("stroll")
    assert (clip.skeleton.unit, clip.fps, clip.up) == (0.1, 24.0, "y")
    page.get_by_role("button", name="More for stroll").click()
    page.get_by_role("menuitem", name="Change how it was read").click()
    expect(page.locator("#reread-now")).to_contain_text("Read now as: decimetres; Y up; 24 frames per second.")
    page.click("#reread-do")
    expect(page.locator("#reread-problem")).to_contain_text("Choose what")
    card = page.locator(".dataset-card.chosen")
    before = card.locator(".dataset-doubts").inner_text()
    choose_option(page, "reread-unit", "Find out")
    page.click("#reread-do")
    undo = page.get_by_role("button", name="Undo")
    expect(undo).to_be_visible(timeout=PATIENCE)
    assert workspace.open("stroll").clip("stroll").skeleton.unit == 1.0
    expect(card.locator(".dataset-doubts")).not_to_have_text(before)
    undo.click()
    page.get_by_role("button", name="More for stroll").click()
    wait_until(page, lambda: workspace.open("stroll").clip("stroll").skeleton.unit == 0.1)
    expect(card.locator(".dataset-doubts")).to_have_text(before)  # the card is drawn anew,
    expect(page.get_by_role("menuitem", name="Rename")).to_be_visible()  # and its menu stays open
    expect(card.locator(".dataset-open")).to_have_attribute("aria-current", "true")
