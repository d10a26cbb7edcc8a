"""The Stage against Plotly's scatter3d, in one headless Chromium: frames per second; and the motion route's speed.

usage: python -m benchmarks.bench_stage
"""

from __future__ import annotations

import statistics
import time
import urllib.request
from pathlib import Path

import plotly
from dash import Dash, html
from flask import Response
from playwright.sync_api import Browser, Page, sync_playwright

from core.mocap.posture_drawing import drawn_body
from tests.browser.start import running, start_chromium
from tests.webapp.generated import walkers
from webapp.stage import player
from webapp.stage.motion_routes import motion_blueprint

COMMAND = "python -m benchmarks.bench_stage"
COUNTS = (1, 4, 12, 24)
SECONDS = 5.0  # measured after one second of warming up
VIEW = {"width": 1280, "height": 800}
NAMES = tuple(f"walk {k}" for k in range(max(COUNTS)))
ASSETS = Path(__file__).resolve().parents[1] / "assets" / "bundle"

COUNT_FRAMES = """async (seconds) => {
    const wait = (ms) => new Promise((done) => setTimeout(done, ms));
    await wait(1000);
    const times = [];
    let on = true;
    const tick = (now) => { times.push(now); if (on) requestAnimationFrame(tick); };
    requestAnimationFrame(tick);
    await wait(1000 * seconds);
    on = false;
    return 1000 * (times.length - 1) / (times[times.length - 1] - times[0]);
}"""

# Plotly as one would write it: a trace a figure, all bones in one line with gaps, restyled for every frame.
PLOTLY = """async ([seconds, clips]) => {
    const motions = await Promise.all(clips.map(async (clip) => {
        const buffer = await (await fetch(`/api/motion/walkers/${encodeURIComponent(clip)}`)).arrayBuffer();
        const length = new DataView(buffer).getUint32(0, true);
        const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
        return { header, positions: new Float32Array(buffer, 4 + length) };
    }));
    const lines = (motion, frame, lane) => {
        const [x, y, z] = [[], [], []];
        const n = motion.header.joints.length;
        motion.header.parents.forEach((parent, joint) => {
            if (parent < 0) return;
            for (const j of [parent, joint]) {
                const k = 3 * (frame * n + j);
                x.push(motion.positions[k] + lane);
                y.push(motion.positions[k + 2]);
                z.push(motion.positions[k + 1]);
            }
            x.push(null); y.push(null); z.push(null);
        });
        return { x, y, z };
    };
    const traces = motions.map((m, k) => ({ type: 'scatter3d', mode: 'lines', line: { width: 6 }, ...lines(m, 0, k) }));
    const layout = { width: 1280, height: 640, showlegend: false, scene: { aspectmode: 'data' } };
    await Plotly.newPlot('plot', traces, layout);
    const wait = (ms) => new Promise((done) => setTimeout(done, ms));
    await new Promise(requestAnimationFrame);
    const start = performance.now();
    let [drawn, first] = [0, 0];
    for (let now = start; now < start + 1000 * (seconds + 1); now = performance.now()) {
        if (!first && now > start + 1000) [first, drawn] = [now, 0];
        const frame = Math.floor((now - start) / 1000 * 60) % motions[0].header.frames;
        const all = motions.map((m, k) => lines(m, frame, k));
        await Plotly.restyle('plot', { x: all.map((l) => l.x), y: all.map((l) => l.y), z: all.map((l) => l.z) });
        await new Promise(requestAnimationFrame);
        drawn++;
    }
    return 1000 * drawn / (performance.now() - first);
}"""


def make_app() -> Dash:
    """A page with the Stage at /, one with an empty Plotly chart at /plotly, and the motion route."""
    dataset = walkers(NAMES, seconds=30.0, fps=60.0)
    app = Dash(__name__, assets_folder=str(ASSETS))
    app.layout = html.Div(player.stage(), style={"height": "780px"})
    player.register(app)
    app.server.register_blueprint(motion_blueprint({"walkers": dataset}.__getitem__))
    script = plotly.offline.get_plotlyjs()

    @app.server.get("/plotly")
    def chart() -> Response:
        return Response(f"<!doctype html><div id='plot'></div><script>{script}</script>", mimetype="text/html")

    return app


def open_view(browser: Browser, address: str) -> Page:
    """A fresh page of the common size."""
    page = browser.new_page(viewport=VIEW)
    page.goto(address)
    return page


def stage_rate(browser: Browser, address: str, n: int, layout: str) -> float:
    """Frames per second of the Stage with ``n`` figures."""
    page = open_view(browser, address)
    page.wait_for_function("window.motionscape.stage?.status === 'empty'")
    items = [{"clip": name, "start": 0, "end": 1800, "label": name} for name in NAMES[:n]]
    page.evaluate("asked => motionscape.stage.show(asked)", {"dataset": "walkers", "items": items, "layout": layout})
    page.wait_for_function("motionscape.stage.status === 'ready' && motionscape.stage.playing")
    rate = page.evaluate(COUNT_FRAMES, SECONDS)
    page.close()
    return rate


def plotly_rate(browser: Browser, address: str, n: int) -> float:
    """Frames per second of Plotly's scatter3d with ``n`` figures: frames really drawn, one after another."""
    page = open_view(browser, f"{address}/plotly")
    rate = page.evaluate(PLOTLY, [SECONDS, list(NAMES[:n])])
    page.close()
    return rate


def fetch_milliseconds(address: str, repeats: int = 15) -> tuple[float, float, int]:
    """Median and worst milliseconds for 30 s of motion over localhost, after one warm-up, and its size in bytes."""
    times, size = [], 0
    for k in range(repeats + 1):
        started = time.perf_counter()
        with urllib.request.urlopen(f"{address}/api/motion/walkers/walk%20{k % len(NAMES)}") as answer:
            size = len(answer.read())
        times.append(1000 * (time.perf_counter() - started))
    return statistics.median(times[1:]), max(times[1:]), size


def main() -> str:
    """Measure, print and return the Markdown section."""
    app = make_app()
    rows = []
    with running(app.server) as address, sync_playwright() as playwright:
        median, worst, size = fetch_milliseconds(address)
        browser = start_chromium(playwright)
        for n in COUNTS:
            side, overlaid = stage_rate(browser, address, n, "side"), stage_rate(browser, address, n, "overlay")
            rows.append((n, side, overlaid, plotly_rate(browser, address, n)))
        version = browser.version
        browser.close()
    body = drawn_body(walkers(NAMES[:1]).clips[0].skeleton)
    lines = [
        "## Stage",
        "",
        f"Frames per second in headless Chromium {version}, software rendering, {VIEW['width']} x {VIEW['height']}; "
        f"skeletons of 31 joints, of which both draw {len(body.names)} points (fingers left out). 60 is the limit.",
        "",
        "| figures | Stage, side by side | Stage, overlaid | Plotly scatter3d | Stage / Plotly |",
        "|---|---|---|---|---|",
        *(f"| {n} | {s:.0f} | {o:.0f} | {p:.1f} | {min(s, o) / p:.0f} x |" for n, s, o, p in rows),
        "",
        f"30 s of motion at 60 frames a second ({size / 1e6:.2f} MB) from the route on localhost: median {median:.0f} "
        f"ms, worst of 15 {worst:.0f} ms.",
        "",
        f"`{COMMAND}`",
    ]
    section = "\n".join(lines)
    print(section)
    return section


if __name__ == "__main__":
    main()
