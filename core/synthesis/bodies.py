"""One body for a stitched motion: which skeletons can pass motion to one another, and how."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from core.editing.contacts import floor_height
from core.mocap.anatomy import find_anatomy
from core.mocap.clip import Clip
from core.mocap.skeleton import Skeleton


def same_joints(a: Skeleton, b: Skeleton) -> bool:
    """Whether two skeletons have the same joints hanging together in the same way, whatever their bones measure."""
    return a.names == b.names and tuple(a.parents) == tuple(b.parents)


def commonest_body(clips: Iterable[Clip], seconds: Iterable[float]) -> Skeleton:
    """The skeleton that most of the time belongs to; ``seconds``: how much of each clip counts."""
    votes: dict[Skeleton, float] = {}
    for clip, time in zip(clips, seconds, strict=True):
        votes[clip.skeleton] = votes.get(clip.skeleton, 0.0) + time
    return max(votes, key=votes.__getitem__)


def floor_of(clip: Clip) -> float:
    """Height of the floor of a whole clip, metres (:func:`core.editing.contacts.floor_height`); kept while it lives."""
    if clip not in _floors:
        _floors[clip] = floor_height(clip)
    return _floors[clip]


def grounded(clip: Clip) -> Clip:
    """The clip with its floor at height 0 and every joint at its rest offset."""
    root = np.array(clip.root_positions, np.float32)
    root[:, 1] -= np.float32(floor_of(clip))
    return replace(clip, root_positions=root, translations={})


def fit_to_body(clip: Clip, skeleton: Skeleton) -> Clip:
    """The clip, on a floor at height 0, as another body of the same joints would move.

    Joint rotations are kept; the path and the height above the floor are scaled with the length of the legs (with the
    body height where there are none). Raises ValueError where the joints differ.
    """
    if clip.skeleton == skeleton:
        return clip
    if not same_joints(clip.skeleton, skeleton):
        raise ValueError(f"{clip.name} has other joints than the body it should move")
    size = _leg_length(skeleton) / _leg_length(clip.skeleton)
    return replace(clip, skeleton=skeleton, root_positions=(clip.root_positions * size).astype(np.float32))


def _leg_length(skeleton: Skeleton) -> float:
    anatomy = find_anatomy(skeleton)
    bones = np.linalg.norm(skeleton.offsets, axis=1)
    legs = [bones[knee] + bones[ankle] for _, knee, ankle in anatomy.legs]
    return float(np.mean(legs)) if legs else anatomy.body_height


_floors: WeakKeyDictionary[Clip, float] = WeakKeyDictionary()
