"""Charts of a sweep: the paper's Figures 5 and 6 with their spread, and a heat map over both axes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import plotly.graph_objects as go

from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import CLEAR, Suggestion
from core.motifs.sweep_table import SweepTable
from core.parameters import write_value
from webapp.features.sweeps.figures.measures import MEASURES, axis_name, is_even, is_log
from webapp.shell import theme
from webapp.ui.charts import HEAT, SERIES, themed

Link = Callable[[MotifParameters], str]
"""A point -> address of its result."""

_SYMBOLS = ("diamond", "circle")
_COLOURS = {"light": SERIES[:2], "dark": ("#86aef5", "#f0a35e")}  # left scale, right scale
_COUNTS = ("n_motifs", "mean_motions")  # shown from zero
_STAR = "#e0a100"


def lines(
    table: SweepTable,
    links: np.ndarray,
    name: str,
    at: Mapping[str, Any],
    pair: Sequence[str],
    chosen: Suggestion,
    scheme: str | None,
) -> go.Figure:
    """Two figures along the axis ``name`` on scales of their own: a dot for each point, median as a line, least to most
    over the seeds as a band. links: (as ``table.shape``) address of each point's result.
    """
    values = list(table.axes[name])
    across = [write_value(value) for value in values] if is_even(values) else values
    own_links = links[_slice(table, name, at)]
    figure, colours = go.Figure(), _COLOURS.get(scheme or "light", _COLOURS["light"])
    for side, measure in enumerate(pair):
        numbers = table.along(measure, name, at)
        if np.isfinite(numbers).any():
            figure.add_traces(_series(measure, side, colours[side], across, values, name, numbers, own_links))
    figure = themed(figure, scheme, height=None, hovermode="closest", margin={"l": 60, "r": 64, "t": 56, "b": 46})
    figure.update_layout(legend_y=1.09)  # room for the words of the suggestion
    figure.update_xaxes(title_text=axis_name(name), showgrid=False)
    if is_even(values):
        figure.update_xaxes(type="category", categoryorder="array", categoryarray=across)
    else:
        shown = _spaced(values)
        figure.update_xaxes(
            type="log" if is_log(values) else "linear", tickvals=shown, ticktext=list(map(write_value, shown))
        )
    for side, measure in enumerate(pair):
        font = {"color": colours[side], "size": 12.5}
        axis = {"title": {"text": MEASURES[measure].title, "font": font}, "tickfont": font, "tickmode": "auto"}
        axis["rangemode"] = "tozero" if measure in _COUNTS else "normal"
        more = {"overlaying": "y", "side": "right", "showgrid": False, "zeroline": False, "automargin": True}
        figure.update_layout({"yaxis2" if side else "yaxis": axis | (more if side else {})})
    if chosen.at and all(chosen.at[other] == value for other, value in at.items()):
        words = "suggested" if chosen.verdict == CLEAR else "suggested, not clear"
        number = values.index(chosen.at[name])  # of a category: its name would be taken for a number
        _mark(figure, number if is_even(values) else values[number], words, is_log(values))
    return figure


def heat(table: SweepTable, links: np.ndarray, measure: str, chosen: Suggestion, scheme: str | None) -> go.Figure:
    """Medians of a figure over both axes, a star on the suggested setting; a cell leads to its most typical seed."""
    (x_name, xs), (y_name, ys) = table.axes.items()
    shown = MEASURES[measure]
    middle = table.middle(measure)
    x, y = [write_value(v) for v in xs], [write_value(v) for v in ys]
    text = [[shown.text(v) if np.isfinite(v) else "" for v in row] for row in middle.T]
    typical = np.array(
        [[links[i, j, typical_seed(table.of(measure)[i, j])] for i in range(len(x))] for j in range(len(y))]
    )
    c = theme.CANVAS[scheme if scheme in theme.CANVAS else "light"]
    figure = go.Figure(
        go.Heatmap(
            x=x, y=y, z=(middle * shown.factor).T, customdata=typical, text=text,
            texttemplate="%{text}" if len(x) * len(y) <= 80 else None,
            colorscale=HEAT.get(scheme or "light", HEAT["light"]),
            colorbar={"title": {"text": shown.unit or "", "side": "top"}, "thickness": 12, "outlinewidth": 0},
            xgap=2, ygap=2, name=shown.name, hoverongaps=False,
            hovertemplate=f"{x_name} %{{x}}, {y_name} %{{y}}<br>{shown.name} %{{text}}<extra></extra>",
        )
    )  # fmt: skip
    if chosen.at:  # above the number, which it would hide
        star = {"text": "★" if chosen.verdict == CLEAR else "☆", "font": {"size": 17, "color": _STAR}}
        column, row = chosen.index  # the number of a category; its name would be taken for one
        badge = {"bgcolor": c["surface"], "borderpad": 0, "yshift": 22, "showarrow": False}
        figure.add_annotation(**star, **badge, x=column, y=row)
    figure = themed(figure, scheme, height=None, margin={"l": 60, "r": 16, "t": 10, "b": 46})
    figure.update_xaxes(title_text=axis_name(x_name), type="category", showgrid=False)
    return figure.update_yaxes(title_text=axis_name(y_name), type="category", showgrid=False)


def typical_seed(numbers: np.ndarray) -> int:
    """Which of a cell's seeds ``(n_seeds,)`` is nearest their median; the first where none is there (NaN)."""
    if not np.isfinite(numbers).any():
        return 0
    return int(np.nanargmin(np.abs(numbers - np.nanmedian(numbers))))


def link_array(table: SweepTable, points: Sequence[MotifParameters], link: Link) -> np.ndarray:
    """Address of every point's result in the shape of the table, "" where it is not there."""
    texts = [link(point) if entry is not None else "" for point, entry in zip(points, table.figures, strict=True)]
    return np.array(texts, object).reshape(table.shape)


def _slice(table: SweepTable, name: str, at: Mapping[str, Any]) -> tuple:
    return tuple(slice(None) if axis == name else list(v).index(at[axis]) for axis, v in table.axes.items())


def _series(measure, side, colour, across, values, name, numbers, links) -> list[go.Scatter]:
    """Band, line and dots of one figure. numbers, links: (n_values, n_seeds)."""
    shown = MEASURES[measure]
    axis = "y2" if side else "y"
    measured = [i for i in range(len(values)) if np.isfinite(numbers[i]).any()]
    scaled = numbers * shown.factor
    low, middle, high = ([float(f(scaled[i])) for i in measured] for f in (np.nanmin, np.nanmedian, np.nanmax))
    x = [across[i] for i in measured]
    quiet = {"hoverinfo": "skip", "showlegend": False, "legendgroup": measure, "yaxis": axis}
    dots = [(i, k) for i in measured for k in range(numbers.shape[1]) if np.isfinite(numbers[i, k])]
    seeds = numbers.shape[1]
    return [
        go.Scatter(x=x, y=low, mode="lines", line={"width": 0}, **quiet),
        go.Scatter(x=x, y=high, mode="lines", line={"width": 0}, fill="tonexty", fillcolor=_faint(colour), **quiet),
        go.Scatter(
            x=x, y=middle, mode="lines", line={"width": 2, "color": colour}, yaxis=axis, name=f"{shown.name}, median",
            hoverinfo="skip", showlegend=False, legendgroup=measure,
        ),
        go.Scatter(
            x=[across[i] for i, _ in dots],
            y=[float(scaled[i, k]) for i, k in dots],
            customdata=[links[i, k] for i, k in dots],
            text=[
                f"{name.replace('_', ' ')} {write_value(values[i])}" + (f", seed {k}" if seeds > 1 else "")
                + f"<br>{shown.name} {shown.text(numbers[i, k])}"
                for i, k in dots
            ],
            hovertemplate="%{text}<extra></extra>",
            mode="markers",
            marker={"symbol": _SYMBOLS[side], "size": 8, "color": colour, "opacity": 1 if seeds == 1 else 0.6},
            yaxis=axis, name=shown.name, legendgroup=measure,
        ),
    ]  # fmt: skip


def _mark(figure: go.Figure, position: Any, words: str, log: bool) -> None:
    """A dashed line at the suggested setting."""
    line = {"color": _STAR, "dash": "dot", "width": 2}
    figure.add_shape(type="line", x0=position, x1=position, y0=0, y1=1, yref="paper", line=line)
    at = float(np.log10(position)) if log else position  # annotations, unlike shapes, want the logarithm
    figure.add_annotation(x=at, y=1, yref="paper", text=words, showarrow=False, yanchor="bottom", font={"size": 11.5})


def _spaced(values: Sequence[float]) -> list[float]:
    """The values that have room for a word on the axis."""
    scale = np.log(values) if is_log(values) else np.array(values, float)
    room, last, kept_ticks = float(np.ptp(scale)) / 11, -np.inf, []
    for value, where in zip(values, scale, strict=True):
        if where - last >= room:
            kept_ticks.append(value)
            last = where
    return kept_ticks


def _faint(colour: str) -> str:
    red, green, blue = (int(colour[i : i + 2], 16) for i in (1, 3, 5))
    return f"rgba({red},{green},{blue},0.18)"
