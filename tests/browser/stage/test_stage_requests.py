"""The Stage in a real browser: what it asks the server for, and the state it gives and takes."""

from __future__ import annotations

from dataclasses import replace

from core.mocap.dataset import Dataset
from tests.browser.stage.page import DATASETS, NAMES, PIXELS, get, page, play, request, stage_app
from tests.webapp.generated import walk

__all__ = ["page", "stage_app"]


def test_a_missing_clip_says_so_and_can_be_tried_again(page):
    asked = request()
    asked["items"][0]["clip"] = "swim"
    page.evaluate("asked => dash_clientside.set_props('stage-request', { data: asked })", asked)
    page.wait_for_function("motionscape.stage.status === 'error'")
    assert page.get_by_text("There is no clip called “swim” in “walkers”.").is_visible()
    with page.expect_response("**/api/motions?**clip=swim**"):
        page.get_by_role("button", name="Try again").click()
    page.wait_for_function("motionscape.stage.status === 'error'")
    play(page, request())
    assert not page.get_by_role("button", name="Try again").is_visible()


def test_some_missing_clips_leave_the_others_playing(page):
    asked = request(3)
    asked["items"][1]["clip"] = "swim"
    page.evaluate("asked => motionscape.stage.show(asked)", asked)
    page.wait_for_function("motionscape.stage.status === 'ready'")
    assert get(page, "figures") == 2
    assert "1 of 3 motions could not be loaded" in page.locator(".ms-stage-note").inner_text()


def test_last_request_wins(page):
    page.evaluate(
        "([a, b]) => Promise.all([motionscape.stage.show(a), motionscape.stage.show(b)])", [request(12), request(2)]
    )
    assert get(page, "status") == "ready" and get(page, "figures") == 2


def test_known_motions_are_not_fetched_again(page):
    version = DATASETS["walkers"].fingerprint
    play(page, request(3, version=version))
    asked = []
    page.on("request", lambda r: asked.append(r.url))
    play(page, request(2, version=version))
    play(page, request(3, version=version))
    assert not [url for url in asked if "/api/motion" in url]


def test_a_name_that_stands_for_other_content_shows_the_new_content(page, monkeypatch):
    play(page, request(), pause=True)
    before = page.evaluate(PIXELS)
    play(page, request(2), pause=True)
    play(page, request(), pause=True)
    assert page.evaluate(PIXELS) == before
    other = Dataset("walkers", (replace(walk("other", pace=2.5, seconds=3.0), name=NAMES[0]),))
    monkeypatch.setitem(DATASETS, "walkers", other)
    page.evaluate("motionscape.stage.show({ items: [] })")
    play(page, request(), pause=True)
    assert page.evaluate(PIXELS) != before


def test_nothing_is_asked_while_playing(page):
    play(page, request(3))
    asked = []
    page.on("request", lambda r: asked.append(r.url))
    page.wait_for_timeout(1000)
    assert asked == []


def test_state_comes_out_and_goes_back_in(page, open_page, stage_app):
    page.evaluate("window.states = []; addEventListener('stage-state', (event) => states.push(event.detail))")
    play(page, request(3), pause=True)
    page.get_by_role("button", name="Side by side").click()
    page.locator(".ms-chip").first.click()
    page.evaluate("motionscape.stage.seek(1.25)")
    page.mouse.wheel(0, 100)
    page.wait_for_function("states.some((state) => state.time === 1.25)")
    state = get(page, "state()")
    other = open_page(stage_app)
    other.wait_for_function("window.motionscape?.stage.status === 'empty'")
    other.evaluate(
        "([state, asked]) => { motionscape.stage.restore(state); motionscape.stage.show(asked); }", [state, request(3)]
    )
    other.wait_for_function("motionscape.stage.status === 'ready'")
    assert get(other, "state()") == state
    assert get(other, "figures") == 2


def test_nonsense_states_are_harmless(page):
    play(page, request(2), pause=True)
    before = get(page, "state()")
    nonsense = {
        "time": "x",
        "speed": None,
        "layout": "pile",
        "camera": {"yaw": "east", "pan": [1]},
        "loop": 3,
        "hidden": "ab",
    }
    page.evaluate("state => motionscape.stage.restore(state)", nonsense)
    assert get(page, "state()") == before
