"""Sessions in signed cookies, and the limit on tries to sign in."""

from __future__ import annotations

import os
import threading
import time
from collections import deque
from datetime import timedelta

from flask import Flask, session
from flask.sessions import SecureCookieSessionInterface

from core.workspace import Person, Workspace
from webapp.shell.origin import is_encrypted

COOKIE = "motionscape-session"
IDLE, ABSOLUTE = "MOTIONSCAPE_SESSION_IDLE_HOURS", "MOTIONSCAPE_SESSION_HOURS"
SEEN_EVERY = 60.0  # seconds after which a session notes again that someone is there
TRIES, TRIES_OF_ADDRESS, WINDOW = 5, 30, 300.0  # wrong passwords for one account, from one address; seconds


class _Sessions(SecureCookieSessionInterface):
    def get_cookie_secure(self, app: Flask) -> bool:
        """Browsers send the cookie back over encrypted connections only, where it came over one."""
        return is_encrypted()


def register(server: Flask, workspace: Workspace) -> None:
    """Lets ``server`` keep sessions that are signed with the workspace's secret, and so survive a restart."""
    server.secret_key = workspace.users.secret()
    server.session_interface = _Sessions()
    server.config.update(
        SESSION_COOKIE_NAME=COOKIE,
        SESSION_COOKIE_HTTPONLY=True,
        SESSION_COOKIE_SAMESITE="Lax",
        SESSION_REFRESH_EACH_REQUEST=False,
        PERMANENT_SESSION_LIFETIME=timedelta(hours=_hours(ABSOLUTE, 168.0)),
    )


def begin(person: Person, number: int) -> None:
    """Begins the session of someone who has signed in; number: of the sessions of this account (see ``Users``)."""
    now = time.time()
    session.clear()
    session.permanent = True
    session.update(name=person.name, number=number, since=now, seen=now)


def person_of_session(workspace: Workspace, active: bool) -> Person | None:
    """Who is signed in, None where nobody is or the session has expired; active: whether a person did something."""
    now = time.time()
    try:
        name, number = str(session["name"]), int(session["number"])
        since, seen = float(session["since"]), float(session["seen"])
    except (KeyError, TypeError, ValueError):
        return None
    if now - seen > 3600 * _hours(IDLE, 12.0) or now - since > 3600 * _hours(ABSOLUTE, 168.0):
        return None
    person = workspace.users.person(name, number)
    if person and active and now - seen > SEEN_EVERY:
        session["seen"] = now
    return person


class Tries:
    """Wrong passwords of the last minutes, by account and address."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._failed: dict[tuple[str, ...], deque[float]] = {}

    def wait(self, name: str, address: str) -> float:
        """Seconds until this account may be tried again from this address; 0 where it may be tried now."""
        now = time.monotonic()
        with self._lock:
            limits = {(name.lower(), address): TRIES, (address,): TRIES_OF_ADDRESS}
            return max(self._wait(key, most, now) for key, most in limits.items())

    def failed(self, name: str, address: str) -> None:
        """Notes a try, until :meth:`succeeded` says that it was right."""
        now = time.monotonic()
        with self._lock:
            self._failed = {key: times for key, times in self._failed.items() if now - times[-1] < WINDOW}
            for key in ((name.lower(), address), (address,)):
                self._failed.setdefault(key, deque(maxlen=TRIES_OF_ADDRESS)).append(now)

    def succeeded(self, name: str, address: str) -> None:
        """The right password clears the account's tries from this address, and does not count for the address."""
        with self._lock:
            self._failed.pop((name.lower(), address), None)
            if times := self._failed.get((address,)):
                times.pop()
            if not times:
                self._failed.pop((address,), None)

    def _wait(self, key: tuple[str, ...], most: int, now: float) -> float:
        times = self._failed.get(key, ())
        recent = [when for when in times if now - when < WINDOW]
        return WINDOW - (now - recent[-most]) if len(recent) >= most else 0.0


def _hours(name: str, default: float) -> float:
    try:
        hours = float(os.environ.get(name, default))
    except ValueError:
        return default
    return hours if 0 < hours < 24 * 366 else default
