"""What is odd about a recording, in words for people.

Doubts make the verdict "warning"; a clean clip has none. Nothing is changed here: the readers do what must be done
(fold joints, guess a unit) and say so in a clip's notes.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from core.inspection.body import floor_notes, size_doubts, up_doubts
from core.inspection.duplicates import find_duplicates
from core.inspection.timing import Jump, find_jumps, rate_doubts, rest_pose_frames
from core.mocap.asfamc import AsfSkeleton, read_asf
from core.mocap.clip import Clip
from core.mocap.dataset import Dataset, FileReport, ImportReport, motion_digest, read_recordings
from core.mocap.errors import RecordingError
from core.mocap.kinematics import joint_positions
from core.mocap.text import recording_format
from core.progress import Report, silent

__all__ = ["inspect_clip", "inspect_dataset", "inspect_file", "inspect_skeleton", "rest_pose"]

_NAMED = 3  # faults of one kind that are named one by one
_ALIKE = ("the same recording as", "looks like the same motion as")  # how doubts about duplicates begin


def inspect_clip(clip: Clip) -> tuple[str, ...]:
    """What a person should look at in this clip, one sentence each; nothing where all is well."""
    return _inspect(clip)[0]


def rest_pose(clip: Clip) -> int:
    """Frames of a T-pose or an unturned skeleton in front of the motion; 0 where it starts at once."""
    positions = joint_positions(clip)
    return rest_pose_frames(clip, positions, find_jumps(clip, positions))[0]


def _inspect(clip: Clip) -> tuple[tuple[str, ...], tuple[str, ...], int]:
    """Doubts, remarks, and the frames of a rest pose in front."""
    positions = joint_positions(clip)
    jumps = find_jumps(clip, positions)
    lead, why = rest_pose_frames(clip, positions, jumps)
    doubts = [*clip.warnings, *size_doubts(clip.skeleton)]
    if lead:
        frames = "frame 0" if lead == 1 else f"frames 0 to {lead - 1}"
        doubts.append(f"{frames} before the motion: {why}, then a jump")
    doubts += _jump_words(clip, [jump for jump in jumps if jump.frame > lead])
    doubts += rate_doubts(clip, positions)
    doubts += up_doubts(clip, positions[lead:])
    sliding, remarks = floor_notes(clip, positions[lead:])
    return tuple(dict.fromkeys([*doubts, *sliding])), (*clip.notes, *remarks), lead


def _jump_words(clip: Clip, jumps: list[Jump]) -> list[str]:
    if not jumps:
        return []
    worst = sorted(sorted(jumps, key=lambda j: -j.metres)[:_NAMED])
    named = ", ".join(f"{clip.skeleton.names[j.joint]} by {j.metres:.2g} m at frame {j.frame}" for j in worst)
    times = "once" if len(jumps) == 1 else f"{len(jumps)} times"
    return [f"jumps {times} from one frame to the next, faster than a body can move: {named}"]


def inspect_skeleton(asf: AsfSkeleton) -> tuple[str, ...]:
    """What a person should look at in a skeleton, one sentence each."""
    return tuple(size_doubts(asf.skeleton))


def inspect_file(path: str | Path, *, skeleton: str | Path | None = None, fps: float | None = None) -> FileReport:
    """Read and inspect one file; an ``.asf`` is checked as a skeleton. What cannot be read is an "error" that says why.

    skeleton, fps: for .amc files, as in open_dataset. Raises ValueError where fps is not positive.
    """
    path = Path(path)
    try:
        if recording_format(path)[1] == ".asf":
            asf = read_asf(path)
            notes = (f"a skeleton of {asf.skeleton.n_joints} joints and tips", *asf.notes)
            return _file_report(FileReport(str(path), None, "ok", notes), inspect_skeleton(asf))
        file, clip = next(iter(read_recordings(path, skeleton=skeleton, fps=fps)))
    except RecordingError as error:
        file, clip = error, None
    if clip is None or isinstance(file, RecordingError):
        return FileReport(str(path), None, "error", (str(file),))
    doubts, remarks, _ = _inspect(clip)
    return _file_report(FileReport(str(path), clip.name, file.verdict, file.messages), doubts, remarks)


def inspect_dataset(dataset: Dataset, report: Report = silent) -> ImportReport:
    """The dataset's import report with what inspection finds in every clip, duplicates among them included.

    Clips that came from no file (a demo) get an entry of their own.
    """
    doubts, remarks, leads = {}, {}, []
    for k, clip in enumerate(dataset.clips):
        report("Inspecting", k / len(dataset.clips))
        doubts[clip.name], remarks[clip.name], lead = _inspect(clip)
        leads.append(lead)
    digests = [motion_digest(clip) for clip in dataset.clips]
    for k, others in find_duplicates(dataset.clips, digests, leads).items():
        named = ", ".join(dataset.clips[other].name for other in others[:5]) + (" ..." if len(others) > 5 else "")
        same = all(digests[other] == digests[k] for other in others)
        word = _ALIKE[0] if same else _ALIKE[1]
        doubts[dataset.clips[k].name] += (f"{word} {named}",)
    before = (_without_alike(file, remarks.get(file.clip or "", ())) for file in dataset.report.files)
    files = [_file_report(f, doubts.get(f.clip or "", ()), remarks.get(f.clip or "", ())) for f in before]
    known = {file.clip for file in files}
    files += [
        _file_report(FileReport(clip.name, clip.name, "ok"), doubts[clip.name], remarks[clip.name])
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


def _file_report(file: FileReport, doubts: Iterable[str], remarks: Iterable[str] = ()) -> FileReport:
    """The report with more to say: doubts first, nothing twice."""
    doubts = tuple(doubts)
    verdict = "error" if file.verdict == "error" else "warning" if doubts else file.verdict
    return replace(file, verdict=verdict, messages=tuple(dict.fromkeys([*doubts, *file.messages, *remarks])))
