"""The frame around every page: header, navigation, page, Stage, job bar, and the stores that say what is shown."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from webapp.shell import links, names, settings, theme
from webapp.shell.attributes import attributes
from webapp.shell.feature import features
from webapp.shell.icons import icon


def layout(stage: Component, job_bar: Component, stores: Sequence[Component]) -> Component:
    """Everything that stays when another page is opened.

    stage: the one persistent player. stores: those of the jobs and the features.
    """
    return dmc.MantineProvider(
        id=names.MANTINE,
        theme=theme.MANTINE,
        defaultColorScheme="auto",
        children=[
            *_stores(),
            *stores,
            html.A("Skip to the page", href="#page", className="skip-link"),
            html.Div(
                className="shell",
                id=names.SHELL,
                children=[
                    _header(),
                    _navigation(),
                    html.Main(id=names.PAGE, className="page", tabIndex="-1"),
                    html.Div(
                        id=names.SPLITTER,
                        className="splitter",
                        role="separator",
                        tabIndex="0",
                        title="Drag, or use the arrow keys, to resize the stage",
                        **attributes(
                            aria_label="Width of the stage",
                            aria_orientation="vertical",
                            aria_valuenow="37",  # percent of the window; assets/shell/frame.mjs keeps it up to date
                        ),
                    ),
                    html.Aside(stage, className="stage-panel", **attributes(aria_label="Stage")),
                    job_bar,
                ],
            ),
        ],
    )


def _stores() -> list[Component]:
    """The stores that say what is shown, by ids; all of it is in the URL."""
    return [
        dcc.Location(id=names.URL, refresh=False),
        dcc.Store(id=names.DATASET),  # its name
        dcc.Store(id=names.SELECTION, data={}),  # see links.View.selection
        dcc.Store(id=names.VIEW, data={}),  # what a page shows beside that, and the settings: see links.view_keys
        dcc.Store(id=names.VIEW_CHANGE),  # merged into "view"; null or "" takes a key out
        dcc.Store(id=names.VIEW_KEYS, data=links.view_keys()),
        dcc.Store(id=names.SETTINGS_KEYS, data={name: settings.keys(name) for name in settings.methods()}),
        dcc.Store(id=names.VIEW_OF_DATASET, data=links.keys_of_dataset()),
        dcc.Store(id=names.STAGE_RESTORE, data={}),  # moment and camera a link asked for
        dcc.Store(id=names.DATASET_CHOICE),  # {"dataset": name}: someone chose another one
        dcc.Store(id=names.AWAITED),  # name of the dataset an import of ours will bring
        dcc.Store(id=names.JOB_STARTED),
        dcc.Store(id=names.JOB_ENDED),
        dcc.Store(id=names.THEME, data="light"),
        dcc.Store(id=names.REVISION),  # changes with the list of datasets
        dcc.Store(id=names.ADDRESS),
    ]


def _header() -> Component:
    return html.Header(
        className="header",
        children=[
            dcc.Link(
                [icon("logo", 22), html.Span("Motionscape", className="brand-name")], href="/library", className="brand"
            ),
            dmc.Select(
                id=names.DATASET_PICKER,
                className="dataset-picker",
                placeholder="No dataset yet",
                searchable=True,
                allowDeselect=False,
                nothingFoundMessage="No dataset of this name",
                leftSection=icon("stack", 16),
                comboboxProps={"shadow": "md"},
                **attributes(aria_label="Dataset"),
            ),
            # in the header's free space (assets/shell/notices.css), where they cover no control
            dmc.NotificationContainer(
                id=names.NOTICES, position="top-center", limit=4, autoClose=6000, withinPortal=False
            ),
            *(control for feature in features() for control in feature.header()),
            dmc.Button(
                "Share",
                id=names.SHARE,
                variant="default",
                leftSection=icon("link", 16),
                **attributes(aria_label="Share: copy a link to this view"),
            ),
            html.Div(id=names.PERSON, className="person"),
            dmc.ColorSchemeToggle(
                id=names.SCHEME_TOGGLE,
                lightIcon=icon("sun"),
                darkIcon=icon("moon"),
                variant="default",
                size=36,
                **attributes(aria_label="Switch between light and dark"),
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
                id=names.NAV(feature.path),
                className="nav-link",
            )
            for feature in features()
        ],
        **attributes(aria_label="Pages"),
    )
