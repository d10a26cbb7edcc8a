"""Blend side and compression view in a real browser: every control, in two page loads and a reload."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.mocap.bvh import read_bvh
from tests.browser.app import (
    PATIENCE,
    address,
    canvas_sum,
    click_in_chart,
    demo_workspace,
    show,
    wait_for_graph,
    wait_for_stage,
    wait_until_moved,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.fixture
def graph(workspace) -> None:
    """A graph with a motif of two bodies and one of ten motions."""
    analyses.run(workspace, analyses.Request("demo", "motifs", {"init": "random"}))


def on_stage(page: Page, pattern: str) -> None:
    """Until the first figure's data set fits."""
    page.wait_for_function(
        "p => motionscape.stage.status === 'ready' && new RegExp(p).test(motionscape.stage.frameOf(0)?.dataset ?? '')",
        arg=pattern,
    )


def choose(page: Page, selection: str) -> None:
    page.evaluate(f"dash_clientside.set_props('selection', {{ data: {selection} }})")


def act(page: Page, action: str) -> None:
    page.click(f"[data-blend={action}]")


@pytest.mark.slow
def test_motions_are_mixed_live(show, graph):
    page = show("/motifs?dataset=demo&init=random&motif=3&side=blend")
    wait_for_graph(page)
    wait_for_stage(page, "mixture of 3")
    on_stage(page, "~blend~.*~3~0:0.33,1:0.33,2:0.33$")
    wait_until_moved(page, canvas_sum(page))
    point, shares = page.locator(".blend-point"), page.locator(".blend-share")
    expect(shares).to_have_text(["33 %"] * 3)

    # the triangle by mouse: into the lower right corner, which is the third motion
    box = page.locator(".blend-triangle").scroll_into_view_if_needed() or page.locator(".blend-triangle").bounding_box()
    asked: list[str] = []
    page.on("request", lambda request: asked.append(request.url) if "/api/motion" in request.url else None)
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] * 0.6)
    page.mouse.down()
    for k in range(1, 13):
        page.mouse.move(box["x"] + box["width"] * (0.5 + 0.04 * k), box["y"] + box["height"] * (0.6 + 0.03 * k))
        page.wait_for_timeout(20)
    page.mouse.up()
    expect(shares).to_have_text(["0 %", "0 %", "100 %"])
    on_stage(page, "~3~2:1$")
    page.wait_for_url(re.compile(r"weights=0:0,1:0,2:1"))
    assert 2 <= len(asked) <= 14, "asked for while one dragged, and no more often than it moved"

    # ... and by keyboard
    point.focus()
    page.keyboard.press("Shift+ArrowUp")
    expect(shares.nth(2)).not_to_have_text("100 %")
    page.keyboard.press("1")
    expect(point).to_have_attribute("aria-valuetext", "motion 1 100 %, motion 2 0 %, motion 3 0 %")
    page.keyboard.press("0")
    expect(shares).to_have_text(["33 %"] * 3)
    page.locator(".blend-badge").nth(1).click()
    expect(shares).to_have_text(["0 %", "100 %", "0 %"])
    act(page, "random")
    on_stage(page, "~3~0:0.[0-9]+")
    page.wait_for_url(re.compile("weights=0:0.[0-9]"))
    drawn = page.url
    act(page, "sources")
    page.wait_for_function("motionscape.stage.figures >= 3 && motionscape.stage.sync === 'warp'")
    act(page, "sources")
    page.wait_for_function("motionscape.stage.figures === 1")

    act(page, "middles")
    wait_for_stage(page, "middle frames")
    assert page.evaluate("[motionscape.stage.layout, motionscape.stage.figures]") == ["pose", 3]
    with page.expect_download() as download:
        page.click("#blend-bvh")
    clip = read_bvh(Path(download.value.path()).rename(Path(download.value.path()).with_suffix(".bvh")))
    assert 60 < clip.n_frames < 260 and clip.skeleton.n_joints > 15

    # a link opens the same mixture
    page.goto(drawn)
    wait_for_stage(page, "mixture of")
    assert re.search(r"weights=([^&]+)", drawn)[1] == re.search(r"weights=([^&]+)", page.url)[1]

    act(page, "mean")
    page.locator(".blend-remove").first.click()
    expect(page.locator(".blend-row input[type=range]")).to_have_count(2)
    expect(page.locator(".blend-remove")).to_have_count(0)
    on_stage(page, "~3~1:0.5,2:0.5$")

    # many motions: eight sliders, the ninth can be had, another body cannot
    choose(page, "{ motif: 0 }")
    wait_for_stage(page, "Motif 0: mixture of 8")
    expect(page.locator("#blend-note")).to_contain_text("1 of its 10 motions")
    sliders = page.locator(".blend-row input[type=range]")
    expect(sliders).to_have_count(8)
    sliders.first.focus()
    page.keyboard.press("End")
    expect(sliders.first).to_have_attribute("aria-valuetext", "22 %")
    page.locator(".blend-remove").last.click()
    expect(sliders).to_have_count(7)
    extra = page.locator("select.blend-choice")
    added = extra.locator("option").nth(2).get_attribute("value")
    extra.select_option(added)
    expect(sliders).to_have_count(8)
    on_stage(page, rf"~0~.*\b{added}:0.13")

    # two bodies with two motions each
    choose(page, "{ motif: 1 }")
    wait_for_stage(page, "Motif 1: mixture of 2")
    first = page.evaluate("motionscape.stage.frameOf(0).dataset")
    page.locator("select.blend-choice").first.select_option("1")
    page.wait_for_function("f => (motionscape.stage.frameOf(0)?.dataset ?? f) !== f", arg=first)
    on_stage(page, r"~1~\d:0.5,\d:0.5$")
    page.wait_for_url(re.compile("weights="))

    # nothing to mix: it plays as it is
    choose(page, "{ motif: 8 }")
    expect(page.locator("#blend-hint")).to_contain_text("nothing to mix")
    wait_for_stage(page, "Motif 8: 2 motions")
    choose(page, "{ motif: 5 }")
    wait_for_stage(page, "mixture of 4")
    page.locator("#motif-side").get_by_text("Motions", exact=True).click()
    wait_for_stage(page, "Motif 5: 4 motions")


@pytest.mark.slow
def test_size_against_error(show, graph):
    page = show("/motifs?dataset=demo&init=random&view=compression")
    wait_for_graph(page)
    expect(page.locator("#compression-sentence")).to_contain_text("Choose a motif")
    page.get_by_role("button", name="Compress all").click()

    choose(page, "{ motif: 0 }")
    chart = page.locator("#compression-chart .js-plotly-plot")
    expect(page.locator("#compression-title")).to_have_text("Motif 0", timeout=PATIENCE)
    expect(page.locator("#compression-sentence")).to_contain_text("9 of its 10 motions")
    plot = "document.querySelector('#compression-chart .js-plotly-plot')"
    page.wait_for_function(
        f"names => {plot}?._fullData?.map(t => t.name).join() === names.join()",
        arg=["Own motions", "Own motions + PCA", "PCA of motions", "PCA of postures"],
    )
    axis = f"() => {plot}._fullLayout.yaxis.title.text"
    assert "cm" in page.evaluate(axis)
    page.locator("#compression-measure").get_by_text("Pose distance").click()
    page.wait_for_function(f"({axis})() === 'Mean pose distance'")

    # a click on a point plays what comes back beside the original; so do the menus
    chart.scroll_into_view_if_needed()
    point = chart.locator(".scatterlayer .trace").first.locator(".point").nth(1).bounding_box()
    click_in_chart(page, "#compression-chart", point["x"] + point["width"] / 2, point["y"] + point["height"] / 2)
    wait_for_stage(page, "Own motions, 2 motions")
    on_stage(page, "~rebuilt~.*~0~own~2~0$")
    assert page.evaluate("motionscape.stage.figures") == 2
    page.wait_for_url(re.compile("step=own:2:0"))
    page.locator("#compression-step").click()
    page.get_by_role("option", name=re.compile("^4 components: ")).first.click()
    wait_for_stage(page, "PCA of postures, 4 components")
    before = page.locator(".ms-stage-title").text_content()
    page.locator("#compression-motion").click()
    page.get_by_role("option", name=re.compile("^Motion .* cm$")).first.click()
    page.wait_for_function("t => document.querySelector('.ms-stage-title').textContent !== t", arg=before)

    with page.expect_download() as download:
        page.get_by_role("button", name="Save the chart: compression of a motif").click()
        page.get_by_role("menuitem", name="Numbers (CSV)").click()
    lines = Path(download.value.path()).read_text().splitlines()
    assert lines[0].startswith("series,") and sum(line.startswith("PCA of postures,") for line in lines) > 5

    expect(page.locator("#compression-all .js-plotly-plot")).to_be_visible(timeout=PATIENCE)
    expect(page.locator("#compression-whole")).to_contain_text("PCA clip by clip")
    choose(page, "{ motif: 8 }")
    expect(page.locator("#compression-sentence")).to_contain_text("nothing to compress")
    expect(page.locator("#compression-motif")).to_be_hidden()
