"""Someone with an account and someone who has only the link of a board, each in a browser of their own."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page, expect

from core.workspace import Board, Workspace
from core.workspace.blocks import Block
from tests.browser.app import address, demo_workspace, workspace
from tests.browser.boards.test_boards import block, choose

__all__ = ["address", "demo_workspace", "workspace"]
PASSWORD = "correct horse"
WIDE = {"width": 1600, "height": 900}


@pytest.fixture
def board(workspace: Workspace) -> Board:
    workspace.users.add("ann", PASSWORD, "editor")
    words = Block("words", "text", 0, 0, 6, 3, {"title": "Plan", "options": {"markdown": "first"}})
    made = workspace.boards.create("Our board", [words, Block("graph", "graph", 6, 0, 6, 6)], "ann")
    return workspace.boards.set_filters(made.id, {"dataset": "demo"})


@pytest.fixture
def ann(open_page, address: str, board: Board) -> Page:
    page = open_page(f"{address}/boards?dataset=demo&board={board.id}", viewport=WIDE)
    page.get_by_label("Name").fill("ann")
    page.get_by_label("Password").fill(PASSWORD)
    page.get_by_role("button", name="Sign in").click()
    expect(block(page, "words")).to_be_visible()
    return page


def test_with_the_read_link_one_sees_what_others_change_and_changes_nothing(ann, open_page, address, board, workspace):
    guest = open_page(f"{address}/boards?board={board.id}&key={board.read_key}", viewport=WIDE)
    expect(block(guest, "graph").locator(".block-motif").first).to_be_visible()
    assert "key=" not in guest.url
    expect(guest.locator(".person")).to_contain_text("Guest")
    expect(guest.get_by_role("button", name="Add block")).to_have_count(0)
    expect(guest.get_by_role("button", name="Save view: keep it for the team")).to_be_hidden()
    choose(ann, "words", "Change")
    ann.get_by_label("Text").fill("second")
    ann.get_by_role("button", name="Save", exact=True).click()
    expect(block(guest, "words")).to_contain_text("second", timeout=5000)
    assert workspace.boards.get(board.id).block("words").author == "ann"


def test_with_the_edit_link_one_changes_the_board_under_the_name_guest(ann, open_page, address, board, workspace):
    guest = open_page(f"{address}/boards?board={board.id}&key={board.edit_key}", viewport=WIDE)
    choose(guest, "words", "Change")
    guest.get_by_label("Text").fill("by a guest")
    guest.get_by_role("button", name="Save", exact=True).click()
    expect(block(ann, "words")).to_contain_text("by a guest", timeout=5000)
    assert workspace.boards.get(board.id).block("words").author == "guest"
    assert workspace.audit.entries()[-1].who == "guest"


def test_when_the_links_are_renewed_the_open_page_says_so(open_page, address, board, workspace):
    guest = open_page(f"{address}/boards?board={board.id}&key={board.read_key}", viewport=WIDE)
    guest.watch.expected += ["401", "403", "body stream already read"]
    expect(block(guest, "words")).to_contain_text("first")
    workspace.boards.renew_keys(board.id)
    expect(guest.locator(".boards-warning", has_text="opens the board no more")).to_be_visible()
    expect(block(guest, "words")).to_contain_text("first")
    guest.goto(f"{address}/boards?board={board.id}&key={board.read_key}")
    expect(guest.get_by_role("heading", name="This link opens no board")).to_be_visible()
