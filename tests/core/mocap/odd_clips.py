"""Clips that are odd in one way each: turned, mirrored, parts of a body, animals."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.bvh import write_bvh
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton
from tests.core.mocap import samples


def walking(name: str = "walk", seconds: float = 3.0, speed: float = 1.2, **options) -> Clip:
    """samples.idling whose hips travel along Z and whose legs swing, knees bent."""
    clip = samples.idling(name, seconds=seconds, **options)
    root, rotations = clip.root_positions.copy(), clip.rotations.copy()
    t = np.arange(clip.n_frames) / clip.fps
    root[:, 2] = speed * t
    for side, sign in (("Left", 1), ("Right", -1)):
        swing = sign * 0.5 * np.sin(2 * np.pi * t)
        bend = 0.35 + 0.3 * np.cos(2 * np.pi * t + sign)
        for joint, angle in ((f"{side}UpLeg", swing - 0.2), (f"{side}Leg", bend)):
            rotations[:, clip.skeleton.index(joint)] = quat.from_rotvec(np.outer(angle, [1.0, 0, 0]))
    return replace(clip, root_positions=root.astype(np.float32), rotations=rotations.astype(np.float32))


def in_other_axes(clip: Clip, turn: np.ndarray) -> Clip:
    """All coordinates turned by the quaternion ``turn`` (4,): the same motion in a file with another axis up."""
    back = quat.conjugate(turn)[None]
    rotations = quat.multiply(turn[None], quat.multiply(clip.rotations.astype(float), back))
    return replace(
        clip,
        skeleton=replace(clip.skeleton, offsets=quat.rotate(turn[None], clip.skeleton.offsets.astype(float))),
        root_positions=quat.rotate(turn[None], clip.root_positions.astype(float)).astype(np.float32),
        rotations=rotations.astype(np.float32),
    )


def mirrored(clip: Clip) -> Clip:
    """X turned round in all coordinates and no joint renamed, as a left-handed program writes it."""
    flip = np.array([-1, 1, 1], np.float32)
    return replace(
        clip,
        skeleton=replace(clip.skeleton, offsets=clip.skeleton.offsets * flip),
        root_positions=clip.root_positions * flip,
        rotations=clip.rotations * np.array([1, 1, -1, -1], np.float32),
    )


def without(clip: Clip, *tops: str) -> Clip:
    """Without these joints and all below them."""
    skeleton, keep = clip.skeleton, []
    for j, parent in enumerate(skeleton.parents):
        if skeleton.names[j] not in tops and (parent < 0 or parent in keep):
            keep.append(j)
    index = {j: k for k, j in enumerate(keep)}
    smaller = Skeleton(
        tuple(skeleton.names[j] for j in keep),
        tuple(-1 if skeleton.parents[j] < 0 else index[skeleton.parents[j]] for j in keep),
        skeleton.offsets[keep],
        tuple(skeleton.end_sites[j] for j in keep),
        unit=skeleton.unit,
    )
    return replace(clip, skeleton=smaller, rotations=clip.rotations[:, keep])


def spider(name: str = "spider", legs: int = 8, seconds: float = 3.0, seed: int = 0) -> Clip:
    """A body on many legs that wave, named as game rigs name them."""
    names, parents, offsets = ["Root", "Body"], [-1, 0], [(0, 0, 0), (0, 0.1, 0)]
    for k in range(legs):
        angle = 2 * np.pi * k / legs
        out = np.array([np.cos(angle), 0.2, np.sin(angle)])
        side = "L" if np.cos(angle) > 0 else "R"
        for part in range(4):
            parents.append(1 if not part else len(names) - 1)
            names.append(f"BN_Leg_{side}_{k}{part}")
            offsets.append(tuple(out * (0.2, 0.3, 0.3, 0.25)[part] * [1, 1 - part, 1]))
    return _waving(name, Skeleton(tuple(names), tuple(parents), np.array(offsets)), 0.4, seconds, seed)


def dog(name: str = "dog", seconds: float = 3.0, seed: int = 0) -> Clip:
    """A quadruped with the names of a person's rig, and a tail; its fore legs are as long as its hind legs."""
    rows = [("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 0.03, 0.25)), ("Chest", "Spine", (0, 0, 0.25))]
    rows += [("Neck", "Chest", (0, 0.1, 0.12)), ("Head", "Neck", (0, 0.1, 0.1)), ("Head_end", "Head", (0, 0, 0.15))]
    rows += [("Tail", "Hips", (0, 0.05, -0.1)), ("Tail1", "Tail", (0, 0.1, -0.15)), ("Tail2", "Tail1", (0, 0.1, -0.1))]
    for side, x in (("Left", 0.08), ("Right", -0.08)):
        rows += [(f"{side}Shoulder", "Chest", (x, 0, 0)), (f"{side}Arm", f"{side}Shoulder", (0, -0.1, 0.05))]
        rows += [(f"{side}ForeArm", f"{side}Arm", (0, -0.22, 0)), (f"{side}Hand", f"{side}ForeArm", (0, -0.22, 0.02))]
        rows += [(f"{side}UpLeg", "Hips", (x, -0.05, 0)), (f"{side}Leg", f"{side}UpLeg", (0, -0.2, 0.05))]
        rows += [(f"{side}Foot", f"{side}Leg", (0, -0.22, -0.05)), (f"{side}Toe", f"{side}Foot", (0, -0.05, 0.06))]
    names = [row[0] for row in rows]
    parents = tuple(-1 if row[1] is None else names.index(row[1]) for row in rows)
    return _waving(name, Skeleton(tuple(names), parents, np.array([row[2] for row in rows])), 0.5, seconds, seed)


def _waving(name: str, skeleton: Skeleton, height: float, seconds: float, seed: int) -> Clip:
    rng, n = np.random.default_rng(seed), round(seconds * 30)
    t = np.arange(n) / 30
    phases, sizes = rng.uniform(0, 6, skeleton.n_joints), rng.uniform(0.1, 0.4, skeleton.n_joints)
    angles = sizes * np.sin(2 * np.pi * (0.5 + 0.5 * rng.random()) * t[:, None] + phases)
    rotations = quat.from_rotvec(angles[..., None] * np.array([1.0, 0.2, 0]))
    root = np.column_stack([0.05 * np.sin(t), np.full(n, height), 0.3 * t]).astype(np.float32)
    return Clip(name, skeleton, 30.0, root, rotations.astype(np.float32))


def written(folder: Path, *clips: Clip) -> Path:
    """The folder, with the clips as BVH files of their names."""
    folder.mkdir(parents=True, exist_ok=True)
    for clip in clips:
        write_bvh(folder / f"{clip.name}.bvh", clip)
    return folder
