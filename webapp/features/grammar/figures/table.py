"""How the number of actions changes a grammar: the paper's Table 1, with a chart of it (SYN section 7)."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any, NamedTuple

import plotly.graph_objects as go
from plotly.subplots import make_subplots

from webapp.shell import theme
from webapp.ui.charts import SERIES, themed
from webapp.ui.tables import NUMBER, Row, column


class Point(NamedTuple):
    """The result for one number of actions. F, R, E as in SYN section 4.1; change: of the view, to show the result."""

    actions: int
    frames: int
    segments: int
    F: float
    R: float
    E: float
    rules: float
    phrases: int
    sentences: int
    bits: float
    seconds: float
    key: str = ""
    change: Mapping[str, str] = MappingProxyType({})


def _fixed(digits: int) -> dict[str, Any]:
    return {"valueFormatter": {"function": f"d3.format('.{digits}f')(params.value)"}, **NUMBER}


COLUMNS = [
    column("actions", "Actions", 96, "How many kinds of movements were told apart", sort="asc", **NUMBER),
    column("segments", "Pieces", 90, "Into how many pieces the recordings were cut", **NUMBER),
    column("repeats", "Repeated", 104, "How often an action occurs on average", **_fixed(1)),
    column("F", "Score F", 92, "1 / (w R + (1 - w) E'): the search makes it large", **_fixed(2)),
    column("R", "Reduced to R", 92, "Typical occurrences together, as a share of all motion", **_fixed(3)),
    column("E", "Spread E'", 94, "How far occurrences lie from the typical one of their action", **_fixed(3)),
    column("rules", "Rules", 84, "Ways in which routines and phrases are put together", **_fixed(0)),
    column("phrases", "Phrases", 94, "Parts that rules name", **NUMBER),
    column("sentences", "Routines", 98, "Into how many routines the recordings were divided", **NUMBER),
    column("bits", "Bits", 84, "What it takes to write rules and routines", **_fixed(0)),
    column("seconds", "Time (s)", 96, "How long it took", **_fixed(1)),
]


def rows(points: Sequence[Point]) -> list[Row]:
    """A row for each number of actions; a click shows its result."""
    return [
        {
            **{name: value for name, value in point._asdict().items() if name not in ("key", "change", "frames")},
            "repeats": round(point.segments / max(point.actions, 1), 2),
            "key": str(point.actions),
            "view": dict(point.change),
        }
        for point in points
    ]


def quality(points: Sequence[Point], scheme: str | None, shown: int | None = None) -> go.Figure:
    """F, R and E' over the number of actions, one above another; shown: the number whose result is on the page."""
    figure = make_subplots(rows=3, cols=1, shared_xaxes=True, vertical_spacing=0.07)
    for row, (name, label) in enumerate((("F", "Score F"), ("R", "Reduced to R"), ("E", "Spread E'")), 1):
        figure.add_trace(_line(points, name, label, SERIES[row - 1]), row=row, col=1)
        figure.update_yaxes(title_text=label, row=row, col=1)
    figure = themed(figure, scheme, height=400, showlegend=False)
    figure.update_yaxes(nticks=4)
    return _over_actions(figure, points, scheme, shown, last="x3")


def counts(points: Sequence[Point], scheme: str | None, shown: int | None = None) -> go.Figure:
    """Rules, phrases and routines over the number of actions."""
    figure = go.Figure()
    lines = (("rules", "Rules", SERIES[3]), ("phrases", "Phrases", SERIES[0]), ("sentences", "Routines", SERIES[5]))
    for name, label, colour in lines:
        figure.add_trace(_line(points, name, label, colour))
    figure = themed(figure, scheme, height=400)
    figure.update_yaxes(title_text="How many", rangemode="tozero")
    return _over_actions(figure, points, scheme, shown)


def _line(points: Sequence[Point], name: str, label: str, colour: str) -> go.Scatter:
    return go.Scatter(
        x=[point.actions for point in points],
        y=[getattr(point, name) for point in points],
        customdata=[json.dumps(dict(point.change)) for point in points],
        name=label,
        mode="lines+markers",
        line={"color": colour, "width": 2},
        marker={"size": 8},
        hovertemplate=f"{label} %{{y:.4g}} with %{{x}} actions<extra></extra>",
    )


def _over_actions(
    figure: go.Figure, points: Sequence[Point], scheme: str | None, shown: int | None, last: str = "x"
) -> go.Figure:
    figure.update_xaxes(tickvals=[point.actions for point in points])
    figure.update_layout({f"xaxis{last[1:]}": {"title": {"text": "Number of actions"}}})
    if shown is not None and any(point.actions == shown for point in points):
        colour = theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]["line"]
        figure.add_vline(x=shown, line={"color": colour, "width": 1, "dash": "dash"})
    return figure
