"""``GET /api/filmstrip/<dataset>/<clip>`` and ``GET /api/icon/<dataset>/<clip>``: small pictures of motions, as SVG."""

from __future__ import annotations

from collections.abc import Callable

from flask import Blueprint, Response, request

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from webapp.shell.routes import BadRequest, answer_errors, cached_response, find_interval, whole_number
from webapp.ui.filmstrip import ICON_COLOURS, frame_icon, segment_filmstrip

MOST_POSES = 40
SVG = "image/svg+xml"


def filmstrip_blueprint(open_dataset: Callable[[str], Dataset]) -> Blueprint:
    """Routes of the pictures; ``open_dataset`` as for :func:`webapp.stage.motion_routes.motion_blueprint`."""
    blueprint = Blueprint("filmstrip", __name__, url_prefix="/api")
    answer_errors(blueprint)

    @blueprint.get("/filmstrip/<dataset>/<path:clip>", merge_slashes=False)
    def filmstrip(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        poses = whole_number("n", 6)
        if not 1 <= poses <= MOST_POSES:
            raise BadRequest(f"n must be between 1 and {MOST_POSES}, not {poses}.")
        segment = Segment(interval.clip.name, interval.start, interval.end)
        return cached_response(
            interval, "filmstrip", (poses,), lambda: segment_filmstrip(interval.dataset, segment, poses), SVG
        )

    @blueprint.get("/icon/<dataset>/<path:clip>", merge_slashes=False)
    def icon(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        scheme = request.args.get("scheme", "light")
        if scheme not in ICON_COLOURS:
            raise BadRequest(f"scheme must be one of {', '.join(ICON_COLOURS)}.")
        frame = (interval.start + interval.end) // 2
        return cached_response(
            interval, "icon", (scheme,), lambda: frame_icon(interval.dataset, interval.clip.name, frame, scheme), SVG
        )

    return blueprint
