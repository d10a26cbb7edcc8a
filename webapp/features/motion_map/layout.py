"""What the Map page consists of; assets/motion_map/*.mjs fill the places whose content follows the pointer."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from webapp.features.motion_map import names
from webapp.features.motion_map.figures.heatmap import COLOURINGS
from webapp.features.motion_map.maps import OtherMap
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends
from webapp.shell.icons import icon
from webapp.ui import method_page
from webapp.ui.charts import CONFIG, empty
from webapp.ui.downloads import table_download
from webapp.ui.views import panel

METHOD = method_page.MethodPage(
    page="map",
    title="Motion map",
    action="Build map",
    doing="Building the map",
    symbol="map",
    hint="It lays all postures out on one plane: click postures to find the motions that pass through them.",
)
BAD_FIT = 2.0  # times the usual distance: postures that the map does not know
CLICKS = (("keys", "Keys"), ("regions", "Regions"), ("draw", "Draw"))
PACES = (("", "Any speed"), ("0-0.25", "On the spot"), ("0.25-1.7", "Walking speed"), ("1.7-99", "Faster"))
WAYS = (("any", "Any way"), ("forward", "Forward"), ("backward", "Backward"), ("left", "To the left"), ("right", "To the right"))  # fmt: skip  # noqa: E501
BELOW = (("hits", "Hits"), ("labels", "Labels"), ("clips", "Clips"), ("region", "Region"))


def page() -> Component:
    """The page before any data is loaded."""
    return html.Div(
        className="map-page",
        children=[
            html.Div(
                className="page-head",
                children=[
                    html.H1("Map"),
                    html.Div(className="spacer"),
                    html.Div(id=names.MAP_MENUS, className="head-menus"),
                    method_page.run_button(METHOD),
                ],
            ),
            method_page.settings_fold(METHOD),
            method_page.status_place(METHOD),
            html.Div(id=names.MAP_MORE),
            html.Div(
                id=names.MAP_RESULT,
                className="hidden",
                children=[
                    html.Div([_map_card(), _side()], className="map-body section"),
                    html.Div(_below(), className="section-head section"),
                    *_panels(),
                ],
            ),
            dcc.Store(id=names.MAP_KNOWN),
            dcc.Store(id=names.MAP_LOOK),
            dcc.Store(id=names.MAP_LIT),
            dcc.Store(id=names.MAP_EXTEND),
            dcc.Store(id=names.MAP_LOADED),
            dcc.Store(id=names.MAP_SHOWN),
            dcc.Store(id=names.MAP_DRAWN),
            dcc.Store(id=names.MAP_PAINTED),
            dcc.Store(id=names.MAP_MARKED),
        ],
    )


def _map_card() -> Component:
    colours = [{"value": value, "label": name} for value, (name, _) in COLOURINGS.items()]
    colour = dmc.Select(
        id=names.MAP_CONTROLS["colour"], data=colours, value="height", size="xs", w=160, allowDeselect=False,
        **attributes(aria_label="Colour the map by"),
    )  # fmt: skip
    click = dmc.SegmentedControl(
        id=names.MAP_CONTROLS["click"],
        data=[{"value": value, "label": label} for value, label in CLICKS],
        value="keys",
        size="xs",
        **attributes(aria_label="What a click on the map does"),
    )
    bar = html.Div([colour, click, html.Div(className="spacer"), _save()], className="map-bar")
    graph = dcc.Graph(id=names.MAP_GRAPH, figure=empty(), config={**CONFIG, "staticPlot": True}, responsive=True)
    plot = html.Div(graph, id=names.MAP_PLOT, className="map-plot")
    return html.Div(
        [
            bar,
            plot,
            html.Div(id=names.MAP_LEGEND, className="map-legend"),
            html.Div(id=names.MAP_EXPLANATION, className="muted map-explanation"),
        ],
        className="card map-card",
    )


def _save() -> Component:
    kinds = {"png": "Picture of the map (PNG)", "svg": "Drawing of the map (SVG)"}
    items = [dmc.MenuItem(label, **attributes(data_map_save=kind)) for kind, label in kinds.items()]
    target = dmc.ActionIcon(
        icon("download", 16), variant="default", size=30, **attributes(aria_label="Save the map as a picture"),
        attributes={"root": {"title": "Save the map as a picture"}},
    )  # fmt: skip
    return dmc.Menu(shadow="md", position="bottom-end", children=[dmc.MenuTarget(target), dmc.MenuDropdown(items)])


def _side() -> Component:
    return html.Div(
        className="card map-side",
        children=[
            html.Div(id=names.MAP_PREVIEW, className="map-preview", **attributes(aria_live="polite")),
            html.Div(
                className="map-block",
                children=[
                    html.Div(
                        [
                            html.H2("Keys"),
                            html.Div(className="spacer"),
                            _do("stage", "person", "Add the posture that the Stage shows now"),
                            _do("edit", "edit", "Shape a posture by hand"),
                            _do("clear", "trash", "Remove all keys"),
                        ],
                        className="map-line",
                    ),
                    html.Div(
                        id=names.MAP_KEYS, className="map-keys", role="list", **attributes(aria_label="Keys in order")
                    ),
                ],
            ),
            html.Div(
                className="map-block",
                children=[
                    html.Div(
                        [
                            html.Span("Keys reach", id=names.MAP_REACH_LABEL),
                            html.Div(id=names.MAP_REACH_BOX, className="map-slider-box"),
                            html.Span(id=names.MAP_REACH_VALUE, className="number muted"),
                        ],
                        className="map-line",
                    ),
                    html.Div(
                        [
                            _pick("pace", PACES, "Speed of the body at the keys"),
                            _pick("way", WAYS, "Direction of travel"),
                        ],
                        className="map-line map-paces",
                    ),
                    html.Div(
                        [
                            html.Span(id=names.MAP_COUNT, className="map-count number", role="status"),
                            html.Div(className="spacer"),
                            html.Button(
                                [icon("play", 14), "Play the best"],
                                id=names.MAP_PLAY_ALL,
                                className="soft-button map-all",
                                title="Play up to 12 hits together",
                                disabled=True,
                                **attributes(data_map_do="all"),
                            ),
                        ],
                        className="map-line",
                    ),
                ],
            ),
        ],
    )


def _do(action: str, symbol: str, label: str) -> Component:
    return dmc.ActionIcon(
        icon(symbol, 16), variant="default", size=28, **attributes(data_map_do=action, aria_label=label),
        attributes={"root": {"title": label}},
    )  # fmt: skip


def _pick(name: str, choices: Sequence[tuple[str, str]], label: str) -> Component:
    data = [{"value": value or "any", "label": label} for value, label in choices]
    return dmc.Select(
        id=names.MAP_CONTROLS[name], data=data, value="any", size="xs", allowDeselect=False, className="map-pick",
        **attributes(aria_label=label),
    )  # fmt: skip


def _below() -> Component:
    return dmc.SegmentedControl(
        id=names.MAP_BELOW,
        data=[{"value": value, "label": label} for value, label in BELOW],
        value=BELOW[0][0],
        size="xs",
        className="view-switch",
        attributes={"root": {"data-key": "below"}},
        **attributes(aria_label="What to look at"),
    )


def _panels() -> list[Component]:
    content: Mapping[str, Component] = {
        "hits": html.Div(id=names.MAP_HITS, className="card map-hits", role="list", **attributes(aria_label="Hits")),
        "labels": html.Div(id=names.MAP_MULTIPLES, className="map-multiples"),
        "clips": html.Div(
            [
                html.Div(
                    [html.Div(className="spacer"), table_download(names.MAP_CLIPS, "clips on the map")],
                    className="table-bar",
                ),
                html.Div(id=names.MAP_CLIPS_PLACE),
            ]
        ),
        "region": html.Div(id=names.MAP_REGION, className="card map-region-panel"),
    }
    return [panel("below", value, content[value], hidden=number > 0) for number, (value, _) in enumerate(BELOW)]


def menus(key: str | None, earlier: list[Component], copies: list[Component]) -> list[Component]:
    """Menus of earlier maps, of downloads of the map that is shown, and of recipes for it."""
    if not key:
        return earlier
    items = [
        dmc.MenuItem("Map, regions and runs (JSON)", href=f"/api/map/{key}.json", refresh=True),
        dmc.MenuItem("Node of every frame (CSV)", href=f"/api/map/{key}.csv", refresh=True),
        dmc.MenuDivider(),
        *copies,
    ]
    target = dmc.Button("Download", variant="default", leftSection=icon("download", 16))
    return [*earlier, dmc.Menu([dmc.MenuTarget(target), dmc.MenuDropdown(items)], shadow="md", position="bottom-end")]


def legend(entries: Sequence[Mapping[str, Any]], scale: Mapping[str, str] | None) -> list[Component]:
    """Categories and their colours, or the scale of the numbers."""
    if scale:
        bar = html.Span(className="map-scale", style={"background": f"linear-gradient(to right, {scale['colours']})"})
        return [html.Span(scale["least"], className="number"), bar, html.Span(scale["most"], className="number")]
    return [
        html.Span(entry["name"], className="map-legend-entry ellipsis", style={"--tone": entry["colour"]})
        for entry in entries
    ]


def others_menu(others: Sequence[OtherMap]) -> list[Component]:
    """A menu of maps of other clips, on whose postures these clips can be laid; empty where there is none."""
    if not others:
        return []
    items = [
        dmc.MenuItem(
            [
                html.Div(other.dataset, className="menu-title"),
                html.Div(f"{other.summary}, {other.when}", className="muted menu-note"),
            ],
            **sends(names.MAP_EXTEND, {"model": other.key}, every_time=True),
        )
        for other in others
    ]
    target = dmc.Button("Lay on another map", variant="default", rightSection=icon("chevron", 14))
    menu = dmc.Menu(
        [dmc.MenuTarget(target), dmc.MenuDropdown(items, className="menu-long")], shadow="md", position="bottom-end"
    )
    return [menu]


def extend_note(others: Sequence[OtherMap], dataset: str | None) -> list[Component]:
    """Where the clips of a data set have changed since its map was built: a way to keep that map."""
    mine = next((other for other in others if other.dataset == dataset), None)
    if mine is None:
        return []
    words = f"The clips have changed since the map of {mine.when} was built. They can be laid on it as it is: that is quick, and shows how well the new ones fit."  # noqa: E501
    return [_note(words, "Lay them on it", {"model": mine.key})]


def laid_note(worst: float) -> list[Component]:
    """Where a map shows clips that it has not learned."""
    words = "These clips lie on the postures of an earlier map, which has not learned them."
    if worst >= BAD_FIT:
        words += f" Some fit badly (up to {worst:.1f} times the usual distance): see Clips below."
    return [_note(words, "Learn a new map", {"model": ""})]


def _note(words: str, label: str, value: Mapping[str, str]) -> Component:
    button = dmc.Button(label, variant="light", size="xs", **sends(names.MAP_EXTEND, value, every_time=True))
    return html.Div([icon("info", 16), html.Span(words), button], className="card map-note section")
