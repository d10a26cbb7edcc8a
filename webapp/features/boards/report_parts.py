"""What a report shows: the overview of a dataset, or the blocks of a board in reading order."""

from __future__ import annotations

from core.workspace import Board, DocumentGone, Workspace
from webapp.features.boards.documents import dataset_of, part_of
from webapp.features.boards.parts import OVERVIEW, Part


def asked_parts(board: Board | None, dataset: str) -> tuple[Part, ...]:
    """The parts of the report. Blocks that show another dataset stay, as a text that says so."""
    if board is None:
        return OVERVIEW
    blocks = sorted(board.blocks, key=lambda block: (block.y, block.x))
    return tuple(
        part_of(block) if dataset_of(board, block) in ("", dataset) else _elsewhere(part_of(block), dataset)
        for block in blocks
    )


def title_of(board: Board | None, dataset: str) -> str:
    """The title of the report."""
    return board.title if board else f"{dataset}: overview"


def board_called(workspace: Workspace, name: str) -> Board:
    """The board with this title or id, the newest of several. Raises DocumentGone, naming those that there are."""
    boards = workspace.boards.all()
    for board in boards:
        if name in (board.title, board.id):
            return board
    known = ", ".join(f"“{board.title}”" for board in boards[:8])
    raise DocumentGone(f"There is no board called “{name[:80]}”." + (f" There are {known}." if known else ""))


def _elsewhere(part: Part, dataset: str) -> Part:
    words = f"This block shows another dataset than “{dataset}”, and is not part of this report."
    return Part("text", part.title, options={"markdown": words}, columns=part.columns)
