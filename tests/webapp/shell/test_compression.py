"""What leaves the server is compressed where that pays, and kept by browsers where its address names its content."""

import gzip
import os

import brotli
import pytest

from webapp.app import create_app
from webapp.shell.compression import FOR_GOOD, LEAST

SUITE = "/_dash-component-suites/dash/dash-renderer/build/dash_renderer.v1_0m1.min.js"
BROWSER = {"Accept-Encoding": "gzip, deflate, br, zstd"}


@pytest.fixture(scope="module")
def app(tmp_path_factory):
    return create_app(tmp_path_factory.mktemp("space") / "workspace")


@pytest.fixture
def get(app):
    client = app.server.test_client()
    return lambda path, **headers: client.get(path, headers=BROWSER | headers)


def assets_address(get, name):
    page = brotli.decompress(get("/library").data).decode()
    return next(part for part in page.split('"') if part.startswith(f"/assets/{name}?m="))


def test_files_of_libraries_are_compressed_and_kept_for_good(get):
    answer = get(SUITE)
    assert answer.headers["Content-Encoding"] == "br"
    assert answer.headers["Cache-Control"] == FOR_GOOD
    assert "Accept-Encoding" in answer.headers["Vary"]
    script = brotli.decompress(answer.data)
    assert script.startswith(b"/*! For license information") and len(answer.data) < len(script) / 4
    assert int(answer.headers["Content-Length"]) == len(answer.data)


def test_browsers_without_brotli_get_gzip_or_plain_text(get):
    zipped = get(SUITE, **{"Accept-Encoding": "gzip"})
    plain = get(SUITE, **{"Accept-Encoding": "br;q=0, identity"})
    assert zipped.headers["Content-Encoding"] == "gzip"
    assert "Content-Encoding" not in plain.headers
    assert gzip.decompress(zipped.data) == plain.data == brotli.decompress(get(SUITE).data)


@pytest.mark.parametrize("name", ["motionscape.js", "motionscape.css"])
def test_own_files_are_kept_for_good_under_their_date_only(get, name):
    address = assets_address(get, name)
    assert get(address).headers["Content-Encoding"] == "br"
    assert get(address).headers["Cache-Control"] == FOR_GOOD
    path = address.partition("?")[0]
    for other in (path, f"{path}?m=1", f"{path}?m=nan", f"{path}?m=1e999"):
        assert "immutable" not in get(other).headers.get("Cache-Control", "")


def test_a_file_that_was_changed_is_sent_anew(app, get, tmp_path, monkeypatch):
    path = tmp_path / "new.css"
    monkeypatch.setattr(app.server.blueprints["_dash_assets"], "static_folder", str(tmp_path))
    for colour in ("red", "green"):
        path.write_text(f"a {{ color: {colour} }}" + " " * LEAST)
        os.utime(path, (1e9, 1e9))
        assert colour.encode() in brotli.decompress(get("/assets/new.css?m=1000000000.0").data)


def test_files_without_a_fingerprint_are_asked_for_again(get):
    answer = get("/_dash-component-suites/dash_ag_grid/async-community.js")
    assert "immutable" not in answer.headers.get("Cache-Control", "")
    again = get("/_dash-component-suites/dash_ag_grid/async-community.js", **{"If-None-Match": answer.headers["ETag"]})
    assert again.status_code == 304 and not again.data


def test_pages_are_compressed_and_never_kept(get):
    answer = get("/library")
    assert answer.headers["Content-Encoding"] == "br"
    assert "immutable" not in answer.headers.get("Cache-Control", "")


def test_short_answers_refusals_and_heads_stay_as_they_are(app, get):
    assert "Content-Encoding" not in get("/_reload-hash").headers
    assert "Content-Encoding" not in get("/_dash-component-suites/dash/nothing.js").headers
    assert "Content-Encoding" not in app.server.test_client().head(SUITE, headers=BROWSER).headers


@pytest.mark.parametrize(
    "path",
    [
        "/assets/../../pyproject.toml",
        "/assets/%2e%2e/%2e%2e/pyproject.toml",
        "/_dash-component-suites/dash/../webapp/app.py",
        "/_dash-component-suites/webapp/app.py",
    ],
)
def test_nothing_else_can_be_read(get, path):
    answer = get(path)
    assert b"motionscape" not in answer.data.lower() or answer.mimetype == "text/html"
    assert "immutable" not in answer.headers.get("Cache-Control", "")
