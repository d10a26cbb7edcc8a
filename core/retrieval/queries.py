"""Queries: a stretch of motion, or a hybrid whose parts come from several (PCR sections 1 and 6)."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from core.errors import ParameterError
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset
from core.poses.body_parts import LEAVES, leaves_of


@dataclass(frozen=True, eq=False)
class QueryPart:
    """Frames ``[start, end)`` of a clip, at its own rate, of which only ``leaves`` count."""

    leaves: tuple[str, ...]
    clip: Clip
    start: int
    end: int

    def __post_init__(self) -> None:
        if not 0 <= self.start < self.end <= self.clip.n_frames:
            raise ParameterError(
                f"{self.clip.name} has frames 0 to {self.clip.n_frames}; {self.start} to {self.end} is no stretch of it"
            )

    @property
    def motion(self) -> Clip:
        """The frames as a clip of their own (views, not copies)."""
        return self.clip.cut(self.start, self.end)

    def same_recording(self, other: QueryPart) -> bool:
        """Whether it is of the recording that another part is of, be it opened twice."""
        a, b = self.clip, other.clip
        return a is b or (
            (a.name, a.n_frames, a.fps, a.skeleton.names) == (b.name, b.n_frames, b.fps, b.skeleton.names)
            and np.array_equal(a.root_positions, b.root_positions)
            and np.array_equal(a.rotations, b.rotations)
        )

    def same_stretch(self, other: QueryPart) -> bool:
        """Whether it is the very motion that another part is of."""
        return (self.start, self.end) == (other.start, other.end) and self.same_recording(other)


@dataclass(frozen=True, eq=False)
class Query:
    """A motion to search for: one part with all leaves, or several with some each.

    The clips need not be of the data set that is searched. Leaves that no part has are left out of the comparison.
    Raises ParameterError where there is no part, or a leaf is in two.
    """

    parts: tuple[QueryPart, ...]
    name: str

    def __post_init__(self) -> None:
        given = self.leaves
        if not given:
            raise ParameterError("a query needs at least one part of the body")
        twice = [leaf for leaf in LEAVES if given.count(leaf) > 1]
        if twice:
            raise ParameterError(f"{twice[0]} is given twice; every part of the body comes from one stretch")

    @property
    def leaves(self) -> tuple[str, ...]:
        """All leaves that the query has."""
        return tuple(leaf for part in self.parts for leaf in part.leaves)

    @property
    def hybrid(self) -> bool:
        """Whether its parts come from more than one stretch."""
        return not all(part.same_stretch(self.parts[0]) for part in self.parts[1:])

    @property
    def leading(self) -> QueryPart:
        """The part that gives the query its timing and path: that of the legs, else the one with most leaves."""
        return max(self.parts, key=lambda part: (sum("leg" in leaf for leaf in part.leaves), len(part.leaves)))


def whole_query(clip: Clip, start: int | None = None, end: int | None = None, name: str | None = None) -> Query:
    """The whole body in frames ``[start, end)`` of a clip (default: all). Raises ValueError for a bad stretch."""
    first, last = 0 if start is None else start, clip.n_frames if end is None else end
    whole = (first, last) == (0, clip.n_frames)
    part = QueryPart(LEAVES, clip, first, last)
    return Query((part,), name or (clip.name if whole else f"{clip.name}:{first}-{last}"))


def hybrid_query(assignment: Mapping[str, tuple[Clip, int | None, int | None]], name: str | None = None) -> Query:
    """A query whose parts come from several stretches: node or leaf -> (clip, start, end), None for the clip's ends.

    A leaf takes the stretch of the smallest node that was given and holds it, so ``whole_body`` with ``left_arm``
    replaces the left arm alone. Raises ValueError for an unknown part or a bad stretch.
    """
    owner: dict[str, str] = {}
    for node in sorted(assignment, key=lambda node: -len(leaves_of(node))):
        owner |= dict.fromkeys(leaves_of(node), node)
    stretches: dict[tuple[int, int, int], tuple[list[str], Clip]] = {}
    for leaf in LEAVES:
        if leaf in owner:
            clip, start, end = assignment[owner[leaf]]
            key = (id(clip), 0 if start is None else start, clip.n_frames if end is None else end)
            stretches.setdefault(key, ([], clip))[0].append(leaf)
    parts = tuple(QueryPart(tuple(leaves), clip, key[1], key[2]) for key, (leaves, clip) in stretches.items())
    return Query(parts, name or " + ".join(f"{part.clip.name}:{part.start}-{part.end}" for part in parts))


def parse_stretch(text: str, dataset: Dataset) -> tuple[Clip, int | None, int | None]:
    """``CLIP`` or ``CLIP:START-END`` as clip, start and end. Raises ParameterError, in plain words, for anything
    else.
    """
    names = dataset.names
    if text in names:
        return dataset.clip(text), None, None
    match = re.fullmatch(r"(.+):(\d{1,9})-(\d{1,9})", text, re.DOTALL)
    if match is None or match[1] not in names:
        name = match[1] if match else text
        known = ", ".join(names[:5]) + (", ..." if len(names) > 5 else "")
        raise ParameterError(
            f"no clip {name[:80]!r}; expected CLIP or CLIP:START-END, with one of {known or 'no clips'}"
        )
    clip, start, end = dataset.clip(match[1]), int(match[2]), int(match[3])
    if not start < end <= clip.n_frames:
        raise ParameterError(f"{text[:80]}: {clip.name} has frames 0 to {clip.n_frames}, the end excluded")
    return clip, start, end


def parse_query(text: str, dataset: Dataset) -> Query:
    """``CLIP`` or ``CLIP:START-END`` as a query named so. Raises ValueError, in plain words, for anything else."""
    return whole_query(*parse_stretch(text, dataset), name=text)
