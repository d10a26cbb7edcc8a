"""A walk as it is kept: a JSON document and arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.mocap.clip import Clip, Segment
from core.mocap.skeleton import Skeleton
from core.synthesis.footing import Skate
from core.synthesis.links import Link
from core.synthesis.postures import Moment
from core.synthesis.stitching import Speeds
from core.synthesis.walks import Part, Walk

FORMAT = "motionscape/walk/1"


def pack_walk(walk: Walk) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document, and the arrays ``root (n, 3)`` metres, ``rotations (n, n_joints, 4)`` and ``contacts (n, 2)``."""
    clip = walk.clip
    document = walk_json(walk) | {"name": clip.name, "fps": clip.fps, "skeleton": clip.skeleton.to_json()}
    return document, {"root": clip.root_positions, "rotations": clip.rotations, "contacts": walk.contacts}


def walk_json(walk: Walk) -> dict[str, Any]:
    """All of a walk but its motion: where every frame comes from, and how well it was made."""
    return {
        "format": FORMAT,
        "frames": walk.clip.n_frames,
        "fps": walk.clip.fps,
        "path": list(walk.path),
        "links": [{**link._asdict(), "exit": list(link.exit), "entry": list(link.entry)} for link in walk.links],
        "parts": [
            {
                "start": part.start,
                "end": part.end,
                "motif": part.motif,
                "visit": part.visit,
                "source": part.source._asdict(),
                "fading": part.fading and part.fading._asdict(),
            }
            for part in walk.parts
        ],
        "seams": [list(seam) for seam in walk.seams],
        "skate": walk.skate._asdict(),
        "speeds": walk.speeds._asdict(),
        "warnings": list(walk.warnings),
    }


def unpack_walk(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Walk:
    """The walk back from :func:`pack_walk`; arrays ``(n, ...)`` as there. Raises ValueError, KeyError,
    TypeError for others."""
    if document.get("format") != FORMAT:
        raise ValueError(f"not a walk: expected format {FORMAT}, found {document.get('format')}")
    skeleton = Skeleton.from_json(document["skeleton"])
    return Walk(
        clip=Clip(document["name"], skeleton, document["fps"], arrays["root"], arrays["rotations"]),
        path=tuple(document["path"]),
        links=tuple(
            Link(**{**link, "exit": Moment(*link["exit"]), "entry": Moment(*link["entry"])})
            for link in document["links"]
        ),
        parts=tuple(_part(entry) for entry in document["parts"]),
        seams=tuple((start, end) for start, end in document["seams"]),
        contacts=arrays["contacts"],
        skate=Skate(**document["skate"]),
        speeds=Speeds(**document["speeds"]),
        warnings=tuple(document["warnings"]),
    )


def _part(entry: Mapping[str, Any]) -> Part:
    fading = Segment(**entry["fading"]) if entry["fading"] else None
    return Part(entry["start"], entry["end"], entry["motif"], entry["visit"], Segment(**entry["source"]), fading)
