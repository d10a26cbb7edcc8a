"""Training and test clips by person, so that a test never sees a person, or a copy of a motion, it was trained on."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping, Sequence

from core.errors import ParameterError
from core.inspection.duplicates import find_duplicates
from core.mocap.clip import Clip
from core.mocap.dataset import motion_digest

TEST_SHARE = 0.2
_SUBJECT = re.compile(r"subject[ _-]?\w+", re.IGNORECASE)
_TAKE = re.compile(r"[ _-]?\d+$")


def subject_of(name: str) -> str:
    """The person of a clip, from its name: ``86_03`` -> 86, ``walk1_subject5`` -> subject5.

    Where names tell the take and not the person (``bow_normal_001``) it is what the takes have in common.
    """
    stem = name.replace("\\", "/").rsplit("/", 1)[-1]
    named = _SUBJECT.search(stem)
    return named.group().lower() if named else _TAKE.sub("", stem) or stem


def motion_groups(clips: Sequence[Clip]) -> tuple[str, ...]:
    """A group name per clip, ``(n_clips,)``: clips of one subject, copies, and pieces of another clip share one.

    Copies are those that :func:`core.inspection.duplicates.find_duplicates` finds; a piece is a clip whose name goes on
    from that of another (``walk_01 mirrored``).
    """
    parent = list(range(len(clips)))

    def root(k: int) -> int:
        while parent[k] != k:
            parent[k] = parent[parent[k]]
            k = parent[k]
        return k

    def join(a: int, b: int) -> None:
        a, b = sorted((root(a), root(b)))
        parent[b] = a

    first: dict[str, int] = {}
    names = {clip.name: k for k, clip in enumerate(clips)}
    for k, clip in enumerate(clips):
        join(k, first.setdefault(subject_of(clip.name), k))
        for cut in range(1, len(clip.name)):
            if not clip.name[cut].isalnum() and clip.name[cut] != "_" and clip.name[:cut] in names:
                join(k, names[clip.name[:cut]])
    for k, others in find_duplicates(clips, [motion_digest(clip) for clip in clips], [0] * len(clips)).items():
        for other in others:
            join(k, other)
    return tuple(subject_of(clips[root(k)].name) for k in range(len(clips)))


def split_groups(groups: Sequence[str], sizes: Sequence[int], share: float = TEST_SHARE) -> Mapping[str, str]:
    """Group -> "train" or "test": whole groups go to the test until it has about ``share`` of all frames.

    groups, sizes: group and number of frames of each clip. The order is that of a hash of the name: it neither follows
    the alphabet nor changes from run to run. A group that is larger than twice what is missing stays in the training;
    where all are, the smallest is tested; one group alone trains. Raises ParameterError for a share not between 0 and
    1.
    """
    if not 0 <= share < 1:
        raise ParameterError(f"the share of the test must be from 0 to below 1, not {share}")
    frames: dict[str, int] = {}
    for group, size in zip(groups, sizes, strict=True):
        frames[group] = frames.get(group, 0) + int(size)
    wanted = share * sum(frames.values())
    order = sorted(frames, key=lambda group: hashlib.blake2b(group.encode(), digest_size=8).digest())
    test: set[str] = set()
    taken = 0
    for group in order:
        if len(frames) - len(test) > 1 and 0 < frames[group] <= 2 * (wanted - taken):
            test.add(group)
            taken += frames[group]
    if not test and len(frames) > 1 and share > 0:
        test.add(min(order, key=frames.__getitem__))
    return {group: "test" if group in test else "train" for group in frames}
