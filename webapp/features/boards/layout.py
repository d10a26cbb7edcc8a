"""The Boards page."""

from __future__ import annotations

from dash import html
from dash.development.base_component import Component

from webapp.features.boards import names


def page() -> Component:
    """A place that assets/boards fills."""
    words = "A report of a dataset as one file: motionscape report WORKSPACE/NAME --out report.html"
    return html.Div(
        [html.H1("Boards"), html.P(words, className="muted"), html.Div(id=names.BOARDS_PLACE)], className="page"
    )
