"""The frame around every page: header, navigation, page, Stage, job bar, and the stores that say what is shown."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from webapp.shell import links, theme
from webapp.shell.feature import features
from webapp.shell.icons import icon


def layout(stage: Component, job_bar: Component, stores: Sequence[Component]) -> Component:
    """Everything that stays when one goes to another page.

    stage: the one persistent player. stores: those of the jobs and the features.
    """
    return dmc.MantineProvider(
        id="mantine",
        theme=theme.MANTINE,
        defaultColorScheme="auto",
        children=[
            *_stores(),
            *stores,
            html.A("Skip to the page", href="#page", className="skip-link"),
            html.Div(
                className="shell",
                id="shell",
                children=[
                    _header(),
                    _navigation(),
                    html.Main(id="page", className="page", tabIndex="-1"),
                    html.Div(
                        id="splitter",
                        className="splitter",
                        role="separator",
                        tabIndex="0",
                        title="Drag, or use the arrow keys, to resize the stage",
                        **{"aria-label": "Width of the stage", "aria-orientation": "vertical"},
                    ),
                    html.Aside(stage, className="stage-panel", **{"aria-label": "Stage"}),
                    job_bar,
                ],
            ),
        ],
    )


def _stores() -> list[Component]:
    """State that names what one sees: ids only, and all of it is in the URL."""
    return [
        dcc.Location(id="url", refresh=False),
        dcc.Store(id="dataset"),  # its name
        dcc.Store(id="parameters", data={}),  # the method's, as text, defaults left out
        dcc.Store(id="selection", data={}),  # see links.View.selection
        dcc.Store(id="view", data={}),  # what a page shows beside that, see links.view_keys
        dcc.Store(id="view-change"),  # merged into "view"; null or "" takes a key out
        dcc.Store(id="view-keys", data=links.view_keys()),
        dcc.Store(id="view-of-dataset", data=links.keys_of_dataset()),
        dcc.Store(id="stage-restore", data={}),  # moment and camera a link asked for
        dcc.Store(id="dataset-choice"),  # {"dataset": name}: someone chose another one
        dcc.Store(id="awaited"),  # name of the dataset an import of ours will bring
        dcc.Store(id="job-started"),
        dcc.Store(id="job-ended"),
        dcc.Store(id="theme", data="light"),
        dcc.Store(id="revision"),  # changes with the list of datasets
        dcc.Store(id="address"),
    ]


def _header() -> Component:
    return html.Header(
        className="header",
        children=[
            dcc.Link(
                [icon("logo", 22), html.Span("Motionscape", className="brand-name")], href="/library", className="brand"
            ),
            dmc.Select(
                id="dataset-picker",
                className="dataset-picker",
                placeholder="No dataset yet",
                searchable=True,
                allowDeselect=False,
                nothingFoundMessage="No dataset of this name",
                leftSection=icon("stack", 16),
                comboboxProps={"shadow": "md"},
                **{"aria-label": "Dataset"},
            ),
            # in the header's free space (assets/notices.css), where they cover no control
            dmc.NotificationContainer(id="notices", position="top-center", limit=4, autoClose=6000, withinPortal=False),
            dmc.Button(
                "Share",
                id="share",
                variant="default",
                leftSection=icon("link", 16),
                **{"aria-label": "Copy a link to this view"},
            ),
            dmc.ColorSchemeToggle(
                id="scheme-toggle",
                lightIcon=icon("sun"),
                darkIcon=icon("moon"),
                variant="default",
                size=36,
                **{"aria-label": "Switch between light and dark"},
            ),
        ],
    )


def _navigation() -> Component:
    return html.Nav(
        className="navigation",
        children=[
            dcc.Link(
                [icon(feature.symbol, 22), html.Span(feature.label)],
                href=f"/{feature.path}",
                id=f"nav-{feature.path}",
                className="nav-link",
            )
            for feature in features()
        ],
        **{"aria-label": "Pages"},
    )
