"""``GET /api/stage/<page>?<what a link says>``: what the Stage would play for a link.

The browser asks for it when the pointer rests on a motif, so that a click finds its motions already there
(assets/stage/ahead.mjs). The callback in webapp/shell/playback.py gives the same answer a round trip later.
"""

from __future__ import annotations

import json

from flask import Blueprint, Response, request

from core.workspace import Workspace
from webapp.shell import links, playback
from webapp.shell.routes import answer_errors


def stage_blueprint(workspace: Workspace) -> Blueprint:
    """The one route, for the data sets and results of ``workspace``."""
    blueprint = Blueprint("stage", __name__, url_prefix="/api")
    answer_errors(blueprint)

    @blueprint.get("/stage/<page>")
    def stage(page: str) -> Response:
        view, _ = links.parse(page, request.query_string.decode("utf-8", "replace"))
        played = playback.selected_request(workspace, view.dataset, view.selection, view.view)
        # null where nothing plays; in the order of the callback's answer, because the Stage compares the two
        return Response(json.dumps(played), mimetype="application/json", headers={"Cache-Control": "no-store"})

    return blueprint
