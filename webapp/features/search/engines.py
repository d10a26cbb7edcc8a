"""Everyday names of the engines."""

from __future__ import annotations

from core.retrieval.search import ENGINES as KNOWN

_NAMES = {
    "bounded-edit": "Bounded edit",
    "parts": "Body parts (2009)",
    "printed": "As printed (2009)",
}
ENGINES: dict[str, str] = {method: _NAMES.get(method, method.capitalize()) for method in KNOWN}
"""Method -> name, of the engines there are."""
