"""Other ways to ask the map: a posture shaped by hand, a drawn path, a pace; pictures, other clips."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from playwright.sync_api import expect

from core import analyses
from core.demo import make_demo
from core.motion_map.key_poses import Pace
from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_for_link, workspace
from tests.browser.motion_map.page import SMALL, hits_of, mapped, open_map, place_of, two_keys
from webapp.shell import settings

__all__ = ["address", "demo_workspace", "mapped", "show", "workspace"]


def bone_lengths(posture: list[float], parents: list[int]) -> np.ndarray:
    joints = np.array(posture).reshape(-1, 3)
    return np.array(
        [np.linalg.norm(joint - (joints[p] if p >= 0 else 0)) for joint, p in zip(joints, parents, strict=True)]
    )


def test_a_posture_is_shaped_by_dragging_and_bones_keep_their_lengths(mapped, show):
    (a, b), (c, d) = two_keys(mapped)
    page = open_map(show, f"&keys={a}-{b},{c}-{d}")
    page.locator(".map-key-card").nth(1).get_by_role("button", name="Change the posture").click()
    hand = mapped.roles.index("left_wrist")
    handle = page.locator(f"#map-editor [data-view=front] .map-joint[data-joint='{hand}']")
    handle.scroll_into_view_if_needed()  # and stands still
    box = handle.bounding_box()
    before = page.evaluate("Array.from(motionscape.map.edited().posture)")
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + 15, box["y"] - 90, steps=6)
    page.mouse.up()
    after = page.evaluate("Array.from(motionscape.map.edited().posture)")
    np.testing.assert_allclose(bone_lengths(after, mapped.parents), mapped.lengths, atol=1e-4)
    assert after[3 * hand + 1] > before[3 * hand + 1] + 0.1, "the hand is higher"
    moved = np.abs(np.array(after) - before).reshape(-1, 3).max(axis=1) > 1e-6
    assert {mapped.roles[k] for k in np.flatnonzero(moved)} <= {"left_elbow", "left_wrist"}
    handle.focus()
    page.keyboard.press("ArrowDown")
    assert page.evaluate("motionscape.map.edited().posture")[3 * hand + 1] < after[3 * hand + 1]
    node = page.evaluate("motionscape.map.edited().node")
    wanted, _ = mapped.nearest(np.array(page.evaluate("Array.from(motionscape.map.edited().posture)")))
    assert divmod(node, mapped.grid[1]) == wanted
    page.locator("[data-editor=use]").click()
    page.wait_for_function("text => location.search.includes(text)", arg=f"keys={a}-{b},{wanted[0]}-{wanted[1]}")


@pytest.mark.slow
def test_a_drawn_path_finds_the_motions_that_go_like_it(mapped, show):
    page = open_map(show, "&click=draw")
    nodes = mapped.nodes_of(mapped.clips[0])[10:40]
    page.mouse.move(*place_of(page, *map(float, nodes[0])))
    page.mouse.down()
    for x, y in nodes[1:]:
        page.mouse.move(*place_of(page, float(x), float(y)), steps=2)
    page.mouse.up()
    page.wait_for_function("() => motionscape.map.state.hits.length > 0 && location.search.includes('drawn=')")
    assert mapped.clips[0] in {clip for clip, _, _ in hits_of(page)[:5]}
    expect(page.locator(".map-hit").first).to_be_visible()
    found = hits_of(page)
    again = open_map(show, "&" + page.url.split("?")[1].split("&", 1)[1])
    again.wait_for_function("() => motionscape.map.state.hits.length > 0")
    assert hits_of(again) == found
    expect(again.locator("polyline.map-drawn")).to_have_count(1)
    again.watch.expected.append("ERR_FAILED")
    again.route("**/drawn?*", lambda route: route.abort())
    again.reload()
    expect(again.locator(".mantine-Notification-root")).to_contain_text("The server does not answer", timeout=PATIENCE)


def test_equal_postures_are_told_apart_by_pace(mapped, show):
    speed = mapped.runs.speed
    node = max(
        range(132),
        key=lambda k: min((speed[mapped.runs.node == k] < 0.25).sum(), (speed[mapped.runs.node == k] > 0.25).sum()),
    )
    key = divmod(node, mapped.grid[1])
    page = open_map(show, f"&keys={key[0]}-{key[1]}&pace=0-0.25")
    wanted = mapped.search([key], 0.0, Pace(0, 0.25))
    assert 0 < len(wanted) < len(mapped.search([key]))
    page.wait_for_function("n => motionscape.map.state.hits.length === n", arg=len(wanted))
    assert sorted(hits_of(page)) == sorted(tuple(segment) for segment, _ in wanted)
    page.click("#map-way")
    page.get_by_role("option", name="Backward").click()
    page.wait_for_function("() => location.search.includes('way=backward')")
    page.wait_for_function(
        "n => motionscape.map.state.hits.length === n", arg=len(mapped.search([key], 0.0, Pace(0, 0.25, "backward")))
    )


def test_pictures_hold_what_was_chosen(mapped, show, tmp_path):
    (a, b), (c, d) = two_keys(mapped)
    page = open_map(show, f"&keys={a}-{b},{c}-{d}&within=0.40")
    made = {}
    for kind in ("SVG", "PNG"):
        page.get_by_role("button", name="Save the map as a picture").click()
        with page.expect_download() as download:
            page.get_by_role("menuitem", name=kind).click()
        made[kind] = Path(tmp_path / f"map.{kind.lower()}")
        download.value.save_as(made[kind])
    root = ElementTree.parse(made["SVG"]).getroot()
    classes = {node.get("class") for node in root.iter()}
    assert "map-key" in classes and "map-reach" in classes
    assert any(
        (node.get("{http://www.w3.org/1999/xlink}href") or node.get("href") or "").startswith("data:image/svg")
        for node in root.iter()
    )
    from PIL import Image

    picture = np.asarray(Image.open(made["PNG"]).convert("RGB"))
    assert picture.shape[0] > 500 and len(np.unique(picture.reshape(-1, 3), axis=0)) > 50
    page.get_by_role("button", name="Download").click()
    with page.expect_download() as download:
        page.get_by_role("menuitem", name="Node of every frame (CSV)").click()
    assert download.value.suggested_filename == "demo-map.csv"


@pytest.mark.slow
def test_other_clips_are_laid_on_a_map_without_learning(mapped, show, workspace):
    workspace.add_dataset("more", make_demo(minutes=0.5, seed=3))
    page = show("/map?dataset=more")
    page.get_by_role("button", name="Lay on another map").click()
    page.get_by_role("menuitem", name="demo").click()
    page.wait_for_function("() => motionscape.map.state.map?.clips.length > 0", timeout=PATIENCE)
    key = settings.key_of(workspace, "map", "demo", SMALL)
    wait_for_link(page, **{"map-model": key})
    expect(page.locator("#map-more")).to_contain_text("has not learned them")
    laid = analyses.stored(workspace, settings.request_of("map", "more", {"map-model": key}))
    np.testing.assert_array_equal(laid.weights, mapped.weights)
    page.locator("#map-below label", has_text="Clips").click()
    expect(page.locator("#map-clips .ag-row")).to_have_count(len(laid.clips))
