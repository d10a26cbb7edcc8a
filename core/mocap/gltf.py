"""glTF, GLB, VRM and VRMA recordings: a clip for each animation of each figure."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.errors import RecordingError
from core.mocap.gltf_file import Gltf
from core.mocap.gltf_nodes import Nodes, Tracks, read_nodes, read_tracks, world
from core.mocap.pelvis import find_pelvis
from core.mocap.skeleton import Skeleton
from core.mocap.text import recording_format
from core.mocap.units import span

_DEFAULT_FPS, _FASTEST = 30.0, 240.0
_MOST_FRAMES, _MOST_VALUES = 400_000, 50_000_000
_STILL = 1e-5  # of the figure's span: bones that change less keep their length
_TIP = re.compile(r"([_. ]|site)(end|tip|nub)$|nub$", re.I)
_SIDED = {
    "Shoulder": "clavicle",
    "UpperArm": "shoulder",
    "LowerArm": "elbow",
    "Hand": "wrist",
    "UpperLeg": "hip",
    "LowerLeg": "knee",
    "Foot": "ankle",
    "Toes": "toe",
}
_HUMANOID = {"spine": "spine", "chest": "chest", "upperChest": "chest", "neck": "neck", "head": "head"} | {
    f"{side}{bone}": f"{side}_{part}" for side in ("left", "right") for bone, part in _SIDED.items()
}
"""Bone of VRM's humanoid -> canonical name."""


def read_gltf(path: str | Path, fps: float | None = None) -> tuple[Clip, ...]:
    """A clip for each animation of a glTF, GLB, VRM or VRMA file.

    The joints are those of the skin with most of them, those of VRM's humanoid, else the nodes that move. fps: in place
    of the rate of the key frames. Raises RecordingError where there is no motion or no figure.
    """
    file = Gltf(Path(path))
    nodes = read_nodes(file)
    animations = [a for a in file.list_of("animations") if a.get("channels")]
    if not animations:
        raise RecordingError(path, "a figure without motion", "at least one animation")
    humanoid = _humanoid(file, len(nodes.names))
    stem = recording_format(path)[0]
    named: list[tuple[str, Tracks]] = []
    for k, animation in enumerate(animations):
        tracks = read_tracks(file, animation)
        title = str(animation.get("name") or f"animation {k + 1}")[:80]
        if tracks:
            named.append((title, tracks))
    if not named:
        raise RecordingError(path, "animations that move no node", "a skeleton that moves")
    joints = _joints(file, nodes, humanoid, [tracks for _, tracks in named])
    names = _names(stem, [title for title, _ in named])
    clips = [_clip(file, nodes, joints, tracks, fps) for _, tracks in named]
    skeletons = {clip.skeleton.names: clip.skeleton for clip in clips}
    corrections = _corrections(humanoid, nodes, next(iter(skeletons)))
    return tuple(
        replace(clip, name=name, skeleton=replace(clip.skeleton, corrections=corrections))
        for clip, name in zip(clips, names, strict=True)
    )


def _names(stem: str, titles: list[str]) -> list[str]:
    if len(titles) == 1:
        return [stem]
    return [
        f"{stem} {title}" if titles.count(title) == 1 else f"{stem} {title} {k + 1}" for k, title in enumerate(titles)
    ]


def _humanoid(file: Gltf, n_nodes: int) -> dict[str, int]:
    """Bone of VRM's humanoid -> node, from any version of it; empty where the file has none."""
    extensions = file.document.get("extensions")
    extensions = extensions if isinstance(extensions, dict) else {}
    found: dict[str, int] = {}
    for name in ("VRMC_vrm", "VRMC_vrm_animation", "VRM"):
        extension = extensions.get(name)
        humanoid = extension.get("humanoid") if isinstance(extension, dict) else None
        bones = humanoid.get("humanBones") if isinstance(humanoid, dict) else None
        pairs: list[tuple[Any, Any]] = []
        if isinstance(bones, dict):
            pairs = [(bone, entry.get("node")) for bone, entry in bones.items() if isinstance(entry, dict)]
        elif isinstance(bones, list):
            pairs = [(entry.get("bone"), entry.get("node")) for entry in bones if isinstance(entry, dict)]
        found |= {str(b): node for b, node in pairs if isinstance(node, int) and 0 <= node < n_nodes}
    return found if "hips" in found else {}


def _joints(file: Gltf, nodes: Nodes, humanoid: dict[str, int], animations: list[Tracks]) -> list[int]:
    """Nodes that are the figure's joints, parents first, the pelvis at the top."""
    if humanoid:
        wanted, top = set(humanoid.values()), humanoid["hips"]
    else:
        skins = [[j for j in skin.get("joints") or () if isinstance(j, int)] for skin in file.list_of("skins")]
        wanted = {j for j in max(skins, key=len, default=[]) if 0 <= j < len(nodes.names)}
        if not wanted:
            wanted = {node for tracks in animations for node, _ in tracks if 0 <= node < len(nodes.names)}
        top = -1
    if not wanted:
        raise RecordingError(file.path, "animations that move no node", "a skeleton that moves")
    wanted |= {above for j in wanted for above in _between(nodes, j, wanted)}
    if top < 0:
        tops = [j for j in nodes.order if j in wanted and nodes.parents[j] not in wanted]
        top = max(tops, key=lambda j: sum(_is_below(nodes, k, j) for k in wanted))
    joints = [j for j in nodes.order if j in wanted and _is_below(nodes, j, top)]
    return joints if humanoid else _from_pelvis(nodes, joints)


def _between(nodes: Nodes, joint: int, wanted: set[int]) -> list[int]:
    """Nodes between a joint and the next joint above it; none where there is no joint above."""
    way: list[int] = []
    above = nodes.parents[joint]
    while above >= 0 and above not in wanted:
        way.append(above)
        above = nodes.parents[above]
    return way if above >= 0 else []


def _is_below(nodes: Nodes, node: int, top: int) -> bool:
    while node >= 0:
        if node == top:
            return True
        node = nodes.parents[node]
    return False


def _from_pelvis(nodes: Nodes, joints: list[int]) -> list[int]:
    """The joints from the pelvis on: those above only carry its path."""
    index = {j: k for k, j in enumerate(joints)}
    children: list[list[int]] = [[] for _ in joints]
    for j in joints[1:]:
        children[index[nodes.parents[j]]].append(index[j])
    pelvis = joints[find_pelvis([nodes.names[j] for j in joints], children)]
    return [j for j in joints if _is_below(nodes, j, pelvis)]


def _times(file: Gltf, tracks: Tracks, fps: float | None) -> tuple[np.ndarray, float]:
    """Times ``(n,)`` at which an animation is sampled, and how many a second."""
    first = min(float(track.times[0]) for track in tracks.values())
    last = max(float(track.times[-1]) for track in tracks.values())
    densest = max(tracks.values(), key=lambda track: len(track.times)).times
    steps = np.diff(densest)
    steps = steps[steps > 1e-5]
    rate = fps or _DEFAULT_FPS
    if not fps and len(steps):
        step = float(np.median(steps))
        even = np.abs(steps / step - np.round(steps / step)).max() < 0.05
        rate = 1 / step if even and 10 <= 1 / step <= _FASTEST else _DEFAULT_FPS
        rate = float(round(rate)) if abs(rate - round(rate)) < 0.01 * rate else rate
    n = int(np.floor((last - first) * rate + 1e-3)) + 1
    if n > _MOST_FRAMES:
        raise RecordingError(file.path, f"{last - first:.0f} s of animation", "less than an hour")
    return first + np.arange(n) / rate, rate


def _clip(file: Gltf, nodes: Nodes, joints: list[int], tracks: Tracks, fps: float | None) -> Clip:
    at, rate = _times(file, tracks, fps)
    if len(at) * len(joints) > _MOST_VALUES:
        raise RecordingError(file.path, f"{len(at)} frames of {len(joints)} joints", "a shorter animation")
    places, turns = world(nodes, tracks, joints, at)
    if not np.isfinite(places).all() or np.abs(places).max() > 1e9:
        raise RecordingError(file.path, "joints that are nowhere", "finite places")
    parents = [joints.index(nodes.parents[j]) if k else -1 for k, j in enumerate(joints)]
    offsets, local, away = np.zeros((len(joints), 3)), turns.copy(), {}
    for k, parent in enumerate(parents):
        if parent >= 0:
            back = quat.conjugate(turns[:, parent])
            local[:, k] = quat.multiply(back, turns[:, k])
            away[k] = quat.rotate(back, places[:, k] - places[:, parent])
            offsets[k] = np.median(away[k], axis=0)
    ends = _tips(nodes, joints, parents, tracks)
    local[:, ends] = [1.0, 0, 0, 0]
    still = _STILL * max(span(parents, offsets), 1e-9)
    moving = {k: track.astype(np.float32) for k, track in away.items() if np.ptp(track, axis=0).max() > still}
    notes = ["unit: metres, as glTF has it"]
    if moving:
        notes.append(f"{len(moving)} joints also move against their parents, by more than a turn")
    return Clip(
        name="",
        skeleton=Skeleton(tuple(nodes.names[j] for j in joints), tuple(parents), offsets, tuple(ends.tolist())),
        fps=rate,
        root_positions=places[:, 0].astype(np.float32),
        rotations=local.astype(np.float32),
        translations=moving,
        notes=tuple(notes),
    )


def _tips(nodes: Nodes, joints: list[int], parents: list[int], tracks: Tracks) -> np.ndarray:
    """Which joints are tips: called so, with nothing below them and no motion of their own."""
    return np.array(
        [
            bool(_TIP.search(nodes.names[j])) and k not in parents and k > 0 and (j, "rotation") not in tracks
            for k, j in enumerate(joints)
        ]
    )


def _corrections(humanoid: dict[str, int], nodes: Nodes, joints: tuple[str, ...]) -> tuple[tuple[str, str | None], ...]:
    """Canonical name -> joint, by VRM's humanoid."""
    found = {_HUMANOID[bone]: nodes.names[node] for bone, node in humanoid.items() if bone in _HUMANOID}
    if "upperChest" in humanoid:
        found["chest"] = nodes.names[humanoid["upperChest"]]
    return tuple(sorted((part, name) for part, name in found.items() if name in joints))
