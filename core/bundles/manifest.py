"""The list of files of a bundle, and how JSON is written in one: the same state gives the same bytes."""

from __future__ import annotations

import json

FORMAT = "motionscape/bundle/1"
MANIFEST = "manifest.json"


def plain(content: object) -> str:
    """JSON in one line, keys in order."""
    return json.dumps(content, ensure_ascii=False, sort_keys=True, separators=(",", ":"), default=dict)
