"""The motion route: what the Stage gets, and what it is told when it asks for nonsense."""

from __future__ import annotations

import json
from dataclasses import replace
from urllib.parse import quote

import numpy as np
import pytest
from flask import Flask

from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.mocap.kinematics import joint_positions
from core.mocap.posture_drawing import drawn_body, drawn_positions, facing
from core.mocap.skeleton import Skeleton
from core.workspace import WorkspaceError
from tests.webapp.generated import person, walk, walkers
from webapp.stage import motion_routes as motion_api
from webapp.stage.filmstrip_routes import filmstrip_blueprint
from webapp.stage.motion_routes import motion_blueprint

STRANGE = ("a b/c", "up//down", "Ünïcødé 歩く", "100%", "what?#&=+", "..", "<script>")


@pytest.fixture
def datasets() -> dict[str, Dataset]:
    return {"walkers": walkers(("walk", "fast", *STRANGE), fps=120.0, seconds=2.0)}


@pytest.fixture
def client(datasets):
    def open_dataset(name: str) -> Dataset:
        if name == "broken":
            raise ZeroDivisionError("secret internals")
        if name == "damaged":
            raise WorkspaceError("The files of “damaged” are damaged; import it again.")
        return datasets[name]

    app = Flask(__name__)
    app.register_blueprint(motion_blueprint(open_dataset))
    app.register_blueprint(filmstrip_blueprint(open_dataset))
    return app.test_client()


def parse(data: bytes) -> tuple[dict, np.ndarray]:
    length = int(np.frombuffer(data, "<u4", 1)[0])
    assert (4 + length) % 4 == 0
    header = json.loads(data[4 : 4 + length])
    shape = header["frames"], len(header["joints"]), 3
    return header, np.frombuffer(data, "<f4", offset=4 + length).reshape(shape)


def test_positions_are_those_of_forward_kinematics(client, datasets):
    header, positions = parse(client.get("/api/motion/walkers/fast").data)
    clip = datasets["walkers"].clip("fast")
    expected = joint_positions(clip)[:: header["step"]]
    for drawn, name in enumerate(header["joints"]):
        if name in clip.skeleton.names:
            np.testing.assert_allclose(positions[:, drawn], expected[:, clip.skeleton.index(name)], atol=1e-6)
    assert (header["clip"], header["start"], header["end"]) == ("fast", 0, 240)


def test_header_describes_the_drawn_body(client):
    header, positions = parse(client.get("/api/motion/walkers/walk").data)
    joints = header["joints"]
    assert all(len(header[key]) == len(joints) for key in ("parents", "sides", "roles"))
    assert all(parent < joint for joint, parent in enumerate(header["parents"]))
    assert header["parents"][header["root"]] == -1
    assert [header["sides"][joints.index(n)] for n in ("LeftLeg", "RightArm", "Spine1")] == ["left", "right", "centre"]
    assert {header["roles"][j] for j in header["feet"]} >= {"left_ankle", "right_toe"}
    assert "LeftThumb" not in joints and "LeftHipJoint" not in joints
    knee = joints.index("LeftLeg")
    assert joints[header["parents"][knee]] == "LeftUpLeg"
    assert 1.5 < header["height"] < 2.0
    nose = positions[0, header["nose"]] - positions[0, header["head"]]
    assert nose[2] > 0.8 * np.linalg.norm(nose), "the nose points where the walker goes: +Z"
    assert positions[0, header["head"], 1] > positions[0, joints.index("Head"), 1]


@pytest.mark.parametrize(("query", "step", "frames"), [("", 2, 120), ("?fps=30", 4, 60), ("?fps=500", 1, 240)])
def test_rate_is_an_integer_part_of_the_recorded_one(client, query, step, frames):
    header, positions = parse(client.get(f"/api/motion/walkers/walk{query}").data)
    assert (header["step"], header["frames"], header["fps"]) == (step, frames, 120 / step)
    assert len(positions) == frames


def test_rates_just_above_sixty_are_not_halved(client, datasets):
    datasets["walkers"] = walkers(("walk",), fps=60.0006)
    assert parse(client.get("/api/motion/walkers/walk").data)[0]["step"] == 1


def test_interval_is_cut_from_the_whole(client):
    _, whole = parse(client.get("/api/motion/walkers/walk?fps=120").data)
    header, part = parse(client.get("/api/motion/walkers/walk?start=31&end=77&fps=120").data)
    np.testing.assert_array_equal(part, whole[31:77])
    assert (header["start"], header["end"]) == (31, 77)


def test_only_the_interval_is_computed(client, monkeypatch):
    seen = []
    original = motion_api.drawn_positions
    monkeypatch.setattr(motion_api, "drawn_positions", lambda *a: seen.append(a[1:]) or original(*a))
    client.get("/api/motion/walkers/walk?start=10&end=20")
    assert seen == [(10, 20, 2)]


def test_long_recordings_arrive_at_a_lower_rate(client, monkeypatch):
    monkeypatch.setattr(motion_api, "MAX_VALUES", 33 * 3 * 50)
    header, positions = parse(client.get("/api/motion/walkers/walk").data)
    assert header["step"] == 5 and len(positions) == 48


@pytest.mark.parametrize("name", STRANGE)
def test_clip_names_may_hold_anything(client, name):
    response = client.get(f"/api/motion/walkers/{quote(name, safe='')}")
    assert response.status_code == 200
    assert parse(response.data)[0]["clip"] == name


@pytest.mark.parametrize(
    ("path", "status", "words"),
    [
        ("/api/motion/nobody/walk", 404, "no dataset called “nobody”"),
        ("/api/motion/walkers/swim", 404, "no clip called “swim”"),
        ("/api/motion/damaged/walk", 404, "import it again"),
        ("/api/motion/walkers/walk?start=5&end=5", 400, "frames 0 to 240"),
        ("/api/motion/walkers/walk?start=-3", 400, "frames 0 to 240"),
        ("/api/motion/walkers/walk?end=241", 400, "cannot show 0 to 241"),
        ("/api/motion/walkers/walk?start=x", 400, "start must be a whole number"),
        ("/api/motion/walkers/walk?start=-", 400, "start must be a whole number"),
        ("/api/motion/walkers/walk?end=99999999999999999999", 400, "end must be a whole number"),
        ("/api/motion/walkers/walk?start=²", 400, "start must be a whole number"),
        ("/api/motion/walkers/walk?fps=0", 400, "fps must be a positive number"),
        ("/api/motion/walkers/walk?fps=nan", 400, "fps must be a positive number"),
        ("/api/motion/walkers/walk?fps=inf", 400, "fps must be a positive number"),
        ("/api/filmstrip/walkers/walk?n=0", 400, "n must be between"),
        ("/api/filmstrip/walkers/walk?n=1000", 400, "n must be between"),
        ("/api/icon/walkers/walk?scheme=pink", 400, "scheme must be one of"),
    ],
)
def test_errors_are_json_in_plain_words(client, path, status, words):
    response = client.get(path)
    assert response.status_code == status
    assert words in response.get_json()["error"]


def test_failures_do_not_tell_internals(client):
    response = client.get("/api/motion/broken/walk")
    assert response.status_code == 500
    assert "secret" not in response.text and "Traceback" not in response.text
    assert response.get_json()["error"]


def test_tiny_rates_send_a_frame(client):
    header, positions = parse(client.get("/api/motion/walkers/walk?fps=1e-300").data)
    assert header["frames"] == len(positions) == 1


def test_unchanged_motion_is_not_sent_again(client, datasets):
    first = client.get("/api/motion/walkers/walk")
    again = client.get("/api/motion/walkers/walk", headers={"If-None-Match": first.headers["ETag"]})
    assert (again.status_code, again.data) == (304, b"")
    assert client.get("/api/motion/walkers/walk?end=9").headers["ETag"] != first.headers["ETag"]
    datasets["walkers"] = Dataset("walkers", (walk("walk", pace=2.0),))  # the name now stands for other content
    assert client.get("/api/motion/walkers/walk", headers={"If-None-Match": first.headers["ETag"]}).status_code == 200


def test_who_names_the_content_need_not_ask_again(client, datasets):
    version = datasets["walkers"].fingerprint[:8]
    assert "immutable" in client.get(f"/api/motion/walkers/walk?v={version}").headers["Cache-Control"]
    assert "no-cache" in client.get("/api/motion/walkers/walk?v=00000000").headers["Cache-Control"]
    assert "no-cache" in client.get("/api/motion/walkers/walk?v=").headers["Cache-Control"]


def test_facing_follows_the_turn():
    for turn in (0.0, 1.0, -2.5, 3.1):
        positions, body, _ = drawn_positions(walk(turn=turn), 0, 3)
        np.testing.assert_allclose(facing(positions, body)[0], [np.sin(turn), 0, np.cos(turn)], atol=1e-5)


def test_an_unknown_body_is_drawn_whole():
    chain = Skeleton(tuple(f"j{k}" for k in range(5)), (-1, 0, 1, 2, 3), np.ones((5, 3)))
    rotations = np.tile(np.float32([1, 0, 0, 0]), (4, 5, 1))
    positions, body, _ = drawn_positions(Clip("chain", chain, 30.0, np.zeros((4, 3), np.float32), rotations), 0, 4)
    assert body.names == chain.names and positions.shape == (4, 5, 3)
    assert body.find("nose") == -1 and not facing(positions, body).any()


def test_fingers_are_drawn_as_one_tip():
    body = drawn_body(person())
    tips = [body.names[body.find(role)] for role in ("left_hand", "right_hand")]
    assert tips == ["LeftHandIndex1", "RightHandIndex1"]


def test_moving_offsets_are_used(client, datasets):
    clip = walk("stretch", fps=60.0)
    track = np.tile(np.float32([0.2, 0.9, 0.0]), (clip.n_frames, 1))
    datasets["walkers"] = Dataset("walkers", (replace(clip, translations={clip.skeleton.index("Spine"): track}),))
    header, positions = parse(client.get("/api/motion/walkers/stretch?start=30&end=40").data)
    assert positions[0, header["joints"].index("Head"), 1] > 1.9


def test_real_skeletons_lose_fingers_and_faces(shared_data):
    from core.mocap.bvh import read_bvh

    clip = read_bvh(shared_data / "cmu" / "bvh" / "001_01.bvh")
    positions, body, _ = drawn_positions(clip, 0, 10)
    assert clip.skeleton.n_joints > 90 and len(body.names) < 32
    assert not any(("Twist" in n and "Neck" not in n) or "Eye" in n or "Thumb" in n for n in body.names)
    assert np.isfinite(positions).all()
