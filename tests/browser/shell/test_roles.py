"""Two people with different roles: who sees which controls, and what is said when something is refused."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.app import address, demo_workspace, workspace

__all__ = ["address", "demo_workspace", "workspace"]
PASSWORD = "correct horse"


@pytest.fixture
def sign_in(workspace, address, open_page):
    for role in ("viewer", "owner"):
        workspace.users.add(role, PASSWORD, role)

    def sign_in(name: str, path: str):
        page = open_page(address + path)
        page.get_by_label("Name").fill(name)
        page.get_by_label("Password").fill(PASSWORD)
        page.get_by_role("button", name="Sign in").click()
        return page

    return sign_in


def test_a_viewer_finds_no_controls_that_change_and_an_owner_does(sign_in):
    viewer, owner = (sign_in(role, "/library?dataset=demo&clip=ana_01") for role in ("viewer", "owner"))
    for page, sees in ((viewer, False), (owner, True)):
        expect(page.locator(".person-name")).to_have_text("owner" if sees else "viewer")
        expect(page.locator(".dataset-card")).to_be_visible()
        expect(page.locator("#upload-open")).to_be_visible(visible=sees)
        page.get_by_role("button", name="More for demo").click()
        expect(page.get_by_role("menuitem", name="Features (npz)")).to_be_visible()
        expect(page.get_by_role("menuitem", name="Delete")).to_be_visible(visible=sees)
    assert "clip=ana_01" in viewer.url, "signing in leads to what the link names"


def test_a_refusal_and_the_end_of_a_session_are_said_in_words(sign_in, workspace):
    page = sign_in("viewer", "/library?dataset=demo")
    page.watch.expected += ["403", "401", "status of 40", "body stream already read"]
    expect(page.locator(".dataset-card")).to_be_visible()
    page.evaluate("fetch('/api/uploads', { method: 'POST', headers: { 'X-Motionscape': '1' } })")
    expect(page.get_by_text("Only an editor may change this")).to_be_visible()
    workspace.users.set_password("viewer", "another horse")
    expect(page.get_by_text("Your session has ended")).to_be_visible()
    page.reload()
    expect(page.get_by_role("heading", name="Sign in to Motionscape")).to_be_visible()


def test_signing_out_leaves_nothing_behind(sign_in, address):
    page = sign_in("owner", "/library")
    page.watch.expected += ["401"]
    page.get_by_role("button", name="Sign out").click()
    expect(page.get_by_role("heading", name="Sign in to Motionscape")).to_be_visible()
    page.goto(f"{address}/motifs")
    expect(page.get_by_role("heading", name="Sign in to Motionscape")).to_be_visible()
