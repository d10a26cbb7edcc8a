"""A body of points that stands, and is moved by a few lines: what words are tried on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from core.retrieval.words.signals import NEEDS, Signals

STANDING = {
    "pelvis": (0, 0.53, 0), "spine": (0, 0.62, 0), "chest": (0, 0.7, 0), "neck": (0, 0.83, 0), "head": (0, 0.9, 0.01),
    "shoulder": (0.11, 0.81, 0), "elbow": (0.13, 0.64, -0.01), "wrist": (0.14, 0.485, 0.02),
    "hip": (0.055, 0.525, 0), "knee": (0.055, 0.285, 0.01), "ankle": (0.055, 0.045, 0), "toe": (0.06, 0.01, 0.09),
}  # fmt: skip
UPPER = ("spine", "chest", "neck", "head", "shoulder", "elbow", "wrist")
ARM = 0.33


class Puppet:
    """Places of joints ``(n, 3)`` in statures, left, up and forward, over ``seconds``; t: times ``(n,)``."""

    def __init__(self, seconds: float = 4.0):
        self.t = np.arange(round(seconds * 30)) / 30
        self.at: dict[str, np.ndarray] = {}
        for name, (x, y, z) in STANDING.items():
            names = [(name, 1)] if x == 0 else [(f"left_{name}", 1), (f"right_{name}", -1)]
            for joint, side in names:
                self.at[joint] = np.tile([side * x, y, z], (len(self.t), 1)).astype(float)

    def signals(self) -> Signals:
        """What words are read from."""
        return Signals(self.at, frozenset(NEEDS))

    def hand(self, side: str, left, up, forward) -> Puppet:
        """A hand seen from its shoulder, in arm's lengths; the elbow half way, out of the line where there is room."""
        shoulder = self.at[f"{side}_shoulder"]
        offset = np.column_stack([np.broadcast_to(np.asarray(v, float), self.t.shape) for v in (left, up, forward)])
        self.at[f"{side}_wrist"] = shoulder + ARM * offset
        room = np.sqrt(np.maximum(0.25 - (offset**2).sum(1) / 4, 0))[:, None]
        out = np.array([1.0 if side == "left" else -1.0, -0.5, -0.5]) / np.sqrt(1.5)
        self.at[f"{side}_elbow"] = shoulder + ARM * (offset / 2 + room * out)
        return self

    def both(self, out, up, forward) -> Puppet:
        """Both hands alike; ``out``: to each hand's own side."""
        return self.hand("left", np.asarray(out), up, forward).hand("right", -np.asarray(out), up, forward)

    def shift(self, joints, left=0.0, up=0.0, forward=0.0) -> Puppet:
        """Joints by their ends of names moved by so much."""
        offset = np.column_stack([np.broadcast_to(np.asarray(v, float), self.t.shape) for v in (left, up, forward)])
        for name in self.at:
            if any(name.endswith(joint) for joint in joints):
                self.at[name] = self.at[name] + offset
        return self

    def lower(self, depth) -> Puppet:
        """Hips and all above them come down by ``depth``, knees come forward."""
        depth = np.broadcast_to(np.asarray(depth, float), self.t.shape)
        self.shift((*UPPER, "pelvis", "hip"), up=-depth)
        return self.shift(("knee",), up=-depth / 2, forward=np.sqrt(np.maximum(depth, 0)) * 0.3)

    def tilt(self, degrees, axis: int = 0) -> Puppet:
        """The trunk turned about the pelvis: forward (axis 0) or to the left (axis 2)."""
        angle = np.radians(np.broadcast_to(np.asarray(degrees, float), self.t.shape))
        for name in self.at:
            if any(name.endswith(joint) for joint in UPPER):
                v = self.at[name] - self.at["pelvis"]
                other = 2 if axis == 0 else 0
                up = v[:, 1] * np.cos(angle) - v[:, other] * np.sin(angle)
                along = v[:, 1] * np.sin(angle) + v[:, other] * np.cos(angle)
                v = v.copy()
                v[:, 1], v[:, other] = up, along
                self.at[name] = self.at["pelvis"] + v
        return self

    def steps(self, rate: float = 0.9, length: float = 0.15, lift: float = 0.04) -> Puppet:
        """The feet pass one another ``rate`` times a second."""
        for side, phase in (("left", 0.0), ("right", np.pi)):
            swing = np.sin(2 * np.pi * rate * self.t + phase)
            rise = lift * np.maximum(0, np.cos(2 * np.pi * rate * self.t + phase))
            self.shift((f"{side}_ankle", f"{side}_toe"), up=rise, forward=length * swing)
            self.shift((f"{side}_knee",), up=rise / 2, forward=length * swing / 2)
        return self

    def travel(self, left=0.0, forward=0.0) -> Puppet:
        """The whole body moved over the ground by so much."""
        return self.shift(("",), left=left, forward=forward)

    def turn(self, degrees, only: tuple[str, ...] = ("",)) -> Puppet:
        """The body, or joints of it, turned to the left about the upright through the pelvis."""
        angle = np.radians(np.broadcast_to(np.asarray(degrees, float), self.t.shape))
        for name in self.at:
            if any(name.endswith(joint) for joint in only):
                x, z = self.at[name][:, 0].copy(), self.at[name][:, 2].copy()
                self.at[name][:, 0] = np.cos(angle) * x + np.sin(angle) * z
                self.at[name][:, 2] = np.cos(angle) * z - np.sin(angle) * x
        return self


Made = Callable[[], Puppet]
