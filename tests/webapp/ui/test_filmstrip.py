"""Filmstrips and icons: which poses, and SVG that is well formed whatever the names."""

from __future__ import annotations

from itertools import pairwise
from urllib.parse import unquote
from xml.etree import ElementTree

import numpy as np
import pytest
from flask import Flask

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.posture_drawing import drawn_positions
from tests.webapp.generated import walk, walkers
from webapp.stage.filmstrip_routes import filmstrip_blueprint
from webapp.ui.filmstrip import ICON_COLOURS, icon_data_uri, key_frames, segment_filmstrip, turn_to_viewer

NAMESPACE = "{http://www.w3.org/2000/svg}"


def poses_of(svg: str) -> list[ElementTree.Element]:
    return ElementTree.fromstring(svg).findall(f"{NAMESPACE}g")


def test_key_frames_follow_the_path_not_the_clock():
    rest, move = np.zeros((100, 3, 3)), np.zeros((50, 3, 3))
    move[:, 1, 0] = np.linspace(0, 1, 50)
    end = np.broadcast_to(move[-1], (100, 3, 3))
    chosen = key_frames(np.concatenate([rest, move, end]), 6)
    assert chosen[0] == 0 and len(chosen) == 6
    assert ((chosen[1:] >= 100) & (chosen[1:] < 151)).all(), "pauses get no poses of their own"
    assert np.ptp(np.diff(chosen[1:])) <= 2


@pytest.mark.parametrize(("frames", "n"), [(1, 6), (2, 6), (5, 1), (100, 6)])
def test_still_and_short_motions_have_key_frames(frames, n):
    chosen = key_frames(np.ones((frames, 4, 3)), n)
    assert 1 <= len(chosen) <= min(frames, n)
    assert chosen[0] == 0 and chosen[-1] < frames


def test_strip_has_the_asked_poses_and_a_size():
    svg = segment_filmstrip(walkers(), Segment("walk", 0, 200), 7)
    root = ElementTree.fromstring(svg)
    assert len(poses_of(svg)) == 7
    assert float(root.get("width")) > 2 * float(root.get("height")) > 150
    assert len(svg) < 12_000


def test_left_and_right_have_their_own_colours():
    svg = segment_filmstrip(walkers(), Segment("walk", 0, 60), 1)
    for side in ("left", "right"):
        assert f"ms-strip-{side}" in svg and f"var(--ms-{side}," in svg


def test_poses_do_not_overlap():
    svg = segment_filmstrip(walkers(), Segment("walk", 0, 200), 6)
    starts = [float(g.get("transform").split("(")[1].split()[0]) for g in poses_of(svg)]
    assert all(b - a >= 25 for a, b in pairwise(starts))


def test_first_pose_is_seen_from_the_same_side_whatever_its_heading():
    views = []
    for turn in (0.0, 2.0, -1.0):
        positions, body, _ = drawn_positions(walk(turn=turn), 0, 5)
        views.append(turn_to_viewer(positions.astype(float), body))
    np.testing.assert_allclose(views[1], views[0], atol=1e-4)
    np.testing.assert_allclose(views[2], views[0], atol=1e-4)
    nose, head = body.find("nose"), body.find("head_centre")
    assert views[0][0, nose, 0] > views[0][0, head, 0] and views[0][0, nose, 2] > views[0][0, head, 2]


@pytest.mark.parametrize("name", ["<script>alert(1)</script>", 'a"b&c', "x\u0000y\ufffe", "a/b 歩"])
def test_names_are_escaped(name):
    svg = segment_filmstrip(Dataset("d", (walk(name),)), Segment(name, 0, 20), 3)
    title = ElementTree.fromstring(svg).find(f"{NAMESPACE}title").text
    assert "<script" not in svg
    assert title.startswith(name.replace("\u0000", "?").replace("\ufffe", "?"))


def test_icon_carries_its_colours():
    for scheme, colours in ICON_COLOURS.items():
        uri = icon_data_uri(walkers(), Segment("walk", 10, 50), scheme)
        assert uri.startswith("data:image/svg+xml;utf8,") and "#" not in uri
        svg = unquote(uri.split(",", 1)[1])
        root = ElementTree.fromstring(svg)
        assert root.get("width") == root.get("height")
        assert all(colour in svg for colour in colours.values()) and "var(" not in svg


def test_routes_serve_svg():
    app = Flask(__name__)
    app.register_blueprint(filmstrip_blueprint({"walkers": walkers()}.__getitem__))
    client = app.test_client()
    strip = client.get("/api/filmstrip/walkers/walk?start=5&end=100&n=4")
    assert strip.mimetype == "image/svg+xml" and len(poses_of(strip.text)) == 4
    assert client.get("/api/icon/walkers/walk?scheme=dark").text.startswith("<svg")
    again = client.get(
        "/api/filmstrip/walkers/walk?start=5&end=100&n=4", headers={"If-None-Match": strip.headers["ETag"]}
    )
    assert again.status_code == 304
