"""A walk as it is kept: a JSON document and arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.mocap.clip import Segment
from core.synthesis.links import Link
from core.synthesis.packing import head_of, pack_made, quality_of, unpack_made
from core.synthesis.postures import Moment
from core.synthesis.walks import Part, Walk

FORMAT = "motionscape/walk/1"


def pack_walk(walk: Walk) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document, and the arrays ``root (n, 3)`` metres, ``rotations (n, n_joints, 4)`` and ``contacts (n, 2)``."""
    return pack_made(walk, walk_json(walk))


def walk_json(walk: Walk) -> dict[str, Any]:
    """All of a walk but its motion: where every frame comes from, and how well it was made."""
    return {
        **head_of(walk, FORMAT),
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
        **quality_of(walk),
    }


def unpack_walk(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Walk:
    """The walk back from :func:`pack_walk`; arrays ``(n, ...)`` as there. Raises ValueError, KeyError,
    TypeError for others."""
    return Walk(
        **unpack_made(document, arrays, FORMAT),
        path=tuple(document["path"]),
        links=tuple(
            Link(**{**link, "exit": Moment(*link["exit"]), "entry": Moment(*link["entry"])})
            for link in document["links"]
        ),
        parts=tuple(_part(entry) for entry in document["parts"]),
    )


def _part(entry: Mapping[str, Any]) -> Part:
    fading = Segment(**entry["fading"]) if entry["fading"] else None
    return Part(entry["start"], entry["end"], entry["motif"], entry["visit"], Segment(**entry["source"]), fading)
