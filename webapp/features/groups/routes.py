"""Routes of the Groups page: ``/api/groups/<dataset>``, what can be compared, comparisons, and their files."""

from __future__ import annotations

import json

from flask import Blueprint, Response, jsonify, request

from core import analyses
from core.errors import AnalysisError, ParameterError
from core.groups.documents import to_csv
from core.workspace import Workspace
from webapp import jobs
from webapp.features.groups.comparisons import choices, request_of, state_of
from webapp.features.groups.recipes import command, script
from webapp.shell.routes import BadRequest, answer_errors, attachment, json_body


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    routes = Blueprint("groups", __name__, url_prefix="/api/groups")
    answer_errors(routes)

    @routes.get("/<dataset>")
    def show_choices(dataset: str) -> Response:
        return jsonify(choices(workspace, dataset))

    @routes.get("/<dataset>/comparison")
    def show_comparison(dataset: str) -> Response:
        try:
            return jsonify(state_of(workspace, request_of(workspace, dataset, request.args), request.args))
        except (AnalysisError, ParameterError) as error:  # no fault of the request: what is chosen cannot be compared
            return jsonify(state="refused", error=str(error))

    @routes.post("/<dataset>/comparison")
    def start_comparison(dataset: str) -> Response:
        link = {str(key): str(value) for key, value in json_body().items()}
        asked = request_of(workspace, dataset, link)
        if analyses.stored(workspace, asked) is None:
            return jsonify(job=jobs.start(workspace, asked).id)
        return jsonify(job=None)

    @routes.get("/<dataset>/<kind>.file")
    def groups_file(dataset: str, kind: str) -> Response:
        found = state_of(workspace, request_of(workspace, dataset, request.args), request.args)
        if found["state"] != "ready":
            raise BadRequest("This comparison has not been made yet.", 404)
        document = found["document"]
        if kind == "csv":
            return attachment(to_csv(document), "text/csv", f"{dataset}-groups.csv")
        if kind == "json":
            return attachment(json.dumps(document, ensure_ascii=False), "application/json", f"{dataset}-groups.json")
        if kind == "py":
            return attachment(script(workspace.path, dataset, document), "text/x-python", f"{dataset}-groups.py")
        if kind == "sh":
            return attachment(command(workspace.path, dataset, document), "text/plain", f"{dataset}-groups.sh")
        raise BadRequest("A comparison is written as csv, json, py or sh.")

    return [routes]
