"""The Map page in the browser: building it, clicking postures, what plays, what a link brings back."""

from __future__ import annotations

from playwright.sync_api import expect

from core import analyses
from tests.browser.app import (
    address,
    demo_workspace,
    show,
    wait_for_link,
    wait_for_stage,
    workspace,
)
from tests.browser.motion_map.page import SMALL, click_node, hits_of, mapped, open_map, place_of, two_keys, wait_for_map

__all__ = ["address", "demo_workspace", "mapped", "show", "workspace"]


def test_a_map_is_built_and_its_icons_are_one_picture(show):
    page = show("/map?dataset=demo")
    expect(page.locator("#map-status")).to_contain_text("No motion map yet")
    page.locator("#map-fold button").first.click()
    page.locator("""input[id*='"name":"grid"']""").fill("12x11")
    page.locator("""input[id*='"name":"samples"']""").fill("500")
    page.locator("#map-run").click()
    wait_for_map(page)
    wait_for_link(page, **{"map-grid": "12x11", "map-samples": "500"})
    expect(page.locator("#map-graph .layer-above image, #map-graph .imagelayer image")).to_have_count(1)
    expect(page.locator("#map-hits")).to_contain_text("Choose one or more postures")


def test_keys_reach_and_hits_are_the_servers(mapped, show):
    page = open_map(show)
    keys = two_keys(mapped)
    page.mouse.move(*place_of(page, *keys[0]))
    expect(page.locator("#map-preview .map-view")).to_have_count(3)
    expect(page.locator(".map-caption")).to_contain_text(f"Node {keys[0][0]}, {keys[0][1]}")
    for key in keys:
        click_node(page, *key)
    expect(page.locator(".map-key-card")).to_have_count(2)
    assert hits_of(page) == [tuple(segment) for segment, _ in mapped.search(keys)]
    slider = page.locator("#map-reach")
    slider.evaluate(
        "(s) => { s.value = 0.5; s.dispatchEvent(new Event('input')); s.dispatchEvent(new Event('change')); }"
    )
    wanted = [tuple(segment) for segment, _ in mapped.search(keys, 0.5)]
    assert len(wanted) > len(mapped.search(keys)) and sorted(hits_of(page)) == sorted(wanted)
    expect(page.locator("#map-count")).to_contain_text(f"{len(wanted)} hits")
    expect(page.locator(".map-hit")).to_have_count(min(len(wanted), 60))
    expect(page.locator(".map-reach")).to_have_count(1)
    link = "-".join(map(str, keys[0])) + "," + "-".join(map(str, keys[1]))
    page.wait_for_function("text => location.search.includes(text)", arg=f"keys={link}&within=0.50")
    again = open_map(show, f"&keys={link}&within=0.50")
    expect(again.locator(".map-key-card")).to_have_count(2)
    expect(again.locator("#map-count")).to_contain_text(f"{len(wanted)} hits")
    assert float(again.locator("#map-reach").input_value()) == 0.5


def test_keys_are_reordered_and_removed_with_mouse_and_keyboard(mapped, show):
    page = open_map(show)
    (a, b), (c, d) = two_keys(mapped)
    page.locator(".map-overlay").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    expect(page.locator(".map-key-card")).to_have_count(1)
    page.keyboard.press("Backspace")
    expect(page.locator(".map-key-card")).to_have_count(0)
    click_node(page, a, b)
    click_node(page, c, d)
    page.locator(".map-key-card").nth(0).focus()
    page.keyboard.press("ArrowRight")
    page.wait_for_function("text => location.search.includes(text)", arg=f"keys={c}-{d},{a}-{b}")
    page.locator(".map-key-card").nth(1).get_by_role("button", name="Move key 2 before").click()
    page.wait_for_function("text => location.search.includes(text)", arg=f"keys={a}-{b},{c}-{d}")
    page.locator(".map-key-card").nth(0).get_by_role("button", name="Remove key 1").click()
    expect(page.locator(".map-key-card")).to_have_count(1)
    page.locator("[data-map-do=clear]").click()
    expect(page.locator(".map-key-card")).to_have_count(0)
    page.wait_for_function("() => !location.search.includes('keys=')")


def test_a_hit_plays_and_its_dot_moves_along_its_path(mapped, show):
    (a, b), (c, d) = two_keys(mapped)
    page = open_map(show, f"&keys={a}-{b},{c}-{d}&within=0.40")
    page.locator(".map-hit").first.click()
    clip, start, end = hits_of(page)[0]
    wait_for_stage(page, clip)
    expect(page.locator(".map-way")).to_have_count(1)
    page.evaluate(
        "([clip, frame]) => { motionscape.stage.pause(); motionscape.stage.seek({ clip, frame }); }", [clip, start]
    )
    page.wait_for_function("() => motionscape.map.state.follower.dots?.length === 1")
    step = mapped.clip_fps[mapped.clips.index(clip)] / mapped.fps
    nodes = mapped.nodes_of(clip)
    for frame in (start, (start + end) // 2):
        page.evaluate("([clip, frame]) => motionscape.stage.seek({ clip, frame })", [clip, frame])
        wanted = nodes[round(frame / step)].tolist()
        page.wait_for_function(
            "([x, y]) => motionscape.map.state.follower.dots.some((dot) => Math.hypot(dot.x - x, dot.y - y) < 1.6)",
            arg=wanted,
        )
    page.locator("#map-play-all").click()
    wait_for_stage(page, "hits")
    n = min(len(hits_of(page)), 12)
    page.wait_for_function("n => motionscape.map.state.follower.dots?.length === n", arg=n)
    expect(page.locator(".map-way")).to_have_count(n)


def test_the_frame_on_the_stage_becomes_a_key(mapped, show):
    clip = mapped.clips[0]
    page = open_map(show, f"&clip={clip}")
    wait_for_stage(page, clip)
    page.evaluate("clip => { motionscape.stage.pause(); motionscape.stage.seek({ clip, frame: 60 }); }", clip)
    frame = page.evaluate("motionscape.stage.frameOf(0).frame")
    page.locator("[data-map-do=stage]").click()
    expect(page.locator(".map-key-card")).to_have_count(1)
    step = mapped.clip_fps[0] / mapped.fps
    x, y = mapped.nodes_of(clip)[round(frame / step)]
    at = page.evaluate("motionscape.map.state.map.place(motionscape.map.state.keys[0])")
    assert max(abs(at[0] - x), abs(at[1] - y)) <= 2


def test_a_motif_lights_its_nodes_and_a_region_gives_motifs_and_clips(mapped, show, workspace):
    graph = analyses.stored(workspace, analyses.Request("demo", "motifs"))
    motif = graph.motifs[0]
    page = show(f"/motifs?dataset=demo&motif={motif.id}")
    wait_for_stage(page, f"Motif {motif.id}")
    page.evaluate("(view) => dash_clientside.set_props('view-change', { data: view })", SMALL)
    page.click("#nav-map")
    wait_for_map(page)
    expect(page.locator(".map-lit")).to_have_count(1)
    page.locator("#map-click label", has_text="Regions").click()
    page.wait_for_function("() => motionscape.map.state.mode === 'regions'")
    x, y = mapped.nodes_of(motif.segments[0].clip)[round(motif.segments[0].start * mapped.fps / 60)]
    click_node(page, int(x), int(y))
    region = int(mapped.regions[x, y])
    expect(page.locator("#map-region")).to_contain_text(f"Region {region}")
    page.wait_for_function("text => location.search.includes(text)", arg=f"region={region}")
    page.locator("#map-region .map-choice", has_text=mapped.clips[0]).first.click()
    wait_for_stage(page, mapped.clips[0])
    expect(page.locator(".map-way")).to_have_count(1)
    listed = page.locator("#map-region .map-choice", has_text="Motif ").count()
    page.get_by_text("Mark them in the motif graph").click()
    expect(page.locator(".marked-motifs button")).to_have_count(listed)
    page.wait_for_function(
        "count => document.getElementById('motif-graph')?._cyreg?.cy?.nodes('.chosen').length === count", arg=listed
    )
    page.wait_for_function("() => location.pathname === '/motifs' && location.search.includes('motifs=')")
    page.locator(".marked-motifs button").first.click()
    expect(page.locator(".marked-motifs")).to_have_count(0)


def test_colours_and_small_maps(mapped, show):
    page = open_map(show, "&colour=label&below=labels")
    expect(page.locator(".map-legend-entry").first).to_be_visible()
    expect(page.locator("#map-multiples .js-plotly-plot .hm").first).to_be_visible()
    expect(page.locator("#map-colour")).to_have_value("Label")
    page.click("#map-colour")
    page.get_by_role("option", name="Speed").click()
    page.wait_for_function("() => location.search.includes('colour=speed')")
    expect(page.locator(".map-scale")).to_be_visible()
    page.locator("#map-below label", has_text="Clips").click()
    expect(page.locator("#map-clips .ag-row")).to_have_count(len(mapped.clips))
