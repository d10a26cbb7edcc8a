"""What people see when something is missing or goes wrong: plain words, never internals."""

from __future__ import annotations

from html import escape

import dash_mantine_components as dmc
from dash import dcc, html, set_props
from dash.development.base_component import Component
from flask import Flask, request
from flask.typing import ResponseReturnValue
from werkzeug.exceptions import HTTPException

from core.errors import MotionscapeError
from webapp.shell.callback_requests import misfit, refusal
from webapp.shell.errors import log_bug, sentence
from webapp.shell.icons import icon
from webapp.shell.names import NOTICES

_PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Motionscape</title>
<meta name="viewport" content="width=device-width"><style>
:root{{color-scheme:light dark}}body{{font:16px/1.5 system-ui,sans-serif;margin:18vh auto;
max-width:32rem;padding:0 1.5rem}}
h1{{font-size:1.35rem}}a{{color:inherit}}</style></head><body><h1>{title}</h1><p>{text}</p>{back}</body></html>"""


def error_page(status: int, title: str, text: str) -> tuple[str, int]:
    """A small page of its own for answers outside the app."""
    back = "" if status == 401 else '<p><a href="/library">Back to the library</a></p>'
    return _PAGE.format(title=escape(title), text=escape(text), back=back), status


def register(server: Flask) -> None:
    """Error pages without internals for the Flask routes; details go to the log."""

    @server.errorhandler(HTTPException)
    def _known(error: HTTPException) -> tuple[str, int]:
        return error_page(error.code or 500, error.name, "The server could not answer this request.")

    @server.errorhandler(MotionscapeError)
    def _cannot(error: MotionscapeError) -> tuple[str, int]:
        return error_page(400, "That cannot be done", sentence(error))

    @server.errorhandler(Exception)
    def _bug(error: Exception) -> ResponseReturnValue:
        if reason := misfit():
            return refusal(reason)
        details = f"The details are in the server's log, as error {log_bug(request.path, error)}."
        return error_page(500, "Something went wrong", f"It is our fault, not yours. {details}")


def on_callback_error(error: Exception) -> None:
    """Dash's handler: the view stays as it was and a notice says why; a bug goes to the log."""
    if isinstance(error, MotionscapeError):
        message = notice("That cannot be done", sentence(error), "red")
    else:
        details = f"Details are in the server's log, as error {log_bug('a callback', error)}."
        message = notice("Something went wrong", f"The view stays as it was. {details}", "red", id="fault")
    set_props(NOTICES, {"sendNotifications": [message]})


def notice(title: str, message: str | Component, colour: str = "accent", **more: object) -> dict:
    """A notification for ``dmc.NotificationContainer.sendNotifications``."""
    return {"action": "show", "title": title, "message": message, "color": colour, **more}


def empty_state(symbol: str, title: str, hint: str, *actions: Component) -> Component:
    """Shown in place of a result that does not exist yet: what is missing, and what to do."""
    return html.Div(
        className="empty-state",
        children=[
            html.Div(icon(symbol, 34), className="empty-icon"),
            dmc.Title(title, order=2, size="h4"),
            dmc.Text(hint, c="dimmed", size="sm", maw=440),
            dmc.Group(list(actions), mt="sm", justify="center") if actions else None,
        ],
    )


def unknown_page() -> Component:
    """The page for a URL that names no page."""
    link = dcc.Link("Go to the library", href="/library", className="text-link")
    return empty_state("compass", "There is no such page", "The link may be old or mistyped.", link)
