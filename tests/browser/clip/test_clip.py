"""The Clip page in a real browser: chart and Stage move together, ranges, links, tables, edits."""

from __future__ import annotations

import re

import pytest
from playwright.sync_api import Page, expect

from tests.browser.app import PATIENCE, address, demo_workspace, show, wait_for_link, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]


def drawn(page: Page, clip: str) -> None:
    """Until the chart of a clip is there, with values at the cursor."""
    page.wait_for_function(
        "clip => window.motionscape?.clip.plot()?.meta.clip === clip && motionscape.stage.status === 'ready'"
        " && document.querySelector('#clip-legend .clip-value')?.textContent",
        arg=clip,
        timeout=PATIENCE,
    )


def place(page: Page, seconds: float, row: float = 0.2) -> tuple[float, float]:
    """A point of the page above a moment of the chart; ``row``: share of the chart's height."""
    return tuple(
        page.evaluate(
            """([seconds, row]) => {
                document.getElementById('clip-box').scrollIntoView({ block: 'center' });
                const box = document.getElementById('clip-box').getBoundingClientRect(), plot = motionscape.clip.plot();
                return [box.x + plot.x(seconds), box.y + plot.top + row * plot.height];
            }""",
            [seconds, row],
        )
    )


def frame(page: Page) -> int:
    return page.evaluate("motionscape.stage.frame")


def drag(page: Page, start: float, end: float) -> None:
    page.mouse.move(*place(page, start))
    page.mouse.down()
    page.mouse.move(*place(page, (start + end) / 2), steps=3)
    page.mouse.move(*place(page, end), steps=3)
    page.mouse.up()


def test_chart_and_stage_move_together(show):
    page = show("/clip")
    drawn(page, "ana_01")
    wait_for_link(page, clip="ana_01")
    page.wait_for_function(  # the cursor is carried along
        """() => {
            window.places ||= new Set();
            return places.add(document.querySelector('.clip-cursor').style.transform).size >= 15;
        }"""
    )
    page.evaluate("motionscape.stage.pause()")
    page.mouse.click(*place(page, 5.0))
    page.wait_for_function("Math.abs(motionscape.stage.frame - 300) <= 4")
    page.wait_for_function("motionscape.clip.at.frame === motionscape.stage.frame")
    at = page.evaluate("new DOMMatrix(document.querySelector('.clip-cursor').style.transform).m41")
    assert at == pytest.approx(page.evaluate("motionscape.clip.plot().x(motionscape.stage.frame / 60)"), abs=1)
    # the value under the pointer is the curve's
    page.mouse.move(*place(page, 3.0))
    times, values = page.evaluate("(() => { const t = motionscape.clip.plot().graph.data[0]; return [t.x, t.y]; })()")
    nearest = min(range(len(times)), key=lambda k: abs(times[k] - 3.0))
    page.wait_for_function(
        """value => {
            const text = document.querySelector('.clip-value').textContent.replace('\u2212', '-');
            return motionscape.clip.at.hover !== null && Math.abs(parseFloat(text) - value) <= 4;
        }""",
        arg=values[nearest],
    )
    # keys
    page.locator("#clip-box").focus()
    before = frame(page)
    page.keyboard.press("ArrowRight")
    page.wait_for_function("f => motionscape.stage.frame === f", arg=before + 1)
    page.keyboard.press("Shift+ArrowLeft")
    page.wait_for_function("f => motionscape.stage.frame === f", arg=before - 9)
    page.keyboard.press("[")
    page.wait_for_url(re.compile(f"start={before - 9}&end="))
    page.keyboard.press("Escape")
    page.wait_for_url(lambda url: "start=" not in url)


def test_a_range_plays_can_be_zoomed_linked_and_downloaded(show, tmp_path):
    page = show("/clip")
    drawn(page, "ana_01")
    drag(page, 4.0, 6.0)
    page.wait_for_url(re.compile("start=2[34][0-9]&end=3[56][0-9]"))
    page.wait_for_function("motionscape.stage.duration > 1.7 && motionscape.stage.duration < 2.3")
    expect(page.locator("#clip-range")).to_contain_text("Selected")
    page.get_by_role("button", name="Zoom in on it").click()
    page.wait_for_url(re.compile("span=3.*_6"))
    page.wait_for_function(
        "(([low, high]) => 3.5 < low && low < 4 && 6 < high && high < 6.5)(motionscape.clip.plot().range)"
    )
    page.get_by_role("button", name="Table").click()
    expect(page.locator("#clip-table-what")).to_contain_text("frames 2")
    with page.expect_download() as download:
        page.get_by_role("link", name="Download CSV").click()
    download.value.save_as(tmp_path / "table.csv")
    lines = (tmp_path / "table.csv").read_text().splitlines()
    assert "left_knee flexion [deg]" in lines[0] and 100 < len(lines) < 140
    page.keyboard.press("Escape")
    for tab, text in (("Speeds", "Travel of the pelvis"), ("Feet", "Left foot")):
        page.locator("#clip-chart").get_by_text(tab, exact=True).click()
        expect(page.locator("#clip-legend")).to_contain_text(text)
    page.locator("#clip-chart").get_by_text("Path", exact=True).click()
    page.wait_for_function(
        "motionscape.clip.plot()?.meta.kind === 'path' && !document.querySelector('.clip-dot').hidden"
    )
    assert page.evaluate("motionscape.clip.plot().graph.data[1].x.length") > 100  # the selected part of the way
    page.goto(page.url)
    page.wait_for_function("window.motionscape?.clip.plot()?.meta.kind === 'path'", timeout=PATIENCE)
    expect(page.locator("#clip-range")).to_contain_text("Selected")
    page.locator("#clip-chart").get_by_text("Angles", exact=True).click()
    page.locator("#clip-kind").get_by_text("File channels").click()
    expect(page.locator("#clip-legend")).to_contain_text("Hips Zrotation")
    wait_for_link(page, angles="file")


def test_bands_gait_and_the_next_clip(show):
    page = show("/clip")
    drawn(page, "ana_01")
    bars = "motionscape.clip.plot()?.graph.data.filter((trace) => trace.type === 'bar').length"
    page.wait_for_function(f"{bars} >= 2", timeout=PATIENCE)  # labels, and motifs once their graph is known
    start, end, row = page.evaluate(
        """() => {
            const labels = motionscape.clip.plot().graph.data.find((trace) => trace.type === 'bar');
            const [start, end] = labels.meta.picks[1];
            return [start, end, labels.meta.row];
        }"""
    )
    box = page.evaluate(
        "row => { const p = motionscape.clip.plot(), a = p.full['yaxis3'];"
        " return (a._offset + a.l2p(row) - p.full._size.t) / p.height; }",
        row,
    )
    assert page.evaluate("document.getElementById('clip-box').clientHeight > motionscape.clip.plot().height")
    page.mouse.click(*place(page, (start + end) / 120, box))
    page.wait_for_url(re.compile(f"start={start}&end={end}"))
    expect(page.locator("#clip-gait")).to_contain_text("Walking")
    page.locator(".gait-select").first.click()
    page.wait_for_url(lambda url: f"start={start}&" not in url and "start=" in url)
    page.locator("#clip-gait details.gait-details summary").click()
    page.locator(".gait-event").nth(1).click()
    wanted = int(page.locator(".gait-event").nth(1).locator(".muted").inner_text().split()[1])
    page.wait_for_function("f => Math.abs(motionscape.clip.at.frame - f) < 90", arg=wanted)
    page.click("#clip-next")
    page.wait_for_function("motionscape.clip.at.shown.clip !== 'ana_01'")
    page.wait_for_function("motionscape.stage.status === 'ready' && motionscape.clip.at.frame !== null")
    expect(page.locator("#clip-previous")).to_be_enabled()
    page.goto(page.url.replace("clip=ben_01", "clip=nobody").split("&start")[0])
    expect(page.locator("#page h1")).to_be_visible(timeout=PATIENCE)


def test_edits_are_announced_and_undone(show, workspace):
    page = show("/clip?clip=ana_01&dataset=demo")
    page.watch.expected.append("404")  # what was still asked for of a clip when it was undone
    drawn(page, "ana_01")
    before = workspace.info("demo").fingerprint
    page.click("#clip-edit-menu")
    page.get_by_role("menuitem", name="selected range").click()
    expect(page.get_by_text("No range is selected")).to_be_visible()
    page.click("#clip-edit-menu")
    page.get_by_role("menuitem", name="Mirror").click()
    expect(page.locator("#clip-edit-effect")).to_contain_text("must be computed again")
    page.get_by_role("button", name="Mirror", exact=True).click()
    page.get_by_role("link", name="Show it").click(timeout=PATIENCE)
    drawn(page, "ana_01 mirrored")
    assert workspace.open("demo").names[-1] == "ana_01 mirrored"
    page.get_by_role("button", name="Undo").click()
    expect(page.get_by_text("is what it was before")).to_be_visible()
    assert workspace.info("demo").fingerprint == before
    page.goto(page.url.split("?")[0] + "?dataset=demo&clip=ana_01")
    drawn(page, "ana_01")
    page.click("#clip-edit-menu")
    page.get_by_role("menuitem", name="frame rate").click()
    page.locator("#clip-edit-fps").fill("60")
    page.get_by_role("radio", name="Into a dataset of its own").check()
    page.locator("#clip-edit-name").fill("slow")
    page.click("#clip-edit-do")
    expect(page.locator("#clip-edit-problem")).to_contain_text("60 frames a second already")
    page.locator("#clip-edit-fps").fill("30")
    page.click("#clip-edit-do")
    page.get_by_role("link", name="Show it").click(timeout=PATIENCE)
    drawn(page, "ana_01 30 fps")
    assert workspace.open("slow").clips[0].fps == 30 and workspace.info("demo").fingerprint == before
