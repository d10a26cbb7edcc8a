"""BVH: read any exporter's files, write files that other tools open."""

from __future__ import annotations

import gzip
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from core.mocap import quaternions as quat
from core.mocap.bvh_parser import RawBvh, RawJoint, parse_bvh
from core.mocap.clip import Clip
from core.mocap.euler import rotations_from_angles
from core.mocap.files import replacing
from core.mocap.gaps import fill_rotations, fill_track
from core.mocap.pelvis import find_pelvis
from core.mocap.reports import Finding
from core.mocap.skeleton import Skeleton
from core.mocap.text import read_bytes, recording_format
from core.mocap.units import guess_unit, span

_STILL = 1e-6  # of the body's span: position channels that stay within it do not move
_LOOKED_AT = 32  # frames that are looked at to tell displacements from places
_NEAR, _MOST_DISPLACED, _FEWEST_DISPLACED = 0.3, 0.8, 2  # of OFFSET's length, of the joints, joints


def read_bvh(path: str | Path, unit: float | None = None, fps: float | None = None) -> Clip:
    """A recording from a ``.bvh`` or ``.bvh.gz`` file; of several skeletons in one file, the first.

    unit: metres per unit of the file; guessed from the body's size where not given, see the clip's notes. fps: frames
    per second, in place of what the file says. Raises RecordingError for what is no recording, see read_bvh_clips.
    """
    return read_bvh_clips(path, unit, fps)[0]


def read_bvh_clips(path: str | Path, unit: float | None = None, fps: float | None = None) -> tuple[Clip, ...]:
    """A clip for each ROOT of a BVH file; all but the first have the root's name behind the file's.

    Position channels replace OFFSET; where nearly all are 0 they are added to it. Joints above the pelvis are folded
    into its path; another joint whose position channels move gets a translation track. A few damaged frames are filled
    from those around; the findings of the clip say which. Parameters as in :func:`read_bvh`. Raises RecordingError
    where the file is damaged further, or holds no motion.
    """
    encoding: list[str] = []
    raw = parse_bvh(path, read_bytes(path, encoding), fps)
    roots = [j for j, joint in enumerate(raw.joints) if joint.parent < 0]
    raw.findings[:0] = [Finding("encoding", note) for note in encoding]
    name = recording_format(path)[0]
    if len(roots) == 1:
        return (_clip(raw, name, unit),)
    titles = [raw.joints[j].name for j in roots]
    words = f"{len(roots)} skeletons in one file ({', '.join(titles[:5])}): each is a clip of its own"
    raw.findings.insert(0, Finding("roots", words))
    names = [name, *(f"{name} {title}" for title in titles[1:])]
    return tuple(
        _clip(_under(raw, j), names[k] if names.count(names[k]) == 1 else f"{names[k]} {k + 1}", unit)
        for k, j in enumerate(roots)
    )


def _under(raw: RawBvh, root: int) -> RawBvh:
    """Only the joints of one root; the values stay whole, joints know their columns."""
    keep = _at_or_below(raw.joints, root)
    index = {j: k for k, j in enumerate(keep)}
    joints = [
        replace(raw.joints[j], parent=index.get(raw.joints[j].parent, -1), children=[index[c] for c in children])
        for j, children in ((j, raw.joints[j].children) for j in keep)
    ]
    return replace(raw, joints=joints, findings=list(raw.findings), notes=list(raw.notes))


def _clip(raw: RawBvh, name: str, unit: float | None) -> Clip:
    notes, findings = raw.notes, raw.findings
    names = _unique_names(raw.joints, findings)
    pelvis = find_pelvis(names, [[c for c in j.children if not raw.joints[c].end_site] for j in raw.joints])
    added = _are_displacements(raw, pelvis)
    if added:
        words = "the position channels are nearly all 0 where OFFSET is not: taken as displacements, added to OFFSET"
        findings.append(Finding("displacements", words))
    rotations = rotations_from_angles(raw.values, *_rotation_columns(raw.joints))
    root, rotations = _fold(raw, rotations, pelvis, names, notes, added)
    offsets, tracks = _offsets(raw, pelvis, added)
    keep = _at_or_below(raw.joints, pelvis)
    index = {j: k for k, j in enumerate(keep)}
    parents = tuple(-1 if j == pelvis else index[raw.joints[j].parent] for j in keep)
    offsets = offsets[keep]
    offsets[0] = 0
    if tracks:
        moving = ", ".join(names[j] for j in list(tracks)[:5]) + (" ..." if len(tracks) > 5 else "")
        notes.append(f"{len(tracks)} joints below the pelvis also change place ({moving}): kept as translation tracks")
    rotations = np.ascontiguousarray(rotations[:, keep], np.float32)
    if any(finding.kind == "filled" for finding in findings):
        lost = np.isnan(raw.values).any(axis=1)
        fill_rotations(rotations, lost)
        for track in (root, *tracks.values()):
            fill_track(track, lost)
    skeleton = Skeleton(
        names=tuple(names[j] for j in keep),
        parents=parents,
        offsets=offsets,
        end_sites=tuple(raw.joints[j].end_site for j in keep),
        channels=tuple(raw.joints[j].channels for j in keep),
    )
    if unit is None:
        guess = guess_unit(skeleton)
        unit = guess.metres
        notes.append(f"no unit in a BVH file: {guess.words}")
    skeleton = replace(skeleton, offsets=offsets * unit, unit=unit)
    return Clip(
        name=name,
        skeleton=skeleton,
        fps=_frame_rate(raw.frame_time),
        root_positions=(root * unit).astype(np.float32),
        rotations=rotations,
        translations={index[j]: (track * unit).astype(np.float32) for j, track in tracks.items()},
        notes=tuple(notes),
        findings=tuple(findings),
    )


def _unique_names(joints: Sequence[RawJoint], findings: list[Finding]) -> list[str]:
    """Joint names, made unique: joints first, so that only an end site gives way to a joint of its name."""
    taken: set[str] = set()
    names, repeated = [""] * len(joints), []
    for j in sorted(range(len(joints)), key=lambda j: joints[j].end_site):
        name, k = joints[j].name, 2
        while name in taken:
            name, k = f"{joints[j].name}_{k}", k + 1
        if k > 2 and not joints[j].end_site:
            repeated.append(f"{joints[j].name} is now {name}")
        taken.add(name)
        names[j] = name
    if repeated:
        findings.append(Finding("names", f"joint names that come more than once: {', '.join(repeated[:5])}"))
    return names


def _rotation_columns(joints: Sequence[RawJoint]) -> tuple[np.ndarray, np.ndarray]:
    columns, axes = np.full((len(joints), 3), -1), np.full((len(joints), 3), -1)
    for j, joint in enumerate(joints):
        turns = [(k, c) for k, c in enumerate(joint.channels) if c.endswith("rotation")]
        for n, (k, channel) in enumerate(turns):
            columns[j, n], axes[j, n] = joint.columns[k], "XYZ".index(channel[0])
    return columns, axes


def _are_displacements(raw: RawBvh, pelvis: int) -> bool:
    """Whether position channels are meant to be added to OFFSET: most joints that have them stay near 0, not near it.

    One joint says nothing: it may well be meant to lie on its parent.
    """
    columns, offsets = [], []
    for joint in raw.joints[pelvis + 1 :]:
        if len(joint.channels) > 3 and (places := _places(joint)) and any(joint.offset or ()):
            columns.append(places)
            offsets.append(joint.offset)
    if len(columns) < _FEWEST_DISPLACED:
        return False
    there = np.array(offsets, float)
    near = _NEAR * np.linalg.norm(there, axis=1)
    for step in (len(raw.values), max(1, len(raw.values) // _LOOKED_AT)):  # one frame rules most files out
        usual = np.median(np.nan_to_num(raw.values[::step][:, columns]), axis=0)
        displaced = (np.linalg.norm(usual, axis=1) < near) & (np.linalg.norm(usual - there, axis=1) > near)
        if np.count_nonzero(displaced) <= _MOST_DISPLACED * len(there):
            return False
    return True


def _places(joint: RawJoint) -> list[int]:
    """Columns of X, Y and Z position; empty where one of them is not there."""
    where = dict(zip(joint.channels, joint.columns, strict=True))
    places = [where.get(f"{axis}position", -1) for axis in "XYZ"]
    return places if min(places) >= 0 else []


def _positions(raw: RawBvh, j: int, added: bool) -> np.ndarray:
    """Where a joint is in its parent's frame, (n_frames, 3), file units: its OFFSET, replaced by position channels.

    added: the channels are added to it instead.
    """
    joint = raw.joints[j]
    if places := _places(joint):
        together = places[0] + 1 == places[1] == places[2] - 1
        values = raw.values[:, places[0] : places[2] + 1] if together else raw.values[:, places]
        return values + np.array(joint.offset) if added else values
    positions = np.tile(np.array(joint.offset), (len(raw.values), 1))
    for k, channel in enumerate(joint.channels):
        if channel.endswith("position"):
            axis = "XYZ".index(channel[0])
            positions[:, axis] = raw.values[:, joint.columns[k]] + (positions[:, axis] if added else 0)
    return positions


def _fold(
    raw: RawBvh, rotations: np.ndarray, pelvis: int, names: list[str], notes: list[str], added: bool
) -> tuple[np.ndarray, np.ndarray]:
    """Path of the pelvis in the world (n_frames, 3), file units, and ``rotations`` with its world rotation."""
    above, joint = [], pelvis
    while (joint := raw.joints[joint].parent) >= 0:
        above.append(joint)
    path = _positions(raw, pelvis, added)
    turn = rotations[:, pelvis]
    for joint in above:
        path = _positions(raw, joint, added) + quat.rotate(rotations[:, joint].astype(float), path)
        turn = quat.multiply(rotations[:, joint], turn)
    if above:
        rotations[:, pelvis] = turn
        upper = ", ".join(names[j] for j in reversed(above))
        notes.append(f"{upper} above {names[pelvis]}: folded into its path")
    return path, rotations


def _at_or_below(joints: Sequence[RawJoint], pelvis: int) -> list[int]:
    kept = {pelvis}
    for j, joint in enumerate(joints):
        if joint.parent in kept:
            kept.add(j)
    return sorted(kept)


def _offsets(raw: RawBvh, pelvis: int, added: bool) -> tuple[np.ndarray, dict[int, np.ndarray]]:
    """Rest offsets (n_joints, 3) and the tracks of joints below the pelvis that change place, in file units."""
    offsets = np.array([joint.offset for joint in raw.joints], float)
    parents = [joint.parent for joint in raw.joints]
    bones = offsets * (np.arange(len(offsets)) > pelvis)[:, None]
    still, tracks = _STILL * span(parents, bones), {}
    whole = not any(finding.kind == "filled" for finding in raw.findings)
    for j, joint in enumerate(raw.joints):
        if j <= pelvis or not any(c.endswith("position") for c in joint.channels):
            continue
        positions = _positions(raw, j, added)
        known = positions if whole else positions[~np.isnan(positions).any(axis=1)]
        if np.abs(known - offsets[j]).max() <= still:
            continue
        if np.ptp(known, axis=0).max() <= still:
            offsets[j] = known[0]
        else:
            tracks[j] = positions
    return offsets, tracks


def _frame_rate(frame_time: float) -> float:
    """Frames per second; a rate that was rounded in the file (.0083333) is made whole again."""
    fps = 1 / frame_time
    return float(round(fps)) if round(fps) and abs(fps - round(fps)) < 5e-4 * fps else fps


def write_bvh(path: str | Path, clip: Clip) -> None:
    """Write a clip as BVH (gzipped where the name ends in ``.gz``), in its skeleton's unit and channels.

    Where the clip moves in ways the source's channels cannot say, the missing channels are added; position channels
    that only repeat OFFSET are left out. The file appears whole or not at all. Raises OSError where it cannot be
    written.
    """
    skeleton = clip.skeleton
    order, columns = _depth_first(skeleton), []
    lines = ["HIERARCHY"]
    depth: dict[int, int] = {}
    for k, j in enumerate(order):
        depth[j] = 0 if not j else depth[skeleton.parents[j]] + 1
        channels = _channels(clip, j)
        lines += _joint_lines(skeleton, j, channels, "  " * depth[j])
        if channels:
            columns.append(_values(clip, j, channels))
        below = depth[skeleton.parents[order[k + 1]]] if k + 1 < len(order) else -1
        lines += ["  " * d + "}" for d in range(depth[j], below, -1)]
    values = np.concatenate(columns, axis=1)
    lines += ["MOTION", f"Frames: {clip.n_frames}", f"Frame Time: {1 / clip.fps:.9g}"]
    row = " ".join(["%.6f"] * values.shape[1]) + "\n"
    opener = gzip.open if str(path).lower().endswith(".gz") else open
    with replacing(path) as fresh, opener(fresh, "wt", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(lines) + "\n")
        for block in range(0, len(values), 1024):
            file.writelines(row % tuple(v) for v in values[block : block + 1024].tolist())


def _depth_first(skeleton: Skeleton) -> list[int]:
    children: list[list[int]] = [[] for _ in skeleton.names]
    for j in range(skeleton.n_joints - 1, 0, -1):
        children[skeleton.parents[j]].append(j)
    order, stack = [], [0]
    while stack:
        order.append(stack.pop())
        stack.extend(children[order[-1]])
    return order


def _channels(clip: Clip, j: int) -> tuple[str, ...]:
    """Channels to write for a joint: the source's, what the motion needs besides, no position that never changes."""
    if clip.skeleton.end_sites[j]:
        return ()
    channels = clip.skeleton.channels[j]
    if j == 0 or j in clip.translations:
        place = tuple(f"{a}position" for a in "XYZ" if f"{a}position" not in channels)
        channels = place + channels
    else:  # OFFSET says it already, and some readers take position channels at the root only
        channels = tuple(c for c in channels if c.endswith("rotation"))
    turns = [c for c in channels if c.endswith("rotation")]
    still = not turns and float(np.abs(clip.rotations[:, j, 1:]).max()) < 1e-6
    if len(turns) < 3 and not still:
        channels += tuple(f"{a}rotation" for a in "ZYX" if f"{a}rotation" not in turns)
    return channels


def _joint_lines(skeleton: Skeleton, j: int, channels: tuple[str, ...], indent: str) -> list[str]:
    name = "_".join(skeleton.names[j].replace("{", "_").replace("}", "_").split())
    head = "End Site" if skeleton.end_sites[j] else f"{'JOINT' if j else 'ROOT'} {name}"
    # The root's offset is zero in a skeleton: its place is in its position channels.
    offset = " ".join(f"{x:.10g}" for x in skeleton.offsets[j].astype(float) / skeleton.unit)
    lines = [indent + head, indent + "{", f"{indent}  OFFSET {offset}"]
    if not skeleton.end_sites[j]:
        lines.append(f"{indent}  CHANNELS {' '.join([str(len(channels)), *channels])}")
    return lines


def _values(clip: Clip, j: int, channels: tuple[str, ...]) -> np.ndarray:
    """(n_frames, n_channels): positions in the file's unit, angles in degrees without jumps of a full turn."""
    out = np.empty((clip.n_frames, len(channels)))
    place = clip.root_positions if j == 0 else clip.translations.get(j, clip.skeleton.offsets[j][None])
    turns = [c[0] for c in channels if c.endswith("rotation")]
    if turns:
        angles = np.unwrap(np.degrees(quat.to_euler("".join(turns), clip.rotations[:, j])), period=360, axis=0)
    for k, channel in enumerate(channels):
        if channel.endswith("position"):
            out[:, k] = place[:, "XYZ".index(channel[0])].astype(float) / clip.skeleton.unit
        else:
            out[:, k] = angles[:, turns.index(channel[0])]
    return out
