"""The Motifs page's pure parts: placement, elements, drawing, form, metrics, what a selection plays."""

from __future__ import annotations

import itertools
import time

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core import analyses
from core.mocap.clip import Label, Segment
from core.mocap.dataset import Dataset
from core.motifs.graph import Motif, MotifGraph, succession_edges
from tests.webapp.generated import walk
from tests.webapp.stored import misfit
from webapp.features.motifs import names, playing
from webapp.features.motifs.figures import graph as graph_figure
from webapp.features.motifs.figures.drawing import graph_svg
from webapp.features.motifs.figures.placement import place_boxes, spread
from webapp.features.motifs.layout import metric_tiles, motion_list, selection_panel
from webapp.shell import playback, results, theme
from webapp.shell import settings as page_settings
from webapp.shell.identifiers import Pattern
from webapp.ui import tables
from webapp.ui.parameter_form import parameter_form, read_form, summary

PARAMETERS = analyses.parameters(results.MOTIFS)


def motif(number: int, segments: list[tuple[str, int, int]]) -> Motif:
    parts = tuple(Segment(*segment) for segment in segments)
    frames = parts[0].n_frames
    warps = tuple(np.linspace(0, part.n_frames - 1, frames, dtype=np.float32) for part in parts)
    return Motif(number, parts, 0, warps)


@pytest.fixture
def dataset() -> Dataset:
    labels = (Label("a", 0, 60, "walk"), Label("a", 60, 100, "stop"))
    return Dataset("two walks", (walk("a", 4.0, 60.0), walk("b", 4.0, 60.0)), labels)


@pytest.fixture
def graph(dataset: Dataset) -> MotifGraph:
    motifs = (
        motif(0, [("a", 0, 60), ("b", 10, 60), ("a", 130, 200)]),
        motif(1, [("a", 70, 100), ("b", 80, 120)]),
        motif(2, [("b", 200, 230), ("b", 130, 160)]),
    )
    metrics = {"coverage": 0.7, "average_frame_error": 2.0, "mean_pose_distance": 8.0, "mean_motions": 7 / 3}
    return MotifGraph(motifs, succession_edges(motifs), metrics, {"kappa": 10})


def overlaps(centres: np.ndarray, sizes: np.ndarray) -> int:
    a, b = np.triu_indices(len(centres), 1)
    return int((np.abs(centres[a] - centres[b]) < (sizes[a] + sizes[b]) / 2 - 0.2).all(axis=1).sum())


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 30), st.integers(0, 2**31 - 1))
def test_placed_boxes_never_overlap(n: int, seed: int):
    rng = np.random.default_rng(seed)
    sizes = rng.uniform(20, 160, (n, 2))
    edges = [(int(a), int(b)) for a, b in rng.integers(0, n, (n, 2))] if n else []
    centres = place_boxes(sizes, edges)
    assert centres.shape == (n, 2) and np.isfinite(centres).all()
    assert overlaps(centres, sizes) == 0
    assert np.array_equal(centres, place_boxes(sizes, edges))


def test_boxes_at_one_place_part():
    sizes = np.full((40, 2), 50.0)
    assert overlaps(spread(np.zeros((40, 2)), sizes), sizes) == 0


def test_neighbours_are_near_and_far_boxes_far():
    sizes, n = np.full((12, 2), 50.0), 12
    ring = place_boxes(sizes, [(k, (k + 1) % n) for k in range(n)])
    radii = np.hypot(*(ring - ring.mean(0)).T)
    assert radii.std() / radii.mean() < 0.1  # a ring is drawn as one
    chain = place_boxes(sizes, [(k, k + 1) for k in range(n - 1)])
    between = np.hypot(*(chain[1:] - chain[:-1]).T)
    assert between.std() / between.mean() < 0.1
    assert np.hypot(*(chain[-1] - chain[0])) > 0.9 * between.sum()  # and a chain is straight


@pytest.mark.parametrize("leaves", [2, 5, 30])
def test_leaves_of_a_star_stand_around_it(leaves):
    sizes = np.full((leaves + 1, 2), 50.0)
    places = place_boxes(sizes, [(0, k) for k in range(1, leaves + 1)])
    turns = np.sort(np.arctan2(*(places[1:] - places[0]).T))
    assert np.diff(turns, append=turns[0] + 2 * np.pi).max() < 2 * np.pi / min(leaves, 5) + 0.7
    assert overlaps(places, sizes) == 0


def test_boxes_that_all_follow_one_another_are_placed():
    sizes = np.full((9, 2), 60.0)
    places = place_boxes(sizes, list(itertools.permutations(range(9), 2)))
    assert overlaps(places, sizes) == 0 and len(np.unique(places, axis=0)) == 9


def test_three_hundred_boxes_take_less_than_a_second():
    rng = np.random.default_rng(0)
    sizes = rng.uniform(46, 150, (300, 2))
    edges = [(k, (k + 1) % 300) for k in range(300)] + [tuple(pair) for pair in rng.integers(0, 300, (200, 2)).tolist()]
    started = time.thread_time()
    assert overlaps(place_boxes(sizes, edges), sizes) == 0
    assert time.thread_time() - started < 1


def test_many_parts_fill_a_frame_of_the_wanted_shape():
    centres = place_boxes(np.full((80, 2), 50.0), [])
    width, height = np.ptp(centres, axis=0)
    assert 0.9 < width / height < 2.4


def test_boxes_grow_with_length_and_number(graph):
    sizes = graph_figure.box_sizes(graph.motifs)
    assert sizes[0, 0] == sizes[:, 0].max() and sizes[0, 1] == sizes[:, 1].max()
    assert graph_figure.box_sizes(()).shape == (0, 2)


def test_elements_are_the_graph(graph):
    elements = graph_figure.graph_elements(graph, {0: {"light": "data:image/svg+xml,x"}})
    nodes = {e["data"]["id"] for e in elements if "position" in e}
    edges = [e["data"] for e in elements if "source" in e["data"]]
    assert nodes == {"m0", "m1", "m2"}
    assert {(e["source"], e["target"], e["count"]) for e in edges} == {
        (f"m{e.source}", f"m{e.target}", e.count) for e in graph.edges
    }
    assert all(edge["source"] in nodes and edge["target"] in nodes for edge in edges)
    loop = next(e for e in elements if e["data"]["id"] == "e2-2")
    assert "loop" in loop["classes"]


def test_parts_have_colours_of_their_own():
    motifs = (motif(0, [("a", 0, 9)]), motif(1, [("a", 9, 20)]), motif(2, [("b", 0, 9)]), motif(3, [("c", 0, 9)]))
    colours = graph_figure.component_colours(MotifGraph(motifs, succession_edges(motifs), {}, {}))
    assert colours[0] == colours[1] == theme.COMPONENTS[0]
    assert colours[2] == colours[3] == theme.ALONE


def test_rare_edges_start_hidden_only_where_there_are_many():
    assert graph_figure.first_threshold([1] * 150) == 1
    counts = [1] * 400 + [5] * 100
    assert sum(c >= graph_figure.first_threshold(counts) for c in counts) <= 150
    assert graph_figure.first_threshold([3] * 500) == 3  # hiding all of them would help nobody


def test_styles_name_every_colour_and_icon():
    for name in theme.CANVAS:
        text = str(graph_figure.stylesheet(name))
        assert theme.CANVAS[name]["line"] in text and f"data(icon_{name})" in text


def test_the_drawing_is_whole_and_escaped(graph):
    from xml.etree import ElementTree

    elements = graph_figure.graph_elements(graph, {0: {"light": 'data:image/svg+xml,"<&'}})
    root = ElementTree.fromstring(graph_svg(elements, title="<a & b>"))
    space = "{http://www.w3.org/2000/svg}"
    assert len(root.findall(f"{space}rect")) == 1 + len(graph.motifs)
    assert len(root.findall(f"{space}path")) == len(graph.edges)
    assert root.find(f"{space}title").text == "<a & b>"
    ElementTree.fromstring(graph_svg([], "dark"))


def test_a_motif_plays_all_its_motions_in_step(dataset, graph):
    request = playing.stage_request(dataset, graph, {"motif": 0})
    assert [(i["clip"], i["start"], i["end"]) for i in request["items"]] == [tuple(s) for s in graph.motifs[0].segments]
    assert all(len(item["warp"]) == 60 for item in request["items"]) and request["sync"] == "warp"
    alone = playing.stage_request(dataset, graph, {"motif": 0, "motion": 1})
    assert [(i["clip"], i["start"], i["end"], i["warp"]) for i in alone["items"]] == [("b", 10, 60, None)]


def test_a_crowd_is_thinned_and_keeps_the_medoid():
    crowd = Motif(0, tuple(Segment("a", i, i + 1) for i in range(90)), 41, ())
    shown = playing.shown_motions(crowd)
    assert len(shown) == len(set(shown)) == playback.MOST_FIGURES and shown[0] == 41
    assert playing.shown_motions(motif(0, [("a", 0, 9), ("a", 9, 18)])) == [0, 1]


def test_a_transition_is_one_segment_around_the_gap(dataset, graph):
    edge = results.find_edge(graph, "0-1")
    assert playing.transition_segment(dataset, graph, edge, 0) == Segment("a", 0, 100)
    request = playing.stage_request(dataset, graph, {"edge": "0-1", "transition": 1})
    assert [(i["clip"], i["start"], i["end"]) for i in request["items"]] == [("b", 10, 120)]
    again = results.find_edge(graph, "1-0")
    assert playing.transition_segment(dataset, graph, again, 0) == Segment("a", 70, 190)  # a second into a long motion


def test_what_is_not_there_does_not_play(dataset, graph):
    for selection in ({"motif": 99}, {"edge": "7-8"}, {"clip": "zz"}, {}):
        assert playing.stage_request(dataset, graph, selection) is None
    assert playing.stage_request(dataset, None, {"motif": 0}) is None
    beyond = playing.stage_request(dataset, None, {"clip": "a", "start": 900, "end": 950})
    assert (beyond["items"][0]["start"], beyond["items"][0]["end"]) == (0, 240)


def test_the_table_says_how_often_how_long_and_what(dataset, graph):
    rows = {row["id"]: row for row in tables.motif_rows(graph, dataset)}
    assert (rows[0]["motions"], rows[0]["clips"], rows[0]["seconds"]) == (3, 2, 1.0)
    assert rows[0]["label"] == "walk (33 %)" and rows[1]["label"] == "stop (43 %)" and rows[2]["label"] == ""
    assert rows[1]["selection"] == {"motif": 1}
    bare = Dataset("bare", dataset.clips)
    fields = [column["field"] for column in tables.motif_columns(dataset)]
    assert [column["field"] for column in tables.motif_columns(bare)] == [field for field in fields if field != "label"]


def test_metrics_in_words(dataset, graph):
    values = {name: value for name, value, _ in metric_tiles(graph, dataset)}
    assert values["Coverage"] == "70 %" and values["Error ratio"] == "0.25" and values["Motifs"] == "3"


def test_the_panel_lists_every_motion_with_its_time(dataset, graph):
    listed = motion_list(dataset, graph, {"motif": 0, "motion": 1})
    assert misfit(listed, names.MOTIONS) is None
    assert [row["chosen"] for row in listed["rows"]] == [False, True, False] and listed["more"] == 0
    assert listed["rows"][1]["when"] == "0:00.2 to 0:01.0"
    assert listed["rows"][2]["selection"] == {"motif": 0, "motion": 2}
    assert "3 motions" in str(selection_panel(graph, {"motif": 0}))
    marked = str(selection_panel(graph, {"motifs": "0-1-99"}))
    assert "2 motifs marked" in marked and "Motif 1" in marked and motion_list(dataset, graph, {"motifs": "0-1"}) == {}
    for nothing in ({}, {"motif": 99}, {"motifs": "98-99"}, {"edge": "7-8"}):
        assert "Choose a box" in str(selection_panel(graph, nothing)) and motion_list(dataset, graph, nothing) == {}


def test_the_form_takes_what_fits_and_says_what_does_not():
    ids = [{"type": "parameter", "name": name} for name in ("kappa", "rho", "adjacency", "seed")]
    taken, problems = read_form(PARAMETERS, ids, ["", 1.5, "spheres", -4])
    assert taken == {"rho": 1.5, "adjacency": "spheres"}
    assert set(problems) == {"seed"} and "whole number" in problems["seed"]


def test_every_parameter_has_a_control_and_help():
    text = str(parameter_form(PARAMETERS, {}, Pattern("parameter", "name")))
    for parameter in PARAMETERS:
        assert f"'name': '{parameter.name}'" in text and parameter.help.strip()[:20] in text


def test_links_hold_only_what_differs_from_the_defaults():
    request = page_settings.request_of("motifs", "demo", {"kappa": "200", "rho": "1", "gamma": "fast"})
    assert page_settings.not_default("motifs", request.parameters) == {"kappa": "200"}
    assert len(page_settings.refused("motifs", {"gamma": "fast", "kappa": "200"})) == 1
    assert summary({}) == "Default settings" and summary({"kappa": "200"}) == "kappa 200"
