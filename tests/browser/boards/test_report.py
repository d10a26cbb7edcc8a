"""A report opens from disk with the network off, plays, and can be explored."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, expect

from core import analyses
from core.workspace import Workspace
from tests.browser.app import demo_workspace, wait_until, workspace
from webapp.features.boards.report import make_report

__all__ = ["demo_workspace", "workspace"]


@pytest.fixture
def report(chromium: Browser, workspace: Workspace, tmp_path: Path):
    analyses.run(workspace, analyses.Request("demo", "map"))
    path = tmp_path / "report.html"
    path.write_text(make_report(workspace, "demo").html, encoding="utf-8")
    context = chromium.new_context(viewport={"width": 1440, "height": 900}, offline=True, color_scheme="light")
    page, seen = context.new_page(), []
    page.on("console", lambda message: seen.append(message.text))
    page.on("pageerror", lambda error: seen.append(str(error)))
    page.on("request", lambda request: seen.append(request.url))
    page.goto(path.as_uri())
    page.wait_for_selector("html[data-ready]")
    yield page
    context.close()
    assert [text for text in seen if text != path.as_uri()] == []


def playing(page: Page) -> list:
    return page.evaluate("[motionscape.player.figures.length, motionscape.player.clock.time]")


def test_it_opens_offline_and_everything_in_it_plays(report: Page):
    expect(report.locator(".report-part")).to_have_count(7)
    box = report.locator(".block-motif").first
    box.click()
    expect(report.locator(".report-playing")).to_have_text(re.compile(r"Motif \d+, \d+ motions"))
    expect(report.locator(".report-note")).to_be_empty()
    wait_until(report, lambda: report.evaluate("motionscape.player.clock.time > 0.1"))
    assert playing(report)[0] >= 2
    expect(report.locator(".block-motif.chosen")).to_have_count(1)
    expect(report.locator(".block-of-motifs tr.chosen")).to_have_count(1)  # the same motif in the table

    report.locator(".block-map").scroll_into_view_if_needed()
    ground = report.locator(".block-map").bounding_box()
    report.mouse.move(ground["x"] + ground["width"] / 2, ground["y"] + ground["height"] / 2)
    expect(report.locator(".block-tip .block-posture")).to_be_visible()
    report.locator(".block-of-overview tbody tr").first.click()
    expect(report.locator(".report-playing")).to_have_text("ana_01")
    wait_until(report, lambda: report.evaluate("motionscape.player.figures.length === 1"))


def test_the_graph_can_be_moved_and_zoomed_by_keyboard_and_colours_follow_the_button(report: Page):
    graph = report.locator(".block-graph")
    before = graph.get_attribute("viewBox")
    graph.focus()
    report.keyboard.press("+")
    nearer = graph.get_attribute("viewBox")
    assert float(nearer.split()[2]) < float(before.split()[2])
    report.keyboard.press("0")
    assert graph.get_attribute("viewBox") == before
    report.locator(".report-scheme").click()
    expect(report.locator("html")).to_have_attribute("data-mantine-color-scheme", "dark")
