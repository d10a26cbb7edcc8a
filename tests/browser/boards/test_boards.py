"""Two people on one board: it is arranged, filtered and discussed by both, and nothing of either is lost."""

from __future__ import annotations

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import Locator, Page, expect

from core.workspace import Workspace
from core.workspace.blocks import Block
from tests.browser.app import address, demo_workspace, show, workspace

__all__ = ["address", "demo_workspace", "show", "workspace"]


@pytest.fixture
def board(workspace: Workspace) -> str:
    blocks = [
        Block("words", "text", 0, 0, 4, 3, {"title": "Plan", "options": {"markdown": "## First *draft*"}}),
        Block("graph", "graph", 4, 0, 8, 6, {"title": "Motif graph"}),
        Block("motifs", "motifs", 0, 6, 8, 5, {"title": "Motifs"}),
        Block("matrix", "matrix", 8, 6, 4, 5, {"title": "What follows what"}),
        Block("tracks", "tracks", 0, 11, 12, 4, {"title": "Over time"}),
    ]
    made = workspace.boards.create("Our board", blocks, "Ana")
    return workspace.boards.set_filters(made.id, {"dataset": "demo"}).id


def block(page: Page, id: str) -> Locator:
    return page.locator(f'.grid-stack-item[data-block="{id}"]')


def choose(page: Page, id: str, entry: str) -> None:
    block(page, id).hover()
    block(page, id).get_by_role("button", name="More", exact=True).click()
    page.get_by_role("menuitem", name=entry).click()


@pytest.fixture
def both(board: str, show: Callable[..., Page]) -> tuple[Page, Page]:
    pages = [show(f"/boards?dataset=demo&board={board}", viewport={"width": 1600, "height": 900}) for _ in range(2)]
    for page in pages:
        expect(block(page, "graph").locator(".block-motif").first).to_be_visible()
    return pages[0], pages[1]


def test_a_selection_in_one_block_lights_in_all_and_plays(both):
    page, _ = both
    block(page, "graph").locator(".block-motif").first.click()
    expect(block(page, "motifs").locator("tr.chosen")).to_have_count(1)
    expect(block(page, "tracks").locator(".block-stretch.faint").first).to_be_visible()
    expect(block(page, "matrix").locator(".block-line.chosen")).to_have_count(2)
    expect(page.locator(".ms-stage-title")).to_have_text(re.compile("Motif"))
    expect(page).to_have_url(re.compile(r"motif=\d+"))

    block(page, "tracks").locator(".block-stretch[aria-label*=walk]").first.click()  # a label: its motion lights
    expect(page).to_have_url(re.compile(r"start=\d+"))
    expect(block(page, "graph").locator(".block-motif.chosen").first).to_be_visible()
    expect(block(page, "motifs").locator("tr.chosen").first).to_be_visible()
    page.get_by_label("Narrow the board to a label").fill("walk")
    page.keyboard.press("Enter")
    expect(block(page, "matrix").locator(".block-cell.faint").first).to_be_visible()


def test_what_one_changes_the_other_sees(both, workspace, board):
    ana, ben = both
    block(ana, "words").locator(".board-head").focus()
    ana.keyboard.press("Shift+ArrowDown")
    expect(block(ben, "words")).to_have_attribute("gs-h", "4")

    choose(ana, "words", "Change")
    ana.get_by_label("Text").fill("## Second\n\n<b>no tag</b>")
    ana.get_by_role("button", name="Save", exact=True).click()
    expect(block(ben, "words").get_by_role("heading", name="Second")).to_be_visible()
    expect(block(ben, "words")).to_contain_text("<b>no tag</b>")

    choose(ben, "tracks", "Remove")
    expect(block(ana, "tracks")).to_have_count(0)
    ben.get_by_role("button", name="Undo").click()
    expect(block(ana, "tracks")).to_have_count(1)
    assert workspace.boards.get(board).block("tracks").kind == "tracks"


def test_two_at_one_block_see_both_versions(both, workspace, board):
    ana, ben = both
    for page, words in ((ana, "Ana's"), (ben, "Ben's")):
        choose(page, "words", "Change")
        page.get_by_label("Text").fill(words)
    ana.get_by_role("button", name="Save", exact=True).click()
    expect(block(ana, "words")).to_contain_text("Ana's")
    ben.watch.expected.append("409")
    ben.get_by_role("button", name="Save", exact=True).click()
    told = ben.get_by_role("dialog", name="Someone was faster")
    expect(told).to_contain_text("Ana's")
    expect(told).to_contain_text("Ben's")
    told.get_by_role("button", name="Save mine over it").click()
    expect(block(ana, "words")).to_contain_text("Ben's")


def test_they_discuss_a_block(both):
    ana, ben = both
    choose(ana, "graph", "Comment")
    ana.evaluate("localStorage.setItem('motionscape-name', 'Ana')")
    ana.get_by_label(re.compile("Say something")).fill("Too many boxes, @Ben?")
    ana.get_by_role("button", name="Comment", exact=True).last.click()
    badge = block(ben, "graph").get_by_role("button", name="Comments")
    expect(badge).to_have_attribute("data-count", "1")
    badge.click()
    expect(ben.locator(".boards-mention")).to_have_text("@Ben")
    ben.get_by_role("button", name="Resolve").click()
    expect(ana.locator(".boards-comment.resolved")).to_be_visible()
    ana.get_by_role("button", name="Reopen").click()
    expect(ben.locator(".boards-comment:not(.resolved)")).to_be_visible()


def test_changed_data_is_told_and_a_read_only_link_changes_nothing(show, board, workspace, both):
    page, _ = both
    workspace.boards.change_block(
        board,
        Block("graph", "graph", settings={"title": "Graph", "pinned": {"dataset": "demo", "fingerprint": "another"}}),
        workspace.boards.get(board).block("graph").version,
    )
    expect(page.locator(".boards-stale")).to_contain_text("changed since")
    reader = show(f"/boards?dataset=demo&board={board}&screen=read", viewport={"width": 1600, "height": 900})
    expect(block(reader, "words")).to_be_visible()
    expect(reader.get_by_role("button", name="Add block")).to_have_count(0)
    expect(block(reader, "words").get_by_role("button", name="More")).to_have_count(0)
    page.get_by_role("button", name="Recompute all").click()
    expect(page.locator(".boards-stale")).to_be_empty()


def test_a_board_begins_with_a_template_and_a_view_is_saved(show):
    page = show("/motifs?dataset=demo", viewport={"width": 1440, "height": 900})
    page.get_by_role("button", name="Save view: keep it for the team").click()
    form = page.get_by_role("dialog", name="Save this view")
    form.get_by_label("Title").fill("The graph of the demo")
    form.get_by_label("Tags").fill("demo, graph")
    form.get_by_role("button", name="Save", exact=True).click()
    page.locator("#nav-boards").click()
    card = page.locator(".boards-card", has_text="The graph of the demo")
    expect(card).to_contain_text("#graph")
    page.wait_for_function("document.querySelector('img.boards-picture')?.naturalWidth > 0")
    page.get_by_role("button", name="New board").click()
    page.get_by_role("dialog").get_by_role("button", name="Curation").click()
    page.get_by_role("button", name="Make it").click()
    expect(page.locator(".grid-stack-item")).to_have_count(4)
    expect(page.locator(".block-of-overview tbody tr").first).to_be_visible()
    page.get_by_role("button", name="Present").click()
    expect(page.locator(".header")).to_be_hidden()
    page.get_by_role("button", name="Leave").click()
    expect(page.locator(".header")).to_be_visible()


def test_a_server_that_is_gone_is_told_and_the_board_goes_on_when_it_is_back(both, workspace, board):
    page, _ = both
    page.watch.expected += ["ERR_FAILED", "request failed"]
    page.route("**/api/boards/*", lambda route: route.abort())
    expect(page.locator(".boards-warning")).to_contain_text("what you change now is not saved")
    assert block(page, "graph").locator(".block-motif").count() > 0  # what was there is still shown
    workspace.boards.rename(board, "Another title")
    page.unroute_all()
    expect(page.get_by_role("heading", name="Another title")).to_be_visible()
    expect(page.locator(".boards-warning")).to_be_hidden()


def test_boards_and_views_are_found_by_ctrl_k(show, board, workspace):
    workspace.views.save("/library?dataset=demo", "All recordings", tags=["start"])
    page = show("/motifs?dataset=demo")
    page.keyboard.press("Control+k")
    page.get_by_label("Go to").last.fill("our")
    page.keyboard.press("Enter")
    expect(block(page, "words")).to_be_visible()
    page.keyboard.press("Control+k")
    page.get_by_label("Go to").last.fill("recordings start")
    page.keyboard.press("Enter")
    expect(page.locator("#clips-table")).to_be_visible()


def test_the_library_offers_a_report_and_says_its_size(show):
    page = show("/library?dataset=demo")
    page.get_by_role("button", name="More for demo").click()
    page.get_by_role("menuitem", name="Report").click()
    told = page.get_by_role("dialog", name="Report of demo")
    told.get_by_role("button", name="As HTML").click()
    expect(told.get_by_role("link", name=re.compile(r"Save \d+\.\d MB"))).to_be_visible()
    expect(told).to_contain_text("at most")
