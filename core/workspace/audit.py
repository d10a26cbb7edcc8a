"""The audit log: who changed what when."""

from __future__ import annotations

import sqlite3
import time
from dataclasses import dataclass

from core.workspace.database import Database
from core.workspace.people import name_on_record

KEPT = 100_000  # entries; the oldest go first
LONGEST = 300  # letters of a subject or its details


@dataclass(frozen=True)
class Entry:
    """One change. when: seconds since 1970; what: such as "dataset deleted"; subject: which one, by its name."""

    when: float
    who: str
    what: str
    subject: str
    details: str


def record(table: sqlite3.Connection, what: str, subject: object, details: object = "") -> None:
    """Notes a change that who acts is making, within the transaction that makes it."""
    row = (time.time(), name_on_record(), what, str(subject)[:LONGEST], str(details)[:LONGEST])
    done = table.execute("INSERT INTO audit (at, who, what, subject, details) VALUES (?, ?, ?, ?, ?)", row)
    table.execute("DELETE FROM audit WHERE id <= ?", ((done.lastrowid or 0) - KEPT,))


class Audit:
    """The audit log of a workspace."""

    def __init__(self, database: Database):
        self._database = database

    def record(self, what: str, subject: object, details: object = "") -> None:
        """Notes something that happened outside of a change of the workspace's database, such as a sign-in."""
        with self._database.transaction("write the audit log") as table:
            record(table, what, subject, details)

    def entries(self, newest: int | None = None) -> list[Entry]:
        """The entries, oldest first; of these the ``newest`` so many, where a number is given."""
        rows = self._database.rows(
            "SELECT at, who, what, subject, details FROM audit ORDER BY id DESC LIMIT ?",
            -1 if newest is None else newest,
        )
        return [Entry(*row) for row in reversed(rows)]

    def newest(self, of: str) -> int:
        """Number of the newest entry about ``of`` ("dataset", "job"); 0 where there is none. It never goes back."""
        rows = self._database.rows("SELECT max(id) FROM audit WHERE what >= ? AND what < ?", f"{of} ", f"{of}!")
        return int(rows[0][0] or 0)

    def who_started(self, job: int) -> str:
        """Who started the job with this number; empty where that is not known."""
        rows = self._database.rows(
            "SELECT who FROM audit WHERE what = 'job started' AND details = ? ORDER BY id DESC LIMIT 1", f"job {job}"
        )
        return str(rows[0]["who"]) if rows else ""
