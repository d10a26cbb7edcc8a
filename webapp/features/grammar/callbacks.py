"""The Grammar page's callbacks: its results, and the data that the browser draws."""

from __future__ import annotations

from urllib.parse import urlencode

from dash import Dash, Input, Output, State, no_update
from dash.dependencies import ClientsideFunction

from core.workspace import Workspace
from webapp.features.grammar import grammars, layout, names, views
from webapp.features.grammar.figures.tiles import tiles
from webapp.features.grammar.layout import METHOD
from webapp.shell import settings
from webapp.shell.names import DATASET, REVISION, SELECTION
from webapp.ui import method_page


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the page's callbacks."""
    method_page.register(app, workspace, METHOD)
    _show(app, workspace)
    views.BELOW.register(app, workspace)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.GRAMMAR_RESULT, "children"),
        Output(names.GRAMMAR_MENUS, "children"),
        Input(names.METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(names.METHOD.settings, "data"),
    )
    def show_result(key, name, view):
        learned = grammars.learned(workspace, name, view) if key and name else None
        menus = method_page.earlier_menu(workspace, METHOD, name, learned is not None)
        if learned is None:
            return [], menus
        query = urlencode({"dataset": name, **(view or {})})
        copies = method_page.copy_items(workspace, METHOD, name, view)
        return layout.result(tiles(workspace.open(name), learned)), [*menus, layout.downloads(query, copies)]

    @app.callback(
        Output(names.GRAMMAR_DATA, "data"),
        Input(names.METHOD.result_key, "data"),
        Input(names.GRAMMAR_NAMES, "data"),
        Input(REVISION, "data"),
        State(DATASET, "data"),
        State(names.METHOD.settings, "data"),
        State(names.GRAMMAR_DATA, "data"),
    )
    def gather(key, _names, _revision, name, view, before):
        learned = grammars.learned(workspace, name, view) if key and name else None
        if learned is None or settings.key_of(workspace, grammars.PAGE, name, view) != key:
            return no_update
        notes = grammars.notes_of(workspace, name, view) or {}
        mark = grammars.names_mark(workspace, name, view)
        if before and (before["key"], before["names"], before["dataset"]) == (key, mark, name):
            return no_update
        return grammars.page_data(workspace.open(name), learned, key, notes) | {"names": mark}

    app.clientside_callback(
        ClientsideFunction("grammar", "draw"),
        Output(names.GRAMMAR_DRAWN, "data"),
        Input(names.GRAMMAR_DATA, "data"),
        Input(SELECTION, "data"),
        Input(names.ACTION_ORDER, "value"),
        Input(names.GRAMMAR_STRING, "id"),
    )
