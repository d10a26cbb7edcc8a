"""Four ways of making new motion compared, as a table and a chart (SYN section 7)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import plotly.graph_objects as go
from plotly.subplots import make_subplots

from webapp.shell import theme
from webapp.ui.charts import SERIES, themed
from webapp.ui.tables import NUMBER, WRAPPED, Row, column, decimals

if TYPE_CHECKING:
    from core.synthesis.bakeoff import Contender

NAMES = {  # of the ways in core/synthesis/bakeoff.py
    "grammar": "These rules",
    "state machine": "Only what follows next",
    "sequitur": "Only what is repeated",
    "motif walk": "Walk on the motif graph",
}
HELP = {
    "grammar": "The rules of this page.",
    "state machine": "A chain: from each action to any action that ever came after it.",
    "sequitur": "Strings that occur again and again, word for word (Sequitur).",
    "motif walk": "Random walks from motif to motif, as on the Motifs page; its strings are motifs, not actions.",
}


class Measure(NamedTuple):
    """A figure of the contenders: its field, name, unit (% or what stands behind the number), and what it means."""

    field: str
    name: str
    unit: str
    digits: int
    help: str


MEASURES = (
    Measure("accepted", "Unseen accepted", "%", 0, "Share of held-out routines it could have made. More is better."),
    Measure("shuffled", "Shuffled accepted", "%", 0, "The same of these routines in random order. Less is better."),
    Measure("bits", "Bits a routine", "", 0, "What rules and routines take to write down, for each routine."),
    Measure("new", "New", "%", 0, "Share of its routines by chance that nobody performed."),
    Measure("blends", "Blends a minute", "", 1, "How often its motion passes from one piece into another."),
    Measure("seam_speed", "Fastest in blends", "m/s", 2, "Speed of the fastest joint where two pieces are blended."),
    Measure("source_speed", "In recordings", "m/s", 2, "Speed of the fastest joint in the recordings used."),
    Measure("skate", "Foot skate", "cm/s", 2, "How far standing feet slide in a second of contact."),
    Measure("skate_plain", "By blending alone", "cm/s", 2, "The same where feet are not kept in place."),
    Measure("skate_source", "Skate of recordings", "cm/s", 2, "The same in the recordings used."),
)  # fmt: skip
_BY_FIELD = {measure.field: measure for measure in MEASURES}
_PLOTS = (  # one small chart each: the figure, and a second one drawn as a mark on its bars
    ("accepted", "shuffled", "Unseen accepted (%)<br>◆ shuffled"),
    ("bits", None, "Bits a routine"),
    ("new", None, "New routines (%)"),
    ("blends", None, "Blends a minute"),
    ("seam_speed", "source_speed", "Fastest joint (m/s)<br>◆ recordings"),
    ("skate", "skate_plain", "Foot skate (cm/s)<br>◆ blending alone"),
)


def shown_value(contender: Contender, field: str) -> float | None:
    """A figure in the unit people read; None where it could not be measured."""
    value = getattr(contender, field)
    factor = {"%": 100, "cm/s": 100}.get(_BY_FIELD[field].unit, 1)
    return None if math.isnan(value) else float(value) * factor


def columns() -> list[dict[str, Any]]:
    """The way, its rules, and every figure."""
    numbers = [
        column(m.field, f"{m.name} ({m.unit})" if m.unit else m.name, 112, m.help, **WRAPPED, **decimals(m.digits))
        for m in MEASURES
    ]
    rules = column("rules", "Rules", 84, "Rules, transitions, or arrows of the graph", **NUMBER)
    return [column("name", "Way", 190, tooltipField="help", pinned="left"), rules, *numbers]


def rows(contenders: Sequence[Contender]) -> list[Row]:
    """A row for each way."""
    return [
        {
            "key": c.name,
            "name": NAMES.get(c.name, c.name),
            "help": HELP.get(c.name, ""),
            "rules": c.rules,
            **{measure.field: shown_value(c, measure.field) for measure in MEASURES},
        }
        for c in contenders
    ]


def chart(contenders: Sequence[Contender], scheme: str | None) -> go.Figure:
    """Six small bar charts, a colour for each way; marks show the values to compare the bars with."""
    titles = [title for _, _, title in _PLOTS]
    figure = make_subplots(rows=2, cols=3, subplot_titles=titles, vertical_spacing=0.16, horizontal_spacing=0.09)
    ink = theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]["text"]
    for number, (field, beside, _) in enumerate(_PLOTS):
        row, col = number // 3 + 1, number % 3 + 1
        for k, contender in enumerate(contenders):
            name = NAMES.get(contender.name, contender.name)
            bar = go.Bar(
                x=[name], y=[shown_value(contender, field)], name=name, legendgroup=name, showlegend=number == 0,
                marker={"color": SERIES[k % len(SERIES)]},
                hovertemplate=f"{name}: %{{y:.3g}}<extra>{_BY_FIELD[field].name}</extra>",
            )  # fmt: skip
            figure.add_trace(bar, row=row, col=col)
        if beside:
            mark = go.Scatter(
                x=[NAMES.get(c.name, c.name) for c in contenders], y=[shown_value(c, beside) for c in contenders],
                mode="markers", name=_BY_FIELD[beside].name, showlegend=False,
                marker={"symbol": "diamond", "size": 9, "color": ink},
                hovertemplate=f"%{{x}}: %{{y:.3g}}<extra>{_BY_FIELD[beside].name}</extra>",
            )  # fmt: skip
            figure.add_trace(mark, row=row, col=col)
    figure = themed(figure, scheme, height=470, margin={"l": 40, "r": 12, "t": 64, "b": 16}, bargap=0.25)
    figure.update_xaxes(showticklabels=False, showgrid=False)
    figure.update_yaxes(rangemode="tozero", nticks=5)
    figure.update_annotations(font={"size": 12})
    return figure.update_layout(legend={"y": 1.09})
