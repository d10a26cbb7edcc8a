"""Requests of callbacks that no page of ours has sent: refused in words where Dash would break over them."""

from __future__ import annotations

import json
from typing import Any

from dash import Dash
from dash._utils import split_callback_id
from flask import g, jsonify, request
from flask.typing import ResponseReturnValue

ROUTE = "/_dash-update-component"


def register(app: Dash) -> None:
    """Answers 400 to what is no request of a callback, before Dash looks at it; also where Dash breaks over one whose
    parts are not those of the callback."""

    @app.server.before_request
    def _check() -> ResponseReturnValue | None:
        if request.method != "POST" or not request.path.endswith(ROUTE):
            return None
        body = sent_json()
        if not isinstance(body, dict) or has_lone_surrogates(request.get_data(), body):
            return refusal("it cannot be read")
        output = body.get("output")
        if not isinstance(output, str) or output not in app.callback_map:
            return refusal("there is no such callback")
        g.misfit = fault(body, app.callback_map[output])
        return None


def refusal(reason: str) -> ResponseReturnValue:
    """The answer to what no page of ours has sent."""
    return jsonify(error=f"This is no request of a page: {reason}. Reload the page."), 400


def misfit() -> str | None:
    """How the current request differs from those of its callback, in words; None where it does not."""
    words: str | None = g.get("misfit")
    return words


def sent_json() -> Any:
    """The JSON of the current request; None where it holds none that can be read."""
    try:
        return request.get_json(silent=True)
    except RecursionError:
        return None


def fault(body: dict[str, Any], callback: dict[str, Any]) -> str | None:
    """What is wrong with the request of a callback, in words; None where nothing is."""
    for name in ("inputs", "state"):
        given, declared = body.get(name, []), callback[name]
        if not isinstance(given, list) or len(given) != len(declared) or not all(map(_is_value, given)):
            return f"its {name} are not those of the callback"
    outputs = split_callback_id(body["output"]) if callback.get("output") else []
    if not _fits(body.get("outputs", []), outputs):
        return "its outputs are not those of the callback"
    changed = body.get("changedPropIds", [])
    if not isinstance(changed, list) or not all(isinstance(name, str) and "." in name for name in changed):
        return "what has changed is no list of names"
    return None


def _fits(given: Any, declared: Any) -> bool:
    """Whether a request names the outputs of its callback; ``declared``: one, or a list."""
    if isinstance(declared, list):
        return isinstance(given, list) and len(given) == len(declared) and all(map(_fits, given, declared))
    if declared["id"].startswith("{"):  # a pattern stands for any number of components
        return _is_value(given) and (isinstance(given, list) or '"ALL' not in declared["id"])
    return isinstance(given, dict) and given.get("id") == declared["id"] and isinstance(given.get("property"), str)


def has_lone_surrogates(text: bytes, body: Any) -> bool:
    """Whether JSON holds half characters, which no answer can repeat. Browsers escape them, so few bodies are read."""
    if b"\\ud" not in text.lower():
        return False
    try:
        json.dumps(body, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        return True
    return False


def _is_value(entry: Any) -> bool:
    """Whether Dash names a component's property so, or several in a list."""
    if isinstance(entry, list):
        return all(map(_is_value, entry))
    named = isinstance(entry, dict) and isinstance(entry.get("property"), str)
    return named and isinstance(entry.get("id"), str | dict)
