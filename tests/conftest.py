"""Fixtures that every test may use."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Folder of real recordings beside the checkout (or MOTIONSCAPE_SHARED/data); skips where it is absent."""
    shared = Path(os.environ.get("MOTIONSCAPE_SHARED", REPOSITORY.parent / "shared"))
    if not (shared / "data" / "README.md").is_file():
        pytest.skip(f"real recordings are not here: {shared / 'data'}")
    return shared / "data"
