"""The properties of the clips that a data set has now, not of those that it once had."""

from __future__ import annotations

from core.mocap.properties import Properties
from core.workspace.workspace import Workspace


def present_properties(workspace: Workspace, dataset: str) -> Properties:
    """The properties of the clips of a data set. Raises WorkspaceError where there is none, DocumentDamaged."""
    return workspace.properties.of(workspace.info(dataset).id).of_clips(workspace.open(dataset).names)
