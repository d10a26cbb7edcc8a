"""A search as a link writes it: the query, the weights of the parts of the body, and the hit that is shown.

One piece is ``[part+part:]clip:start-end[:dataset]``, pieces are joined by commas: the parts of the body it gives (all
where none is named), the clip, its frames at its own rate (end exclusive), and the data set where it is another than
the one searched, which may be made-up motion (shell/virtual.py). Characters of names that have a meaning in a
link are escaped: ``~`` and two hexadecimal digits for each byte.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from core.errors import ParameterError
from core.mocap.clip import Segment
from core.poses.body_parts import CHILDREN, LEAVES, leaves_of

MOST_PIECES = 6
_PLAIN = re.compile(r"[-0-9A-Za-z._ ]")
_RANGE = re.compile(r"(\d{1,8})-(\d{1,8})")


class Piece(NamedTuple):
    """Frames ``[start, end)`` of a clip that give the ``leaves`` of the body; ``dataset``: "" for the one searched."""

    clip: str
    start: int
    end: int
    leaves: tuple[str, ...] = LEAVES
    dataset: str = ""


def read_query(text: str) -> tuple[Piece, ...]:
    """The pieces of a query in a link. Raises ParameterError."""
    words = text.split(",") if text else []
    if not 1 <= len(words) <= MOST_PIECES:
        raise ParameterError(f"a query has 1 to {MOST_PIECES} pieces, not {len(words)}")
    pieces = tuple(_read_piece(word) for word in words)
    leaves_given = [leaf for piece in pieces for leaf in piece.leaves]
    if len(leaves_given) != len(set(leaves_given)):
        raise ParameterError("each part of the body comes from one piece only")
    return pieces


def write_query(pieces: Iterable[Piece]) -> str:
    """The pieces as a link writes them; :func:`read_query` gives them back."""
    return ",".join(map(_write_piece, pieces))


def read_hit(text: str) -> Segment | None:
    """The hit that a link names, or None where it names none."""
    try:
        piece = _read_piece(text)
    except ParameterError:
        return None
    return Segment(piece.clip, piece.start, piece.end)


def write_hit(segment: Segment) -> str:
    """A hit as a link writes it."""
    return f"{escape(segment.clip)}:{segment.start}-{segment.end}"


def read_weights(text: str | None) -> dict[str, float] | None:
    """Weights of parts from a link (``left_arm:35,right_arm:45``); None for the whole body alike.

    Raises ParameterError where they cannot be read, or all are zero.
    """
    if not text:
        return None
    weights: dict[str, float] = {}
    for word in text.split(","):
        match = re.fullmatch(r"([a-z_]{1,20}):(\d{1,4}(?:\.\d{1,4})?)", word)
        if not match or match[1] not in CHILDREN:
            raise ParameterError("weights of body parts look like left_arm:35,right_arm:45")
        weights[match[1]] = float(match[2])
    if not any(weights.values()):
        raise ParameterError("all parts of the body are switched off; switch on at least one")
    return weights


def write_weights(weights: Mapping[str, float] | None) -> str:
    """Weights as a link writes them; parts without weight are left out."""
    return ",".join(f"{part}:{weight:g}" for part, weight in (weights or {}).items() if weight > 0)


def nodes_of(leaves: Sequence[str]) -> tuple[str, ...]:
    """The fewest nodes of the hierarchy that have exactly these leaves below them."""
    target = set(leaves)

    def cover(node: str) -> tuple[str, ...]:
        if target.issuperset(leaves_of(node)):
            return (node,)
        return tuple(named for child in CHILDREN[node] for named in cover(child))

    return cover("whole_body")


def escape(name: str) -> str:
    """A name as it may stand in a link."""
    return "".join(c if _PLAIN.fullmatch(c) else "".join(f"~{byte:02x}" for byte in c.encode()) for c in name)


def unescape(text: str) -> str:
    """The name back from :func:`escape`. Raises ParameterError where it is damaged."""
    if re.search(r"~(?![0-9a-f]{2})", text):
        raise ParameterError("a name in the link is damaged")
    encoded = re.sub(rb"~([0-9a-f]{2})", lambda named: bytes([int(named[1], 16)]), text.encode())
    try:
        return encoded.decode()
    except UnicodeDecodeError:
        raise ParameterError("a name in the link is damaged") from None


def _read_piece(word: str) -> Piece:
    fields = word.split(":")
    at = next((k for k in (-1, -2) if len(fields) >= 1 - k and _RANGE.fullmatch(fields[k])), None)
    match = _RANGE.fullmatch(fields[at]) if at is not None else None
    rest = fields[:at] if at is not None else []
    if match is None or len(rest) not in (1, 2) or not rest[-1]:
        raise ParameterError("a piece of a query looks like walk_01:10-90 or upper_body:walk_01:10-90")
    start, end = int(match[1]), int(match[2])
    if start >= end:
        raise ParameterError(f"frames {start} to {end} of a query are none; the end comes after the start")
    leaves = _leaves(rest[0].split("+")) if len(rest) == 2 else LEAVES
    clip, dataset = unescape(rest[-1]), unescape(fields[-1]) if at == -2 else ""
    return Piece(clip, start, end, leaves, dataset)


def _leaves(nodes: Iterable[str]) -> tuple[str, ...]:
    named = {leaf for node in nodes for leaf in leaves_of(node)}
    return tuple(leaf for leaf in LEAVES if leaf in named)


def _write_piece(piece: Piece) -> str:
    parts = [] if len(piece.leaves) == len(LEAVES) else ["+".join(nodes_of(piece.leaves))]
    return ":".join(
        [*parts, escape(piece.clip), f"{piece.start}-{piece.end}", *([escape(piece.dataset)] if piece.dataset else [])]
    )
