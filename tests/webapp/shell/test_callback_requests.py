"""Whatever is sent to the address of callbacks, the answer is no fault of the server."""

from __future__ import annotations

import json

import pytest
from dash._utils import split_callback_id

from webapp.app import create_app

ROUTE = "/_dash-update-component"


@pytest.fixture(scope="module")
def app(tmp_path_factory):
    return create_app(tmp_path_factory.mktemp("workspace"))


JOBS = {"output": "..jobs-shown.data..", "inputs": []}  # one of its outputs


@pytest.mark.parametrize(
    "body",
    [b"", b"{", b"\xff\xfe", b"[]", b"null", b'"x"', b"{}", b'{"output": 5}', b'{"output": "x.y"}', b"[" * 100_000]
    + [json.dumps(JOBS | more).encode() for more in ({}, {"inputs": 5}, {"output": None}, {"output": []})],
)
def test_what_is_no_request_of_a_callback_is_refused_in_words(app, body):
    answer = app.server.test_client().post(ROUTE, data=body, headers={"Content-Type": "application/json"})
    assert answer.status_code == 400 and "Reload the page" in answer.json["error"]


@pytest.mark.parametrize("junk", [5, "\ud800", {"a": [1]}], ids=["number", "half a character", "object"])
@pytest.mark.parametrize("outputs", ["its own", [], {"id": "x", "property": "y"}], ids=["own", "none", "another"])
def test_no_callback_breaks_over_values_or_outputs_that_are_not_its_own(app, junk, outputs):
    client, seen = app.server.test_client(), set()
    for callback in app._callback_list:
        if callback["clientside_function"] is not None:
            continue
        body = {"output": callback["output"], "changedPropIds": []}
        body["outputs"] = outputs
        if outputs == "its own":
            body["outputs"] = [] if callback["no_output"] else split_callback_id(callback["output"])
        for name in ("inputs", "state"):
            body[name] = [{"id": one["id"], "property": one["property"], "value": junk} for one in callback[name]]
        answer = client.post(ROUTE, json=body)
        assert answer.status_code in (200, 204, 400), callback["output"]
        seen.add(answer.status_code)
    assert 400 in seen or junk != "\ud800"
    assert 200 in seen or outputs != "its own" or junk == "\ud800"
