"""A motion as a strip of key poses, and a pose as an icon: one small SVG each, from joint positions alone.

Colours are CSS variables with defaults that read on light and dark, so that a strip may stand in the page itself or in
an ``<img>``; icons for the graph carry their colours with them.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from html import escape
from typing import NamedTuple
from urllib.parse import quote

import numpy as np

from core.mocap.clip import Segment
from core.mocap.dataset import Dataset
from core.mocap.posture_drawing import DrawnBody, drawn_positions, facing

STRIP_HEIGHT = 100.0  # units of the drawing for a body of average height, and a little air
MOST_FRAMES = 600  # of which key poses are chosen
VIEW_YAW, VIEW_PITCH = math.radians(35), math.radians(8)
ICON_COLOURS = {
    "light": {"left": "#2a78d0", "right": "#e0701a", "centre": "#6d7686"},
    "dark": {"left": "#5aa9f5", "right": "#f2994a", "centre": "#a9b3c4"},
}
_VARIABLES = {
    "left": "var(--ms-left,#3d8ee0)",
    "right": "var(--ms-right,#e8832f)",
    "centre": "var(--ms-spine,#8590a2)",
}
_WIDTHS = {"left": 0.042, "right": 0.042, "centre": 0.05}  # of the body's height


class Drawing(NamedTuple):
    """SVG elements and the box they fill: x from ``left`` to ``right``, y from ``top`` down to ``bottom``."""

    elements: str
    left: float
    right: float
    top: float
    bottom: float


def key_frames(positions: np.ndarray, n_poses: int) -> np.ndarray:
    """Frames that divide the path of the joints evenly, first and last among them: at most ``n_poses``, ascending.

    positions: ``(n_frames, joints, 3)``. The path is the mean distance of the joints, relative to the root, plus a
    third of the root's own: so a pause gets no pose, and a kick several.
    """
    n_poses = min(n_poses, len(positions))
    steps = np.diff(np.asarray(positions, np.float64), axis=0)
    relative = np.linalg.norm(steps - steps[:, :1], axis=-1).mean(axis=-1)
    path = np.concatenate([[0.0], np.cumsum(relative + np.linalg.norm(steps[:, 0], axis=-1) / 3)])
    if n_poses < 2 or path[-1] < 1e-6:
        return np.unique(np.linspace(0, len(positions) - 1, n_poses).astype(int))
    return np.unique(np.searchsorted(path, np.linspace(0, path[-1], n_poses) * (1 - 1e-9)))


def turn_to_viewer(positions: np.ndarray, body: DrawnBody) -> np.ndarray:
    """Poses ``(n, joints, 3)`` seen from the front left of the first: x to the right, y up, z to the viewer, metres.

    Roots are moved to x = 0; heights stay as they are.
    """
    forward = facing(positions[:1], body)[0]
    yaw = VIEW_YAW - (math.atan2(forward[0], forward[2]) if forward.any() else 0.0)
    relative = positions - positions[:, :1] * [1, 0, 1]
    cos, sin = math.cos(yaw), math.sin(yaw)
    x = cos * relative[..., 0] + sin * relative[..., 2]
    z = cos * relative[..., 2] - sin * relative[..., 0]
    y = relative[..., 1] * math.cos(VIEW_PITCH) - z * math.sin(VIEW_PITCH)
    return np.stack([x, y, z], axis=-1)


def draw_pose(seen: np.ndarray, body: DrawnBody, radius: float, scale: float, colours: dict[str, str]) -> Drawing:
    """One pose ``(joints, 3)`` from :func:`turn_to_viewer`; ``radius`` of the head in metres, ``scale`` units a metre.

    Left, right and centre limbs, the furthest first; the trunk filled, the head a disc with a nose.
    """
    at = np.stack([seen[:, 0], -seen[:, 1]], axis=-1) * scale
    layers: list[tuple[float, str]] = []
    for side, bones in _bones_by_side(body).items():
        joints = sorted({joint for bone in bones for joint in bone})
        path = "".join(_path(chain, at) for chain in _chains(bones))
        width = _WIDTHS[side] * body.height * scale
        pen = f'fill="none" stroke="{colours[side]}" stroke-width="{width:.1f}"'
        stroke = f'<path class="ms-strip-{side}" d="{path}" {pen}/>'
        if side == "centre":
            stroke = (
                _trunk(at, body, colours[side], width) + stroke + _head(at, seen, body, radius * scale, colours[side])
            )
        layers.append((float(seen[joints, 2].mean()), stroke))
    layers.sort(key=lambda layer: layer[0])
    air = max(0.03 * body.height, radius) * scale
    low, high = at.min(axis=0), at.max(axis=0)
    return Drawing("".join(text for _, text in layers), low[0] - air, high[0] + air, low[1] - air, high[1] + air / 2)


def _bones_by_side(body: DrawnBody) -> dict[str, list[tuple[int, int]]]:
    bones: dict[str, list[tuple[int, int]]] = {}
    for joint, parent in enumerate(body.parents):
        if parent >= 0 and body.roles[joint] not in ("head_centre", "nose"):
            bones.setdefault(_limb_side(body, joint), []).append((parent, joint))
    return bones


def _limb_side(body: DrawnBody, joint: int) -> str:
    """Collarbones and the pelvis' sides belong to the trunk."""
    in_trunk = body.roles[joint].endswith(("_clavicle", "_shoulder", "_hip"))
    return "centre" if in_trunk else body.sides[joint]


def _chains(bones: list[tuple[int, int]]) -> Iterator[list[int]]:
    """Bones joined to chains, each drawn in one go."""
    chain: list[int] = []
    for parent, joint in bones:
        if chain and chain[-1] == parent:
            chain.append(joint)
            continue
        if chain:
            yield chain
        chain = [parent, joint]
    if chain:
        yield chain


def _path(chain: list[int], at: np.ndarray) -> str:
    return "M" + "L".join(f"{at[j, 0]:.1f} {at[j, 1]:.1f}" for j in chain)


def _trunk(at: np.ndarray, body: DrawnBody, colour: str, width: float) -> str:
    corners = [body.find(role) for role in ("left_shoulder", "right_shoulder", "right_hip", "left_hip")]
    if min(corners) < 0:
        return ""
    path = _path(corners, at)
    return f'<path class="ms-strip-trunk" d="{path}z" fill="{colour}" stroke="{colour}" stroke-width="{width:.1f}"/>'


def _head(at: np.ndarray, seen: np.ndarray, body: DrawnBody, radius: float, colour: str) -> str:
    head, nose = body.find("head_centre"), body.find("nose")
    if head < 0:
        return ""
    ball = f'<circle cx="{at[head, 0]:.1f}" cy="{at[head, 1]:.1f}" r="{radius:.1f}" fill="{colour}"/>'
    if seen[nose, 2] < seen[head, 2] - 0.02:
        return ball
    tip = at[head] + 1.25 * (at[nose] - at[head])
    line = f"M{at[head, 0]:.1f} {at[head, 1]:.1f}L{tip[0]:.1f} {tip[1]:.1f}"
    return ball + f'<path d="{line}" stroke="{colour}" stroke-width="{0.42 * radius:.1f}"/>'


def filmstrip_svg(positions: np.ndarray, body: DrawnBody, radius: float, floor: float, n_poses: int, title: str) -> str:
    """Key poses side by side on one floor, as SVG text.

    positions: ``(n_frames, joints, 3)`` of the drawn joints, metres; ``radius`` of the head and height of the ``floor``
    in metres; ``title`` is what screen readers say, in any characters.
    """
    poses = positions[key_frames(positions, n_poses)].astype(np.float64)
    poses[..., 1] -= floor
    scale = 0.9 * STRIP_HEIGHT / max(body.height, 1e-3)
    drawings = [draw_pose(pose, body, radius, scale, _VARIABLES) for pose in turn_to_viewer(poses, body)]
    top = min(-STRIP_HEIGHT, *(drawing.top for drawing in drawings))
    bottom = max(6.0, *(drawing.bottom for drawing in drawings))
    parts, x = [], 0.0
    for drawing in drawings:
        width = max(drawing.right - drawing.left, 0.3 * STRIP_HEIGHT)
        shift = x + width / 2 - (drawing.left + drawing.right) / 2
        parts.append(f'<g transform="translate({shift:.1f} 0)">{drawing.elements}</g>')
        x += width + 5
    line = f'<path class="ms-strip-floor" d="M0 0H{x:.0f}" stroke="#8590a2" stroke-opacity=".35" stroke-width="1.2"/>'
    return _svg((0, top, x, bottom - top), line + "".join(parts), title)


def icon_svg(positions: np.ndarray, body: DrawnBody, radius: float, colours: dict[str, str], title: str = "") -> str:
    """One pose ``(joints, 3)`` in a square, as SVG text with these colours for ``left``, ``right`` and ``centre``."""
    seen = turn_to_viewer(np.asarray(positions, np.float64)[None], body)[0]
    drawing = draw_pose(seen, body, radius, 90.0 / max(body.height, 1e-3), colours)
    side = max(drawing.right - drawing.left, drawing.bottom - drawing.top)
    middle = (drawing.left + drawing.right) / 2, (drawing.top + drawing.bottom) / 2
    return _svg((middle[0] - side / 2, middle[1] - side / 2, side, side), drawing.elements, title)


def _svg(box: tuple[float, float, float, float], elements: str, title: str) -> str:
    x, y, width, height = box
    name = f"<title>{escape(_printable(title))}</title>" if title else ""
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{x:.1f} {y:.1f} {width:.1f} {height:.1f}" '
        f'width="{width:.0f}" height="{height:.0f}" stroke-linecap="round" stroke-linejoin="round" role="img">'
        f"{name}{elements}</svg>"
    )


def _printable(text: str) -> str:
    return "".join(character if character.isprintable() else "?" for character in text)


def segment_filmstrip(dataset: Dataset, segment: Segment, n_poses: int = 6) -> str:
    """Filmstrip of a segment as SVG text. Raises KeyError or ValueError where the dataset does not have it."""
    step = max(1, segment.n_frames // MOST_FRAMES)
    positions, body, measured = drawn_positions(dataset.clip(segment.clip), segment.start, segment.end, step)
    title = f"{segment.clip}, frames {segment.start} to {segment.end}"
    return filmstrip_svg(positions, body, measured.radius, measured.floor, n_poses, title)


def frame_icon(dataset: Dataset, clip: str, frame: int, scheme: str = "light") -> str:
    """Icon of one frame as SVG text. Raises KeyError or ValueError where the dataset does not have it."""
    positions, body, measured = drawn_positions(dataset.clip(clip), frame, frame + 1)
    return icon_svg(positions[0], body, measured.radius, ICON_COLOURS[scheme])


def page_icon(dataset: Dataset, clip: str, frame: int, title: str = "") -> str:
    """Icon of one frame for a drawing within a page, in whose colours it stands: SVG text."""
    positions, body, measured = drawn_positions(dataset.clip(clip), frame, frame + 1)
    return icon_svg(positions[0], body, measured.radius, _VARIABLES, title)


def icon_data_uri(dataset: Dataset, segment: Segment, scheme: str = "light") -> str:
    """Icon of a segment's middle frame as a ``data:`` URI, as Cytoscape wants it; ``scheme``: "light" or "dark"."""
    return data_uri(frame_icon(dataset, segment.clip, (segment.start + segment.end) // 2, scheme))


def data_uri(svg: str) -> str:
    """SVG text as a ``data:`` URI."""
    return "data:image/svg+xml;utf8," + quote(svg, safe="")
