"""glTF: what is written comes back; scaled nodes, splines, sparse numbers, VRM's humanoid; damaged files."""

from __future__ import annotations

import base64
import json
import struct
from dataclasses import replace

import numpy as np
import pytest

from core.inspection import inspect_recording
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.dataset import open_dataset
from core.mocap.errors import RecordingError
from core.mocap.gltf_writer import write_glb
from core.mocap.kinematics import joint_positions
from core.mocap.skeleton import Skeleton
from tests.core.mocap.points.walker import figure

TURN = [0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5)]  # a quarter about Z, (x, y, z, w)


def document(arrays: list[np.ndarray], animation: dict, nodes: list[dict], **more) -> str:
    """A .gltf with its numbers inside; arrays are float32 accessors in order."""
    data, views, accessors = b"", [], []
    kinds = {1: "SCALAR", 3: "VEC3", 4: "VEC4"}
    for array in arrays:
        body = np.asarray(array, "<f4").reshape(len(array), -1)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": body.nbytes})
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": 5126, "count": len(body), "type": kinds[body.shape[1]]}
        )
        data += body.tobytes()
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    base = {"asset": {"version": "2.0"}, "nodes": nodes, "animations": [animation], "bufferViews": views}
    base |= {"accessors": accessors, "buffers": [{"uri": uri, "byteLength": len(data)}]}
    return json.dumps(base | more)


def channel(sampler: int, node: int, path: str) -> dict:
    return {"sampler": sampler, "target": {"node": node, "path": path}}


def test_what_is_written_comes_back(tmp_path):
    clip = figure(50, 24.0)
    write_glb(tmp_path / "walk.glb", clip)
    report, facts = inspect_recording(tmp_path / "walk.glb")
    assert (facts.frames, facts.fps, facts.body, facts.unit, facts.up) == (50, 24.0, "human", "m", "y"), report.messages
    (back,) = open_dataset(tmp_path / "walk.glb").clips
    assert back.skeleton.names == clip.skeleton.names
    assert np.abs(joint_positions(back) - joint_positions(clip)).max() < 1e-4


def test_tips_tracks_and_several_animations_come_back(tmp_path):
    skeleton = Skeleton(
        ("hips", "arm", "arm_end"), (-1, 0, 1), np.array([[0, 0, 0], [0, 1, 0], [0, 0.5, 0]]), (False, False, True)
    )
    still = np.zeros((8, 3, 4), np.float32)
    still[..., 0] = 1
    track = np.linspace([0, 1, 0], [0, 2, 0], 8).astype(np.float32)
    one = Clip("a", skeleton, 30.0, np.zeros((8, 3), np.float32), still, {1: track})
    write_glb(tmp_path / "two.glb", [one, replace(one, name="b", translations={})])
    a, b = open_dataset(tmp_path / "two.glb").clips
    assert (a.name, b.name) == ("two a", "two b")
    assert np.abs(joint_positions(a) - joint_positions(one)).max() < 1e-5
    assert a.skeleton.end_sites == (False, False, True) and set(a.translations) == {1} and not b.translations
    with pytest.raises(ValueError, match="one skeleton"):
        write_glb(tmp_path / "x.glb", [one, figure(8)])


def test_scaled_and_turned_nodes_above_carry_the_figure(tmp_path):
    nodes = [
        {"name": "armature", "scale": [0.01, 0.01, 0.01], "rotation": TURN, "children": [1]},
        {"name": "hips", "translation": [100, 0, 0], "children": [2]},
        {"name": "knee", "translation": [0, 50, 0]},
    ]
    animation = {"name": "a", "samplers": [{"input": 0, "output": 1}], "channels": [channel(0, 1, "translation")]}
    times, places = np.array([0, 0.5, 1]), np.array([[100, 0, 0], [200, 0, 0], [300, 0, 0]])
    (tmp_path / "a.gltf").write_text(document([times, places], animation, nodes, skins=[{"joints": [1, 2]}]))
    (clip,) = open_dataset(tmp_path / "a.gltf", fps=4).clips
    at = joint_positions(clip)
    # a quarter about Z brings X to Y and Y to -X
    assert np.allclose(at[:, 0], np.stack([np.zeros(5), np.linspace(1, 3, 5), np.zeros(5)], axis=1), atol=1e-5)
    assert np.allclose(at[:, 1] - at[:, 0], [-0.5, 0, 0], atol=1e-5)


@pytest.mark.parametrize(("joined", "middle"), [("LINEAR", 0.5), ("STEP", 0.0), ("CUBICSPLINE", 0.5 + 0.125)])
def test_key_frames_are_joined_as_the_file_says(tmp_path, joined, middle):
    keys = np.array([[0.0, 0, 0], [1, 0, 0]])
    if joined == "CUBICSPLINE":  # arrives, is, leaves: leaving at 1 a second and arriving at rest
        keys = np.array([[0, 0, 0], [0, 0, 0], [1, 0, 0], [0, 0, 0], [1, 0, 0], [0, 0, 0]], float)
    animation = {
        "samplers": [{"input": 0, "output": 1, "interpolation": joined}],
        "channels": [channel(0, 0, "translation")],
    }
    nodes = [{"name": "hips", "children": [1]}, {"name": "tip", "translation": [0, 1, 0]}]
    (tmp_path / "a.gltf").write_text(document([np.array([0, 1.0]), keys], animation, nodes, skins=[{"joints": [0, 1]}]))
    (clip,) = open_dataset(tmp_path / "a.gltf", fps=2).clips
    assert np.allclose(clip.root_positions[:, 0], [0, middle, 1], atol=1e-6)


def test_sparse_and_normalised_numbers(tmp_path):
    times = np.array([0, 1 / 30, 2 / 30], "<f4")
    index, value = np.array([1], "<u2"), np.array([[0, 7, 0]], "<f4")
    turns = np.array([[0, 0, 0, 32767]] * 3, "<i2")
    blob = times.tobytes() + index.tobytes() + b"\0\0" + value.tobytes() + turns.tobytes()
    views = [{"buffer": 0, "byteOffset": o, "byteLength": n} for o, n in ((0, 12), (12, 2), (16, 12), (28, 24))]
    sparse = {"count": 1, "indices": {"bufferView": 1, "componentType": 5123}, "values": {"bufferView": 2}}
    accessors = [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR"},
        {"componentType": 5126, "count": 3, "type": "VEC3", "sparse": sparse},
        {"bufferView": 3, "componentType": 5122, "normalized": True, "count": 3, "type": "VEC4"},
    ]
    uri = "data:;base64," + base64.b64encode(blob).decode()
    samplers = [{"input": 0, "output": 1}, {"input": 0, "output": 2}]
    channels = [channel(0, 0, "translation"), channel(1, 1, "rotation")]
    whole = {"asset": {"version": "2.0"}, "nodes": [{"name": "hips", "children": [1]}, {"translation": [0, 1, 0]}]}
    whole |= {"accessors": accessors, "bufferViews": views, "buffers": [{"uri": uri, "byteLength": len(blob)}]}
    whole |= {"animations": [{"samplers": samplers, "channels": channels}]}
    (tmp_path / "a.gltf").write_text(json.dumps(whole))
    (clip,) = open_dataset(tmp_path / "a.gltf").clips
    assert clip.fps == 30.0 and np.allclose(clip.root_positions[:, 1], [0, 7, 0])


def with_json(data: bytes, change) -> bytes:
    """A GLB file with its JSON changed."""
    length = struct.unpack_from("<I", data, 12)[0]
    text = json.dumps(change(json.loads(data[20 : 20 + length]))).encode()
    text += b" " * (-len(text) % 4)
    rest = data[20 + length :]
    return (
        struct.pack("<4sII", b"glTF", 2, 20 + len(text) + len(rest))
        + struct.pack("<II", len(text), 0x4E4F534A)
        + text
        + rest
    )


@pytest.mark.parametrize("version", ["VRM", "VRMC_vrm", "VRMC_vrm_animation"])
def test_the_humanoid_of_vrm_says_which_joint_is_which(tmp_path, version):
    clip = figure(20)
    names = [f"bone{k}" for k in range(clip.skeleton.n_joints)]
    write_glb(tmp_path / "a.glb", replace(clip, skeleton=replace(clip.skeleton, names=tuple(names))))
    bones = {"hips": "pelvis", "spine": "spine", "chest": "chest", "neck": "neck", "head": "head"}
    for side in ("left", "right"):
        pairs = {"UpperLeg": "hip", "LowerLeg": "knee", "Foot": "ankle", "Toes": "toe", "UpperArm": "shoulder"}
        pairs |= {"LowerArm": "elbow", "Hand": "wrist", "Shoulder": "clavicle"}
        bones |= {f"{side}{bone}": f"{side}_{role}" for bone, role in pairs.items()}
    place = {bone: clip.skeleton.names.index(role) for bone, role in bones.items()}

    def change(document):
        listed = [{"bone": bone, "node": node} for bone, node in place.items()]
        human = listed if version == "VRM" else {bone: {"node": node} for bone, node in place.items()}
        return document | {"extensions": {version: {"humanoid": {"humanBones": human}}}}

    (tmp_path / "b.vrm").write_bytes(with_json((tmp_path / "a.glb").read_bytes(), change))
    (back,) = open_dataset(tmp_path / "b.vrm").clips
    anatomy = find_anatomy(back.skeleton)
    assert anatomy.body == "human"
    for role in ("left_knee", "right_wrist", "left_toe", "head"):
        assert back.skeleton.names[anatomy.joints[role]] == names[clip.skeleton.names.index(role)]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d: d | {"animations": []}, "without motion"),
        (lambda d: d | {"nodes": [{"children": [0]}]}, "no tree"),
        (lambda d: d | {"accessors": [{"count": 10**12, "type": "VEC3", "componentType": 5126}]}, "accessor|accessors"),
        (lambda d: d | {"bufferViews": [v | {"byteOffset": 10**9} for v in d["bufferViews"]]}, "beyond its buffer"),
        (lambda d: d | {"asset": {"version": "1.0"}}, r"glTF 1\.0"),
    ],
)
def test_damaged_files_say_what_is_wrong(tmp_path, change, words):
    write_glb(tmp_path / "a.glb", figure(10))
    (tmp_path / "b.glb").write_bytes(with_json((tmp_path / "a.glb").read_bytes(), change))
    with pytest.raises(RecordingError, match=words):
        open_dataset(tmp_path / "b.glb")


def test_buffers_outside_the_folder_are_not_read(tmp_path):
    (tmp_path / "secret.bin").write_bytes(bytes(1000))
    (tmp_path / "in").mkdir()
    animation = {"samplers": [{"input": 0, "output": 1}], "channels": [channel(0, 0, "translation")]}
    text = json.loads(document([np.zeros(2), np.zeros((2, 3))], animation, [{"name": "a"}]))
    text["buffers"] = [{"uri": "../secret.bin", "byteLength": 1000}]
    (tmp_path / "in" / "a.gltf").write_text(json.dumps(text))
    with pytest.raises(RecordingError, match="not beside it"):
        open_dataset(tmp_path / "in" / "a.gltf")


@pytest.mark.parametrize(("name", "clips", "joints"), [("fox", 14, 48), ("bird", 5, 54)])
def test_the_samples_are_read(shared_data, name, clips, joints):
    dataset = open_dataset(shared_data / "formats" / f"{name}.glb")
    assert len(dataset.clips) == clips and {clip.skeleton.n_joints for clip in dataset.clips} == {joints}
    assert all(np.isfinite(joint_positions(clip)).all() for clip in dataset.clips)
