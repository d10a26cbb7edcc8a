"""What Ctrl+K finds in a workspace."""

import pytest

from core import analyses
from core.demo import make_demo
from core.workspace import Workspace
from webapp.app import create_app
from webapp.shell import links, places


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("places") / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.5))
    workspace.add_dataset("other", make_demo(minutes=0.2))
    for method in ("motifs", "grammar"):
        analyses.run(workspace, analyses.Request("demo", method))
    return workspace


def named(workspace, text, link="/map?dataset=demo"):
    create_app(workspace.path)  # registers the features
    return {place.name: place for place in places.find(workspace, link, text)}


def test_datasets_clips_motifs_actions_and_settings_are_found(workspace):
    clip = workspace.open("demo").clips[0].name
    assert named(workspace, "other")["other"].address == "/library?dataset=other"
    assert named(workspace, clip.upper())[clip].address == f"/map?dataset=demo&clip={clip}"
    assert named(workspace, "motif 0")["Motif 0"].address == "/motifs?dataset=demo&motif=0"
    assert named(workspace, "action 1")["Action 1"].address == "/grammar?dataset=demo&action=1"
    (kappa,) = named(workspace, "(kappa)").values()
    assert (kappa.address, kappa.opens) == ("/motifs?dataset=demo", "motifs-fold")


def test_motifs_are_found_by_their_labels(workspace):
    found = named(workspace, "motif walk")
    assert found and all("walk" in place.about for place in found.values())


def test_what_is_called_so_comes_first(workspace):
    assert next(iter(named(workspace, "motif 1"))) == "Motif 1"


def test_all_words_must_stand_there_and_each_kind_has_a_limit(workspace):
    assert not named(workspace, "motif zebra")
    assert len([p for p in places.find(workspace, "/library?dataset=demo", "setting")]) == places.MOST


def test_every_address_opens_without_a_problem(workspace):
    for place in places.find(workspace, "/sweeps?dataset=demo&kappa=60", ""):
        view, problems = links.parse(*place.address.partition("?")[::2])
        assert not problems and view.dataset in ("demo", "other")


@pytest.mark.parametrize("link", ["", "/nowhere", "/library?dataset=gone", "/map?kappa=x&motif=%00", "?" * 5000])
def test_links_that_cannot_be_opened_are_no_hindrance(workspace, link):
    assert "demo" in named(workspace, "demo", link)


def test_the_route_answers_with_what_was_found(workspace):
    client = create_app(workspace.path).server.test_client()
    answer = client.get("/api/places", query_string={"link": "/map?dataset=demo", "text": "other"})
    assert [place["name"] for place in answer.get_json()["places"]] == ["other"]
    assert client.get("/api/places").status_code == 200
