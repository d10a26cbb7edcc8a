"""The sign-in page: a plain form that works before anything of the app has loaded."""

from __future__ import annotations

from html import escape
from math import ceil

from flask import Flask, Response, jsonify, make_response, redirect, request, session
from flask.typing import ResponseReturnValue

from core.workspace import Workspace, WorkspaceError, acting
from core.workspace.views import check_address
from webapp.shell import sessions
from webapp.shell.origin import client_address
from webapp.shell.visitors import BOARDS_COOKIE, TOKEN_COOKIE, accounts_exist, current

ADDRESS, SIGN_OUT = "/sign-in", "/sign-out"
_PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Sign in – Motionscape</title>
<meta name="viewport" content="width=device-width"><style>
:root{{color-scheme:light dark;--paper:light-dark(#f4f6f8,#12161c);--card:light-dark(#fff,#1a2029);
--ink:light-dark(#1f2733,#e7ebf1);--line:light-dark(#dfe4ea,#2f3846);--accent:light-dark(#2f62b8,#8fb3f3);
--on-accent:light-dark(#fff,#10203c);--wrong:light-dark(#b3332f,#f19a94)}}
:root[data-theme=light]{{color-scheme:light}}:root[data-theme=dark]{{color-scheme:dark}}
body{{font:16px/1.5 system-ui,sans-serif;margin:0;min-height:100vh;display:grid;place-items:center;
background:var(--paper);color:var(--ink)}}
form{{width:min(22rem,calc(100vw - 3rem));padding:2rem;background:var(--card);border:1px solid var(--line);
border-radius:8px;box-sizing:border-box}}
h1{{font-size:1.35rem;margin:0 0 1.25rem}}label{{display:block;margin:0 0 1rem;font-size:.9rem}}
input,button{{font:inherit;width:100%;box-sizing:border-box;padding:.55rem .7rem;border-radius:6px}}
input{{margin-top:.3rem;border:1px solid var(--line);background:var(--paper);color:inherit}}
button{{border:0;background:var(--accent);color:var(--on-accent);font-weight:600;cursor:pointer}}
input:focus-visible,button:focus-visible{{outline:2px solid var(--accent);outline-offset:2px}}
[role=alert]{{color:var(--wrong);margin:0 0 1rem}}</style>
<script>const theme = localStorage.getItem("mantine-color-scheme-value");
if (theme === "light" || theme === "dark") document.documentElement.dataset.theme = theme;</script>
</head><body><main><form method="post" action="{action}"><h1>Sign in to Motionscape</h1>{problem}
<input type="hidden" name="next" value="{next}">
<label>Name<input name="name" value="{name}" autocomplete="username" autocapitalize="none" required autofocus></label>
<label>Password<input name="password" type="password" autocomplete="current-password" required></label>
<button>Sign in</button></form></main></body></html>"""


def register(server: Flask, workspace: Workspace) -> None:
    """Adds the pages to sign in and out, and the route that says who one is."""
    tries = sessions.Tries()

    @server.get(ADDRESS)
    def show_sign_in() -> ResponseReturnValue:
        if not accounts_exist(workspace):
            return redirect("/")
        return _page()

    @server.post(ADDRESS)
    def take_sign_in() -> ResponseReturnValue:
        name, password = request.form.get("name", "").strip()[:100], request.form.get("password", "")
        address = client_address()
        seconds = tries.wait(name, address)
        if seconds:
            answer = _page(f"Too many wrong tries. Wait {ceil(seconds / 60)} min and try again.", 429)
            answer.headers["Retry-After"] = str(ceil(seconds))
            return answer
        tries.failed(name, address)  # first, so that tries at the same time count too
        found = workspace.users.sign_in(name, password)
        if found is None:
            workspace.audit.record("sign-in refused", name, address)
            return _page("Name and password do not fit.", 401)
        tries.succeeded(name, address)
        sessions.begin(*found)
        workspace.audit.record("signed in", found[0].name, address)
        return redirect(_next(), 303)

    @server.post(SIGN_OUT)
    def sign_out() -> ResponseReturnValue:
        session.clear()
        answer = redirect(ADDRESS if accounts_exist(workspace) else "/", 303)
        for cookie in (TOKEN_COOKIE, BOARDS_COOKIE):
            answer.delete_cookie(cookie)
        return answer

    @server.get("/api/me")
    def who_am_i() -> Response:
        person = current()
        roles = {info.name: person.roles[info.id] for info in workspace.datasets() if info.id in person.roles}
        return jsonify(name=acting().name, role=person.role, roles=roles, guest=person.is_guest)


def _page(problem: str = "", status: int = 200) -> Response:
    alert = f'<p role="alert">{escape(problem)}</p>' if problem else ""
    name = request.form.get("name", "")[:100]
    text = _PAGE.format(action=ADDRESS, problem=alert, next=escape(_next(), quote=True), name=escape(name, quote=True))
    answer = make_response(text, status)
    answer.headers["Cache-Control"] = "no-store"
    return answer


def _next() -> str:
    """Where to go after signing in: an address of this app."""
    try:
        return check_address(request.values.get("next", "/"))
    except WorkspaceError:
        return "/"
