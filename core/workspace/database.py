"""The workspace's SQLite file: one connection a thread, write-ahead logging, short transactions.

Write-ahead logging needs memory that all processes share, so machines that share a folder use a rollback journal
(https://www.sqlite.org/wal.html); which of the two it is stands in the file.
"""

from __future__ import annotations

import os
import re
import sqlite3
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from core.workspace.errors import plain_errors

SCHEMA = """
CREATE TABLE IF NOT EXISTS datasets (
    id TEXT PRIMARY KEY, name TEXT NOT NULL, fingerprint TEXT NOT NULL, folder TEXT NOT NULL,
    clips INTEGER NOT NULL, frames INTEGER NOT NULL, seconds REAL NOT NULL, labels INTEGER NOT NULL,
    warnings INTEGER NOT NULL, errors INTEGER NOT NULL, imported REAL NOT NULL, trashed REAL
);
CREATE UNIQUE INDEX IF NOT EXISTS dataset_names ON datasets (name) WHERE trashed IS NULL;
CREATE TABLE IF NOT EXISTS jobs (
    id INTEGER PRIMARY KEY AUTOINCREMENT, key TEXT NOT NULL, request TEXT NOT NULL, title TEXT NOT NULL,
    state TEXT NOT NULL DEFAULT 'queued', stage TEXT NOT NULL DEFAULT '', fraction REAL NOT NULL DEFAULT 0,
    cancel REAL, created REAL NOT NULL, started REAL, finished REAL, heartbeat REAL NOT NULL,
    pid INTEGER, born REAL, host TEXT, error TEXT NOT NULL DEFAULT '', died INTEGER NOT NULL DEFAULT 0,
    expected TEXT NOT NULL DEFAULT '', held TEXT NOT NULL DEFAULT ''
);
CREATE UNIQUE INDEX IF NOT EXISTS one_flight ON jobs (key) WHERE state IN ('queued', 'running') AND cancel IS NULL;
CREATE TABLE IF NOT EXISTS costs (
    id INTEGER PRIMARY KEY AUTOINCREMENT, method TEXT NOT NULL, fingerprint TEXT NOT NULL, amount REAL NOT NULL,
    seconds REAL NOT NULL, bytes REAL NOT NULL, host TEXT NOT NULL, at REAL NOT NULL
);
CREATE TABLE IF NOT EXISTS notes (
    id INTEGER PRIMARY KEY AUTOINCREMENT, dataset TEXT NOT NULL, result TEXT NOT NULL, motif INTEGER NOT NULL,
    segments TEXT NOT NULL, name TEXT NOT NULL, tags TEXT NOT NULL, note TEXT NOT NULL, changed REAL NOT NULL,
    UNIQUE (dataset, result, motif)
);
CREATE TABLE IF NOT EXISTS ratings (
    id INTEGER PRIMARY KEY AUTOINCREMENT, dataset TEXT NOT NULL, query TEXT NOT NULL, hit TEXT NOT NULL,
    engine TEXT NOT NULL, rank INTEGER NOT NULL, rating INTEGER NOT NULL, person TEXT NOT NULL, changed REAL NOT NULL,
    UNIQUE (dataset, person, query, hit, engine)
);
CREATE TABLE IF NOT EXISTS votes (
    id INTEGER PRIMARY KEY AUTOINCREMENT, dataset TEXT NOT NULL, query TEXT NOT NULL, left_hit TEXT NOT NULL,
    right_hit TEXT NOT NULL, left_engine TEXT NOT NULL, right_engine TEXT NOT NULL, left_rank INTEGER NOT NULL,
    right_rank INTEGER NOT NULL, choice TEXT NOT NULL, person TEXT NOT NULL, changed REAL NOT NULL,
    UNIQUE (dataset, person, query, left_hit, right_hit, left_engine, right_engine)
);
CREATE INDEX IF NOT EXISTS jobs_by_state ON jobs (state, id);
CREATE TABLE IF NOT EXISTS documents (
    kind TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL, created REAL NOT NULL, deleted REAL,
    PRIMARY KEY (kind, id)
);
CREATE TABLE IF NOT EXISTS document_versions (
    kind TEXT NOT NULL, id TEXT NOT NULL, version INTEGER NOT NULL, document TEXT NOT NULL, author TEXT NOT NULL,
    saved REAL NOT NULL, what TEXT NOT NULL, PRIMARY KEY (kind, id, version)
);
CREATE TABLE IF NOT EXISTS comments (
    id TEXT PRIMARY KEY, place TEXT NOT NULL, text TEXT NOT NULL, author TEXT NOT NULL, created REAL NOT NULL,
    updated REAL NOT NULL, version INTEGER NOT NULL, resolved INTEGER NOT NULL, parent TEXT, deleted REAL
);
CREATE INDEX IF NOT EXISTS comments_by_place ON comments (place);
CREATE TABLE IF NOT EXISTS users (
    name TEXT PRIMARY KEY COLLATE NOCASE, role TEXT NOT NULL, password TEXT NOT NULL, session INTEGER NOT NULL,
    created REAL NOT NULL
);
CREATE TABLE IF NOT EXISTS user_roles (
    user TEXT NOT NULL COLLATE NOCASE, dataset TEXT NOT NULL, role TEXT NOT NULL, PRIMARY KEY (user, dataset)
);
CREATE TABLE IF NOT EXISTS secrets (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS audit (
    id INTEGER PRIMARY KEY AUTOINCREMENT, at REAL NOT NULL, who TEXT NOT NULL, what TEXT NOT NULL,
    subject TEXT NOT NULL, details TEXT NOT NULL
);
CREATE INDEX IF NOT EXISTS audit_by_what ON audit (what, id);
"""
_LATER = {"jobs": ("expected TEXT NOT NULL DEFAULT ''", "held TEXT NOT NULL DEFAULT ''")}
"""Columns that tables of older workspaces lack."""

TABLES = tuple(re.findall(r"CREATE TABLE IF NOT EXISTS (\w+)", SCHEMA))


class Database:
    """Transactions on the SQLite file at ``path``; safe from any thread and after a fork."""

    def __init__(self, path: Path, patience: float = 10.0):
        self.path, self.patience, self._local = path, patience, threading.local()
        with plain_errors("open the job table"):
            connection = self._connection()
            if not connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]:
                _set_journal(connection, "wal", patience)
        with self.transaction("open the job table") as table:
            present = {row[0] for row in table.execute("SELECT name FROM sqlite_master WHERE type = 'table'")}
            for statement in SCHEMA.split(";"):
                table.execute(statement)
            for name, columns in _LATER.items():
                there = {row["name"] for row in table.execute(f"PRAGMA table_info({name})")}
                for column in columns:
                    if column.split()[0] not in there:
                        table.execute(f"ALTER TABLE {name} ADD COLUMN {column}")
        self.is_new = "datasets" not in present

    @contextmanager
    def transaction(self, doing: str) -> Iterator[sqlite3.Connection]:
        """A write transaction, committed when the block ends well; raises WorkspaceError that begins with ``doing``."""
        with plain_errors(doing):
            connection = self._connection()
            connection.execute("BEGIN IMMEDIATE")
            try:
                yield connection
                connection.execute("COMMIT")
            except BaseException:
                if connection.in_transaction:
                    connection.execute("ROLLBACK")
                raise

    def rows(self, query: str, *values: object) -> list[sqlite3.Row]:
        """All rows of a reading query; raises WorkspaceError when the table is busy or damaged."""
        with plain_errors("read the job table"):
            return self._connection().execute(query, values).fetchall()

    def share_between_machines(self) -> None:
        """Makes the file one that several machines may use; raises WorkspaceError where others have it open."""
        with plain_errors("make the job table one for several machines (others have it open)"):
            _set_journal(self._connection(), "delete", self.patience)

    def close(self) -> None:
        """Closes this thread's connection."""
        connection = getattr(self._local, "connection", None)
        if connection is not None and self._local.pid == os.getpid():
            connection.close()
        self._local.connection = None

    def _connection(self) -> sqlite3.Connection:
        local = self._local
        if getattr(local, "connection", None) is None or local.pid != os.getpid():
            # A connection must not cross a fork, nor be closed there: the child keeps the old one untouched.
            local.inherited = getattr(local, "connection", None)
            local.connection, local.pid = _connect(self.path, self.patience), os.getpid()
        connection: sqlite3.Connection = local.connection
        return connection


def _connect(path: Path, patience: float) -> sqlite3.Connection:
    connection = sqlite3.connect(path, timeout=patience, isolation_level=None)
    connection.row_factory = sqlite3.Row
    connection.execute("PRAGMA synchronous = NORMAL")
    return connection


def _set_journal(connection: sqlite3.Connection, mode: str, patience: float) -> None:
    deadline = time.monotonic() + patience
    while connection.execute("PRAGMA journal_mode").fetchone()[0] != mode:
        try:
            connection.execute(f"PRAGMA journal_mode = {mode}")
        except sqlite3.OperationalError:  # another process switches at once, or reads: SQLite does not wait here
            if time.monotonic() > deadline:
                raise
            time.sleep(0.02)
