"""The HTTP server: how many connections it holds, and which bodies of requests it takes at all.

A browser keeps up to six connections open for each tab, and idle ones cost little, so there may be thousands. Bodies
are judged by the head of the request, before anything of them is kept: small ones are read, large ones only from those
who are let in, and very large ones only where files are uploaded.
"""

from __future__ import annotations

import socket
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from waitress import create_server
from waitress.channel import HTTPChannel
from waitress.parser import HTTPRequestParser
from waitress.server import TcpWSGIServer
from waitress.task import WSGITask
from waitress.utilities import Error, RequestEntityTooLarge

THREADS = 12
CONNECTIONS = 4000
IDLE = 60  # seconds until an idle connection is closed
SMALL = 1 << 20  # bytes of a body that anyone may send: someone who signs in, a page that does not know its end yet
ANSWERS = 64 << 20  # bytes of a body that is no file: what callbacks are given
UPLOADS = "/api/uploads/"
_FILES_LEFT = 256  # file descriptors for everything but connections

Admits = Callable[[dict[str, Any]], bool]


class Unauthorised(Error):
    """Nobody whom the workspace knows has sent this."""

    code = 401
    reason = "Unauthorized"


class LengthRequired(Error):
    """The request does not say how long its body is."""

    code = 411
    reason = "Length Required"


def make_server(
    application: Any, listener: socket.socket, admits: Admits, file_bytes: int, threads: int = THREADS
) -> TcpWSGIServer:
    """A server for a WSGI application on a listening socket; ``run()`` serves until interrupted.

    admits: whether the sender of a request with this WSGI environment is let in. file_bytes: the largest upload.
    """
    server: TcpWSGIServer = create_server(
        application,
        sockets=[listener],
        threads=threads,
        connection_limit=connection_limit(),
        asyncore_use_poll=True,  # select() takes no descriptor above 1023
        channel_timeout=IDLE,
        cleanup_interval=10,
        max_request_body_size=file_bytes + SMALL,
        ident="motionscape",
        clear_untrusted_proxy_headers=False,  # webapp/shell/origin.py knows which proxies to believe
    )

    class Channel(_Channel):
        """A connection of this server."""

        admitted = staticmethod(admits)

    server.channel_class = Channel
    return server


def connection_limit() -> int:
    """How many connections may be open: CONNECTIONS, or what the system lets this process have (and it is asked)."""
    try:
        import resource
    except ImportError:  # Windows
        return CONNECTIONS
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = CONNECTIONS + _FILES_LEFT
    if soft != resource.RLIM_INFINITY and soft < wanted:
        soft = wanted if hard == resource.RLIM_INFINITY else min(wanted, hard)
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
        soft = resource.getrlimit(resource.RLIMIT_NOFILE)[0]
    return CONNECTIONS if soft == resource.RLIM_INFINITY else max(64, min(CONNECTIONS, soft - _FILES_LEFT))


class _Channel(HTTPChannel):
    """A connection whose requests are judged when their heads have arrived."""

    admitted: Admits

    def parser_class(self, adjustments: Any) -> HTTPRequestParser:
        """What reads one request of this connection."""
        return _Parser(adjustments, self)


class _Parser(HTTPRequestParser):
    completed: bool
    error: Error | None

    def __init__(self, adjustments: Any, channel: _Channel):
        super().__init__(adjustments)
        self._channel = channel

    def received(self, data: bytes) -> int:
        """Reads on; a body that is not wanted is not read."""
        in_head = not self.headers_finished
        consumed: int = super().received(data)
        if in_head and self.headers_finished and not self.completed and (error := self._refusal()):
            self.error, self.completed, self.expect_continue = error, True, False
        return consumed

    def _refusal(self) -> Error | None:
        if self.chunked:
            return LengthRequired("Say how long the body is (Content-Length).")
        if self.content_length <= SMALL:
            return None
        if self.content_length > ANSWERS and UPLOADS not in self.path:
            return RequestEntityTooLarge("Only uploads of files may be this large.")
        environment = WSGITask(self._channel, self).get_environment()
        return None if self._channel.admitted(environment) else Unauthorised("Open Motionscape and sign in first.")
