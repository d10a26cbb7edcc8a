"""Compresses text, and lets browsers keep files for good whose address identifies their content.

A file is compressed when it is first sent and kept in memory after that; pages and answers of callbacks, which differ
each time, are compressed quickly. Motion (floating-point numbers) is sent as it is: it hardly gets smaller.
"""

from __future__ import annotations

import gzip
from functools import lru_cache

import brotli
from dash.fingerprint import check_fingerprint
from flask import Flask, Response, request

FOR_GOOD = "private, max-age=31536000, immutable"
LEAST = 1000  # bytes; smaller answers are sent as they are
KEPT_FILES = 128
COMPRESSED_TYPES = frozenset(
    {
        "application/javascript",
        "application/json",
        "image/svg+xml",
        "image/x-icon",
        "text/css",
        "text/csv",
        "text/html",
        "text/javascript",
        "text/plain",
    }
)
SUITES = "/_dash-component-suites/"


def register(server: Flask, assets: str = "/assets/") -> None:
    """Compresses what ``server`` sends. assets: where the app's own files are, each with ``?m=`` and its date."""

    @server.after_request
    def compress(response: Response) -> Response:
        is_file = request.path.startswith((SUITES, assets))
        if response.status_code != 200:
            return response
        if is_file and _names_content(response):
            response.headers["Cache-Control"] = FOR_GOOD
        if response.mimetype in COMPRESSED_TYPES and (is_file or not response.is_streamed):
            response.vary.add("Accept-Encoding")
            encoding = best_encoding()
            if encoding and request.method != "HEAD" and "Content-Encoding" not in response.headers:
                _encode(response, encoding, is_file)
        return response


def best_encoding() -> str | None:
    """``br`` or ``gzip``, whichever the current request accepts, or None."""
    return next((name for name in ("br", "gzip") if request.accept_encodings.quality(name) > 0), None)


def _names_content(response: Response) -> bool:
    """Whether the address of the requested file identifies its content."""
    if request.path.startswith(SUITES):
        return check_fingerprint(request.path)[1]
    try:
        date = int(float(request.args.get("m", "")))
    except (ValueError, OverflowError):
        return False
    return response.last_modified is not None and date == int(response.last_modified.timestamp())


def _encode(response: Response, encoding: str, is_file: bool) -> None:
    response.direct_passthrough = False  # read a file's content
    content = response.get_data()
    if len(content) < LEAST:
        return
    response.set_data(_compressed_file(content, encoding) if is_file else _compress(content, encoding, quickly=True))
    response.headers["Content-Encoding"] = encoding
    response.headers.pop("Accept-Ranges", None)


@lru_cache(KEPT_FILES)
def _compressed_file(content: bytes, encoding: str) -> bytes:
    return _compress(content, encoding, quickly=False)


def _compress(content: bytes, encoding: str, *, quickly: bool) -> bytes:
    if encoding == "br":
        return brotli.compress(content, quality=4 if quickly else 5)
    return gzip.compress(content, compresslevel=1 if quickly else 6, mtime=0)
