"""What SOURCE means on the command line."""

from __future__ import annotations

from argparse import Namespace
from pathlib import Path

from core.mocap.dataset import Dataset, open_dataset
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


def open_source(arguments: Namespace, report: Report) -> Dataset:
    """The data set that ``arguments.source`` and the common options name.

    Raises WorkspaceError, RecordingError, ValueError or OSError in plain words.
    """
    named = named_dataset(arguments.source)
    if named is None:
        path = Path(arguments.source).expanduser()
        if not path.exists():
            raise WorkspaceError(f"{arguments.source}: no such file or folder, and no dataset of a workspace.")
        return open_dataset(
            path,
            skeleton=arguments.skeleton,
            fps=arguments.fps,
            clips=arguments.clips,
            labels=arguments.labels,
            report=report,
        )
    refuse_reading_options(arguments)
    workspace, name = named
    dataset = workspace.open(name)
    try:
        return dataset.select(arguments.clips) if arguments.clips else dataset
    except KeyError as error:
        raise WorkspaceError(str(error.args[0])) from error


def refuse_reading_options(arguments: Namespace) -> None:
    """Raises WorkspaceError for options that only make sense while recordings are read."""
    given = [f"--{name}" for name in ("skeleton", "fps", "labels") if getattr(arguments, name) is not None]
    if given:
        raise WorkspaceError(f"{' and '.join(given)}: only for files; this dataset has been imported already.")
