"""The layout of the Clip page."""

from __future__ import annotations

from collections.abc import Sequence

import dash_mantine_components as dmc
from dash import dcc, html
from dash.development.base_component import Component

from core.editing.curves import TRAVEL, ClipCurves
from core.mocap.dataset import Dataset
from core.poses.angles import JOINTS
from webapp.features.clip import editing, names, table
from webapp.features.clip.clips import CHARTS, KINDS, Choice, joint_words, offered_joints
from webapp.features.clip.figures.curves import Panel
from webapp.shell.attributes import attributes
from webapp.shell.buttons import sends, similar
from webapp.shell.icons import icon
from webapp.shell.messages import empty_state
from webapp.shell.names import SELECTION
from webapp.ui.page_head import page_head

HINT = (
    "Click to go to a moment, drag to select a range; Ctrl + wheel to zoom. With the chart in focus: arrows step, "
    "[ and ] set the ends of the range, Esc clears it, + − 0 zoom, Space plays."
)


def page() -> Component:
    """The page before any data is loaded."""
    return html.Div(
        className="clip-page",
        children=[
            _head(),
            html.Div(id=names.CLIP_NOTHING),
            html.Div(
                id=names.CLIP_BODY,
                className="hidden",
                children=[
                    html.Div(id=names.CLIP_FACTS, className="muted clip-facts"),
                    _choosers(),
                    html.Div(
                        id=names.CLIP_LEGEND,
                        className="clip-legend",
                        role="group",
                        **attributes(aria_label="Values at the cursor"),
                    ),
                    _chart(),
                    html.Div(id=names.CLIP_RANGE, className="clip-range"),
                    html.Div([html.H2("Doubts")], className="section-head section"),
                    html.Div(id=names.CLIP_DOUBTS, className="card clip-doubts"),
                    html.Div([html.H2("Gait")], className="section-head section"),
                    html.Div(id=names.CLIP_GAIT, className="card clip-gait"),
                ],
            ),
            dcc.Store(id=names.CLIP_SHOWN),  # {"dataset", "version", "clip", "fps", "frames"}
            dcc.Store(id=names.CLIP_CHOICE),  # the joints and channels that the chart shows
            dcc.Store(id=names.CLIP_GAIT_TABLE),  # drawn by assets/clip/gait.mjs
            dcc.Store(id=names.CLIP_GAIT_DRAWN),  # these four only give clientside callbacks an output
            dcc.Store(id=names.CLIP_DRAWN),
            dcc.Store(id=names.CLIP_MARKED),
            dcc.Store(id=names.CLIP_SOUGHT),
            dcc.Store(id=names.CLIP_REPAIR),  # a repair that someone chose beside a doubt
            dcc.Store(id=names.CLIP_SEEK),  # {"clip", "frame"}: someone chose a moment in a list
            *editing.dialogs(),
            *table.dialogs(),
        ],
    )


def _head() -> Component:
    def step(name: str, label: str, symbol: str) -> Component:
        button = dmc.ActionIcon(
            icon(symbol, 18), id=name, variant="default", size=36, disabled=True, **attributes(aria_label=label)
        )
        return html.Span(button, title=label)

    picker = dmc.Select(
        id=names.CLIP_PICKER,
        className="clip-picker",
        placeholder="No clip",
        searchable=True,
        allowDeselect=False,
        limit=200,
        nothingFoundMessage="No clip of this name",
        maxDropdownHeight=320,
        comboboxProps={"shadow": "md"},
        **attributes(aria_label="Clip"),
    )
    walk = [step(names.CLIP_PREVIOUS, "Previous clip", "back"), picker, step(names.CLIP_NEXT, "Next clip", "next")]
    return page_head(
        "Clip",
        html.Div([editing.menu(), table.button()], className="head-menus"),
        beside=[html.Div(walk, className="clip-walk")],
    )


def _choosers() -> Component:
    def segments(name: str, choices: dict[str, str], label: str) -> Component:
        data = [{"value": value, "label": text} for value, text in choices.items()]
        return dmc.SegmentedControl(id=name, data=data, size="xs", **attributes(aria_label=label))

    return html.Div(
        className="clip-choosers",
        children=[
            segments(names.CLIP_CHART, CHARTS, "Chart"),
            html.Div(segments(names.CLIP_KIND, KINDS, "Kind of angles"), id=names.CLIP_KIND_BOX, className="hidden"),
            html.Div(
                dmc.ChipGroup(id=names.CLIP_CHANNELS, multiple=True, children=[], value=[]),
                id=names.CLIP_CHANNELS_BOX,
                className="hidden clip-channels-box",
            ),
            html.Div(
                dmc.MultiSelect(
                    id=names.CLIP_JOINTS,
                    data=[],
                    size="xs",
                    searchable=True,
                    maxValues=8,
                    placeholder="Add a joint",
                    maxDropdownHeight=300,
                    comboboxProps={"shadow": "md"},
                    **attributes(aria_label="Joints"),
                ),
                id=names.CLIP_JOINTS_BOX,
                className="hidden clip-joints-box",
            ),
        ],
    )


def _chart() -> Component:
    overlay = html.Div(
        [
            html.Div(className="clip-band", hidden=True),
            html.Div(className="clip-pointer", hidden=True),
            html.Div(html.Div(className="clip-grip"), className="clip-cursor", hidden=True),
            html.Div(className="clip-dot", hidden=True),
        ],
        className="clip-over",
        **attributes(aria_hidden="true"),
    )
    graph = dcc.Graph(
        id=names.CLIP_GRAPH,
        figure={"data": [], "layout": {"height": 380, "xaxis": {"visible": False}, "yaxis": {"visible": False}}},
        config={"displayModeBar": False, "doubleClick": False, "scrollZoom": False, "responsive": True},
    )
    box = html.Div(
        [graph, overlay],
        id=names.CLIP_BOX,
        className="card clip-box",
        tabIndex="0",
        role="application",
        **attributes(aria_label="Chart of the clip. " + HINT),
    )
    zoom = [
        _zoom("minus", "Zoom out", "out"),
        _zoom("plus", "Zoom in", "in"),
        _zoom("fit", "Show the whole clip", "whole"),
    ]
    return html.Div([box, html.Div([html.Span(HINT, className="clip-hint muted"), *zoom], className="clip-tools")])


def _zoom(symbol: str, label: str, what: str) -> Component:
    return dmc.ActionIcon(
        icon(symbol, 15),
        variant="default",
        size=26,
        attributes={"root": {"title": label, "data-clip-zoom": what}},
        **attributes(aria_label=label),
    )


def nothing(dataset: Dataset | None, clip: str | None) -> Component:
    """The message shown in place of a clip that does not exist."""
    if dataset is None:
        link = dcc.Link("Go to the library", href="/library", className="text-link")
        state = empty_state("person", "No dataset yet", "Add recordings, or make the demo, in the library.", link)
    elif clip:
        hint = f"“{clip[:80]}” is not in {dataset.name}; it may have been removed. Choose another one above."
        first = dmc.Button(f"Show {dataset.names[0]}", variant="light", **sends(SELECTION, {"clip": dataset.names[0]}))
        state = empty_state("warning", "There is no such clip", hint, first)
    else:
        state = empty_state("person", "No clip to show", "This dataset has no clips; add recordings in the library.")
    return html.Div(state, className="card section")


def facts(curves: ClipCurves) -> list[Component]:
    """Length, rate and body of the clip, and remarks of the import."""
    clip = curves.clip
    turning = len(curves.turning_joints)
    facts = [
        f"{clip.seconds:.2f} s",
        f"{clip.n_frames:,} frames",
        f"{clip.fps:g} frames per second",
        f"{turning} joints",
    ]
    parts: list[Component] = [html.Span(" · ".join(facts), className="number")]
    if clip.notes:
        note = clip.notes[0]
        parts.append(html.Span(f" · {note}", className="clip-note", title=" ".join(clip.notes)))
    return parts


def joint_options(curves: ClipCurves, chosen: Choice) -> list[dict[str, str]]:
    """The options of the joint chooser."""
    offered = offered_joints(curves, chosen.chart, chosen.kind)
    if chosen.chart == "angles" and chosen.kind == "file":
        return [{"value": name, "label": curves.clip.skeleton.names[int(name)]} for name in offered]
    words = {TRAVEL: "Travel of the pelvis"}
    return [{"value": name, "label": words.get(name, joint_words(name))} for name in offered]


def channel_chips(chosen: Choice) -> list[Component]:
    """A chip for every angle that the chosen joints have."""
    channels = dict.fromkeys(channel.name for joint in chosen.joints for channel in JOINTS[joint].channels)
    return [dmc.Chip(name.capitalize(), value=name, size="xs", variant="outline") for name in channels]


def legend(panels: Sequence[Panel]) -> list[Component]:
    """A chip for every line, in the order of the traces; assets/clip/cursor.mjs writes the value at the cursor."""
    return [
        html.Div(
            [
                html.Span(
                    className="clip-key",
                    style={
                        "borderTopColor": line.colour,
                        "borderTopStyle": "solid" if line.dash == "solid" else "dashed",
                    },
                ),
                html.Span(line.label, className="clip-key-name"),
                html.Span("", className="clip-value number", **attributes(data_unit=_unit(panel.unit))),
            ],
            className="clip-chip",
            title=f"{line.label}: positive is {line.tip}" if line.tip and panel.unit == "deg" else line.tip,
        )
        for panel in panels
        for line in panel.lines
    ]


def _unit(unit: str) -> str:
    return {"deg": "°"}.get(unit, f" {unit}")


def range_bar(clip: str, fps: float, frames: int, start: int | None, end: int | None) -> list[Component]:
    """The selected range of a clip of so many frames, and buttons for it."""
    first, last = (0, frames) if start is None or end is None else (start, end)
    alike = dmc.Button("More like this", size="compact-sm", variant="default", **similar(clip, first, last))
    if start is None or end is None:
        hint = "No range selected: drag over the chart, and it plays on the Stage."
        return [html.Span(hint, className="muted"), html.Div(className="spacer"), alike]
    seconds = f"{start / fps:.2f} to {end / fps:.2f} s"
    more = f"{(end - start) / fps:.2f} s, frames {start} to {end}"
    whole = sends(SELECTION, {"clip": clip})
    return [
        html.Span(["Selected ", html.B(seconds, className="number")]),
        html.Span(more, className="muted number"),
        html.Div(className="spacer"),
        alike,
        dmc.Button(
            "Zoom in on it", size="compact-sm", variant="default", attributes={"root": {"data-clip-zoom": "range"}}
        ),
        dmc.Button(
            "Make it a clip",
            className="for-editors",
            size="compact-sm",
            variant="default",
            **sends(names.CLIP_EDIT, {"action": "trim"}, every_time=True),
        ),
        dmc.Button("Clear", size="compact-sm", variant="subtle", color="gray", **whole),
    ]
