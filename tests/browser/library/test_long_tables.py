"""A dataset with more clips than a browser should hold: the server sorts, filters and sends what is seen."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from core.mocap.dataset import Dataset
from core.workspace import Workspace
from tests.browser.app import PATIENCE, address, demo_workspace, show, workspace
from tests.webapp.generated import walk
from webapp.features.library import long_lists

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.fixture
def many(workspace: Workspace, monkeypatch: pytest.MonkeyPatch) -> Workspace:
    """The workspace with a dataset of 150 clips, which count as many."""
    monkeypatch.setattr(long_lists, "LONG", 100)
    clip = walk("take", seconds=0.3)
    clips = tuple(type(clip)(**{**vars(clip), "name": f"take {k:03d}"}) for k in range(150))
    workspace.add_dataset("many", Dataset("many", clips))
    return workspace


def test_rows_come_as_they_are_scrolled_sorted_and_filtered_and_all_that_match_are_chosen(show, many):
    page = show("/library?dataset=many")
    chosen, rows = page.locator("#clips-chosen"), page.locator("#clips-table .ag-center-cols-container .ag-row")
    expect(rows.first.locator("a.clip-link")).to_have_text("take 000", timeout=PATIENCE)
    expect(chosen).to_contain_text("150 clips")
    page.evaluate("document.querySelector('#clips-table .ag-body-viewport').scrollTop = 1e6")
    expect(page.locator("a.clip-link[data-clip='take 149']")).to_be_visible()
    page.locator(".ag-header-cell[col-id=clip] .ag-header-cell-filter-button").first.click()
    page.locator(".ag-filter input[type=text]").first.fill("take 01")
    expect(chosen).to_contain_text("10 clips")
    page.keyboard.press("Escape")
    page.get_by_role("button", name="Choose all").click()
    expect(chosen).to_contain_text("10 clips chosen")
    page.get_by_role("button", name="Remove").click()
    expect(page.locator(".dataset-card.chosen")).to_contain_text("140 clips", timeout=PATIENCE)
    assert "take 011" not in many.open("many").names and "take 001" in many.open("many").names
