"""Adding recordings: a dialog that takes files, asks where to add them, and starts the job."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import Any

import dash_mantine_components as dmc
from dash import ALL, Dash, Input, Output, State, ctx, html, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses, requests
from core.errors import MotionscapeError
from core.workspace import Workspace, check_name
from webapp import jobs
from webapp.features.library import names, reading
from webapp.jobs import changes
from webapp.jobs.names import JOB_POKE
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.names import AWAITED, DATASET, JOB_STARTED
from webapp.shell.uploads import SUFFIXES, Limits

NEW = "new"
INTO = "into:"  # and the name of the dataset
HIDDEN = {"display": "none"}  # by a style, because the dialog's focus trap ignores classes


def dialog(limits: Limits) -> Component:
    """The dialog: choose or drop files, follow the upload, choose where to add them, add them."""
    return dmc.Modal(
        id=names.UPLOAD_DIALOG,
        title="Add recordings or labels",
        size="xl",
        keepMounted=True,
        closeOnClickOutside=False,
        children=[
            _drop_zone(limits),
            html.Div(html.Div(id=names.UPLOAD_BAR), id=names.UPLOAD_PROGRESS, className="upload-progress hidden"),
            html.Div(
                id=names.UPLOAD_SUMMARY,
                className="muted upload-summary",
                role="status",
                **attributes(aria_live="polite"),
            ),
            html.Ul(id=names.UPLOAD_LIST, className="upload-list", tabIndex="0", **attributes(aria_label="Files")),
            html.Div(
                className="upload-choices",
                children=[
                    dmc.Select(
                        id=names.UPLOAD_TARGET,
                        label="Add to",
                        data=targets(()),
                        value=NEW,
                        allowDeselect=False,
                        searchable=True,
                        comboboxProps={"shadow": "md"},
                    ),
                    dmc.TextInput(id=names.UPLOAD_NAME, label="Name of the dataset", placeholder="Walks in the park"),
                    html.Div(
                        id=names.UPLOAD_LABELS_BOX,
                        style=HIDDEN,
                        children=[
                            html.Label("Labels there now", className="choice-label", id=names.UPLOAD_LABELS_LABEL),
                            dmc.SegmentedControl(
                                id=names.UPLOAD_LABELS,
                                data=[{"value": "add", "label": "Keep"}, {"value": "replace", "label": "Replace"}],
                                value="add",
                                fullWidth=True,
                                **attributes(aria_labelledby=names.UPLOAD_LABELS_LABEL),
                            ),
                        ],
                    ),
                    reading.fold(),
                    dmc.Button("Import", id=names.UPLOAD_IMPORT, disabled=True),
                ],
            ),
            html.Div(id=names.UPLOAD_PROBLEM, className="form-problem", role="alert"),
        ],
    )


def _drop_zone(limits: Limits) -> Component:
    buttons = [("Choose files", "files"), ("Choose a folder", "folder")]
    return html.Div(
        id=names.DROP_ZONE,
        className="drop-zone",
        children=[
            icon("upload", 30),
            html.Div("Drop files, folders or a zip here", className="drop-title"),
            html.Div(
                [
                    dmc.Button(words, variant="default", size="compact-sm", **attributes(data_chooses=what))
                    for words, what in buttons
                ],
                className="drop-buttons",
            ),
            html.Div(limits.sentence(), className="muted drop-limits"),
        ],
        **attributes(
            data_file_bytes=limits.file_bytes,
            data_total_bytes=limits.total_bytes,
            data_files=limits.files,
            data_suffixes=" ".join(SUFFIXES),
        ),
    )


def targets(datasets: Sequence[str]) -> list[dict[str, Any]]:
    """Options of where the files are added: a new dataset, or one of ``datasets``."""
    existing = [{"value": f"{INTO}{name}", "label": name} for name in datasets]
    new = {"value": NEW, "label": "A new dataset"}
    return [new, {"group": "Datasets here", "items": existing}] if existing else [new]


def into(target: str | None) -> str | None:
    """The dataset of a choice in the dialog; None for a new one."""
    return target.removeprefix(INTO) if target and target.startswith(INTO) else None


def problem_of(upload: Mapping[str, Any] | None, name: str | None) -> str:
    """Why the upload cannot be added to the dataset ``name`` (None: a new one) yet; empty where it can."""
    upload = upload or {}
    if not (upload.get("done") and upload.get("received")):
        return "Add at least one file, and wait until all have arrived."
    if not upload.get("recordings") and not (name and upload.get("labels")):
        if upload.get("labels"):
            return "Labels alone need a dataset that is there: choose it under “Add to”."
        return "There is no recording among these files (BVH, or AMC with its ASF)."
    return ""


def request_for(
    upload: Mapping[str, Any], name: str | None, new: str, labels: str, how: Mapping[str, Any]
) -> analyses.Request:
    """The request that adds an upload to the dataset ``name``, or makes the dataset ``new`` of it.

    how: what reading.import_options gives. Raises WorkspaceError, ParameterError.
    """
    options = how if upload.get("recordings") or upload.get("archives") else {}
    token = str(upload.get("token"))
    if name:
        return requests.add_request(name, token, labels=labels or "add", **options)
    return requests.import_request(check_name(new), token, **options)


def suggested_name(workspace: Workspace, upload: Mapping[str, Any]) -> str:
    """A free name for the dataset of an upload, by its folder or first file; it also stands for one left empty."""
    return workspace.free_name(str(upload.get("name") or ""))


def register(app: Dash, workspace: Workspace) -> None:
    """The dialog's callbacks."""
    _open(app, workspace)
    _choose(app, workspace)
    _ask(app, workspace)
    app.clientside_callback(
        ClientsideFunction("upload", "closed"),
        Output(names.UPLOAD, "data"),
        Input(names.UPLOAD_DIALOG, "opened"),
        State(names.UPLOADED, "data"),
        prevent_initial_call=True,
    )


def _open(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.UPLOAD_DIALOG, "opened"),
        Output(names.UPLOAD_TARGET, "data"),
        Output(names.UPLOAD_TARGET, "value"),
        Input(names.UPLOAD_OPEN, "n_clicks"),
        Input(names.ADD(ALL), "n_clicks"),
        Input(names.UPLOAD_INTO, "data"),
        prevent_initial_call=True,
    )
    def open_dialog(clicked, others, target):
        if ctx.triggered_id != names.UPLOAD_INTO and not (clicked or any(others)):
            return no_update, no_update, no_update
        datasets = [info.name for info in workspace.datasets()]
        requested = (target or {}).get("dataset") if ctx.triggered_id == names.UPLOAD_INTO else None
        return True, targets(datasets), f"{INTO}{requested}" if requested in datasets else NEW


def _choose(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.UPLOAD_TARGET, "value", allow_duplicate=True),
        Output(names.UPLOAD_SUGGESTED, "data"),
        Input(names.UPLOAD, "data"),
        State(names.UPLOAD_TARGET, "value"),
        State(DATASET, "data"),
        prevent_initial_call=True,
    )
    def name_upload(upload, target, chosen):
        upload = upload or {}
        if not upload.get("total"):
            return no_update, ""
        only_labels = upload.get("done") and upload.get("labels") and not upload.get("recordings")
        target = f"{INTO}{chosen}" if only_labels and target == NEW and chosen else no_update
        return target, suggested_name(workspace, upload)

    app.clientside_callback(
        ClientsideFunction("upload", "name"),
        Output(names.UPLOAD_NAME, "value"),
        Input(names.UPLOAD_SUGGESTED, "data"),
        State(names.UPLOAD_NAME, "value"),
        prevent_initial_call=True,
    )

    @app.callback(
        Output(names.UPLOAD_IMPORT, "disabled"),
        Output(names.UPLOAD_IMPORT, "children"),
        Output(names.UPLOAD_NAME, "style"),
        Output(names.UPLOAD_LABELS_BOX, "style"),
        Output(names.UPLOAD_PROBLEM, "children", allow_duplicate=True),
        Input(names.UPLOAD, "data"),
        Input(names.UPLOAD_TARGET, "value"),
        prevent_initial_call=True,
    )
    def show_choices(upload, target):
        upload, name = upload or {}, into(target)
        shown = {True: {}, False: HIDDEN}
        problem = problem_of(upload, name)
        return (
            bool(problem),
            "Add" if name else "Import",
            shown[name is None],
            shown[name is not None and bool(upload.get("labels") or upload.get("archives"))],
            problem if upload.get("done") and upload.get("received") else None,
        )


def _ask(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.UPLOAD_PROBLEM, "children"),
        Output(names.UPLOADED, "data"),
        Output(names.UPLOAD_DIALOG, "opened", allow_duplicate=True),
        Input(names.UPLOAD_IMPORT, "n_clicks"),
        Input(names.UPLOAD_NAME, "n_submit"),
        State(names.UPLOAD, "data"),
        State(names.UPLOAD_TARGET, "value"),
        State(names.UPLOAD_NAME, "value"),
        State(names.UPLOAD_LABELS, "value"),
        State(names.UPLOAD_UNIT, "value"),
        State(names.UPLOAD_UP, "value"),
        State(names.UPLOAD_FPS, "value"),
        State(names.UPLOAD_POINTS, "value"),
        State(names.UPLOAD_SMOOTH, "value"),
        prevent_initial_call=True,
    )
    def add_upload(_clicks, _submits, upload, target, new, labels, *how):
        name = into(target)
        if problem := problem_of(upload, name):
            return problem, no_update, no_update
        try:
            new = (new or "").strip() or suggested_name(workspace, upload or {})
            request = request_for(upload, name, new, labels, reading.import_options(*how))
            if name:
                changes.start(workspace, request)
            else:
                set_props(JOB_STARTED, {"data": jobs.start(workspace, request).id})
                set_props(AWAITED, {"data": request.dataset})
            set_props(JOB_POKE, {"data": time.time()})
        except MotionscapeError as error:
            return str(error), no_update, no_update
        return None, upload.get("token"), False
