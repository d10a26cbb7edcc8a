"""Charts of one clip: curves over time with bands below them, and its path seen from above.

Plain Plotly documents. Everything over time shares one time axis, so that assets/clip/*.mjs can lay a cursor and the
selected range over panels and bands alike; what these scripts must know stands in ``layout.meta``.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from html import escape
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np

from core.editing.contacts import runs
from core.editing.curves import TRAVEL, ClipCurves, Curve
from core.mocap.anatomy import SIDES
from core.poses.angles import JOINTS
from core.sequences.envelope import envelope
from webapp.features.clip.clips import Choice, joint_words, side_of
from webapp.shell import theme

MOST_POINTS = 2400  # of a line: more than one for each pixel, the margins included
MOST_MARKS = 150  # of a band
AROUND = 0.5  # visible spans drawn beyond either end, so that panning and zooming out show curves immediately
PANEL, ROW, GAP, TOP, BOTTOM, LEFT, RIGHT = 132, 20, 24, 22, 40, 78, 12  # pixels
DASHES = ("solid", "6px,3px", "1.5px,3px", "9px,3px,2px,3px")
AXES = {"X": "#d9534f", "Y": "#3a9b5c", "Z": "#4a7cd8"}  # the colours 3D programs give to axes
SIDE_COLOURS = {  # as the Stage colours its figures
    "light": {"left": "#2a78d0", "right": "#e0701a", "centre": "#6d7686"},
    "dark": {"left": "#5aa9f5", "right": "#f2994a", "centre": "#a9b3c4"},
}
STANCE = {"light": 0.55, "dark": 0.7}

Document = dict[str, Any]


class Line(NamedTuple):
    """A curve as it is drawn: the words of the legend (``tip``: which way is positive), colour and dash."""

    curve: Curve
    label: str
    tip: str
    colour: str
    dash: str


class Panel(NamedTuple):
    """Curves that share a unit and an axis."""

    title: str
    unit: str
    lines: tuple[Line, ...]


class Block(NamedTuple):
    """A stretch of frames in a band; a click selects it, or the frames ``picks``."""

    start: int
    end: int
    text: str
    colour: str
    picks: tuple[int, int] | None = None


class Mark(NamedTuple):
    """A moment in a band."""

    frame: int
    symbol: str
    colour: str
    text: str


@dataclass(frozen=True)
class Band:
    """A row below the panels."""

    title: str
    blocks: tuple[Block, ...]
    marks: tuple[Mark, ...] = ()


def panels_of(curves: Sequence[Curve], chosen: Choice, scheme: str) -> tuple[Panel, ...]:
    """Panels for the curves of a chart: left and right of a joint share one."""
    if chosen.chart == "speeds":
        return (Panel("Speed", "m/s", tuple(_speed_line(k, curve, scheme) for k, curve in enumerate(curves))),)
    if chosen.chart == "contacts":
        colours = SIDE_COLOURS[scheme]
        lines = (
            Line(c, joint_words(c.part), "above where it is when it stands", colours[side_of(c.part)], "solid")
            for c in curves
        )
        return (Panel("Foot height", "m", tuple(lines)),)
    if chosen.kind == "file":
        return tuple(
            Panel(part, "deg", tuple(Line(c, f"{part} {c.name}", "", AXES[c.name[0]], "solid") for c in group))
            for part, group in groupby(curves, lambda curve: curve.part)
        )
    by_joint: dict[str, list[Curve]] = {}
    for curve in curves:
        by_joint.setdefault(_without_side(curve.part), []).append(curve)
    return tuple(
        Panel(joint_words(name), "deg", tuple(_angle_line(curve, group, scheme) for curve in group))
        for name, group in by_joint.items()
    )


def _without_side(part: str) -> str:
    return part if side_of(part) == "centre" else part.partition("_")[2]


def _angle_line(curve: Curve, group: Sequence[Curve], scheme: str) -> Line:
    side, names = side_of(curve.part), list(dict.fromkeys(c.name for c in group))
    nth = names.index(curve.name)
    positive = next(c.positive for c in JOINTS[curve.part].channels if c.name == curve.name)
    if side == "centre":  # on one side only: a colour for each angle
        return Line(curve, f"{joint_words(curve.part)} {curve.name}", positive, theme.COMPONENTS[nth], "solid")
    label = f"{joint_words(curve.part)} {curve.name}"
    return Line(curve, label, positive, SIDE_COLOURS[scheme][side], DASHES[nth % len(DASHES)])


def _speed_line(k: int, curve: Curve, scheme: str) -> Line:
    label = "Travel of the pelvis" if curve.part == TRAVEL else joint_words(curve.part)
    tip = "along the ground" if curve.part == TRAVEL else "in the world"
    return Line(curve, label, tip, theme.COMPONENTS[k % len(theme.COMPONENTS)], DASHES[k // len(theme.COMPONENTS) % 4])


def foot_bands(curves: ClipCurves, scheme: str) -> list[Band]:
    """A band a foot: when it stands, and its heel strikes and toe-offs where gait was found."""
    bands = []
    for k, side in enumerate(SIDES):
        colour = SIDE_COLOURS[scheme][side]
        blocks = tuple(
            Block(int(a), int(b), "", _faded(colour, STANCE[scheme])) for a, b in runs(curves.contacts[:, k])
        )
        marks = tuple(
            Mark(
                e.frame,
                *(
                    ("triangle-down", colour, "heel strike")
                    if e.kind == "strike"
                    else ("triangle-up-open", colour, "toe-off")
                ),
            )
            for e in curves.gait.events
            if e.side == side
        )
        bands.append(Band(f"{side.capitalize()} foot", blocks, marks))
    return bands


def lanes(title: str, blocks: Iterable[Block]) -> list[Band]:
    """The blocks in as few bands as possible without overlaps."""
    rows: list[list[Block]] = []
    for block in sorted(blocks):
        row = next((row for row in rows if row[-1].end <= block.start), None)
        if row is None:
            rows.append(row := [])
        row.append(block)
    return [Band(title if not k else "", tuple(row)) for k, row in enumerate(rows)]


def time_chart(
    curves: ClipCurves, panels: Sequence[Panel], bands: Sequence[Band], chosen: Choice, scheme: str
) -> Document:
    """Panels above bands on one time axis, in seconds; curves are drawn half a span beyond either end."""
    clip, colours = curves.clip, theme.CANVAS[scheme]
    low, high = chosen.span or (0.0, max((clip.n_frames - 1) / clip.fps, 1 / clip.fps))
    room = (high - low) * AROUND
    first, last = (
        max(int((low - room) * clip.fps) - 1, 0),
        min(int(np.ceil((high + room) * clip.fps)) + 2, clip.n_frames),
    )
    height = TOP + BOTTOM + len(panels) * (PANEL + GAP) + len(bands) * ROW - (0 if bands else GAP)
    inner = height - TOP - BOTTOM
    layout = _layout(colours, height)
    layout["xaxis"] |= {
        "range": [low, high],
        "title": {"text": "Time (s)", "standoff": 6, "font": {"size": 12}},
        "side": "bottom",
        "position": 0,
    }
    layout["xaxis"] |= {"anchor": "free", "hoverformat": ".2f"}
    data, at = [], 0
    for k, panel in enumerate(panels):
        axis = f"yaxis{k + 1 if k else ''}"
        layout[axis] = _axis(colours) | {"domain": _domain(at, at + PANEL, inner), "nticks": 5, "fixedrange": True}
        layout["annotations"].append(_heading(f"{escape(panel.title)} ({panel.unit})", at, inner, colours))
        data += [_trace(line, axis, first, last, clip.fps) for line in panel.lines]
        at += PANEL + GAP
    thinned = any(len(trace["x"]) < last - first for trace in data)
    if bands:
        axis = f"yaxis{len(panels) + 1 if panels else ''}"
        layout[axis] = _band_axis(bands, _domain(at, at + ROW * len(bands), inner), colours)
        shown = [_within(band, first, last) for band in bands]
        data += [trace for row, band in enumerate(shown) for trace in _band(row, band, axis, clip.fps)]
    layout["meta"] = {"kind": "time", "clip": clip.name, "fps": clip.fps, "frames": clip.n_frames, "thinned": thinned}
    return {"data": data, "layout": layout}


def _within(band: Band, first: int, last: int) -> Band:
    """The part of a band within these frames; marks only where there is room to tell them apart."""
    blocks = tuple(block for block in band.blocks if block.start < last and block.end > first)
    marks = tuple(mark for mark in band.marks if first <= mark.frame < last)
    return Band(band.title, blocks, marks if len(marks) <= MOST_MARKS else ())


def _trace(line: Line, axis: str, first: int, last: int, fps: float) -> Document:
    values = line.curve.values[first:last]
    drawn = envelope(values, MOST_POINTS)
    return {
        "type": "scatter",
        "mode": "lines",
        "name": line.label,
        "x": np.round((first + drawn) / fps, 4).tolist(),
        "y": [round(float(v), 3) for v in values[drawn]],
        "yaxis": axis.replace("axis", ""),
        "line": {"color": line.colour, "width": 1.6, "dash": line.dash},
        "hoverinfo": "skip",
        "showlegend": False,
    }


def _band(row: int, band: Band, axis: str, fps: float) -> list[Document]:
    common = {"yaxis": axis.replace("axis", ""), "showlegend": False, "hoverlabel": {"namelength": 0}}
    common |= {"hovertemplate": "%{customdata}<extra></extra>"}
    traces: list[Document] = []
    if band.blocks:
        look = (
            _named_blocks(row, band, fps) if any(block.text for block in band.blocks) else _plain_blocks(row, band, fps)
        )
        traces.append(
            common | look | {"meta": {"row": row, "picks": [list(b.picks or (b.start, b.end)) for b in band.blocks]}}
        )
    if band.marks:
        colours = [mark.colour for mark in band.marks]
        traces.append(
            common
            | {
                "type": "scatter",
                "mode": "markers",
                "x": [round(m.frame / fps, 4) for m in band.marks],
                "y": [row] * len(band.marks),
                "marker": {
                    "symbol": [m.symbol for m in band.marks],
                    "color": colours,
                    "size": 9,
                    "line": {"width": 1.4, "color": colours},
                },
                "customdata": [f"{m.text}, frame {m.frame}" for m in band.marks],
            }
        )
    return traces


def _plain_blocks(row: int, band: Band, fps: float) -> Document:
    """Blocks without text as one broken line, which draws thousands of them as fast as a few."""
    ends = [[round(b.start / fps, 4), round(b.end / fps, 4), None] for b in band.blocks]
    return {
        "type": "scatter",
        "mode": "lines",
        "x": [x for stretch in ends for x in stretch],
        "y": [row, row, None] * len(ends),
        "line": {"color": band.blocks[0].colour, "width": ROW - 5},
        "connectgaps": False,
        "hoverinfo": "skip",
        "hovertemplate": None,
    }


def _named_blocks(row: int, band: Band, fps: float) -> Document:
    return {
        "type": "bar",
        "orientation": "h",
        "base": [round(b.start / fps, 4) for b in band.blocks],
        "x": [round((b.end - b.start) / fps, 4) for b in band.blocks],
        "y": [row] * len(band.blocks),
        "width": 0.88,
        "marker": {"color": [b.colour for b in band.blocks], "line": {"width": 0}},
        "text": [escape(b.text) for b in band.blocks],
        "textposition": "inside",
        "insidetextanchor": "start",
        "textangle": 0,
        "textfont": {"size": 11},
        "customdata": [f"{escape(b.text)}<br>{b.start / fps:.2f} to {b.end / fps:.2f} s" for b in band.blocks],
    }


def _band_axis(bands: Sequence[Band], domain: list[float], colours: dict[str, str]) -> Document:
    return _axis(colours) | {
        "domain": domain,
        "range": [len(bands) - 0.5, -0.5],
        "tickvals": list(range(len(bands))),
        "ticktext": [band.title for band in bands],
        "showgrid": False,
        "zeroline": False,
        "fixedrange": True,
    }


def _domain(top: float, bottom: float, inner: float) -> list[float]:
    return [round(max(1 - bottom / inner, 0.0), 5), round(1 - top / inner, 5)]


def _heading(text: str, at: float, inner: float, colours: dict[str, str]) -> Document:
    place = {"xref": "paper", "yref": "paper", "x": 0, "y": 1 - at / inner, "xanchor": "left", "yanchor": "bottom"}
    return place | {
        "text": text,
        "showarrow": False,
        "yshift": 1,
        "xshift": 0,
        "font": {"size": 12, "color": colours["muted"]},
    }


def _axis(colours: dict[str, str]) -> Document:
    look = {"gridcolor": colours["soft"], "zerolinecolor": colours["line"], "linecolor": colours["line"]}
    return look | {"tickfont": {"color": colours["muted"], "size": 11}, "zerolinewidth": 1, "automargin": False}


def _layout(colours: dict[str, str], height: int) -> Document:
    clear = "rgba(0,0,0,0)"
    return {
        "height": height,
        "margin": {"l": LEFT, "r": RIGHT, "t": TOP, "b": BOTTOM, "pad": 0},
        "paper_bgcolor": clear,
        "plot_bgcolor": clear,
        "font": {"color": colours["text"], "size": 12, "family": "inherit"},
        "xaxis": _axis(colours) | {"showgrid": True, "zeroline": False},
        "annotations": [],
        "hovermode": "closest",
        "dragmode": False,
        "barmode": "overlay",
        "uniformtext": {"mode": "hide", "minsize": 9},
        "hoverlabel": {
            "bgcolor": colours["surface"],
            "bordercolor": colours["line"],
            "font": {"color": colours["text"]},
        },
    }


def _faded(colour: str, share: float) -> str:
    red, green, blue = (int(colour[k : k + 2], 16) for k in (1, 3, 5))
    return f"rgba({red},{green},{blue},{share:g})"
