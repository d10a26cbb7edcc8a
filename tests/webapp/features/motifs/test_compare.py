"""Comparing results: what is said, listed, drawn and played; settings in links."""

from __future__ import annotations

import pytest

from core import analyses
from core.mocap.dataset import Dataset
from core.motifs.compare import compare
from core.workspace import Workspace
from tests.core.motifs.recordings import recurring
from tests.core.motifs.test_compare import graph_of
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.features.motifs import compare_view, names
from webapp.features.motifs.figures import compare as figure
from webapp.shell.links import parse, view_keys

HERE = graph_of("AAAAAAAABBBBCCCCDDDDEEEE....", fps=7)
THERE = graph_of("AAAABBBBCCCCCCCCDDD.....FFFF", fps=7)
FOUND = compare(HERE, THERE)


@pytest.fixture(scope="module")
def dataset() -> Dataset:
    return Dataset("walks", (walk("clip0", 4.0, 7.0),))


def test_the_sentence_says_what_changed():
    assert figure.sentence(FOUND) == (
        "1 of 5 motifs is kept in the other result, with 75% overlap on average; 1 is split; 2 are merged with others; "
        "1 is gone. 1 of its 5 motifs is new. 11% of all motion lies the same way in both."
    )
    assert figure.sentence(compare(HERE, HERE)).startswith("5 of 5 motifs are kept in the other result, with 100%")
    none = graph_of("....")
    assert figure.sentence(compare(none, none)) == "Neither result has motifs."


def test_filters_count_what_the_rows_hold(dataset):
    listed = figure.rows(FOUND, HERE, THERE, dataset, {3: "jump"})
    choices = {choice["value"]: choice["label"] for choice in figure.filters(FOUND)}
    assert choices == {
        "all": "All 6",
        "kept": "Kept 1",
        "split": "Split 1",
        "merged": "Merged 2",
        "lost": "Gone 1",
        "gained": "New 1",
    }
    assert [row["change"] for row in listed] == ["split", "merged", "merged", "kept", "lost", "gained"]
    assert [row["there"] for row in listed] == ["0, 1", "2", "2", "3", "", "4"]
    assert listed[3]["here"] == "3 jump" and listed[3]["overlap"] == 0.75
    assert listed[-1]["selection"] == {} and listed[-1]["view"] == {"gained": "4"}
    assert all(row["here_strip"].startswith("/api/filmstrip/walks/clip0?") for row in listed[:5])


def test_bars_are_as_high_as_their_motion_and_ribbons_fit_into_them():
    drawn = figure.flow(FOUND, {0: "squat"})
    assert misfit(drawn, names.COMPARE_FLOW_DATA) is None
    bars = {(bar["side"], bar["motif"]): bar for bar in drawn["bars"]}
    assert len(bars) == 12 and bars["a", 0]["title"] == "Motif 0 squat: 1.1 s, split"
    for side in "ab":
        column = [bar for bar in drawn["bars"] if bar["side"] == side]
        tops = [bar["y"] for bar in column]
        assert tops == sorted(tops) and column[-1]["motif"] is None
        assert column[-1]["y"] + column[-1]["h"] <= drawn["height"] + 0.2
    for ribbon in drawn["ribbons"]:
        for side, y in (("a", "ya"), ("b", "yb")):
            bar = bars[side, ribbon[side]]
            assert bar["y"] - 0.2 <= ribbon[y] and ribbon[y] + ribbon["h"] <= bar["y"] + bar["h"] + 0.2
    assert sum(r["h"] for r in drawn["ribbons"]) == pytest.approx(sum(b["h"] for b in drawn["bars"]) / 2, rel=0.05)
    assert {(r["a"], r["b"]): r["kind"] for r in drawn["ribbons"] if r["kind"] != "rest"} == {
        (0, 0): "linked", (0, 1): "linked", (1, 2): "linked", (2, 2): "linked", (3, 3): "kept",
    }  # fmt: skip


def test_the_picture_of_nothing_and_of_very_much_stays_in_its_frame():
    none = graph_of("....")
    assert [bar["motif"] for bar in figure.flow(compare(none, none))["bars"]] == [None, None]
    many = graph_of("".join(chr(1000 + k % 700) * 3 for k in range(7000)))
    drawn = figure.flow(compare(many, many))
    assert drawn["height"] <= 720 and max(bar["y"] + bar["h"] for bar in drawn["bars"]) <= drawn["height"] + 0.5


def test_a_motif_plays_beside_its_partners(dataset):
    request = figure.pair_request(dataset, HERE, THERE, FOUND, {"motif": 0})
    assert request["layout"] == "side" and request["title"] == "Motif 0 and motifs 0, 1 of the other result"
    assert [(i["label"], i["start"], i["end"]) for i in request["items"]] == [
        ("here 0", 0, 8), ("other 0", 0, 4), ("other 1", 4, 8),
    ]  # fmt: skip
    assert {i["colour"] for i in request["items"]} == {figure.HERE, figure.THERE}
    assert figure.pair_request(dataset, HERE, THERE, FOUND, {"motif": "4"})["title"] == "Motif 4, only here"
    alone = figure.pair_request(dataset, HERE, THERE, FOUND, {}, "4")
    assert alone["title"] == "Motif 4, only in the other result" and len(alone["items"]) == 1
    assert figure.pair_request(dataset, HERE, THERE, FOUND, {"motif": 99}) is None
    assert figure.pair_request(dataset, HERE, THERE, FOUND, {}, "") is None


@pytest.mark.parametrize(
    "settings",
    [
        {},
        {"kappa": 250},
        {"rho": 0.5, "seed": 3, "adjacency": "spheres", "reach": 0.001},
        {"rho": 1.2345678, "analysis_fps": 29.97, "gamma": 3.0000000000000004},
    ],
)
def test_settings_of_the_other_result_stand_in_a_link(settings):
    text = compare_view.write_other(settings)
    assert compare_view.read_other(text) == {name: str(value) for name, value in settings.items()}
    assert text == compare_view.write_other(dict(reversed(settings.items())))
    view, problems = parse("/motifs", f"?view=compare&other={text}&gained=3&stability=2,2")
    assert not problems and dict(view.view) == {"view": "compare", "other": text, "gained": "3", "stability": "2,2"}
    assert set(view.view) <= set(view_keys()["motifs"])


@pytest.mark.parametrize("text", ["", "default", "kappa", "kappa:", "kappa:lots", "nonsense:4", ":::,,,"])
def test_settings_that_make_no_sense_are_left_out(text):
    assert compare_view.read_other(text) == {}


def test_earlier_results_and_neighbours_are_offered_but_not_the_result_itself(tmp_path):
    workspace = Workspace(tmp_path)
    workspace.add_dataset("r", recurring())
    settings = {"kappa": "60", "min_letters": "3"}
    for extra in ({}, {"rho": "1.25"}, {"gamma": "2"}):
        analyses.run(
            workspace,
            analyses.Request("r", "motifs", {"kappa": 60, "min_letters": 3} | {k: float(v) for k, v in extra.items()}),
        )
    graph = analyses.stored(workspace, analyses.Request("r", "motifs", {"kappa": 60, "min_letters": 3}))
    past, steps = compare_view.choices(workspace, "r", settings, graph, "kappa:77")
    assert {item["value"] for item in past["items"]} == {
        "gamma:2,kappa:60,min_letters:3",
        "kappa:60,min_letters:3,rho:1.25",
        "kappa:77",
    }
    labels = {item["label"] for item in steps["items"]}
    assert labels == {
        "Same, seed 1",
        "Same, kappa 48",
        "Same, kappa 75",
        "Same, rho 0.8",
        "Same, gamma 1.4",
        "Same, gamma 1.6",
    }
    workspace.close()
