"""Every function that a callback calls in the browser is handed over by a module of the front end."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from webapp.app import create_app

ASSETS = Path(__file__).resolve().parents[3] / "assets"


def handed_over() -> dict[str, str]:
    """Namespace -> the object of functions that a module registers under it."""
    sources = [path.read_text(encoding="utf-8") for path in sorted(ASSETS.glob("*/*.mjs"))]
    found = [
        match for text in sources for match in re.findall(r'^register\("(\w+)", \{$(.*?)^\}\);$', text, re.M | re.S)
    ]
    assert len(found) == len({namespace for namespace, _ in found}), "a namespace is registered twice"
    return dict(found)


@pytest.fixture(scope="module")
def callbacks(tmp_path_factory) -> list[dict]:
    app = create_app(tmp_path_factory.mktemp("workspace"))
    app._setup_server()
    return app._callback_list


def test_the_browser_has_every_function_that_a_callback_names(callbacks):
    functions = handed_over()
    named = [callback["clientside_function"] for callback in callbacks if callback["clientside_function"]]
    assert len(named) > 50
    for function in named:
        namespace, name = function["namespace"], function["function_name"]
        assert re.search(rf"^  (async )?{name}[(:,]", functions[namespace], re.M), f"{namespace}.{name}"
