"""The motif graph as an SVG drawing for papers and slides: the same boxes, icons and arrows as on the screen."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from html import escape
from typing import Any
from urllib.parse import unquote

from webapp.shell import theme
from webapp.shell.links import format_link, parse

_MARGIN, _FONT = 60.0, "system-ui, Segoe UI, Roboto, Liberation Sans, Arial, sans-serif"


def graph_svg(elements: Sequence[dict[str, Any]], scheme: str = "light", title: str = "Motif graph") -> str:
    """SVG text of Cytoscape ``elements`` (see figures.graph) in the colours of ``scheme``; lengths in pixels."""
    colours = theme.CANVAS[scheme]
    nodes = {e["data"]["id"]: e for e in elements if "position" in e}
    edges = [e["data"] for e in elements if "source" in e["data"]]
    left, top, width, height = _frame(list(nodes.values()))
    drawn = [_edge(nodes[e["source"]], nodes[e["target"]], e, colours["line"]) for e in edges]
    drawn += [_node(node, scheme, colours) for node in nodes.values()]
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{left:.0f} {top:.0f} {width:.0f} {height:.0f}" '
        f'width="{width:.0f}" height="{height:.0f}" font-family="{_FONT}" font-size="12">'
        f"<title>{escape(title)}</title>"
        f'<rect x="{left:.0f}" y="{top:.0f}" width="{width:.0f}" height="{height:.0f}" fill="{colours["surface"]}"/>'
        f"{''.join(drawn)}</svg>"
    )


def first_graph(props: Mapping[str, Any], link: str) -> str:
    """The graph as plain HTML, for the first picture of a page: boxes that are links, at the places where Cytoscape
    will draw them; props: Cytoscape's. Colours come from the page's style sheet.
    """
    elements = props.get("elements") or ()
    nodes = {e["data"]["id"]: e for e in elements if "position" in e}
    xs = [n["position"]["x"] + s * n["data"]["width"] / 2 for n in nodes.values() for s in (-1, 1)] or [0.0]
    ys = [n["position"]["y"] + s * n["data"]["height"] / 2 for n in nodes.values() for s in (-1, 1)] or [0.0]
    edges = [e["data"] for e in elements if "source" in e["data"]]
    drawn = [_edge(nodes[e["source"]], nodes[e["target"]], e, "var(--line)") for e in edges]
    shown, _ = parse(*link.partition("?")[::2])
    drawn += [
        _linked_box(node, format_link(replace(shown, selection={"motif": node["data"]["motif"]})))
        for node in nodes.values()
    ]
    view = f"{min(xs):.0f} {min(ys):.0f} {max(xs) - min(xs):.0f} {max(ys) - min(ys):.0f}"
    return f'<div id="{props["id"]}" class="first-graph"><svg viewBox="{view}">{"".join(drawn)}</svg></div>'


def _linked_box(node: Mapping[str, Any], link: str) -> str:
    """A box of the first picture, with its icon as lines that a style sheet can colour."""
    data, x, y = node["data"], node["position"]["x"], node["position"]["y"]
    side = 0.86 * min(data["width"], data["height"])
    icon = unquote(data.get("icon_light", "").partition(",")[2])
    lines = re.sub(r' width="[\d.]+" height="[\d.]+"', f" {_box(x, y, side, side)}", icon, count=1)
    box = f'<rect {_box(x, y, data["width"], data["height"])} rx="7" stroke="{data["colour"]}"/>'
    return f'<a href="{escape(link)}" aria-label="Motif {escape(data["label"])}">{box}{lines}</a>'


def _frame(nodes: Sequence[dict[str, Any]]) -> tuple[float, float, float, float]:
    """Left, top, width and height of all boxes with a margin for loops and labels."""
    if not nodes:
        return 0.0, 0.0, 2 * _MARGIN, 2 * _MARGIN
    xs = [n["position"]["x"] + s * n["data"]["width"] / 2 for n in nodes for s in (-1, 1)]
    ys = [n["position"]["y"] + s * n["data"]["height"] / 2 for n in nodes for s in (-1, 1)]
    left, top = min(xs) - _MARGIN, min(ys) - _MARGIN
    return left, top, max(xs) + _MARGIN - left, max(ys) + _MARGIN - top


def _node(node: dict[str, Any], scheme: str, colours: dict[str, str]) -> str:
    data, x, y = node["data"], node["position"]["x"], node["position"]["y"]
    w, h = data["width"], data["height"]
    dash = ' stroke-dasharray="5 3"' if "one-way" in node.get("classes", "") else ""
    look = f'fill="{colours["surface"]}" stroke="{data["colour"]}" stroke-width="2"{dash}'
    box = f'<rect {_box(x, y, w, h)} rx="7" {look}/>'
    icon = data.get(f"icon_{scheme}")
    side = 0.86 * min(w, h)
    image = f'<image href="{escape(icon)}" {_box(x, y, side, side)}/>' if icon else ""
    label = f'<text x="{x:.1f}" y="{y + h / 2 + 15:.1f}" text-anchor="middle" fill="{colours["text"]}">'
    return f"{box}{image}{label}{escape(data['label'])}</text>"


def _box(x: float, y: float, width: float, height: float) -> str:
    return f'x="{x - width / 2:.1f}" y="{y - height / 2:.1f}" width="{width:.1f}" height="{height:.1f}"'


def _edge(source: dict[str, Any], target: dict[str, Any], data: dict[str, Any], colour: str) -> str:
    pen = f'fill="none" stroke="{colour}" stroke-width="{data["width"]}"'
    a, b = (source["position"]["x"], source["position"]["y"]), (target["position"]["x"], target["position"]["y"])
    if source is target:
        x, y = a[0] - source["data"]["width"] / 2, a[1] - source["data"]["height"] / 2
        return f'<path d="M{x:.1f} {y + 14:.1f}C{x - 34:.1f} {y:.1f} {x:.1f} {y - 34:.1f} {x + 14:.1f} {y:.1f}" {pen}/>'
    length = math.dist(a, b) or 1.0
    bend = min(26.0, length / 8)  # the way back bends to the other side
    middle = (
        (a[0] + b[0]) / 2 - bend * (b[1] - a[1]) / length,
        (a[1] + b[1]) / 2 + bend * (b[0] - a[0]) / length,
    )
    points = " ".join(f"{x:.1f},{y:.1f}" for x, y in (middle, _border(target, middle)))
    start = "{:.1f} {:.1f}".format(*_border(source, middle))
    head = _head(middle, _border(target, middle), data["width"], colour)
    return f'<path d="M{start}Q{points}" {pen}/>{head}'


def _border(node: dict[str, Any], towards: tuple[float, float]) -> tuple[float, float]:
    """Where a line from the middle of a box towards a point leaves the box."""
    x, y = node["position"]["x"], node["position"]["y"]
    dx, dy = towards[0] - x, towards[1] - y
    w, h = node["data"]["width"] / 2 + 2, node["data"]["height"] / 2 + 2
    share = min(w / abs(dx) if dx else math.inf, h / abs(dy) if dy else math.inf)
    return (x, y) if math.isinf(share) else (x + share * dx, y + share * dy)


def _head(before: tuple[float, float], tip: tuple[float, float], width: float, colour: str) -> str:
    angle, size = math.atan2(tip[1] - before[1], tip[0] - before[0]), 6 + 1.5 * width
    corners = [tip] + [(tip[0] - size * math.cos(angle + s), tip[1] - size * math.sin(angle + s)) for s in (0.4, -0.4)]
    return f'<polygon points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in corners)}" fill="{colour}"/>'
