"""Short names of clips, as assets/stage/names.mjs makes them."""

from __future__ import annotations

import re
from collections.abc import Sequence

_WORTH_LEAVING_OUT = 8  # letters


def brief_names(names: Sequence[str], most: int = 20) -> list[str]:
    """Shortens each name to ``most`` characters: leaves out a long beginning that all share, then the middle."""
    shared = _shared_beginning(names) if len(set(names)) > 1 else ""
    start = len(shared) if len(shared) >= _WORTH_LEAVING_OUT else 0
    return [_shorten(name[start:] or name, most) for name in names]


def _shared_beginning(names: Sequence[str]) -> str:
    """The beginning that all names share, up to its last separator."""
    first, last = min(names), max(names)
    n = next((n for n, (a, b) in enumerate(zip(first, last, strict=False)) if a != b), min(len(first), len(last)))
    return re.sub(r"[^\s_\-/.:]*$", "", first[:n])


def _shorten(text: str, most: int) -> str:
    kept = (most - 1) // 2
    return text if len(text) <= most else f"{text[: most - 1 - kept].rstrip()}…{text[-kept:].lstrip()}"
