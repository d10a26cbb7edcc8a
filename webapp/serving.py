"""The command ``serve``: the app on a threaded server, safe by default."""

from __future__ import annotations

import errno
import os
import secrets
import socket
import sys
import threading
import webbrowser
from argparse import Namespace
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING
from urllib.parse import urlencode

from core.workspace import Workspace, WorkspaceError, shared_workspace
from webapp.shell.access import is_loopback
from webapp.shell.warming import after_first_page

if TYPE_CHECKING:
    from webapp.shell.loading import LoadingDash

TOKEN = "MOTIONSCAPE_TOKEN"


def serve(arguments: Namespace) -> int:
    """Shows a workspace in the browser until interrupted. Raises WorkspaceError (folder, port or address unusable)."""
    workspace = shared_workspace(arguments.workspace)
    token = token_for(arguments.host)
    server = listen(arguments.host, arguments.port)  # before anything slow, so that a port in use is reported early
    try:
        return _serve(workspace, arguments, token, server)
    finally:
        server.close()


def token_for(host: str) -> str | None:
    """The token that visitors need: none on this machine; elsewhere MOTIONSCAPE_TOKEN, or a new one."""
    return os.environ.get(TOKEN) or (None if is_loopback(host) else secrets.token_urlsafe(18))


def listen(host: str, port: int) -> socket.socket:
    """A listening socket (port 0: any free one); raises WorkspaceError in plain words."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host.strip("[]"), port, type=socket.SOCK_STREAM)[0]
    except (socket.gaierror, UnicodeError) as error:
        raise WorkspaceError(f"{host!r} is no address of this machine.") from error
    listener = socket.socket(family, kind, protocol)
    try:
        if os.name == "posix":  # a port that was just left may be used again at once
            listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        listener.bind(address)
        listener.listen(128)
    except OSError as error:
        listener.close()
        reasons = {
            errno.EADDRINUSE: f"Port {port} is in use, perhaps by another Motionscape; choose another with --port.",
            errno.EACCES: f"Port {port} may not be used without administrator's rights; choose one above 1023.",
            errno.EADDRNOTAVAIL: f"{host!r} is no address of this machine.",
        }
        raise WorkspaceError(reasons.get(error.errno or 0, f"Cannot listen on {host}:{port}: {error}.")) from error
    return listener


def prepare_demo(workspace: Workspace) -> None:
    """Asks for the demo data set and what pages show of it as jobs like any others, unless they are there."""
    from core.analyses import DEMO, Request, missing
    from webapp.jobs import start

    if DEMO not in {info.name for info in workspace.datasets()}:
        start(workspace, Request(DEMO, "demo"))
    else:
        for request in missing(workspace, DEMO):
            start(workspace, request)


def _serve(workspace: Workspace, arguments: Namespace, token: str | None, listener: socket.socket) -> int:
    from webapp.connections import make_server
    from webapp.jobs import ensure_worker, get_ready, resume
    from webapp.shell.access import admits
    from webapp.shell.uploads import Limits
    from webapp.shell.visitors import accounts_exist

    get_ready(workspace)
    if arguments.demo:
        prepare_demo(workspace)  # its worker starts while the app is being built
    resume(workspace)  # jobs that were broken off, as by a restart of the machine
    ensure_worker(workspace)  # jobs that were waiting when the last server ended
    app = _app(workspace, token)
    after_first_page(app.server, lambda: _first_visits(app, workspace))
    port = listener.getsockname()[1]
    by_link = token and (os.environ.get(TOKEN) or not accounts_exist(workspace))
    url = f"http://{_shown(arguments.host)}:{port}/" + (f"?token={token}" if by_link else "")
    print(f"Motionscape shows {workspace.path} at\n  {url}\nCtrl+C stops it.", flush=True)
    if token and not is_loopback(arguments.host):
        who = (
            "Whoever has this link can see and change the workspace"
            if by_link
            else "People sign in with their accounts"
        )
        print(f"{who}; traffic is not encrypted.", flush=True)
    if not arguments.no_browser and _has_display():
        threading.Timer(0.3, webbrowser.open, [url]).start()
    known = partial(admits, app.server, workspace, token)
    make_server(app.server, listener, known, Limits.from_environment().file_bytes).run()
    raise KeyboardInterrupt  # the server returns only then


def _first_visits(app: LoadingDash, workspace: Workspace) -> dict[str, Callable[[], object]]:
    """What the first visit of each page reads and compiles, for the dataset that the bare address shows."""
    from core.compiled import warm_up
    from webapp.shell import settings
    from webapp.shell.feature import features
    from webapp.shell.names import MethodNames
    from webapp.ui.parameter_form import parameter_form

    steps: dict[str, Callable[[], object]] = {"compiled functions": warm_up}
    for name in settings.methods():
        steps[f"form of {name}"] = partial(parameter_form, settings.parameters(name), {}, MethodNames(name).control)
    if known := workspace.datasets():
        search = "?" + urlencode({"dataset": known[0].name})
        steps |= {
            f"page {feature.path}": partial(app.first_values, f"/{feature.path}", search) for feature in features()
        }
    return steps


def _app(workspace: Workspace, token: str | None) -> LoadingDash:
    from webapp.app import create_app

    return create_app(workspace.path, token=token)


def _shown(host: str) -> str:
    """``host`` as a browser on this machine can open it."""
    if host in ("0.0.0.0", "::"):
        return socket.gethostname()
    return f"[{host}]" if ":" in host and not host.startswith("[") else host


def _has_display() -> bool:
    if sys.platform in ("darwin", "win32"):
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
