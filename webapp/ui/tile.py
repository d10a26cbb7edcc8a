"""A number of a result with its name; its explanation appears on hover and on focus."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from webapp.shell.attributes import attributes


def metric_tile(name: str, value: str, explanation: str) -> Component:
    """One tile; it can be focused, so that the keyboard reaches its explanation too."""
    return dmc.Tooltip(
        html.Div(
            [html.Span(name, className="tile-name"), html.Span(value, className="tile-value number")],
            className="tile card",
            tabIndex="0",
            **attributes(aria_label=f"{name}: {value}. {explanation}"),
        ),
        label=explanation,
        boxWrapperProps={"className": "tile-box"},
        events={"hover": True, "focus": True, "touch": True},
    )
