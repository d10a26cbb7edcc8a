"""Corrections of a body: which joint of a rig is which part, where the names or the shape mislead; as JSON too.

A rig is known by the names of its joints: one correction serves all clips of it, of whatever size.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from core.errors import FormatError, ParameterError
from core.mocap.anatomy import CANONICAL, find_anatomy
from core.mocap.body_kinds import BodyKind
from core.mocap.skeleton import Skeleton

FORMAT = "motionscape/body/1"
KINDS = ("human", "partial", "other")


@dataclass(frozen=True)
class RigCorrection:
    """What was said about a rig.

    rig: the names of its joints, in order; empty for every rig that has the joints named here. joints: (canonical name
    of core.mocap.anatomy.CANONICAL, joint name or None for "there is none"). body: the kind of body, None to find out.
    """

    rig: tuple[str, ...] = ()
    joints: tuple[tuple[str, str | None], ...] = ()
    body: BodyKind | None = None

    def fits(self, skeleton: Skeleton) -> bool:
        """Whether it is meant for this skeleton."""
        if self.rig:
            return self.rig == skeleton.names
        return all(joint in skeleton.names for _, joint in self.joints if joint is not None)


@dataclass(frozen=True)
class BodyCorrections:
    """Corrections of one or several rigs; of two that fit a skeleton the later counts."""

    rigs: tuple[RigCorrection, ...] = ()

    def applied(self, skeleton: Skeleton) -> Skeleton:
        """The skeleton with the correction that fits it; the same object where none does.

        Raises ParameterError where two parts of the body are one joint.
        """
        fitting = [rig for rig in self.rigs if rig.fits(skeleton)]
        if not fitting:
            return skeleton
        corrected = replace(skeleton, corrections=fitting[-1].joints, body=fitting[-1].body)
        joints = find_anatomy(corrected).joints
        twice = [name for name, joint in joints.items() if list(joints.values()).count(joint) > 1]
        if twice and corrected != skeleton:
            joint = skeleton.names[joints[twice[0]]]
            raise ParameterError(
                f"{' and '.join(twice)} cannot both be {joint!r}; give one of them another joint, or null"
            )
        return corrected


def correction_of(skeleton: Skeleton) -> RigCorrection:
    """All of the body that is known of a rig, as a correction that can be changed and given back."""
    anatomy = find_anatomy(skeleton)
    joints = {name: skeleton.names[joint] for name, joint in anatomy.joints.items()}
    return RigCorrection(skeleton.names, tuple((name, joints.get(name)) for name in CANONICAL), anatomy.body)


def corrections_of(skeletons: Iterable[Skeleton], only_corrected: bool = False) -> BodyCorrections:
    """A correction for each rig among ``skeletons``; ``only_corrected``: of those where someone said something."""
    rigs = {skeleton.names: skeleton for skeleton in skeletons if skeleton.is_corrected or not only_corrected}
    return BodyCorrections(tuple(correction_of(skeleton) for skeleton in rigs.values()))


def to_json(corrections: BodyCorrections) -> dict[str, Any]:
    """Plain values; :func:`from_json` gives the corrections back."""
    rigs = [{"rig": list(rig.rig), "body": rig.body, "joints": dict(rig.joints)} for rig in corrections.rigs]
    return {"format": FORMAT, "rigs": rigs}


def from_json(document: Any) -> BodyCorrections:
    """The corrections that :func:`to_json` wrote, or of one rig: ``{"left_hip": "LegL", "neck": null}``.

    Raises FormatError, which says what is wrong, for anything else.
    """
    if not isinstance(document, Mapping):
        raise FormatError("body corrections are a JSON object")
    if "rigs" not in document:
        entry = document if "joints" in document else {"joints": document}
        return BodyCorrections((_rig(entry),))
    if document.get("format", FORMAT) != FORMAT:
        raise FormatError(f"body corrections of format {str(document['format'])[:40]!r}; expected {FORMAT}")
    if not isinstance(document["rigs"], list):
        raise FormatError("'rigs' must be a list")
    return BodyCorrections(tuple(map(_rig, document["rigs"])))


def _rig(entry: Any) -> RigCorrection:
    joints = entry.get("joints", {}) if isinstance(entry, Mapping) else None
    if not isinstance(joints, Mapping):
        raise FormatError("a body correction needs 'joints': part of the body -> joint name, or null")
    for name, joint in joints.items():
        if name not in CANONICAL:
            raise FormatError(f"{str(name)[:40]!r} is no part of the body; the parts are {', '.join(CANONICAL)}")
        if joint is not None and not isinstance(joint, str):
            raise FormatError(f"{name}: expected the name of a joint, or null")
    rig, body = entry.get("rig") or (), entry.get("body")
    if not isinstance(rig, list | tuple) or not all(isinstance(name, str) for name in rig):
        raise FormatError("'rig' must be the names of all joints")
    if body not in (None, *KINDS):
        raise FormatError(f"'body' must be one of {', '.join(KINDS)}, or null")
    unknown = [joint for joint in joints.values() if rig and joint is not None and joint not in rig]
    if unknown:
        raise FormatError(f"the rig has no joint {unknown[0][:40]!r}")
    return RigCorrection(tuple(rig), tuple(sorted(joints.items())), body)


def read_corrections(path: str | Path) -> BodyCorrections:
    """Corrections from a JSON file. Raises FormatError, naming the file, where it is none; OSError."""
    try:
        return from_json(json.loads(Path(path).read_text(encoding="utf-8-sig")))
    except (UnicodeDecodeError, json.JSONDecodeError, RecursionError) as error:
        raise FormatError(f"{Path(path).name}: not JSON ({error})") from None
    except FormatError as error:
        raise FormatError(f"{Path(path).name}: {error}") from None
