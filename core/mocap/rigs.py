"""Which skeletons can be compared: rigs that are one but for their size, and bodies of one kind."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from core.mocap.anatomy import find_anatomy
from core.mocap.skeleton import Skeleton

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

PEOPLE = "people"
_SAME_WAY = 0.8  # cosine of two bones that point the same way at rest
_SHORT = 0.03  # of the longest reach: bones too short to ask where they point


@dataclass(frozen=True, eq=False)
class Rig:
    """Joint names, and where each bone points at rest: ``(n_joints, 3)`` unit vectors, 0 for those that are short.

    Joints of one name turn about other axes where the bones point elsewhere at rest (another axis up, a T-pose and an
    A-pose), so what is learnt from the rotations of one rig says nothing of the other.
    """

    names: tuple[str, ...]
    directions: np.ndarray

    def fits(self, skeleton: Skeleton) -> bool:
        """Whether the skeleton is this rig, in whatever size."""
        if skeleton.names != self.names:
            return False
        cosines = (self.directions * rig_of(skeleton).directions).sum(1)
        both = self.directions.any(1) & rig_of(skeleton).directions.any(1)
        return bool((cosines[both] > _SAME_WAY).all())


def rig_of(skeleton: Skeleton) -> Rig:
    """The rig of a skeleton."""
    offsets = skeleton.offsets.astype(np.float64)
    length = np.linalg.norm(offsets, axis=1, keepdims=True)
    long = length > _SHORT * max(float(length.sum()) / 4, 1e-9)
    return Rig(skeleton.names, np.where(long, offsets / np.maximum(length, 1e-12), 0.0))


def rigs_of(skeletons: Iterable[Skeleton], known: Sequence[Rig] = ()) -> tuple[list[Rig], dict[Skeleton, int]]:
    """All rigs, those ``known`` first, and of each skeleton the number of its rig."""
    rigs, number = list(known), {}
    for skeleton in dict.fromkeys(skeletons):
        found = next((k for k, rig in enumerate(rigs) if rig.fits(skeleton)), len(rigs))
        if found == len(rigs):
            rigs.append(rig_of(skeleton))
        number[skeleton] = found
    return rigs, number


@dataclass(frozen=True)
class Group:
    """Clips whose bodies can be compared. words: what they are, for people; clips: their names; frames: of all."""

    words: str
    clips: tuple[str, ...]
    frames: int


def kinds_of(skeletons: Iterable[Skeleton], parts_with_people: bool = False) -> Mapping[Skeleton, str]:
    """What each skeleton can be compared with, in words: equal words, comparable bodies.

    All people are one kind, whatever their rig; people who lack the same parts are one; of anything else each rig is
    one. parts_with_people: people who lack something are people too.
    """
    skeletons = list(dict.fromkeys(skeletons))
    others = [skeleton for skeleton in skeletons if find_anatomy(skeleton).body == "other"]
    rigs, number = rigs_of(others)
    kinds = {}
    for skeleton in skeletons:
        anatomy = find_anatomy(skeleton)
        if anatomy.body == "human" or (parts_with_people and anatomy.body == "partial"):
            kinds[skeleton] = PEOPLE
        elif anatomy.body == "partial":
            kinds[skeleton] = f"people without {' and '.join(anatomy.missing)}"
        else:
            alike = sum(rig.names[0] == skeleton.names[0] for rig in rigs) > 1
            which = f", rig {number[skeleton] + 1}" if alike else ""
            kinds[skeleton] = f"the rig of {skeleton.names[0]} with {skeleton.n_joints} joints{which}"
    return kinds


def comparable_groups(dataset: Dataset, parts_with_people: bool = False) -> tuple[Group, ...]:
    """The clips of a dataset in groups that can be compared, the one with most frames first."""
    kinds = kinds_of((clip.skeleton for clip in dataset.clips), parts_with_people)
    members: dict[str, list[tuple[str, int]]] = {}
    for clip in dataset.clips:
        members.setdefault(kinds[clip.skeleton], []).append((clip.name, clip.n_frames))
    groups = [
        Group(words, tuple(name for name, _ in clips), sum(frames for _, frames in clips))
        for words, clips in members.items()
    ]
    return tuple(sorted(groups, key=lambda group: (-group.frames, group.words)))


def comparable(dataset: Dataset) -> Dataset:
    """Only the largest group of clips whose bodies can be compared; the dataset itself where all can be."""
    groups = comparable_groups(dataset)
    return dataset if len(groups) < 2 else dataset.select(groups[0].clips)


WITH_CLIPS = "choose them with --clips to analyse them among their own kind"


def left_out(dataset: Dataset, advice: str = WITH_CLIPS) -> str:
    """What :func:`comparable` leaves out, and the ``advice`` what to do, in words; empty where nothing is left out."""
    first, *others = comparable_groups(dataset) or [Group("", (), 0)]
    if not others:
        return ""
    named = "; ".join(f"{group.words}: {', '.join(group.clips[:3])}" + _more(group) for group in others[:3])
    rest = f"; and {len(others) - 3} kinds more" if len(others) > 3 else ""
    count = sum(len(group.clips) for group in others)
    return (
        f"{count} clip{'s' * (count > 1)} left out, for their bodies cannot be compared with those of {first.words} "
        f"({named}{rest}); {advice}"
    )


def kinds_in_words(dataset: Dataset) -> str:
    """The kinds of bodies in a dataset that a search keeps apart, in words; empty where there is one only."""
    groups = comparable_groups(dataset, parts_with_people=True)
    if len(groups) < 2:
        return ""
    counted = (f"{group.words} ({len(group.clips):,} clip{'s' * (len(group.clips) > 1)})" for group in groups[:4])
    more = f" and {len(groups) - 4} kinds more" if len(groups) > 4 else ""
    return f"a search finds clips of its query's kind of body only; there are {'; '.join(counted)}{more}"


def _more(group: Group) -> str:
    return f" and {len(group.clips) - 3} more" if len(group.clips) > 3 else ""
