"""Access to the app: a token, or a check of the host name, and security headers."""

from __future__ import annotations

import hmac
import ipaddress
import os
import re
from urllib.parse import parse_qsl, urlencode

from flask import Flask, Response, redirect, request
from flask.typing import ResponseReturnValue

from webapp.shell.messages import error_page

HOSTS = "MOTIONSCAPE_HOSTS"
COOKIE = "motionscape-token"
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


def protect(server: Flask, token: str | None) -> None:
    """Sends security headers with every answer and, with a ``token``, admits only browsers that have it.

    The token comes once as ``?token=...``, becomes a cookie, and is taken out of the address. Without a token only
    requests to this machine's own names, or to one of MOTIONSCAPE_HOSTS, are answered: another site may point its name
    at this machine (DNS rebinding), and the Host header tells which name the browser used.
    """

    @server.after_request
    def _headers(response: Response) -> Response:
        response.headers.setdefault("Content-Security-Policy", _POLICY)
        response.headers.setdefault("X-Content-Type-Options", "nosniff")
        response.headers.setdefault("Referrer-Policy", "same-origin")
        response.headers.setdefault("Cross-Origin-Resource-Policy", "same-origin")
        return response

    hosts = known_hosts()

    @server.before_request
    def _check() -> ResponseReturnValue | None:
        return _let_in(token) if token else _check_host(hosts)


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


def _let_in(token: str) -> ResponseReturnValue | None:
    offered = request.args.get("token")
    if offered is not None and _same(offered, token):
        rest = [(k, v) for k, v in parse_qsl(request.query_string.decode("utf-8", "replace")) if k != "token"]
        response = redirect(request.path + (f"?{urlencode(rest)}" if rest else ""))
        response.set_cookie(COOKIE, token, httponly=True, samesite="Strict", secure=request.is_secure)
        return response
    if _same(request.cookies.get(COOKIE, ""), token):
        return None
    return error_page(
        401,
        "This workspace asks for a token",
        "Open the link that was printed when the server was started; it ends in ?token=… and is needed only once.",
    )


def _same(offered: str, token: str) -> bool:
    return hmac.compare_digest(offered.encode(), token.encode())
