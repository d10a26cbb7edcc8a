"""The parse tree of a sentence as an SVG drawing: actions in a row at the bottom, the phrases they form above them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from html import escape
from typing import TYPE_CHECKING, NamedTuple

from webapp.features.grammar.figures.actions import ink_on

if TYPE_CHECKING:
    from core.grammar.trees import Node, Symbol

LEAF, GAP, ROW, BOX = 46, 6, 46, 24  # pixels: width of an action, gap beside it, from level to level, height of a box
PICTURE = 44  # height of the posture below an action
_MARGIN, _LETTER = 10, 6.6
_FONT = "system-ui, Segoe UI, Roboto, Liberation Sans, Arial, sans-serif"
PAGE = {name: f"var(--{name})" for name in ("text", "surface", "accent", "selected")}
PAGE |= {"line": "color-mix(in srgb, var(--muted) 55%, transparent)"}
"""Colours of a drawing that stands in the page itself and follows its theme."""


class Placed(NamedTuple):
    """A node with its place: path of child numbers from the root, centre x in pixels, level from the top."""

    node: Node
    path: tuple[int, ...]
    x: float
    level: int


def placed(root: Node) -> list[Placed]:
    """All nodes of the tree that have actions under them, with their places; parents before children."""
    return list(_place(root, ()))


def _place(node: Node, path: tuple[int, ...]) -> Iterator[Placed]:
    if node.end == node.start:
        return  # an optional part that is left out
    yield Placed(node, path, _MARGIN + (LEAF + GAP) * (node.start + node.end) / 2, len(path))
    for number, child in enumerate(node.children):
        yield from _place(child, (*path, number))


def tree_svg(
    root: Node,
    names: Callable[[Symbol], str],
    tones: Mapping[int, str],
    *,
    colours: Mapping[str, str] = PAGE,
    pictures: Sequence[str] = (),
    marked: tuple[int, ...] | None = None,
    picked: int | None = None,
    title: str = "How it is built",
) -> str:
    """SVG text of a tree over the actions [0, n). names: the text of each box. tones: action -> its colour.

    pictures: address of a posture for every action, in order, or none.

    marked: path of the phrase that is chosen, picked: number of the chosen leaf. Every node carries ``data-path``
    (child numbers from the root, joined by dots), ``data-first`` and ``data-end`` (its leaves).
    """
    nodes = placed(root)
    depth = max(one.level for one in nodes)
    width = 2 * _MARGIN + (LEAF + GAP) * max(root.end, 1)
    height = 2 * _MARGIN + ROW * depth + BOX + (PICTURE + 4 if pictures else 0)
    by_path = {one.path: one for one in nodes}
    lines = [_line(by_path[one.path[:-1]], one, depth, colours) for one in nodes if one.path]
    ground = f'<rect width="{width}" height="{height}" fill="{colours["surface"]}"/>' if colours is not PAGE else ""
    boxes = [_box(one, names(one.node.symbol), depth, tones, colours, marked, picked) for one in nodes]
    images = [_picture(one, depth, pictures) for one in nodes if pictures and one.node.is_leaf]
    chosen = _ground(by_path.get(marked), depth, height, colours) if marked is not None else ""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        f'font-family="{_FONT}" font-size="12"><title>{escape(title)}</title>'
        f"{ground}{chosen}{''.join(lines)}{''.join(boxes)}{''.join(images)}</svg>"
    )


def _y(one: Placed, depth: int) -> float:
    """Top of a node's box: actions stand in the last row, whatever the depth of their phrase."""
    return _MARGIN + ROW * (depth if one.node.is_leaf else one.level)


def _ground(one: Placed | None, depth: int, height: float, colours: Mapping[str, str]) -> str:
    """A tinted background behind all that the chosen phrase covers."""
    if one is None:
        return ""
    left, right = (_MARGIN + (LEAF + GAP) * at for at in (one.node.start, one.node.end))
    top = _y(one, depth) - 5
    return (
        f'<rect class="tree-chosen" x="{left}" y="{top}" width="{right - left}" height="{height - top - 3}" rx="8" '
        f'fill="{colours["selected"]}" stroke="{colours["accent"]}" stroke-dasharray="4 3"/>'
    )


def _line(above: Placed, one: Placed, depth: int, colours: Mapping[str, str]) -> str:
    y0, y1 = _y(above, depth) + BOX, _y(one, depth)
    bend = min(ROW - BOX, y1 - y0)
    return (
        f'<path d="M{above.x:g} {y0:g}C{above.x:g} {y0 + bend:g} {one.x:g} {y0:g} {one.x:g} {y0 + bend:g}V{y1:g}" '
        f'fill="none" stroke="{colours["line"]}" stroke-width="1.4"/>'
    )


def _box(
    one: Placed,
    name: str,
    depth: int,
    tones: Mapping[int, str],
    colours: Mapping[str, str],
    marked: tuple[int, ...] | None,
    picked: int | None,
) -> str:
    node, leaf, y = one.node, one.node.is_leaf, _y(one, depth)
    count = node.end - node.start
    room = (LEAF + GAP) * count - GAP  # above its own actions: more would cover its neighbours
    text = name if leaf or _width(name) <= room else name.replace("Phrase ", "P")
    text = _short(text, room)
    width = LEAF if leaf else min(max(LEAF - 8, _width(text)), room)
    here = one.path == marked or (leaf and node.start == picked)
    edge, pen = (colours["text"], 2.4) if here else (colours["line"], 1.2)
    tone = tones.get(int(node.symbol), "#888888") if leaf else ""
    fill, ink = (tone, ink_on(tone)) if leaf else (colours["surface"], colours["text"])
    path = ".".join(map(str, one.path))
    kind = "tree-leaf" if leaf else "tree-phrase"
    label = escape(name if leaf else f"{name}: {count} action{'s' if count != 1 else ''}")
    return (
        f'<g class="tree-node {kind}" data-path="{path}" data-first="{node.start}" data-end="{node.end}" tabindex="-1" '
        f'role="button" aria-label="{label}"><title>{label}</title>'
        f'<rect x="{one.x - width / 2:g}" y="{y:g}" width="{width:g}" height="{BOX}" rx="7" fill="{fill}" '
        f'stroke="{edge}" stroke-width="{pen}"/>'
        f'<text x="{one.x:g}" y="{y + BOX / 2 + 4:g}" text-anchor="middle" fill="{ink}" '
        f'font-weight="600">{escape(text)}</text></g>'
    )


def _picture(one: Placed, depth: int, pictures: Sequence[str]) -> str:
    address = escape(pictures[one.node.start], quote=True)
    place = f'x="{one.x - PICTURE / 2:g}" y="{_y(one, depth) + BOX + 4:g}" width="{PICTURE}" height="{PICTURE}"'
    return f'<image href="{address}" {place}/>'


def _width(text: str) -> float:
    """Width of a phrase's box around a text, in pixels."""
    return _LETTER * len(text) + 18


def _short(text: str, width: float) -> str:
    most = max(2, int((width - 8) / _LETTER))
    return text if len(text) <= most else text[: most - 1] + "…"
