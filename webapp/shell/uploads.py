"""Uploads: one PUT a file, streamed to disk. A job imports the files afterwards."""

from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import dataclass

from flask import Blueprint, Response, jsonify, request

from core.mocap.readers import BESIDE, FORMATS, NAMED, is_recording
from core.workspace import Workspace, WorkspaceError
from core.workspace.uploads import MAX_BYTES, MAX_FILES
from webapp.shell.routes import HEADER

SUFFIXES = (*(f"{ending}{packed}" for ending in (*FORMATS, *BESIDE) for packed in ("", ".gz")), ".zip")
_CHUNK = 1 << 18
_DRAIN = 1 << 24


@dataclass(frozen=True)
class Limits:
    """How much an upload may hold: bytes a file, bytes altogether, files."""

    file_bytes: int
    total_bytes: int
    files: int

    @classmethod
    def from_environment(cls) -> Limits:
        """MOTIONSCAPE_MAX_FILE_MB, MOTIONSCAPE_MAX_UPLOAD_MB and MOTIONSCAPE_MAX_FILES, within the workspace's own."""
        total = min(_whole("MOTIONSCAPE_MAX_UPLOAD_MB", 2048) << 20, MAX_BYTES)
        file = min(_whole("MOTIONSCAPE_MAX_FILE_MB", 512) << 20, total)
        return cls(file, total, min(_whole("MOTIONSCAPE_MAX_FILES", 2000), MAX_FILES))

    def sentence(self) -> str:
        """The limits in words, for the people who upload."""
        sizes = f"{megabytes(self.file_bytes)} a file and {megabytes(self.total_bytes)} altogether"
        kinds = f"{NAMED}, as they are, gzipped or all in a zip; labels as CSV"
        return f"{kinds} (columns clip, start_frame, end_frame, action). Up to {self.files:,} files, {sizes}."


def megabytes(n_bytes: float) -> str:
    """A size as people write it: 512 MB, 2 GB."""
    if n_bytes >= 1 << 30:
        return f"{n_bytes / (1 << 30):.3g} GB"
    return f"{n_bytes / (1 << 20):.3g} MB"


def upload_blueprint(workspace: Workspace, limits: Limits) -> Blueprint:
    """The routes: POST makes an upload, PUT adds a file to it, DELETE cancels it. Answers are JSON."""
    routes = Blueprint("uploads", __name__, url_prefix="/api/uploads")

    @routes.before_request
    def _own_page() -> tuple[Response, int] | None:
        return None if request.headers.get(HEADER) else _refuse("This request does not come from the app.", 403)

    @routes.post("")
    def _create() -> Response:
        return jsonify(token=workspace.uploads.create())

    @routes.put("/<token>/<path:name>")
    def _add(token: str, name: str) -> Response | tuple[Response, int]:
        if not name.lower().endswith(SUFFIXES):
            return _refuse(f"Not a kind of file we read ({', '.join(SUFFIXES)}).", 415)
        size = request.content_length
        if size is None:
            return _refuse("The browser did not say how large the file is.", 411)
        if size > limits.file_bytes:
            return _refuse(f"Too large: {megabytes(size)}; a file may have {megabytes(limits.file_bytes)}.", 413)
        try:
            folder = workspace.uploads.path(token)
            sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
            if len(sizes) >= limits.files:
                return _refuse(f"An upload takes at most {limits.files:,} files.", 413)
            if sum(sizes) + size > limits.total_bytes:
                return _refuse(f"An upload takes at most {megabytes(limits.total_bytes)} altogether.", 413)
            path = workspace.uploads.add(token, name, _chunks(size))
        except WorkspaceError as error:
            return _refuse(str(error), 400)
        return jsonify(name=path.name, bytes=size, recording=is_recording(path))

    @routes.delete("/<token>")
    def _remove(token: str) -> Response | tuple[Response, int]:
        try:
            workspace.uploads.remove(token)
        except WorkspaceError as error:
            return _refuse(str(error), 400)
        return jsonify(removed=True)

    return routes


def _chunks(size: int) -> Iterator[bytes]:
    """The body; raises WorkspaceError when the connection ends early, so that no half file is kept."""
    received = 0
    while chunk := request.stream.read(_CHUNK):
        received += len(chunk)
        yield chunk
    if received != size:
        raise WorkspaceError("The file did not arrive whole; upload it again.")


def _refuse(message: str, status: int) -> tuple[Response, int]:
    # A browser that is still sending sees a broken connection, not the answer: small bodies are read to the end.
    drained = 0
    while drained < _DRAIN and (chunk := request.stream.read(_CHUNK)):
        drained += len(chunk)
    return jsonify(error=message), status


def _whole(name: str, default: int) -> int:
    try:
        return max(1, int(os.environ.get(name, default)))
    except ValueError:
        return default
