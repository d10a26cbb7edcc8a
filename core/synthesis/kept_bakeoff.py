"""A bake-off as it is kept: a JSON document and the motions as arrays."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

import numpy as np

from core.errors import FormatError
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton
from core.synthesis.bakeoff import Bakeoff, Contender

FORMAT = "motionscape/bakeoff/1"


def pack_bakeoff(found: Bakeoff) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document, and of clip k the arrays ``root_k (n, 3)`` metres and ``rotations_k (n, n_joints, 4)``."""
    document = bakeoff_json(found) | {
        "motions": [{"name": c.name, "fps": c.fps, "skeleton": c.skeleton.to_json()} for c in found.clips]
    }
    arrays = {f"root_{k}": clip.root_positions for k, clip in enumerate(found.clips)}
    return document, arrays | {f"rotations_{k}": clip.rotations for k, clip in enumerate(found.clips)}


def bakeoff_json(found: Bakeoff) -> dict[str, Any]:
    """All of a bake-off but its motions; what could not be measured is null."""
    return {
        "format": FORMAT,
        "sentences": found.sentences,
        "shuffles": found.shuffles,
        "contenders": [
            {name: None if isinstance(v, float) and math.isnan(v) else v for name, v in asdict(contender).items()}
            for contender in found.contenders
        ],
        "notes": list(found.notes),
        "parameters": dict(found.parameters),
    }


def _read_contender(entry: Mapping[str, Any]) -> Contender:
    values: dict[str, Any] = {name: math.nan if value is None else value for name, value in entry.items()}
    return Contender(**values)


def unpack_bakeoff(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Bakeoff:
    """The bake-off back from :func:`pack_bakeoff`; arrays ``(n, ...)`` as there. Raises FormatError, KeyError,
    TypeError for others."""
    if document.get("format") != FORMAT:
        raise FormatError(f"not a bake-off: expected format {FORMAT}, found {document.get('format')}")
    return Bakeoff(
        contenders=tuple(map(_read_contender, document["contenders"])),
        clips=tuple(
            Clip(
                motion["name"],
                Skeleton.from_json(motion["skeleton"]),
                motion["fps"],
                arrays[f"root_{k}"],
                arrays[f"rotations_{k}"],
            )
            for k, motion in enumerate(document["motions"])
        ),
        sentences=document["sentences"],
        shuffles=document["shuffles"],
        notes=tuple(document["notes"]),
        parameters=document["parameters"],
    )
