"""Whatever a browser puts into the stores, no callback of the server breaks over it."""

from __future__ import annotations

import logging
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

import pytest
from dash._utils import split_callback_id
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from core.workspace import Workspace
from tests.webapp.generated import walkers
from tests.webapp.shell.test_shapes import RUBBISH
from tests.webapp.test_names import STORES
from webapp.app import create_app
from webapp.jobs import launching
from webapp.shell.shapes import Most, keys, problem

_PLAIN = {
    NoneType: st.none(),
    bool: st.booleans(),
    int: st.integers(-2, 2**53),
    float: st.floats(allow_nan=False, allow_infinity=False),
    str: st.sampled_from(["walkers", "a", "0-9", "1", "a~0", ""]) | st.text(max_size=12),
}


def fitting(shape: Any, depth: int = 3) -> st.SearchStrategy:
    """Values of a shape."""
    origin, parts = get_origin(shape), get_args(shape)
    if shape is Any:
        return RUBBISH
    if shape is None or shape in _PLAIN:
        return _PLAIN[NoneType if shape is None else shape]
    if origin is Literal:
        return st.sampled_from(parts)
    if origin in (Union, UnionType):
        return st.one_of(*(fitting(part, depth) for part in parts))
    if origin is list:
        return st.lists(fitting(parts[0], depth - 1), max_size=2 if depth > 0 else 0)
    if origin is tuple:
        return st.tuples(*(fitting(part, depth - 1) for part in parts)).map(list)
    if origin is dict:
        return st.dictionaries(fitting(parts[0]), fitting(parts[1], depth - 1), max_size=3)
    if origin is Annotated or not isinstance(shape, type):
        return fitting(parts[0], depth)
    known, required = keys(shape)
    by_key = {key: fitting(part, depth - 1) for key, part in known.items()}
    return st.fixed_dictionaries(
        {key: by_key[key] for key in known if key in required},
        optional={key: by_key[key] for key in known if key not in required},
    )


@pytest.fixture(scope="module")
def app(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("workspace"))
    workspace.add_dataset("walkers", walkers(("a", "b"), seconds=2.0))
    return create_app(workspace.path)


@pytest.fixture(autouse=True)
def _no_work(monkeypatch):
    monkeypatch.setattr(launching, "launch", lambda workspace_path: None)


def on_server(app) -> list[dict[str, Any]]:
    return [one for one in app._callback_list if one["clientside_function"] is None and not one["background"]]


def answer(client, callback: dict[str, Any], values: dict[str, Any]):
    """The server's answer to a callback whose stores hold ``values``; other components have nothing."""

    def given_to(one: dict[str, str]) -> Any:
        if one["id"].startswith("{"):
            return []
        value = values.get(one["id"]) if one["property"] == "data" else None
        return {"id": one["id"], "property": one["property"], "value": value}

    first = callback["inputs"][0]
    outputs = [] if callback["no_output"] else split_callback_id(callback["output"])
    if isinstance(outputs, list):  # a pattern stands for the components that fit it: here, none
        outputs = [[] if one["id"].startswith("{") else one for one in outputs]
    elif outputs["id"].startswith("{"):
        outputs = []
    body = {
        "output": callback["output"],
        "outputs": outputs,
        "inputs": [given_to(one) for one in callback["inputs"]],
        "state": [given_to(one) for one in callback["state"]],
        "changedPropIds": [f"{first['id']}.{first['property']}"],
    }
    return client.post("/_dash-update-component", json=body)


@settings(max_examples=400, suppress_health_check=list(HealthCheck))
@given(data=st.data())
def test_no_callback_breaks_over_what_stores_hold(app, caplog, data):
    client = app.server.test_client()
    callback = data.draw(st.sampled_from(on_server(app)), label="callback")
    stores = {one["id"] for one in (*callback["inputs"], *callback["state"])} & STORES.keys()
    values = {store: data.draw(fitting(STORES[store].content) | RUBBISH, label=store) for store in sorted(stores)}
    if data.draw(st.booleans()):
        values["dataset"] = "walkers"
    caplog.clear()
    with caplog.at_level(logging.ERROR):
        status = answer(client, callback, values).status_code
    assert status in (200, 204), (callback["output"], status)
    assert [record for record in caplog.records if record.levelno >= logging.ERROR] == [], callback["output"]


@given(data=st.data())
def test_what_is_made_of_a_shape_fits_it(data):
    store = data.draw(st.sampled_from([*STORES.values()]))
    value = data.draw(fitting(store.content))
    words = problem(value, store.content, store)
    assert words is None or "too long" in words, (value, words)


def test_a_shape_may_limit_what_it_takes():
    assert problem("abc", Annotated[str, Most(2)]) == "it is too long"
    assert problem("a" * 200_000, Annotated[str, Most(300_000)]) is None
