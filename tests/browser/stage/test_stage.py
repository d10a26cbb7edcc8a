"""The Stage in a real browser: figures, time, camera, controls."""

from __future__ import annotations

import pytest

from tests.browser.stage.page import INK, NAMES, PIXELS, get, page, play, request, settle, stage_app, warped

__all__ = ["page", "stage_app"]


def test_empty_stage_gives_a_hint(page):
    assert get(page, "status") == "empty"
    assert page.get_by_text("Nothing on stage yet").is_visible()
    assert not page.get_by_text("Try again").first.is_visible()


def test_figures_move_and_pause_holds_them(page):
    play(page, request())
    before = page.evaluate(PIXELS)
    page.wait_for_function("t => motionscape.stage.time > t + .2", arg=get(page, "time"))
    assert page.evaluate(PIXELS) != before
    page.get_by_role("button", name="Pause").click()
    settle(page)
    held, time = page.evaluate(PIXELS), get(page, "time")
    page.wait_for_timeout(300)
    assert (page.evaluate(PIXELS), get(page, "time")) == (held, time)
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_function("t => motionscape.stage.time !== t", arg=time)


def test_speed_changes_the_rate(page):
    play(page, request())
    rate = """async () => {  // seconds played in a second; a frame counts for a quarter of a second at most
        const s = motionscape.stage, frame = () => new Promise(requestAnimationFrame);
        let now = await frame(), passed = 0;
        const first = s.time;
        while (passed < 0.6) {
            const next = await frame();
            passed += Math.min((next - now) / 1000, 0.25);
            now = next;
        }
        return ((s.time - first + s.duration) % s.duration) / passed;
    }"""
    page.evaluate("motionscape.stage.seek(0)")
    assert page.evaluate(rate) == pytest.approx(1.0, rel=0.02)
    for _ in range(3):
        page.get_by_role("button", name="Slower").click()
    assert get(page, "speed") == 0.25
    page.evaluate("motionscape.stage.seek(0)")
    assert page.evaluate(rate) == pytest.approx(0.25, rel=0.02)
    page.locator(".ms-speed").click()
    assert get(page, "speed") == 1


def test_scrubbing_seeks_and_goes_on(page):
    play(page, request())
    box = page.locator(".ms-scrub").bounding_box()
    page.mouse.move(box["x"] + 0.25 * box["width"], box["y"] + box["height"] / 2)
    page.mouse.down()
    assert get(page, "time") == pytest.approx(0.25 * get(page, "duration"), abs=0.02)
    page.mouse.move(box["x"] + 0.5 * box["width"], box["y"] + box["height"] / 2, steps=4)
    settle(page)
    assert get(page, "time") == pytest.approx(0.5 * get(page, "duration"), abs=0.02)
    assert not get(page, "playing")
    page.mouse.up()
    assert get(page, "playing")


def test_keyboard(page):
    play(page, request(2), pause=True)
    page.locator("#stage-canvas").focus()
    for _ in range(3):
        page.keyboard.press("ArrowRight")
    assert get(page, "frame") == 3
    page.keyboard.press("ArrowLeft")
    assert get(page, "frame") == 2
    page.keyboard.press("End")
    assert get(page, "frame") == 179
    page.keyboard.press("Home")
    assert get(page, "frame") == 0
    page.keyboard.press("+")
    assert get(page, "speed") == 1.5
    yaw = get(page, "camera.yaw")
    page.keyboard.press("Shift+ArrowRight")
    assert get(page, "camera.yaw") != yaw
    distance = get(page, "camera.distance")
    page.keyboard.press("ArrowUp")
    assert get(page, "camera.distance") < distance
    for key, state in (("l", "loop"), ("g", "ghosts"), ("t", "trails")):
        before = get(page, "state()")[state]
        page.keyboard.press(key)
        assert get(page, "state()")[state] != before
    page.keyboard.press("f")
    assert get(page, "camera.follow") is False
    page.keyboard.press("2")
    assert get(page, "layout") == "side"
    page.keyboard.press("1")
    assert get(page, "layout") == "overlay"
    page.keyboard.press("?")
    assert page.locator(".ms-help").is_visible()
    page.keyboard.press("Escape")
    assert not page.locator(".ms-help").is_visible()
    page.keyboard.press(" ")
    assert get(page, "playing")


def test_space_on_a_button_presses_that_button(page):
    play(page, request(), pause=True)
    page.get_by_role("button", name="Ghosts").focus()
    page.keyboard.press(" ")
    assert get(page, "state()")["ghosts"] is True
    assert not get(page, "playing")


def test_pointer_orbits_pans_and_zooms(page):
    play(page, request(), pause=True)
    box = page.locator("#stage-canvas").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    home, before = get(page, "camera"), page.evaluate(PIXELS)

    def drag(dx: float, dy: float) -> dict:
        page.mouse.move(x, y)
        page.mouse.down()
        page.mouse.move(x + dx, y + dy, steps=3)
        page.mouse.up()
        return get(page, "camera")

    turned = drag(120, 30)
    assert turned["yaw"] != home["yaw"] and turned["pitch"] != home["pitch"] and turned["pan"] == home["pan"]
    page.keyboard.down("Shift")
    shifted = drag(60, -20)
    page.keyboard.up("Shift")
    assert shifted["yaw"] == turned["yaw"] and shifted["pan"] != home["pan"]
    page.mouse.wheel(0, 300)
    page.wait_for_function("d => motionscape.stage.camera.distance > d", arg=home["distance"])
    settle(page)
    assert page.evaluate(PIXELS) != before
    page.mouse.dblclick(x, y)
    settle(page)
    assert get(page, "camera") == home


def test_overlaid_figures_stand_together_side_by_side_apart(page):
    play(page, request(4), pause=True)
    together = page.evaluate(INK)
    page.get_by_role("button", name="Side by side").click()
    settle(page)
    apart = page.evaluate(INK)
    assert together["count"] > 500 and apart["count"] > 500
    assert apart["right"] - apart["left"] > 2 * (together["right"] - together["left"])


def test_chips_hide_figures(page):
    play(page, request(3), pause=True)
    chips = page.locator(".ms-chip")
    assert chips.all_inner_texts() == list(NAMES[:3])
    before = page.evaluate(PIXELS)
    chips.nth(1).click()
    page.mouse.move(5, 5)
    settle(page)
    assert get(page, "figures") == 2
    assert chips.nth(1).get_attribute("aria-pressed") == "false"
    assert page.evaluate(PIXELS) != before


def test_motions_of_a_motif_play_in_step(page):
    play(page, warped(), pause=True)
    assert get(page, "sync") == "warp"
    assert get(page, "duration") == pytest.approx(99 / 60)
    frames = "t => motionscape.stage.framesAt(t)"
    middle = page.evaluate(frames, 49.5 / 60)
    assert middle == pytest.approx([49.5, 99 * 0.5**1.5 * 1.2, 99 * 0.5**2 * 1.4], abs=0.1)
    page.get_by_role("button", name="In step").click()
    assert get(page, "sync") == "start"
    assert page.evaluate(frames, 0.5) == pytest.approx([30, 30, 30], abs=0.01)
    assert not page.locator(".ms-warp").is_visible()


def test_warp_strip_seeks(page):
    play(page, warped(), pause=True)
    strip = page.locator(".ms-warp-rows")
    assert strip.is_visible()
    box = strip.bounding_box()
    strip.click(position={"x": 0.75 * box["width"], "y": box["height"] / 2})
    assert get(page, "time") == pytest.approx(0.75 * get(page, "duration"), abs=0.02)
    settle(page)
    cursor = page.locator(".ms-warp-cursor").bounding_box()
    assert cursor["x"] == pytest.approx(box["x"] + 0.75 * box["width"], abs=4)
    assert "as the middle motion here" in strip.get_attribute("title")


def test_loop_modes(page):
    play(page, request(), pause=True)
    page.evaluate("motionscape.stage.restore({ loop: 'once', speed: 4, time: 2.8, playing: true })")
    page.wait_for_function("!motionscape.stage.playing")
    assert get(page, "time") == get(page, "duration")
    page.evaluate("motionscape.stage.restore({ loop: 'loop', time: 2.9, playing: true })")
    page.wait_for_function("motionscape.stage.time < 2")
    page.evaluate("motionscape.stage.restore({ loop: 'bounce', time: 2.9, playing: true })")
    page.wait_for_function("motionscape.stage.time < 2")
    assert get(page, "playing")


def test_reduced_motion_does_not_autoplay(open_page, stage_app):
    page = open_page(stage_app, reduced_motion="reduce")
    page.wait_for_function("window.motionscape?.stage.status === 'empty'")
    page.evaluate("asked => motionscape.stage.show(asked)", request())
    page.wait_for_function("motionscape.stage.status === 'ready'")
    assert not get(page, "playing")
    page.get_by_role("button", name="Play", exact=True).click()
    page.wait_for_function("motionscape.stage.time > 0")


def test_theme_change_repaints(page):
    play(page, request(), pause=True)
    light = page.evaluate("[...document.getElementById('stage-canvas').getContext('2d').getImageData(4, 4, 1, 1).data]")
    page.evaluate("document.documentElement.setAttribute('data-mantine-color-scheme', 'dark')")
    settle(page)
    dark = page.evaluate("[...document.getElementById('stage-canvas').getContext('2d').getImageData(4, 4, 1, 1).data]")
    assert sum(light[:3]) > 600 and sum(dark[:3]) < 200


@pytest.mark.parametrize("width", [420, 640, 1600])
def test_controls_fit_every_width(page, width):
    page.set_viewport_size({"width": width, "height": 700})
    play(page, warped(12))
    stage_box = page.locator("#stage").bounding_box()
    boxes = [button.bounding_box() for button in page.locator(".ms-toolbar button").all() if button.is_visible()]
    assert len(boxes) == 16
    for box in boxes:
        assert stage_box["x"] <= box["x"] and box["x"] + box["width"] <= stage_box["x"] + stage_box["width"]
        assert box["y"] + box["height"] <= stage_box["y"] + stage_box["height"]
    for k, a in enumerate(boxes):
        for b in boxes[:k]:
            assert a["x"] >= b["x"] + b["width"] or b["x"] >= a["x"] + a["width"] or abs(a["y"] - b["y"]) > 20
    assert page.locator("#stage-canvas").bounding_box()["height"] > 200
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")


def test_sharp_on_dense_screens(open_page, stage_app):
    page = open_page(stage_app, device_scale_factor=2)
    page.wait_for_function("window.motionscape?.stage.status === 'empty'")
    page.wait_for_function("(c => c.width === 2 * c.clientWidth)(document.getElementById('stage-canvas'))")


def test_buttons_have_names(page):
    play(page, request(2))
    for button in page.locator("#stage button").all():
        if button.is_visible():
            assert button.get_attribute("aria-label") or button.inner_text().strip()
