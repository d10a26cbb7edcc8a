"""``GET /api/motion/<dataset>/<clip>``: drawn joint positions as little-endian float32, for the Stage."""

from __future__ import annotations

import hashlib
import json
import logging
import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from flask import Blueprint, Response, jsonify, request

from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.posture_drawing import DrawnBody, HeadAndFloor, drawn_positions
from core.workspace import WorkspaceError

log = logging.getLogger(__name__)

DEFAULT_FPS = 60.0
MAX_VALUES = 12_000_000  # about 48 MB; a longer recording arrives at a lower rate rather than not at all
VERSION = 1  # of header and positions; part of the ETag


class BadRequest(Exception):
    """Something the asker can mend; ``status`` is the HTTP status."""

    def __init__(self, message: str, status: int = 400):
        super().__init__(message)
        self.status = status


class Interval(NamedTuple):
    """What was asked for, checked: frames ``[start, end)`` of ``clip``."""

    dataset: Dataset
    clip: Clip
    start: int
    end: int


def motion_blueprint(open_dataset: Callable[[str], Dataset]) -> Blueprint:
    """Routes of the Stage. ``open_dataset`` turns a name into a Dataset and raises LookupError, OSError or ValueError
    where there is none."""
    blueprint = Blueprint("motion", __name__, url_prefix="/api")
    answer_errors(blueprint)

    # clip names may hold slashes, two in a row as well
    @blueprint.get("/motion/<dataset>/<path:clip>", merge_slashes=False)
    def motion(dataset: str, clip: str) -> Response:
        asked = find_interval(open_dataset, dataset, clip)
        step = frame_step(asked, positive_number("fps", DEFAULT_FPS))
        return cached(asked, "motion", (step,), lambda: encode_motion(asked, step), "application/octet-stream")

    return blueprint


def find_interval(open_dataset: Callable[[str], Dataset], dataset_name: str, clip_name: str) -> Interval:
    """Dataset, clip and frames of the current request. Raises BadRequest in plain words."""
    try:
        dataset = open_dataset(dataset_name)
    except WorkspaceError as error:
        raise BadRequest(str(error), 404) from None
    except (LookupError, OSError, ValueError) as error:
        log.info("no dataset %r: %s", dataset_name, error)
        raise BadRequest(
            f"There is no dataset called “{dataset_name}”. It may have been renamed or deleted.", 404
        ) from None
    try:
        clip = dataset.clip(clip_name)
    except (LookupError, ValueError):
        raise BadRequest(f"There is no clip called “{clip_name}” in “{dataset_name}”.", 404) from None
    start, end = whole_number("start", 0), whole_number("end", clip.n_frames)
    if not 0 <= start < end <= clip.n_frames:
        raise BadRequest(f"“{clip_name}” has frames 0 to {clip.n_frames}; cannot show {start} to {end}.")
    return Interval(dataset, clip, start, end)


def whole_number(name: str, default: int) -> int:
    """A whole number from the query string. Raises BadRequest."""
    text = request.args.get(name, "")
    if text == "":
        return default
    if not text.lstrip("-").isascii() or not text.lstrip("-").isdigit() or len(text) > 12:
        raise BadRequest(f"{name} must be a whole number, not “{text[:40]}”.")
    return int(text)


def positive_number(name: str, default: float) -> float:
    """A positive number from the query string. Raises BadRequest."""
    text = request.args.get(name, "")
    try:
        value = float(text) if text else default
    except ValueError:
        value = math.nan
    if not 0 < value < math.inf:
        raise BadRequest(f"{name} must be a positive number, not “{text[:40]}”.")
    return value


def frame_step(asked: Interval, fps: float) -> int:
    """Send every step-th frame: the smallest step that keeps to ``fps`` frames a second and to :data:`MAX_VALUES`."""
    step = max(1, math.ceil(asked.clip.fps / fps - 0.01))
    frames = asked.end - asked.start
    most = max(2, MAX_VALUES // (3 * (asked.clip.skeleton.n_joints + 2)))
    return max(min(step, frames), math.ceil(frames / most))


def encode_motion(asked: Interval, step: int) -> bytes:
    """Header length, JSON header and positions, as docs/architecture.md lays them out."""
    positions, body, measured = drawn_positions(asked.clip, asked.start, asked.end, step)
    header = motion_header(asked, step, len(positions), body, measured)
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return b"".join((np.uint32(len(text)).astype("<u4").tobytes(), text, positions.astype("<f4", copy=False).tobytes()))


def motion_header(asked: Interval, step: int, frames: int, body: DrawnBody, measured: HeadAndFloor) -> dict:
    """All the Stage needs to know besides positions. Lengths in metres; joints by their place among the drawn ones."""
    return {
        "clip": asked.clip.name,
        "start": asked.start,
        "end": asked.end,
        "fps": asked.clip.fps / step,
        "step": step,
        "frames": frames,
        "joints": body.names,
        "parents": body.parents,
        "sides": body.sides,
        "roles": body.roles,
        "root": 0,
        "head": body.find("head_centre"),
        "nose": body.find("nose"),
        "hands": body.hands,
        "feet": body.feet,
        "height": round(body.height, 4),
        "head_radius": round(measured.radius, 4),
        "floor": round(measured.floor, 4),
    }


def cached(asked: Interval, kind: str, details: tuple, make: Callable[[], bytes | str], mimetype: str) -> Response:
    """The answer with an ETag from the dataset's content; nothing is computed for who has it already.

    A name may come to stand for other content, so browsers keep the answer but ask each time whether it still holds;
    who names the content (``v``: at least 8 letters of the fingerprint) need not ask again.
    """
    key = repr((VERSION, kind, asked.dataset.fingerprint, asked.clip.name, asked.start, asked.end, details))
    etag = hashlib.blake2b(key.encode(), digest_size=12).hexdigest()
    fresh = etag in request.if_none_match
    response = Response(status=304) if fresh else Response(make(), mimetype=mimetype)
    response.set_etag(etag)
    version = request.args.get("v", "")
    named = len(version) >= 8 and asked.dataset.fingerprint.startswith(version)
    response.headers["Cache-Control"] = "private, max-age=31536000, immutable" if named else "private, no-cache"
    return response


def answer_errors(blueprint: Blueprint) -> None:
    """Every error of these routes is JSON in plain words, never a trace."""

    @blueprint.errorhandler(BadRequest)
    def bad_request(error: BadRequest) -> tuple[Response, int]:
        return jsonify(error=str(error)), error.status

    @blueprint.errorhandler(Exception)
    def internal(error: Exception) -> tuple[Response, int]:
        log.exception("the answer to %s failed", request.path)
        return jsonify(error="This motion cannot be shown: something went wrong on the server."), 500
