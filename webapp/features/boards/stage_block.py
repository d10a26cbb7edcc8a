"""What a Stage loop on a board plays: a selection, as the Stage plays it."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import Any

from core.errors import ParameterError
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from webapp.shell.playback import selected_request


def content(
    workspace: Workspace, dataset: Dataset, view: Mapping[str, str], options: Mapping[str, str]
) -> dict[str, Any]:
    """``request``: what the Stage plays for the option ``selection`` (JSON). Raises ParameterError where it is none."""
    try:
        selection = json.loads(options.get("selection", "{}"))
    except ValueError as error:
        raise ParameterError("What this block plays cannot be read; choose it again.") from error
    if not isinstance(selection, dict) or not selection:
        raise ParameterError("Nothing was selected when this block was added: select something and choose it again.")
    request = selected_request(workspace, dataset.name, selection, view)
    if request is None:
        raise ParameterError("What this block plays is not there: its result has not been computed, or has changed.")
    return {"request": request}


def segments(content: Mapping[str, Any]) -> Iterator[tuple[str, int, int]]:
    """What plays; figures of other datasets are left out."""
    request = content["request"]
    for item in request["items"]:
        if item.get("dataset") in (None, request["dataset"]) and "start" in item:
            yield item["clip"], item["start"], item["end"]
