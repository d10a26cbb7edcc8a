"""Doubts on the Clip page and in the Library, in a real browser."""

from __future__ import annotations

from dataclasses import replace

import pytest
from playwright.sync_api import expect

from core.mocap.dataset import Dataset
from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_for_link, wait_until, workspace
from tests.browser.clip.test_clip import drawn, place
from tests.webapp.generated import walk

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.fixture
def odd(workspace):
    """A dataset with a clip that jumps in its middle, and one in which all is well."""
    clip = walk("jumpy", seconds=8.0)
    roots = clip.root_positions.copy()
    roots[clip.n_frames // 2 :] += [1.5, 0, 0]
    workspace.add_dataset("odd", Dataset("odd", (replace(clip, root_positions=roots), walk("calm", seconds=3.0))))
    return clip


def test_a_doubt_is_listed_marked_and_played(show, odd):
    middle, half = odd.n_frames // 2, round(odd.fps / 2)
    first, last = middle - 1 - half, middle + 1 + half
    page = show("/clip?dataset=odd&clip=jumpy")
    drawn(page, "jumpy")
    doubts = page.locator("#clip-doubts")
    expect(doubts).to_contain_text("jump")
    doubts.locator("button.doubt", has_text=f"frames {middle - 1} to {middle}").click()
    wait_for_link(page, start=str(first), end=str(last))
    page.wait_for_function(f"motionscape.stage.frame >= {first} && motionscape.stage.frame < {last}")
    page.get_by_role("button", name="Clear").click()
    row = page.evaluate(
        """() => {
            const plot = motionscape.clip.plot();
            const band = plot.graph.data.find((trace) => trace.meta?.picks && trace.text?.includes('jump'));
            const axis = plot.full['yaxis' + band.yaxis.slice(1)];
            return (axis._offset + axis.l2p(band.meta.row) - plot.full._size.t) / plot.height;
        }"""
    )
    page.mouse.click(*place(page, middle / odd.fps, row))
    wait_for_link(page, start=str(first), end=str(last))


@pytest.mark.slow
def test_repairs_of_one_doubt_and_of_several_clips_are_undone(show, workspace, odd):
    page = show("/clip?dataset=odd&clip=jumpy")
    drawn(page, "jumpy")
    doubts = page.locator("#clip-doubts")
    before = workspace.open("odd").fingerprint
    doubts.get_by_role("button", name="Smooth").click()
    undo = page.get_by_role("button", name="Undo")
    expect(undo).to_be_visible(timeout=PATIENCE)
    expect(doubts.locator(".doubt-kind", has_text="jump")).to_have_count(0)
    undo.click()
    wait_until(page, lambda: workspace.open("odd").fingerprint == before)
    expect(doubts.locator(".doubt-kind", has_text="jump")).to_have_count(1)
    page = show("/library?dataset=odd")
    page.locator("#clips-table .ag-header-select-all").click()
    page.get_by_role("button", name="Repair", exact=True).click()
    dialog = page.get_by_role("dialog", name="Repair what was found")
    expect(dialog).to_contain_text("Jump: 1 smoothed")
    dialog.get_by_role("button", name="Repair", exact=True).click()
    wait_until(page, lambda: "jump" not in {f.kind for f in workspace.report("odd").findings_by_clip()["jumpy"]})
    page.get_by_role("button", name="Undo").click()
    wait_until(page, lambda: workspace.open("odd").fingerprint == before)


def test_the_library_counts_doubts_sorts_and_filters(show, odd):
    page = show("/library?dataset=odd")
    rows = page.locator("#clips-table .ag-center-cols-container .ag-row")
    expect(rows).to_have_count(2)
    page.locator("#clips-table .ag-header-cell[col-id=doubts] .ag-header-cell-label").click()
    page.locator("#clips-table .ag-header-cell[col-id=doubts] .ag-header-cell-label").click()
    expect(page.locator("#clips-table .ag-row[row-index='0'] [col-id=doubts]")).not_to_be_empty()
    page.locator("#clips-table .ag-header-cell[col-id=doubts] .ag-header-cell-filter-button").click()
    page.locator(".ag-filter input[type=text]").first.fill("jump")
    expect(rows).to_have_count(1)
    expect(rows).to_contain_text("jumpy")
