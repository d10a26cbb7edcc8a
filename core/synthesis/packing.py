"""Storage of synthesised motion with its quality measures."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from core.errors import FormatError
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton
from core.synthesis.footing import Skate
from core.synthesis.stitching import Speeds


class Made(Protocol):
    """A motion that was made of pieces: walks and derivations."""

    @property
    def clip(self) -> Clip:
        """The motion."""

    @property
    def seams(self) -> tuple[tuple[int, int], ...]:
        """Half-open frames of each cross-fade."""

    @property
    def contacts(self) -> np.ndarray:
        """``(n_frames, 2)`` bool: which foot stands."""

    @property
    def skate(self) -> Skate:
        """How far standing feet slide."""

    @property
    def speeds(self) -> Speeds:
        """Speeds at the seams and elsewhere."""

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a person should know of it."""


def head_of(made: Made, kind: str) -> dict[str, Any]:
    """The format and the length, the beginning of a document."""
    return {"format": kind, "frames": made.clip.n_frames, "fps": made.clip.fps}


def quality_of(made: Made) -> dict[str, Any]:
    """The quality measures, the end of a document."""
    return {
        "seams": [list(seam) for seam in made.seams],
        "skate": made.skate._asdict(),
        "speeds": made.speeds._asdict(),
        "warnings": list(made.warnings),
    }


def pack_made(made: Made, document: dict[str, Any]) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document with what it says of the motion, and the arrays ``root (n, 3)`` metres,
    ``rotations (n, n_joints, 4)`` and ``contacts (n, 2)``."""
    clip = made.clip
    head = {"name": clip.name, "skeleton": clip.skeleton.to_json()}
    return document | head, {"root": clip.root_positions, "rotations": clip.rotations, "contacts": made.contacts}


def unpack_made(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray], kind: str) -> dict[str, Any]:
    """The fields of :class:`Made`; arrays ``(n, ...)`` as there. Raises FormatError for a document of another format,
    KeyError or TypeError for a broken one."""
    if document.get("format") != kind:
        name = kind.split("/")[1]
        raise FormatError(f"not a {name}: expected format {kind}, found {document.get('format')}")
    skeleton = Skeleton.from_json(document["skeleton"])
    return {
        "clip": Clip(document["name"], skeleton, document["fps"], arrays["root"], arrays["rotations"]),
        "seams": tuple((start, end) for start, end in document["seams"]),
        "contacts": arrays["contacts"],
        "skate": Skate(**document["skate"]),
        "speeds": Speeds(**document["speeds"]),
        "warnings": tuple(document["warnings"]),
    }
