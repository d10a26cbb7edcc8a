"""The commands that bring recordings in, or say what is odd about them: ``import``, ``inspect``, ``demo``."""

from __future__ import annotations

import json
import sys
from argparse import Namespace
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from core.progress import Report
from core.workspace import Workspace, WorkspaceError, clean_name
from webapp.cli.progress_bar import progress_bar
from webapp.shell.advice import on_the_command_line

SHOWN = 20  # bad files that an import names


def import_(asked: Namespace) -> int:
    """Reads recordings into a workspace; bad files are named on stderr. Raises WorkspaceError where all are bad."""
    missing = [str(path) for path in asked.paths if not path.expanduser().exists()]
    if missing:
        raise WorkspaceError(f"{missing[0]}: no such file or folder")
    workspace = Workspace(asked.workspace)
    first = asked.paths[0].expanduser().resolve()
    name = asked.name if asked.name is not None else clean_name(_stem(first), "recordings")
    with progress_bar(asked.quiet) as report:
        imported = (workspace.add_files if asked.add else workspace.import_dataset)(
            name,
            [path.expanduser() for path in asked.paths],
            skeleton=asked.skeleton,
            fps=asked.fps,
            clips=asked.clips,
            labels=asked.labels,
            report=report,
        )
    came = [file for file in imported.files if file.addition == imported.last_addition]
    bad = [file for file in came if file.verdict == "error"]
    for file in bad[:SHOWN]:
        print(line_of(file), file=sys.stderr)
    if len(bad) > SHOWN:
        print(f"... and {len(bad) - SHOWN} more files that cannot be read", file=sys.stderr)
    if not asked.quiet:
        info = workspace.info(name.strip())
        print(
            f"{info.name}: {info.clips} clips, {info.frames} frames, {info.seconds:.1f} s, {info.labels} labels; "
            f"{info.warnings} files with warnings, {info.errors} files with errors"
        )
    return 0


def inspect(asked: Namespace) -> int:
    """One line a file: its verdict and why; 2 if any is unreadable. With ``--json`` one object with the same."""
    with progress_bar(asked.quiet or not asked.json) as report:
        verdicts = []
        for file in _verdicts(asked, report):
            verdicts.append(file)
            if not asked.json and not (asked.quiet and file.verdict == "ok"):
                print(line_of(file), flush=True)
    if not verdicts:
        raise WorkspaceError(f"no recordings (.bvh, .amc, .asf) in {', '.join(map(str, asked.paths))}")
    if asked.json:
        entries = [
            {"path": str(f.path), "clip": f.clip, "verdict": f.verdict, "messages": list(f.messages)} for f in verdicts
        ]
        print(json.dumps({"format": "motionscape/inspection/1", "files": entries}, ensure_ascii=False, indent=1))
    return 2 if any(file.verdict == "error" for file in verdicts) else 0


def demo(asked: Namespace) -> int:
    """Writes the demo data set as BVH and labels."""
    from core.demo import write_demo

    if asked.folder.exists() and not asked.folder.is_dir():
        raise WorkspaceError(f"{asked.folder} is a file; the demo needs a folder.")
    with progress_bar(asked.quiet) as report:
        write_demo(asked.folder, asked.minutes, asked.seed, report)
    if not asked.quiet:
        print(f"{asked.minutes:g} minutes of labelled motion are in {asked.folder}")
    return 0


def _verdicts(asked: Namespace, report: Report) -> Iterator[Any]:
    """A FileReport for every file that was named or found, and for the labels."""
    from core.inspection import inspect_file

    paths = [path for path in _files(asked.paths) if not asked.clips or _stem(path) in asked.clips]
    for k, path in enumerate(paths):
        report("inspecting", k / len(paths))
        yield inspect_file(path, skeleton=asked.skeleton, fps=asked.fps)
    if asked.labels is not None:
        yield _inspect_labels(asked.labels)


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
        found = {p for p in path.rglob("*") if p.suffix.lower() == ".asf" and p.is_file()}
        with suppress(RecordingError):  # no recordings in it; perhaps skeletons
            found.update(find_recordings(path))
        yield from sorted(found)


def line_of(file: Any) -> str:
    """``verdict path[:line]: why``, on one line whatever the names of files hold."""
    text, name = f"{file.verdict:<8}{file.path}", f"{Path(file.path).name}:"
    if file.messages:
        first, *others = (" ".join(on_the_command_line(message).split()) for message in file.messages)
        text += first[len(name) - 1 :] if first.startswith(name) else f": {first}"
        text = "; ".join([text, *others])
    return "".join(c if c.isprintable() else "?" for c in text)


def _stem(path: Path) -> str:
    name = path.name
    for suffix in (".gz", ".bvh", ".amc", ".asf"):
        if name.lower().endswith(suffix):
            name = name[: -len(suffix)]
    return name
