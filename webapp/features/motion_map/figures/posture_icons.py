"""Postures of a map as small stick figures: left limbs, right limbs and trunk in three colours, a nose for facing.

Postures are joints relative to the pelvis, which is not among them, in metres, on a body that faces +z (see
core.poses.postures).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from core.motion_map.motion_map import MotionMap

VIEW_YAW, VIEW_PITCH = math.radians(35), math.radians(8)
_HEAD = 0.105  # metres, on a body of 1.7 m
_PENS = {"left": 0.075, "right": 0.075, "centre": 0.09}  # metres


class Body(NamedTuple):
    """What is needed to draw: parents, sides and roles of the joints, as a MotionMap has them."""

    parents: tuple[int, ...]
    sides: tuple[str, ...]
    roles: tuple[str, ...]

    def find(self, role: str) -> int:
        """The joint of a canonical name, -1 where there is none."""
        return self.roles.index(role) if role in self.roles else -1


def body_of(motion_map: MotionMap) -> Body:
    """The body whose postures are on a map."""
    return Body(motion_map.parents, motion_map.sides, motion_map.roles)


def forward_of(posture: np.ndarray, body: Body) -> np.ndarray:
    """Where the trunk faces, a unit vector: square to the shoulders and to the line from the hips to the chest."""
    corners = [body.find(name) for name in ("left_shoulder", "right_shoulder")]
    if min(corners) < 0:
        return np.array([0.0, 0.0, 1.0])
    left = posture[corners[0]] - posture[corners[1]]
    up = (posture[corners[0]] + posture[corners[1]]) / 2
    forward = np.cross(left, up)
    length = np.linalg.norm(forward)
    return forward / length if length > 1e-6 else np.array([0.0, 0.0, 1.0])


def turned(points: np.ndarray) -> np.ndarray:
    """Points ``(n, 3)`` as seen from the front left, a little from above: x right, y up, z to the viewer."""
    cos, sin = math.cos(VIEW_YAW), math.sin(VIEW_YAW)
    x = cos * points[..., 0] + sin * points[..., 2]
    z = cos * points[..., 2] - sin * points[..., 0]
    y = points[..., 1] * math.cos(VIEW_PITCH) - z * math.sin(VIEW_PITCH)
    return np.stack([x, y, z], axis=-1)


def figure_svg(posture: np.ndarray, body: Body, colours: dict[str, str]) -> str:
    """SVG elements of one posture ``(n_joints, 3)``, in metres, y down, the pelvis at the origin."""
    posture = np.asarray(posture, np.float64)
    seen = turned(np.vstack([posture, [[0.0, 0.0, 0.0]]]))
    layers: list[tuple[float, str]] = []
    for side in ("left", "right", "centre"):
        bones = [(p, j) for j, p in enumerate(body.parents) if _side(body, j) == side]
        if not bones:
            continue
        path = "".join(f"M{_at(seen[p])}L{_at(seen[j])}" for p, j in bones)
        pen = f'fill="none" stroke="{colours[side]}" stroke-width="{_PENS[side]}"'
        text = f'<path d="{path}" {pen}/>'
        if side == "centre":
            text += _head(posture, body, colours[side])
        layers.append((float(np.mean([seen[j, 2] for _, j in bones])), text))
    return "".join(text for _, text in sorted(layers, key=lambda layer: layer[0]))


def _side(body: Body, joint: int) -> str:
    """Collarbones, shoulders and the pelvis' sides belong to the trunk."""
    in_trunk = body.roles[joint].endswith(("_clavicle", "_shoulder", "_hip"))
    return "centre" if in_trunk else body.sides[joint]


def _at(point: np.ndarray) -> str:
    return f"{point[0]:.3f} {-point[1]:.3f}"


def _head(posture: np.ndarray, body: Body, colour: str) -> str:
    """The head on top of the neck, and the nose where the trunk faces, unless it points away."""
    head = body.find("head")
    if head < 0:
        return ""
    below = body.parents[head]
    up = posture[head] - (posture[below] if below >= 0 else 0)
    centre = posture[head] + up / max(float(np.linalg.norm(up)), 1e-6) * _HEAD
    middle, tip = turned(centre), turned(centre + forward_of(posture, body) * _HEAD * 1.5)
    ball = f'<circle cx="{middle[0]:.3f}" cy="{-middle[1]:.3f}" r="{_HEAD}" fill="{colour}"/>'
    if tip[2] < middle[2]:
        return ball
    return ball + f'<path d="M{_at(middle)}L{_at(tip)}" stroke="{colour}" stroke-width="0.045"/>'
