"""The timeline as an SVG drawing for papers and slides: rows, labels and motions as on the screen."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape
from typing import Any

from webapp.shell import theme

_FONT = "system-ui, Segoe UI, Roboto, Liberation Sans, Arial, sans-serif"
_WIDTH, _MARGIN, _NAMES = 1200.0, 16.0, 170.0  # pixels
_LABELS, _MOTIONS, _GAP = 13.0, 18.0, 9.0  # heights of the bands, and from row to row
_LETTER = 6.2  # about the width of a letter at the bands' size


def timeline_svg(
    data: Mapping[str, Any], order: str = "name", scale: str = "same", motif: int | None = None, scheme: str = "light"
) -> str:
    """SVG text of a :func:`webapp.ui.timeline.timeline`, lengths in pixels, in the colours of ``scheme``.

    order: "name", "share" (least in motifs first) or "chosen" (the clips with most motions of ``motif`` first);
    scale: "same" for all clips, or "fill" the width with each; motions of other motifs than ``motif`` are faint.
    """
    colours = theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]
    rows = _ordered(data["rows"], order, motif)
    longest = max((row["seconds"] for row in rows), default=0.0) or 1.0
    labelled = bool(data["actions"])
    step = (_LABELS + 2 if labelled else 0) + _MOTIONS + _GAP
    legend, top = _legend(data, colours)
    drawn = [
        _row(row, data, top + k * step, (row["seconds"] if scale == "fill" else longest) or 1.0, motif, colours)
        for k, row in enumerate(rows)
    ]
    height = top + len(rows) * step + _MARGIN
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:.0f} {height:.0f}" width="{_WIDTH:.0f}" '
        f'height="{height:.0f}" font-family="{_FONT}" font-size="12"><title>{escape(_title(data))}</title>'
        f'<rect width="{_WIDTH:.0f}" height="{height:.0f}" fill="{colours["surface"]}"/>{legend}{"".join(drawn)}</svg>'
    )


def _title(data: Mapping[str, Any]) -> str:
    return f"Motifs of {data['dataset']}, clip by clip"


def _ordered(rows: list[dict[str, Any]], order: str, motif: int | None) -> list[dict[str, Any]]:
    if order == "share":
        return sorted(rows, key=lambda row: row["share"])
    if order == "chosen" and motif is not None:
        return sorted(rows, key=lambda row: -sum(motion[2] == motif for motion in row["motions"]))
    return rows


def _legend(data: Mapping[str, Any], colours: Mapping[str, str]) -> tuple[str, float]:
    """The names of the labels in their colours, in lines, and where the rows begin below them."""
    x, y, drawn = _MARGIN, _MARGIN, []
    for action, tone in zip(data["actions"], data["colours"], strict=True):
        width = 24 + 7 * len(action)
        if x + width > _WIDTH - _MARGIN and x > _MARGIN:
            x, y = _MARGIN, y + 18
        drawn.append(
            f'<rect x="{x:.0f}" y="{y:.0f}" width="10" height="10" rx="2" fill="{tone}"/>'
            f'<text x="{x + 15:.0f}" y="{y + 9:.0f}" fill="{colours["text"]}">{escape(action)}</text>'
        )
        x += width
    return "".join(drawn), y + (26 if drawn else 0)


def _row(
    row: Mapping[str, Any],
    data: Mapping[str, Any],
    y: float,
    span: float,
    motif: int | None,
    colours: Mapping[str, str],
) -> str:
    left, width = _MARGIN + _NAMES, _WIDTH - 2 * _MARGIN - _NAMES
    share = f"{100 * row['share']:.0f} %"
    band = y + (_LABELS + 2 if data["actions"] else 0)
    drawn = [
        f'<text x="{_MARGIN:.0f}" y="{band + 13:.1f}" fill="{colours["text"]}">{escape(row["brief"])}'
        f"<title>{escape(row['clip'])}</title></text>"
        f'<text x="{left - 10:.0f}" y="{band + 13:.1f}" fill="{colours["muted"]}" text-anchor="end">{share}</text>'
        f'<rect x="{left:.1f}" y="{band:.1f}" width="{width * row["seconds"] / span:.1f}" height="{_MOTIONS}" '
        f'fill="{colours["soft"]}"/>'
    ]

    def block(start: float, end: float, top: float, height: float, look: str, ink: str, text: str) -> None:
        x, wide = left + width * start / span, max(width * (end - start) / span, 1.0)
        place = f'x="{x:.1f}" y="{top:.1f}" width="{wide:.1f}" height="{height}"'
        drawn.append(f"<rect {place} {look}/>")
        if _LETTER * len(text) + 4 < wide:
            at = f'x="{x + 3:.1f}" y="{top + height - 4:.1f}"'
            drawn.append(f'<text {at} font-size="10.5" fill="{ink}">{escape(text)}</text>')

    for start, end, action in row["labels"]:
        look = f'fill="{data["colours"][action]}" fill-opacity=".38"'
        block(start, end, y, _LABELS, look, colours["text"], data["actions"][action])
    for start, end, number, _ in row["motions"]:
        faint = ' opacity=".3"' if motif is not None and number != motif else ""
        look = f'fill="{data["motifs"][str(number)]["colour"]}" stroke="{colours["surface"]}" stroke-width=".5"{faint}'
        block(start, end, band, _MOTIONS, look, "#ffffff", str(number))
    return "".join(drawn)
