"""Charts of a sweep as SVG files: the paper's Figures 5 and 6 with the spread over seeds, without a browser."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from html import escape
from typing import Any

import numpy as np

from core.motifs.parameters import MotifParameters
from core.motifs.suggestion import CLEAR, Suggestion, suggest
from core.motifs.sweep_table import SweepTable
from core.parameters import parameters_of, write_value
from webapp.features.sweeps.figures.measures import MEASURES, axis_name, is_even, is_log, pairs_of, place

WIDTH, HEIGHT = 680, 420
PAPER_KAPPA = 200  # of the paper's Figure 6
LEFT, RIGHT, TOP, BOTTOM = 72, 72, 54, 62
COLOURS = ("#2f5fb3", "#c2651c")  # left scale, right scale
_INK, _GRID = "#333a45", "#dfe4ea"
_FONT = "system-ui, -apple-system, 'Segoe UI', Roboto, 'Noto Sans', sans-serif"


def charts(table: SweepTable) -> Iterator[tuple[str, str]]:
    """Name and SVG of a chart for every axis with several values and every pair of figures on two scales.

    The other axes stand where :func:`fixed` says.
    """
    chosen = suggest(table)
    for name, values in table.axes.items():
        if len(values) > 1:
            at = fixed(table, name)
            for pair_name, pair in pairs_of(table).items():
                yield f"{name}-{pair_name}", chart(table, name, at, pair, chosen)


def fixed(table: SweepTable, name: str) -> dict[str, Any]:
    """The values of the other axes in a chart along ``name``: those nearest the defaults, and to the paper's kappa of
    200.
    """
    usual = {p.name: p.default for p in parameters_of(MotifParameters)} | {"kappa": PAPER_KAPPA}
    return {other: _nearest(values, usual[other]) for other, values in table.axes.items() if other != name}


def _nearest(values: Sequence[Any], wanted: Any) -> Any:
    return min(values, key=lambda value: _distance(value, wanted))


def _distance(value: Any, wanted: Any) -> float:
    """0 for equal values, infinite between different words, else the difference."""
    if value == wanted:
        return 0.0
    return math.inf if isinstance(value, str) or isinstance(wanted, str) else abs(value - wanted)


def chart(table: SweepTable, name: str, at: dict[str, Any], pair: Sequence[str], chosen: Suggestion) -> str:
    """One chart: both figures along an axis, median as a line, least to most over the seeds as a band."""
    values = table.axes[name]
    across = _across(values)
    parts = [_frame(name, values, across), _heading(pair, at, table.seeds)]
    for side, measure in enumerate(pair):
        numbers = table.along(measure, name, at) * MEASURES[measure].factor
        if np.isfinite(numbers).any():
            parts.append(_series(measure, side, across, numbers))
    if chosen.at and all(chosen.at.get(other, value) == value for other, value in at.items()):
        parts.append(_mark(across[list(values).index(chosen.at[name])], chosen.verdict))
    body = "\n".join(parts)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" '
        f'font-family="{_FONT}" font-size="13" fill="{_INK}">\n<rect width="100%" height="100%" fill="#fff"/>\n'
        f"{body}\n</svg>\n"
    )


def _across(values: Sequence[Any]) -> list[float]:
    """Where each value stands, from the left edge of the drawing."""
    if is_even(values) or len(values) == 1:
        numbers = np.arange(len(values), dtype=float)
    else:
        numbers = np.log(values) if is_log(values) else np.array(values, float)
    span = float(np.ptp(numbers)) or 1.0
    inner = WIDTH - LEFT - RIGHT - 40
    return [LEFT + 20 + inner * float(n - numbers.min()) / span for n in numbers]


def _frame(name: str, values: Sequence[Any], across: list[float]) -> str:
    bottom = HEIGHT - BOTTOM
    parts = [f'<path d="M{LEFT} {bottom}H{WIDTH - RIGHT}" stroke="{_INK}" fill="none"/>']
    last = -100.0
    for value, x in zip(values, across, strict=True):
        parts.append(f'<path d="M{x:.1f} {TOP}V{bottom + 5}" stroke="{_GRID}" fill="none"/>')
        word = write_value(value)
        if x - 4 * len(word) > last + 4:
            parts.append(_text(x, bottom + 20, word))
            last = x + 4 * len(word)
    parts.append(_text(WIDTH / 2, HEIGHT - 16, axis_name(name) + (", logarithmic" if is_log(values) else "")))
    return "\n".join(parts)


def _heading(pair: Sequence[str], at: dict[str, Any], seeds: int) -> str:
    shapes = ("◆", "●")
    names = [
        f'<tspan fill="{COLOURS[side]}">{shapes[side]} {escape(MEASURES[measure].name)}</tspan>'
        for side, measure in enumerate(pair)
    ]
    spread = f"median and range of {seeds} seeds" if seeds > 1 else "one seed"
    note = ", ".join(filter(None, [place(at), spread]))
    return (
        f'<text x="{LEFT}" y="24" font-weight="600">{names[0]} and {names[1]}</text>\n'
        f'<text x="{LEFT}" y="42" font-size="12" fill="#66707f">{escape(note)}</text>'
    )


def _series(measure: str, side: int, across: list[float], numbers: np.ndarray) -> str:
    """A figure on its own scale. numbers: (n_values, n_seeds), as shown, NaN where missing."""
    ticks = nice_ticks(float(np.nanmin(numbers)), float(np.nanmax(numbers)))
    height = HEIGHT - TOP - BOTTOM

    def up(value: float) -> float:
        return HEIGHT - BOTTOM - height * (value - ticks[0]) / (ticks[-1] - ticks[0])

    measured = np.isfinite(numbers).any(1)
    xs = [x for x, here in zip(across, measured, strict=True) if here]
    rows = numbers[measured]
    low, middle, high = np.nanmin(rows, 1), np.nanmedian(rows, 1), np.nanmax(rows, 1)
    colour, edge = COLOURS[side], LEFT if side == 0 else WIDTH - RIGHT
    band = _points(xs, map(up, high)) + " " + _points(xs[::-1], map(up, low[::-1]))
    parts = [
        f'<polygon points="{band}" fill="{colour}" fill-opacity=".16"/>',
        f'<polyline points="{_points(xs, map(up, middle))}" fill="none" stroke="{colour}" stroke-width="2"/>',
        *(_marker(side, x, up(y)) for x, y in zip(xs, middle, strict=True)),
        f'<path d="M{edge} {TOP}V{HEIGHT - BOTTOM}" stroke="{colour}" fill="none"/>',
    ]
    for tick in ticks:
        x, anchor = (edge - 8, "end") if side == 0 else (edge + 8, "start")
        parts.append(_text(x, up(tick) + 4, f"{tick:g}", anchor, colour))
    turn = LEFT - 54 if side == 0 else WIDTH - RIGHT + 54
    middle_y = TOP + height / 2
    title = escape(MEASURES[measure].title)
    parts.append(
        f'<text transform="translate({turn} {middle_y}) rotate({-90 if side == 0 else 90})" text-anchor="middle" '
        f'fill="{colour}">{title}</text>'
    )
    return "\n".join(parts)


def _marker(side: int, x: float, y: float) -> str:
    if side == 0:
        return f'<path d="M{x:.1f} {y - 5:.1f}l5 5l-5 5l-5 -5z" fill="{COLOURS[0]}"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{COLOURS[1]}"/>'


def _mark(x: float, verdict: str) -> str:
    words = "suggested" if verdict == CLEAR else "suggested, not clear"
    anchor = "end" if x > WIDTH - RIGHT - 80 else "middle"
    line = f'<path d="M{x:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="{_INK}" stroke-dasharray="4 4" fill="none"/>'
    return f"{line}\n{_text(x, TOP - 5, words, anchor)}"


def _text(x: float, y: float, words: str, anchor: str = "middle", colour: str = _INK) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{colour}">{escape(words)}</text>'


def _points(xs: Sequence[float], ys: Any) -> str:
    return " ".join(f"{x:.1f},{y:.1f}" for x, y in zip(xs, ys, strict=True))


def nice_ticks(low: float, high: float, wanted: int = 5) -> list[float]:
    """Round numbers from at most ``low`` to at least ``high``, about ``wanted`` steps of 1, 2 or 5 times a power of
    ten."""
    span = (high - low) or abs(high) or 1.0
    size = 10 ** math.floor(math.log10(span / wanted))
    step = next(size * m for m in (1, 2, 5, 10) if span / (size * m) <= wanted)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    last = max(last, first + 1)
    return [round(k * step, 12) for k in range(first, last + 1)]
