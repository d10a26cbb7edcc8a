"""A clip's curves for the browser: ``GET /api/clip-table/...`` as CSV, ``GET /api/clip-values/...`` as numbers.

Values are what a chart's readout needs where its lines are thinned: little-endian float32 ``(curves, frames)``.
"""

from __future__ import annotations

from collections.abc import Callable
from urllib.parse import quote

import numpy as np
from flask import Blueprint, Response, request, stream_with_context

from core.editing.curves import ClipCurves, Curve, csv_blocks
from core.workspace import Workspace
from webapp.features.clip import clips
from webapp.shell.routes import BadRequest, OpenDataset, answer_errors, cached_response, find_interval
from webapp.shell.virtual import opener

COLUMNS = {  # of a table: names in the address and on the page
    "angles": "Joint angles (deg)",
    "channels": "File channels (deg)",
    "speeds": "Speeds (m/s)",
    "positions": "Positions (m)",
    "feet": "Foot heights and contacts",
    "gait": "Heel strikes and toe-offs",
}


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [clip_blueprint(opener(workspace))]


def clip_blueprint(open_dataset: OpenDataset) -> Blueprint:
    """The routes; ``open_dataset`` turns a name into a Dataset, as for the Stage's routes."""
    routes = Blueprint("clip", __name__, url_prefix="/api")
    answer_errors(routes)

    @routes.get("/clip-table/<dataset>/<path:clip>", merge_slashes=False)
    def clip_table(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        curves = clips.clip_curves(interval.dataset, interval.clip.name)
        table = csv_blocks(interval.clip, _columns(curves), interval.start, interval.end)
        answer = Response(stream_with_context(table), mimetype="text/csv")
        part = "" if interval.end - interval.start == interval.clip.n_frames else f" {interval.start}-{interval.end}"
        name = f"{interval.clip.name}{part}.csv".replace("/", "_")
        answer.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(name)}"
        return answer

    @routes.get("/clip-values/<dataset>/<path:clip>", merge_slashes=False)
    def clip_values(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        curves = clips.clip_curves(interval.dataset, interval.clip.name)
        view = {key: request.args.get(key, "") for key in ("chart", "angles", "joints", "rig", "channels")}
        chosen = clips.choice(view, curves)

        def make() -> bytes:
            arrays = [curve.values for curve in clips.chosen_curves(curves, chosen)]
            return np.array(arrays, "<f4").tobytes()

        return cached_response(interval, "values", tuple(chosen[:4]), make, "application/octet-stream")

    return routes


def _columns(curves: ClipCurves) -> list[Curve]:
    """The curves that ``columns`` and ``joints`` of the current request name. Raises BadRequest."""
    columns = [word for word in request.args.get("columns", "angles,speeds,feet").split(",") if word]
    if unknown := [word for word in columns if word not in COLUMNS]:
        raise BadRequest(f"“{unknown[0][:40]}” is no kind of column; there are {', '.join(COLUMNS)}.")
    joints = [word for word in request.args.get("joints", "").split(",") if word] or None
    angles, places = curves.angle_joints, (clips.TRAVEL, *curves.joints)
    if joints and (strange := [j for j in joints if j not in angles and j not in places]):
        raise BadRequest(f"This body has no “{strange[0][:40]}”.")

    def among(known: tuple[str, ...]) -> tuple[str, ...]:
        return known if joints is None else tuple(j for j in joints if j in known)

    makers: dict[str, Callable[[], list[Curve]]] = {
        "angles": lambda: curves.angles(among(angles)),
        "channels": curves.channels,
        "speeds": lambda: curves.speeds(among(places)),
        "positions": lambda: curves.positions(among(curves.joints)),
        "feet": curves.feet,
        "gait": curves.events,
    }
    return [curve for word in COLUMNS if word in columns for curve in makers[word]()]
