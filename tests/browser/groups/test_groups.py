"""Groups on the demo with a planted difference: properties from names, the answer in words, examples on the Stage."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
from playwright.sync_api import expect

from core.demo.planted import planted_groups, with_wider_arms
from core.workspace import Workspace
from tests.browser.app import PATIENCE, address, show

__all__ = ["address", "show"]


@pytest.fixture
def workspace(tmp_path) -> Workspace:
    """Six people a group, of whom B hold their arms so much wider that few clips show it."""
    dataset, properties = planted_groups("nothing", 6, pieces=8)
    of_b = properties.groups("group")["B"]
    wider = (with_wider_arms(clip, 40) if clip.name in of_b else clip for clip in dataset.clips)
    dataset = replace(dataset, clips=tuple(wider))
    workspace = Workspace(tmp_path / "workspace")
    workspace.add_dataset("people", dataset)
    workspace.properties.put(workspace.info("people").id, properties)
    return workspace


def test_groups_are_compared_and_examples_play(show):
    page = show("/groups?dataset=people")
    page.get_by_label("Groups by").select_option("group")
    page.get_by_role("button", name="Compare", exact=True).click()
    expect(page.locator(".groups-words")).to_be_visible(timeout=PATIENCE)
    expect(page).to_have_url(re.compile("by=group"))
    expect(page.locator(".groups-who")).to_contain_text("A: 6 subjects")
    expect(page.locator(".groups-words")).to_contain_text(re.compile(r"B holds the (left|right) arm .* wider"))
    page.locator(".groups-sentence").first.click()
    expect(page.locator(".ms-stage-title")).to_have_text(re.compile("arm away from the trunk"))
    expect(page.locator(".groups-graph, .groups-matrix")).to_have_count(2)
    expect(page.locator(".groups-figure").first).to_be_visible()
    with page.expect_download() as download:
        page.get_by_role("link", name="Table (CSV)").click()
    assert download.value.path().read_text().startswith("kind,id,name")

    page.get_by_label("Groups by").select_option("subject")
    expect(page.get_by_role("alert")).to_contain_text("Groups need 2 clips at least")
