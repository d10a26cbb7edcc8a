"""The layout of the Grammar page."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from webapp.features.grammar import names, views
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.ui import method_page
from webapp.ui.method_page import MethodPage
from webapp.ui.tile import metric_tile

HINT = (
    "It cuts the recordings into short actions that recur, and finds out which actions follow which. Then you can see "
    "every recording as a string of actions, and make new motion that keeps to the same order."
)
METHOD = MethodPage(
    page="grammar",
    title="Actions",
    action="Learn the rules",
    doing="Learning the rules",
    symbol="branches",
    hint=HINT,
)


def page() -> Component:
    """The page before any data is loaded."""
    return html.Div(
        className="grammar",
        children=[
            html.Div(
                className="page-head",
                children=[
                    html.H1("Grammar"),
                    html.Span("what follows what", className="muted"),
                    html.Div(className="spacer"),
                    html.Div(id=names.GRAMMAR_MENUS, className="head-menus"),
                    method_page.run_button(METHOD),
                ],
            ),
            method_page.settings_fold(METHOD),
            method_page.status_place(METHOD),
            dcc.Store(id=names.GRAMMAR_DATA),
            dcc.Store(id=names.GRAMMAR_NAMES),
            html.Div(id=names.GRAMMAR_RESULT),
        ],
    )


def result(tiles: Sequence[tuple[str, str, str]]) -> Component:
    """The figures, every recording as a string, and the views below; assets/grammar/*.mjs fill them."""
    return html.Div(
        [
            html.Div([metric_tile(*tile) for tile in tiles], className="tiles grammar-tiles section"),
            html.Div(
                [
                    html.H2("Recordings"),
                    html.Span("a colour for each action, ▾ where a routine begins", className="muted"),
                    html.Div(className="spacer"),
                    _zoom("minus", "Show more time", "out"),
                    _zoom("plus", "Show less time, larger", "in"),
                ],
                className="section-head section",
            ),
            html.Div(
                id=names.GRAMMAR_STRING, className="card string", role="list", **attributes(aria_label="Recordings")
            ),
            html.Div([views.BELOW.switch()], className="section-head section"),
            *views.BELOW.panels(),
            dcc.Store(id=names.GRAMMAR_DRAWN),
        ]
    )


def _zoom(symbol: str, label: str, direction: str) -> Component:
    return html.Button(
        icon(symbol, 14),
        type="button",
        title=label,
        className="walk-button string-zoom",
        **attributes(aria_label=label, data_zoom=direction),
    )


def downloads(query: str, copies: Sequence[Component]) -> Component:
    """The menu of downloads; copies: items that copy recipes for the result."""
    items = [
        _download("Everything (JSON)", f"/api/grammar.json?{query}"),
        _download("All occurrences (CSV)", f"/api/grammar-actions.csv?{query}"),
        _download("Rules (CSV)", f"/api/grammar-rules.csv?{query}"),
        dmc.MenuDivider(),
        *copies,
    ]
    target = dmc.Button("Download", variant="default", leftSection=icon("download", 16))
    children = [dmc.MenuTarget(target), dmc.MenuDropdown(items)]
    return dmc.Menu(shadow="md", position="bottom-end", children=children)


def _download(label: str, address: str) -> Component:
    return dmc.MenuItem(label, href=address, refresh=True)
