"""The Groups page: a place that assets/groups fills."""

from __future__ import annotations

from dash import dcc, html
from dash.development.base_component import Component

from webapp.features.groups import names
from webapp.ui.page_head import page_head


def page() -> Component:
    """The page."""
    return html.Div(
        [page_head("Groups"), html.Div(id=names.GROUPS_PLACE), dcc.Store(id=names.GROUPS_SHOWN)], className="groups"
    )
