"""Which joint of a hierarchy is the pelvis: the joints above it only carry its path."""

from __future__ import annotations

import re
from collections.abc import Sequence

PELVIS = re.compile(r"((^|[^a-z])hip|hips|pelvis)[\W\d_]*$", re.IGNORECASE)
TRUNK = re.compile(r"spine|chest|thorax|torso|abdomen|waist|back|neck|belly|上半身", re.IGNORECASE)


def find_pelvis(names: Sequence[str], children: Sequence[Sequence[int]]) -> int:
    """Index of the pelvis: the first branching joint below the root, or a joint named hips or pelvis above it.

    children: for each joint the joints that hang from it, end sites left out. The root (0) is the answer where nothing
    branches, and where a part of the trunk stands between: then the upper joints are a spine, not a path.
    """
    chain = [0]
    while len(children[chain[-1]]) == 1:
        chain.append(children[chain[-1]][0])
    if not children[chain[-1]]:
        return 0
    for joint in chain:
        if PELVIS.search(names[joint]):
            return joint
    return 0 if any(TRUNK.search(names[joint]) for joint in chain) else chain[-1]
