"""Downloads of results."""

from __future__ import annotations

import json
from urllib.parse import quote

from flask import Blueprint, Response, jsonify, request

from core.workspace import Workspace, WorkspaceError
from webapp import results


def export_blueprint(workspace: Workspace) -> Blueprint:
    """``GET /api/motifs.json?dataset=...&kappa=...``: the graph of that request, as the command line writes it."""
    routes = Blueprint("exports", __name__, url_prefix="/api")

    @routes.get("/motifs.json")
    def motifs_json() -> Response | tuple[Response, int]:
        name = request.args.get("dataset", "")
        parameters = {key: value for key, value in request.args.items() if key != "dataset"}
        try:
            problems = results.refused(parameters)
            if problems:
                return jsonify(error=" ".join(problems)), 400
            graph = results.motif_graph(workspace, name, parameters)
            if graph is None:
                return jsonify(error="This motif graph has not been computed yet."), 404
            document = graph.to_json(workspace.open(name))
        except WorkspaceError as error:
            return jsonify(error=str(error)), 404
        answer = Response(json.dumps(document, ensure_ascii=False, allow_nan=False), mimetype="application/json")
        answer.headers["Content-Disposition"] = f"attachment; filename*=UTF-8''{quote(name + '-motifs.json')}"
        return answer

    return routes
