"""A saved view on a board: its picture, and the link that opens it."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from typing import Any

from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.features.boards.pictures import picture_of


def content(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any]:
    """The view with its picture as a ``data:`` address, or "". Raises DocumentGone where it is not there."""
    saved = workspace.views.get(options.get("view", ""))
    picture = picture_of(workspace, saved.id, saved.version)
    return {
        "title": saved.title,
        "note": saved.note,
        "tags": list(saved.tags),
        "address": saved.address,
        "author": saved.author,
        "updated": saved.updated,
        "picture": f"data:image/jpeg;base64,{base64.b64encode(picture).decode()}" if picture else "",
    }
