"""The Sweeps page in a browser: form, progress, cancel, charts, suggestion, and from any point to its result."""

from __future__ import annotations

import re
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from tests.browser.app import (
    PATIENCE,
    address,
    click_in_chart,
    demo_workspace,
    show,
    wait_for_graph,
    wait_for_link,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]

SWEEP = "x=kappa:20,30,40&y=rho:0.2,1&seeds=2&analysis_fps=15"


def points(page: Page, graph: str) -> list[dict]:
    """Clickable dots of a line chart: where they are drawn and which result they stand for."""
    return page.evaluate(
        """(id) => {
            const plot = document.querySelector(`#${id} .js-plotly-plot`), found = [];
            plot.scrollIntoView({ block: "center" });
            const box = plot.getBoundingClientRect(), full = plot._fullLayout;
            plot._fullData.forEach((trace) => {
                if (!trace.customdata) return;
                const ya = full[trace.yaxis === "y2" ? "yaxis2" : "yaxis"], xa = full.xaxis;
                trace.customdata.forEach((address, i) => found.push({
                    address,
                    x: box.x + xa._offset + xa.d2p(trace.x[i]),
                    y: box.y + ya._offset + ya.d2p(trace.y[i]),
                }));
            });
            return found;
        }""",
        graph,
    )


def wait_for_points(page: Page, graph: str, n: int) -> None:
    """Until a line chart shows n dots (two figures a point)."""
    page.wait_for_function(
        """([id, n]) => {
            const plot = document.querySelector(`#${id} .js-plotly-plot`);
            const traces = ((plot || {})._fullData || []).filter((trace) => trace.customdata);
            return traces.reduce((sum, trace) => sum + trace.customdata.length, 0) === n;
        }""",
        arg=[graph, n],
        timeout=PATIENCE,
    )


def idle(page: Page) -> None:
    """Until no job runs."""
    expect(page.locator("#job-list .job")).to_have_count(0, timeout=PATIENCE)


def test_from_the_form_to_the_result(show, workspace):
    page = show("/sweeps?dataset=demo&analysis_fps=15")
    expect(page.locator("#sweep-status")).to_contain_text("No sweep yet")
    expect(page.locator("#sweep-base-summary")).to_have_text("analysis fps 15")

    # errors where they are made
    page.fill("#sweep-x-values", "20, 30, many")
    page.keyboard.press("Tab")
    expect(page.locator(".sweep-form")).to_contain_text("'many' cannot be used; expected auto or a whole number")
    page.fill("#sweep-x-values", "20, 30, 40")
    page.fill("#sweep-y-values", "0.2, 1")
    page.fill("#sweep-seeds", "2")
    page.keyboard.press("Tab")
    expect(page.locator("#sweep-plan")).to_have_text(re.compile(r"^3 × 2 × 2 seeds = 12 points; .*, up to .* GB\.$"))

    # another axis brings values of its own, and goes again
    page.click("#sweep-y-name")
    page.click("[role=option]:has-text('Speed tolerance'):visible")
    expect(page.locator("#sweep-y-values")).to_have_value("1.2, 1.35, 1.5, 1.75, 2")
    page.click("#sweep-y-name")
    page.click("[role=option]:has-text('Nothing else'):visible")
    expect(page.locator("#sweep-y-values")).to_be_hidden()
    expect(page.locator("#sweep-plan")).to_have_text(re.compile(r"^3 × 2 seeds = 6 points; .*, up to .* GB\.$"))
    page.click("#sweep-run")
    wait_for_points(page, "sweep-lines-x", 12)
    idle(page)
    wait_for_link(page, x="kappa:20,30,40", y="none")
    expect(page.locator("#sweep-heat")).to_be_hidden()
    expect(page.locator("#sweep-plan")).to_contain_text("all of them there already")

    # a point opens its result, and Back the sweep
    point = points(page, "sweep-lines-x")[-1]
    click_in_chart(page, "#sweep-lines-x", point["x"], point["y"])
    wait_for_graph(page)
    wait_for_link(page, kappa="40")
    page.wait_for_url(lambda url: url.endswith(point["address"]))
    expect(page.locator("#motifs-status")).to_be_empty()
    page.go_back()
    wait_for_points(page, "sweep-lines-x", 12)

    # both copies of the sweep; the table by keyboard
    page.click("#sweep-menu button")
    command = page.get_by_role("menuitem", name="Copy as command").get_attribute("data-copy")
    assert "--kappa 20,30,40" in command and "--analysis-fps 15" in command and "--seeds 2" in command
    page.keyboard.press("Escape")
    page.locator("#sweep-table .ag-row[row-id='1'] .ag-cell[col-id='coverage']").click()
    page.keyboard.press("Enter")
    wait_for_graph(page)
    wait_for_link(page, kappa="20", seed="1")


@pytest.mark.slow
def test_cancel_keeps_points_and_a_link_shows_them(show, workspace):
    analyses.run(
        workspace,
        analyses.Request("demo", "sweep", {"axes": "kappa:20,30", "base": '{"analysis_fps": 15, "init": "random"}'}),
    )
    page = show(f"/sweeps?dataset=demo&{SWEEP}", color_scheme="dark", viewport={"width": 1920, "height": 1080})
    expect(page.locator(".sweep-note")).to_contain_text("2 of 12 points are there")
    wait_for_points(page, "sweep-lines-x", 4)

    # cancelled, it keeps what was there; run again, it does what is missing
    page.fill("#sweep-x-values", ", ".join(map(str, range(20, 60, 2))))
    page.fill("#sweep-seeds", "20")
    page.keyboard.press("Tab")
    expect(page.locator("#sweep-plan")).to_contain_text("= 800 points")
    page.click("#sweep-run")
    expect(page.locator("#sweep-status [data-job]")).to_contain_text(
        re.compile(r"[1-9]\d* of 800 points"), timeout=PATIENCE
    )
    page.click("#sweep-status .job-cancel")
    idle(page)
    expect(page.locator(".sweep-note")).to_contain_text("The sweep was cancelled.")
    page.goto(page.url.replace(urlsplit(page.url).query, f"dataset=demo&{SWEEP}"))
    expect(page.locator(".sweep-note")).to_contain_text("of 12 points are there")
    page.click("#sweep-run")
    wait_for_points(page, "sweep-lines-x", 12)
    idle(page)
    expect(page.locator("#sweep-status")).to_be_empty()

    # the charts follow what is chosen
    page.click("#sweep-pair-x")
    page.click("[role=option]:has-text('Agreement with labels'):visible")
    expect(page.locator("#sweep-lines-x .ytitle")).to_contain_text("Purity")
    page.click("#sweep-at-x")
    page.click("[role=option]:has-text('0.2'):visible")
    page.wait_for_function(
        """() => document.querySelector("#sweep-lines-x .js-plotly-plot")._fullData
            .some((trace) => (trace.customdata || []).some((address) => address.includes("rho=0.2")))"""
    )
    page.click("#sweep-measure")
    page.click("[role=option]:has-text('Frames per motion'):visible")
    expect(page.locator("#sweep-measure-help")).to_have_text("Mean length of a motion.")

    # from the map, and from the suggestion, to the result
    page.locator("#sweep-heat").scroll_into_view_if_needed()
    box = page.locator("#sweep-heat .nsewdrag").first.bounding_box()
    click_in_chart(page, "#sweep-heat", box["x"] + box["width"] * 0.5, box["y"] + box["height"] * 0.25)
    wait_for_graph(page)
    wait_for_link(page, kappa="30", rho=None)  # rho 1 is the default
    page.go_back()
    page.click("#sweep-suggestion a:has-text('Open it')")
    wait_for_graph(page)
    expect(page.locator("#motifs-status")).to_be_empty()


def test_links_that_mean_no_sweep_say_why(show):
    page = show("/sweeps?dataset=demo&x=kappa:1,2&y=kappa:3")
    expect(page.locator("#sweep-status")).to_contain_text("This sweep cannot be run")
    expect(page.locator(".sweep-form")).to_contain_text("Choose another setting than the first.")
    page.click("#sweep-run")
    expect(page.locator(".mantine-Notification-root")).to_contain_text("Cannot run the sweep")


def test_a_point_opens_its_own_result_whatever_its_numbers(show, workspace):
    axes = "rho:0.30000000000000004,1.2345678;kappa:20"
    sweep = {"axes": axes, "seeds": 1, "base": '{"analysis_fps": 29.97}'}
    analyses.run(workspace, analyses.Request("demo", "sweep", sweep))
    x, y = axes.split(";")
    page = show(f"/sweeps?dataset=demo&x={x}&y={y}&seeds=1&analysis_fps=29.97")
    wait_for_points(page, "sweep-lines-x", 4)
    point = points(page, "sweep-lines-x")[-1]
    assert point["address"] == "/motifs?dataset=demo&kappa=20&rho=1.2345678&analysis_fps=29.97"
    click_in_chart(page, "#sweep-lines-x", point["x"], point["y"])
    wait_for_graph(page)
    expect(page.locator("#motifs-status")).to_be_empty()
    expect(page.locator("#motifs-summary")).to_have_text("kappa 20, rho 1.2345678, analysis fps 29.97")
    page.wait_for_url(lambda url: url.endswith(point["address"]))
