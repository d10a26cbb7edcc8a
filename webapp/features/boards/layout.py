"""The Boards page: a place that assets/boards fills, and the button in the header that saves a view."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from webapp.features.boards import names
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon


def page() -> Component:
    """The page."""
    return html.Div(
        [
            html.H1("Boards", className="visually-hidden"),
            html.Div(id=names.BOARDS_PLACE),
            dcc.Store(id=names.BOARDS_SHOWN),
        ],
        className="page boards",
    )


def header() -> list[Component]:
    """Comments on what is selected, and saving what is shown, on every page."""
    return [
        html.Button(
            [icon("note", 16), "Comments"],
            id=names.COMMENTS_BUTTON,
            className="boards-button boards-comments-button",
            hidden=True,
        ),
        dmc.Button(
            "Save view",
            id=names.SAVE_VIEW,
            className="for-editors",
            variant="default",
            leftSection=icon("star", 16),
            **attributes(aria_label="Save view: keep it for the team"),
        ),
    ]
