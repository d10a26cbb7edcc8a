"""Turns a selection into what the Stage plays: the feature that owns the selection answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from dash import Dash, Input, Output, State, no_update, set_props

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.workspace import Workspace, WorkspaceError
from webapp.shell import names
from webapp.shell.feature import Feature, Shown, features
from webapp.shell.messages import notice
from webapp.shell.names import Figure, StageRequest

MOST_FIGURES = 24  # the Stage stays fluid; more bodies would hide one another anyway


def selected_request(
    workspace: Workspace,
    dataset_name: str | None,
    selection: Mapping[str, Any] | None,
    view: Mapping[str, str] | None,
) -> StageRequest | None:
    """What plays when this is selected on a page that shows ``view``; None where nothing does."""
    if not selection or not dataset_name:
        return None
    feature = _feature_of(selection)
    try:
        dataset = workspace.open(dataset_name)
        if feature:
            return feature.plays(workspace, dataset, Shown(dataset_name, selection, view or {}))
        return clip_request(dataset, selection) if "clip" in selection else None
    except WorkspaceError:
        return None


def missing(
    workspace: Workspace,
    dataset_name: str | None,
    selection: Mapping[str, Any],
    view: Mapping[str, str] | None = None,
) -> str | None:
    """A sentence about what a selection names that does not exist; None where it exists or cannot be checked yet."""
    if not selection or not dataset_name:
        return None
    try:
        if "clip" in selection:
            known = selection["clip"] in workspace.open(dataset_name).names
            return None if known else f"“{dataset_name}” has no clip called “{selection['clip']}”."
        feature = _feature_of(selection)
        shown = Shown(dataset_name, selection, view or {})
        return feature.missing(workspace, shown) if feature else None
    except WorkspaceError:
        return None


def clip_request(dataset: Dataset, selection: Mapping[str, Any]) -> StageRequest | None:
    """What plays for a selected clip, or frames of it; None where the dataset has no such clip."""
    segment = clip_segment(dataset, selection)
    return overlay(dataset, [item(*segment, segment.clip)], segment.clip) if segment else None


def clip_segment(dataset: Dataset, selection: Mapping[str, Any]) -> Segment | None:
    """Frames ``start`` to ``end`` of the selected clip, all where it has no such frames; None without such a clip."""
    try:
        clip = dataset.clip(str(selection["clip"]))
    except KeyError:
        return None
    start, end = int(selection.get("start", 0)), min(int(selection.get("end", clip.n_frames)), clip.n_frames)
    return Segment(clip.name, start, end) if start < end else Segment(clip.name, 0, clip.n_frames)


def item(clip: str, start: int, end: int, label: str, warp: list[float] | None = None) -> Figure:
    """One figure of a request: frames ``[start, end)`` of a clip; warp: its frame beside each frame of the medoid."""
    return {"clip": clip, "start": int(start), "end": int(end), "label": label, "warp": warp}


def overlay(dataset: Dataset, items: list[Figure], title: str, sync: Literal["warp", "start"] = "warp") -> StageRequest:
    """A request that lays its figures over one another.

    sync: "warp" plays them in step where they have warps, "start" each at its own pace from its start.
    """
    return {
        "dataset": dataset.name,
        "version": dataset.fingerprint,
        "items": items,
        "title": title,
        "layout": "overlay",
        "sync": sync,
    }


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the callback that plays the selection, whichever page it was made on."""

    @app.callback(
        Output(names.STAGE_REQUEST, "data"),
        Input(names.SELECTION, "data"),
        {store: Input(store, "data") for feature in features() for store in feature.replay_on},
        State(names.VIEW, "data"),
        State(names.DATASET, "data"),
        prevent_initial_call=True,
    )
    def play(selection, _stores, view, dataset_name):
        message = missing(workspace, dataset_name, selection, view)
        if message:
            set_props(
                names.NOTICES, {"sendNotifications": [notice("That is not there", message, "orange", id="not-there")]}
            )
            set_props(names.SELECTION, {"data": {}})
        return selected_request(workspace, dataset_name, selection, view) or no_update


def _feature_of(selection: Mapping[str, Any]) -> Feature | None:
    """The feature that answers for a selection; None for a plain clip, and for an unknown selection."""
    for feature in features():
        if any(kind.key in selection for kind in feature.selections):
            return feature
        if "clip" in selection and selection.get("as") in feature.clip_colours:
            return feature
    return None
