"""Reads and checks requests for motions and pictures, and sends answers that browsers can cache."""

from __future__ import annotations

import hashlib
import logging
import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple
from urllib.parse import quote

from flask import Blueprint, Response, jsonify, request

from core.errors import MotionscapeError
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from webapp.shell.callback_requests import sent_json
from webapp.shell.errors import log_bug, sentence

log = logging.getLogger(__name__)

HEADER = "X-Motionscape"  # pages of other sites cannot send it without permission
VERSION = 1  # of headers, positions and pictures; part of the ETag
FOR_GOOD = "private, max-age=31536000, immutable"
ASK_AGAIN = "private, no-cache"

OpenDataset = Callable[[str], Dataset]


class BadRequest(MotionscapeError):
    """A request that the client can correct; ``status`` is the HTTP status."""

    def __init__(self, message: str, status: int = 400):
        super().__init__(message)
        self.status = status


class Interval(NamedTuple):
    """The requested frames ``[start, end)`` of a clip."""

    dataset: Dataset
    clip: Clip
    start: int
    end: int


def find_interval(open_dataset: OpenDataset, dataset_name: str, clip_name: str) -> Interval:
    """Dataset, clip and frames of the current request. Raises BadRequest in plain words."""
    return parse_interval(
        open_dataset, dataset_name, clip_name, request.args.get("start", ""), request.args.get("end", "")
    )


def parse_interval(open_dataset: OpenDataset, dataset_name: str, clip_name: str, start: str, end: str) -> Interval:
    """Frames from ``start`` to ``end`` (text; empty: all there are) of a clip. Raises BadRequest in plain words."""
    try:
        dataset = open_dataset(dataset_name)
    except MotionscapeError as error:
        raise BadRequest(str(error), 404) from None
    except (LookupError, OSError) as error:
        log.info("no dataset %r: %s", dataset_name, error)
        raise BadRequest(
            f"There is no dataset called “{dataset_name}”. It may have been renamed or deleted.", 404
        ) from None
    try:
        clip = dataset.clip(clip_name)
    except KeyError:
        raise BadRequest(f"There is no clip called “{clip_name}” in “{dataset_name}”.", 404) from None
    first, last = read_whole("start", start, 0), read_whole("end", end, clip.n_frames)
    if not 0 <= first < last <= clip.n_frames:
        raise BadRequest(f"“{clip_name}” has frames 0 to {clip.n_frames}; cannot show {first} to {last}.")
    return Interval(dataset, clip, first, last)


def whole_number(name: str, default: int) -> int:
    """A whole number from the query string. Raises BadRequest."""
    return read_whole(name, request.args.get(name, ""), default)


def read_whole(name: str, text: str, default: int) -> int:
    """``text`` as a whole number, ``default`` where it is empty. Raises BadRequest."""
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


def content_key(interval: Interval, kind: str, details: tuple) -> str:
    """A key for the content of an answer: equal keys always mean the same bytes."""
    return repr(
        (VERSION, kind, interval.dataset.fingerprint, interval.clip.name, interval.start, interval.end, details)
    )


def names_content(interval: Interval, version: str) -> bool:
    """Whether ``version`` is the beginning (at least 8 letters) of the dataset's fingerprint."""
    return len(version) >= 8 and interval.dataset.fingerprint.startswith(version)


def cached_response(
    interval: Interval, kind: str, details: tuple, make: Callable[[], bytes | str], mimetype: str
) -> Response:
    """The answer with an ETag made from the dataset's content; nothing is computed if the browser has it already.

    The content behind a name may change, so browsers keep the answer but ask each time whether it is still valid. A
    request that names the content (``v``: at least 8 letters of the fingerprint) need not be sent again.
    """
    for_good = names_content(interval, request.args.get("v", ""))
    return response_with_etag([content_key(interval, kind, details)], for_good, make, mimetype)


def response_with_etag(keys: Sequence[str], for_good: bool, make: Callable[[], bytes | str], mimetype: str) -> Response:
    """The answer whose content is named by ``keys``; ``make`` is called only if the browser does not have it."""
    etag = hashlib.blake2b("\n".join(keys).encode(), digest_size=12).hexdigest()
    fresh = etag in request.if_none_match
    response = Response(status=304) if fresh else Response(make(), mimetype=mimetype)
    response.set_etag(etag)
    response.headers["Cache-Control"] = FOR_GOOD if for_good else ASK_AGAIN
    return response


def json_body(largest: int = 300_000) -> dict[str, Any]:
    """The JSON object of the request, at most ``largest`` bytes. Raises BadRequest for anything else, or where it does
    not come from the app.
    """
    if not request.headers.get(HEADER):
        raise BadRequest("This request does not come from the app.", 403)
    if (request.content_length or 0) > largest:
        raise BadRequest("This is too large.", 413)
    body = sent_json()
    if not isinstance(body, dict):
        raise BadRequest("A JSON object was expected.")
    return body


class Refusal(MotionscapeError):
    """Why there is nothing to download, and the HTTP status that says so."""

    def __init__(self, message: str, status: int):
        super().__init__(message)
        self.status = status


def answer_refusals(routes: Blueprint) -> None:
    """A Refusal of these routes is JSON in plain words."""

    @routes.errorhandler(Refusal)
    def _refused(error: Refusal) -> tuple[Response, int]:
        return jsonify(error=str(error)), error.status


def attachment(text: str, mimetype: str, name: str) -> Response:
    """A file that the browser saves under ``name``."""
    answer = Response(text, mimetype=mimetype)
    answer.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(name)}"
    return answer


def answer_errors(blueprint: Blueprint) -> None:
    """Every error of these routes is JSON in plain words, never a trace."""

    @blueprint.errorhandler(BadRequest)
    def bad_request(error: BadRequest) -> tuple[Response, int]:
        return jsonify(error=str(error)), error.status

    @blueprint.errorhandler(MotionscapeError)
    def cannot(error: MotionscapeError) -> tuple[Response, int]:
        return jsonify(error=sentence(error)), 400

    @blueprint.errorhandler(Exception)
    def bug(error: Exception) -> tuple[Response, int]:
        return jsonify(error=bug_message(request.path, error)), 500


def bug_message(where: str, error: Exception) -> str:
    """Logs a bug that kept a motion from being sent; returns the message for people."""
    return f"This motion cannot be shown: something went wrong on the server (error {log_bug(where, error)})."
