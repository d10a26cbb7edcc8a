"""Helpers of the Map page's browser tests: a small map, and where its nodes are drawn."""

from __future__ import annotations

import pytest
from playwright.sync_api import Page

from core import analyses
from tests.browser.app import PATIENCE
from webapp.shell import settings

SMALL = {"map-grid": "12x11", "map-samples": "500", "map-analysis_fps": "15"}
QUERY = "&".join(f"{key}={value}" for key, value in SMALL.items())


@pytest.fixture
def mapped(workspace):
    """The demo's map, and the motif graph that the workspace has anyway."""
    return analyses.run(workspace, settings.request_of("map", "demo", SMALL))


def open_map(show, more: str = "", **options) -> Page:
    page = show(f"/map?dataset=demo&{QUERY}{more}", **options)
    wait_for_map(page)
    return page


def wait_for_map(page: Page) -> None:
    """Until the heatmap is drawn, what lies over it fits, and nothing moves any more."""
    page.wait_for_function(
        """() => {
            const drawn = motionscape.map.state.map && motionscape.map.state.overlay?.scale > 0
                && document.querySelector('#map-graph .js-plotly-plot .hm image')
                && document.querySelector('#map-explanation').textContent
                && !document.querySelector('#map-status').textContent;
            if (!drawn) return false;
            const { x, y, width } = motionscape.map.state.overlay.svg.getBoundingClientRect();
            const now = [x, y, width, motionscape.map.state.overlay.scale].join(' ');
            if (window.stoodAt !== now) [window.stoodAt, window.stoodSince] = [now, performance.now()];
            return performance.now() - window.stoodSince > 250;
        }""",
        timeout=PATIENCE,
    )


def place_of(page: Page, x: float, y: float) -> tuple[float, float]:
    """Where a node is drawn, in pixels of the page."""
    return tuple(
        page.evaluate(
            """([x, y]) => {
                const { overlay } = motionscape.map.state, box = overlay.svg.getBoundingClientRect();
                const of = (name) => Number(overlay.view.getAttribute(name));
                return [box.x + of('x') + (x + 0.5) * overlay.scale, box.y + of('y') + (y + 0.5) * overlay.scale];
            }""",
            [x, y],
        )
    )


def click_node(page: Page, x: int, y: int) -> None:
    page.mouse.click(*place_of(page, x, y))


def hits_of(page: Page) -> list[tuple[str, int, int]]:
    return [
        (hit["clip"], hit["start"], hit["end"])
        for hit in page.evaluate("motionscape.map.state.hits.map((hit) => motionscape.map.state.map.segment(hit))")
    ]


def two_keys(motion_map) -> list[tuple[int, int]]:
    """Two postures that a clip passes one after the other."""
    nodes = motion_map.nodes_of(motion_map.clips[0])
    return [tuple(map(int, nodes[20])), tuple(map(int, nodes[50]))]
