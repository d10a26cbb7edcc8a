"""What the Motifs page shows below and beside its graph, one view in each place at a time.

A view is a module with ``layout()`` and ``register(app, workspace)``, its callbacks. The layouts come into the page
with each graph. The callbacks of the table and of the motions are in callbacks.py.
"""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import html
from dash.development.base_component import Component

from webapp.features.motifs import (
    blend_side,
    compare_view,
    compression_view,
    names,
    notes_side,
    report_view,
    timeline_view,
    walk_side,
)
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.ui.downloads import table_download
from webapp.ui.views import PageView, PageViews


def _motions() -> Component:
    return html.Div(
        [html.Div(id=names.MOTIF_SELECTION), html.Div(id=names.MOTION_LIST, className="motion-list")],
        className="side-motions",
    )


def _table() -> Component:
    search = dmc.TextInput(
        id=names.MOTIF_SEARCH,
        placeholder="Search names, tags, notes, labels",
        leftSection=icon("search", 14),
        size="xs",
        className="motif-search",
        **attributes(aria_label="Search motifs"),
    )
    bar = html.Div(
        [search, html.Div(className="spacer"), table_download(names.MOTIF_TABLE, "motifs")], className="table-bar"
    )
    return html.Div([bar, html.Div(id=names.MOTIF_TABLE_PLACE)])


BELOW = PageViews(
    "view",
    names.SWITCHES["view"],
    "What to look at",
    (
        PageView("table", "All motifs", _table),
        PageView("timeline", "Timeline", timeline_view.layout, timeline_view.register),
        PageView("report", "Coverage report", report_view.layout, report_view.register),
        PageView("compare", "Compare", compare_view.layout, compare_view.register),
        PageView("compression", "Compression", compression_view.layout, compression_view.register),
    ),
)
BESIDE = PageViews(
    "side",
    names.SWITCHES["side"],
    "What to do with the motif",
    (
        PageView("motions", "Motions", _motions),
        PageView("blend", "Blend", blend_side.layout, blend_side.register),
        PageView("walk", "Walk", walk_side.layout, walk_side.register),
        PageView("notes", "Notes", notes_side.layout, notes_side.register),
    ),
)
