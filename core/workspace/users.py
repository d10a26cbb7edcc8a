"""Accounts: names, roles and passwords (kept as scrypt hashes), and the secret that signs sessions."""

from __future__ import annotations

import hashlib
import hmac
import re
import secrets
import sqlite3
import time
from dataclasses import dataclass, field

from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import WorkspaceError
from core.workspace.people import ROLES, Person, require

SHORTEST_PASSWORD, LONGEST_PASSWORD = 8, 1000
_NAME = re.compile(r"\w[\w.@+-]{0,79}")
_COST = {"n": 2**15, "r": 8, "p": 1, "maxmem": 2**26}  # OWASP's advice for scrypt; about 0.1 s
_NO_PASSWORD = ""


@dataclass(frozen=True)
class Account:
    """An account. roles: name of a dataset -> the role there, where it is another; created: seconds since 1970."""

    name: str
    role: str
    created: float
    has_password: bool
    roles: dict[str, str] = field(default_factory=dict)


class Users:
    """The accounts of a workspace. Only owners may change them."""

    def __init__(self, database: Database):
        self._database = database

    def exist(self) -> bool:
        """Whether there are accounts at all."""
        return bool(self._database.rows("SELECT 1 FROM users LIMIT 1"))

    def list(self) -> list[Account]:
        """The accounts by name."""
        roles: dict[str, dict[str, str]] = {}
        for row in self._database.rows(
            "SELECT r.user, d.name, r.role FROM user_roles r JOIN datasets d ON d.id = r.dataset ORDER BY d.name"
        ):
            roles.setdefault(row[0], {})[row[1]] = row[2]
        rows = self._database.rows("SELECT name, role, created, password FROM users ORDER BY name")
        return [Account(row[0], row[1], row[2], bool(row[3]), roles.get(row[0], {})) for row in rows]

    def add(self, name: str, password: str | None, role: str = "editor") -> None:
        """A new account; without a password only a reverse proxy can sign it in. Raises WorkspaceError."""
        require("owner", to="add accounts")
        name, role = check_user_name(name), _role(role)
        hashed = _NO_PASSWORD if password is None else hash_password(password)
        with self._database.transaction("add the account") as table:
            if table.execute("SELECT 1 FROM users WHERE name = ?", (name,)).fetchone():
                raise WorkspaceError(f"There is an account {name!r} already.")
            table.execute("INSERT INTO users VALUES (?, ?, ?, 1, ?)", (name, role, hashed, time.time()))
            record(table, "account added", name, role)

    def remove(self, name: str) -> None:
        """Removes an account; its sessions end at once. Raises WorkspaceError where there is none."""
        require("owner", to="remove accounts")
        with self._database.transaction("remove the account") as table:
            name = _known(table, name)
            table.execute("DELETE FROM users WHERE name = ?", (name,))
            table.execute("DELETE FROM user_roles WHERE user = ?", (name,))
            record(table, "account removed", name)

    def set_role(self, name: str, role: str, dataset: str | None = None) -> None:
        """Gives an account a role, for one dataset (its name) where one is given. Raises WorkspaceError."""
        require("owner", to="change roles")
        role = _role(role)
        with self._database.transaction("change the role") as table:
            name = _known(table, name)
            if dataset is None:
                table.execute("UPDATE users SET role = ? WHERE name = ?", (role, name))
            else:
                query = "SELECT id FROM datasets WHERE name = ? AND trashed IS NULL"
                row = table.execute(query, (dataset,)).fetchone()
                if row is None:
                    raise WorkspaceError(f"There is no dataset {dataset[:80]!r}.")
                table.execute("REPLACE INTO user_roles VALUES (?, ?, ?)", (name, row["id"], role))
            record(table, "role changed", name, f"{role} of {dataset}" if dataset else role)

    def set_password(self, name: str, password: str) -> None:
        """Another password; sessions that were begun with the old one end. Raises WorkspaceError."""
        require("owner", to="set passwords")
        hashed = hash_password(password)
        with self._database.transaction("change the password") as table:
            name = _known(table, name)
            table.execute("UPDATE users SET password = ?, session = session + 1 WHERE name = ?", (hashed, name))
            record(table, "password changed", name)

    def person(self, name: str, session: int | None = None) -> Person | None:
        """Who acts under this account; None where there is none, or where ``session`` is from an older password."""
        rows = self._database.rows("SELECT name, role, session FROM users WHERE name = ?", name)
        if not rows or session not in (None, rows[0]["session"]):
            return None
        roles = self._database.rows("SELECT dataset, role FROM user_roles WHERE user = ?", rows[0]["name"])
        return Person(rows[0]["name"], rows[0]["role"], {row["dataset"]: row["role"] for row in roles})

    def sign_in(self, name: str, password: str) -> tuple[Person, int] | None:
        """Who has this name and password, and the number of their sessions; None where the two do not fit."""
        rows = self._database.rows("SELECT name, password, session FROM users WHERE name = ?", name)
        kept = str(rows[0]["password"]) if rows else _NO_PASSWORD
        fits = _fits(password[:LONGEST_PASSWORD], kept or _NOBODYS)  # the same work, whether or not there is an account
        person = self.person(rows[0]["name"]) if rows and kept and fits else None
        return (person, int(rows[0]["session"])) if person else None

    def secret(self) -> str:
        """What sessions are signed with; made once for the workspace."""
        with self._database.transaction("make the secret of the sessions") as table:
            table.execute("INSERT OR IGNORE INTO secrets VALUES ('sessions', ?)", (secrets.token_urlsafe(32),))
            return str(table.execute("SELECT value FROM secrets WHERE name = 'sessions'").fetchone()[0])


def check_user_name(name: str) -> str:
    """``name`` where it can be the name of an account; raises WorkspaceError."""
    if not _NAME.fullmatch(name):
        raise WorkspaceError(
            f"{name[:80]!r} cannot be the name of an account: letters, digits and . @ + - _ are allowed, at most 80."
        )
    return name


def hash_password(password: str) -> str:
    """The scrypt hash of a password with its salt and cost, as text; raises WorkspaceError (too short, too long)."""
    if not SHORTEST_PASSWORD <= len(password) <= LONGEST_PASSWORD:
        raise WorkspaceError(f"A password has {SHORTEST_PASSWORD} to {LONGEST_PASSWORD:,} letters.")
    salt = secrets.token_bytes(16)
    return f"scrypt${salt.hex()}${_scrypt(password, salt).hex()}"


def _scrypt(password: str, salt: bytes) -> bytes:
    return hashlib.scrypt(password.encode("utf-8", "surrogatepass"), salt=salt, dklen=32, **_COST)


def _fits(password: str, kept: str) -> bool:
    try:
        _, salt, expected = kept.split("$")
        return hmac.compare_digest(_scrypt(password, bytes.fromhex(salt)), bytes.fromhex(expected))
    except ValueError:  # a damaged row admits nobody
        return False


_NOBODYS = f"scrypt${'00' * 16}${'00' * 32}"


def _role(role: str) -> str:
    if role not in ROLES:
        raise WorkspaceError(f"A role is {', '.join(ROLES)}, not {role[:40]!r}.")
    return role


def _known(table: sqlite3.Connection, name: str) -> str:
    row = table.execute("SELECT name FROM users WHERE name = ?", (name,)).fetchone()
    if row is None:
        raise WorkspaceError(f"There is no account {name[:80]!r}.")
    return str(row["name"])
