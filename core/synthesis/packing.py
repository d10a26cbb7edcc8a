"""What every made motion is kept with: the motion itself, and how well it was made."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton
from core.synthesis.footing import Skate
from core.synthesis.stitching import Speeds


class Made(Protocol):
    """A motion that was made of pieces: walks and derivations."""

    clip: Clip
    seams: tuple[tuple[int, int], ...]
    contacts: np.ndarray
    skate: Skate
    speeds: Speeds
    warnings: tuple[str, ...]


def head_of(made: Made, kind: str) -> dict[str, Any]:
    """The format and the length, with which a document begins."""
    return {"format": kind, "frames": made.clip.n_frames, "fps": made.clip.fps}


def quality_of(made: Made) -> dict[str, Any]:
    """How well it was made, with which a document ends."""
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
    said = {"name": clip.name, "skeleton": clip.skeleton.to_json()}
    return document | said, {"root": clip.root_positions, "rotations": clip.rotations, "contacts": made.contacts}


def unpack_made(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray], kind: str) -> dict[str, Any]:
    """The fields of :class:`Made`; arrays ``(n, ...)`` as there. Raises ValueError for a document of another format,
    KeyError or TypeError for a broken one."""
    if document.get("format") != kind:
        name = kind.split("/")[1]
        raise ValueError(f"not a {name}: expected format {kind}, found {document.get('format')}")
    skeleton = Skeleton.from_json(document["skeleton"])
    return {
        "clip": Clip(document["name"], skeleton, document["fps"], arrays["root"], arrays["rotations"]),
        "seams": tuple((start, end) for start, end in document["seams"]),
        "contacts": arrays["contacts"],
        "skate": Skate(**document["skate"]),
        "speeds": Speeds(**document["speeds"]),
        "warnings": tuple(document["warnings"]),
    }
