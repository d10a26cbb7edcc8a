"""The app: one Dash application for one workspace."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import dash
from dash import Input, Output, State, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core import analyses
from core.workspace import Workspace, WorkspaceError, shared_workspace
from webapp import access, jobs, links, playback, results, settings
from webapp.api.clip import clip_blueprint
from webapp.api.exports import export_blueprint
from webapp.api.filmstrip import filmstrip_blueprint
from webapp.api.grammar import grammar_blueprint
from webapp.api.motion import motion_blueprint
from webapp.api.motion_map import map_blueprint
from webapp.api.recordings import recordings_blueprint
from webapp.api.search import search_blueprint
from webapp.api.stage import stage_blueprint
from webapp.api.uploads import Limits, upload_blueprint
from webapp.components import changes, errors, features, job_bar, shell
from webapp.components import stage as stage_component
from webapp.pages import clip, grammar, library, motifs, motion_map, search, sweeps
from webapp.virtual import open_any

PAGES = {  # beside the library: name in the address (a key of links.VIEW_KEYS) -> module with page() and register()
    "motifs": motifs,
    "sweeps": sweeps,
    "search": search,
    "grammar": grammar,
    "map": motion_map,
    "clip": clip,
}


def create_app(workspace_path: str | Path, *, token: str | None = None) -> dash.Dash:
    """The app for the workspace at ``workspace_path`` (made where missing); with ``token`` only for those who have it.

    Raises WorkspaceError where the folder cannot be used.
    """
    workspace = shared_workspace(workspace_path)
    app = dash.Dash(
        __name__,
        title="Motionscape",
        update_title=None,
        assets_folder=str(_assets()),
        serve_locally=True,
        suppress_callback_exceptions=True,
        background_callback_manager=jobs.background_manager(workspace.path),
        on_error=errors.on_callback_error,
    )
    app.layout = shell.layout(stage_component.stage())
    access.protect(app.server, token)
    errors.register(app.server)
    limits = Limits.from_environment()
    open_motion = partial(open_any, workspace)
    for blueprint in (
        upload_blueprint(workspace, limits),
        motion_blueprint(open_motion),
        clip_blueprint(open_motion),
        stage_blueprint(workspace),
        map_blueprint(workspace, open_motion),
        filmstrip_blueprint(open_motion),
        export_blueprint(workspace),
        grammar_blueprint(workspace),
        recordings_blueprint(workspace, open_motion),
        search_blueprint(workspace),
    ):
        app.server.register_blueprint(blueprint)
    stage_component.register(app)
    job_bar.register(app, workspace)
    changes.register(app, workspace)
    features.register(app, workspace)
    _register_state(app, workspace)
    _register_page(app, {name: page.page() for name, page in PAGES.items()} | {"library": library.page(limits)})
    for page in (library, *PAGES.values()):
        page.register(app, workspace)
    playback.register(app, workspace)
    return app


def _assets() -> Path:
    """The bundled front end: in a wheel it lies in the package, in a checkout beside it."""
    packaged = Path(__file__).parent / "assets"
    return packaged if packaged.is_dir() else Path(__file__).parents[1] / "assets" / "bundle"


def _register_page(app: dash.Dash, pages: dict[str, Component]) -> None:
    @app.callback(Output("page", "children"), Input("url", "pathname"))
    def show_page(pathname):
        page = links.page_of(pathname)
        return pages[page] if page else errors.unknown_page()


def _register_state(app: dash.Dash, workspace: Workspace) -> None:
    names = tuple(parameter.name for parameter in analyses.parameters(results.MOTIFS))

    @app.callback(
        Output("dataset", "data"),
        Output("parameters", "data"),
        Output("selection", "data"),
        Output("view", "data"),
        Output("stage-restore", "data"),
        Input("url", "pathname"),
        Input("url", "search"),
        State("dataset", "data"),
        State("view", "data"),
    )
    def open_link(pathname, search, current, shown):
        if current and not search:  # a click on the navigation: what is shown stays
            return (no_update,) * 5
        view, problems = links.parse(pathname, search, names)
        known = [info.name for info in workspace.datasets()]
        dataset, more = choose_dataset(view.dataset, known)
        if links.page_of(pathname) is None:
            problems = problems[1:]  # the page itself says so
        problems = (*more, *problems, *results.refused(view.parameters), *settings.refused(view.page, view.view))
        if problems:
            message = " ".join(problems)
            set_props(
                "notices", {"sendNotifications": [errors.notice("Part of the link was left out", message, "orange")]}
            )
        usable = results.not_default(results.motif_request("", view.parameters).parameters)
        if more:
            view = links.without_selection(view)
        others = settings.of_other_pages(view.page, shown) if dataset == current else {}
        return dataset, usable, dict(view.selection), others | view.view, dict(view.stage)

    @app.callback(
        Output("dataset-picker", "data"),
        Output("dataset-picker", "value"),
        Output("dataset-picker", "disabled"),
        Input("revision", "data"),
        Input("dataset", "data"),
        State("awaited", "data"),
    )
    def show_datasets(_revision, current, awaited):
        known = [info.name for info in workspace.datasets()]
        if awaited in known:  # an import has ended: show what it brought
            set_props("awaited", {"data": None})
            set_props("dataset-choice", {"data": {"dataset": awaited}})
        elif known and current not in known:
            set_props("dataset-choice", {"data": {"dataset": known[0]}})
        elif not known and current:
            set_props("dataset-choice", {"data": {"dataset": None}})
        return known, current if current in known else None, not known

    app.clientside_callback(
        ClientsideFunction("shell", "choose"), Input("dataset-choice", "data"), State("view-of-dataset", "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "pick"), Input("dataset-picker", "value"), State("dataset", "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "address"),
        Output("address", "data"),
        Input("url", "pathname"),
        Input("dataset", "data"),
        Input("parameters", "data"),
        Input("selection", "data"),
        Input("view", "data"),
        State("view-keys", "data"),
    )
    app.clientside_callback(ClientsideFunction("shell", "change"), Input("view-change", "data"), State("view", "data"))
    app.clientside_callback(ClientsideFunction("shell", "restore"), Input("stage-restore", "data"))
    app.clientside_callback(ClientsideFunction("shell", "current"), Input("url", "pathname"))
    app.clientside_callback(
        ClientsideFunction("shell", "share"), Output("notices", "sendNotifications"), Input("share", "n_clicks")
    )

    path = str(workspace.path)

    @app.callback(
        Output("job-ended", "data"),
        Input("job-started", "data"),
        background=True,
        prevent_initial_call=True,
    )
    def follow(job_id):
        return jobs.work(path, job_id)


def choose_dataset(wanted: str | None, known: list[str]) -> tuple[str | None, tuple[str, ...]]:
    """The dataset to show and, where it is not the wanted one, why."""
    if wanted in known:
        return wanted, ()
    first = known[0] if known else None
    if wanted is None:
        return first, ()
    return first, (f"There is no dataset called “{wanted[:60]}” here any more.",)


__all__ = ["WorkspaceError", "create_app"]
