"""What the Clip page consists of."""

from __future__ import annotations

from dash import html
from dash.development.base_component import Component


def page() -> Component:
    """The page before it knows what there is to show."""
    return html.Div([html.Div([html.H1("Clip")], className="page-head")], className="clip")
