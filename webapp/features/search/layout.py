"""The layout of the Search page: containers that assets/search/*.mjs fill, and the controls of the search."""

from __future__ import annotations

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.poses.body_parts import PRESETS
from webapp.features.search import names
from webapp.features.search.engines import ENGINES
from webapp.features.search.figures.hits import body
from webapp.features.search.searching import PAGE
from webapp.shell.attributes import attributes
from webapp.shell.icons import icon
from webapp.shell.uploads import SUFFIXES
from webapp.ui.method_page import MethodPage, run_button, settings_fold, status_place
from webapp.ui.views import panel

VIEWS = {
    "search": "Search",
    "words": "By words",
    "agree": "Do people agree?",
    "evaluate": "Evaluation",
    "indexes": "Indexes",
}

METHOD = MethodPage(
    page=PAGE,
    title="Search index",
    action="Build index",
    doing="Building the search index",
    symbol="search",
    hint="Searches are then immediate, for motions of these recordings and uploaded ones.",
    without=("method",),
)


def page(panels: dict[str, Component]) -> Component:
    """The page before any data is loaded; ``panels``: of the views beside the search itself."""
    return html.Div(
        className="search-page",
        children=[
            html.Div(
                className="page-head",
                children=[
                    html.H1("Search"),
                    _views(panels),
                    html.Div(className="spacer"),
                    html.Div(id=names.SEARCH_MENUS, className="head-menus"),
                    run_button(METHOD),
                ],
            ),
            panel("look", "search", [settings_fold(METHOD), _search()], hidden=False),
            *(panel("look", value, content, hidden=True) for value, content in panels.items()),
        ],
    )


def _views(panels: dict[str, Component]) -> Component:
    return dmc.SegmentedControl(
        id=names.SEARCH_LOOK,
        data=[{"value": value, "label": label} for value, label in VIEWS.items() if value in ("search", *panels)],
        value="search",
        size="xs",
        **attributes(aria_label="What to look at"),
    )


def _search() -> Component:
    return html.Div(
        [
            html.Div(className="card search-query section", children=[_query(), _fold(), _wanted()]),
            status_place(METHOD),
            html.Div(id=names.SEARCH_ERROR, className="search-error hidden", role="alert"),
            html.Div(id=names.SEARCH_HITS_HEAD, className="section-head section hidden"),
            html.Div(
                id=names.SEARCH_HITS, className="card search-hits hidden", role="list", **attributes(aria_label="Hits")
            ),
            *_stores(),
        ]
    )


def _query() -> Component:
    """The sources of the query; assets/search/sources.mjs draws them."""
    return html.Div(
        className="search-from",
        children=[
            html.Div(id=names.SEARCH_SOURCES, className="search-sources"),
            html.Datalist(id=names.SEARCH_CLIP_NAMES),
            html.Div(
                className="search-choose",
                role="group",
                children=[
                    _button("From the Stage", "stage", "Look for what the Stage shows, from its start to its end"),
                    html.Select(
                        id=names.SEARCH_MOTIF,
                        className="search-select hidden",
                        **attributes(aria_label="Look for a motif"),
                    ),
                    _button(
                        [icon("upload", 14), "Upload a file"],
                        "upload",
                        "Search for an uploaded motion: BVH, or AMC with its ASF",
                        "for-editors",
                    ),
                    _button(
                        [icon("plus", 14), "Combine"], "combine", "Take other parts of the body from another motion"
                    ),
                    _button([icon("back", 14), "Back"], "back", "Back to the previous query", "hidden"),
                ],
                **attributes(aria_label="Where the query comes from", data_suffixes=",".join(SUFFIXES)),
            ),
            html.Div(id=names.SEARCH_UPLOAD_STATUS, className="search-upload", role="status"),
            html.Div(id=names.SEARCH_WARNING, className="search-warning hidden", role="status"),
        ],
    )


def _fold() -> Component:
    """Opens and closes the options, and sums up the choices in a line."""
    return html.Button(
        [
            icon("chevron", 14),
            html.B("What counts"),
            html.Span(id=names.SEARCH_COUNTS_SAYS, className="muted ellipsis"),
        ],
        id=names.SEARCH_COUNTS,
        type="button",
        className="search-fold",
        **attributes(aria_expanded="true", aria_controls=names.SEARCH_WANTED),
    )


def _wanted() -> Component:
    """The options: parts of the body (assets/search/body.mjs), kind of hits, path, filters (options.mjs)."""
    engines = [{"value": value, "label": label} for value, label in ENGINES.items()]
    return html.Div(
        id=names.SEARCH_WANTED,
        className="search-wanted",
        children=[
            html.Div(id=names.SEARCH_BODY, className="search-body"),
            html.Div(id=names.SEARCH_OPTIONS, className="search-options"),
            dcc.Store(id=names.SEARCH_ENGINES, data=engines),
        ],
    )


def _button(label, action: str, tip: str, more: str = "") -> Component:
    return html.Button(
        label, type="button", className=f"search-button {more}".strip(), title=tip, **attributes(data_search=action)
    )


def _stores() -> list[Component]:
    return [
        dcc.Store(id=names.SEARCH_PRESETS, data={name: dict(weights) for name, weights in PRESETS.items()}),
        dcc.Store(id=names.SEARCH_PARTS, data=body()),
        dcc.Store(id=names.SEARCH_CLIPS),  # the clips and actions there are to choose from
        dcc.Store(id=names.SEARCH_TYPED),
        dcc.Store(id=names.SEARCH_MOTIFS),  # the motifs there are
        dcc.Store(id=names.SEARCH_FOUND),  # the query and its hits; drawn by assets/search/search.mjs
        dcc.Store(id=names.SEARCH_DRAWN),
        dcc.Store(id=names.SEARCH_LISTED),
        dcc.Store(id=names.SEARCH_UPLOAD),  # {"token", "name"}: a recording has arrived
        dcc.Store(id=names.SEARCH_UPLOAD_JOB),  # {"job"}: it is being read
        dcc.Store(id=names.SEARCH_UPLOAD_DONE),
    ]
