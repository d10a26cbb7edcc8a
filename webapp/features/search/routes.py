"""``GET /api/search/explain?<link>&hit=`` explains a hit; ``/api/search/hits.csv``, ``.json``: all hits of a search."""

from __future__ import annotations

import json

from flask import Blueprint, Response, jsonify, request

from core.errors import AnalysisError, MotionscapeError
from core.mocap.dataset import Dataset
from core.rankings import evaluate
from core.workspace import Workspace, WorkspaceError
from webapp.features.search import searching
from webapp.features.search.figures import hits as figures
from webapp.features.search.queries import read_hit
from webapp.shell import links, settings
from webapp.shell.errors import sentence
from webapp.shell.routes import BadRequest, answer_errors, attachment
from webapp.ui.tables import labels_by_clip


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [search_blueprint(workspace)]


def search_blueprint(workspace: Workspace) -> Blueprint:
    """The routes of one workspace; their query string is that of a link to the page."""
    routes = Blueprint("search", __name__, url_prefix="/api/search")
    answer_errors(routes)

    @routes.get("/explain")
    def explain() -> Response:
        dataset, view = _requested_view(workspace)
        hit = read_hit(view.get("hit", ""))
        if hit is None:
            raise BadRequest("The link names no hit.")
        try:
            search = searching.read(view)
            why = searching.explain(workspace, dataset, view, hit)
            pieces = search.pieces if search else ()
            query = searching.query_of(workspace, dataset, pieces)
            sources = [searching.source_of(workspace, dataset, piece) for piece in pieces]
        except KeyError:
            raise BadRequest(f"There is no clip called “{hit.clip}” in this index.", 404) from None
        except MotionscapeError as error:
            raise BadRequest(sentence(error)) from None
        played = figures.pair_request(dataset, sources, query, hit, why)
        return jsonify(strip=figures.strip_of(why), request=played)

    @routes.get("/hits.csv")
    def hits_csv() -> Response:
        dataset, result = _requested_result(workspace)
        labels = labels_by_clip(dataset)
        rows = [(hit, searching.label_of(labels, hit.segment)) for hit in result.hits]
        return attachment(figures.hits_csv(dataset, rows), "text/csv", f"{dataset.name}-hits.csv")

    @routes.get("/hits.json")
    def hits_json() -> Response:
        dataset, result = _requested_result(workspace)
        _, view = _requested_view(workspace)
        parameters = dict(settings.request_of(searching.PAGE, dataset.name, view).parameters)
        parameters |= {"weights": result.search.weights, "level": result.level, "root_path": result.search.route}
        index = searching.index_of(workspace, dataset.name, view)
        document = figures.hits_json(
            dataset, result.query, result.hits, parameters, index.seconds if index else {}, result.milliseconds
        )
        return attachment(json.dumps(document, ensure_ascii=False), "application/json", f"{dataset.name}-hits.json")

    @routes.get("/ranking.json")
    def ranking_json() -> Response:
        dataset, view = _requested_view(workspace)
        rankings = settings.result_of(workspace, "ranking", dataset.name, view)
        if rankings is None:
            raise BadRequest("The engines have not been compared with these settings yet.", 404)
        try:
            scores = evaluate(rankings, dataset)
        except AnalysisError as error:
            raise BadRequest(sentence(error)) from None
        head = {"format": "motionscape/evaluation/1", "dataset": {"name": dataset.name}}
        document = (
            head | {"parameters": dict(rankings.parameters), "seconds": dict(rankings.seconds)} | scores.to_json()
        )
        return attachment(json.dumps(document), "application/json", f"{dataset.name}-evaluation.json")

    @routes.get("/ratings.csv")
    def ratings_csv() -> Response:
        name = request.args.get("dataset", "")
        return attachment(workspace.ratings.export_ratings(_id(workspace, name)), "text/csv", f"{name}-ratings.csv")

    @routes.get("/votes.csv")
    def votes_csv() -> Response:
        name = request.args.get("dataset", "")
        return attachment(workspace.ratings.export_votes(_id(workspace, name)), "text/csv", f"{name}-votes.csv")

    return routes


def _id(workspace: Workspace, name: str) -> str:
    try:
        return workspace.info(name).id
    except WorkspaceError as error:
        raise BadRequest(str(error), 404) from None


def _requested_view(workspace: Workspace) -> tuple[Dataset, dict[str, str]]:
    """Data set and view of the current request. Raises BadRequest."""
    view, _ = links.parse("/search", request.query_string.decode("utf-8", "replace"))
    try:
        return workspace.open(view.dataset or ""), dict(view.view)
    except WorkspaceError as error:
        raise BadRequest(str(error), 404) from None


def _requested_result(workspace: Workspace) -> tuple[Dataset, searching.SearchResult]:
    dataset, view = _requested_view(workspace)
    try:
        result = searching.find(workspace, dataset, {**view, "top": view.get("top") or str(searching.MOST)})
    except MotionscapeError as error:
        raise BadRequest(sentence(error)) from None
    if result is None:
        raise BadRequest("There is no query, or the index has not been built yet.", 404)
    return dataset, result
