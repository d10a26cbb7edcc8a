"""Views that share a place on a page, one visible at a time; the choice is in the link.

The browser shows and hides them without the server (assets/shell/views.mjs).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import dash_mantine_components as dmc
from dash import Dash, Input, Output, State, html
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.shell.attributes import attributes
from webapp.shell.identifiers import Id
from webapp.shell.names import VIEW


def _nothing(app: Dash, workspace: Workspace) -> None:
    """Registers nothing."""


@dataclass(frozen=True)
class PageView:
    """One view: its value in the link, its label, and the functions that make its layout and register its callbacks."""

    value: str
    label: str
    layout: Callable[[], Component]
    register: Callable[[Dash, Workspace], None] = _nothing


@dataclass(frozen=True)
class PageViews:
    """Views that share a place on the page; the first is shown until another is chosen.

    key: of the link. control: id of the control that chooses, which ends in ``-<key>``. label: what the control is
    called for screen readers.
    """

    key: str
    control: Id
    label: str
    views: tuple[PageView, ...]

    def register(self, app: Dash, workspace: Workspace) -> None:
        """Registers the callbacks of the control and of all views."""
        for view in self.views:
            view.register(app, workspace)
        register_switch(app, self.control)

    def switch(self) -> Component:
        """The control that chooses among the views."""
        return dmc.SegmentedControl(
            id=self.control,
            data=[{"value": view.value, "label": view.label} for view in self.views],
            value=self.views[0].value,
            size="xs",
            className="view-switch",
            **attributes(aria_label=self.label),
        )

    def panels(self) -> list[Component]:
        """The layouts of all views; all but the first are hidden."""
        return [panel(self.key, view.value, view.layout(), hidden=view is not self.views[0]) for view in self.views]


def panel(key: str, value: str, content: Component | list[Component], hidden: bool) -> Component:
    """The place of a view: it is shown while ``key`` has this value in the link."""
    classes = "view-panel hidden" if hidden else "view-panel"
    return html.Div(content, className=classes, **attributes(data_key=key, data_value=value))


def register_switch(app: Dash, control: Id) -> None:
    """Registers the callbacks of a control that chooses a view; the last word of its id is the key of the link."""
    app.clientside_callback(ClientsideFunction("views", "chosen"), Input(control, "value"), State(VIEW, "data"))
    app.clientside_callback(
        ClientsideFunction("views", "show"), Output(control, "value"), Input(VIEW, "data"), Input(control, "id")
    )
