"""The Clip page without a browser: what is chosen, what the figures hold, what the routes answer."""

from __future__ import annotations

import csv
import io
from urllib.parse import quote

import numpy as np
import pytest
from flask import Flask

from core.editing.curves import TRAVEL
from core.mocap.clip import Label
from core.mocap.dataset import Dataset
from core.workspace import Workspace
from tests.core.editing.figures import going, standing
from tests.webapp.stored import misfit
from webapp.features.clip import callbacks, clips, editing, layout, names, table
from webapp.features.clip.figures import curves as figures
from webapp.features.clip.figures.gait import gait_table
from webapp.features.clip.figures.path import path_chart, selected_part
from webapp.features.clip.routes import clip_blueprint
from webapp.ui.timeline import motif_colour

LABELS = (Label("gait", 0, 100, "walk <fast>"), Label("gait", 80, 180, "on"))


@pytest.fixture(scope="module")
def dataset():
    return Dataset("walks", (going(("walk", 3.0)), standing(40)), LABELS)


@pytest.fixture(scope="module")
def curves(dataset):
    return clips.clip_curves(dataset, "gait")


def test_a_view_without_words_shows_hips_and_knees(curves):
    chosen = clips.choice({}, curves)
    assert (chosen.chart, chosen.kind, chosen.span) == ("angles", "body", None)
    assert chosen.joints == ("left_hip", "right_hip", "left_knee", "right_knee")
    assert {curve.name for curve in clips.chosen_curves(curves, chosen)} == {"flexion"}


@pytest.mark.parametrize(
    ("view", "joints", "titles"),
    [
        ({"joints": "left_ankle,tail"}, ("left_ankle",), ["left_ankle flexion [deg]"]),
        ({"joints": "left_ankle", "channels": "inversion"}, ("left_ankle",), ["left_ankle inversion [deg]"]),
        ({"joints": "pelvis", "channels": "flexion"}, ("pelvis",), ["pelvis tilt [deg]"]),
        ({"chart": "speeds", "joints": "head"}, ("head",), ["head speed [m/s]"]),
        ({"chart": "speeds"}, (TRAVEL, "left_wrist", "right_wrist"), None),
        ({"angles": "file", "rig": "16"}, ("16",), [f"LeftLeg {axis}rotation [deg]" for axis in "ZYX"]),
        ({"chart": "contacts"}, (), ["left_foot height [m]", "right_foot height [m]"]),
        (
            {"chart": "nonsense", "angles": "x", "span": "a_b"},
            ("left_hip", "right_hip", "left_knee", "right_knee"),
            None,
        ),
    ],
)
def test_views_name_what_the_chart_shows(curves, view, joints, titles):
    chosen = clips.choice(view, curves)
    found = clips.chosen_curves(curves, chosen)
    assert chosen.chart == "contacts" or chosen.joints == joints
    assert titles is None or [curve.title for curve in found] == titles


@pytest.mark.parametrize(
    ("text", "span"),
    [("0.5_2", (0.5, 2.0)), ("-1_2", (0.0, 2.0)), ("0_99", None), ("2_1", None), ("1", None), ("", None)],
)
def test_spans(curves, text, span):
    assert clips.choice({"span": text}, curves).span == span


def test_lines_are_the_curves_and_bands_the_contacts(curves):
    chosen = clips.choice({"channels": "flexion,rotation"}, curves)
    found = clips.chosen_curves(curves, chosen)
    panels = figures.panels_of(found, chosen, "light")
    assert [panel.title for panel in panels] == ["Hip", "Knee"] and all(len(panel.lines) == 4 for panel in panels)
    bands = figures.foot_bands(curves, "light")
    document = figures.time_chart(curves, panels, bands, chosen, "light")
    lines = document["data"][:8]
    for trace, line in zip(lines, [line for panel in panels for line in panel.lines], strict=True):
        assert np.allclose(trace["x"], np.arange(180) / 60, atol=1e-4)
        assert np.allclose(trace["y"], line.curve.values, atol=1e-3)
    left = next(t for t in document["data"][8:] if t["meta"]["row"] == 0)
    stands = np.zeros(180, bool)
    for start, end in left["meta"]["picks"]:
        stands[start:end] = True
    assert np.array_equal(stands, curves.contacts[:, 0])
    marks = [t for t in document["data"] if t.get("mode") == "markers"]
    assert sum(len(t["x"]) for t in marks) == len(curves.gait.events) > 4
    assert document["layout"]["meta"]["thinned"] is False
    assert {t["yaxis"] for t in document["data"]} == {"y", "y2", "y3"}


def test_a_long_line_is_thinned_to_what_is_seen_and_what_lies_beside_it():
    clip = standing(20_000, 120.0)
    clip.root_positions[12_345, 0] += 5.0
    long = clips.clip_curves(Dataset("long", (clip,)), "standing")
    for span, first, last in ((None, 0, 20_000), ("101_106", 98.4, 108.6)):
        chosen = clips.choice({"chart": "speeds", "joints": TRAVEL} | ({"span": span} if span else {}), long)
        panels = figures.panels_of(clips.chosen_curves(long, chosen), chosen, "dark")
        document = figures.time_chart(long, panels, [], chosen, "dark")
        (line,) = document["data"]
        assert len(line["x"]) <= figures.MOST_POINTS + 4 and first <= line["x"][0] and line["x"][-1] <= last
        assert max(line["y"]) > 10  # the jump at 102.9 s is in both
        assert document["layout"]["meta"]["thinned"] == (span is None)


def test_overlapping_labels_get_bands_of_their_own_and_are_only_text():
    blocks = [figures.Block(label.start, label.end, label.action, motif_colour(k)) for k, label in enumerate(LABELS)]
    bands = figures.lanes("Labels", blocks)
    assert [band.title for band in bands] == ["Labels", ""] and [len(band.blocks) for band in bands] == [1, 1]
    bars = [figures._band(row, band, "yaxis2", 60.0)[0] for row, band in enumerate(bands)]
    assert bars[0]["text"] == ["walk &lt;fast&gt;"] and bars[1]["base"] == [round(80 / 60, 4)]
    assert len(figures.lanes("Labels", [blocks[0], figures.Block(100, 120, "z", "#000000")])) == 1


def test_the_path_has_start_end_steps_and_the_selected_part(curves):
    document = path_chart(curves, {"clip": "gait", "start": 30, "end": 60}, "light")
    path, chosen = document["data"][:2]
    ground = curves.place("pelvis")[:, [0, 2]]
    assert np.allclose(path["x"], ground[:, 0], atol=1e-4) and np.allclose(path["y"], ground[:, 1], atol=1e-4)
    assert path["customdata"] == list(range(180)) and chosen["customdata"] == list(range(30, 60))
    assert selected_part(curves, {"clip": "other", "start": 1, "end": 5}, "light")["x"] == []
    arrows = next(t for t in document["data"] if t.get("marker", {}).get("symbol") == "arrow")
    assert np.abs(np.array(arrows["marker"]["angle"])).min() > 150  # it goes along +Z, which is down
    feet = [t["name"] for t in document["data"] if "foot" in t.get("name", "")]
    assert feet == ["left foot stands", "right foot stands"]


def test_gait_in_words(curves):
    said = gait_table(curves.gait, "gait", 60.0)
    assert misfit(said, names.CLIP_GAIT_TABLE) is None
    assert said["bouts"][0]["title"] == "Walking" and "steps/min" in said["bouts"][0]["facts"]
    measures = [row[0] for row in said["bouts"][0]["rows"]]
    assert {"Cadence", "Stride length", "Stance"} <= set(measures) and all(
        len(row) == 7 for row in said["bouts"][0]["rows"]
    )
    assert len(said["events"]) == len(curves.gait.events)


def test_legend_and_controls_name_every_line(curves):
    chosen = clips.choice({"joints": "left_knee,trunk", "channels": "flexion,rotation"}, curves)
    panels = figures.panels_of(clips.chosen_curves(curves, chosen), chosen, "light")
    assert len(layout.legend(panels)) == 4
    assert [chip.value for chip in layout.channel_chips(chosen)] == ["flexion", "abduction", "rotation", "side bend"]
    assert {option["value"] for option in layout.joint_options(curves, chosen)} == set(curves.angle_joints)


@pytest.fixture
def client(dataset):
    server = Flask(__name__)
    known = {"walks": dataset}
    server.register_blueprint(clip_blueprint(known.__getitem__))
    return server.test_client()


def test_the_table_holds_the_selected_frames(client, curves):
    shown = {"dataset": "walks", "clip": "gait"}
    href = table.address(
        shown, {"clip": "gait", "start": 20, "end": 50}, ["feet", "speeds"], ["left_wrist", TRAVEL], False
    )
    answer = client.get(href)
    rows = list(csv.reader(io.StringIO(answer.text)))
    assert rows[0][:4] == ["frame", "time [s]", "left_wrist speed [m/s]", "travel speed [m/s]"] and len(rows) == 31
    assert [row[0] for row in rows[1:]] == [str(k) for k in range(20, 50)]
    assert np.allclose([float(row[2]) for row in rows[1:]], curves.speeds(["left_wrist"])[0].values[20:50], rtol=1e-4)
    assert "gait%2020-50.csv" in answer.headers["Content-Disposition"]
    whole = client.get(table.address(shown, {}, list(clips_columns()), None, True))
    assert len(whole.text.splitlines()) == 181 and "left_foot heel strike [0/1]" in whole.text.splitlines()[0]


def clips_columns():
    return table.COLUMNS


@pytest.mark.parametrize(
    ("address", "status", "why"),
    [
        ("walks/gait?columns=shoes", 400, "“shoes” is no kind of column"),
        ("walks/gait?joints=tail", 400, "no “tail”"),
        ("walks/gait?start=9&end=3", 400, "cannot show 9 to 3"),
        ("walks/none", 404, "no clip called “none”"),
        ("none/gait", 404, "no dataset called “none”"),
    ],
)
def test_what_cannot_be_answered_says_why(client, address, status, why):
    answer = client.get(f"/api/clip-table/{address}")
    assert answer.status_code == status and why in answer.json["error"]


def test_values_of_a_chart_are_all_its_numbers(client, curves):
    answer = client.get("/api/clip-values/walks/gait?joints=left_knee&channels=flexion,rotation")
    values = np.frombuffer(answer.data, "<f4").reshape(2, 180)
    assert np.allclose(values, [c.values for c in curves.angles(["left_knee"], ["flexion", "rotation"])])
    again = client.get(
        "/api/clip-values/walks/gait?joints=left_knee&channels=flexion,rotation",
        headers={"If-None-Match": answer.headers["ETag"]},
    )
    assert again.status_code == 304


def test_clip_names_with_slashes_and_quotes(dataset):
    address = table.address({"dataset": "a/b", "clip": 'x/y "1"'}, {}, ["feet"], None, True)
    assert address.startswith(f"/api/clip-table/a%2Fb/x/y%20{quote(chr(34))}1{quote(chr(34))}?")


def test_the_clip_of_a_selection(dataset):
    assert callbacks.clip_of(dataset, None, {"clip": "gait", "start": 1, "end": 5}) == "gait"
    assert callbacks.clip_of(dataset, None, {"motif": 3}) is None
    shown = {"clip": "gait", "frames": 180}
    assert editing.selected(shown, {"clip": "gait", "start": 5, "end": 500}) == (5, 180)
    assert editing.selected(shown, {"clip": "standing", "start": 5, "end": 9}) == (None, None)
    assert editing.selected(shown, {"clip": "gait"}) == (None, None)


@pytest.mark.parametrize(
    ("action", "options", "why"),
    [
        ("trim", {"start": 3, "end": 60}, ""),
        ("trim", {"start": None, "end": None}, "Select a range"),
        ("mirror", {}, ""),
        ("rate", {"fps": 60.0}, "already"),
        ("rate", {"fps": 0.0}, "from 1 to 1000"),
        ("split", {"frame": 90}, ""),
        ("split", {"frame": 0}, "nothing to cut"),
        ("labels", {}, ""),
    ],
)
def test_edits_that_cannot_be_made_are_refused_before_any_work(dataset, action, options, why):
    said = editing.problem(dataset, "gait", action, options)
    assert (why in said) if why else said == ""
    assert editing.problem(dataset, "none", "mirror", {}) == "This clip is no longer there."


def test_what_an_edit_means_for_results(tmp_path, dataset):
    workspace = Workspace(tmp_path)
    workspace.add_dataset("walks", dataset)
    assert "nothing else changes" in editing.effect(workspace, "walks", editing.HERE)
    assert "stay as they are" in editing.effect(workspace, "walks", editing.NEW)


def test_of_thousands_of_clips_those_near_the_shown_one_and_those_sought_are_offered():
    names = [f"take {k:05d}" for k in range(5000)]
    shown = callbacks.offered(names, "take 03000")
    at = shown.index("take 03000")
    assert len(shown) < 500 and shown[at - 1 : at + 2] == names[2999:3002]
    assert callbacks.offered(names, names[0])[0] == names[0] and callbacks.offered(names, names[-1])[-1] == names[-1]
    sought = callbacks.offered(names, "take 03000", "0471")
    assert {"take 04710", "take 04719", "take 03001"} <= set(sought) and sought == sorted(sought)
    assert callbacks.offered(names[:20], None) == names[:20]
