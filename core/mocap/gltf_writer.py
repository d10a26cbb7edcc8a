"""Clips as GLB: a skeleton, its motion, and a figure of sticks that moves with it, for Blender, three.js and others."""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.clip import Clip
from core.mocap.files import replacing
from core.mocap.skeleton import Skeleton

_THICK = 0.08  # of a bone's length: how far its widest place is from the middle
_WIDEST = 0.2  # of the way along a bone
_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_COLOUR = (0.24, 0.45, 0.75, 1.0)


class _Writer:
    """Collects arrays in one buffer."""

    def __init__(self) -> None:
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add(self, values: np.ndarray, kind: str, component: int, bounds: bool = False) -> int:
        """Number of the accessor of an array ``(count, ...)``."""
        dtype = {_FLOAT: "<f4", _SHORT: "<u2", _INT: "<u4"}[component]
        body = np.ascontiguousarray(values, dtype)
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": body.nbytes})
        self.data += body.tobytes() + bytes(-body.nbytes % 4)
        entry: dict[str, Any] = {
            "bufferView": len(self.views) - 1,
            "componentType": component,
            "count": len(body),
            "type": kind,
        }
        if bounds:
            flat = body.reshape(len(body), -1)
            entry |= {"min": flat.min(axis=0).tolist(), "max": flat.max(axis=0).tolist()}
        self.accessors.append(entry)
        return len(self.accessors) - 1


def write_glb(path: str | Path, clips: Clip | Sequence[Clip]) -> None:
    """Writes clips of one skeleton as GLB, each an animation; metres, Y up.

    The file appears whole or not at all. Raises ValueError where the skeletons differ, OSError where it cannot be
    written.
    """
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    skeleton = clips[0].skeleton
    if any(clip.skeleton != skeleton for clip in clips):
        raise ValueError("clips of one GLB file must have one skeleton")
    writer = _Writer()
    nodes = _nodes(skeleton, clips[0])
    mesh, skin = _figure(writer, skeleton), _skin(writer, skeleton)
    document = {
        "asset": {"version": "2.0", "generator": "Motionscape"},
        "scene": 0,
        "scenes": [{"nodes": [0, len(nodes)]}],
        "nodes": [*nodes, {"name": "figure", "mesh": 0, "skin": 0}],
        "meshes": [mesh],
        "skins": [skin],
        "materials": [{"name": "sticks", "pbrMetallicRoughness": {"baseColorFactor": _COLOUR, "metallicFactor": 0.0}}],
        "animations": [_animation(writer, clip) for clip in clips],
        "buffers": [{"byteLength": len(writer.data)}],
        "bufferViews": writer.views,
        "accessors": writer.accessors,
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(writer.data)
    with replacing(path) as fresh, fresh.open("wb") as file:
        file.write(struct.pack("<4sII", b"glTF", 2, size))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(writer.data), 0x004E4942) + bytes(writer.data))


def _nodes(skeleton: Skeleton, first: Clip) -> list[dict[str, Any]]:
    nodes: list[dict[str, Any]] = []
    for j, name in enumerate(skeleton.names):
        place = first.root_positions[0] if j == 0 else skeleton.offsets[j]
        node: dict[str, Any] = {"name": name, "translation": [float(v) for v in place]}
        if children := skeleton.children(j):
            node["children"] = children
        nodes.append(node)
    return nodes


def _at_rest(skeleton: Skeleton) -> np.ndarray:
    places = np.zeros((skeleton.n_joints, 3))
    for j, parent in enumerate(skeleton.parents):
        if parent >= 0:
            places[j] = places[parent] + skeleton.offsets[j]
    return places


def _skin(writer: _Writer, skeleton: Skeleton) -> dict[str, Any]:
    matrices = np.tile(np.eye(4), (skeleton.n_joints, 1, 1))
    matrices[:, 3, :3] = -_at_rest(skeleton)  # column by column
    bind = writer.add(matrices.reshape(-1, 16), "MAT4", _FLOAT)
    return {"joints": list(range(skeleton.n_joints)), "skeleton": 0, "inverseBindMatrices": bind}


def _figure(writer: _Writer, skeleton: Skeleton) -> dict[str, Any]:
    """A double pyramid for each bone, which follows the joint that it begins at."""
    places = _at_rest(skeleton)
    corners: list[np.ndarray] = []
    joints: list[int] = []
    faces: list[int] = []
    for j, parent in enumerate(skeleton.parents):
        bone = places[j] - places[max(parent, 0)]
        length = float(np.linalg.norm(bone))
        if parent < 0 or length < 1e-6:
            continue
        across = np.cross(bone, np.eye(3)[np.abs(bone).argmin()])
        across *= _THICK * length / np.linalg.norm(across)
        other = np.cross(bone, across) / length
        middle = places[parent] + _WIDEST * bone
        ring = [middle + across, middle + other, middle - across, middle - other]
        start = len(corners)
        corners += [places[parent], *ring, places[j]]
        joints += [parent] * 6
        for k in range(4):
            a, b = start + 1 + k, start + 1 + (k + 1) % 4
            faces += [start, b, a, start + 5, a, b]
    if not corners:  # a single joint
        corners, joints, faces = [places[0]] * 3, [0, 0, 0], [0, 1, 2]
    index = np.zeros((len(corners), 4))
    index[:, 0] = joints
    weights = np.zeros((len(corners), 4))
    weights[:, 0] = 1
    attributes = {
        "POSITION": writer.add(np.array(corners), "VEC3", _FLOAT, bounds=True),
        "JOINTS_0": writer.add(index, "VEC4", _SHORT),
        "WEIGHTS_0": writer.add(weights, "VEC4", _FLOAT),
    }
    indices = writer.add(np.array(faces), "SCALAR", _INT)
    return {"name": "figure", "primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}


def _animation(writer: _Writer, clip: Clip) -> dict[str, Any]:
    times = writer.add(np.arange(clip.n_frames) / clip.fps, "SCALAR", _FLOAT, bounds=True)
    samplers: list[dict[str, Any]] = []
    channels: list[dict[str, Any]] = []

    def channel(joint: int, path: str, values: np.ndarray, kind: str) -> None:
        samplers.append({"input": times, "output": writer.add(values, kind, _FLOAT), "interpolation": "LINEAR"})
        channels.append({"sampler": len(samplers) - 1, "target": {"node": joint, "path": path}})

    channel(0, "translation", np.asarray(clip.root_positions), "VEC3")
    for j, track in clip.translations.items():
        channel(j, "translation", np.asarray(track), "VEC3")
    for j in range(clip.skeleton.n_joints):
        if not clip.skeleton.end_sites[j]:
            turns = np.asarray(clip.rotations[:, j], float)
            turns = turns / np.linalg.norm(turns, axis=1, keepdims=True)
            channel(j, "rotation", np.roll(turns, -1, axis=1), "VEC4")
    return {"name": clip.name, "samplers": samplers, "channels": channels}
