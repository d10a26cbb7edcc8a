"""The Stage as a Dash layout: a canvas and its controls. The modules of ``assets/stage`` run it.

Views hand it segments by writing ``dcc.Store("stage-request")``. What a request holds, and what the Stage offers in
the browser (assets/stage/player.mjs, the events ``stage-state`` and ``stage-frame``), is in docs/reference/stage.md.
"""

from __future__ import annotations

from dash import ClientsideFunction, Dash, Input, Output, dcc, html
from dash.development.base_component import Component

from webapp.shell.attributes import attributes
from webapp.shell.names import STAGE_REQUEST
from webapp.stage import names

KEYS = (
    ("Space", "play, pause"),
    ("← →", "one frame back, forward"),
    ("Page ↑ ↓", "ten frames forward, back"),
    ("Home End", "first, last frame"),
    ("+ − 0", "faster, slower, normal"),
    ("L", "repeat, back and forth, once"),
    ("G T", "ghosts, trails"),
    ("F R", "follow, reset the view"),
    ("1 2 3", "overlay, side by side, stills"),
    ("S", "in step, own pace"),
    ("Shift + arrows", "turn the view"),
    ("↑ ↓", "zoom"),
)
MOUSE = "Drag to turn, Shift + drag to shift, wheel to zoom, double click to reset."


def stage(api: str = "/api") -> html.Div:
    """The Stage, once in a page, with the id ``stage``. ``api``: address of the motion routes."""
    return html.Div(
        [
            dcc.Store(id=STAGE_REQUEST),
            dcc.Store(id=names.STAGE_SHOWN),
            html.Div(
                [
                    html.Div(className="ms-stage-title"),
                    html.Div(className="ms-figures", role="group", **attributes(aria_label="Figures")),
                ],
                className="ms-stage-head",
            ),
            _view(),
            html.Div(
                [
                    html.Div(
                        [html.Div(className="ms-band-rows"), html.Div(className="ms-band-cursor")],
                        className="ms-bands",
                        hidden=True,
                        **attributes(aria_hidden="true"),
                    ),
                    html.Div(
                        html.Div([html.Canvas(), html.Div(className="ms-warp-cursor")], className="ms-warp-rows"),
                        className="ms-warp",
                        hidden=True,
                        **attributes(aria_hidden="true"),
                    ),
                    _scrub_bar(),
                    _toolbar(),
                ],
                className="ms-controls",
            ),
        ],
        id=names.STAGE,
        className="ms-stage",
        role="region",
        **attributes(aria_label="Stage", data_api=api, data_status="empty"),
    )


def register(app: Dash) -> None:
    """Lets the Stage play what is written into its request store."""
    app.clientside_callback(
        ClientsideFunction("stage", "show"),
        Output(names.STAGE_SHOWN, "data"),
        Input(STAGE_REQUEST, "data"),
    )


def _view() -> html.Div:
    return html.Div(
        [
            html.Canvas(
                id=names.STAGE_CANVAS, role="img", tabIndex="0", **attributes(aria_label="Stage for moving figures")
            ),
            html.Div(
                [
                    html.Div(className="ms-message-figure", **attributes(aria_hidden="true")),
                    html.Div("Nothing on stage yet", className="ms-message-title"),
                    html.Div("Choose a clip, a motif or a motion, and it plays here.", className="ms-message-hint"),
                    html.Div(className="ms-message-text", role="status"),
                    html.Button("Try again", type="button", className="ms-retry", **attributes(data_action="retry")),
                ],
                className="ms-message",
            ),
            html.Div(
                [html.Span(), html.Button("Try again", type="button", **attributes(data_action="retry"))],
                className="ms-stage-note",
                role="status",
                hidden=True,
            ),
            html.Div(className="ms-toast", role="status"),
            html.Div([*_help(), html.P(MOUSE)], className="ms-help", hidden=True, role="note"),
        ],
        className="ms-stage-view",
    )


def _help() -> list[html.Dl]:
    return [html.Dl([part for keys, what in KEYS for part in (html.Dt(keys), html.Dd(what))])]


def _scrub_bar() -> html.Div:
    return html.Div(
        [html.Div(className="ms-scrub-track"), html.Div(className="ms-scrub-thumb")],
        className="ms-scrub",
        role="slider",
        tabIndex="0",
        **attributes(aria_label="Time in seconds", aria_valuemin="0", aria_valuemax="0", aria_valuenow="0"),
    )


def _tool(action: str, label: str, key: str = "", pressed: bool | None = None) -> html.Button:
    tip = f"{label}  ·  {key}" if key else label
    state = {} if pressed is None else attributes(aria_pressed=str(pressed).lower())
    data = attributes(data_action=action, data_icon=action, data_key=key, data_tip=tip)
    return html.Button(type="button", className="ms-tool", **data, **attributes(aria_label=label), **state)


def _group(*children: Component, label: str, name: str = "") -> html.Div:
    return html.Div(list(children), className=f"ms-group {name}".strip(), role="group", **attributes(aria_label=label))


def _toolbar() -> html.Div:
    speed = html.Button(
        "1×", type="button", className="ms-speed", **attributes(data_action="speed", data_tip="Normal speed  ·  0")
    )
    return html.Div(
        [
            _group(
                _tool("back", "One frame back", "←"),
                _tool("play", "Play", "Space"),
                _tool("forward", "One frame forward", "→"),
                _tool("loop", "Repeat", "L"),
                label="Playing",
            ),
            _group(_tool("slower", "Slower", "−"), speed, _tool("faster", "Faster", "+"), label="Speed"),
            html.Div(className="ms-readout"),
            _group(
                _tool("overlay", "Overlay", "1", True),
                _tool("side", "Side by side", "2", False),
                _tool("pose", "Stills in rows", "3", False),
                _tool("warp", "In step", "S", False),
                label="Arrangement",
                name="ms-arrangement",
            ),
            _group(
                _tool("ghosts", "Ghosts", "G", False),
                _tool("trails", "Trails off", "T", False),
                _tool("follow", "Camera follows", "F", True),
                _tool("reset", "Reset the view", "R"),
                _tool("help", "Keys", "?"),
                label="View",
            ),
        ],
        className="ms-toolbar",
        role="toolbar",
        **attributes(aria_label="Stage controls"),
    )
