"""The Search page in a real browser: a query by hand, parts weighed and combined, hits explained, played and linked."""

from __future__ import annotations

import re
from pathlib import Path
from urllib.parse import urlsplit

import pytest
from playwright.sync_api import Page, expect

from core import analyses
from core.mocap.bvh import write_bvh
from core.workspace import Workspace
from tests.browser.app import (
    PATIENCE,
    address,
    demo_workspace,
    link_of,
    show,
    wait_for_graph,
    wait_for_link,
    wait_for_stage,
    wait_until,
    workspace,
)

__all__ = ["address", "demo_workspace", "show", "workspace"]
WIDE = {"width": 1700, "height": 950}


@pytest.fixture
def indexed(workspace: Workspace) -> Workspace:
    """The demo with its search index."""
    analyses.run(workspace, analyses.Request("demo", "search"))
    return workspace


def stretch(workspace: Workspace) -> str:
    """A labelled stretch of the demo, as a link has it."""
    label = next(label for label in workspace.open("demo").labels if label.action not in ("idle", "walk"))
    return f"{label.clip}:{label.start}-{label.end}"


def wait_for_hits(page: Page, query: str) -> None:
    """Until the hits shown are those of this query."""
    page.wait_for_function(
        "query => motionscape.search.now.found?.hits && motionscape.search.now.found.inputs.query === query",
        arg=query,
        timeout=PATIENCE,
    )


def open_search(show, query: str, **options) -> Page:
    page = show(f"/search?dataset=demo&query={query}", viewport=WIDE, **options)
    wait_for_hits(page, query)
    return page


def hits(page: Page) -> list[str]:
    return page.evaluate("[...document.querySelectorAll('.search-hit')].map((one) => one.dataset.hit)")


def test_from_nothing_to_a_hit_and_its_link(show, workspace) -> None:
    page = show("/search?dataset=demo", viewport=WIDE)
    expect(page.locator("#search-status")).to_contain_text("No search index yet", timeout=PATIENCE)
    page.locator("#search-run").click()
    name = workspace.open("demo").names[0]
    page.get_by_label("Clip that is looked for").fill(name)
    page.get_by_label("Clip that is looked for").press("Enter")
    expect(page.locator(".search-span")).to_contain_text("whole clip", timeout=PATIENCE)
    wait_for_stage(page, f"Query: {name}")
    wait_for_hits(page, link_of(page)["query"])
    expect(page.locator("#search-level")).to_have_value("clip")

    _a_range_is_dragged(page, name)
    query = link_of(page)["query"]
    expect(page.locator("#search-level")).to_have_value("interval")
    first, second = hits(page)[:2]
    expect(page.locator(".search-hit.explained").first).to_be_visible(timeout=PATIENCE)
    expect(page.locator(".search-why").first).to_have_attribute("aria-label", re.compile("Most alike: "))
    page.locator(".search-open").nth(1).click()
    wait_for_stage(page, "Query and")
    wait_for_link(page, hit=second)
    assert page.evaluate("motionscape.stage.figures") == 2
    expect(page.locator(".search-hit.chosen .search-why-names span")).to_have_count(10)
    expect(page.locator(".ms-warp")).to_be_visible()
    page.evaluate("motionscape.stage.pause(); motionscape.stage.seek(motionscape.stage.duration / 2)")
    expect(page.locator(".search-hit.chosen .search-why-cursor")).to_be_visible()

    page.reload()
    wait_for_hits(page, query)
    wait_for_stage(page, "Query and")
    expect(page.locator(f".search-hit.chosen[data-hit='{second}']")).to_have_count(1)
    page.keyboard.press("Escape")
    page.locator(".search-open").nth(1).focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Enter")
    page.wait_for_url(re.compile(re.escape(f"hit={first}")))

    page.locator(".search-hit [data-similar]").first.click()
    page.wait_for_function("query => motionscape.search.now.view.query === query", arg=first, timeout=PATIENCE)
    wait_for_hits(page, first)
    page.locator("[data-search='back']").click()
    wait_for_hits(page, query)


def _a_range_is_dragged(page: Page, name: str) -> None:
    box = page.locator(".search-track").bounding_box()
    page.mouse.move(box["x"] + 0.05 * box["width"], box["y"] + 20)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.135 * box["width"], box["y"] + 20, steps=4)
    page.mouse.up()
    page.wait_for_function("() => motionscape.search.now.view.query && !/:0-/.test(motionscape.search.now.view.query)")
    clip, start, end = re.fullmatch(r"(.+):(\d+)-(\d+)", link_of(page)["query"]).groups()
    frames = page.evaluate("motionscape.search.now.clips.clips[0][1]")
    assert clip == name and abs(int(start) - 0.05 * frames) < 12 and abs(int(end) - 0.135 * frames) < 12
    wait_for_hits(page, link_of(page)["query"])
    page.get_by_role("slider", name="End of the query").focus()
    page.keyboard.press("Shift+ArrowRight")
    page.wait_for_url(re.compile(f"-{int(end) + 10}(&|$)"))
    wait_for_hits(page, link_of(page)["query"])


@pytest.mark.slow
def test_parts_are_weighed_by_clicks_keys_and_presets(show, indexed) -> None:
    page = open_search(show, stretch(indexed))
    arm = page.locator(".search-part[data-part='left_arm']")
    arm.click(modifiers=["Shift"])
    page.wait_for_url(re.compile("parts=left_arm:10(&|$)"))
    expect(arm).to_have_attribute("aria-valuenow", "100")
    page.locator(".search-part[data-part='head']").focus()
    page.keyboard.press("Enter")
    page.wait_for_url(re.compile("parts=head:10,left_arm:10"))
    page.keyboard.press("ArrowDown")
    page.wait_for_url(re.compile("parts=head:9,left_arm:10"))
    page.wait_for_function("motionscape.search.now.found?.inputs.parts === 'head:9,left_arm:10'", timeout=PATIENCE)
    page.locator("#search-preset").select_option("arms and legs (35 / 45 / 20)")
    page.wait_for_url(re.compile("left_arm:17.5,"))
    shares = {
        row.get_attribute("data-part"): row.locator(".search-weight-share").text_content()
        for row in page.locator(".search-weight-row").all()
    }
    assert shares["left_arm"] == "18 %" and shares["left_leg"] == "5 %" and shares["head"] == "0 %"
    page.reload()
    expect(page.locator("#search-preset")).to_have_value("arms and legs (35 / 45 / 20)", timeout=PATIENCE)
    page.locator("#search-preset").select_option("whole body")
    page.wait_for_function("() => !motionscape.search.now.view.parts")


@pytest.mark.slow
def test_a_query_is_put_together_from_pieces(show, indexed) -> None:
    page = open_search(show, stretch(indexed))
    page.locator("[data-search='combine']").click()
    page.wait_for_url(re.compile("query=upper_body:.*,lower_body:"))
    expect(page.locator(".search-source")).to_have_count(2)
    other = indexed.open("demo").names[-1]
    page.locator(".search-source").nth(1).get_by_label("Clip that is looked for").fill(other)
    page.locator(".search-source").nth(1).get_by_label("Clip that is looked for").press("Enter")
    page.wait_for_url(re.compile(f"lower_body:{other}:0-"))
    wait_for_hits(page, link_of(page)["query"])
    expect(page.locator(".search-source").nth(1)).to_contain_text("whole clip")

    page = open_search(show, f"upper_body:{stretch(indexed)},lower_body:{other}:30-120")
    page.locator(".search-part[data-part='left_arm']").click(modifiers=["Shift"])
    page.wait_for_url(re.compile(re.escape("query=head_torso%2Bright_arm_hand:") + ".*" + re.escape("lower_body")))
    wait_for_hits(page, link_of(page)["query"])
    page.wait_for_function("() => motionscape.stage.status === 'ready' && motionscape.stage.figures === 2")
    expect(page.locator(".search-gives").nth(0)).to_have_text("Head and torso, right arm and hand")
    page.locator(".search-open").first.click()
    wait_for_stage(page, "Query and")
    page.wait_for_function("() => motionscape.stage.figures === 3")
    page.locator("[data-piece='remove']").nth(1).click()
    expect(page.locator(".search-source")).to_have_count(1)


def test_a_file_of_ones_own_is_looked_for(show, indexed, tmp_path: Path) -> None:
    clip = indexed.open("demo").clips[1]
    write_bvh(tmp_path / "mine.bvh", clip.cut(0, 150, "mine"))
    (tmp_path / "bad.bvh").write_text("no recording at all")
    (tmp_path / "notes.doc").write_text("nothing")
    page = show("/search?dataset=demo", viewport=WIDE)

    def upload(name: str) -> None:
        with page.expect_file_chooser() as chooser:
            page.locator("[data-search='upload']").click()
        chooser.value.set_files(tmp_path / name)

    upload("notes.doc")
    expect(page.locator(".search-sending")).to_contain_text("not a kind of file we read")
    upload("bad.bvh")
    expect(page.locator("#search-upload-status")).to_contain_text("expected HIERARCHY", timeout=PATIENCE)
    page.watch.expected.append("ERR_FAILED")
    asked = []
    page.route("**/api/uploads", lambda route: asked.append(route))
    for name in ("bad.bvh", "mine.bvh"):  # the second while the first is on its way: the last one counts
        upload(name)
    wait_until(page, lambda: len(asked) == 2)
    asked[1].continue_()
    page.wait_for_url(re.compile("query=mine:0-150:"), timeout=PATIENCE)
    asked[0].abort()
    page.wait_for_timeout(300)
    expect(page.locator(".search-sending")).to_have_count(0)
    page.unroute("**/api/uploads")
    wait_for_hits(page, link_of(page)["query"])
    expect(page.locator(".search-gives")).to_have_text("uploaded")
    expect(page.locator("#search-upload-status")).to_be_empty()
    wait_for_stage(page, "Query: mine")
    page.reload()
    wait_for_hits(page, link_of(page)["query"])
    expect(page.get_by_label("Clip that is looked for")).to_have_value("mine")
    page.route("**/api/uploads", lambda route: route.abort())
    upload("mine.bvh")
    expect(page.locator(".search-sending")).to_have_text("The server cannot take files now; try again in a moment.")


def test_filters_options_and_exports(show, indexed) -> None:
    query = stretch(indexed)
    page = open_search(show, query)
    action = page.evaluate("motionscape.search.now.found.hits.find((hit) => hit.label).label.replace(/ [0-9]+ %$/, '')")
    page.locator("#search-label").select_option(action)
    shown = "action => motionscape.search.now.found?.inputs.label === action"
    page.wait_for_function(shown, arg=action, timeout=PATIENCE)
    facts = page.locator(".search-facts").all_text_contents()
    assert facts and all(action in text for text in facts)
    page.locator("#search-label").select_option("")
    page.locator("#search-named").fill("nobody is called so")
    expect(page.locator(".search-nothing")).to_contain_text("Nothing passes these filters", timeout=PATIENCE)
    page.locator("#search-named").fill("")
    page.locator("#search-level").select_option("clip")
    page.wait_for_function("motionscape.search.now.found?.level === 'clip' && !motionscape.search.now.view.named")
    page.locator("#search-route").fill("40")
    page.wait_for_url(re.compile("route=40"))
    page.wait_for_function("motionscape.search.now.found?.inputs.route === '40'", timeout=PATIENCE)
    page.get_by_role("button", name="Download").click()
    item = page.get_by_role("menuitem", name="Hits (CSV)")
    expect(item).to_have_attribute("href", re.compile("route=40"))
    place = item.get_attribute("href")
    parts = urlsplit(page.url)
    answer = page.request.get(f"{parts.scheme}://{parts.netloc}{place}")
    names = [line.split(",")[1] for line in answer.text().splitlines()[1:]]
    assert names == [name.partition(":")[0] for name in hits(page)]
    copied = page.get_by_role("menuitem", name="Copy as command").get_attribute("data-copy")
    assert copied.startswith("motionscape search ") and f"--query {query}" in copied and "--root-path 0.4" in copied


@pytest.mark.slow
def test_more_like_this_from_other_pages_and_the_stage(show, indexed) -> None:
    name = indexed.open("demo").names[0]
    page = show(f"/clip?dataset=demo&clip={name}&start=60&end=160", viewport=WIDE)
    page.get_by_role("button", name="More like this").click(timeout=PATIENCE)
    page.wait_for_url(re.compile(f"/search\\?.*query={name}:60-160"))
    wait_for_hits(page, f"{name}:60-160")

    page = show("/motifs?dataset=demo&motif=0&motion=0", viewport=WIDE)
    wait_for_graph(page)
    page.get_by_role("button", name="More like this").click(timeout=PATIENCE)
    page.wait_for_url(re.compile("/search\\?.*query="))
    wait_for_hits(page, link_of(page)["query"])
    before = link_of(page)["query"]
    page.locator("#search-motif").select_option(index=2)
    page.wait_for_function("before => motionscape.search.now.view.query !== before", arg=before)
    wait_for_hits(page, link_of(page)["query"])

    page.locator("#nav-library").click()
    page.evaluate("name => dash_clientside.set_props('selection', {data: {clip: name, start: 30, end: 130}})", name)
    wait_for_stage(page, name)
    page.locator("#nav-search").click()
    page.locator("[data-search='stage']").click()
    page.wait_for_url(re.compile(f"query={name}:30-130"))


def test_links_that_name_what_is_not_there_say_so(show, indexed) -> None:
    page = show("/search?dataset=demo&query=nobody:0-90", viewport=WIDE)
    expect(page.locator("#search-error")).to_contain_text("has no clip called “nobody”", timeout=PATIENCE)
    page = show("/search?dataset=demo&query=what", viewport=WIDE)
    expect(page.locator("#search-error")).to_contain_text("A piece of a query looks like", timeout=PATIENCE)
