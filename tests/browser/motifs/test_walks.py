"""Walks in a real browser: by clicks, between motifs and by chance; played, mended, saved, there after a reload."""

from __future__ import annotations

import re
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.synthesis import open_ways
from core.synthesis.links import FURTHER
from tests.browser.app import (
    PATIENCE,
    address,
    click_in_graph,
    demo_workspace,
    show,
    wait_for_graph,
    wait_for_link,
    wait_for_stage,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]


def path_of(page: Page) -> list[int]:
    """The motifs on the path, as one sees them."""
    return [int(text) for text in page.locator(".walk-go b").all_text_contents()]


def wait_for_path(page: Page, path: list[int]) -> None:
    page.wait_for_function(
        "path => !document.querySelector('#walk-path.busy')"
        " && [...document.querySelectorAll('.walk-go b')].map((b) => Number(b.textContent)).join() === path.join()",
        arg=path,
        timeout=PATIENCE,
    )


def marked(page: Page, kind: str) -> list[str]:
    """Ids of the graph's elements with a class."""
    return page.evaluate(
        "kind => document.getElementById('motif-graph')._cyreg.cy.elements('.' + kind).map((one) => one.id())", kind
    )


@pytest.mark.slow
def test_a_walk_from_the_first_click_to_the_file(show, workspace) -> None:
    dataset = workspace.open("demo")
    graph = analyses.stored(workspace, analyses.Request("demo", "motifs"))
    ways = open_ways(dataset, graph)
    first, second = next((a, b) for a, b in ways.links if a != b and b not in ways.dead_ends)
    stranger = next(m for m in ways.following if (second, m) not in ways.links and m != second)
    page = show("/motifs?dataset=demo&side=walk", viewport={"width": 1700, "height": 950})
    wait_for_graph(page)
    expect(page.locator("#walk-hint")).to_contain_text("Click motifs in the graph", timeout=PATIENCE)
    page.wait_for_function(
        "ids => document.getElementById('motif-graph')._cyreg.cy.elements('.dead-end').map((one) => one.id()).join()"
        " === ids.join()",
        arg=[f"m{motif}" for motif in ways.dead_ends],
    )

    click_in_graph(page, f"m{first}")
    wait_for_path(page, [first])
    click_in_graph(page, f"m{second}")
    wait_for_path(page, [first, second])
    wait_for_link(page, walk=f"{first}-{second}", motif=None)
    wait_for_stage(page, f"Walk: {first} → {second}")
    page.wait_for_function("() => document.querySelector('.walk-chip.lit')", timeout=PATIENCE)
    assert set(marked(page, "lit")) <= {f"m{first}", f"m{second}"}
    page.wait_for_function(
        "id => document.getElementById('motif-graph')._cyreg.cy.getElementById(id).hasClass('walked')",
        arg=f"e{first}-{second}",
    )
    expect(page.locator(".walk-meter")).to_have_count(3)
    expect(page.locator(".walk-speed")).to_contain_text(re.compile("No jump|nothing had to be blended"))

    _a_gap_is_offered_help(page, ways, first, second, stranger)
    _chips_can_be_moved_and_taken_away(page)
    _between_and_by_chance(page, ways, first, second)
    _switches(page, dataset, graph)
    _files(page)

    before = path_of(page)
    page.reload()
    wait_for_graph(page)
    wait_for_path(page, before)
    wait_for_stage(page, "Walk: ")
    page.get_by_role("radio", name="Motions").locator("xpath=..").click()
    page.wait_for_function(
        "() => !document.getElementById('motif-graph')._cyreg.cy.elements('.walked, .lit, .further').length",
        timeout=PATIENCE,
    )
    click_in_graph(page, f"m{first}")
    wait_for_stage(page, f"Motif {first}")


def _a_gap_is_offered_help(page: Page, ways, first: int, second: int, stranger: int) -> None:
    page.locator("#walk-add").select_option(str(stranger))
    wait_for_path(page, [first, second, stranger])
    expect(page.locator("#walk-error")).to_contain_text(f"No edge leads from motif {second} to motif {stranger}")
    expect(page.locator(".walk-chip.gap")).to_have_count(1)
    page.locator("#walk-error").get_by_text("Bridge the gap by a blend").click()
    expect(page.locator(".walk-link")).to_have_count(1, timeout=PATIENCE)
    expect(page.locator("#walk-notes")).to_contain_text("bridged by a blend")
    wait_for_link(page, gaps="bridge")
    expect(page.locator("#walk-error")).to_be_hidden()


def _chips_can_be_moved_and_taken_away(page: Page) -> None:
    path = path_of(page)
    page.locator(".walk-go").nth(0).focus()
    page.keyboard.press("Alt+ArrowRight")
    wait_for_path(page, [path[1], path[0], path[2]])
    page.locator(".walk-chip").nth(2).drag_to(page.locator(".walk-chip").nth(0))
    wait_for_path(page, [path[2], path[1], path[0]])
    page.locator(".walk-go").nth(1).focus()
    page.keyboard.press("Delete")
    wait_for_path(page, [path[2], path[0]])
    page.locator(".walk-away").first.click()
    wait_for_path(page, [path[0]])


def _between_and_by_chance(page: Page, ways, first: int, second: int) -> None:
    page.locator("#walk-from").select_option(str(first))
    page.locator("#walk-to").select_option(str(second))
    page.locator("[data-walk='fewest']").click()
    wait_for_path(page, [first, second])
    wait_for_link(page, walk=f"fewest:{first}:{second}")
    page.locator("[data-walk='used']").click()
    page.wait_for_url(re.compile("walk=used"))
    page.locator("#walk-seconds").fill("12")
    page.locator("[data-walk='random']").click()
    page.wait_for_url(re.compile("walk=random:12:1(&|$)"))
    page.locator("[data-walk='random']").click()
    page.wait_for_function(
        "() => document.getElementById('walk-path').dataset.shown === 'random:12:2'", timeout=PATIENCE
    )
    seconds = float(re.search(r"([\d.]+) s", page.locator("#walk-length").text_content())[1])
    assert 8 < seconds < 17 and len(path_of(page)) > 3


def _switches(page: Page, dataset, graph) -> None:
    further = {
        f"w{a}-{b}" for (a, b), links in open_ways(dataset, graph, True).links.items() if links[0].kind == FURTHER
    }
    page.get_by_label("Further transition points").click(force=True)
    page.wait_for_function(
        "n => document.getElementById('motif-graph')._cyreg.cy.edges('.further').length === n",
        arg=len(further),
        timeout=PATIENCE,
    )
    assert further and set(marked(page, "further")) == further
    page.get_by_label("Keep feet where they stand").click(force=True)
    _wait_for_meters(page, "===")  # this walk is blending alone
    wait_for_link(page, feet="0")
    page.get_by_label("Keep feet where they stand").click(force=True)
    _wait_for_meters(page, "!==")
    wait_for_link(page, feet=None)


def _wait_for_meters(page: Page, how: str) -> None:
    """Until the first meter, this walk's, and the second, of blending alone, compare as ``how`` says."""
    numbers = "[...document.querySelectorAll('.walk-meter .number')].map((n) => n.textContent)"
    page.wait_for_function(f"() => {{ const [a, b] = {numbers}; return a {how} b; }}", timeout=PATIENCE)


def _files(page: Page) -> None:
    for name, beginning in (("bvh", "HIERARCHY"), ("json", '{"format": "motionscape/walk/1"')):
        address = page.locator(f"#walk-{name}").get_attribute("href")
        answer = page.request.get(f"{urlsplit(page.url).scheme}://{urlsplit(page.url).netloc}{address}")
        assert answer.ok and answer.text().startswith(beginning)


def test_links_to_walks_that_cannot_be_made_say_why(show) -> None:
    page = show("/motifs?dataset=demo&side=walk&walk=0-99999")
    wait_for_graph(page)
    expect(page.locator("#walk-error")).to_contain_text("There is no motif 99999", timeout=PATIENCE)
    page.locator(".walk-away").nth(1).click()
    expect(page.locator("#walk-error")).to_be_hidden()
    wait_for_stage(page, "Walk: 0")
