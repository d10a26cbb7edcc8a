"""Access to the app: who is let in and what they may ask for; a check of the host name, and security headers."""

from __future__ import annotations

import ipaddress
import os
import re
from collections.abc import Callable
from typing import Any
from urllib.parse import parse_qsl, quote, urlencode

from flask import Flask, Response, g, jsonify, redirect, request
from flask.typing import ResponseReturnValue

from core.workspace import Person, Workspace, WorkspaceError
from core.workspace.people import OWNER, refusal, start_acting
from webapp.shell import rights, sessions, sign_in, visitors
from webapp.shell.callback_requests import sent_json
from webapp.shell.messages import error_page
from webapp.shell.origin import is_encrypted, is_foreign

HOSTS = "MOTIONSCAPE_HOSTS"
_POLICY = (
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self'; worker-src 'self' blob:; "
    "object-src 'none'; base-uri 'self'; form-action 'self'; frame-ancestors 'none'"
)


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach ``host``."""
    try:
        return ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return host.lower() == "localhost"


NOBODY = Person(only=frozenset(), role="viewer")


def protect(server: Flask, workspace: Workspace, token: str | None, mark: Callable[[], str | None]) -> None:
    """Sends security headers with every answer and lets in whom the workspace knows, for what they may ask.

    token: opens the whole app, as ``?token=...``, which becomes a cookie and is taken out of the address. Without a
    token and without accounts everyone on this machine is let in, but only under this machine's own names or one of
    MOTIONSCAPE_HOSTS: another site may point its name at this machine (DNS rebinding), and the Host header tells which
    name the browser used. mark: what the current request does (see :mod:`webapp.shell.rights`), None where unknown.
    """
    sessions.register(server, workspace)
    hosts = known_hosts()

    @server.after_request
    def _headers(response: Response) -> Response:
        response.headers.setdefault("Content-Security-Policy", _POLICY)
        response.headers.setdefault("X-Content-Type-Options", "nosniff")
        response.headers.setdefault("Referrer-Policy", "same-origin")
        response.headers.setdefault("Cross-Origin-Resource-Policy", "same-origin")
        return response

    @server.before_request
    def _check() -> ResponseReturnValue | None:
        start_acting(OWNER)  # until it is known who it is
        if not token and not visitors.accounts_exist(workspace) and (unknown := _check_host(hosts)):
            return unknown
        if is_foreign(hosts):
            return _refuse(403, "This request comes from another site", "Nothing was changed.")
        if answer := _take_token(token) or _take_key(workspace):
            return answer
        return _let_in(workspace, token, mark())

    @server.teardown_request
    def _nobody_acts(_: BaseException | None) -> None:
        start_acting(OWNER)

    sign_in.register(server, workspace)


def admits(server: Flask, workspace: Workspace, token: str | None, environment: dict[str, Any]) -> bool:
    """Whether the sender of a request is known, before its body has been read."""
    with server.request_context(environment):
        try:
            return visitors.visitor(workspace, token, active=False) is not None
        except WorkspaceError:
            return False


def known_hosts() -> frozenset[str]:
    """The names in MOTIONSCAPE_HOSTS, in lower case and without ports."""
    return frozenset(filter(None, map(host_name, os.environ.get(HOSTS, "").split(","))))


def host_name(address: str) -> str:
    """The name in ``name[:port]``, in lower case and without brackets; empty where it is not of this form."""
    parts = re.fullmatch(r"(?:\[([0-9a-f:.]+)\]|([^\s:@/\[\]]+))(?::\d*)?", address.strip().lower())
    return (parts[1] or parts[2]).rstrip(".") if parts else ""


def _check_host(hosts: frozenset[str]) -> tuple[str, int] | None:
    name = host_name(request.environ.get("HTTP_HOST", ""))
    if name and (is_loopback(name) or name in hosts):
        return None
    return error_page(
        403,
        "This address is not known here",
        "Open Motionscape under the address that was printed when the server was started. "
        f"Whoever runs it behind another name can allow that name with {HOSTS}.",
    )


def _take_token(token: str | None) -> ResponseReturnValue | None:
    offered = request.args.get("token")
    if not token or offered is None or not visitors.same(offered, token):
        return None
    return _kept("token", visitors.TOKEN_COOKIE, token, "Strict")


def _take_key(workspace: Workspace) -> ResponseReturnValue | None:
    """The key in the link of a board becomes a cookie."""
    key = request.args.get("key", "")
    if request.method != "GET" or request.path.startswith(("/api/", "/_")):
        return None
    if not visitors.boards_of_keys(workspace, [key]):
        return None
    keys = dict.fromkeys([key, *visitors.kept_keys()])
    return _kept("key", visitors.BOARDS_COOKIE, " ".join(list(keys)[: visitors.MOST_KEYS]).strip(), "Lax")


def _kept(name: str, cookie: str, value: str, samesite: str) -> ResponseReturnValue:
    """The same address without the part ``name`` of its query, which the browser keeps as a cookie."""
    rest = [(k, v) for k, v in parse_qsl(request.query_string.decode("utf-8", "replace")) if k != name]
    response = redirect(request.path + (f"?{urlencode(rest)}" if rest else ""))
    response.set_cookie(cookie, value, httponly=True, samesite=samesite, secure=is_encrypted())
    return response


def _let_in(workspace: Workspace, token: str | None, mark: str | None) -> ResponseReturnValue | None:
    try:
        person = visitors.visitor(workspace, token, active=_is_active())
    except visitors.UnknownUser as error:
        return _refuse(403, "You have no account here", f"{error} An owner can add one: motionscape user add.")
    g.person = person or NOBODY
    start_acting(g.person)
    if person is None:
        return None if mark == rights.OPEN else _ask_who(workspace, token)
    reason = refused(person, mark)
    return _refuse(403, "You may not do this", reason) if reason else None


def refused(person: Person, mark: str | None) -> str | None:
    """Why someone may not ask for what is marked so (None: it has no mark), as a sentence; None where they may."""
    if mark in (rights.READS, rights.ASKS, rights.OPEN) or (mark == rights.BOARDS and person.boards):
        return None
    if mark == rights.MANAGES:
        return None if person.may("owner") else refusal(person, "owner", "do this")
    return None if person.may_change_something() else refusal(person, "editor", "change this")


def _is_active() -> bool:
    """Whether someone does something, rather than a page that is open asking for news."""
    if request.method in ("GET", "HEAD"):
        return not request.path.startswith(("/api/", "/_", "/assets/"))
    if request.path.endswith("/_dash-update-component"):
        body = sent_json()
        changed = body.get("changedPropIds") if isinstance(body, dict) else None
        return not (isinstance(changed, list) and all(str(name).endswith(".n_intervals") for name in changed))
    return True


def _ask_who(workspace: Workspace, token: str | None) -> ResponseReturnValue:
    """What someone is told whom nobody knows: to sign in, or to open the link with the token."""
    if request.method == "GET" and "key" in request.args and not request.path.startswith(("/api/", "/_")):
        text = "It may have been deleted, or its links renewed. Ask for a new link"
        return _refuse(403, "This link opens no board", f"{text}, or open the app as usual if you have an account.")
    if visitors.accounts_exist(workspace):
        if request.method == "GET" and not request.path.startswith(("/api/", "/_", "/assets/")):
            address = request.full_path if request.query_string else request.path
            return redirect(f"{sign_in.ADDRESS}?next={quote(address, safe='/')}")
        if any(visitors.kept_keys()):
            return _refuse(401, "The link has ended", "The link by which you came opens the board no more.")
        return _refuse(401, "Nobody is signed in", "Your session has ended, or you have not signed in yet.")
    return _refuse(
        401,
        "This workspace asks for a token",
        "Open the link that was printed when the server was started; it ends in ?token=… and is needed only once.",
    )


def _refuse(status: int, title: str, text: str) -> ResponseReturnValue:
    """A refusal as JSON for the app's own requests, else as a page."""
    if request.path.startswith(("/api/", "/_")):
        return jsonify(error=text, title=title), status
    return error_page(status, title, text)
