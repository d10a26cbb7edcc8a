"""Curves of clips for the Clip page, with the last few kept in memory, and what the page shows of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from core.caching import RecentCache
from core.editing.curves import TRAVEL, ClipCurves, Curve
from core.mocap.dataset import Dataset
from core.mocap.skeleton import Skeleton
from core.poses.angles import JOINTS
from core.poses.body_frames import BodyFrames, body_frames

CHARTS = {"angles": "Angles", "speeds": "Speeds", "contacts": "Feet", "path": "Path"}
KINDS = {"body": "Anatomical", "file": "File channels"}
_DEFAULT = {
    "angles": ("left_hip", "right_hip", "left_knee", "right_knee"),
    "speeds": (TRAVEL, "left_wrist", "right_wrist"),
}


class Choice(NamedTuple):
    """The part of a clip that is shown, read from the store "view".

    chart: one of :data:`CHARTS`; kind: of angles, one of :data:`KINDS`; joints: names of what has such curves (numbers
    of joints where the kind is "file"); channels: names of angles; span: seconds from and to, None for the whole clip.
    """

    chart: str
    kind: str
    joints: tuple[str, ...]
    channels: tuple[str, ...]
    span: tuple[float, float] | None


def clip_curves(dataset: Dataset, name: str) -> ClipCurves:
    """The curves of a clip; the last few stay in memory. Raises KeyError where there is no such clip."""

    def compute() -> ClipCurves:
        clip = dataset.clip(name)
        return ClipCurves(clip, frames_of(dataset, clip.skeleton))

    return _clips.get_or_compute((dataset.fingerprint, name), compute)


def frames_of(dataset: Dataset, skeleton: Skeleton) -> BodyFrames:
    """Anatomical frames of a skeleton from all clips of the data set that have it, so that all share one zero."""
    return _bodies.get_or_compute(
        (dataset.fingerprint, skeleton.fingerprint),
        lambda: body_frames([clip for clip in dataset.clips if clip.skeleton == skeleton]),
    )


def choice(view: Mapping[str, str] | None, curves: ClipCurves) -> Choice:
    """What ``view`` asks for where this clip has it; defaults for the rest."""
    view = view or {}
    chart, kind = view.get("chart", ""), view.get("angles", "")
    chart = chart if chart in CHARTS else "angles"
    kind = kind if kind in KINDS else "body"
    if not curves.angle_joints:
        kind = "file"
    offered = offered_joints(curves, chart, kind)
    joints = tuple(
        name for name in _words(view, "rig" if chart == "angles" and kind == "file" else "joints") if name in offered
    )
    if not joints:
        defaults = offered[:3] if kind == "file" and chart == "angles" else _DEFAULT.get(chart, ())
        joints = tuple(name for name in defaults if name in offered) or offered[:2]
    channels = tuple(_words(view, "channels")) or ("flexion", "tilt")
    return Choice(chart, kind, joints, channels, _span(view.get("span"), curves.clip.seconds))


def offered_joints(curves: ClipCurves, chart: str, kind: str) -> tuple[str, ...]:
    """Names (or numbers, see :class:`Choice`) of the joints that one may choose for a chart."""
    if chart == "angles":
        return curves.angle_joints if kind == "body" else tuple(map(str, curves.turning_joints))
    return (TRAVEL, *curves.joints) if chart == "speeds" else ()


def chosen_curves(curves: ClipCurves, chosen: Choice) -> list[Curve]:
    """The curves a chart shows. Joints without any of the chosen channels show their first."""
    if chosen.chart == "speeds":
        return curves.speeds(chosen.joints)
    if chosen.chart == "contacts":
        return [curve for curve in curves.feet() if not curve.step]
    if chosen.chart == "path":
        return []
    if chosen.kind == "file":
        return curves.channels(map(int, chosen.joints))
    chosen_angles = []
    for joint in chosen.joints:
        names = [channel.name for channel in JOINTS[joint].channels]
        chosen_angles += curves.angles([joint], [n for n in names if n in chosen.channels] or names[:1])
    return chosen_angles


def joint_words(name: str) -> str:
    """A canonical joint's name as people write it: ``Left knee``."""
    return name.replace("_", " ").capitalize()


def side_of(name: str) -> str:
    """``"left"``, ``"right"`` or ``"centre"`` for the name of a canonical joint or a foot."""
    side = name.partition("_")[0]
    return side if side in ("left", "right") else "centre"


def _words(view: Mapping[str, str], key: str) -> list[str]:
    return list(dict.fromkeys(word for word in view.get(key, "").split(",") if word))


def _span(text: str | None, seconds: float) -> tuple[float, float] | None:
    try:
        low, high = (float(part) for part in (text or "").split("_"))
    except ValueError:
        return None
    low, high = max(low, 0.0), min(high, seconds)
    return (low, high) if low < high and (low > 0 or high < seconds) else None


_clips: RecentCache[tuple[str, str], ClipCurves] = RecentCache(4)  # by data set and clip
_bodies: RecentCache[tuple[str, str], BodyFrames] = RecentCache(16)  # by data set and skeleton
