"""Menus that save what is on the page: a chart as PNG, SVG or CSV, a table as CSV (assets/shared/downloads.mjs)."""

from __future__ import annotations

from typing import Any

import dash_mantine_components as dmc
from dash.development.base_component import Component

from webapp.shell.attributes import attributes
from webapp.shell.icons import icon

KINDS = {"png": "Picture (PNG)", "svg": "Drawing (SVG)", "csv": "Numbers (CSV)"}


def chart_menu(graph_id: str, name: str) -> Component:
    """A button that saves the chart in the dcc.Graph ``graph_id`` under ``name`` plus the dataset's name."""
    return _menu("chart", graph_id, name, *KINDS)


def drawing_menu(drawing: str, name: str) -> Component:
    """A button that saves a drawing of the server, at the address that assets/shared/downloads.mjs has for it."""
    return _menu("drawing", drawing, name, "png", "svg")


def _menu(what: str, target: str, name: str, *kinds: str) -> Component:
    items = [dmc.MenuItem(KINDS[kind], **_saves(what, target, kind, name)) for kind in kinds]
    return dmc.Menu(
        shadow="md",
        position="bottom-end",
        children=[dmc.MenuTarget(_button(f"Save the {what}: {name}")), dmc.MenuDropdown(items)],
    )


def table_download(grid_id: str, name: str) -> Component:
    """A button that saves the rows of a table as they are shown: filtered and sorted."""
    return _button(f"Save the table as CSV: {name}", **_saves("table", grid_id, "csv", name))


def _saves(what: str, target: str, kind: str, name: str) -> dict[str, Any]:
    return {"data-save": what, "data-target": target, "data-kind": kind, "data-name": name}


def _button(label: str, **more: Any) -> Component:
    return dmc.ActionIcon(
        icon("download", 16),
        variant="default",
        size=30,
        attributes={"root": {"title": label}},
        **attributes(aria_label=label),
        **more,
    )
