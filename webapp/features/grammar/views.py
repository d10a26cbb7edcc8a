"""The views below the recordings, of which one is seen at a time."""

from __future__ import annotations

from dash import html
from dash.development.base_component import Component

from webapp.features.grammar import actions_view, compare_view, compose_view, names, routines_view, tune_view
from webapp.shell.attributes import attributes
from webapp.ui.views import PageView, PageViews


def _rules() -> Component:
    return html.Div(id=names.GRAMMAR_RULES, className="grammar-rules", **attributes(aria_label="Rules"))


BELOW = PageViews(
    "show",
    names.GRAMMAR_SHOW,
    "What to look at",
    (
        PageView("actions", "Actions", actions_view.layout, actions_view.register),
        PageView("rules", "What follows what", _rules),  # drawn in the browser
        PageView("routines", "Routines", routines_view.layout, routines_view.register),
        PageView("compose", "Compose", compose_view.layout, compose_view.register),
        PageView("tune", "How many actions", tune_view.layout, tune_view.register),
        PageView("compare", "Compare", compare_view.layout, compare_view.register),
    ),
)
