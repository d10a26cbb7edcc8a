"""The Boards page."""

from __future__ import annotations

from dash import html
from dash.development.base_component import Component

from webapp.features.boards import names


def page() -> Component:
    """A place that assets/boards fills."""
    return html.Div([html.H1("Boards"), html.Div(id=names.BOARDS_PLACE)], className="page")
