"""The Stage in a real browser: several data sets at once, stills, swapping in place, frames, coloured spans, names."""

from __future__ import annotations

import pytest

from tests.browser.stage.page import INK, NAMES, PIXELS, get, page, play, request, settle, stage_app, warped

__all__ = ["page", "stage_app"]

FRAMES = "() => [0, 1, 2, 3].map(motionscape.stage.frameOf).filter(Boolean).map((item) => item.frame)"
RED, BLUE = "#d02020", "#2040d0"


def coloured() -> dict:
    asked = request()
    asked["items"][0]["colours"] = [
        {"start": 60, "end": 120, "colour": BLUE, "label": "Motif 4"},
        {"start": -20, "end": 45, "colour": RED, "label": "Motif 7"},
        {"start": 150, "end": 150, "colour": RED, "label": "empty"},
    ]
    return asked


def test_a_made_motion_beside_its_source_in_one_request(page):
    asked = request(2)
    asked["items"].append({"dataset": "~made~1", "clip": "walk", "start": 40, "end": 240, "label": "Made"})
    seen = []
    page.on("request", lambda r: seen.append(r.url))
    play(page, asked, pause=True)
    assert len([url for url in seen if "/api/motion" in url]) == 1
    items = [get(page, f"frameOf({k})") for k in range(3)]
    assert [item["dataset"] for item in items] == ["walkers", "walkers", "~made~1"]
    assert [(item["clip"], item["start"], item["frame"]) for item in items][2] == ("walk", 40, 40)
    assert page.evaluate("motionscape.stage.frameOf(3)") is None
    page.evaluate("motionscape.stage.seek(1)")
    assert page.evaluate(FRAMES) == [60, 60, 160], "each counts frames at its own rate"


def test_stills_stand_at_their_middles_and_move_by_the_same_share(page):
    asked = request(4, layout="pose", sync="start")
    asked["items"][1].update(start=20, end=61)
    asked["items"][2]["frame"] = 60
    play(page, asked)
    assert get(page, "layout") == "pose" and not get(page, "playing")
    assert page.evaluate(FRAMES) == [90, 40, 60, 90]
    held = page.evaluate(PIXELS)
    page.wait_for_timeout(200)
    assert page.evaluate(PIXELS) == held
    page.evaluate("motionscape.stage.seek(.75 * motionscape.stage.duration)")
    assert page.evaluate(FRAMES) == pytest.approx([134, 50, 104.75, 134], abs=1)
    settle(page)
    assert "75 % of each" in page.locator(".ms-readout").inner_text()
    spread = page.evaluate(INK)
    camera = get(page, "camera")
    page.keyboard.press("Tab")
    page.locator("#stage-canvas").focus()
    page.keyboard.press("Shift+ArrowRight")
    assert get(page, "camera.yaw") != camera["yaw"]
    page.keyboard.press("1")
    page.evaluate("motionscape.stage.seek(0)")
    settle(page)
    together = page.evaluate(INK)
    assert spread["right"] - spread["left"] > 2 * (together["right"] - together["left"])
    page.get_by_role("button", name="Stills in rows").click()
    assert get(page, "layout") == "pose"
    play(page, {**warped(), "layout": "pose"})
    assert page.evaluate(FRAMES) == pytest.approx([49.5, 99 * 0.5**1.5 * 1.2, 99 * 0.5**2 * 1.4], abs=1), "in step"


def test_replacing_keeps_time_camera_and_layout(page):
    play(page, request(2, layout="side"))
    page.evaluate("motionscape.stage.restore({ time: 1, speed: .1, camera: { distance: 9, yaw: .4 }, hidden: [1] })")
    before = {**get(page, "state()"), "share": get(page, "time") / get(page, "duration")}
    other = request(2, layout="overlay", title="Blend")
    for item in other["items"]:
        item.update(end=91)
    page.evaluate("asked => motionscape.stage.replace(asked)", other)
    assert get(page, "duration") == pytest.approx(1.5)
    after = get(page, "state()")
    assert after["playing"] and get(page, "time") / get(page, "duration") == pytest.approx(before["share"], abs=0.1)
    for kept in ("layout", "speed", "hidden", "camera"):
        assert after[kept] == before[kept], kept
    assert page.locator(".ms-stage-title").inner_text() == "Blend"
    # a slider asks faster than motions come: the last one wins, none is shown twice
    many = [request(1, replace=True) for _ in range(20)]
    for k, asked in enumerate(many):
        asked["items"][0]["end"] = 100 + k
    page.evaluate("many => Promise.all(many.map((asked) => motionscape.stage.show(asked)))", many)
    assert get(page, "frameOf(0)")["end"] == 119 and get(page, "figures") == 1
    missing = request()
    missing["items"][0]["clip"] = "swim"
    page.evaluate("asked => motionscape.stage.replace(asked)", missing)
    assert get(page, "figures") == 1 and "no clip called “swim”" in page.locator(".ms-stage-note").inner_text()
    page.evaluate("motionscape.stage.show({ items: [] })")
    page.evaluate("asked => motionscape.stage.replace(asked)", request(3))
    page.wait_for_function("motionscape.stage.status === 'ready' && motionscape.stage.figures === 3")
    assert page.locator(".ms-stage-note").is_hidden()


def test_charts_follow_frames_and_lead_to_them(page):
    page.evaluate(
        """() => { window.told = { state: [], frame: [] };
            for (const name of ['state', 'frame'])
                addEventListener('stage-' + name, (event) => told[name].push(event.detail)); }"""
    )
    play(page, warped())
    page.wait_for_function("told.frame.length > 5 && told.state.filter((detail) => detail.playing).length > 1")
    page.evaluate("motionscape.stage.pause(); motionscape.stage.seek(.5)")
    settle(page)
    last = page.evaluate("told.frame.at(-1)")
    assert last["time"] == 0.5 and [item["frame"] for item in last["items"]] == page.evaluate(FRAMES)
    page.wait_for_function("told.state.at(-1).time === .5 && !told.state.at(-1).playing")
    assert page.evaluate("told.state.at(-1).items[1].clip") == NAMES[1]
    for clip, frame, lands in ((NAMES[1], 70, 70), (NAMES[2], 33, 33), (NAMES[0], 500, 99)):
        assert page.evaluate("to => motionscape.stage.seek(to)", {"clip": clip, "frame": frame})
        index = NAMES.index(clip)
        assert get(page, f"frameOf({index})")["frame"] == pytest.approx(lands, abs=1)
    time = get(page, "time")
    for nonsense in ({"clip": "swim", "frame": 3}, {"clip": NAMES[0], "frame": "x"}, None, "soon"):
        assert page.evaluate("to => motionscape.stage.seek(to)", nonsense) is False
    assert get(page, "time") == time


def test_coloured_spans_band_the_time_and_the_path(page):
    play(page, coloured(), pause=True)
    blocks = page.locator(".ms-band span")
    assert blocks.all_inner_texts() == ["Motif 7", "Motif 4"]
    whole = page.locator(".ms-bands").bounding_box()
    red, blue = (block.bounding_box() for block in blocks.all())
    assert red["x"] == pytest.approx(whole["x"], abs=1)
    assert blue["x"] - whole["x"] == pytest.approx(whole["width"] * 60 / 179, abs=2)
    assert blue["width"] == pytest.approx(whole["width"] * 60 / 179, abs=2)
    assert get(page, "state()")["trails"] == "root"
    count = """([r, g, b]) => {
        const c = document.getElementById('stage-canvas');
        const data = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
        let n = 0;
        for (let k = 0; k < data.length; k += 4) n += data[k] === r && data[k + 1] === g && data[k + 2] === b;
        return n;
    }"""
    page.evaluate("motionscape.stage.seek({ clip: 'walk 0/a', frame: 80 })")
    settle(page)
    assert page.evaluate(count, [208, 32, 32]) > 50 and page.evaluate(count, [32, 64, 208]) > 50
    page.mouse.click(blue["x"] + blue["width"] / 2, blue["y"] + 4)
    settle(page)
    assert get(page, "frameOf(0)")["frame"] == pytest.approx(90, abs=2) and get(page, "frameOf(0)")["span"] == "Motif 4"
    assert "Motif 4" in page.locator(".ms-readout").inner_text()
    play(page, request(), pause=True)
    assert page.locator(".ms-bands").is_hidden() and get(page, "state()")["trails"] == "off"
    assert page.evaluate(count, [208, 32, 32]) == 0


def test_long_names_keep_both_ends(page):
    asked = request(2)
    long = "subject_86_session_3_walk_and_turn_take_12"
    asked["items"][0]["label"] = long
    play(page, asked, pause=True)
    chip = page.locator(".ms-chip").first
    assert chip.inner_text() == "subject_86…n_take_12"
    assert long in chip.get_attribute("title")
    name = chip.locator(".ms-chip-name")
    assert name.evaluate("e => e.scrollWidth <= e.clientWidth"), "not cut a second time"
