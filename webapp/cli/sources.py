"""What SOURCE means on the command line."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from core.mocap.dataset import Dataset, left_out_words, open_dataset, reading, reread
from core.mocap.reading import Change
from core.mocap.rigs import left_out
from core.progress import Report
from core.workspace import Workspace, WorkspaceError, is_workspace


def named_dataset(source: str) -> tuple[Workspace, str] | None:
    """Workspace and name where ``source`` is WORKSPACE/NAME, else None. Raises WorkspaceError for a bare workspace."""
    path = Path(source).expanduser()
    if is_workspace(path):
        names = [info.name for info in Workspace(path).datasets()]
        known = f" It has {', '.join(names[:8])}." if names else " It is empty."
        raise WorkspaceError(f"{source} is a workspace: say which dataset of it, as {source.rstrip('/')}/NAME.{known}")
    return (Workspace(path.parent), path.name) if is_workspace(path.parent) else None


def stored_dataset(arguments: Namespace) -> tuple[Workspace, str] | None:
    """Workspace and name where SOURCE is a dataset that is used whole and as it is stored; else None.

    Raises WorkspaceError as :func:`named_dataset`, and for options that only make sense while files are read.
    """
    named = named_dataset(arguments.source)
    if named is None:
        return None
    refuse_reading_options(arguments)
    return None if arguments.clips or _said(arguments) else named


def open_source(arguments: Namespace, report: Report) -> Dataset:
    """The data set that ``arguments.source`` and the common options name; one of a workspace as the options say.

    Raises WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    named = named_dataset(arguments.source)
    if named is None:
        path = Path(arguments.source).expanduser()
        if not path.exists():
            raise WorkspaceError(f"{arguments.source}: no such file or folder, and no dataset of a workspace.")
        dataset = open_dataset(
            path,
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
        if not arguments.quiet and (words := left_out_words(path)):
            print(f"note: {words}", file=sys.stderr)
        return dataset
    refuse_reading_options(arguments)
    workspace, name = named
    dataset = workspace.open(name)
    try:
        dataset = dataset.select(arguments.clips) if arguments.clips else dataset
    except KeyError as error:
        raise WorkspaceError(str(error.args[0])) from error
    return reread(dataset, change_of(arguments)) if _said(arguments) else dataset


def say_left_out(dataset: Dataset, quiet: bool = False) -> None:
    """Says on stderr which clips an analysis leaves out, for their bodies cannot be compared with the others."""
    if not quiet and (words := left_out(dataset)):
        print(f"note: {words}", file=sys.stderr)


def change_of(arguments: Namespace) -> Change:
    """What the options say about recordings that are there. Raises ParameterError, FormatError, OSError."""
    how = reading(arguments.unit, arguments.up, arguments.fps, arguments.body)
    return Change(how, guess_up=arguments.up == "auto", guess_unit=arguments.unit == "auto")


def _said(arguments: Namespace) -> bool:
    return any(getattr(arguments, name) is not None for name in ("unit", "up", "fps", "body"))


def refuse_reading_options(arguments: Namespace) -> None:
    """Raises WorkspaceError for options that only make sense while recordings are read."""
    given = [f"--{name}" for name in ("skeleton", "labels", "points", "smooth") if getattr(arguments, name) is not None]
    if given:
        raise WorkspaceError(f"{' and '.join(given)}: only for files; this dataset has been imported already.")
