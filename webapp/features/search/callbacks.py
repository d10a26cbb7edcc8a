"""The Search page's callbacks: what there is to choose from, the hits of the search, uploaded queries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice
from typing import Any
from urllib.parse import urlencode

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, ctx, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.errors import MotionscapeError
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError
from webapp.features.search import names, recipes, searching, uploaded
from webapp.features.search.figures import hits as figures
from webapp.features.search.layout import METHOD
from webapp.features.search.queries import Piece, write_query
from webapp.features.search.searching import PAGE
from webapp.jobs.names import JOBS_SEEN
from webapp.jobs.running import running
from webapp.shell import results, settings
from webapp.shell.buttons import copies
from webapp.shell.errors import sentence
from webapp.shell.icons import icon
from webapp.shell.names import (
    DATASET,
    JOB_STARTED,
    MOTIF_METHOD,
    REVISION,
    SELECTION,
    THEME,
    VIEW,
    VIEW_CHANGE,
)
from webapp.ui import method_page
from webapp.ui.long_tables import LONG, OFFERED
from webapp.ui.tables import labels_by_clip
from webapp.ui.views import register_switch


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
    method_page.register(app, workspace, METHOD)
    _choices(app, workspace)
    _search(app, workspace)
    _menus(app, workspace)
    _upload(app, workspace)
    register_switch(app, names.SEARCH_LOOK)


def _choices(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SEARCH_CLIPS, "data"),
        Input(DATASET, "data"),
        Input(REVISION, "data"),
        Input(names.SEARCH_TYPED, "data"),
    )
    def list_clips(name, _revision, typed):
        try:
            dataset = workspace.open(name) if name else None
        except WorkspaceError:
            dataset = None
        if dataset is None:
            return None
        if ctx.triggered_id == names.SEARCH_TYPED and len(dataset.clips) <= LONG:
            return no_update  # the browser has them all
        return {
            "dataset": dataset.name,
            "version": dataset.fingerprint,
            "clips": [[clip.name, clip.n_frames] for clip in offered_clips(dataset, typed)],
            "actions": sorted({label.action for label in dataset.labels}),
        }

    @app.callback(
        Output(names.SEARCH_MOTIFS, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        Input(names.SEARCH_MOTIF, "id"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def list_motifs(_key, _place, name, view):
        try:
            graph = results.motif_graph(workspace, name, view) if name else None
            notes = results.motif_notes(workspace, name, view) if graph else {}
        except WorkspaceError:
            return []
        return [
            {
                "name": (notes[m.id].name if m.id in notes else "") or f"Motif {m.id}",
                "motions": len(m.segments),
                "query": write_query([Piece(*m.segments[m.medoid])]),
            }
            for m in (graph.motifs if graph else ())
        ]


def _search(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SEARCH_FOUND, "data"),
        Input(VIEW, "data"),
        Input(names.METHOD.result_key, "data"),
        Input(DATASET, "data"),
        Input(REVISION, "data"),
        State(names.SEARCH_FOUND, "data"),
    )
    def search(view, key, name, revision, before):
        inputs = searching.search_keys_of(view) | {"index": key, "dataset": name, "revision": revision}
        if before and before["inputs"] == inputs:
            return no_update
        if not name:
            return {"inputs": inputs}
        try:
            return {"inputs": inputs, **found_data(workspace, workspace.open(name), view)}
        except MotionscapeError as error:
            return {"inputs": inputs, "error": sentence(error)}

    app.clientside_callback(
        ClientsideFunction("search", "draw"),
        Output(names.SEARCH_DRAWN, "data"),
        Input(names.SEARCH_FOUND, "data"),
        Input(VIEW, "data"),
        Input(names.SEARCH_CLIPS, "data"),
        Input(names.SEARCH_MOTIFS, "data"),
        Input(THEME, "data"),
        State(names.SEARCH_PRESETS, "data"),
        State(names.SEARCH_PARTS, "data"),
        State(names.SEARCH_ENGINES, "data"),
        State(names.METHOD.result_key, "data"),
        State(SELECTION, "data"),
    )


def offered_clips(dataset: Dataset, typed: str | None) -> Sequence[Clip]:
    """The clips one may choose from: all, or of thousands some whose names have what was ``typed``."""
    if len(dataset.clips) <= LONG:
        return dataset.clips
    asked = str(typed or "").lower()
    return list(islice((clip for clip in dataset.clips if asked in clip.name.lower()), OFFERED))


def found_data(workspace: Workspace, dataset: Dataset, view: Mapping[str, str] | None) -> dict[str, Any]:
    """The query and its hits as assets/search/search.mjs draws them. Raises MotionscapeError for a bad query."""
    search = searching.read(view)
    if search is None:
        searching.warm(workspace, dataset, view)
        return {}
    query = searching.query_of(workspace, dataset, search.pieces)
    sources = [searching.source_of(workspace, dataset, piece) for piece in search.pieces]
    data: dict[str, Any] = {
        "pieces": [
            figures.piece_row(source, part, number, dataset)
            for number, (source, part) in enumerate(zip(sources, query.parts, strict=True))
        ],
        "level": searching.level_of(search, query),
        "request": figures.query_request(dataset, sources, query),
    }
    try:
        result = searching.find(workspace, dataset, view)
        if result is None:
            return data
        labels = labels_by_clip(dataset)
        rows = [
            figures.hit_row(dataset, hit, rank, searching.tag_of(labels, hit.segment))
            for rank, hit in enumerate(result.hits, 1)
        ]
        doubt = searching.doubt(workspace, dataset, view, query)
    except MotionscapeError as error:
        return data | {"error": sentence(error)}
    found = {"hits": rows, "total": result.total, "milliseconds": round(result.milliseconds, 1), "doubt": doubt}
    return data | found | {"unlike": result.unlike, "chances": result.chances}


def _menus(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SEARCH_MENUS, "children"),
        Input(names.SEARCH_FOUND, "data"),
        State(names.METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def show_menus(result, key, name, view):
        if not key or not name:
            return []
        search = searching.read(view) if result and result.get("hits") else None
        return [_download(workspace, name, view, search, result["level"])] if search else []


def _download(
    workspace: Workspace, name: str, view: Mapping[str, str], search: searching.Search, level: str
) -> Component:
    settled = settings.view_of(PAGE, settings.request_of(PAGE, name, view).parameters)
    query = urlencode({"dataset": name, **searching.search_keys_of(view), **{k: v for k, v in settled.items() if v}})
    request = settings.request_of(PAGE, name, view)
    again = recipes.texts(workspace.path, request, search, level)
    items = [
        dmc.MenuItem("Hits (CSV)", href=f"/api/search/hits.csv?{query}", refresh=True),
        dmc.MenuItem("Hits (JSON)", href=f"/api/search/hits.json?{query}", refresh=True),
        dmc.MenuDivider(),
        *(dmc.MenuItem(label, **copies(text)) for label, text in again.items()),
    ]
    target = dmc.Button("Download", variant="default", leftSection=icon("download", 16))
    return dmc.Menu([dmc.MenuTarget(target), dmc.MenuDropdown(items)], shadow="md", position="bottom-end")


def _upload(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.SEARCH_UPLOAD_JOB, "data"),
        Output(names.SEARCH_UPLOAD_STATUS, "children"),
        Input(names.SEARCH_UPLOAD, "data"),
        prevent_initial_call=True,
    )
    def read(upload):
        if not (upload or {}).get("token"):
            return None, []
        try:
            job = uploaded.start(workspace, str(upload.get("name") or "recording"), str(upload["token"]))
        except MotionscapeError as error:
            return None, [_problem(sentence(error))]
        set_props(JOB_STARTED, {"data": job.id})
        return {"job": job.id}, [running(job, f"Reading {upload.get('name')}", "upload")]

    @app.callback(
        Output(names.SEARCH_UPLOAD_JOB, "data", allow_duplicate=True),
        Output(names.SEARCH_UPLOAD_STATUS, "children", allow_duplicate=True),
        Input(JOBS_SEEN, "data"),
        Input(names.SEARCH_UPLOAD_JOB, "data"),
        prevent_initial_call=True,
    )
    def took(_seen, reading):
        job = workspace.jobs.get(reading["job"]) if reading else None
        if job is None or job.alive:
            return no_update, no_update
        if job.state != "done":
            why = job.error if job.state == "failed" else "Reading the recording was cancelled."
            return None, [_problem(why)]
        try:
            clip = uploaded.open_upload(workspace, job.key).clips[0]
        except WorkspaceError as error:
            return None, [_problem(sentence(error))]
        piece = Piece(clip.name, 0, clip.n_frames, dataset=uploaded.name_of(job))
        set_props(VIEW_CHANGE, {"data": {"query": write_query([piece]), "hit": ""}})
        return None, []


def _problem(words: str) -> Component:
    return dmc.Alert(words, color="red", title="This recording cannot be used", withCloseButton=True)
