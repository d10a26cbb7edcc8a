"""Comments on what a page shows: on a motif, or on moments of a clip."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from core.workspace import Workspace, acting
from webapp.features.boards.documents import comment_data, people_of
from webapp.shell.results import find_motif, motif_graph, motif_graph_key, motif_notes


def said_about(workspace: Workspace, values: Mapping[str, str]) -> dict[str, Any] | None:
    """What is said about the motif or the clip that a link selects; None where it selects neither.

    values: of the link. ``place``: where a new comment belongs; for a clip the browser adds the frame to it.
    ``comments``: as those of a board, those of a clip with ``frame`` and ``seconds``. Raises WorkspaceError where there
    is no such dataset.
    """
    dataset = values.get("dataset", "")
    if not dataset or not (values.get("motif") or values.get("clip")):
        return None
    info = workspace.info(dataset)
    if values.get("motif"):
        number = values["motif"]
        graph, key = motif_graph(workspace, dataset, values), motif_graph_key(workspace, dataset, values)
        motif = find_motif(graph, int(number)) if graph and number.isdecimal() and len(number) < 9 else None
        if motif is None or not key:
            return None
        note = motif_notes(workspace, dataset, values).get(motif.id)
        name = f"Motif {motif.id}" + (f", {note.name}" if note and note.name else "")
        return _answer(workspace, f"motif:{info.id}/{key}/{motif.id}", name, None)
    clips = {clip.name: clip for clip in workspace.open(dataset).clips}
    clip = clips.get(values["clip"])
    return _answer(workspace, f"moment:{info.id}/{clip.name}", clip.name, clip.fps) if clip else None


def _answer(workspace: Workspace, place: str, title: str, fps: float | None) -> dict[str, Any]:
    comments = workspace.comments.at(place) if fps is None else workspace.comments.under(place)
    shown = []
    for comment in comments:
        frame = comment.place.removeprefix(f"{place}/")
        if fps and not frame.isdecimal():
            continue  # of a clip in a folder that is called like this one
        moment = {"frame": int(frame), "seconds": int(frame) / fps} if fps else {}
        shown.append(comment_data(comment) | {"block": ""} | moment)
    return {
        "place": place,
        "title": title,
        "moments": fps is not None,
        "comments": shown,
        "me": acting().name,
        "names": people_of(workspace, *(comment.author for comment in comments)),
    }
