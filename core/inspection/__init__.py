"""Finds what is odd about a recording, and says it in plain words.

Doubts make the verdict "warning"; a clean clip has none. Nothing is changed here: the readers do what must be done
(fold joints, guess a unit) and say so in a clip's notes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from core.inspection.body import body_doubts, floor_notes, side_doubts, size_doubts, up_doubts
from core.inspection.duplicates import find_duplicates
from core.inspection.timing import Jump, find_jumps, rate_doubts, rest_pose_frames
from core.mocap.anatomy import find_anatomy
from core.mocap.asfamc import AsfSkeleton, read_asf
from core.mocap.clip import Clip
from core.mocap.dataset import (
    READ_AS_THEY_ARE,
    Dataset,
    FileReport,
    ImportReport,
    motion_digest,
    read_recordings,
)
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.reading import Reading
from core.mocap.reports import Finding
from core.mocap.text import recording_format
from core.mocap.units import name_of
from core.progress import Report, silent

__all__ = [
    "Inspection",
    "find_doubts",
    "inspect_clip",
    "inspect_dataset",
    "inspect_file",
    "inspect_skeleton",
    "rest_pose",
]

_NAMED = 3  # faults of one kind that are named one by one in a sentence
_MARKED = 200  # and those that are findings of their own
_ALIKE = ("the same recording as", "looks like the same motion as")  # how doubts about duplicates begin


class Inspection(NamedTuple):
    """What inspection finds in a clip.

    findings: what a person should look at, and in which frames, that of the reader first. doubts: the same in
    sentences, all jumps in one. remarks: what is good to know. lead: frames of a rest pose in front.
    """

    findings: tuple[Finding, ...]
    doubts: tuple[str, ...]
    remarks: tuple[str, ...]
    lead: int


def inspect_clip(clip: Clip) -> tuple[str, ...]:
    """What a person should look at in this clip, one sentence each; nothing where all is well."""
    return find_doubts(clip).doubts


def rest_pose(clip: Clip) -> int:
    """Frames of a T-pose or an unturned skeleton in front of the motion; 0 where it starts at once."""
    positions = joint_positions(clip)
    return rest_pose_frames(clip, positions, find_jumps(clip, positions))[0]


def find_doubts(clip: Clip) -> Inspection:
    """Inspects a clip."""
    positions = joint_positions(clip)
    jumps = find_jumps(clip, positions)
    lead, why = rest_pose_frames(clip, positions, jumps)
    before = [*clip.findings, *body_doubts(clip.skeleton), *size_doubts(clip.skeleton)]
    if lead:
        frames = "frame 0" if lead == 1 else f"frames 0 to {lead - 1}"
        before.append(Finding("rest pose", f"{frames} before the motion: {why}, then a jump", 0, lead))
    jumps = [jump for jump in jumps if jump.frame > lead]
    sliding, remarks = floor_notes(clip, positions[lead:])
    turned = [*up_doubts(clip, positions[lead:]), *side_doubts(clip, positions[lead:])]
    after = [*rate_doubts(clip, positions), *turned, *sliding]
    findings = dict.fromkeys([*before, *_jump_findings(clip, jumps), *after])
    doubts = dict.fromkeys([*(f.message for f in before), *_jump_words(clip, jumps), *(f.message for f in after)])
    return Inspection(tuple(findings), tuple(doubts), (*clip.notes, *remarks), lead)


def _jump_words(clip: Clip, jumps: list[Jump]) -> list[str]:
    if not jumps:
        return []
    worst = sorted(sorted(jumps, key=lambda j: -j.metres)[:_NAMED])
    named = ", ".join(f"{clip.skeleton.names[j.joint]} by {j.metres:.2g} m at frame {j.frame}" for j in worst)
    times = "once" if len(jumps) == 1 else f"{len(jumps)} times"
    return [f"jumps {times} from one frame to the next, faster than a body can move: {named}"]


def _jump_findings(clip: Clip, jumps: list[Jump]) -> list[Finding]:
    """Every jump at its frames; of very many, the later ones together."""
    findings = [
        Finding(
            "jump",
            f"{clip.skeleton.names[jump.joint]} jumps by {jump.metres:.2g} m",
            jump.frame - 1,
            jump.frame + 1,
        )
        for jump in jumps[:_MARKED]
    ]
    if others := jumps[_MARKED:]:
        words = f"{len(others)} further jumps"
        findings.append(Finding("jump", words, others[0].frame - 1, others[-1].frame + 1))
    return findings


def inspect_skeleton(asf: AsfSkeleton) -> tuple[str, ...]:
    """What a person should look at in a skeleton, one sentence each."""
    return tuple(finding.message for finding in (*asf.findings, *size_doubts(asf.skeleton)))


def inspect_file(
    path: str | Path, *, skeleton: str | Path | None = None, how: Reading = READ_AS_THEY_ARE
) -> FileReport:
    """Read and inspect one file; an ``.asf`` is checked as a skeleton. What cannot be read is an "error" that says why.

    skeleton: for .amc files, as in open_dataset. how: what was said beside the file.
    """
    return inspect_recording(path, skeleton=skeleton, how=how)[0]


def inspect_recording(
    path: str | Path, *, skeleton: str | Path | None = None, how: Reading = READ_AS_THEY_ARE
) -> tuple[FileReport, Facts | None]:
    """As :func:`inspect_file`, with the facts of what was read; of several clips in the file, of the first."""
    path = Path(path)
    try:
        if recording_format(path)[1] == ".asf":
            asf = read_asf(path)
            notes = (f"a skeleton of {asf.skeleton.n_joints} joints and tips", *asf.notes)
            doubts = inspect_skeleton(asf)
            return FileReport(str(path), None, "warning" if doubts else "ok", (*doubts, *notes)), None
        file, clip = next(iter(read_recordings(path, skeleton=skeleton, how=how)))
    except RecordingError as error:
        file, clip = error, None
    if clip is None or isinstance(file, RecordingError):
        return FileReport(str(path), None, "error", (str(file),)), None
    report = FileReport(str(path), clip.name, file.verdict, file.messages)
    return _file_report(report, find_doubts(clip)), facts_of(clip)


class Facts(NamedTuple):
    """A recording in numbers, as ``inspect --json`` gives them.

    unit: its name in core.mocap.units.UNITS, else the number of metres. up: the axis that points up in the file.
    height: of the body, metres; of what is no body, of the whole figure in its highest frame. body: "human", "partial"
    or "other". joints: canonical name -> joint name.
    """

    frames: int
    fps: float
    unit: str
    up: str
    height: float
    body: str
    joints: dict[str, str]


def facts_of(clip: Clip) -> Facts:
    """The facts of a clip."""
    anatomy = find_anatomy(clip.skeleton)
    joints = {name: clip.skeleton.names[joint] for name, joint in anatomy.joints.items()}
    height = anatomy.body_height
    if anatomy.body == "other":
        height = float(np.ptp(joint_positions(clip)[..., 1], axis=1).max())
    unit = name_of(clip.skeleton.unit)
    return Facts(clip.n_frames, clip.fps, unit, clip.up, round(height, 4), anatomy.body, joints)


def inspect_dataset(dataset: Dataset, report: Report = silent) -> ImportReport:
    """The dataset's import report with what inspection finds in every clip, duplicates among them included.

    Clips that came from no file (a demo) get an entry of their own.
    """
    inspected: dict[str, Inspection] = {}
    for k, clip in enumerate(dataset.clips):
        report("Inspecting", k / len(dataset.clips))
        inspected[clip.name] = find_doubts(clip)
    digests = [motion_digest(clip) for clip in dataset.clips]
    leads = [inspection.lead for inspection in inspected.values()]
    for k, others in find_duplicates(dataset.clips, digests, leads).items():
        named = ", ".join(dataset.clips[other].name for other in others[:5]) + (" ..." if len(others) > 5 else "")
        same = all(digests[other] == digests[k] for other in others)
        words = f"{_ALIKE[0] if same else _ALIKE[1]} {named}"
        before = inspected[dataset.clips[k].name]
        inspected[dataset.clips[k].name] = before._replace(
            findings=(*before.findings, Finding("duplicate", words)), doubts=(*before.doubts, words)
        )
    nothing = Inspection((), (), (), 0)
    files = [
        _file_report(_without_alike(file, found.remarks), found)
        for file in dataset.report.files
        for found in [inspected.get(file.clip or "", nothing)]
    ]
    known = {file.clip for file in files}
    files += [
        _file_report(FileReport(clip.name, clip.name, "ok"), inspected[clip.name])
        for clip in dataset.clips
        if clip.name not in known
    ]
    report("Inspecting", 1.0)
    return replace(dataset.report, files=tuple(files))


def _without_alike(file: FileReport, remarks: Iterable[str]) -> FileReport:
    """The report without the duplicates of an earlier inspection: those clips may have gone since."""
    kept = tuple(message for message in file.messages if not message.startswith(_ALIKE))
    doubtless = kept != file.messages and file.verdict == "warning" and set(kept) <= set(remarks)
    return replace(file, messages=kept, verdict="ok" if doubtless else file.verdict)


def _file_report(file: FileReport, found: Inspection) -> FileReport:
    """The report with more to say: doubts first, nothing twice."""
    verdict = "error" if file.verdict == "error" else "warning" if found.doubts else file.verdict
    messages = tuple(dict.fromkeys([*found.doubts, *file.messages, *found.remarks]))
    return replace(file, verdict=verdict, messages=messages, findings=found.findings)
