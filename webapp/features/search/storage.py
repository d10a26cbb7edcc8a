"""The view of what the indexes hold: segments, patterns, time and sizes for every engine (Tables 1 to 3 of PCR)."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path

from dash import Dash, Input, Output, State, html, no_update
from dash.development.base_component import Component

from core.caching import RecentCache
from core.retrieval.storage import Storage, storage_of
from core.workspace import Workspace
from webapp.features.search import names
from webapp.features.search.engines import ENGINES
from webapp.features.search.figures import storage as figures
from webapp.shell import settings
from webapp.shell.names import DATASET, REVISION, VIEW

PAGE = "search"
LONGEST = 5.0  # seconds of the clip whose query is timed, at most
HINT = (
    "What the index of each engine holds, with the settings of this page. The engines of the 2009 paper cut every part "
    "of the body into segments and learn patterns from them; the other engine keeps postures alone. Choose an engine "
    "under Search and build its index to see it here."
)


def layout() -> Component:
    """The panel before any data is loaded."""
    return html.Div(
        [html.P(HINT, className="muted study-hint"), html.Div(id=names.SEARCH_STORAGE)],
        className="study",
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the panel's callback."""

    @app.callback(
        Output(names.SEARCH_STORAGE, "children"),
        Input(VIEW, "data"),
        Input(names.METHOD.result_key, "data"),
        Input(DATASET, "data"),
        Input(REVISION, "data"),
        State(names.SEARCH_STORAGE, "id"),
    )
    def show(view, _key, name, _revision, _place):
        if (view or {}).get("look") != "indexes":
            return no_update
        return result(workspace, name, view) if name else []


def indexes_of(workspace: Workspace, dataset: str, view: Mapping[str, str] | None) -> dict[str, Storage | None]:
    """Engine -> the figures of its index with a view's other settings, None where it has not been built."""
    found: dict[str, Storage | None] = {}
    clips = workspace.open(dataset).clips
    clip = clips[len(clips) // 2] if clips else None
    query = clip and clip.cut(0, min(clip.n_frames, round(LONGEST * clip.fps)))
    for method in ENGINES:
        wanted = settings.in_link(PAGE, {**settings.request_of(PAGE, dataset, view).parameters, "method": method})
        others = {k: text for k, text in (view or {}).items() if k not in settings.keys(PAGE)}
        shown = others | wanted
        key = settings.key_of(workspace, PAGE, dataset, shown)
        index = settings.result_of(workspace, PAGE, dataset, shown)
        if key is None or index is None:
            found[method] = None
        else:  # its query is timed by searching, which a page that only opens again need not do
            found[method] = _storages.get_or_compute((workspace.path, key), partial(storage_of, index, query))
    return found


_storages: RecentCache[tuple[Path, str], Storage] = RecentCache(16)  # by workspace and key of the index


def result(workspace: Workspace, dataset: str, view: Mapping[str, str] | None) -> list[Component]:
    """The tables of a data set."""
    indexes = indexes_of(workspace, dataset, view)
    tables = [figures.storage_table(indexes, ENGINES), *figures.nodes_tables(indexes, ENGINES)]
    return [html.Div(one, className="card study-figures section") for one in tables]
