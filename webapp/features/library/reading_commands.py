"""The commands that say how recordings are to be read: ``reread`` changes it, ``body`` writes what is which joint."""

from __future__ import annotations

import json
from argparse import Namespace

from core.mocap.corrections import corrections_of, to_json
from core.mocap.files import atomic_file
from core.workspace import WorkspaceError
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import change_of, named_dataset, open_source


def reread(arguments: Namespace) -> int:
    """Changes unit, way up, rate or bodies of a dataset that is there.

    Raises WorkspaceError, ParameterError or FormatError in plain words.
    """
    named = named_dataset(arguments.source)
    if named is None:
        raise WorkspaceError(f"{arguments.source}: expected WORKSPACE/NAME, a dataset of a workspace.")
    if all(value is None for value in (arguments.unit, arguments.up, arguments.fps, arguments.body)):
        raise WorkspaceError("Say what to change: --unit, --up, --fps or --body.")
    workspace, name = named
    with progress_bar(arguments.quiet) as report:
        workspace.change_reading(name, change_of(arguments), arguments.clips, report)
    if not arguments.quiet:
        info = workspace.info(name)
        print(f"{info.name}: {info.clips} clips, {info.seconds:.1f} s; {info.warnings} files with warnings")
    return 0


def body(arguments: Namespace) -> int:
    """Writes, for every rig of SOURCE, which joint is which part of the body; --body takes it back once corrected.

    Raises WorkspaceError, RecordingError or OSError in plain words.
    """
    with progress_bar(arguments.quiet) as report:
        dataset = open_source(arguments, report)
    corrections = corrections_of(clip.skeleton for clip in dataset.clips)
    with atomic_file(arguments.out) as file:
        file.write((json.dumps(to_json(corrections), ensure_ascii=False, indent=1) + "\n").encode())
    if not arguments.quiet:
        print(f"{len(corrections.rigs)} rigs; written to {arguments.out}")
    return 0
