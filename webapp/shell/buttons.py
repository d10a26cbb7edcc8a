"""Buttons that write into a store in the browser (assets/shell/selecting.mjs), without a callback for each.

Lists are redrawn often and hold many buttons; one listener on the document serves them all, and server callbacks
take the store as their only input.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any


def copies(text: str) -> dict[str, Any]:
    """Attributes for a button: a click copies ``text`` to the clipboard and says so."""
    return {"data-copy": text}


def similar(clip: str, start: int, end: int) -> dict[str, Any]:
    """Attributes for a button: a click goes to the Search page and looks for frames ``[start, end)`` of a clip."""
    return {"data-similar": json.dumps({"clip": clip, "start": int(start), "end": int(end)})}


def sends(
    store: str, value: Mapping[str, object], *, every_time: bool = False, page: str | None = None
) -> dict[str, Any]:
    """Attributes for a button: a click puts ``value`` into ``store``, and goes to ``page`` where one is given.

    every_time: callbacks run also when the store holds the value already.
    """
    attributes = {"data-store": store, "data-value": json.dumps(value)}
    return attributes | ({"data-stamp": "yes"} if every_time else {}) | ({"data-page": f"/{page}"} if page else {})
