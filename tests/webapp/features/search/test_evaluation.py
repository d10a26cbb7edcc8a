"""Evaluation: engines' rankings against labels, as the page and its download show them."""

from __future__ import annotations

import json

import pytest

from core import analyses
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from tests.webapp.generated import walk
from webapp.app import create_app
from webapp.features.search import evaluation
from webapp.features.search.figures import ranking as figures
from webapp.shell import settings

ENGINES = "bounded-edit,chance"
VIEW = {"look": "evaluate", "ranking-engines": ENGINES}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory: pytest.TempPathFactory) -> Workspace:
    """Slow and fast walks, and how the default engine and chance rank them."""
    clips = tuple(
        walk(f"{kind}{k}", pace=pace + 0.02 * k, turn=0.5 * k, seconds=2.0)
        for kind, pace in (("slow", 0.5), ("fast", 1.6))
        for k in range(4)
    )
    labels = tuple(Label(c.name, 0, c.n_frames, c.name[:4]) for c in clips)
    made = Workspace(tmp_path_factory.mktemp("evaluation") / "workspace")
    made.add_dataset("walkers", Dataset("walkers", clips, labels))
    made.add_dataset("plain", Dataset("plain", clips))
    for name in ("walkers", "plain"):
        analyses.run(made, analyses.Request(name, "ranking", {"engines": ENGINES}))
    return made


@pytest.fixture(scope="module")
def found(workspace: Workspace):
    dataset, key = workspace.open("walkers"), settings.key_of(workspace, "ranking", "walkers", VIEW)
    return evaluation.evaluation_of(workspace, dataset, key, VIEW)


def test_the_chips_know_the_engines_and_the_usual_choice():
    known = next(part for part in evaluation.layout()._traverse() if getattr(part, "id", "") == "ranking-engines-of")
    assert known.data["key"] in settings.keys("ranking")
    assert set(known.data["usual"].split(",")) < set(known.data["names"])


def test_the_result_shows_every_measure_of_every_engine(workspace, found):
    shown = str(evaluation.result(workspace.open("walkers"), found, VIEW, "light"))
    for word in ("P@20", "mAP", "1-NN", "Bounded edit", "Chance", "8 clips searched for"):
        assert word in shown
    best = found.engines["bounded-edit"]["ALL"].measures["1-NN"].mean
    assert f"{best:.3f}" in shown


def test_curves_and_confusion_are_those_of_the_scores(found):
    chart = figures.curves_chart(found.engines, "ALL", evaluation.NAMES, "dark")
    assert [line.name for line in chart.data] == ["Bounded edit", "Chance"]
    scores = found.engines["bounded-edit"]["ALL"]
    assert list(chart.data[0].y) == pytest.approx(list(scores.precision))
    confusion = figures.confusion_chart(scores, "light").data[0]
    assert tuple(confusion.x) == ("fast", "slow") and sum(confusion.z[0]) == pytest.approx(1)
    assert figures.curves_chart(found.engines, "XSTYLE", evaluation.NAMES, None).data == ()  # there are no styles here


def test_the_download_holds_all_of_it(workspace, found):
    client = create_app(workspace.path).server.test_client()
    document = json.loads(client.get(f"/api/search/ranking.json?dataset=walkers&ranking-engines={ENGINES}").text)
    assert document["format"] == "motionscape/evaluation/1" and document["parameters"]["engines"] == ENGINES
    measures = document["engines"]["bounded-edit"]["ALL"]["measures"]
    assert measures["mAP"]["mean"] == pytest.approx(found.engines["bounded-edit"]["ALL"].measures["mAP"].mean)
    assert client.get("/api/search/ranking.json?dataset=walkers").status_code == 404


def test_without_labels_it_says_so(workspace):
    key = settings.key_of(workspace, "ranking", "plain", VIEW)
    with pytest.raises(ValueError, match="label"):
        evaluation.evaluation_of(workspace, workspace.open("plain"), key, VIEW)
