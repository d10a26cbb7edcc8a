"""Checks what callbacks get from stores against the declared shapes.

Stores live in the browser, so they can hold anything. In place of a value that does not fit the store's shape the
callback gets None, as from an empty store, and a notice is shown.
"""

from __future__ import annotations

import logging
from collections.abc import Callable
from functools import wraps
from typing import Any

import dash
from dash import Output, set_props
from dash.dependencies import DashDependency

from webapp.shell.identifiers import Store
from webapp.shell.messages import notice
from webapp.shell.names import NOTICES
from webapp.shell.shapes import problem

log = logging.getLogger(__name__)


class CheckedDash(dash.Dash):
    """A Dash app whose callbacks get only what the shapes of their stores allow."""

    def callback(self, *dependencies: Any, **options: Any) -> Callable[..., Any]:
        """As ``dash.Dash.callback``; inputs and states stand among ``dependencies``."""
        register = super().callback(*dependencies, **options)
        inputs = [dependency for dependency in dependencies if not isinstance(dependency, Output)]
        return lambda function: register(checked(function, inputs))


def checked(function: Callable[..., Any], dependencies: list[Any]) -> Callable[..., Any]:
    """The function, called with None in place of every value that does not fit its store."""

    @wraps(function)
    def call(*values: Any) -> Any:
        left_out: list[str] = []
        usable = [_usable(one, value, left_out) for one, value in zip(dependencies, values, strict=True)]
        if left_out:
            log.warning("left out of %s: %s", function.__name__, "; ".join(left_out))
            message = "What the page remembered could not be understood, and was left out."
            set_props(NOTICES, {"sendNotifications": [notice("Part of the view was left out", message, "orange")]})
        return function(*usable)

    return call


def _usable(dependency: Any, value: Any, left_out: list[str]) -> Any:
    if isinstance(dependency, dict):
        return {key: _usable(dependency[key], part, left_out) for key, part in value.items()}
    if not isinstance(dependency, DashDependency) or value is None or dependency.component_property != "data":
        return value
    store = dependency.component_id
    words = problem(value, store.content, store) if isinstance(store, Store) else None
    if words:
        left_out.append(words)
    return None if words else value
