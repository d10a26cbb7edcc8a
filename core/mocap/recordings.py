"""Which files of a folder are recordings, what their clips are called, and which skeleton an AMC belongs to."""

from __future__ import annotations

import difflib
import os
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from core.mocap.errors import RecordingError
from core.mocap.files import files_below
from core.mocap.other_files import LeftOut, in_words, left_out_files, what_it_is
from core.mocap.readers import FORMATS, NAMED, is_recording, without_later_frames
from core.mocap.text import recording_format

NEEDS_SKELETON = "one of them, or one skeleton given for all"  # whoever shows the message says how to give one
Source = str | os.PathLike[str] | Sequence[str | os.PathLike[str]]


@dataclass(frozen=True)
class Recording:
    """A file and the name of its clip; ``message`` says why the name is longer than the file's stem, if it is."""

    path: Path
    clip: str
    message: str = ""


def find_recordings(source: Source) -> list[Path]:
    """Recordings (core.mocap.readers) of a folder and all below it, or of several; a file stands for itself.

    Sorted by path; hidden files and folders, and files of other kinds, are left out (:func:`find_left_out`). Raises
    RecordingError where a path does not exist, or there is no recording at all.
    """
    return [path for path, _ in _find(source)]


def name_recordings(source: Source, clips: Iterable[str] | str | None = None) -> list[Recording]:
    """Recordings of ``source`` with their clip names, only those of ``clips`` where given.

    A clip is called like its file, without format; where two are, both get their folder below ``source`` in front.
    Raises RecordingError as :func:`find_recordings`, and where a clip of ``clips`` does not exist.
    """
    paths = _find(source)
    stems = [recording_format(path)[0] for path, _ in paths]
    names = list(stems)
    # Folder first; then, for 01_01.bvh beside 01_01.amc, the format as well; at last its place among the files.
    longer: tuple[Callable[[int], str], ...] = (
        lambda k: "/".join((*paths[k][1].parts, stems[k])),
        lambda k: "/".join((*paths[k][1].parts, paths[k][0].name)),
        lambda k: f"{names[k]} ({k})",
    )
    for longer_name in longer:
        count = Counter(names)
        names = [longer_name(k) if count[name] > 1 else name for k, name in enumerate(names)]
    recordings = [
        Recording(path, name, "" if name == stem else f"another file is called {stem} too; this clip is called {name}")
        for (path, _), name, stem in zip(paths, names, stems, strict=True)
    ]
    return recordings if clips is None else _chosen(source, recordings, clips)


def _chosen(source: Source, recordings: list[Recording], clips: Iterable[str] | str) -> list[Recording]:
    clips = clips.split(",") if isinstance(clips, str) else clips
    wanted = {name.strip(): True for name in clips}
    known = {r.clip for r in recordings}
    for name in wanted:
        if name not in known:
            near = difflib.get_close_matches(name, known, 3, 0.5) or sorted(known)[:3]
            near += [clip for clip in sorted(known) if clip.endswith("/" + name)][:3]
            where = source if isinstance(source, str | os.PathLike) else source[0]
            raise RecordingError(where, f"no clip is called {name!r}", f"a clip such as {', '.join(near)}")
    return [r for r in recordings if r.clip in wanted]


def find_left_out(source: Source) -> tuple[LeftOut, ...]:
    """What of ``source`` is not read, by format; hidden files are not looked at."""
    sources = [source] if isinstance(source, str | os.PathLike) else list(source)
    files = [file for one in map(Path, sources) for file in (files_below(one) if one.is_dir() else [one])]
    return left_out_files(dict.fromkeys(file for file in files if not is_recording(file)), ())


def _find(source: Source) -> list[tuple[Path, Path]]:
    """Every recording and its folder relative to the source it was found in."""
    sources = [source] if isinstance(source, str | os.PathLike) else list(source)
    found: dict[Path, Path] = {}
    for one in map(Path, sources):
        if not one.exists():
            raise RecordingError(one, "there is no such file or folder")
        if one.is_dir():
            for path in without_later_frames(sorted(filter(is_recording, files_below(one)))):
                found.setdefault(path, path.parent.relative_to(one))
        elif is_recording(one):
            found.setdefault(one, Path())
    if not found:
        one = Path(sources[0])
        others = in_words(find_left_out(source))
        if one.is_dir() or len(sources) > 1:
            words = "no recordings in this folder" if len(sources) == 1 else "no recordings among these"
            found_words = f"{words} ({others})" if others else words
            raise RecordingError(one, found_words, f"files of {NAMED}")
        if recording_format(one)[1] in FORMATS:  # it may be none, but its reader says why
            return [(one, Path())]
        what = f"not a recording: {what_it_is(one)}" if what_it_is(one) else "not a recording"
        raise RecordingError(one, what, f"a file of {NAMED}, or a folder")
    return list(found.items())


def find_skeleton(path: Path, skeleton: str | Path | None = None) -> Path:
    """The .asf for an .amc: SUBJECT.asf beside it, the only .asf of its folder, or ``skeleton``.

    SUBJECT is what stands before an underscore in the file's name. Raises RecordingError where there is none.
    """
    beside = {p.name.lower().removesuffix(".gz").removesuffix(".asf"): p for p in _skeletons_in(path.parent)}
    parts = recording_format(path)[0].lower().split("_")
    for n in range(len(parts), 0, -1):
        if "_".join(parts[:n]) in beside:
            return beside["_".join(parts[:n])]
    if len(beside) == 1:
        return next(iter(beside.values()))
    if skeleton is not None:
        return Path(skeleton)
    found = f"no skeleton: neither {parts[0]}.asf nor a single .asf file stands beside it"
    raise RecordingError(path, found, NEEDS_SKELETON)


def _skeletons_in(folder: Path) -> list[Path]:
    return sorted(p for p in folder.iterdir() if p.name.lower().endswith((".asf", ".asf.gz")) and p.is_file())
