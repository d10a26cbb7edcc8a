"""The Map page without a browser: the heatmap, its icons, what the routes send, what stands below the map."""

from __future__ import annotations

import csv
import io
import json
import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest

from core import analyses
from core.demo import make_demo
from core.motion_map.build import MapParameters
from core.workspace import Workspace
from tests.webapp.stored import misfit
from webapp.app import create_app
from webapp.features.motion_map import callbacks, layout, names, panels
from webapp.features.motion_map.figures import heatmap as figures
from webapp.features.motion_map.maps import other_maps
from webapp.shell import settings

VIEW = {"map-grid": "9x8", "map-samples": "300", "map-analysis_fps": "15"}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    workspace = Workspace(tmp_path_factory.mktemp("maps") / "workspace")
    workspace.add_dataset("demo", make_demo(minutes=0.5))
    analyses.run(workspace, settings.request_of("map", "demo", VIEW))
    analyses.run(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))
    return workspace


@pytest.fixture(scope="module")
def shown(workspace):
    return callbacks.opened(workspace, "demo", VIEW)


@pytest.fixture(scope="module")
def graph(workspace):
    return analyses.stored(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))


@pytest.fixture(scope="module")
def client(workspace):
    return create_app(workspace.path).server.test_client()


@pytest.fixture(scope="module")
def key(workspace):
    return settings.key_of(workspace, "map", "demo", VIEW)


@pytest.mark.parametrize("colouring", figures.COLOURINGS)
def test_every_colouring_gives_every_node_what_it_says(shown, graph, colouring):
    motion_map, dataset = shown
    layer = figures.layer_of(motion_map, dataset, graph, colouring)
    assert layer.values.shape == (9, 8) and len(layer.names) == len(layer.colours)
    figure = figures.map_figure(motion_map, layer, "dark")
    z = np.array(figure.data[0].z, float)
    np.testing.assert_allclose(z, np.round(layer.values.T, 4))
    there = motion_map.density > 0
    if colouring in ("density", "speed", "clip"):
        assert (np.isnan(layer.values) == ~there).all()
    if layer.names:
        entries = figures.legend(layer)
        assert entries and {entry["name"] for entry in entries} <= set(layer.names)
        assert [entry["nodes"] for entry in entries] == sorted((e["nodes"] for e in entries), reverse=True)
        assert figures.scale_of(layer, "light") is None
    else:
        assert figures.legend(layer) == [] and layer.unit in figures.scale_of(layer, "light")["most"]


def test_the_label_of_a_node_is_the_one_most_of_its_time_has(shown):
    motion_map, dataset = shown
    layer = figures.layer_of(motion_map, dataset, None, "label")
    counted: dict[tuple[int, int], dict[str, int]] = {}
    for name in motion_map.clips:
        scale = dataset.clip(name).fps / motion_map.fps
        for k, node in enumerate(map(tuple, motion_map.nodes_of(name).tolist())):
            for label in dataset.labels:
                if label.clip == name and round(label.start / scale) <= k < round(label.end / scale):
                    counts = counted.setdefault(node, {})
                    counts[label.action] = counts.get(label.action, 0) + 1
    assert counted
    for (x, y), counts in counted.items():
        assert counts[layer.names[int(layer.values[x, y])]] == max(counts.values())


def test_colouring_by_what_is_not_there_shows_the_ridges(shown):
    motion_map, dataset = shown
    for colouring in (None, "motif", "nonsense"):
        np.testing.assert_array_equal(figures.layer_of(motion_map, dataset, None, colouring).values, motion_map.heights)


def test_one_picture_holds_all_icons_inside_the_map(shown):
    motion_map, _ = shown
    root = ElementTree.fromstring(figures.icons_svg(motion_map, "light"))
    groups = root.findall("{*}g")
    assert len(groups) == len(motion_map.icons)
    figure = figures.map_figure(motion_map, figures.layer_of(*shown, None, None), "light")
    assert len(figure.layout.images) == 1 and figure.layout.images[0].sizex == 9 and figure.layout.images[0].sizey == 8
    for group in groups:
        x, y, scale = map(float, re.findall(r"-?\d+\.?\d*", group.get("transform")))
        points = [
            tuple(map(float, pair)) for path in group.iter("{http://www.w3.org/2000/svg}path")
            for pair in re.findall(r"(-?\d+\.\d+) (-?\d+\.\d+)", path.get("d"))
        ]  # fmt: skip
        assert len(points) > 20
        for a, b in points:
            assert -0.6 <= x + scale * a <= 8.6 and -0.6 <= y + scale * b <= 7.6


def test_the_whole_map_is_sent_as_it_is(client, key, shown):
    motion_map, _ = shown
    answer = client.get(f"/api/map/{key}.bin")
    assert answer.status_code == 200 and "immutable" in answer.headers["Cache-Control"]
    length = int(np.frombuffer(answer.data[:4], "<u4")[0])
    head = json.loads(answer.data[4 : 4 + length])
    assert head["grid"] == [9, 8] and [clip["name"] for clip in head["clips"]] == list(motion_map.clips)
    numbers = np.frombuffer(answer.data[4 + length :], "<f4")
    size = motion_map.weights.size
    np.testing.assert_array_equal(numbers[:size].reshape(motion_map.weights.shape), motion_map.weights)
    table = np.frombuffer(answer.data[4 + length + 4 * size :], "<i4").reshape(7, -1)
    np.testing.assert_array_equal(table[3], motion_map.runs.node)
    assert client.get(f"/api/map/{key}.bin", headers={"If-None-Match": answer.headers["ETag"]}).status_code == 304


def test_paths_follow_their_clips(client, key, shown):
    motion_map, dataset = shown
    clip = dataset.clip(motion_map.clips[0])
    asked = f"/api/map/{key}/paths?dataset=demo&clip={clip.name}&start=20&end=80&clip={clip.name}&start=0&end=4"
    first, second = client.get(asked).get_json()
    step = round(clip.fps / motion_map.fps)
    assert first["step"] == step and first["start"] == 20 // step * step
    whole = motion_map.trajectory(clip, 4, step)
    np.testing.assert_allclose(first["points"], whole[20 // step : 79 // step + 1], atol=1e-3)
    assert len(second["points"]) == 1
    assert client.get(f"/api/map/{key}/paths?dataset=demo&clip=nobody&start=0&end=4").status_code == 404


def test_the_node_of_any_frame(client, key, shown):
    motion_map, _ = shown
    clip = motion_map.clips[0]
    answer = client.get(f"/api/map/{key}/node?dataset=demo&clip={clip}&frame=0").get_json()
    assert answer["node"] == motion_map.nodes_of(clip)[0].tolist() and answer["usual"] > 0
    assert client.get(f"/api/map/{key}/node?dataset=demo&clip={clip}&frame=x").status_code == 400


def test_a_drawn_path_is_answered_with_hits(client, key, shown):
    motion_map, _ = shown
    nodes = motion_map.nodes_of(motion_map.clips[0])[:40]
    path = ",".join(f"{x}-{y}" for x, y in nodes[::4])
    hits = client.get(f"/api/map/{key}/drawn?path={path}").get_json()
    assert hits and hits[0]["clip"] == 0 and hits[0]["distance"] <= hits[-1]["distance"]
    for bad in ("", "3-4", "a-b,c-d", "1-2-3,4-5-6"):
        assert client.get(f"/api/map/{key}/drawn?path={bad}").status_code == 400


def test_downloads(client, key, shown):
    motion_map, dataset = shown
    assert client.get(f"/api/map/{key}.json").get_json()["grid"] == [9, 8]
    answer = client.get(f"/api/map/{key}.csv")
    assert "demo-map.csv" in answer.headers["Content-Disposition"]
    rows = list(csv.DictReader(io.StringIO(answer.text)))
    assert len(rows) == int((motion_map.runs.end - motion_map.runs.start).sum())
    mine = [row for row in rows if row["clip"] == motion_map.clips[0]]
    assert [[int(row["node_x"]), int(row["node_y"])] for row in mine] == motion_map.nodes_of(
        motion_map.clips[0]
    ).tolist()
    assert int(mine[-1]["frame"]) < dataset.clip(motion_map.clips[0]).n_frames


def test_no_other_result_is_taken_for_a_map_or_harmed(client, workspace):
    motifs = analyses.key(workspace, analyses.Request("demo", "motifs", {"analysis_fps": 15}))
    for wrong in (motifs, "0" * 32, "..", "x"):
        assert client.get(f"/api/map/{wrong}.bin").status_code == 404
    assert workspace.results.has(motifs)


def test_what_lights_up_is_where_the_motif_passes(shown, graph):
    motion_map, dataset = shown
    lit = callbacks.lit_nodes(motion_map, graph, {"motif": graph.motifs[0].id})
    segment = graph.motifs[0].segments[0]
    scale = dataset.clip(segment.clip).fps / motion_map.fps
    first = motion_map.nodes_of(segment.clip)[round(segment.start / scale)]
    assert int(first[0] * 8 + first[1]) in lit
    several = callbacks.lit_nodes(motion_map, graph, {"motifs": "-".join(str(motif.id) for motif in graph.motifs)})
    assert set(lit) <= set(several)
    assert callbacks.lit_nodes(motion_map, graph, {"clip": "x"}) == []


def test_what_stands_below_the_map(shown, graph):
    motion_map, dataset = shown
    figure = panels.multiples_figure(motion_map, dataset, "light")
    assert len(figure.data) == len({label.action for label in dataset.labels})
    rows = panels.clip_rows(motion_map, dataset)
    assert [row["clip"] for row in rows] == list(motion_map.clips) and all(row["fit"] > 0 for row in rows)
    there = str(motion_map.regions[tuple(motion_map.nodes_of(motion_map.clips[0])[0])])
    text = str(panels.region(motion_map, dataset, graph, there))
    assert f"Region {there}" in text and motion_map.clips[0] in text
    assert "No motifs have been found" in str(panels.region(motion_map, dataset, None, there))
    for nothing in (None, "", "9999", "x"):
        assert "click one" in str(panels.region(motion_map, dataset, graph, nothing))


def test_facts_name_the_labels_of_every_node(shown):
    motion_map, dataset = shown
    facts = callbacks.facts_of(motion_map, dataset)
    assert misfit({"key": "k", "dataset": "d", "version": "v", "facts": facts}, names.MAP_KNOWN) is None
    assert len(facts["labels"]) == 72 and set(facts["names"]) == {label.action for label in dataset.labels}
    assert all(node == sorted(node, key=lambda entry: -entry[1]) for node in facts["labels"])


def test_recordings_without_labels_have_no_names_of_them(shown):
    motion_map, dataset = shown
    facts = callbacks.facts_of(motion_map, replace(dataset, labels=()))
    assert facts == {"names": [], "labels": [[]] * 72}


def test_the_clips_of_another_data_set_can_be_laid_on_a_map(workspace, key):
    workspace.add_dataset("more", make_demo(minutes=0.5, seed=5))
    request = settings.request_of("map", "more", {"map-model": key})
    laid, own = analyses.run(workspace, request), analyses.stored(workspace, settings.request_of("map", "demo", VIEW))
    np.testing.assert_array_equal(laid.weights, own.weights)
    assert set(laid.clips) == set(workspace.open("more").names) and laid.fits.shape == (len(laid.clips),)
    assert [other.key for other in other_maps(workspace, "more")] == [key] and other_maps(workspace, "demo") == []
    assert "demo" in str(layout.others_menu(other_maps(workspace, "more")))
    assert layout.extend_note(other_maps(workspace, "more"), "more") == []
    with pytest.raises(analyses.AnalysisError, match="no longer there"):
        analyses.run(workspace, settings.request_of("map", "more", {"map-model": "0" * 32}))
    with pytest.raises(analyses.ParameterError, match="workspace"):
        analyses.compute(workspace.open("more"), "map", {"model": key})


def test_parameters_have_everyday_names():
    assert {p.name: p.label for p in settings.parameters("map")} == {
        "grid": "Nodes across and down",
        "analysis_fps": "Frames per second",
        "samples": "Postures to learn from",
        "sigma": "Smoothness (sigma)",
        "ridge": "Height of ridges",
        "epochs": "Rounds",
        "training": "Training",
        "passes": "Passes (online)",
        "seed": "Random seed",
        "model": "Earlier map",
    }
    assert MapParameters().model == ""
