"""What people write, and JSON from outside: cleaned, with a limit on its size."""

from __future__ import annotations

import json
import math
import unicodedata
from collections.abc import Mapping
from typing import Any

from core.workspace.errors import WorkspaceError

LONGEST_NAME = 80  # letters of a person's name
_DEEPEST = 12  # levels of lists and mappings in a JSON value


def one_line(text: object, what: str, longest: int, *, needed: bool = False) -> str:
    """One line of readable text; raises WorkspaceError where it is too long, or empty though it is needed."""
    plain = unicodedata.normalize("NFC", str(text))
    plain = " ".join("".join(c if unicodedata.category(c)[0] != "C" else " " for c in plain).split())
    return _bounded(plain, what, longest, needed)


def paragraphs(text: object, what: str, longest: int, *, needed: bool = False) -> str:
    """Text of several lines without control characters; raises WorkspaceError as :func:`one_line`."""
    plain = unicodedata.normalize("NFC", str(text)).replace("\r\n", "\n")
    plain = "".join(c for c in plain if c in "\n\t" or unicodedata.category(c)[0] != "C").strip()
    return _bounded(plain, what, longest, needed)


def _bounded(text: str, what: str, longest: int, needed: bool) -> str:
    if needed and not text:
        raise WorkspaceError(f"The {what} is empty.")
    if len(text) > longest:
        raise WorkspaceError(f"The {what} has at most {longest:,} letters; this one has {len(text):,}.")
    return text


def plain_json(value: object, what: str, largest: int) -> Any:
    """``value`` as JSON gives it back (tuples become lists); raises WorkspaceError where JSON cannot hold it.

    largest: letters of its JSON.
    """
    plain = _plain(value, what, _DEEPEST)
    size = len(json.dumps(plain, allow_nan=False))
    if size > largest:
        raise WorkspaceError(f"The {what} are too large: {size:,} letters, where {largest:,} fit.")
    return plain


def _plain(value: object, what: str, depth: int) -> Any:
    if not depth:
        raise WorkspaceError(f"The {what} are nested too deeply.")
    if isinstance(value, Mapping) and all(isinstance(key, str) for key in value):
        return {key: _plain(part, what, depth - 1) for key, part in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(part, what, depth - 1) for part in value]
    if value is None or isinstance(value, str | bool | int) or (isinstance(value, float) and math.isfinite(value)):
        return value
    raise WorkspaceError(f"The {what} hold something that is not text, a finite number, a list or a mapping.")
