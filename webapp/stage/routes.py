"""All routes of the Stage: motion, its pictures, and what a link would play."""

from __future__ import annotations

from flask import Blueprint

from core.workspace import Workspace
from webapp.shell.virtual import opener
from webapp.stage.filmstrip_routes import filmstrip_blueprint
from webapp.stage.motion_routes import motion_blueprint
from webapp.stage.selection_routes import stage_blueprint


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes for one workspace, made-up motion included."""
    open_dataset = opener(workspace)
    return [motion_blueprint(open_dataset), filmstrip_blueprint(open_dataset), stage_blueprint(workspace)]
