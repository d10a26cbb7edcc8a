"""Drawn joint positions as little-endian float32, for the Stage.

``GET /api/motion/<dataset>/<clip>`` answers with one segment, ``GET /api/motions`` with up to 48 at once.
"""

from __future__ import annotations

import json
import logging
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from flask import Blueprint, Response, request

from core.errors import MotionscapeError
from core.mocap.posture_drawing import DrawnBody, HeadAndFloor, drawn_positions
from webapp.shell.routes import (
    BadRequest,
    Interval,
    OpenDataset,
    answer_errors,
    bug_message,
    cached_response,
    content_key,
    find_interval,
    names_content,
    parse_interval,
    positive_number,
    response_with_etag,
)
from webapp.stage.names import MotionHeader

log = logging.getLogger(__name__)

DEFAULT_FPS = 60.0
MAX_VALUES = 12_000_000  # about 48 MB; a longer recording arrives at a lower rate rather than not at all
MAX_BATCH_VALUES = 24_000_000  # of all parts together
MAX_PARTS = 48
BINARY = "application/octet-stream"


def motion_blueprint(open_dataset: OpenDataset) -> Blueprint:
    """Routes of the Stage. ``open_dataset`` turns a name into a Dataset and raises MotionscapeError, LookupError or
    OSError where there is none."""
    blueprint = Blueprint("motion", __name__, url_prefix="/api")
    answer_errors(blueprint)

    # clip names may hold slashes, two in a row as well
    @blueprint.get("/motion/<dataset>/<path:clip>", merge_slashes=False)
    def motion(dataset: str, clip: str) -> Response:
        interval = find_interval(open_dataset, dataset, clip)
        step = frame_step(interval, positive_number("fps", DEFAULT_FPS), MAX_VALUES)
        return cached_response(interval, "motion", (step,), lambda: encode_motion(interval, step), BINARY)

    @blueprint.get("/motions")
    def motions() -> Response:
        fps = positive_number("fps", DEFAULT_FPS)
        rows = part_rows()
        most = min(MAX_VALUES, MAX_BATCH_VALUES // len(rows))
        parts = [find_part(open_dataset, row, fps, most) for row in rows]
        keys = [part if isinstance(part, str) else content_key(part[0], "motion", part[1:]) for part in parts]
        named = (
            not isinstance(part, str) and names_content(part[0], row[1]) for part, row in zip(parts, rows, strict=True)
        )
        return response_with_etag(["motions", *keys], all(named), lambda: encode_motions(parts), BINARY)

    return blueprint


Row = tuple[str, str, str, str, str]  # dataset, version, clip, start, end: as they stand in the address
Part = tuple[Interval, int] | str  # what to send every how many frames, or why it cannot be sent


def part_rows() -> list[Row]:
    """The segments that the address lists: ``clip`` once for each; ``dataset``, ``v`` (the fingerprint), ``start`` and
    ``end`` once for each or once for all. Raises BadRequest."""
    clips = request.args.getlist("clip")
    if not 1 <= len(clips) <= MAX_PARTS:
        raise BadRequest(f"Between 1 and {MAX_PARTS} clips can be asked for at once, not {len(clips)}.")
    columns = []
    for name in ("dataset", "v", "start", "end"):
        values = request.args.getlist(name) or [""]
        if len(values) not in (1, len(clips)):
            raise BadRequest(f"{name} is given {len(values)} times for {len(clips)} clips.")
        columns.append(values if len(values) == len(clips) else values * len(clips))
    datasets, versions, starts, ends = columns
    return list(zip(datasets, versions, clips, starts, ends, strict=True))


def find_part(open_dataset: OpenDataset, row: Row, fps: float, most: int) -> Part:
    """The segment of one row, or a sentence that says why there is none; the other rows are sent regardless."""
    dataset, _, clip, start, end = row
    try:
        interval = parse_interval(open_dataset, dataset, clip, start, end)
        return interval, frame_step(interval, fps, most)
    except MotionscapeError as error:
        return str(error)
    except Exception as error:
        return bug_message(request.path, error)


def frame_step(interval: Interval, fps: float, most_values: int) -> int:
    """Send every step-th frame: the smallest step that keeps to ``fps`` frames a second and to ``most_values``."""
    step = max(1, math.ceil(interval.clip.fps / fps - 0.01))
    frames = interval.end - interval.start
    most = max(2, most_values // (3 * (interval.clip.skeleton.n_joints + 2)))
    return max(min(step, frames), math.ceil(frames / most))


def encode_motions(parts: Sequence[Part]) -> bytes:
    """A header with the size of each part or its error, then the parts, each as :func:`encode_motion` has it."""
    bodies = [b"" if isinstance(part, str) else encode_motion(*part) for part in parts]
    sizes = [
        {"error": part} if isinstance(part, str) else {"bytes": len(body)}
        for part, body in zip(parts, bodies, strict=True)
    ]
    return b"".join((*framed({"parts": sizes}), *bodies))


def encode_motion(interval: Interval, step: int) -> bytes:
    """Header length, JSON header and positions, as docs/reference/stage.md lays them out."""
    positions, body, measured = drawn_positions(interval.clip, interval.start, interval.end, step)
    header = motion_header(interval, step, len(positions), body, measured)
    return b"".join((*framed(header), positions.astype("<f4", copy=False).tobytes()))


def framed(header: Mapping[str, Any]) -> tuple[bytes, bytes]:
    """A header's length as uint32, and the header as JSON padded to whole words."""
    text = json.dumps(header, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return np.uint32(len(text)).astype("<u4").tobytes(), text


def motion_header(interval: Interval, step: int, frames: int, body: DrawnBody, measured: HeadAndFloor) -> MotionHeader:
    """The header of a motion; frames: how many are sent."""
    return {
        "clip": interval.clip.name,
        "start": interval.start,
        "end": interval.end,
        "fps": interval.clip.fps / step,
        "step": step,
        "frames": frames,
        "joints": list(body.names),
        "parents": list(body.parents),
        "sides": list(body.sides),
        "roles": list(body.roles),
        "root": 0,
        "head": body.find("head_centre"),
        "nose": body.find("nose"),
        "hands": list(body.hands),
        "feet": list(body.feet),
        "height": round(body.height, 4),
        "head_radius": round(measured.radius, 4),
        "floor": round(measured.floor, 4),
    }
