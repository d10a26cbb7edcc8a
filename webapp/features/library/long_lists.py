"""The Library's tables of datasets with thousands of clips: rows stay on the server, and so does what is chosen."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from dash import Dash, Input, Output, State, no_update

from core.caching import RecentCache
from core.workspace import Workspace, WorkspaceError
from webapp.features.library import names
from webapp.features.library.figures import tables
from webapp.shell.names import DATASET
from webapp.ui.long_tables import LONG, LongTable

_tables: RecentCache[tuple[Path, str, str, str], LongTable] = RecentCache(6)  # by workspace, folder, name and what


def is_long(workspace: Workspace, name: str | None) -> bool:
    """Whether the tables of a dataset stay on the server."""
    try:
        return bool(name) and workspace.info(str(name)).clips > LONG
    except WorkspaceError:
        return False


def clips_of(workspace: Workspace, name: str) -> LongTable:
    """The table of clips; raises WorkspaceError where there is no such dataset."""
    key = workspace.path, workspace.info(name).folder, name, "clips"
    return _tables.get_or_compute(key, lambda: tables.ClipRows(workspace.open(name)).long_table())


def files_of(workspace: Workspace, name: str, shown: str) -> LongTable:
    """The table of the import report's files that ``shown`` names; raises WorkspaceError."""
    key = workspace.path, workspace.info(name).folder, name, f"files {shown}"
    return _tables.get_or_compute(key, lambda: tables.report_table(workspace.report(name).files, shown))


def matching(workspace: Workspace, name: str, filters: object) -> list[str]:
    """Names of the clips that the filters of the table leave; raises WorkspaceError."""
    clips = workspace.open(name).clips
    return [clips[k].name for k in clips_of(workspace, name).order(filters).tolist()]


def chosen_names(
    workspace: Workspace, name: str, rows: Sequence[Mapping[str, Any]] | None, every: Mapping[str, Any] | None
) -> list[str]:
    """Names of the chosen clips: all that match where that was asked for, else those whose boxes are ticked.

    Raises WorkspaceError.
    """
    if every and every.get("dataset") == name:
        return matching(workspace, name, every.get("filter"))
    return [str(row["clip"]) for row in rows or ()]


def register(app: Dash, workspace: Workspace) -> None:
    """The callbacks that answer the tables' requests for rows."""

    @app.callback(
        Output(names.CLIPS_TABLE, "getRowsResponse"),
        Input(names.CLIPS_TABLE, "getRowsRequest"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def rows_of_clips(request, name):
        return _block(lambda: clips_of(workspace, name), request)

    @app.callback(
        Output(names.REPORT_TABLE, "getRowsResponse"),
        Input(names.REPORT_TABLE, "getRowsRequest"),
        State(names.REPORT_FILTER, "value"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def rows_of_files(request, shown, name):
        return _block(lambda: files_of(workspace, name, str(shown or "all")), request)


def _block(table: Any, request: Any) -> Any:
    if not isinstance(request, Mapping):
        return no_update
    try:
        return table().block(request)
    except WorkspaceError:  # the dataset has gone meanwhile
        return {"rowData": [], "rowCount": 0}
