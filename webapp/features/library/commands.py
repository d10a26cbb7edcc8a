"""The commands that import recordings or check them: ``import``, ``inspect``, ``demo``."""

from __future__ import annotations

import json
import sys
from argparse import Namespace
from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from core.progress import Report
from core.workspace import Workspace, WorkspaceError, clean_name
from webapp.cli.progress_bar import progress_bar
from webapp.shell.advice import on_the_command_line

if TYPE_CHECKING:
    from core.mocap.other_files import LeftOut

SHOWN = 20  # most unreadable files that an import lists


def import_(arguments: Namespace) -> int:
    """Reads recordings into a workspace; bad files are named on stderr. Raises WorkspaceError where all are bad."""
    missing = [str(path) for path in arguments.paths if not path.expanduser().exists()]
    if missing:
        raise WorkspaceError(f"{missing[0]}: no such file or folder")
    workspace = Workspace(arguments.workspace)
    first = _first_with_recordings(arguments.paths)
    name = arguments.name if arguments.name is not None else clean_name(_stem(first), "recordings")
    with progress_bar(arguments.quiet) as report:
        imported = (workspace.add_files if arguments.add else workspace.import_dataset)(
            name,
            [path.expanduser() for path in arguments.paths],
            skeleton=arguments.skeleton,
            unit=arguments.unit,
            up=arguments.up,
            fps=arguments.fps,
            body=arguments.body,
            points=arguments.points,
            smooth=arguments.smooth,
            clips=arguments.clips,
            labels=arguments.labels,
            report=report,
        )
    added = [file for file in imported.files if file.addition == imported.last_addition]
    bad = [file for file in added if file.verdict == "error"]
    for file in bad[:SHOWN]:
        print(line_of(file), file=sys.stderr)
    for file in added:
        if file.verdict == "warning" and file.clip is None and not arguments.quiet:
            print(line_of(file), file=sys.stderr)
    if len(bad) > SHOWN:
        print(f"... and {len(bad) - SHOWN} more files that cannot be read", file=sys.stderr)
    if not arguments.quiet:
        info = workspace.info(name.strip())
        print(
            f"{info.name}: {info.clips} clips, {info.frames} frames, {info.seconds:.1f} s, {info.labels} labels; "
            f"{info.warnings} files with warnings, {info.errors} files with errors"
        )
    return 0


def _first_with_recordings(paths: Iterable[Path]) -> Path:
    """The path that a dataset is named after: the first that is a recording or a folder, else the first."""
    from core.mocap.readers import is_recording

    paths = [path.expanduser().resolve() for path in paths]
    return next((path for path in paths if path.is_dir() or is_recording(path)), paths[0])


def inspect(arguments: Namespace) -> int:
    """A line for each file: verdict and reason, or with ``--json`` one object; exit code 2 if any is unreadable."""
    with progress_bar(arguments.quiet or not arguments.json) as report:
        verdicts = []
        for file, facts in _verdicts(arguments, report):
            verdicts.append((file, facts))
            if not arguments.json and not (arguments.quiet and file.verdict == "ok"):
                print(line_of(file), flush=True)
    from core.mocap.other_files import in_words

    left = _left_out(arguments.paths)
    if not verdicts:
        also = f" ({in_words(left)})" if left else ""
        raise WorkspaceError(f"no recordings in {', '.join(map(str, arguments.paths))}{also}")
    if arguments.json:
        entries = [_entry(file, facts) for file, facts in verdicts]
        others = [{"format": group.format, "files": group.files, "advice": group.advice} for group in left]
        document = {"format": "motionscape/inspection/1", "files": entries, "left_out": others}
        document["messages"] = [in_words(left)] if left else []
        print(json.dumps(document, ensure_ascii=False, indent=1))
    elif left and not arguments.quiet:
        print(in_words(left))
    return 2 if any(file.verdict == "error" for file, _ in verdicts) else 0


def _left_out(paths: Iterable[Path]) -> tuple[LeftOut, ...]:
    """What of the folders among ``paths`` is not read."""
    from core.mocap.recordings import find_left_out

    folders = [path for path in paths if path.is_dir()]
    return find_left_out(folders) if folders else ()


def _entry(file: Any, facts: Any) -> dict[str, Any]:
    """A file as ``inspect --json`` gives it; what was not read has no facts."""
    findings = [asdict(finding) for finding in file.findings]
    entry = {"path": str(file.path), "clip": file.clip, "verdict": file.verdict, "messages": list(file.messages)}
    return entry | (facts._asdict() if facts else {}) | {"findings": findings}


def demo(arguments: Namespace) -> int:
    """Writes the demo data set as BVH and labels."""
    from core.demo import write_demo

    if arguments.folder.exists() and not arguments.folder.is_dir():
        raise WorkspaceError(f"{arguments.folder} is a file; the demo needs a folder.")
    with progress_bar(arguments.quiet) as report:
        write_demo(arguments.folder, arguments.minutes, arguments.seed, report)
    if not arguments.quiet:
        print(f"{arguments.minutes:g} minutes of labelled motion are in {arguments.folder}")
    return 0


def _verdicts(arguments: Namespace, report: Report) -> Iterator[tuple[Any, Any]]:
    """A FileReport for every file that was named or found, and for the labels; and the Facts of what was read."""
    from core.inspection import inspect_recording
    from core.mocap.dataset import reading

    how = reading(arguments.unit, arguments.up, arguments.fps, arguments.body, arguments.points, arguments.smooth)
    paths = [path for path in _files(arguments.paths) if not arguments.clips or _stem(path) in arguments.clips]
    for k, path in enumerate(paths):
        report("inspecting", k / len(paths))
        yield inspect_recording(path, skeleton=arguments.skeleton, how=how)
    if arguments.labels is not None:
        yield _inspect_labels(arguments.labels), None


def _inspect_labels(path: Path) -> Any:
    from core.mocap.dataset import FileReport
    from core.mocap.errors import RecordingError
    from core.mocap.labels import read_labels

    try:
        return FileReport(str(path), "", "ok", (f"{len(read_labels(path))} labels",))
    except (RecordingError, OSError) as error:
        return FileReport(str(path), "", "error", (str(error),))


def _files(paths: Iterable[Path]) -> Iterator[Path]:
    from core.mocap.dataset import find_recordings
    from core.mocap.errors import RecordingError

    for path in paths:
        if not path.is_dir():
            yield path
            continue
        skeletons_and_recordings = {p for p in path.rglob("*") if p.suffix.lower() == ".asf" and p.is_file()}
        with suppress(RecordingError):  # no recordings in it; perhaps skeletons
            skeletons_and_recordings.update(find_recordings(path))
        yield from sorted(skeletons_and_recordings)


def line_of(file: Any) -> str:
    """``verdict path[:line]: why``, on one line whatever the names of files hold."""
    text, name = f"{file.verdict:<8}{file.path}", f"{Path(file.path).name}:"
    if file.messages:
        first, *others = (" ".join(on_the_command_line(message).split()) for message in file.messages)
        text += first[len(name) - 1 :] if first.startswith(name) else f": {first}"
        text = "; ".join([text, *others])
    return "".join(c if c.isprintable() else "?" for c in text)


def _stem(path: Path) -> str:
    from core.mocap.text import recording_format

    return recording_format(path)[0]
