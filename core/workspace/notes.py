"""What people say of motifs: a name, tags, a note. It belongs to the frames of the motif's motions, not to its number,

so that it is found again when other settings, another seed or more clips number the motifs anew.
"""

from __future__ import annotations

import json
import sqlite3
import time
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import WorkspaceError
from core.workspace.people import require

if TYPE_CHECKING:
    from core.mocap.clip import Segment

LONGEST_NAME, LONGEST_NOTE, MOST_TAGS = 80, 4000, 20
SAME = 0.5  # share of frames in common, of those in either, from which on a motif is the one that was named


@dataclass(frozen=True)
class MotifNote:
    """A name, tags and a note. segments: (clip, start, end) of the motions that were named; ``carried``: the note was

    made for a motif of another result, of which this one has most of the frames.
    """

    name: str = ""
    tags: tuple[str, ...] = ()
    note: str = ""
    segments: tuple[tuple[str, int, int], ...] = ()
    changed: float = 0.0
    carried: bool = False

    @property
    def is_empty(self) -> bool:
        """Whether it says nothing at all."""
        return not (self.name or self.tags or self.note)


class Notes:
    """The notes of a workspace; a data set is known by its id, a result by its key."""

    def __init__(self, database: Database):
        self._database = database

    def put(
        self,
        dataset: str,
        result: str,
        motif: int,
        segments: Sequence[Segment],
        *,
        name: str = "",
        tags: Iterable[str] = (),
        note: str = "",
    ) -> MotifNote:
        """Writes what is said of a motif of a result; saying nothing removes it. Raises WorkspaceError (too long)."""
        require("editor", dataset, to="name motifs")
        plain = tuple((clip, start, end) for clip, start, end in segments)
        entry = MotifNote(_line(name), _tags(tags), str(note).strip(), plain, time.time())
        if len(entry.name) > LONGEST_NAME:
            raise WorkspaceError(f"A name has at most {LONGEST_NAME} letters; this one has {len(entry.name)}.")
        if len(entry.note) > LONGEST_NOTE:
            raise WorkspaceError(f"A note has at most {LONGEST_NOTE} letters; this one has {len(entry.note)}.")
        if len(entry.tags) > MOST_TAGS or any(len(tag) > LONGEST_NAME for tag in entry.tags):
            raise WorkspaceError(f"A motif has at most {MOST_TAGS} tags of at most {LONGEST_NAME} letters.")
        row = (dataset, result, int(motif), json.dumps(entry.segments), entry.name, json.dumps(entry.tags), entry.note)
        with self._database.transaction("keep the note") as table:
            record(table, "note written", entry.name or f"motif {motif}", f"motif {motif} of result {result[:12]}")
            if entry.is_empty:
                # An empty row hides a note that would be carried over; without one there is nothing to hide.
                others = table.execute("SELECT 1 FROM notes WHERE dataset = ? AND result != ? LIMIT 1", row[:2])
                if others.fetchone() is None:
                    table.execute("DELETE FROM notes WHERE dataset = ? AND result = ? AND motif = ?", row[:3])
                    return entry
            table.execute("REPLACE INTO notes VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?)", (*row, entry.changed))
        return entry

    def of(self, dataset: str, result: str, motifs: Mapping[int, Sequence[Segment]]) -> dict[int, MotifNote]:
        """What is said of each of these motifs: written for this very result, or carried over from another.

        motifs: motif id -> its segments, in frames of the clips' own rates. Motifs nobody spoke of are left out.
        """
        rows = self._database.rows("SELECT * FROM notes WHERE dataset = ? ORDER BY changed DESC", dataset)
        own = {row["motif"]: _read(row) for row in rows if row["result"] == result}
        others = [_read(row, carried=True) for row in rows if row["result"] != result]
        notes = {motif: note for motif, note in own.items() if motif in motifs}
        free = {motif: segments for motif, segments in motifs.items() if motif not in own}
        for note in others:
            overlaps = {motif: overlap(note.segments, segments) for motif, segments in free.items()}
            best = max(overlaps, key=overlaps.__getitem__, default=None)
            if best is not None and overlaps[best] >= SAME and not note.is_empty:
                notes[best] = note
                del free[best]
        return {motif: note for motif, note in notes.items() if not note.is_empty}

    def all(self, dataset: str) -> list[dict[str, Any]]:
        """All that is said of motifs of a data set, in a fixed order: result, motif, segments, name, tags, note."""
        rows = self._database.rows("SELECT * FROM notes WHERE dataset = ? ORDER BY result, motif", dataset)
        return [
            {
                "result": row["result"],
                "motif": row["motif"],
                "segments": json.loads(row["segments"]),
                "name": row["name"],
                "tags": json.loads(row["tags"]),
                "note": row["note"],
            }
            for row in rows
        ]

    def state(self, dataset: str) -> str:
        """A short text that changes whenever something is said of a motif of this data set, by one cheap query."""
        row = self._database.rows("SELECT COUNT(*), TOTAL(changed) FROM notes WHERE dataset = ?", dataset)[0]
        return f"{row[0]}.{row[1]:.3f}"

    def forget_deleted(self) -> None:
        """Removes what was said of data sets that are gone for good."""
        with self._database.transaction("forget old notes") as table:
            table.execute("DELETE FROM notes WHERE dataset NOT IN (SELECT id FROM datasets)")


def overlap(a: Sequence[tuple[str, int, int]], b: Sequence[tuple[str, int, int]]) -> float:
    """Frames in both sets of segments as a share of those in either; segments of a set do not overlap each other."""
    by_clip: dict[str, list[tuple[int, int]]] = {}
    for clip, start, end in b:
        by_clip.setdefault(clip, []).append((start, end))
    both = sum(
        max(0, min(end, other_end) - max(start, other_start))
        for clip, start, end in a
        for other_start, other_end in by_clip.get(clip, ())
    )
    either = sum(end - start for _, start, end in (*a, *b)) - both
    return both / either if either else 0.0


def _read(row: sqlite3.Row, carried: bool = False) -> MotifNote:
    segments = tuple((str(clip), int(start), int(end)) for clip, start, end in json.loads(row["segments"]))
    return MotifNote(row["name"], tuple(json.loads(row["tags"])), row["note"], segments, row["changed"], carried)


def _line(text: str) -> str:
    """One line of readable text."""
    text = unicodedata.normalize("NFC", str(text))
    return " ".join("".join(c if unicodedata.category(c)[0] != "C" else " " for c in text).split())


def _tags(tags: Iterable[str]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(filter(None, map(_line, tags))))
