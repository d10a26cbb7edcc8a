"""A derivation as it is kept: a JSON document and arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.grammar.trees import Node, tree_json
from core.mocap.clip import Clip, Segment
from core.mocap.skeleton import Skeleton
from core.synthesis.derivations import Derivation
from core.synthesis.footing import Skate
from core.synthesis.stitching import Speeds

FORMAT = "motionscape/derivation/1"


def pack_derivation(made: Derivation) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document, and the arrays ``root (n, 3)`` metres, ``rotations (n, n_joints, 4)`` and ``contacts (n, 2)``."""
    clip = made.clip
    document = derivation_json(made) | {"name": clip.name, "fps": clip.fps, "skeleton": clip.skeleton.to_json()}
    return document, {"root": clip.root_positions, "rotations": clip.rotations, "contacts": made.contacts}


def derivation_json(made: Derivation) -> dict[str, Any]:
    """All of a derivation but its motion: the sentence, where every frame comes from, and how well it was made."""
    return {
        "format": FORMAT,
        "frames": made.clip.n_frames,
        "fps": made.clip.fps,
        "terminals": list(made.terminals),
        "segments": [piece._asdict() for piece in made.pieces],
        "spans": [list(span) for span in made.spans],
        "tree": tree_json(made.tree) if made.tree else None,
        "jumps": list(made.jumps),
        "seams": [list(seam) for seam in made.seams],
        "skate": made.skate._asdict(),
        "speeds": made.speeds._asdict(),
        "warnings": list(made.warnings),
    }


def unpack_derivation(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Derivation:
    """The derivation back from :func:`pack_derivation`; arrays ``(n, ...)`` as there. Raises ValueError, KeyError,
    TypeError for others."""
    if document.get("format") != FORMAT:
        raise ValueError(f"not a derivation: expected format {FORMAT}, found {document.get('format')}")
    skeleton = Skeleton.from_json(document["skeleton"])
    return Derivation(
        clip=Clip(document["name"], skeleton, document["fps"], arrays["root"], arrays["rotations"]),
        terminals=tuple(document["terminals"]),
        pieces=tuple(Segment(**piece) for piece in document["segments"]),
        spans=tuple((start, end) for start, end in document["spans"]),
        tree=_node(document["tree"]) if document["tree"] else None,
        jumps=tuple(document["jumps"]),
        seams=tuple((start, end) for start, end in document["seams"]),
        contacts=arrays["contacts"],
        skate=Skate(**document["skate"]),
        speeds=Speeds(**document["speeds"]),
        warnings=tuple(document["warnings"]),
    )


def _node(entry: Mapping[str, Any]) -> Node:
    leaf = Node(entry["symbol"], entry["start"], entry["end"])
    return (
        leaf
        if "rule" not in entry
        else leaf._replace(rule=entry["rule"], children=tuple(map(_node, entry["children"])))
    )
