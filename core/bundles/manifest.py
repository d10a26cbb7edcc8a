"""The list of files of a bundle, and how JSON is written in one: the same state gives the same bytes."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

FORMAT = "motionscape/bundle/1"
MANIFEST = "manifest.json"
DRAWN = ("block", "picture", "report")
"""Kinds of results that are drawings for a page: made anew from other results, and never taken from elsewhere."""


def is_drawn(document: Mapping[str, Any]) -> bool:
    """Whether a result is a drawing: see DRAWN."""
    kind = str(document.get("format", "")).split("/")
    return len(kind) > 1 and kind[1] in DRAWN


def plain(content: object) -> str:
    """JSON in one line, keys in order."""
    return json.dumps(content, ensure_ascii=False, sort_keys=True, separators=(",", ":"), default=dict)
