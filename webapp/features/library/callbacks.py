"""The Library page's callbacks: they show the workspace and carry out actions on it."""

from __future__ import annotations

import time
from collections.abc import Mapping

from dash import ALL, Dash, Input, Output, State, ctx, dcc, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses, requests
from core.methods import METHODS
from core.workspace import Workspace, WorkspaceError
from webapp import jobs
from webapp.features.library import (
    adding,
    body_editor,
    cards,
    feature_files,
    layout,
    long_lists,
    names,
    reading,
    repairs,
)
from webapp.features.library.figures import tables
from webapp.jobs import changes
from webapp.jobs.names import JOB_POKE
from webapp.shell.feature import Values
from webapp.shell.messages import empty_state, notice
from webapp.shell.names import DATASET, JOB_STARTED, NOTICES, REVISION, SELECTION, VIEW
from webapp.ui.long_tables import OPTIONS
from webapp.ui.tables import grid

_OPENS = {"reread": names.REREAD_OF, "repair": names.REPAIR_OF, "properties": names.PROPERTIES_OF}
"""Actions on chosen clips that open a dialog, and the store that opens it."""


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the page's callbacks."""
    _show(app, workspace)
    _act(app, workspace)
    _choose_clips(app, workspace)
    adding.register(app, workspace)
    reading.register(app, workspace)
    repairs.register(app, workspace)
    long_lists.register(app, workspace)
    body_editor.register(app, workspace)
    feature_files.register(app, workspace)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.DATASET_CARDS, "children"),
        Input(REVISION, "data"),
        State(DATASET, "data"),
        State(names.CARD(ALL), "id"),
    )
    def show_cards(_revision, chosen, shown):
        there = workspace.datasets()
        if there and [card["dataset"] for card in shown] == [info.name for info in there]:
            return no_update  # what is in the cards changes below, so that an open menu stays open
        return cards.dataset_cards(there, chosen)

    @app.callback(
        Output(names.CARD(ALL), "className"),
        Output(names.CARD_OPEN(ALL), "children"),
        Output(names.CARD_OPEN(ALL), "aria-current"),
        Input(REVISION, "data"),
        Input(DATASET, "data"),
        Input(names.CARD(ALL), "id"),
    )
    def show_facts(_revision, chosen, shown):
        there = {info.name: info for info in workspace.datasets()}
        cards_of = [there.get(card["dataset"]) for card in shown]
        mine = [card["dataset"] == chosen for card in shown]
        facts = [cards.card_facts(info) if info else no_update for info in cards_of]
        return list(map(cards.card_class, mine)), facts, list(map(cards.current, mine))

    @app.callback(
        Output(names.DATASET_DETAIL, "children"),
        Output(names.DETAIL_SHOWN, "data"),
        Input(DATASET, "data"),
        Input(REVISION, "data"),
        State(VIEW, "data"),
        State(names.DETAIL_SHOWN, "data"),
    )
    def show_detail(name, _revision, view, shown):
        if name == shown and ctx.triggered_id is None:  # it came with the page
            return no_update, no_update
        return detail(workspace, name, view), name

    app.clientside_callback(
        ClientsideFunction("library", "filter"),
        Output(names.REPORT_TABLE, "rowData"),
        Input(names.REPORT_FILTER, "value"),
        Input(names.REPORT_ROWS, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("library", "look"),
        Input(names.DATASET_TABS, "value"),
        Input(names.REPORT_FILTER, "value"),
        State(VIEW, "data"),
    )
    app.clientside_callback(
        ClientsideFunction("library", "show"),
        Output(names.DATASET_TABS, "value"),
        Output(names.REPORT_FILTER, "value"),
        Input(VIEW, "data"),
        State(names.REPORT_FILTER, "data"),
        prevent_initial_call=True,
    )
    app.clientside_callback(
        ClientsideFunction("properties", "open"), Input(names.PROPERTIES_OF, "data"), prevent_initial_call=True
    )
    app.clientside_callback(
        ClientsideFunction("tables", "mark"),
        Output(names.CLIPS_MARKED, "data"),
        Input(SELECTION, "data"),
        Input(names.CLIPS_TABLE, "rowData"),
        State(names.CLIPS_TABLE, "id"),
    )


def first_values(workspace: Workspace, dataset: str, view: Mapping[str, str]) -> Values:
    """The page with its table of clips, for the layout that the browser gets first."""
    return {
        names.DATASET_CARDS: {"children": cards.dataset_cards(workspace.datasets(), dataset)},
        names.DATASET_DETAIL: {"children": detail(workspace, dataset, view)},
        names.DETAIL_SHOWN: {"data": dataset},
    }


def detail(workspace: Workspace, name: str | None, view: Mapping[str, str] | None) -> list[Component] | Component:
    """The tables of a data set, or why they cannot be shown."""
    if not name:
        return []
    try:
        dataset = workspace.open(name)
    except WorkspaceError as error:
        return empty_state("warning", "This dataset cannot be shown", str(error))
    tab, files = _shown_parts(view)
    columns, report_columns = tables.clip_columns(dataset), tables.REPORT_COLUMNS
    if long_lists.is_long(workspace, name):
        first = long_lists.clips_of(workspace, name).first()
        shown = {
            "clips": grid(names.CLIPS_TABLE, tables.long_columns(columns), first, "Clips", **tables.LONG_CHOICE),
            "report": grid(names.REPORT_TABLE, tables.long_columns(report_columns), None, "Import report", **OPTIONS),
            "rows": dcc.Store(id=names.REPORT_ROWS),
        }
    else:
        shown = {
            "clips": grid(names.CLIPS_TABLE, columns, tables.clip_rows(dataset), "Clips", **tables.CHOICE),
            "report": grid(names.REPORT_TABLE, report_columns, [], "Import report"),
            "rows": dcc.Store(id=names.REPORT_ROWS, data=tables.report_rows(dataset.report.files)),
        }
    return layout.detail(name, shown, dataset.report, tab, files, analyse_button(workspace, name))


def analyse_button(workspace: Workspace, name: str) -> Component | None:
    """The button that computes all that pages show of a dataset, with what it will take; None where all is there."""
    missing = analyses.missing(workspace, name)
    expected = {one.method: analyses.expected_words(workspace, one) for one in missing}
    lines = [f"{METHODS[method].title}: {words}".removesuffix(": ") for method, words in expected.items()]
    return layout.analyse_button(name, lines) if missing else None


def _shown_parts(view: Mapping[str, str] | None) -> tuple[str, str]:
    """The tab and the files of the report that the store "view" names."""
    tab, files = ((view or {}).get(key) for key in ("tab", "files"))
    return tab if tab == "report" else "clips", files if files in dict(layout.REPORTS) else "all"


def _act(app: Dash, workspace: Workspace) -> None:
    @app.callback(Input(names.DATASET_ACTION, "data"), prevent_initial_call=True)
    def act(request):
        try:
            perform(workspace, request or {})
        except WorkspaceError as error:
            _notify(notice("That did not work", str(error), "red"))
        set_props(JOB_POKE, {"data": time.time()})

    @app.callback(
        Output(names.RENAME_DIALOG, "opened"),
        Output(names.RENAME_PROBLEM, "children"),
        Input(names.RENAME_SAVE, "n_clicks"),
        Input(names.RENAME_NAME, "n_submit"),
        State(names.RENAME_OLD, "data"),
        State(names.RENAME_NAME, "value"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def rename(_clicks, _submits, old, new, chosen):
        try:
            info = workspace.rename(old, new or "")
        except WorkspaceError as error:
            return no_update, str(error)
        if chosen == old:
            set_props(DATASET, {"data": info.name})
        set_props(JOB_POKE, {"data": time.time()})
        return False, None

    @app.callback(
        Output(names.TRASH_DIALOG, "opened"),
        Output(names.TRASH_LIST, "children"),
        Input(names.TRASH_OPEN, "n_clicks"),
        Input(REVISION, "data"),
        prevent_initial_call=True,
    )
    def show_trash(_clicks, _revision):
        return True if ctx.triggered_id == names.TRASH_OPEN else no_update, layout.trash_list(workspace.trashed())

    @app.callback(Input(names.DEMO(ALL), "n_clicks"), prevent_initial_call=True)
    def open_demo(clicks):
        if any(clicks):
            _start(workspace, analyses.Request(analyses.DEMO, "demo"))
            _notify(notice("Making the demo", "It appears here in a moment, with its motif graph."))


def perform(workspace: Workspace, request: Mapping[str, object]) -> None:
    """Carries out the action of a button on a dataset's card or in the trash. Raises WorkspaceError."""
    action, name = (str(request.get(key) or "") for key in ("action", "dataset"))
    if action == "rename":
        set_props(names.RENAME_OLD, {"data": name})
        set_props(names.RENAME_NAME, {"value": name})
        set_props(names.RENAME_PROBLEM, {"children": None})
        set_props(names.RENAME_DIALOG, {"opened": True})
    elif action == "trash":
        _notify(changes.undo_notice("Dataset deleted", f"{name} is in the trash.", {"restore": workspace.trash(name)}))
    elif action == "analyse":
        started = [jobs.start(workspace, one) for one in analyses.missing(workspace, name)]
        set_props(JOB_STARTED, {"data": started[-1].id if started else None})
        words = ", ".join(job.title.partition(":")[0] for job in started)
        title = "Analysing everything" if started else "Everything is analysed"
        _notify(notice(title, words or "All results are there."))
    elif action == "empty":
        deleted = workspace.empty_trash()
        set_props(names.TRASH_LIST, {"children": layout.trash_list(workspace.trashed())})
        _notify(notice("Trash emptied", f"{deleted} dataset{'s' if deleted != 1 else ''} deleted for good."))


def _choose_clips(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.CLIPS_CHOSEN, "children"),
        Output(names.CLIPS_ALL, "data"),
        Input(names.CLIPS_TABLE, "selectedRows"),
        Input(names.CLIPS_ALL, "data"),
        Input(names.CLIPS_TABLE, "filterModel"),
        State(DATASET, "data"),
    )
    def show_chosen(rows, every, filters, name):
        if not long_lists.is_long(workspace, name):
            return layout.clips_chosen(len(rows or ())), no_update
        here = len(long_lists.clips_of(workspace, name).order(filters))
        if every and (every.get("dataset") != name or (every.get("filter") or {}) != (filters or {})):
            return layout.clips_chosen(len(rows or ()), here), None  # other clips match now
        return layout.clips_chosen(here if every else len(rows or ()), here), no_update

    @app.callback(
        Output(names.CLIPS_TABLE, "selectedRows"),
        Input(names.CLIPS_ACTION, "data"),
        State(names.CLIPS_TABLE, "selectedRows"),
        State(names.CLIPS_ALL, "data"),
        State(names.CLIPS_TABLE, "filterModel"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def act_on_clips(request, rows, every, filters, name):
        action = (request or {}).get("action")
        if action == "all":
            set_props(names.CLIPS_ALL, {"data": {"dataset": name, "filter": filters or {}}})
            return no_update
        try:
            clips = long_lists.chosen_names(workspace, name, rows, every)
            if action in _OPENS and clips:
                set_props(_OPENS[action], {"data": {"dataset": name, "clips": list(clips), "at": time.time()}})
                return no_update
            if action == "remove" and clips:
                if len(clips) == workspace.info(name).clips:
                    raise WorkspaceError("These are all its clips; delete the dataset instead.")
                changes.start(workspace, requests.remove_request(name, clips))
        except WorkspaceError as error:
            _notify(notice("That did not work", str(error), "red"))
            return no_update
        set_props(names.CLIPS_ALL, {"data": None})
        return []


def _start(workspace: Workspace, request: analyses.Request) -> None:
    """Starts a job and updates the job bar. Raises WorkspaceError, ParameterError."""
    job = jobs.start(workspace, request)
    set_props(JOB_STARTED, {"data": job.id})
    set_props(JOB_POKE, {"data": time.time()})


def _notify(message: dict) -> None:
    set_props(NOTICES, {"sendNotifications": [message]})
