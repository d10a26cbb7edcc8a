"""Nodes of a glTF file and how an animation moves them: world places and rotations of joints in every frame."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.errors import RecordingError
from core.mocap.gltf_file import Gltf
from core.mocap.points.solving import from_matrices

MOST_NODES = 4000
_PATHS = {"translation": 3, "rotation": 4, "scale": 3}
_BLOCK = 512  # frames worked on at a time


@dataclass(frozen=True, eq=False)
class Nodes:
    """names, and parents (-1 for those at the top) of all nodes; order: parents first; rest: (3 + 4 + 3,) of each:
    translation, rotation (w, x, y, z), scale."""

    names: tuple[str, ...]
    parents: tuple[int, ...]
    order: tuple[int, ...]
    rest: tuple[tuple[np.ndarray, np.ndarray, np.ndarray], ...]


@dataclass(frozen=True, eq=False)
class Track:
    """Key frames of one property of a node: times (k,), values (k, 3 or 4), and how they are joined."""

    times: np.ndarray
    values: np.ndarray
    joined: str


Tracks = Mapping[tuple[int, str], Track]


def read_nodes(file: Gltf) -> Nodes:
    """The tree of nodes. Raises RecordingError where it is none."""
    entries = file.list_of("nodes")
    if not entries or len(entries) > MOST_NODES:
        raise RecordingError(file.path, f"{len(entries)} nodes", f"from 1 to {MOST_NODES}")
    parents = [-1] * len(entries)
    for k, entry in enumerate(entries):
        for child in entry.get("children") or () if isinstance(entry.get("children"), list) else ():
            if not isinstance(child, int) or not 0 <= child < len(entries) or parents[child] >= 0 or child == k:
                raise RecordingError(file.path, "nodes that are no tree", "a whole glTF file")
            parents[child] = k
    order: list[int] = [k for k, parent in enumerate(parents) if parent < 0]
    for k in order:
        order += [j for j, parent in enumerate(parents) if parent == k]
    if len(order) < len(entries):
        raise RecordingError(file.path, "nodes that are their own parents", "a tree of nodes")
    names = [str(entry.get("name") or f"node {k}")[:200] for k, entry in enumerate(entries)]
    once = [name if names.index(name) == k else f"{name} {k}" for k, name in enumerate(names)]
    if all(parent < k for k, parent in enumerate(parents)):
        order.sort()  # as the file has them
    return Nodes(tuple(once), tuple(parents), tuple(order), tuple(_rest(file, entry) for entry in entries))


def _rest(file: Gltf, entry: dict[str, Any]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    if "matrix" in entry:
        matrix = _vector(file, entry["matrix"], 16, None).reshape(4, 4).T
        scale = np.linalg.norm(matrix[:3, :3], axis=0)
        if np.linalg.det(matrix[:3, :3]) < 0:
            scale[0] = -scale[0]
        turn = _rotations((matrix[:3, :3] / np.where(scale == 0, 1, scale))[None])[0]
        return matrix[:3, 3], turn, scale
    place = _vector(file, entry.get("translation"), 3, [0, 0, 0])
    turn = np.roll(_vector(file, entry.get("rotation"), 4, [0, 0, 0, 1]), 1)
    return place, _unit(turn[None])[0], _vector(file, entry.get("scale"), 3, [1, 1, 1])


def _vector(file: Gltf, value: Any, size: int, default: Sequence[float] | None) -> np.ndarray:
    given = default if value is None else value
    if not isinstance(given, list | tuple) or len(given) != size or not all(isinstance(v, int | float) for v in given):
        raise RecordingError(file.path, "a node whose place is no vector", "numbers")
    vector = np.array(given, float)
    if not np.isfinite(vector).all() or np.abs(vector).max() > 1e9:
        raise RecordingError(file.path, "a node whose place is out of range", "numbers")
    return vector


def _unit(q: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(q, axis=-1, keepdims=True)
    return np.where(length > 1e-9, q / np.maximum(length, 1e-9), [1.0, 0, 0, 0])


def read_tracks(file: Gltf, animation: dict[str, Any]) -> dict[tuple[int, str], Track]:
    """(node, property) -> its key frames, of one animation. Raises RecordingError."""
    samplers = [s for s in animation.get("samplers") or () if isinstance(s, dict)]
    tracks: dict[tuple[int, str], Track] = {}
    for channel in animation.get("channels") or ():
        target = channel.get("target") if isinstance(channel, dict) else None
        if not isinstance(target, dict) or target.get("path") not in _PATHS or not isinstance(target.get("node"), int):
            continue
        if not isinstance(channel.get("sampler"), int) or not 0 <= channel["sampler"] < len(samplers):
            raise RecordingError(file.path, "an animation without its key frames", "a whole glTF file")
        sampler = samplers[channel["sampler"]]
        joined = str(sampler.get("interpolation") or "LINEAR")
        times, values = file.accessor(sampler.get("input"))[:, 0], file.accessor(sampler.get("output"))
        size = _PATHS[target["path"]]
        keys = 3 * len(times) if joined == "CUBICSPLINE" else len(times)
        if values.shape != (keys, size) or not len(times):
            raise RecordingError(
                file.path, f"{len(times)} times and {len(values)} values of an animation", "equal numbers"
            )
        if (
            not (np.isfinite(times).all() and np.isfinite(values).all())
            or (np.diff(times) < 0).any()
            or np.abs(values).max() > 1e9
        ):
            raise RecordingError(
                file.path, "times or values of an animation that are none", "rising times, and numbers"
            )
        if target["path"] == "rotation":
            values = np.roll(values, 1, axis=1)
        tracks[target["node"], target["path"]] = Track(times, values, joined)
    return tracks


def sampled(track: Track, at: np.ndarray, is_rotation: bool) -> np.ndarray:
    """Values ``(n, 3 or 4)`` of a track at the times ``at`` (n,)."""
    times = track.times
    after = np.clip(np.searchsorted(times, at + 1e-6, side="right"), 0, len(times) - 1)
    before = np.clip(np.searchsorted(times, at + 1e-6, side="right") - 1, 0, len(times) - 1)
    step = (times[after] - times[before])[:, None]
    share = np.clip((at - times[before])[:, None] / np.where(step > 0, step, 1), 0, 1)
    if track.joined == "CUBICSPLINE":
        keys = track.values.reshape(len(times), 3, -1)
        a, b = keys[before, 1], keys[after, 1]
        leave, arrive = keys[before, 2] * step, keys[after, 0] * step
        s2, s3 = share**2, share**3
        values = (2 * s3 - 3 * s2 + 1) * a + (s3 - 2 * s2 + share) * leave + (3 * s2 - 2 * s3) * b + (s3 - s2) * arrive
        return _unit(values) if is_rotation else values
    a, b = track.values[before], track.values[after]
    if track.joined == "STEP":
        return _unit(a) if is_rotation else a
    if is_rotation:
        return np.asarray(quat.slerp(_unit(a), _unit(b), share[:, 0]))
    return np.asarray(a + (b - a) * share)


def world(nodes: Nodes, tracks: Tracks, joints: Sequence[int], at: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Places ``(n, n_joints, 3)`` and rotations ``(n, n_joints, 4)`` of ``joints`` at the times ``at`` (n,)."""
    needed = set(joints)
    for j in joints:
        while (j := nodes.parents[j]) >= 0:
            needed.add(j)
    places, turns = np.empty((len(at), len(joints), 3)), np.empty((len(at), len(joints), 4))
    for start in range(0, len(at), _BLOCK):
        times = at[start : start + _BLOCK]
        matrices: dict[int, np.ndarray] = {}
        for node in nodes.order:
            if node in needed:
                own = _local(nodes, tracks, node, times)
                parent = nodes.parents[node]
                matrices[node] = own if parent < 0 else matrices[parent] @ own
        for k, joint in enumerate(joints):
            places[start : start + _BLOCK, k] = matrices[joint][:, :3, 3]
            turns[start : start + _BLOCK, k] = _rotations(matrices[joint][:, :3, :3])
    return places, turns


def _local(nodes: Nodes, tracks: Tracks, node: int, times: np.ndarray) -> np.ndarray:
    """Matrices ``(n, 4, 4)`` of a node against its parent."""
    place, turn, scale = nodes.rest[node]
    n = len(times)

    def value(path: str, rest: np.ndarray) -> np.ndarray:
        track = tracks.get((node, path))
        return np.tile(rest, (n, 1)) if track is None else sampled(track, times, path == "rotation")

    q, s = value("rotation", turn), value("scale", scale)
    matrices = np.zeros((n, 4, 4))
    for axis in range(3):
        matrices[:, :3, axis] = quat.rotate(q, np.tile(np.eye(3)[axis], (n, 1))) * s[:, [axis]]
    matrices[:, :3, 3] = value("translation", place)
    matrices[:, 3, 3] = 1
    return matrices


def _rotations(linear: np.ndarray) -> np.ndarray:
    """The rotations ``(n, 4)`` in matrices ``(n, 3, 3)`` that may also scale and mirror."""
    x = linear[:, :, 0]
    x = x / np.maximum(np.linalg.norm(x, axis=1, keepdims=True), 1e-12)
    y = linear[:, :, 1] - (linear[:, :, 1] * x).sum(1, keepdims=True) * x
    y = y / np.maximum(np.linalg.norm(y, axis=1, keepdims=True), 1e-12)
    z = np.cross(x, y)
    flat = np.linalg.norm(z, axis=1) < 0.5  # scaled to nothing
    frames = np.stack([x, y, z], axis=2)
    frames[flat] = np.eye(3)
    return from_matrices(frames)
