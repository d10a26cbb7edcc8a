"""Limbs told from the shape of a skeleton's tree: mirror pairs of long chains. Used where names say nothing."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from core.mocap.skeleton import Skeleton


def ancestors(skeleton: Skeleton, joint: int) -> list[int]:
    """Indices from the joint's parent up to the root."""
    chains = []
    while (joint := skeleton.parents[joint]) >= 0:
        chains.append(joint)
    return chains


def path(skeleton: Skeleton, top: int, bottom: int) -> list[int]:
    """Indices from ``top`` down to ``bottom``, both included; empty where ``bottom`` does not hang from ``top``."""
    line = [bottom, *ancestors(skeleton, bottom)]
    return line[: line.index(top) + 1][::-1] if top in line else []


def common_ancestor(skeleton: Skeleton, a: int, b: int) -> int:
    """The lowest joint from which both (other) joints hang."""
    return max(set(ancestors(skeleton, a)) & set(ancestors(skeleton, b)), default=0)


def subtree(skeleton: Skeleton, joint: int) -> list[int]:
    """The joint and all that hangs from it, ascending."""
    inside = {joint}
    for j in range(joint + 1, skeleton.n_joints):
        if skeleton.parents[j] in inside:
            inside.add(j)
    return sorted(inside)


def reach(skeleton: Skeleton) -> np.ndarray:
    """Length of the longest path of bones below each joint: ``(n_joints,)``, metres."""
    length = np.linalg.norm(skeleton.offsets.astype(np.float64), axis=1)
    below = np.zeros(skeleton.n_joints)
    for j in range(skeleton.n_joints - 1, 0, -1):
        parent = skeleton.parents[j]
        below[parent] = max(below[parent], below[j] + length[j])
    return below


def longest_path(skeleton: Skeleton, joint: int, avoid: Sequence[int] = ()) -> list[int]:
    """From below ``joint`` down the longest path of bones to a leaf; never through ``avoid``."""
    length = np.linalg.norm(skeleton.offsets, axis=1) + reach(skeleton)
    line: list[int] = []
    while children := [j for j in skeleton.children(joint) if j not in avoid]:
        joint = max(children, key=lambda j: length[j])
        line.append(joint)
    return line


def head_of(skeleton: Skeleton, line: Sequence[int]) -> int | None:
    """The head on the path above the chest: where a face branches off, else the last joint that is no end site."""
    joints = [j for j in line if not skeleton.end_sites[j]]
    return next((j for j in joints[1:] if len(skeleton.children(j)) > 1), joints[-1] if joints else None)


def find_limbs(skeleton: Skeleton) -> dict[str, tuple[dict[str, int], dict[str, int]]]:
    """Legs and arms as pairs of ``{part: joint}``, sides unknown; a limb that cannot be told is left out.

    A pair of limbs is two subtrees of one joint with about the same reach. The pair nearest the root are the legs; of
    the others, the pair with the greatest reach that does not hang from a leg are the arms.
    """
    pairs = _mirror_pairs(skeleton)
    if not pairs:
        return {}
    depth = {p: len(ancestors(skeleton, p)) for p, _, _ in pairs}
    below = reach(skeleton) + np.linalg.norm(skeleton.offsets, axis=1)
    legs = min(pairs, key=lambda pair: (depth[pair[0]], -below[pair[1]]))
    used = {j for top in legs[1:] for j in subtree(skeleton, top)}
    others = [pair for pair in pairs if pair != legs and pair[0] not in used]
    chosen = {"leg": legs, **({"arm": max(others, key=lambda pair: below[pair[1]])} if others else {})}
    limbs = {}
    for limb, (_, *tops) in chosen.items():
        left, right = (_limb_joints(skeleton, top, limb) for top in tops)
        if left and right:
            limbs[limb] = left, right
    return limbs


def leftness(skeleton: Skeleton, chain: dict[str, int]) -> float:
    """How far to the left a limb lies at rest, metres: facing where the feet point, or Z where they do not."""
    positions = np.zeros((skeleton.n_joints, 3))
    for j in range(1, skeleton.n_joints):
        positions[j] = positions[skeleton.parents[j]] + skeleton.offsets[j]
    forward = np.zeros(3)
    for leg in find_limbs(skeleton).get("leg", ()):
        if "toe" in leg:
            forward += (positions[leg["toe"]] - positions[leg["ankle"]]) * [1, 0, 1]
    if np.linalg.norm(forward) < 1e-3 * reach(skeleton)[0]:
        forward = np.array([0.0, 0.0, 1.0])
    left = np.cross([0, 1, 0], forward / np.linalg.norm(forward))
    return float(np.mean([positions[j] for j in chain.values()], axis=0) @ left)


def _mirror_pairs(skeleton: Skeleton) -> list[tuple[int, int, int]]:
    """(parent, child, child) where both children reach equally far (3 %), and at least a fifth of the body."""
    below = reach(skeleton)
    length = np.linalg.norm(skeleton.offsets, axis=1) + below
    pairs = []
    for parent in range(skeleton.n_joints):
        children = [j for j in skeleton.children(parent) if length[j] > 0.2 * below[0] and not skeleton.end_sites[j]]
        best = None
        for k, a in enumerate(children):
            for b in children[k + 1 :]:
                gap = abs(length[a] - length[b]) / max(length[a], length[b])
                alike = abs(len(subtree(skeleton, a)) - len(subtree(skeleton, b))) <= 2
                if gap < 0.03 and alike and (best is None or gap < best[0]):
                    best = (gap, a, b)
        if best:
            pairs.append((parent, *best[1:]))
    return pairs


def _limb_joints(skeleton: Skeleton, top: int, limb: str) -> dict[str, int]:
    """The two long neighbouring bones of the chain are thigh and shin, or upper arm and forearm."""
    line = [top, *longest_path(skeleton, top)]
    length = np.linalg.norm(skeleton.offsets, axis=1)
    keep = [line[0], *(j for j in line[1:] if length[j] > 0.02 * length[line].sum())]
    if len(keep) < 3:
        return {}
    pairs = [min(length[keep[k + 1]], length[keep[k + 2]]) for k in range(len(keep) - 2)]
    # a clavicle may be as long as a forearm: of nearly equal pairs, the one further out
    k = int(np.flatnonzero(np.array(pairs) >= 0.85 * max(pairs))[-1])
    names = ("hip", "knee", "ankle", "toe") if limb == "leg" else ("shoulder", "elbow", "wrist")
    joints = dict(zip(names, keep[k:], strict=False))
    if "toe" in joints and skeleton.end_sites[joints["toe"]]:
        del joints["toe"]
    if limb == "arm" and k:
        joints = {"clavicle": keep[k - 1], **joints}
    return joints
