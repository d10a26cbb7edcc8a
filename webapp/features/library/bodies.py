"""Bodies of a data set as the editor shows them: its rigs, a posture from the front and from the side, corrections."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from core.errors import FormatError
from core.mocap.anatomy import SIDES, find_anatomy, suggested_joints
from core.mocap.clip import Clip
from core.mocap.corrections import BodyCorrections, RigCorrection, from_json
from core.mocap.dataset import Dataset
from core.mocap.kinematics import forward_kinematics
from core.mocap.skeleton import Skeleton

REST = -1  # the frame that stands for the rest pose
WIDTH, HEIGHT, MARGIN = 100.0, 150.0, 8.0  # of a drawing


class EditedRig(NamedTuple):
    """Clips whose joints have the same names: one correction serves them all. skeleton: that of the first clip."""

    skeleton: Skeleton
    clips: tuple[Clip, ...]


def edited_rigs(dataset: Dataset) -> list[EditedRig]:
    """The rigs of a data set, the one with most clips first."""
    clips: dict[tuple[str, ...], list[Clip]] = {}
    for clip in dataset.clips:
        clips.setdefault(clip.skeleton.names, []).append(clip)
    rigs = [EditedRig(some[0].skeleton, tuple(some)) for some in clips.values()]
    return sorted(rigs, key=lambda rig: -len(rig.clips))


def rig_entry(rig: EditedRig) -> dict[str, Any]:
    """A rig for the browser: its joints, which part of the body each is, and what someone said about it."""
    skeleton, anatomy = rig.skeleton, find_anatomy(rig.skeleton)
    n = len(rig.clips)
    return {
        "names": list(skeleton.names),
        "parents": [int(parent) for parent in skeleton.parents],
        "ends": [bool(end) for end in skeleton.end_sites],
        "joints": {part: skeleton.names[joint] for part, joint in anatomy.joints.items()},
        "said": dict(skeleton.corrections),
        "suggested": suggestions(skeleton),
        "body": anatomy.body,
        "said_body": skeleton.body,
        "words": f"{skeleton.names[0]}, {skeleton.n_joints} joints, {n:,} clip{'s' if n != 1 else ''}",
    }


def suggestions(skeleton: Skeleton) -> dict[str, str]:
    """Part of the body -> joint to begin with, for what is no human and was said nothing about; else nothing."""
    if find_anatomy(skeleton).body != "other" or skeleton.is_corrected:
        return {}
    found = suggested_joints(skeleton)
    return {part: skeleton.names[j] for part, j in found.items() if list(found.values()).count(j) == 1}


def clip_of(rig: EditedRig, name: str | None) -> Clip:
    """The clip of the rig with this name; its first where there is none."""
    return next((clip for clip in rig.clips if clip.name == name), rig.clips[0])


def posture(clip: Clip, frame: int) -> dict[str, list[list[float]]]:
    """A frame of a clip from the front and from the left: places of all joints in a drawing.

    frame: REST for the rest pose. The drawing is WIDTH by HEIGHT, y downwards; both views have one scale.
    """
    positions = _positions(clip, frame)
    left = _left(clip.skeleton, positions)
    forward = np.array([-left[2], 0.0, left[0]])  # Y up, right-handed
    views = [np.stack([positions @ across, -positions[:, 1]], axis=1) for across in (left, -forward)]
    size = np.max([np.ptp(view, axis=0) for view in views], axis=0)
    scale = min((WIDTH - 2 * MARGIN) / max(size[0], 1e-6), (HEIGHT - 2 * MARGIN) / max(size[1], 1e-6))
    middle = np.array([WIDTH, HEIGHT]) / 2
    placed = [(view - (view.min(axis=0) + view.max(axis=0)) / 2) * scale + middle for view in views]
    return {name: np.round(view, 2).tolist() for name, view in zip(("front", "side"), placed, strict=True)}


def _positions(clip: Clip, frame: int) -> np.ndarray:
    """``(n_joints, 3)`` of a frame, in metres."""
    if frame > REST:
        k = min(frame, clip.n_frames - 1)
        return np.asarray(forward_kinematics(clip.cut(k, k + 1))[0][0], float)
    places = np.zeros((clip.skeleton.n_joints, 3))
    for joint, parent in enumerate(clip.skeleton.parents):
        if parent >= 0:
            places[joint] = places[parent] + clip.skeleton.offsets[joint]
    return places


def _left(skeleton: Skeleton, positions: np.ndarray) -> np.ndarray:
    """The direction of the body's left on the ground: a unit vector; X where the body does not say."""
    joints, left = find_anatomy(skeleton).joints, np.zeros(3)
    for part in ("hip", "shoulder"):
        pair = [joints.get(f"{side}_{part}") for side in SIDES]
        if pair[0] is not None and pair[1] is not None:
            left += positions[pair[0]] - positions[pair[1]]
    left[1] = 0.0
    length = float(np.linalg.norm(left))
    return left / length if length > 1e-6 else np.array([1.0, 0.0, 0.0])


def drafted(rigs: Sequence[EditedRig], draft: Sequence[Mapping[str, Any]]) -> BodyCorrections:
    """The corrections of those rigs of a draft that were changed.

    Raises FormatError or ParameterError, in words, where one does not fit its rig.
    """
    changed = []
    for rig, entry in zip(rigs, draft, strict=False):
        if not entry.get("changed"):
            continue
        names = list(rig.skeleton.names)
        (correction,) = from_json({"rig": names, "joints": entry.get("joints"), "body": entry.get("body")}).rigs
        BodyCorrections((correction,)).applied(rig.skeleton)
        changed.append(correction)
    return BodyCorrections(tuple(changed))


def fitting(rigs: Sequence[EditedRig], text: str) -> list[dict[str, Any] | None]:
    """What a JSON file of corrections says of each rig, None where it says nothing.

    Raises FormatError where it is none, or fits no rig here.
    """
    try:
        corrections = from_json(json.loads(text))
    except (ValueError, RecursionError) as error:
        raise error if isinstance(error, FormatError) else FormatError("This file is not JSON.") from None
    found = [_last_fitting(corrections, rig.skeleton) for rig in rigs]
    if not any(found):
        raise FormatError("None of these corrections is for a rig of this dataset: the names of the joints differ.")
    return [{"joints": dict(one.joints), "body": one.body} if one else None for one in found]


def _last_fitting(corrections: BodyCorrections, skeleton: Skeleton) -> RigCorrection | None:
    return next((rig for rig in reversed(corrections.rigs) if rig.fits(skeleton)), None)
