"""The server holds many connections, and reads no large body from strangers."""

import socket
import threading
import time
from contextlib import ExitStack, contextmanager, suppress

import pytest

from core.workspace import Workspace
from webapp import connections
from webapp.app import create_app
from webapp.connections import ANSWERS, SMALL, connection_limit, make_server
from webapp.shell.access import admits


def application(environment, start_response):
    body = environment["wsgi.input"].read()
    start_response("200 OK", [("Content-Type", "text/plain")])
    return [str(len(body)).encode()]


@contextmanager
def served(admitted, app=application):
    listener = socket.create_server(("127.0.0.1", 0))
    server = make_server(app, listener, admitted, 1 << 30, threads=2)
    thread = threading.Thread(target=server.run, daemon=True)
    thread.start()
    try:
        yield listener.getsockname()
    finally:
        server.close()
        thread.join(20)


def ask(address, head, body=b""):
    """The first line of the answer to a request, whose body may end before it is whole."""
    with socket.create_connection(address, timeout=30) as client:
        with suppress(OSError):  # the answer may come, and the door be closed, while we still send
            client.sendall(head.replace("\n", "\r\n").encode() + b"\r\n\r\n" + body)
        return client.recv(1000).split(b"\r\n")[0].decode()


def test_hundreds_of_idle_and_half_open_connections_lock_nobody_out():
    with served(lambda _: True) as address, ExitStack() as stack:
        for k in range(300):
            client = stack.enter_context(socket.create_connection(address, timeout=30))
            if k % 2:
                client.sendall(b"GET / HTTP/1.1\r\nHost: a")  # and nothing more
        begin = time.monotonic()
        assert ask(address, "GET / HTTP/1.1\nHost: a\nConnection: close") == "HTTP/1.1 200 OK"
        assert time.monotonic() - begin < 20


def test_the_limit_of_connections_fits_what_the_system_allows():
    assert 64 <= connection_limit() <= connections.CONNECTIONS


def head(method, path, length):
    return f"{method} {path} HTTP/1.1\nHost: a\nContent-Length: {length}\nConnection: close"


def test_large_bodies_are_read_only_from_those_who_are_let_in():
    with served(lambda environment: environment.get("HTTP_COOKIE") == "token=mine") as address:
        assert ask(address, head("POST", "/sign-in", 5), b"12345") == "HTTP/1.1 200 OK"
        begin = time.monotonic()
        refused = ask(address, head("PUT", "/api/uploads/a/b.bvh", 300 << 20), b"x" * 1000)
        assert refused == "HTTP/1.1 401 Unauthorized"  # although hardly anything of it was sent
        assert time.monotonic() - begin < 20
        mine = head("PUT", "/api/uploads/a/b.bvh", SMALL + 5) + "\nCookie: token=mine"
        assert ask(address, mine, b"x" * (SMALL + 5)) == "HTTP/1.1 200 OK"
        mine = head("POST", "/_dash-update-component", ANSWERS + 1) + "\nCookie: token=mine"
        assert ask(address, mine).startswith("HTTP/1.1 413")
        chunked = "POST / HTTP/1.1\nHost: a\nTransfer-Encoding: chunked"
        assert ask(address, chunked, b"5\r\n12345\r\n").startswith("HTTP/1.1 411")


@pytest.mark.parametrize(("cookie", "known"), [("", False), ("motionscape-token=mine", True), ("x=\udcff", False)])
def test_who_has_the_token_is_let_in_before_the_body_has_come(tmp_path, cookie, known):
    workspace = Workspace(tmp_path / "space")
    server = create_app(workspace.path, token="mine").server
    environment = {
        "REQUEST_METHOD": "PUT",
        "PATH_INFO": "/api/uploads/a/b.bvh",
        "HTTP_HOST": "a",
        "SERVER_NAME": "a",
        "SERVER_PORT": "80",
        "wsgi.url_scheme": "http",
        "REMOTE_ADDR": "192.0.2.1",
        "HTTP_COOKIE": cookie,
    }
    assert admits(server, workspace, "mine", environment) is known
