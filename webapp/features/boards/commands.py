"""The command ``report``: a data set or a board as one file that others open without Motionscape."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from core import analyses
from core.workspace import Board, Workspace, WorkspaceError, atomic_file
from webapp.cli.progress_bar import progress_bar
from webapp.cli.sources import named_dataset

ALWAYS = ("motifs", "map")  # computed for a report where they are missing


def report(arguments: Namespace) -> int:
    """Writes the report. Raises WorkspaceError, AnalysisError or OSError in plain words."""
    from webapp.features.boards.printing import find_printer, write_pdf
    from webapp.features.boards.report import make_report
    from webapp.features.boards.report_parts import asked_parts, board_called, title_of

    suffix = arguments.out.suffix.lower()
    if suffix not in (".html", ".htm", ".pdf", ".zip") or arguments.out.is_dir():
        raise WorkspaceError(f"{arguments.out}: --out names a file .html, .pdf or .zip (a bundle).")
    workspace, name = _dataset(arguments.source)
    if suffix == ".zip":
        return _bundle(workspace, name, arguments)
    if arguments.features_only:
        raise WorkspaceError("--features-only: only for a bundle, with --out bundle.zip.")
    board = board_called(workspace, arguments.board) if arguments.board else None
    if suffix == ".pdf":
        find_printer()  # before anything is computed
    with progress_bar(arguments.quiet) as progress:
        for request in _missing(name, board):
            analyses.run(workspace, request, progress)
        made = make_report(workspace, name, asked_parts(board, name), title_of(board, name), progress)
    if not arguments.quiet:
        for sentence in made.left_out:
            print(f"left out: {sentence}", file=sys.stderr)
        print(f"{made.size / 1e6:.1f} MB. {made.motion}", flush=True)
    if suffix == ".pdf":
        write_pdf(made.html, arguments.out)
    else:
        _write(arguments.out, made.html)
    if not arguments.quiet:
        print(f"written to {arguments.out}")
    return 0


def import_bundle(arguments: Namespace) -> int:
    """Takes a bundle over. Raises WorkspaceError in plain words for what is none, or damaged."""
    from core.bundles import describe, take_bundle

    if not arguments.bundle.expanduser().is_file():
        raise WorkspaceError(f"{arguments.bundle}: no such file")
    with progress_bar(arguments.quiet) as progress:
        taken = take_bundle(Workspace(arguments.workspace), arguments.bundle.expanduser(), arguments.name, progress)
    if not arguments.quiet:
        print("\n".join(describe(taken)))
    return 0


def _bundle(workspace: Workspace, name: str, arguments: Namespace) -> int:
    from core.bundles import write_bundle

    if arguments.board:
        raise WorkspaceError("--board: a bundle holds all boards that show the dataset; leave it out.")
    with progress_bar(arguments.quiet) as progress:
        manifest = write_bundle(workspace, name, arguments.out, recordings=not arguments.features_only, report=progress)
    if not arguments.quiet:
        what = "features" if arguments.features_only else "recordings"
        results = sum(entry.startswith("results/") for entry in manifest["files"])
        print(f"{arguments.out.stat().st_size / 1e6:.1f} MB: {what}, {results} results, notes, views and boards")
        print(f"written to {arguments.out}")
    return 0


def _missing(name: str, board: Board | None) -> list[analyses.Request]:
    """What a report computes where it is not there: the usual results, or those that the blocks of a board show."""
    from webapp.features.boards.contents import request_of
    from webapp.features.boards.report_parts import asked_parts

    if board is None:
        return [analyses.Request(name, method) for method in ALWAYS]
    requests = [request_of(name, part) for part in asked_parts(board, name)]
    return [request for request in requests if request is not None]


def _dataset(source: str) -> tuple[Workspace, str]:
    named = named_dataset(source)
    if named is None:
        raise WorkspaceError(
            f"{source}: a report is made of a dataset of a workspace, WORKSPACE/NAME; import it first."
        )
    return named


def _write(path: Path, text: str) -> None:
    with atomic_file(path) as file:
        file.write(text.encode())
