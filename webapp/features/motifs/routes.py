"""Downloads of results under /api: motifs.json, .csv and .svg, timeline.svg, stability.json; walks by their key."""

from __future__ import annotations

import json
import re

from flask import Blueprint, Response, request

from core import analyses
from core.mocap.dataset import Dataset
from core.motifs.graph import MotifGraph
from core.synthesis import kept_walks
from core.workspace import Workspace, WorkspaceError
from webapp.features.motifs import stability_request
from webapp.features.motifs.figures.drawing import graph_svg
from webapp.features.motifs.figures.timeline_drawing import timeline_svg
from webapp.features.motifs.graph_drawing import graph_elements
from webapp.shell import results, settings
from webapp.shell.routes import Refusal, answer_refusals, attachment
from webapp.ui.tables import motions_csv
from webapp.ui.timeline import timeline


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [export_blueprint(workspace)]


def export_blueprint(workspace: Workspace) -> Blueprint:
    """The routes of one workspace; errors are JSON in plain words."""
    routes = Blueprint("exports", __name__, url_prefix="/api")

    answer_refusals(routes)

    @routes.get("/motifs.json")
    def motifs_json() -> Response:
        dataset, graph, _ = _requested(workspace)
        notes = results.motif_notes(workspace, dataset.name, request.args)
        text = json.dumps(graph.to_json(dataset, notes), ensure_ascii=False, allow_nan=False)
        return attachment(text, "application/json", f"{dataset.name}-motifs.json")

    @routes.get("/motifs.csv")
    def motifs_csv() -> Response:
        dataset, graph, _ = _requested(workspace)
        notes = results.motif_notes(workspace, dataset.name, request.args)
        return attachment(motions_csv(dataset, graph, notes), "text/csv", f"{dataset.name}-motifs.csv")

    @routes.get("/stability.json")
    def stability_json() -> Response:
        dataset, _, _ = _requested(workspace)
        stability = stability_request.stored(workspace, dataset.name, request.args, request.args.get("stability"))
        if stability is None:
            raise Refusal("The stability of these motifs has not been measured yet.", 404)
        return attachment(json.dumps(stability.to_json()), "application/json", f"{dataset.name}-stability.json")

    @routes.get("/walk/<key>.json")
    def walk_json(key: str) -> Response:
        walk = analyses.kept(workspace, "walk", key) if re.fullmatch(r"[0-9a-f]{8,64}", key) else None
        if walk is None:
            raise Refusal("This walk is no longer there; make it again on the Motifs page.", 404)
        return attachment(json.dumps(kept_walks.walk_json(walk)), "application/json", "walk.json")

    @routes.get("/motifs.svg")
    def motifs_svg() -> Response:
        dataset, graph, key = _requested(workspace)
        elements = graph_elements(dataset, key, graph)
        return attachment(
            graph_svg(elements, title=f"Motifs of {dataset.name}"), "image/svg+xml", f"{dataset.name}-motifs.svg"
        )

    @routes.get("/timeline.svg")
    def timeline_drawing() -> Response:
        dataset, graph, _ = _requested(workspace)
        given, chosen = request.args, request.args.get("motif", "")
        data = timeline(dataset, graph, results.motif_notes(workspace, dataset.name, request.args))
        text = timeline_svg(
            data,
            given.get("order", "name"),
            given.get("scale", "same"),
            int(chosen) if chosen.isdecimal() else None,
            given.get("scheme", "light"),
        )
        return attachment(text, "image/svg+xml", f"{dataset.name}-timeline.svg")

    return routes


def _requested(workspace: Workspace) -> tuple[Dataset, MotifGraph, str]:
    """Data set, graph and key of the current request; raises Refusal."""
    name = request.args.get("dataset", "")
    problems = settings.refused(results.MOTIFS, request.args)
    if problems:
        raise Refusal(" ".join(problems), 400)
    try:
        dataset = workspace.open(name)
        graph = results.motif_graph(workspace, name, request.args)
        key = results.motif_graph_key(workspace, name, request.args)
    except WorkspaceError as error:
        raise Refusal(str(error), 404) from error
    if graph is None or key is None:
        raise Refusal("This motif graph has not been computed yet.", 404)
    return dataset, graph, key
