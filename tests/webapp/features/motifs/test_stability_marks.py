"""Stability in the app: what the browser gets, what stands in a link, the download."""

from __future__ import annotations

import pytest

from core import analyses
from core.workspace import Workspace
from tests.core.motifs.recordings import recurring
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.motifs import names, stability_marks, stability_request
from webapp.shell import results

SETTINGS = {"kappa": "60", "min_letters": "3"}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    opened = Workspace(tmp_path_factory.mktemp("stability") / "workspace")
    opened.add_dataset("r", recurring())
    analyses.run(opened, analyses.Request("r", "motifs", {"kappa": 60, "min_letters": 3}))
    yield opened
    opened.close()


def test_a_link_says_repetitions_and_degrees_of_noise():
    for text, wanted in (
        ("1,3.5", (1, 3.5)),
        ("4", (4, 2.0)),
        ("many,0", (2, 0.0)),
        ("99,99", (2, 2.0)),
        ("", (2, 2.0)),
        (None, (2, 2.0)),
    ):
        values = analyses.normalise(stability_request.request("r", SETTINGS, text)).parameters
        assert (values["repetitions"], values["noise_degrees"], values["kappa"]) == (*wanted, 60)


def test_a_link_holds_every_digit():
    text = stability_request.write(3, 1.2345678)
    assert text == "3,1.2345678" and stability_request.write(2, 2.0) == "2,2"
    assert stability_request.request("r", SETTINGS, text).parameters["noise_degrees"] == 1.2345678


def test_what_is_measured_is_found_again_and_shown(workspace):
    assert stability_request.stored(workspace, "r", SETTINGS, "1,1") is None
    job = stability_request.latest_job(workspace, "r", SETTINGS, "1,1")
    assert job is None and stability_marks.status("1,1", None, None, "").children == "Not measured yet for this result."
    found = analyses.run(workspace, stability_request.request("r", SETTINGS, "1,1"))
    assert stability_request.stored(workspace, "r", SETTINGS, "1,1") is found
    assert stability_request.latest_job(workspace, "r", SETTINGS, "1,1").state == "done"
    shown = stability_marks.shown_values(found)
    assert misfit(shown, names.STABILITY_DATA) is None
    graph = results.motif_graph(workspace, "r", SETTINGS)
    assert set(shown["motifs"]) == {str(motif.id) for motif in graph.motifs} and shown["repeats"] == len(found.repeats)
    one = shown["motifs"]["0"]
    kinds = [one[kind] for kind in ("noise", "seed", "parameters")]
    assert one["overall"] == pytest.approx(sum(kinds) / 3, abs=1e-3) and 0 <= one["kept"] <= shown["repeats"]
    said = stability_marks.status("1,1", found, None, "dataset=r").children[0]
    assert said == f"Mean stability {found.overall.mean():.0%}, over 8 repeats. "


def test_nothing_is_shown_where_nothing_was_asked(workspace):
    assert stability_marks.shown_values(None) is None
    assert stability_marks.status(None, None, None, "") is None


def test_the_figures_can_be_saved_once_they_are_there(workspace):
    browser = create_app(workspace.path).server.test_client()
    query = "dataset=r&kappa=60&min_letters=3"
    missing = browser.get(f"/api/stability.json?{query}&stability=2,4")
    assert missing.status_code == 404 and "not been measured" in missing.get_json()["error"]
    analyses.run(workspace, stability_request.request("r", SETTINGS, "1,1"))
    there = browser.get(f"/api/stability.json?{query}&stability=1,1")
    assert there.status_code == 200 and there.get_json()["format"] == "motionscape/stability/1"
    assert "r-stability.json" in there.headers["Content-Disposition"]
