"""The Search page: the search itself, its evaluation by labels, the study with people, and its indexes."""

from __future__ import annotations

from dash import Dash
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.features.search import callbacks, evaluation, layout, storage, study, words_view


def page() -> Component:
    """The page before any data is loaded."""
    return layout.page(
        {
            "words": words_view.layout(),
            "agree": study.layout(),
            "evaluate": evaluation.layout(),
            "indexes": storage.layout(),
        }
    )


def register(app: Dash, workspace: Workspace) -> None:
    """Registers the page's callbacks."""
    callbacks.register(app, workspace)
    study.register(app, workspace)
    evaluation.register(app, workspace)
    storage.register(app, workspace)
    words_view.register(app, workspace)
