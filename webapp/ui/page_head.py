"""The line at the top of a page: its title, links within the page, and its actions on the right."""

from __future__ import annotations

from collections.abc import Sequence

from dash import html
from dash.development.base_component import Component


def page_head(title: str, *actions: Component, beside: Sequence[Component] = ()) -> Component:
    """The head of the page called ``title``; ``beside``: what stands next to the name."""
    return html.Div([html.H1(title), *beside, html.Div(className="spacer"), *actions], className="page-head")
