"""What jobs took: the experience by which the next ones are estimated (core.estimates)."""

from __future__ import annotations

import socket
import time
from typing import NamedTuple

from core.workspace.database import Database

_KEPT = 2000  # jobs; the oldest go
_LOOKED_AT = 12  # of them that an estimate rests on


class Cost(NamedTuple):
    """A job that ended well. fingerprint: of its dataset; amount: of work, in the units of core.estimates; seconds on
    the clock; bytes: the most memory it had for itself."""

    method: str
    fingerprint: str
    amount: float
    seconds: float
    bytes: float


class Costs:
    """The costs of a workspace's jobs, those of each machine by themselves. Methods raise WorkspaceError."""

    def __init__(self, database: Database):
        self._database = database

    def add(self, cost: Cost) -> None:
        """Keeps what a job took on this machine."""
        with self._database.transaction("note what the job took") as table:
            table.execute(
                "INSERT INTO costs (method, fingerprint, amount, seconds, bytes, host, at) "
                "VALUES (?, ?, ?, ?, ?, ?, ?)",
                (*cost, socket.gethostname(), time.time()),
            )
            table.execute("DELETE FROM costs WHERE id <= (SELECT max(id) FROM costs) - ?", (_KEPT,))

    def of(self, method: str) -> list[Cost]:
        """The newest costs of a method on this machine, newest first."""
        return self._read("method = ?", method)

    def newest(self) -> list[Cost]:
        """The newest costs of any method on this machine, newest first."""
        return self._read("1")

    def _read(self, condition: str, *values: object) -> list[Cost]:
        rows = self._database.rows(
            f"SELECT method, fingerprint, amount, seconds, bytes FROM costs WHERE host = ? AND {condition} "
            "ORDER BY id DESC LIMIT ?",
            socket.gethostname(),
            *values,
            _LOOKED_AT,
        )
        return [Cost(*row) for row in rows]
