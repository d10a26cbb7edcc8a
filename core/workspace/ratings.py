"""What people think of search results: ratings of a hit beside its query, and votes between two hits (PCR 5.3).

They belong to a data set (its id) and stay when the search runs again; a person may change their mind, so the newest
rating of a pair and the newest vote on two hits count.
"""

from __future__ import annotations

import io
import sqlite3
import time
from collections.abc import Sequence

from core.evaluation.agreement import LEAST, MOST, Rating, Vote
from core.mocap.clip import Segment
from core.spreadsheets import SheetWriter
from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import WorkspaceError
from core.workspace.people import require

CHOICES = ("left", "right", "same")
LONGEST_WORD = 200

_RATING_COLUMNS = ("query", "hit", "engine", "rank", "rating", "person", "changed")
_VOTE_COLUMNS = (
    *("query", "left", "right", "left_engine", "right_engine", "left_rank", "right_rank"),
    *("choice", "person", "changed"),
)


class Ratings:
    """The ratings and votes of a workspace; a data set is known by its id, a person by any word of the app's."""

    def __init__(self, database: Database):
        self._database = database

    def put_rating(
        self, dataset: str, query: Segment, hit: Segment, engine: str, rank: int, value: int, *, person: str = ""
    ) -> Rating:
        """Keeps a rating from 1 to 10, in the place of an earlier one of this person on this hit of this engine.

        rank: the hit's place in the engine's list, from 1. Raises WorkspaceError for what cannot be.
        """
        require("editor", dataset, to="rate hits")
        rating = Rating(_segment(query), _segment(hit), _word(engine), int(rank), int(value), _word(person))
        if not LEAST <= rating.value <= MOST or rating.rank < 1:
            raise WorkspaceError(f"A rating goes from {LEAST} to {MOST} and a rank from 1.")
        row = (dataset, *map(_text, rating[:2]), *rating[2:], time.time())
        with self._database.transaction("keep the rating") as table:
            record(table, "hit rated", _text(hit), f"{rating.value} of {MOST}")
            table.execute("REPLACE INTO ratings VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?)", row)
        return rating

    def put_vote(self, dataset: str, vote: Vote) -> Vote:
        """Keeps which of two hits is more like the query, in the place of this person's earlier vote on the two.

        Raises WorkspaceError for an unknown choice or two times the same hit of the same engine.
        """
        require("editor", dataset, to="rate hits")
        if vote.choice not in CHOICES:
            raise WorkspaceError(f"A vote is {', '.join(CHOICES)}, not {str(vote.choice)[:40]!r}.")
        first, second = (vote.left, vote.left_engine), (vote.right, vote.right_engine)
        if first == second or min(vote.left_rank, vote.right_rank) < 1:
            raise WorkspaceError("A vote is between two different hits, with ranks from 1.")
        kept = vote._replace(
            query=_segment(vote.query),
            left=_segment(vote.left),
            right=_segment(vote.right),
            left_engine=_word(vote.left_engine),
            right_engine=_word(vote.right_engine),
            person=_word(vote.person),
        )
        values = (*map(_text, kept[:3]), *kept[3:])
        turned = (values[0], values[2], values[1], values[4], values[3])  # the same two, shown the other way round
        with self._database.transaction("keep the vote") as table:
            record(table, "hits compared", _text(vote.query), kept.choice)
            table.execute(
                "DELETE FROM votes WHERE dataset = ? AND person = ? AND query = ? AND left_hit = ? AND right_hit = ? "
                "AND left_engine = ? AND right_engine = ?",
                (dataset, kept.person, *turned),
            )
            table.execute(
                "REPLACE INTO votes VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)", (dataset, *values, time.time())
            )
        return kept

    def list_ratings(self, dataset: str, *, person: str | None = None) -> list[Rating]:
        """The ratings of a data set, oldest first; of one person where one is given."""
        rows = self._database.rows("SELECT * FROM ratings WHERE dataset = ? ORDER BY changed, id", dataset)
        return [_rating(row) for row in rows if person is None or row["person"] == person]

    def list_votes(self, dataset: str, *, person: str | None = None) -> list[Vote]:
        """The votes of a data set, oldest first; of one person where one is given."""
        rows = self._database.rows("SELECT * FROM votes WHERE dataset = ? ORDER BY changed, id", dataset)
        return [_vote(row) for row in rows if person is None or row["person"] == person]

    def clear(self, dataset: str, *, person: str | None = None) -> int:
        """Removes the ratings and votes of a data set, or one person's; gives how many there were."""
        require("editor", dataset, to="remove ratings")
        with self._database.transaction("remove the ratings") as table:
            record(table, "ratings removed", dataset, person or "everyone's")
            return sum(
                table.execute(
                    f"DELETE FROM {kind} WHERE dataset = ? AND (? IS NULL OR person = ?)", (dataset, person, person)
                ).rowcount
                for kind in ("ratings", "votes")
            )

    def export_ratings(self, dataset: str) -> str:
        """The ratings as CSV; segments as ``CLIP:START-END``."""
        rows = self._database.rows("SELECT * FROM ratings WHERE dataset = ? ORDER BY changed, id", dataset)
        return _csv(_RATING_COLUMNS, [[_name(r["query"]), _name(r["hit"]), *tuple(r)[4:]] for r in rows])

    def export_votes(self, dataset: str) -> str:
        """The votes as CSV; segments as ``CLIP:START-END``."""
        rows = self._database.rows("SELECT * FROM votes WHERE dataset = ? ORDER BY changed, id", dataset)
        return _csv(_VOTE_COLUMNS, [[*map(_name, tuple(r)[2:5]), *tuple(r)[5:]] for r in rows])

    def forget_deleted(self) -> None:
        """Removes what was said of data sets that are gone for good."""
        with self._database.transaction("forget old ratings") as table:
            for kind in ("ratings", "votes"):
                table.execute(f"DELETE FROM {kind} WHERE dataset NOT IN (SELECT id FROM datasets)")


def _segment(segment: tuple[str, int, int]) -> Segment:
    clip, start, end = segment
    if not 0 <= int(start) < int(end):
        raise WorkspaceError(f"A segment ends after it starts, not {start} to {end}.")
    return Segment(str(clip), int(start), int(end))


def _word(text: str) -> str:
    text = " ".join(str(text).split())
    if len(text) > LONGEST_WORD:
        raise WorkspaceError(f"A name has at most {LONGEST_WORD} letters here.")
    return text


def _text(segment: Segment) -> str:
    """As the table holds it: frames first, as a clip's name may hold anything."""
    return f"{segment.start} {segment.end} {segment.clip}"


def _read(text: str) -> Segment:
    start, end, clip = text.split(" ", 2)
    return Segment(clip, int(start), int(end))


def _name(text: str) -> str:
    clip, start, end = _read(text)
    return f"{clip}:{start}-{end}"


def _rating(row: sqlite3.Row) -> Rating:
    return Rating(_read(row["query"]), _read(row["hit"]), row["engine"], row["rank"], row["rating"], row["person"])


def _vote(row: sqlite3.Row) -> Vote:
    return Vote(_read(row["query"]), _read(row["left_hit"]), _read(row["right_hit"]), *tuple(row)[5:11])


def _csv(columns: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    out = io.StringIO()
    writer = SheetWriter(out)
    writer.writerow(columns)
    # a spreadsheet takes a cell that begins so for a formula
    writer.writerows([["'" + c if isinstance(c, str) and c[:1] in "=+-@" else c for c in row] for row in rows])
    return out.getvalue()
