"""What Ctrl+K finds: datasets, clips, motifs, actions and settings by a few letters of their names.

Features say in ``Feature.places`` what is there; pages, boards and saved views are known in the browser.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, replace
from heapq import nsmallest
from itertools import islice
from typing import TYPE_CHECKING

from flask import Blueprint, Response, jsonify, request

from webapp.shell import links, settings
from webapp.shell.feature import Place, features
from webapp.shell.names import MethodNames
from webapp.shell.routes import answer_errors

if TYPE_CHECKING:
    from core.workspace import Workspace

MOST = 12  # of each kind
LONGEST = 200  # letters of a query that are looked at


def find(workspace: Workspace, link: str, text: str) -> list[Place]:
    """Places whose name and description hold all words of ``text``; first those that are called so, or begin so.

    link: of what is shown now; its dataset, settings and results are looked through.
    """
    shown, _ = links.parse(*link.partition("?")[::2])
    words = text[:LONGEST].casefold().split()

    def distance(place: Place) -> int:
        name = place.name.casefold()
        return [name == " ".join(words), name.startswith(" ".join(words)), name.startswith(words[0]), True].index(True)

    known = [info.name for info in workspace.datasets()]
    if shown.dataset not in known:
        shown = replace(shown, dataset=known[0] if known else None)
    found: list[Place] = []
    for places in (*(feature.places for feature in features()), _settings):
        matching = (place for place in places(workspace, shown) if _matches(place, words))
        found += nsmallest(MOST, matching, key=distance) if words else islice(matching, MOST)
    return sorted(found, key=distance) if words else found


def _matches(place: Place, words: Iterable[str]) -> bool:
    text = f"{place.name} {place.about}".casefold()
    return all(word in text for word in words)


def _settings(_workspace: Workspace, shown: links.View) -> Iterable[Place]:
    """The settings of all methods, each on the page of its method."""
    for feature in features():
        address = links.format_link(replace(shown, page=feature.path, selection={}, stage={}))
        for name in feature.methods:
            for parameter in settings.parameters(name):
                about = f"setting of {feature.label} ({parameter.name})"
                yield Place(parameter.label or parameter.name, about, address, opens=MethodNames(name).fold)


def places_blueprint(workspace: Workspace) -> Blueprint:
    """The route that the browser asks with every letter."""
    routes = Blueprint("places", __name__, url_prefix="/api/places")
    answer_errors(routes)

    @routes.get("")
    def places() -> Response:
        found = find(workspace, request.args.get("link", ""), request.args.get("text", ""))
        return jsonify({"places": [asdict(place) for place in found]})

    return routes
