"""The Sweeps page's callbacks."""

from __future__ import annotations

from dash import Dash

from core.workspace import Workspace


def register(app: Dash, workspace: Workspace) -> None:
    """All of the page's callbacks."""
