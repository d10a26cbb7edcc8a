"""What boards and reports show of a motion map: its ground, the posture of every node, and what passes there."""

from __future__ import annotations

import base64
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from core.mocap.dataset import Dataset
from core.motion_map.motion_map import MotionMap
from core.workspace import Workspace
from webapp.features.motion_map.figures.heatmap import icons_svg
from webapp.shell import settings
from webapp.ui.tables import labels_by_clip, main_label

MOST_STAYS = 20_000  # that light and fade with what is selected elsewhere
PASSES = 3  # stays at a node that play when it is clicked
BEFORE = 0.6  # seconds around a stay


def motion_map(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any] | None:
    """``heights``, ``seconds``: of the nodes, column by column; ``postures``: base64 of int16 millimetres (nodes,
    joints, 3); ``passes``: of each node, [clip, start, end] of its longest stays; ``icons``: by theme;
    ``clips``: names; ``stays``, ``labels``: see :func:`_stays`."""
    found: MotionMap | None = settings.result_of(workspace, "map", dataset.name, view)
    if found is None:
        return None
    millimetres = np.round(1000 * found.postures.reshape(-1, len(found.joints), 3)).astype("<i2")
    return {
        "grid": list(found.grid),
        "heights": np.round(found.heights, 4).ravel().tolist(),
        "seconds": np.round(found.density, 2).ravel().tolist(),
        "parents": list(found.parents),
        "sides": list(found.sides),
        "roles": list(found.roles),
        "postures": base64.b64encode(millimetres.tobytes()).decode(),
        "icons": {scheme: icons_svg(found, scheme) for scheme in ("light", "dark")},
        "passes": _passes(found, dataset),
        "clips": list(found.clips),
        **_stays(found, dataset),
    }


def _passes(found: MotionMap, dataset: Dataset) -> list[list[list[Any]]]:
    nodes: list[list[list[Any]]] = [[] for _ in range(found.grid[0] * found.grid[1])]
    around, frames = round(BEFORE * found.fps), dict(zip(found.clips, found.clip_frames, strict=True))
    for k in np.argsort(found.runs.start - found.runs.end, kind="stable"):
        own = nodes[found.runs.node[k]]
        if len(own) < PASSES:
            start, end = int(found.runs.start[k]), int(found.runs.end[k])
            clip, first, last = found.segment(int(found.runs.clip[k]), max(start - around, 0), end + around)
            own.append([clip, first, min(last, frames[clip])])
    return nodes


def _stays(found: MotionMap, dataset: Dataset) -> dict[str, Any]:
    """``stays``: the longest, five numbers each: index of the clip, node, start and end in frames of the clip, index of
    the label that covers most of it or -1; ``labels``: the names."""
    by_clip, runs = labels_by_clip(dataset), found.runs
    names = sorted({label.action for label in dataset.labels})
    at = {name: k for k, name in enumerate(names)}
    stays: list[int] = []
    for k in np.argsort(runs.start - runs.end, kind="stable")[:MOST_STAYS]:
        clip = int(runs.clip[k])
        stretch = found.segment(clip, int(runs.start[k]), int(runs.end[k]))
        label = main_label([stretch], by_clip)
        stays += [clip, int(runs.node[k]), stretch.start, stretch.end, at[label] if label else -1]
    return {"stays": stays, "labels": names}


def segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """The longest stay at every node, then the second longest of each."""
    for k in range(PASSES):
        yield from (tuple(own[k]) for own in content["passes"] if k < len(own))
