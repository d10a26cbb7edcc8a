"""The command that adds labels to a data set of a workspace."""

from __future__ import annotations

import sys
from argparse import Namespace

from core.workspace import WorkspaceError
from webapp.cli.sources import named_dataset
from webapp.features.library.commands import line_of


def labels(arguments: Namespace) -> int:
    """Adds label files to a data set; rows that do not fit are named on stderr. Raises WorkspaceError."""
    named = named_dataset(arguments.source)
    if named is None:
        raise WorkspaceError(f"{arguments.source}: labels belong to a dataset of a workspace, as WORKSPACE/NAME.")
    missing = [str(path) for path in arguments.paths if not path.expanduser().exists()]
    if missing:
        raise WorkspaceError(f"{missing[0]}: no such file or folder")
    workspace, name = named
    before = workspace.info(name).labels
    report = workspace.add_labels(name, [path.expanduser() for path in arguments.paths], replace=arguments.replace)
    came = [file for file in report.files if file.addition == report.last_addition]
    for file in came:
        if file.verdict != "ok":
            print(line_of(file), file=sys.stderr)
    if not arguments.quiet:
        print(f"{name}: {workspace.info(name).labels} labels, {before} before")
    return 0
