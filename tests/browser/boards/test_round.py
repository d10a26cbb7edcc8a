"""The whole round of two people: one saves and builds a board and invites, the other opens the link alone, comments,
filters and takes a report along that plays with the network off."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from core.mocap.properties import Properties
from core.mocap.property_files import by_pattern
from core.workspace import Workspace
from tests.browser.app import address, demo_workspace, wait_until, workspace

__all__ = ["address", "demo_workspace", "workspace"]
PASSWORD = "correct horse"
WIDE = {"width": 1600, "height": 900}


@pytest.fixture
def ann(open_page, address: str, workspace: Workspace) -> Page:
    workspace.users.add("ann", PASSWORD, "editor")
    page = open_page(f"{address}/motifs?dataset=demo", viewport=WIDE)
    page.get_by_label("Name").fill("ann")
    page.get_by_label("Password").fill(PASSWORD)
    page.get_by_role("button", name="Sign in").click()
    expect(page.locator("#page h1, #page h2").first).to_be_visible()
    return page


def invite(page: Page) -> str:
    """Saves what is shown, makes a board with a template, and gives the link with which others may change it."""
    page.get_by_role("button", name="Save view: keep it for the team").click()
    page.get_by_role("dialog").get_by_label("Title").fill("The graph")
    page.get_by_role("dialog").get_by_role("button", name="Save", exact=True).click()
    page.locator("#nav-boards").click()
    expect(page.locator(".boards-card", has_text="The graph")).to_be_visible()
    page.locator(".boards-beginning").get_by_role("button", name="Motif report").click()
    page.get_by_role("button", name="Make it").click()
    expect(page.locator(".block-motif").first).to_be_visible()
    page.get_by_role("button", name="Share board").click()
    link = page.get_by_label("To change").input_value()
    page.keyboard.press("Escape")
    return link


def say_about_the_motif(page: Page) -> None:
    """Comments on the motif that is selected, on its own page."""
    page.goto(page.url + "&motif=1")
    page.get_by_role("button", name="Comments").click()
    page.get_by_label(re.compile("Say something")).fill("This recurs")
    page.get_by_role("button", name="Comment", exact=True).click()
    expect(page.locator(".discussion .boards-comment")).to_contain_text("This recurs")
    page.get_by_role("button", name="Close the comments").click()


def test_the_whole_round(ann, open_page, workspace: Workspace, chromium: Browser, tmp_path: Path):
    found, _ = by_pattern("{performer}_{take}", workspace.open("demo").names)
    workspace.properties.put(workspace.info("demo").id, Properties().with_values(found))
    say_about_the_motif(ann)
    guest = open_page(invite(ann), viewport=WIDE)
    expect(guest.locator(".block-motif").first).to_be_visible()

    guest.locator("[data-kind=graph] .board-head").hover()
    guest.locator("[data-kind=graph]").get_by_role("button", name="Comments").click()
    guest.get_by_label(re.compile("Say something")).fill("Very clear, @ann")
    guest.get_by_role("button", name="Comment", exact=True).last.click()
    expect(ann.locator("[data-kind=graph]").get_by_role("button", name="Comments")).to_have_attribute("data-count", "1")

    guest.get_by_label("Narrow the board to a label").fill("walk")
    guest.keyboard.press("Enter")
    expect(guest.locator("[data-kind=motifs] tr.faint").first).to_be_visible()

    guest.get_by_label("Narrow the board to a group of clips").select_option("performer=ben")
    expect(ann.get_by_label("Narrow the board to a group of clips")).to_have_value("performer=ben")

    guest.locator(".boards-bar").get_by_role("button", name="More", exact=True).click()
    guest.get_by_role("menuitem", name="Report").click()
    guest.get_by_role("button", name="As HTML").click()
    save = guest.get_by_role("link", name=re.compile(r"Save \d+\.\d MB"))
    with guest.expect_download() as download:
        save.click()
    path = tmp_path / "report.html"
    download.value.save_as(path)

    reader = chromium.new_context(offline=True, viewport=WIDE).new_page()
    reader.goto(path.as_uri())
    reader.locator(".block-motif").first.click()
    wait_until(reader, lambda: reader.evaluate("motionscape.player.clock.time > 0.1"))
    assert reader.evaluate("motionscape.player.figures.length") >= 2
    reader.context.close()
