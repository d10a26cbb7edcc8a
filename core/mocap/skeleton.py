"""Skeleton: joints, who hangs from whom, and the rest offsets."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A tree of joints, parents first; the first joint is the root (the pelvis).

    names: joint names, unique. End sites (tips of head, hands and feet) are joints too, marked in ``end_sites``,
        named after their parent with ``_end``; they never rotate.
    parents: index of each joint's parent, -1 for the root.
    offsets: (n_joints, 3) float32, metres, from the parent in the parent's frame at rest; Y up, right-handed.
    end_sites: (n_joints,) True for tips without channels of their own.
    channels: per joint, the source's channel names in file order (BVH spelling: ``Zrotation``, ``Xposition`` ...).
    unit: metres per length unit of the source file, so that a file can be written back.
    corrections: (canonical name, joint name or None) where someone said which joint is which, or that there is none, in
        place of what core.mocap.anatomy finds; body: "human", "partial" or "other" where someone said it.
    Raises ValueError for cycles, a child before its parent, duplicate names or wrong shapes.
    """

    names: tuple[str, ...]
    parents: tuple[int, ...]
    offsets: np.ndarray
    end_sites: tuple[bool, ...] = ()
    channels: tuple[tuple[str, ...], ...] = ()
    unit: float = 1.0
    corrections: tuple[tuple[str, str | None], ...] = ()
    body: Literal["human", "partial", "other"] | None = None
    fingerprint: str = field(init=False, default="")

    def __post_init__(self) -> None:
        n = len(self.names)
        offsets = np.ascontiguousarray(self.offsets, np.float32)
        if offsets.shape != (n, 3) or len(self.parents) != n or n == 0:
            raise ValueError(f"a skeleton of {n} joints needs {n} parents and offsets of shape ({n}, 3)")
        if len(set(self.names)) != n:
            raise ValueError("joint names must be unique")
        if self.parents[0] != -1 or any(not 0 <= p < j for j, p in enumerate(self.parents) if j):
            raise ValueError("the first joint must be the only root and parents must come before their children")
        object.__setattr__(self, "offsets", offsets)
        object.__setattr__(self, "end_sites", tuple(self.end_sites) or (False,) * n)
        object.__setattr__(self, "channels", tuple(self.channels) or _default_channels(self.end_sites))
        object.__setattr__(self, "corrections", tuple(sorted(map(tuple, self.corrections))))
        text = repr((self.names, tuple(map(int, self.parents)), self.end_sites)).encode() + offsets.tobytes()
        if self.corrections or self.body:
            text += repr((self.corrections, self.body)).encode()
        object.__setattr__(self, "fingerprint", hashlib.blake2b(text, digest_size=8).hexdigest())

    def to_json(self) -> dict[str, Any]:
        """All of it as plain values; :meth:`from_json` gives the skeleton back."""
        return {
            "names": list(self.names),
            "parents": [int(parent) for parent in self.parents],
            "offsets": self.offsets.tolist(),
            "end_sites": [bool(end) for end in self.end_sites],
            "channels": [list(channels) for channels in self.channels],
            "unit": self.unit,
        } | ({"corrections": [list(pair) for pair in self.corrections], "body": self.body} if self.is_corrected else {})

    @classmethod
    def from_json(cls, entry: Mapping[str, Any]) -> Skeleton:
        """The skeleton that :meth:`to_json` wrote. Raises KeyError, TypeError or ValueError for anything else."""
        return cls(
            names=tuple(entry["names"]),
            parents=tuple(entry["parents"]),
            offsets=np.array(entry["offsets"], np.float32),
            end_sites=tuple(entry["end_sites"]),
            channels=tuple(tuple(channels) for channels in entry["channels"]),
            unit=entry["unit"],
            corrections=tuple((name, joint) for name, joint in entry.get("corrections", ())),
            body=entry.get("body"),
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Skeleton) and self.fingerprint == other.fingerprint

    def __hash__(self) -> int:
        return hash(self.fingerprint)

    @property
    def is_corrected(self) -> bool:
        """Whether someone said what is what in this body."""
        return bool(self.corrections or self.body)

    @property
    def n_joints(self) -> int:
        """Number of joints, end sites included."""
        return len(self.names)

    def index(self, name: str) -> int:
        """Index of the joint called ``name``; raises KeyError where there is none."""
        try:
            return self.names.index(name)
        except ValueError:
            raise KeyError(f"no joint {name!r}; the joints are {', '.join(self.names)}") from None

    def children(self, joint: int) -> list[int]:
        """Indices of the joints that hang from ``joint``."""
        return list(self._children[joint])

    @cached_property
    def _children(self) -> list[list[int]]:
        children: list[list[int]] = [[] for _ in self.names]
        for joint, parent in enumerate(self.parents):
            if parent >= 0:
                children[parent].append(joint)
        return children


def _default_channels(end_sites: tuple[bool, ...]) -> tuple[tuple[str, ...], ...]:
    rotation = ("Zrotation", "Yrotation", "Xrotation")
    root = ("Xposition", "Yposition", "Zposition", *rotation)
    return tuple(() if end else root if j == 0 else rotation for j, end in enumerate(end_sites))
