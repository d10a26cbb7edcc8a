"""A motion map for the browser and for other programs: all of it as one binary file, paths over it, downloads.

``GET /api/map/<key>.bin``: ``uint32`` header length, JSON header (padded with spaces to 4 bytes), then little-endian
arrays one after another: weights float32 ``(nx, ny, 3 n_joints)``; of the runs clip, start, end, node int32 and
distance, ahead, aside float32, each ``(n_runs,)`` (see core.motion_map.key_poses.Runs).
``GET /api/map/<key>/paths?dataset=&clip=&start=&end=&clip=...``: the paths of segments over the map.
``GET /api/map/<key>/drawn?path=x-y,x-y,...``: stretches whose path over the map is like a drawn one.
``GET /api/map/<key>/node?dataset=&clip=&frame=``: the node nearest to one frame of any clip.
``GET /api/map/<key>.json`` and ``.csv``: downloads.
"""

from __future__ import annotations

import io
import json
import re

import numpy as np
from flask import Blueprint, Response, jsonify, request

from core import analyses
from core.errors import AnalysisError, ParameterError
from core.motion_map.layers import frame_nodes
from core.motion_map.motion_map import MotionMap
from core.motion_map.path_queries import search_path
from core.spreadsheets import SheetWriter
from core.workspace import Workspace, WorkspaceError
from webapp.features.motion_map.names import MapHeader
from webapp.features.motion_map.paths import path_of
from webapp.shell.routes import (
    BadRequest,
    OpenDataset,
    answer_errors,
    attachment,
    parse_interval,
    read_whole,
    response_with_etag,
)
from webapp.shell.virtual import opener

MOST_PATHS = 48


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [map_blueprint(workspace, opener(workspace))]


def _points(text: str) -> list[tuple[float, float]]:
    """The points of a drawn path in an address: ``x-y,x-y``. Raises ParameterError."""
    try:
        return [(float(x), float(y)) for x, y in (point.split("-") for point in text.split(","))]
    except ValueError:
        raise ParameterError(f"{text[:40]!r} is no path") from None


def map_blueprint(workspace: Workspace, open_dataset: OpenDataset) -> Blueprint:
    """The routes for the maps kept in ``workspace``; ``open_dataset`` also opens made-up motion."""
    routes = Blueprint("motion_map", __name__, url_prefix="/api/map")
    answer_errors(routes)

    @routes.get("/<key>.bin")
    def whole(key: str) -> Response:
        motion_map = _map(workspace, key)
        return response_with_etag(["map", key], True, lambda: packed(motion_map), "application/octet-stream")

    @routes.get("/<key>/paths")
    def map_paths(key: str) -> Response:
        motion_map = _map(workspace, key)
        rows = zip(*(request.args.getlist(name) for name in ("clip", "start", "end")), strict=False)
        paths = []
        for clip, start, end in list(rows)[:MOST_PATHS]:
            interval = parse_interval(open_dataset, request.args.get("dataset", ""), clip, start, end)
            try:
                paths.append(path_of(motion_map, key, interval.dataset, interval.clip, interval.start, interval.end))
            except AnalysisError as error:
                raise BadRequest(f"{error}.") from None
        return jsonify(paths)

    @routes.get("/<key>/drawn")
    def drawn(key: str) -> Response:
        motion_map = _map(workspace, key)
        try:
            hits = search_path(motion_map, _points(request.args.get("path", "")))
        except ParameterError:
            raise BadRequest("This is no path over a map; draw it again.") from None
        return jsonify([hit._asdict() for _, hit in hits])

    @routes.get("/<key>/node")
    def node(key: str) -> Response:
        motion_map = _map(workspace, key)
        frame = read_whole("frame", request.args.get("frame", ""), 0)
        interval = parse_interval(
            open_dataset, request.args.get("dataset", ""), request.args.get("clip", ""), str(frame), str(frame + 1)
        )
        try:
            vectors, _ = motion_map.vectors_of(interval.clip.cut(interval.start, interval.end))
        except AnalysisError as error:
            raise BadRequest(f"{error}.") from None
        at, apart = motion_map.nearest(vectors[0])
        return jsonify(node=at, distance=apart, usual=motion_map.metrics["usual_distance"])

    @routes.get("/<key>.json")
    def document(key: str) -> Response:
        return attachment(json.dumps(_map(workspace, key).to_json()), "application/json", _name(workspace, key, "json"))

    @routes.get("/<key>.csv")
    def nodes(key: str) -> Response:
        return attachment(nodes_csv(_map(workspace, key)), "text/csv", _name(workspace, key, "csv"))

    return routes


def packed(motion_map: MotionMap) -> bytes:
    """The whole map as ``/api/map/<key>.bin`` sends it."""
    runs = motion_map.runs
    head: MapHeader = {
        "grid": motion_map.grid,
        "joints": list(motion_map.joints),
        "roles": list(motion_map.roles),
        "sides": list(motion_map.sides),
        "parents": list(motion_map.parents),
        "lengths": np.round(motion_map.lengths, 5).tolist(),
        "clips": [
            {"name": name, "frames": frames, "fps": fps, "fit": round(float(fit), 3)}
            for name, frames, fps, fit in zip(
                motion_map.clips, motion_map.clip_frames, motion_map.clip_fps, motion_map.fits, strict=True
            )
        ],
        "fps": motion_map.fps,
        "regions": motion_map.regions.ravel().tolist(),
        "icons": motion_map.icons.tolist(),
        "usual": motion_map.metrics["usual_distance"],
        "runs": len(runs.node),
    }
    text = json.dumps(head, allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    whole = [np.asarray(getattr(runs, name), "<i4") for name in ("clip", "start", "end", "node")]
    real = [np.asarray(getattr(runs, name), "<f4") for name in ("distance", "ahead", "aside")]
    arrays = [np.asarray(motion_map.weights, "<f4"), *whole, *real]
    return b"".join([np.uint32(len(text)).astype("<u4").tobytes(), text, *(array.tobytes() for array in arrays)])


def nodes_csv(motion_map: MotionMap) -> str:
    """A row for each analysis frame: clip, its frame at the clip's own rate, seconds, node and region."""
    nodes, starts = frame_nodes(motion_map)
    regions, ny = motion_map.regions.ravel(), motion_map.grid[1]
    text = io.StringIO()
    rows = SheetWriter(text)
    rows.writerow(["clip", "frame", "seconds", "node_x", "node_y", "region"])
    for k, clip in enumerate(motion_map.clips):
        scale, frames = motion_map.clip_fps[k] / motion_map.fps, motion_map.clip_frames[k]
        for i, node in enumerate(nodes[starts[k] : starts[k + 1]].tolist()):
            clip_frame = min(round(i * scale), frames - 1)
            rows.writerow([clip, clip_frame, f"{i / motion_map.fps:.4f}", node // ny, node % ny, regions[node]])
    return text.getvalue()


def _map(workspace: Workspace, key: str) -> MotionMap:
    motion_map = None
    if re.fullmatch(r"[0-9a-f]{8,64}", key):
        try:
            motion_map = analyses.kept(workspace, "map", key)
        except WorkspaceError:
            motion_map = None
    if motion_map is None:
        raise BadRequest("This motion map is no longer there; build it again on the Map page.", 404)
    return motion_map


def _name(workspace: Workspace, key: str, ending: str) -> str:
    return f"{_map(workspace, key).dataset.get('name', 'motion')}-map.{ending}"
