"""The Library page's callbacks: look at the workspace, show; take an action, do it."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import dash_mantine_components as dmc
from dash import ALL, Dash, Input, Output, State, ctx, no_update, set_props
from dash.dependencies import ClientsideFunction

from core import analyses
from core.parameters import ParameterError
from core.workspace import Workspace, WorkspaceError, check_name
from webapp import jobs
from webapp.components.actions import sends
from webapp.components.errors import empty_state, notice
from webapp.figures import library_tables as tables
from webapp.figures.tables import grid
from webapp.pages.library import layout


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    _show(app, workspace)
    _act(app, workspace)
    _upload(app, workspace)


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(Output("dataset-cards", "children"), Input("revision", "data"), Input("dataset", "data"))
    def show_cards(_revision, chosen):
        return layout.dataset_cards(workspace.datasets(), chosen)

    @app.callback(
        Output("dataset-detail", "children"),
        Input("dataset", "data"),
        Input("revision", "data"),
        State("selection", "data"),
    )
    def show_detail(name, _revision, _selection):
        if not name:
            return None
        try:
            dataset = workspace.open(name)
        except WorkspaceError as error:
            return empty_state("warning", "This dataset cannot be shown", str(error))
        files = dataset.report.files
        shown = {
            "clips": grid("clips-table", tables.CLIP_COLUMNS, tables.clip_rows(dataset), "Clips"),
            "report": grid("report-table", tables.REPORT_COLUMNS, tables.report_rows(files), "Import report"),
        }
        return layout.detail(name, shown, Counter(file.verdict for file in dataset.report.files))

    @app.callback(
        Output("report-table", "rowData"),
        Input("report-filter", "value"),
        State("dataset", "data"),
        prevent_initial_call=True,
    )
    def filter_report(verdict, name):
        try:
            files = workspace.report(name).files
        except WorkspaceError:
            return []
        return tables.report_rows(files, verdict or "all")

    app.clientside_callback(
        ClientsideFunction("tables", "mark"),
        Output("clips-marked", "data"),
        Input("selection", "data"),
        Input("clips-table", "rowData"),
        State("clips-table", "id"),
    )


def _act(app: Dash, workspace: Workspace) -> None:
    @app.callback(Input("dataset-action", "data"), prevent_initial_call=True)
    def act(request):
        try:
            perform(workspace, request or {})
        except WorkspaceError as error:
            _say(notice("That did not work", str(error), "red"))
        set_props("job-poke", {"data": time.time()})
        set_props("trash-revision", {"data": time.time()})

    @app.callback(
        Output("rename-dialog", "opened"),
        Output("rename-problem", "children"),
        Input("rename-save", "n_clicks"),
        Input("rename-name", "n_submit"),
        State("rename-old", "data"),
        State("rename-name", "value"),
        State("dataset", "data"),
        prevent_initial_call=True,
    )
    def rename(_clicks, _submits, old, new, chosen):
        try:
            info = workspace.rename(old, new or "")
        except WorkspaceError as error:
            return no_update, str(error)
        if chosen == old:
            set_props("dataset", {"data": info.name})
        set_props("job-poke", {"data": time.time()})
        return False, None

    @app.callback(
        Output("trash-dialog", "opened"),
        Output("trash-list", "children"),
        Input("trash-open", "n_clicks"),
        Input("trash-revision", "data"),
        prevent_initial_call=True,
    )
    def show_trash(_clicks, _revision):
        return True if ctx.triggered_id == "trash-open" else no_update, layout.trash_list(workspace.trashed())

    @app.callback(Input({"type": "demo", "at": ALL}, "n_clicks"), prevent_initial_call=True)
    def open_demo(clicks):
        if any(clicks):
            _ask(workspace, analyses.Request(analyses.DEMO, "demo"))
            _say(notice("Making the demo", "It appears here in a moment, with its motif graph."))


def perform(workspace: Workspace, request: Mapping[str, object]) -> None:
    """Does what a button of a dataset's card or of the trash asks for; raises WorkspaceError."""
    action, name, token = (str(request.get(key) or "") for key in ("action", "dataset", "token"))
    if action == "rename":
        set_props("rename-old", {"data": name})
        set_props("rename-name", {"value": name})
        set_props("rename-problem", {"children": None})
        set_props("rename-dialog", {"opened": True})
    elif action == "trash":
        _say(_undo_notice(name, workspace.trash(name)))
    elif action == "restore":
        info = workspace.restore(token)
        _say(notice("Restored", f"{info.name} is back in the library."))
        set_props("awaited", {"data": info.name})
    elif action == "empty":
        gone = workspace.empty_trash()
        _say(notice("Trash emptied", f"{gone} dataset{'s' if gone != 1 else ''} deleted for good."))


def _upload(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output("upload-dialog", "opened"),
        Input("upload-open", "n_clicks"),
        Input({"type": "add", "at": ALL}, "n_clicks"),
        prevent_initial_call=True,
    )
    def open_dialog(clicked, others):
        return True if clicked or any(others) else no_update

    @app.callback(
        Output("upload-import", "disabled"),
        Output("upload-name", "value"),
        Input("upload", "data"),
        State("upload-name", "value"),
        prevent_initial_call=True,
    )
    def show_upload(upload, name):
        upload = upload or {}
        ready = bool(upload.get("done") and upload.get("received"))
        if not upload.get("total"):
            return True, ""
        return not ready, name or workspace.free_name(str(upload.get("name") or ""))

    @app.callback(
        Output("upload-problem", "children"),
        Output("uploaded", "data"),
        Output("upload-dialog", "opened", allow_duplicate=True),
        Input("upload-import", "n_clicks"),
        Input("upload-name", "n_submit"),
        State("upload", "data"),
        State("upload-name", "value"),
        State("upload-fps", "value"),
        prevent_initial_call=True,
    )
    def import_upload(_clicks, _submits, upload, name, fps):
        upload = upload or {}
        if not (upload.get("done") and upload.get("received")):
            return "Add at least one file, and wait until all have arrived.", no_update, no_update
        try:
            name = check_name(name or "")
            token = str(upload.get("token"))
            options = companions(workspace.uploads.path(token))
            if fps not in (None, ""):
                options["fps"] = float(fps)
            _ask(workspace, analyses.import_request(name, token, **options))
        except (WorkspaceError, ParameterError, ValueError) as error:
            return str(error), no_update, no_update
        set_props("awaited", {"data": name})
        return None, upload.get("token"), False

    app.clientside_callback(
        ClientsideFunction("upload", "closed"),
        Output("upload", "data"),
        Input("upload-dialog", "opened"),
        State("uploaded", "data"),
        prevent_initial_call=True,
    )


def companions(folder: Path) -> dict[str, Any]:
    """The only label file and the only skeleton of an upload, wherever in it they lie, as options of the import."""
    found = {"labels": sorted(folder.rglob("*.csv")), "skeleton": sorted(folder.rglob("*.asf"))}
    return {name: paths[0].relative_to(folder).as_posix() for name, paths in found.items() if len(paths) == 1}


def _ask(workspace: Workspace, request: analyses.Request) -> None:
    """Enters a job and has the bar look at once; raises WorkspaceError, ParameterError."""
    job = jobs.start(workspace, request)
    set_props("job-started", {"data": job.id})


def _say(message: dict) -> None:
    set_props("notices", {"sendNotifications": [message]})


def _undo_notice(name: str, token: str) -> dict:
    action = {"action": "restore", "token": token}
    undo = dmc.Button("Undo", size="compact-sm", variant="light", **sends("dataset-action", action, every_time=True))
    body = dmc.Group([dmc.Text(f"{name} is in the trash.", size="sm", truncate="end"), undo], gap=12, wrap="nowrap")
    return notice("Dataset deleted", body, autoClose=12000)
