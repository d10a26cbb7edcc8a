"""A derivation as it is kept: a JSON document and arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from core.grammar.trees import Node, tree_json
from core.mocap.clip import Segment
from core.synthesis.derivations import Derivation
from core.synthesis.packing import head_of, pack_made, quality_of, unpack_made

FORMAT = "motionscape/derivation/1"


def pack_derivation(made: Derivation) -> tuple[dict[str, Any], dict[str, np.ndarray]]:
    """The document, and the arrays ``root (n, 3)`` metres, ``rotations (n, n_joints, 4)`` and ``contacts (n, 2)``."""
    return pack_made(made, derivation_json(made))


def derivation_json(made: Derivation) -> dict[str, Any]:
    """All of a derivation but its motion: the sentence, where every frame comes from, and how well it was made."""
    return {
        **head_of(made, FORMAT),
        "terminals": list(made.terminals),
        "segments": [piece._asdict() for piece in made.pieces],
        "spans": [list(span) for span in made.spans],
        "tree": tree_json(made.tree) if made.tree else None,
        "jumps": list(made.jumps),
        **quality_of(made),
    }


def unpack_derivation(document: Mapping[str, Any], arrays: Mapping[str, np.ndarray]) -> Derivation:
    """The derivation back from :func:`pack_derivation`; arrays ``(n, ...)`` as there. Raises ValueError, KeyError,
    TypeError for others."""
    return Derivation(
        **unpack_made(document, arrays, FORMAT),
        terminals=tuple(document["terminals"]),
        pieces=tuple(Segment(**piece) for piece in document["segments"]),
        spans=tuple((start, end) for start, end in document["spans"]),
        tree=_node(document["tree"]) if document["tree"] else None,
        jumps=tuple(document["jumps"]),
    )


def _node(entry: Mapping[str, Any]) -> Node:
    leaf = Node(entry["symbol"], entry["start"], entry["end"])
    return (
        leaf
        if "rule" not in entry
        else leaf._replace(rule=entry["rule"], children=tuple(map(_node, entry["children"])))
    )
