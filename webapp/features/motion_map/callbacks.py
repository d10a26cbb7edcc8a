"""The Map page's callbacks; keys, reach and hits are handled in the browser (assets/motion_map/map.mjs)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import plotly.graph_objects as go
from dash import Dash, Input, Output, State, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.errors import ParameterError
from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.motion_map import layers
from core.motion_map.motion_map import MotionMap
from core.workspace import Workspace, WorkspaceError
from webapp.features.motion_map import layout, names, panels
from webapp.features.motion_map.figures import heatmap as figures
from webapp.features.motion_map.maps import other_maps
from webapp.shell import results, settings
from webapp.shell.feature import Values
from webapp.shell.messages import notice
from webapp.shell.names import DATASET, MOTIF_METHOD, NOTICES, REVISION, SELECTION, THEME, VIEW
from webapp.shell.results import find_motifs
from webapp.ui import method_page, tables
from webapp.ui.views import register_switch

METHOD = layout.METHOD


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the page's callbacks."""
    method_page.register(app, workspace, METHOD)
    _show(app, workspace)
    _draw(app, workspace)
    _below(app, workspace)
    _browser(app)


def opened(
    workspace: Workspace, dataset: str | None, view: Mapping[str, Any] | None
) -> tuple[MotionMap, Dataset] | None:
    """The map that a view shows and its data set; None where there is none."""
    motion_map = settings.result_of(workspace, "map", dataset, view)
    try:
        return (motion_map, workspace.open(dataset)) if dataset and motion_map is not None else None
    except WorkspaceError:
        return None


def lit_nodes(motion_map: MotionMap, graph: MotifGraph | None, selection: Mapping[str, Any]) -> list[int]:
    """Nodes that the motions of the selected motifs pass, row by row in the grid; none where no motif is selected."""
    motifs = find_motifs(graph, selection) if graph is not None else []
    if not motifs:
        return []
    segments = [segment for motif in motifs for segment in motif.segments]
    return np.flatnonzero(layers.seconds_on_nodes(motion_map, [segments])[0]).tolist()


def facts_of(motion_map: MotionMap, dataset: Dataset) -> dict[str, Any]:
    """What is shown about a node beside its posture: names of labels, and [[label, seconds], ...] of each node."""
    groups: dict[str, list[Segment]] = figures.label_segments(dataset)
    seconds = layers.seconds_on_nodes(motion_map, list(groups.values()))
    seconds = seconds.reshape(len(groups), motion_map.grid[0] * motion_map.grid[1])
    order = np.argsort(-seconds, axis=0, kind="stable")[:4]
    labels = [
        [[int(k), round(float(seconds[k, node]), 2)] for k in order[:, node] if seconds[k, node] > 0]
        for node in range(seconds.shape[1])
    ]
    return {"names": list(groups), "labels": labels}


def first_values(workspace: Workspace, dataset: str, view: Mapping[str, str]) -> Values:
    """The page with its map, for the layout that the browser gets first; nothing where there is no result."""
    key = settings.key_of(workspace, "map", dataset, view)
    shown = opened(workspace, dataset, view) if key else None
    if key is None or shown is None:
        return {}
    known, class_name, menus, more = known_map(workspace, key, dataset, view)
    painted = painted_for(known, view, None, settings.key_of(workspace, results.MOTIFS, dataset, view))
    figure, legend, explanation = drawn(workspace, shown, painted, view)
    return {
        names.METHOD.result_key: {"data": key},
        names.MAP_KNOWN: {"data": known},
        names.MAP_RESULT: {"className": class_name},
        names.MAP_MENUS: {"children": menus},
        names.MAP_MORE: {"children": more},
        names.MAP_GRAPH: {"figure": figure},
        names.MAP_LEGEND: {"children": legend},
        names.MAP_EXPLANATION: {"children": explanation},
        names.MAP_PAINTED: {"data": painted},
    }


def known_map(
    workspace: Workspace, key: str | None, name: str | None, view: Mapping[str, Any] | None
) -> tuple[dict[str, Any] | None, str, list[Component], Any]:
    """What the browser knows of the map with this key, the class of its place, its menus, and the note above it."""
    shown = opened(workspace, name, view) if key else None
    others = other_maps(workspace, name)
    earlier = [*layout.others_menu(others), *method_page.earlier_menu(workspace, METHOD, name, shown is not None)]
    if shown is None:
        return None, "hidden", layout.menus(None, earlier, []), layout.extend_note(others, name)
    motion_map, dataset = shown
    known: dict[str, Any] = {"key": key, "dataset": dataset.name, "version": dataset.fingerprint}
    known["facts"] = facts_of(motion_map, dataset)
    copies = method_page.copy_items(workspace, METHOD, dataset.name, view)
    note = layout.laid_note(float(motion_map.fits.max())) if motion_map.parameters.get("model") else []
    return known, "", layout.menus(key, earlier, copies), note


def painted_for(
    known: Mapping[str, Any] | None, look: Mapping[str, Any] | None, scheme: str | None, motifs: str | None
) -> list[str | None]:
    """What the drawing depends on: map, version of its dataset, colouring, theme, motifs where they colour it."""
    colouring = str((look or {}).get("colour") or "")
    of_map = [str((known or {}).get(part)) for part in ("key", "version")]
    return [*of_map, colouring, scheme or "light", motifs if colouring == "motif" else None]


def drawn(
    workspace: Workspace,
    shown: tuple[MotionMap, Dataset],
    painted: Sequence[str | None],
    view: Mapping[str, Any] | None,
) -> tuple[go.Figure, list[Component], str]:
    """The map's figure, its legend and what the colours mean. painted: see painted_for."""
    colouring, scheme = painted[2] or "", painted[3]
    graph = results.motif_graph(workspace, shown[1].name, view) if colouring == "motif" else None
    layer = figures.layer_of(*shown, graph, colouring)
    unavailable = colouring in ("label", "motif") and not layer.names
    missing = {"label": "These recordings have no labels.", "motif": "No motifs have been found yet (Motifs page)."}
    explanation = figures.COLOURINGS.get(colouring, figures.COLOURINGS["height"])[1]
    return (
        figures.map_figure(shown[0], layer, scheme),
        layout.legend(figures.legend(layer), figures.scale_of(layer, scheme)),
        missing[colouring] if unavailable else explanation,
    )


def _show(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.MAP_KNOWN, "data"),
        Output(names.MAP_RESULT, "className"),
        Output(names.MAP_MENUS, "children"),
        Output(names.MAP_MORE, "children"),
        Input(names.METHOD.result_key, "data"),
        Input(REVISION, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def show(key, _revision, name, view):
        return known_map(workspace, key, name, view)

    @app.callback(Input(names.MAP_EXTEND, "data"), State(DATASET, "data"), prevent_initial_call=True)
    def extend(request, name):
        try:
            method_page.ask(workspace, "map", name, {"model": str((request or {}).get("model", ""))})
        except (ParameterError, WorkspaceError) as error:
            set_props(NOTICES, {"sendNotifications": [notice("Cannot lay the clips on that map", str(error), "red")]})


def _draw(app: Dash, workspace: Workspace) -> None:
    @app.callback(
        Output(names.MAP_GRAPH, "figure"),
        Output(names.MAP_LEGEND, "children"),
        Output(names.MAP_EXPLANATION, "children"),
        Output(names.MAP_PAINTED, "data"),
        Input(names.MAP_KNOWN, "data"),
        Input(names.MAP_LOOK, "data"),
        Input(THEME, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
        State(names.MAP_PAINTED, "data"),
    )
    def draw(known, look, scheme, motifs, name, view, painted):
        shown = opened(workspace, name, view) if known else None
        if shown is None:
            return no_update, [], "", None
        now = painted_for(known, look, scheme, motifs)
        if now == painted:
            return (no_update,) * 4
        return *drawn(workspace, shown, now, view), now

    @app.callback(
        Output(names.MAP_LIT, "data"),
        Input(SELECTION, "data"),
        Input(names.MAP_KNOWN, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        State(DATASET, "data"),
        State(VIEW, "data"),
    )
    def light(selection, known, _graph, name, view):
        shown = opened(workspace, name, view) if known else None
        if shown is None or "motif" not in (selection or {}):
            return {"nodes": []}
        return {"nodes": lit_nodes(shown[0], results.motif_graph(workspace, name, view), selection)}


def _below(app: Dash, workspace: Workspace) -> None:
    where = (State(DATASET, "data"), State(VIEW, "data"))

    def seen(known: Any, look: Any, panel: str, name: str, view: Any) -> tuple[MotionMap, Dataset] | None:
        return opened(workspace, name, view) if known and (look or {}).get("below") == panel else None

    @app.callback(
        Output(names.MAP_MULTIPLES, "children"),
        Input(names.MAP_KNOWN, "data"),
        Input(names.MAP_LOOK, "data"),
        Input(THEME, "data"),
        *where,
    )
    def multiples(known, look, scheme, name, view):
        shown = seen(known, look, "labels", name, view)
        return panels.multiples(*shown, scheme) if shown else []

    @app.callback(
        Output(names.MAP_CLIPS_PLACE, "children"), Input(names.MAP_KNOWN, "data"), Input(names.MAP_LOOK, "data"), *where
    )
    def clips(known, look, name, view):
        shown = seen(known, look, "clips", name, view)
        if not shown:
            return []
        return tables.grid(names.MAP_CLIPS, panels.clip_columns(), panels.clip_rows(*shown), "Clips on the map")

    @app.callback(
        Output(names.MAP_REGION, "children"),
        Input(names.MAP_KNOWN, "data"),
        Input(names.MAP_LOOK, "data"),
        Input(MOTIF_METHOD.result_key, "data"),
        *where,
    )
    def region(known, look, _graph, name, view):
        shown = seen(known, look, "region", name, view)
        if not shown:
            return []
        return panels.region(*shown, results.motif_graph(workspace, name, view), (look or {}).get("region"))


def _browser(app: Dash) -> None:
    """Registers the clientside callbacks."""
    app.clientside_callback(
        ClientsideFunction("map", "load"),
        Output(names.MAP_LOADED, "data"),
        Input(names.MAP_KNOWN, "data"),
        State(VIEW, "data"),
    )
    app.clientside_callback(ClientsideFunction("map", "view"), Output(names.MAP_SHOWN, "data"), Input(VIEW, "data"))
    app.clientside_callback(
        ClientsideFunction("map", "drawn"), Output(names.MAP_DRAWN, "data"), Input(names.MAP_GRAPH, "figure")
    )
    app.clientside_callback(ClientsideFunction("map", "lit"), Input(names.MAP_LIT, "data"))
    app.clientside_callback(
        ClientsideFunction("map", "selection"), Output(names.MAP_MARKED, "data"), Input(SELECTION, "data")
    )
    app.clientside_callback(
        ClientsideFunction("map", "look"),
        Output(names.MAP_LOOK, "data"),
        Input(VIEW, "data"),
        State(names.MAP_LOOK, "data"),
    )
    register_switch(app, names.MAP_BELOW)
    for control in names.MAP_CONTROLS.values():
        app.clientside_callback(ClientsideFunction("map", "chosen"), Input(control, "value"), State(VIEW, "data"))
        app.clientside_callback(
            ClientsideFunction("map", "choice"),
            Output(control, "value"),
            Input(VIEW, "data"),
            State(control, "id"),
        )
