"""Attributes whose names have hyphens, which Python's keywords cannot have."""

from __future__ import annotations

from typing import Any


def attributes(**values: str | float) -> dict[str, Any]:
    """``attributes(aria_label="Pages")`` is ``{"aria-label": "Pages"}``: pass it to a component with ``**``."""
    return {name.replace("_", "-"): value for name, value in values.items()}
