"""The app: one Dash application for one workspace, put together from the shell, the Stage and the features."""

from __future__ import annotations

from pathlib import Path

import webapp.features  # noqa: F401  registers the features
from core.workspace import WorkspaceError, shared_workspace
from webapp import jobs
from webapp.jobs import changes, following, job_bar
from webapp.marks import all_marks, mark_of_request
from webapp.shell import (
    access,
    callback_requests,
    compression,
    frame,
    messages,
    monitoring,
    person_menu,
    playback,
    state,
)
from webapp.shell.assets import PARTS, VENDOR, assets_folder
from webapp.shell.feature import features
from webapp.shell.loading import LoadingDash
from webapp.shell.places import places_blueprint
from webapp.shell.uploads import Limits, upload_blueprint
from webapp.stage import player
from webapp.stage import routes as stage_routes
from webapp.ui.first_table import first_table


def create_app(workspace_path: str | Path, *, token: str | None = None) -> LoadingDash:
    """The app for the workspace at ``workspace_path`` (made where missing); with ``token`` only for those who have it.

    Raises WorkspaceError where the folder cannot be used.
    """
    workspace = shared_workspace(workspace_path)
    jobs.get_ready(workspace)
    app = LoadingDash(
        __name__,
        title="Motionscape",
        update_title="",
        assets_folder=str(assets_folder()),
        assets_path_ignore=[VENDOR, PARTS],
        serve_locally=True,
        suppress_callback_exceptions=True,
        background_callback_manager=jobs.background_manager(),
        on_error=messages.on_callback_error,
    )
    stores = [*changes.stores(), *(store for feature in features() for store in feature.stores())]
    app.layout = frame.layout(player.stage(), job_bar.layout(), stores)
    pages = {feature.path: feature.page() for feature in features()}
    app.shown_at_once = {feature.path: feature.shows for feature in features()}
    app.first_values = lambda pathname, search: (
        state.first_values(workspace, pages, pathname, search)
        | job_bar.first_values(workspace)
        | person_menu.first_values(workspace)
    )
    app.drawings = {"AgGrid": first_table}
    for feature in features():
        app.drawings |= feature.drawings
    marks = all_marks()
    monitoring.register(app.server, workspace)
    access.protect(app.server, workspace, token, lambda: mark_of_request(app, marks))
    callback_requests.register(app)
    compression.register(app.server)
    messages.register(app.server)
    blueprints = [upload_blueprint(workspace, Limits.from_environment()), *stage_routes.blueprints(workspace)]
    blueprints.append(places_blueprint(workspace))
    blueprints += [blueprint for feature in features() for blueprint in feature.routes(workspace)]
    for blueprint in blueprints:
        app.server.register_blueprint(blueprint)
    player.register(app)
    for part in (job_bar, changes, following, state, playback):
        part.register(app, workspace)
    state.register_pages(app, pages)
    for feature in features():
        feature.register(app, workspace)
    return app


__all__ = ["WorkspaceError", "create_app"]
