"""Adding a page touches its own folder and one list: a feature that is registered works everywhere."""

from __future__ import annotations

from pathlib import Path

import pytest
from dash import html
from flask import Blueprint

import webapp.features
from core.mocap.clip import Segment
from core.workspace import Workspace
from tests.webapp.generated import walkers
from webapp.app import create_app
from webapp.cli.main import commands
from webapp.shell import feature, links, playback, virtual


def _routes(workspace):
    routes = Blueprint("dances", __name__, url_prefix="/api/dances")
    routes.get("/count")(lambda: str(len(workspace.datasets())))
    return [routes]


DANCES = feature.Feature(
    path="dances",
    label="Dances",
    symbol="graph",
    page=lambda: html.Div("All dances", id="dances-page"),
    register=lambda app, workspace: None,
    keys=feature.LinkKeys(names=("style", "partner"), of_dataset=("partner",), patterns={"style": "waltz|tango"}),
    routes=_routes,
    commands={"dance": feature.Command("Dance.", lambda parser: None, lambda arguments: 7)},
    selections=(feature.SelectionKind("dance", numbers=("step",)),),
    plays=lambda workspace, dataset, shown: playback.overlay(
        dataset, [playback.item(*Segment(dataset.names[0], 0, 10), "a dance")], "Dance"
    ),
    missing=lambda workspace, shown: "There is no such dance." if shown.selection["dance"] > 3 else None,
    motion_kinds={"dance": lambda workspace, rest: walkers((rest,))},
)


@pytest.fixture
def dances():
    feature.register(DANCES)
    yield
    feature.unregister("dances")


@pytest.fixture
def workspace(tmp_path):
    found = Workspace(tmp_path)
    found.add_dataset("demo", walkers(("a", "b")))
    return found


def test_every_feature_is_a_folder_and_the_list_is_complete():
    home = Path(webapp.features.__file__).parent
    folders = {path.parent.name for path in home.glob("*/__init__.py")}
    assert folders == set(webapp.features.NAMES) and len(feature.features()) == len(folders)


def test_a_new_feature_has_page_link_route_and_command(dances, workspace):
    app = create_app(workspace.path)
    assert app.server.test_client().get("/api/dances/count", headers={"Host": "localhost"}).text == "1"
    assert "/dances" in str(app.layout) and "Dances" in str(app.layout)
    view, problems = links.parse("/dances", "?dataset=demo&style=tango&partner=ana&dance=2&step=5")
    assert problems == () and view.view == {"style": "tango", "partner": "ana"}
    assert view.selection == {"dance": 2, "step": 5}
    _, problems = links.parse("/dances", "?style=polka&dance=two")
    assert len(problems) == 2
    assert commands()["dance"].run(None) == 7


def test_its_selections_play_and_say_what_is_missing(dances, workspace):
    request = playback.selected_request(workspace, "demo", {"dance": 1}, {})
    assert request["title"] == "Dance" and request["items"][0]["clip"] == "a"
    assert playback.missing(workspace, "demo", {"dance": 9}) == "There is no such dance."
    assert virtual.open_any(workspace, "~dance~c").names == ("c",)


def test_without_it_nothing_of_it_is_known(workspace):
    assert "dances" not in links.view_keys() and "dance" not in commands()
    assert playback.selected_request(workspace, "demo", {"dance": 1}, {}) is None
