"""Downloads of grammars.

``GET /api/grammar.json``, ``grammar-actions.csv``, ``grammar-rules.csv`` and ``grammar-tree.svg``, each with
``?dataset=...&grammar-n_terminals=...`` (a tree: ``&routine=N`` of the recordings, or ``&sentence=CODE`` of a new one).
``GET /api/derivation/<key>.json``: where every frame of a new routine comes from. ``GET /api/bakeoff/<key>.json``: the
comparison of four ways.
"""

from __future__ import annotations

import json

from flask import Blueprint, Response, request

from core.errors import ParameterError
from core.grammar.learned import LearnedGrammar
from core.grammar.trees import leaves
from core.mocap.dataset import Dataset
from core.synthesis.kept_bakeoff import bakeoff_json
from core.synthesis.kept_derivations import derivation_json
from core.workspace import MotifNote, Workspace, WorkspaceError
from webapp.features.grammar import bakeoffs, compositions, grammars
from webapp.features.grammar.figures import actions, rules
from webapp.features.grammar.figures.parse_tree import tree_svg
from webapp.shell import settings, theme
from webapp.shell.routes import Refusal, answer_refusals, attachment
from webapp.ui.filmstrip import icon_data_uri

COLOURS = theme.CANVAS["light"] | {"selected": "#e6eefb"}


def blueprints(workspace: Workspace) -> list[Blueprint]:
    """The routes of the page for one workspace."""
    return [grammar_blueprint(workspace)]


def grammar_blueprint(workspace: Workspace) -> Blueprint:
    """The routes of one workspace; errors are JSON in plain words."""
    routes = Blueprint("grammar", __name__, url_prefix="/api")
    answer_refusals(routes)
    _learned(routes, workspace)
    _made(routes, workspace)
    return routes


def _learned(routes: Blueprint, workspace: Workspace) -> None:
    """Registers the routes of grammars."""

    @routes.get("/grammar.json")
    def grammar_json() -> Response:
        dataset, learned, notes = _requested_grammar(workspace)
        document = learned.to_json()
        for terminal in document["terminals"]:
            note = notes.get(terminal["id"])
            if note is not None and note.name:
                terminal["name"] = note.name
        text = json.dumps(document, ensure_ascii=False, allow_nan=False)
        return attachment(text, "application/json", f"{dataset.name}-grammar.json")

    @routes.get("/grammar-actions.csv")
    def actions_csv() -> Response:
        dataset, learned, notes = _requested_grammar(workspace)
        text = actions.segments_csv(dataset, learned.terminals.segments, notes)
        return attachment(text, "text/csv", f"{dataset.name}-actions.csv")

    @routes.get("/grammar-rules.csv")
    def rules_csv() -> Response:
        dataset, learned, notes = _requested_grammar(workspace)
        names = {k: actions.action_name(k, notes) for k in range(learned.terminals.n_terminals)}
        text = rules.rules_csv(learned.grammar.rules, learned.grammar.start, names)
        return attachment(text, "text/csv", f"{dataset.name}-rules.csv")

    @routes.get("/grammar-tree.svg")
    def tree() -> Response:
        dataset, learned, notes = _requested_grammar(workspace)
        if request.args.get("sentence"):
            try:
                drawn = compositions.tree_of(learned, request.args["sentence"])
            except ParameterError as error:
                raise Refusal(f"{error}.", 400) from error
            typical = learned.terminals.medoids
            segments = [typical[action] for action in leaves(drawn)]
        else:
            number = grammars.routine_number(learned, dict(request.args))
            routine = grammars.routines(learned)[number]
            drawn, segments = routine.tree, [segment for _, segment in routine.pieces]
        svg = tree_svg(
            drawn,
            grammars.tree_names(learned, notes),
            actions.tones(learned.terminals.n_terminals),
            colours=COLOURS,
            pictures=[icon_data_uri(dataset, segment, "light") for segment in segments],
        )
        return attachment(svg, "image/svg+xml", f"{dataset.name}-tree.svg")


def _made(routes: Blueprint, workspace: Workspace) -> None:
    """Registers the routes of new routines and comparisons."""

    @routes.get("/derivation/<key>.json")
    def derivation(key: str) -> Response:
        result = compositions.find_derivation(workspace, key)
        if result is None:
            raise Refusal("This routine is no longer there; make it again on the Grammar page.", 404)
        return attachment(json.dumps(derivation_json(result)), "application/json", "routine.json")

    @routes.get("/bakeoff/<key>.json")
    def bakeoff(key: str) -> Response:
        result = bakeoffs.kept_bakeoff(workspace, key)
        if result is None:
            raise Refusal("This comparison is no longer there; make it again on the Grammar page.", 404)
        return attachment(json.dumps(bakeoff_json(result)), "application/json", "comparison.json")


def _requested_grammar(workspace: Workspace) -> tuple[Dataset, LearnedGrammar, dict[int, MotifNote]]:
    """Data set, grammar and notes of the current request; raises Refusal."""
    name, view = request.args.get("dataset", ""), dict(request.args)
    problems = settings.refused(grammars.PAGE, view)
    if problems:
        raise Refusal(" ".join(problems), 400)
    try:
        dataset = workspace.open(name)
    except WorkspaceError as error:
        raise Refusal(str(error), 404) from error
    learned = grammars.learned(workspace, name, view)
    if learned is None:
        raise Refusal("This has not been computed yet; press Learn the rules on the Grammar page.", 404)
    return dataset, learned, grammars.notes_of(workspace, name, view) or {}
