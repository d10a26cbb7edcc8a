"""What the gait of a clip comes to, as tables."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from core.editing.gait import Gait, GaitBout, Measure
from webapp.components.actions import sends

MOST_EVENTS = 400  # rows of the table
_DIGITS = {"m": 2, "s": 2, "m/s": 2, "steps/min": 0}
MINUS = "\N{MINUS SIGN}"
_NAMES = {"strike": "Heel strike", "off": "Toe-off"}


def gait_card(gait: Gait, clip: str, fps: float) -> Component:
    """Measures of every bout, and all events; or why there are none."""
    if not gait.bouts:
        return html.Div(gait.why, className="muted gait-none")
    bouts = [_bout(bout, number, len(gait.bouts), clip, fps) for number, bout in enumerate(gait.bouts)]
    return html.Div([*bouts, _events(gait, clip, fps)])


def bout_words(bout: GaitBout) -> str:
    """``Walking``, ``Running backward`` ..."""
    return ("Walking" if bout.kind == "walk" else "Running") + (" backward" if bout.backward else "")


def _bout(bout: GaitBout, number: int, n: int, clip: str, fps: float) -> Component:
    when = f"{bout.start / fps:.2f} to {bout.end / fps:.2f} s"
    select = dmc.Button(
        "Select",
        size="compact-xs",
        variant="default",
        **sends("selection", {"clip": clip, "start": bout.start, "end": bout.end + 1}),
        **{"aria-label": f"Select the frames of {bout_words(bout).lower()}, {when}"},
    )
    title = bout_words(bout) + (f" ({number + 1} of {n})" if n > 1 else "")
    cadence, speed = (next(m for m in bout.measures if m.name == name) for name in ("Cadence", "Speed"))
    facts = f"{when} · {cadence.mean:.0f} steps/min · {speed.mean:.2f} m/s"
    head = html.Summary([html.B(title), html.Span(facts, className="muted number"), select], className="gait-head")
    return html.Details([head, _measures(bout)], className="gait-bout", open=number == 0)


def _measures(bout: GaitBout) -> Component:
    head = ("", "Left", "Right", "Both", "±", "Asymmetry")
    rows = [
        [
            html.Span([m.name, html.Span(f" {m.unit}", className="muted")]),
            *(_number(m, value) for value in (m.left, m.right, m.mean)),
            _number(m, m.spread) if m.n > 1 else "",
            "" if m.asymmetry is None else _signed(m.asymmetry),
        ]
        for m in bout.measures
    ]
    return dmc.Table(
        [
            dmc.TableThead(dmc.TableTr([dmc.TableTh(text) for text in head])),
            dmc.TableTbody([dmc.TableTr([dmc.TableTd(cell) for cell in row]) for row in rows]),
        ],
        className="gait-table number",
        verticalSpacing=3,
        horizontalSpacing="sm",
        fz="sm",
    )


def _number(measure: Measure, value: float | None) -> str:
    return "" if value is None else f"{value:.{_DIGITS.get(measure.unit, 1)}f}"


def _signed(percent: float) -> str:
    whole = round(percent)
    return f"{'+' if whole > 0 else MINUS if whole < 0 else ''}{abs(whole)} %"


def _events(gait: Gait, clip: str, fps: float) -> Component:
    rows = [
        html.Button(
            [
                html.Span(f"{event.frame / fps:.2f} s", className="number"),
                html.Span(f"frame {event.frame}", className="muted number"),
                html.Span(event.side.capitalize(), className=f"gait-side side-{event.side}"),
                html.Span(_NAMES[event.kind]),
            ],
            className="gait-event",
            type="button",
            **sends("clip-seek", {"clip": clip, "frame": event.frame}, every_time=True),
        )
        for event in gait.events[:MOST_EVENTS]
    ]
    more = len(gait.events) - len(rows)
    return html.Details(
        [
            html.Summary(f"{len(gait.events)} heel strikes and toe-offs"),
            html.Div(rows, className="gait-events", role="list"),
            html.Div(f"and {more} more; the table of the clip has them all", className="muted") if more > 0 else None,
        ],
        className="gait-details",
    )
