"""A figure of 22 joints that walks a few steps: what files of points are made from in tests."""

from __future__ import annotations

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.clip import Clip
from core.mocap.kinematics import joint_positions
from core.mocap.points.presets import PRESETS
from core.mocap.points.roles import ROLES, direction_of, parent_among
from core.mocap.skeleton import Skeleton

POINTS = PRESETS["smpl22"].points
_LENGTHS = {"hip": 0.12, "knee": 0.42, "ankle": 0.42, "toe": 0.15, "clavicle": 0.12, "shoulder": 0.1, "elbow": 0.28}
_LENGTHS |= {"wrist": 0.26, "spine": 0.1, "spine2": 0.13, "chest": 0.12, "neck": 0.15, "head": 0.12, "pelvis": 0.0}
ALL = {**_LENGTHS, "nose": 0.1, "eye": 0.08, "ear": 0.08, "heel": 0.08, "hand": 0.08, "hand_tip": 0.1, "thumb": 0.07}
ALL |= {"index": 0.09, "pinky": 0.09, "small_toe": 0.14, "toe_tip": 0.05, "head_top": 0.12, "jaw": 0.1}


def figure(n: int = 90, fps: float = 30.0, roles: tuple[str, ...] = tuple(PRESETS["smpl22"].parts)) -> Clip:
    """A clip of these roles (core.mocap.points.roles), about 1.7 m tall, that walks along Z, feet near the floor."""
    roles = tuple(role for role in ROLES if role in roles)
    parents = [-1 if r == "pelvis" else roles.index(parent_among(r, set(roles)) or "pelvis") for r in roles]
    offsets = np.array([direction_of(r) * ALL[r.split("_", 1)[-1] if r[:4] in ("left", "righ") else r] for r in roles])
    phase = np.arange(n) / fps * 2 * np.pi
    turns = np.zeros((n, len(roles), 3))
    for sign, side in ((1, "left"), (-1, "right")):
        swing = sign * np.sin(phase)
        for role, axis, angle in (
            (f"{side}_hip", 0, -0.5 * swing),
            (f"{side}_knee", 0, 0.5 + 0.4 * np.cos(phase) * sign),
            (f"{side}_shoulder", 2, -sign * (1.2 + 0.1 * swing)),
            (f"{side}_elbow", 1, -sign * (0.5 + 0.3 * swing)),
        ):
            if role in roles:
                turns[:, roles.index(role), axis] = angle
    if "spine" in roles:
        turns[:, roles.index("spine"), 1] = 0.15 * np.sin(phase)
    root = np.stack([0.05 * np.sin(phase), 0.92 + 0.02 * np.cos(2 * phase), 0.4 * np.arange(n) / fps], axis=1)
    rotations = quat.from_rotvec(turns).astype(np.float32)
    return Clip("walk", Skeleton(roles, tuple(parents), offsets), fps, root.astype(np.float32), rotations)


def walk(n: int = 90, fps: float = 30.0) -> np.ndarray:
    """Positions ``(n, 22, 3)``, metres, Y up, in the order of SMPL's joints."""
    clip = figure(n, fps)
    parts = PRESETS["smpl22"].parts
    role_of = {sources[0]: role for role, sources in parts.items()}
    order = [clip.skeleton.names.index(role_of[point]) for point in POINTS]
    return joint_positions(clip)[:, order].astype(float)


def of_preset(name: str, n: int = 60) -> np.ndarray:
    """Positions ``(n, n_points, 3)`` of a preset's points: each lies where a part of the walking body is."""
    preset = PRESETS[name]
    clip = figure(n, roles=tuple(preset.parts))
    at = joint_positions(clip).astype(float)
    values = np.full((n, len(preset.points), 3), np.nan)
    for role, sources in preset.parts.items():
        for source in sources:
            if len(sources) == 1 or np.isnan(values[0, preset.points.index(source)]).any():
                values[:, preset.points.index(source)] = at[:, clip.skeleton.names.index(role)]
    for role, sources in preset.parts.items():
        if len(sources) == 1:
            values[:, preset.points.index(sources[0])] = at[:, clip.skeleton.names.index(role)]
    lost = np.isnan(values[0]).any(axis=1)
    values[:, lost] = at[:, [clip.skeleton.names.index("head")]] + 0.03 * np.arange(1, lost.sum() + 1)[None, :, None]
    return values
