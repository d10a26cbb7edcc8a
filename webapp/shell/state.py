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
from webapp.shell import links, names, settings
from webapp.shell.feature import Values, features
from webapp.shell.messages import notice, unknown_page


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
    feature = next(feature for feature in features() if feature.path == page)
    of_page = feature.first_values(workspace, opened.dataset, opened.view) if opened.dataset else {}
    return {
        names.URL: {"pathname": pathname, "search": search},
        names.PAGE: {"children": pages[page]},
        names.DATASET: {"data": opened.dataset},
        names.DATASET_PICKER: _picker(workspace, opened.dataset),
        names.SELECTION: {"data": opened.selection},
        names.VIEW: {"data": opened.view},
        names.STAGE_RESTORE: {"data": opened.stage},
        **of_page,
    }


def _picker(workspace: Workspace, current: str | None) -> dict[str, Any]:
    """The choice of the dataset: the datasets that there are, and the current one."""
    known = [info.name for info in workspace.datasets()]
    return {"data": known, "value": current if current in known else None, "disabled": not known}


def register_pages(app: dash.Dash, pages: Mapping[str, Component]) -> None:
    """The page of the address; pages: path -> page. The first one comes with the layout (see first_values)."""

    @app.callback(Output(names.PAGE, "children"), Input(names.URL, "pathname"), prevent_initial_call=True)
    def show_page(pathname):
        page = links.page_of(pathname)
        return pages[page] if page else unknown_page()


def register(app: dash.Dash, workspace: Workspace) -> None:
    """Registers the callbacks that open links, keep the address up to date, and choose datasets."""

    @app.callback(
        Output(names.DATASET, "data"),
        Output(names.SELECTION, "data"),
        Output(names.VIEW, "data"),
        Output(names.STAGE_RESTORE, "data"),
        Input(names.URL, "pathname"),
        Input(names.URL, "search"),
        State(names.DATASET, "data"),
        State(names.VIEW, "data"),
        prevent_initial_call=True,
    )
    def show_link(pathname, search, current, shown):
        if current and not search:  # a click on the navigation: what is shown stays
            return (no_update,) * 4
        opened = open_link(workspace, pathname, search, current, shown)
        if opened.problems:
            message = notice("Part of the link was left out", " ".join(opened.problems), "orange")
            set_props(names.NOTICES, {"sendNotifications": [message]})
        return opened.dataset, opened.selection, opened.view, opened.stage

    @app.callback(
        Output(names.DATASET_PICKER, "data"),
        Output(names.DATASET_PICKER, "value"),
        Output(names.DATASET_PICKER, "disabled"),
        Input(names.REVISION, "data"),
        Input(names.DATASET, "data"),
        State(names.AWAITED, "data"),
    )
    def show_datasets(_revision, current, awaited):
        known = [info.name for info in workspace.datasets()]
        if awaited in known:  # an import has ended: show what it brought
            set_props(names.AWAITED, {"data": None})
            set_props(names.DATASET_CHOICE, {"data": {"dataset": awaited}})
        elif known and current not in known:
            set_props(names.DATASET_CHOICE, {"data": {"dataset": known[0]}})
        elif not known and current:
            set_props(names.DATASET_CHOICE, {"data": {"dataset": None}})
        return known, current if current in known else None, not known

    app.clientside_callback(
        ClientsideFunction("shell", "choose"), Input(names.DATASET_CHOICE, "data"), State(names.VIEW_OF_DATASET, "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "pick"), Input(names.DATASET_PICKER, "value"), State(names.DATASET, "data")
    )
    app.clientside_callback(
        ClientsideFunction("shell", "address"),
        Output(names.ADDRESS, "data"),
        Input(names.URL, "pathname"),
        Input(names.DATASET, "data"),
        Input(names.SELECTION, "data"),
        Input(names.VIEW, "data"),
        State(names.VIEW_KEYS, "data"),
    )
    app.clientside_callback(ClientsideFunction("shell", "change"), Input(names.VIEW_CHANGE, "data"))
    app.clientside_callback(ClientsideFunction("shell", "restore"), Input(names.STAGE_RESTORE, "data"))
    app.clientside_callback(ClientsideFunction("shell", "current"), Input(names.URL, "pathname"))
    app.clientside_callback(
        ClientsideFunction("shell", "share"), Output(names.NOTICES, "sendNotifications"), Input(names.SHARE, "n_clicks")
    )


def choose_dataset(requested: str | None, known: list[str]) -> tuple[str | None, tuple[str, ...]]:
    """The dataset to show and, where it is not the wanted one, why."""
    if requested in known:
        return requested, ()
    first = known[0] if known else None
    if requested is None:
        return first, ()
    return first, (f"There is no dataset called “{requested[:60]}” here any more.",)
