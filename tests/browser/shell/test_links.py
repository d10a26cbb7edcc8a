"""Links in a real browser: the same view for a colleague, the theme, the keyboard."""

from __future__ import annotations

import pytest
from playwright.sync_api import expect

from tests.browser.app import address, demo_workspace, show, wait_for_graph, wait_for_link, wait_for_stage, workspace
from webapp.shell.links import View, format_link, parse

__all__ = ["address", "demo_workspace", "show", "workspace"]


def test_a_link_opens_the_same_view_in_another_browser(show, address):
    page = show("/motifs?motif=1")
    wait_for_stage(page, "Motif 1")
    page.click("#stage [data-action=play]")
    page.locator("#stage-canvas").focus()
    for key in ("Shift+ArrowLeft", "Shift+ArrowLeft", "ArrowRight"):
        page.keyboard.press(key)
    page.wait_for_function(
        """() => {  // the address is written now and then
            const { time, camera: c } = motionscape.stage.state(), link = new URLSearchParams(location.search);
            return link.get("time") === String(time)
                && link.get("camera") === [c.yaw, c.pitch, c.distance, ...c.pan, c.follow ? 1 : 0].join(",");
        }"""
    )
    seen = page.evaluate("motionscape.stage.state()")
    other = show(page.url.removeprefix(address))
    wait_for_stage(other, "Motif 1")
    restored = other.evaluate("motionscape.stage.state()")
    assert restored["camera"] == seen["camera"] and restored["time"] == seen["time"] and not restored["playing"]
    expect(other.locator("#motif-selection h2")).to_have_text("Motif 1")


VIEWS = (
    View("library", "demo", {"motif": 0, "motion": 1}, {}, {"rho": "2", "adjacency": "spheres", "tab": "report"}),
    View("library", "demo", {"edge": "0-1"}),
    View("library", "demo", {"clip": "Ben & Anna: 100 %+?#ü/ä", "start": 3, "end": 9}),
)


def test_the_address_is_the_link_that_python_writes(show):
    page = show("/library")
    page.watch.expected.append("404")  # nobody has recorded these
    wait_for_link(page, dataset="demo")
    page.evaluate(  # the server takes out again what is not there
        """() => {
            const write = history.replaceState.bind(history);
            window.written = [];
            history.replaceState = (...state) => { written.push(state[2]); write(...state); };
        }"""
    )
    for view in VIEWS:
        page.evaluate(
            """stores => {
                written.length = 0;
                for (const [id, data] of Object.entries(stores)) dash_clientside.set_props(id, { data });
            }""",
            {"selection": view.selection, "view": view.view},
        )
        key = next(iter(view.selection))
        address = page.wait_for_function(
            "key => written.find((one) => new URLSearchParams(one.split('?')[1]).has(key))", arg=key
        ).json_value()
        path, _, query = address.partition("?")
        assert parse(path, query) == (view, ()) == parse("/library", format_link(view).split("?")[1])


def test_the_stage_outlives_a_change_of_page_and_back_works(show):
    page = show("/motifs?motif=0")
    wait_for_stage(page, "Motif 0")
    page.click("#nav-library")
    expect(page.locator("h1")).to_have_text("Library")
    assert page.evaluate("motionscape.stage.status") == "ready"
    wait_for_link(page, motif="0")
    page.go_back()
    expect(page.locator("h1")).to_have_text("Motifs")
    wait_for_graph(page)


def test_a_broken_link_says_so_and_shows_the_rest(show):
    page = show("/motifs?dataset=gone&motif=x&rho=plenty")
    notice = page.locator("#notices-portal, .mantine-Notifications-notification, .mantine-Notification-root").first
    expect(notice).to_contain_text("gone")
    wait_for_graph(page)
    wait_for_link(page, dataset="demo", rho=None)


def test_a_link_to_a_motif_that_is_not_there_says_so(show):
    page = show("/motifs?dataset=demo&motif=999")
    notice = page.get_by_text("The result shown has no motif 999")
    expect(notice).to_be_visible()
    expect(notice).to_be_in_viewport()
    page.wait_for_function("!location.search.includes('999')")
    wait_for_graph(page)


def test_an_unknown_address_is_a_friendly_page(show):
    page = show("/nowhere")
    expect(page.get_by_text("There is no such page")).to_be_visible()
    page.get_by_role("link", name="Go to the library").click()
    expect(page.locator("h1")).to_have_text("Library")


def test_share_copies_the_link(show):
    page = show("/motifs?motif=0", permissions=["clipboard-read", "clipboard-write"])
    wait_for_stage(page, "Motif 0")
    page.click("#share")
    expect(page.get_by_text("Link copied")).to_be_visible()
    assert page.evaluate("navigator.clipboard.readText()") == page.url


@pytest.mark.slow
def test_the_theme_follows_the_system_and_is_remembered(show):
    page = show("/motifs", color_scheme="dark")
    wait_for_graph(page)
    root = page.locator("html")
    expect(root).to_have_attribute("data-mantine-color-scheme", "dark")
    line = "document.getElementById('motif-graph')._cyreg.cy.nodes()[0].style('background-color')"
    page.wait_for_function(f"{line} === 'rgb(35,42,52)'")
    page.click("#scheme-toggle")
    expect(root).to_have_attribute("data-mantine-color-scheme", "light")
    page.wait_for_function(f"{line} === 'rgb(255,255,255)'")
    page.reload()
    expect(root).to_have_attribute("data-mantine-color-scheme", "light")


FOCUSED = """(() => {
    const { id, className } = document.activeElement;
    return id && !id.startsWith("{") ? id : className.toString().split(" ")[0];
})()"""


def test_the_keyboard_reaches_everything(show):
    page = show("/library")
    expect(page.locator(".dataset-card")).to_have_count(1)
    expect(page.locator("#first-picture")).to_have_count(0)
    page.keyboard.press("Tab")
    expect(page.get_by_text("Skip to the page")).to_be_focused()
    reached = set()
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.add(page.evaluate(FOCUSED))
    wanted = {
        "dataset-picker",
        "share",
        "scheme-toggle",
        "nav-library",
        "nav-motifs",
        "upload-open",
        "dataset-open",
        "splitter",
    }
    assert wanted <= reached
    width = page.locator(".stage-panel").bounding_box()["width"]
    page.locator("#splitter").focus()
    page.keyboard.press("ArrowLeft")
    assert page.locator(".stage-panel").bounding_box()["width"] > width
