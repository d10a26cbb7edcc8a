"""The body editor in a real browser: joints are chosen in the list and in the drawing, saved, taken back, exported."""

from __future__ import annotations

import json

from playwright.sync_api import expect

from core.mocap.anatomy import find_anatomy
from core.mocap.dataset import Dataset
from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_until, workspace
from tests.webapp.generated import walk

__all__ = ["address", "demo_workspace", "show", "workspace"]


def joints(workspace, clip: str) -> dict[str, str]:
    """Part of the body -> joint, of a clip."""
    skeleton = workspace.open("walks").clip(clip).skeleton
    return {part: skeleton.names[joint] for part, joint in find_anatomy(skeleton).joints.items()}


def drag(page, start: str, end: str) -> None:
    """Drags what the first selector finds to what the second one finds in the front view."""
    page.locator(start).first.hover()
    page.mouse.down()
    box = page.locator(end).first.bounding_box()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2, steps=4)
    page.mouse.up()


def test_a_body_is_corrected_for_all_clips_of_its_rig(show, workspace, tmp_path):
    workspace.add_dataset("walks", Dataset("walks", (walk("a", 1.0), walk("b", 2.0))))
    before = joints(workspace, "a")
    page = show("/library?dataset=walks")
    page.get_by_role("button", name="More for walks").click()
    page.get_by_role("menuitem", name="Which joint is which").click()
    row = page.locator(".body-part[data-part=neck]")
    expect(row.locator("select")).to_have_value(before["neck"])
    page.locator(".body-part[data-part=left_wrist] button").click()
    lit = page.locator(".body-drawing").first.locator("circle.chosen")
    expect(lit).to_have_attribute("data-joint", before["left_wrist"])
    row.locator("select").select_option("")  # there is none
    expect(lit).to_have_count(0)
    page.locator(".body-part[data-part=left_wrist] button").click()
    page.locator(".body-drawing").first.locator(f"circle[data-joint='{before['neck']}']").click()
    expect(page.locator(".body-part[data-part=left_wrist] select")).to_have_value(before["neck"])
    page.get_by_role("button", name="Step back").click()
    expect(page.locator(".body-part[data-part=left_wrist] select")).to_have_value(before["left_wrist"])
    expect(row.locator("select")).to_have_value("")
    page.get_by_role("button", name="Start over").click()
    expect(row.locator("select")).to_have_value(before["neck"])
    drag(page, ".body-part[data-part=neck] button", f"circle[data-joint='{before['left_elbow']}']")
    expect(row.locator("select")).to_have_value(before["left_elbow"])
    expect(page.locator(".body-part[data-part=left_elbow] select")).to_have_value("")
    drag(page, f"circle[data-joint='{before['left_elbow']}']", f"circle[data-joint='{before['neck']}']")
    expect(row.locator("select")).to_have_value(before["neck"])
    page.get_by_role("button", name="Start over").click()
    page.click("#body-clip")
    page.get_by_role("option", name="b", exact=True).locator("visible=true").click()
    expect(page.locator("#body-frame-label")).to_have_text("Frame 0 of b")
    row.locator("select").select_option("")
    with page.expect_download() as download:
        page.get_by_role("button", name="Export").click()
    download.value.save_as(tmp_path / "bodies.json")
    exported = json.loads((tmp_path / "bodies.json").read_text())
    assert exported["rigs"][0]["joints"] == {**dict.fromkeys(exported["rigs"][0]["joints"]), **before, "neck": None}
    page.get_by_role("button", name="Start over").click()
    expect(row.locator("select")).to_have_value(before["neck"])
    with page.expect_file_chooser() as chooser:
        page.get_by_role("button", name="Import", exact=True).locator("visible=true").click()
    chooser.value.set_files([tmp_path / "bodies.json"])
    expect(row.locator("select")).to_have_value("")
    page.click("#body-save")
    undo = page.get_by_role("button", name="Undo")
    expect(undo).to_be_visible(timeout=PATIENCE)
    assert all("neck" not in joints(workspace, clip) for clip in "ab")
    undo.click()
    wait_until(page, lambda: joints(workspace, "a") == before)
