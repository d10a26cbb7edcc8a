"""The stores that say what is shown: opened from a link, kept in the address; and the choice of the dataset."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import dash
from dash import Input, Output, State, no_update, set_props
from dash.dependencies import ClientsideFunction
from dash.development.base_component import Component

from core.workspace import Workspace
from webapp.shell import links, settings
from webapp.shell.messages import notice, unknown_page

Values = dict[str, dict[str, Any]]
"""Id of a component -> its properties."""


@dataclass(frozen=True)
class OpenedLink:
    """What a link opens: data of the stores of these names, and what of the link cannot be opened, as sentences."""

    dataset: str | None
    selection: dict[str, Any]
    view: dict[str, Any]
    stage: dict[str, Any]
    problems: tuple[str, ...] = ()


def open_link(
    workspace: Workspace, pathname: str, search: str, current: str | None = None, view: Mapping[str, str] | None = None
) -> OpenedLink:
    """What the address names. current, view: the dataset and the view shown until now, if any."""
    link, problems = links.parse(pathname, search)
    known = [info.name for info in workspace.datasets()]
    dataset, more = choose_dataset(link.dataset, known)
    if links.page_of(pathname) is None:
        problems = problems[1:]  # the page itself says so
    usable, refused = settings.usable(link.page, link.view)
    link = replace(link, view=usable)
    if more:
        link = links.without_selection(link)
    others = settings.of_other_pages(link.page, view) if dataset == current else {}
    return OpenedLink(
        dataset,
        dict(link.selection),
        {**others, **link.view},
        dict(link.stage),
        (*more, *problems, *refused),
    )


def first_values(workspace: Workspace, pages: Mapping[str, Component], pathname: str, search: str) -> Values:
    """What an address shows, for the layout that the browser gets first: id of a component -> its properties.

    Empty where the link has problems: then the browser asks, as it does for every later link, and is told of them.
    """
    page = links.page_of(pathname)
    if page is None or (opened := open_link(workspace, pathname, search)).problems:
        return {}
    return {
        "url": {"pathname": pathname, "search": search},
        "page": {"children": pages[page]},
        "dataset": {"data": opened.dataset},
        "selection": {"data": opened.selection},
        "view": {"data": opened.view},
        "stage-restore": {"data": opened.stage},
    }


def register_pages(app: dash.Dash, pages: Mapping[str, Component]) -> None:
    """The page of the address; pages: path -> page. The first one comes with the layout (see first_values)."""

    @app.callback(Output("page", "children"), Input("url", "pathname"), prevent_initial_call=True)
    def show_page(pathname):
        page = links.page_of(pathname)
        return pages[page] if page else unknown_page()


def register(app: dash.Dash, workspace: Workspace) -> None:
    """Links open what they name, the address follows what is shown, and datasets can be chosen."""

    @app.callback(
        Output("dataset", "data"),
        Output("selection", "data"),
        Output("view", "data"),
        Output("stage-restore", "data"),
        Input("url", "pathname"),
        Input("url", "search"),
        State("dataset", "data"),
        State("view", "data"),
        prevent_initial_call=True,
    )
    def show_link(pathname, search, current, shown):
        if current and not search:  # a click on the navigation: what is shown stays
            return (no_update,) * 4
        opened = open_link(workspace, pathname, search, current, shown)
        if opened.problems:
            message = notice("Part of the link was left out", " ".join(opened.problems), "orange")
            set_props("notices", {"sendNotifications": [message]})
        return opened.dataset, opened.selection, opened.view, opened.stage

    @app.callback(
        Output("dataset-picker", "data"),
        Output("dataset-picker", "value"),
        Output("dataset-picker", "disabled"),
        Input("revision", "data"),
        Input("dataset", "data"),
        State("awaited", "data"),
    )
    def show_datasets(_revision, current, awaited):
        known = [info.name for info in workspace.datasets()]
        if awaited in known:  # an import has ended: show what it brought
            set_props("awaited", {"data": None})
            set_props("dataset-choice", {"data": {"dataset": awaited}})
        elif known and current not in known:
            set_props("dataset-choice", {"data": {"dataset": known[0]}})
        elif not known and current:
            set_props("dataset-choice", {"data": {"dataset": None}})
        return known, current if current in known else None, not known

    app.clientside_callback(
        ClientsideFunction("shell", "choose"), Input("dataset-choice", "data"), State("view-of-dataset", "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "pick"), Input("dataset-picker", "value"), State("dataset", "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "address"),
        Output("address", "data"),
        Input("url", "pathname"),
        Input("dataset", "data"),
        Input("selection", "data"),
        Input("view", "data"),
        State("view-keys", "data"),
    )
    app.clientside_callback(ClientsideFunction("shell", "change"), Input("view-change", "data"))
    app.clientside_callback(ClientsideFunction("shell", "restore"), Input("stage-restore", "data"))
    app.clientside_callback(ClientsideFunction("shell", "current"), Input("url", "pathname"))
    app.clientside_callback(
        ClientsideFunction("shell", "share"), Output("notices", "sendNotifications"), Input("share", "n_clicks")
    )


def choose_dataset(requested: str | None, known: list[str]) -> tuple[str | None, tuple[str, ...]]:
    """The dataset to show and, where it is not the wanted one, why."""
    if requested in known:
        return requested, ()
    first = known[0] if known else None
    if requested is None:
        return first, ()
    return first, (f"There is no dataset called “{requested[:60]}” here any more.",)
