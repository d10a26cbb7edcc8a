"""What each route and callback does to the workspace: marks of the features, of the other parts and of Dash itself."""

from __future__ import annotations

from dash import Dash
from flask import request

from webapp.shell.callback_requests import sent_json
from webapp.shell.feature import features
from webapp.shell.rights import OPEN, READS, Rights, callback_name, name_of

CALLBACKS = "/_dash-update-component"  # Dash's route for all callbacks: what it does depends on the callback
SHARED = Rights(
    package="webapp",
    reads=(
        "jobs.changes.announce",
        "jobs.following.follow",
        "jobs.job_bar.poll",
        "shell.places.places",
        "shell.monitoring.metrics",
        "shell.playback.play",
        "shell.sign_in.who_am_i",
        "shell.state.show_datasets",
        "shell.state.show_link",
        "shell.state.show_page",
        "stage.filmstrip_routes.filmstrip",
        "stage.filmstrip_routes.icon",
        "stage.motion_routes.motion",
        "stage.motion_routes.motions",
        "stage.selection_routes.stage",
        "ui.method_page.find_result",
        "ui.method_page.show_estimate",
        "ui.method_page.show_form",
        "ui.method_page.show_left_out",
        "ui.method_page.show_status",
    ),
    asks=("jobs.job_bar.act", "ui.method_page.run"),
    changes=(
        "jobs.changes.undo",
        "shell.uploads._add",
        "shell.uploads._create",
        "shell.uploads._remove",
    ),
    open=("shell.sign_in.show_sign_in", "shell.sign_in.sign_out", "shell.sign_in.take_sign_in"),
)
DASH = {  # endpoints of Dash and Flask: the page, its files and its layout
    **dict.fromkeys(("/", "/<path:path>", "/_dash-layout", "/_dash-dependencies", "/_reload-hash"), READS),
    **dict.fromkeys(("static", "_dash_assets.static"), READS),
    "/_dash-component-suites/<string:package_name>/<path:fingerprinted_path>": READS,
    "/_favicon.ico": OPEN,
}


def all_marks() -> dict[str, str]:
    """Full name of a function behind a route or callback -> what it does."""
    marks = SHARED.marks()
    for feature in features():
        marks |= feature.rights.marks()
    return marks


def mark_of_request(app: Dash, marks: dict[str, str]) -> str | None:
    """What the current request does; None where it has no mark. A request for nothing that exists reads nothing."""
    endpoint = request.endpoint
    if endpoint is None:
        return READS
    if endpoint == CALLBACKS:
        body = sent_json()
        return marks.get(callback_name(app.callback_map, body.get("output") if isinstance(body, dict) else None))
    return DASH.get(endpoint) or marks.get(name_of(app.server.view_functions[endpoint]))
