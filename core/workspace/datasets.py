"""Data sets on disk: a folder each under a random id; names, trash and counts are rows of the table.

A folder never changes once it is there: renaming touches a row only, and a changed data set gets a new folder, so that
running jobs keep reading what they have opened. What a data set was before its last change lies in the trash, so that
the change can be undone; results belong to the content and are found again with it.
"""

from __future__ import annotations

import json
import secrets
import shutil
import sqlite3
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from core.caching import RecentCache
from core.mocap.errors import RecordingError
from core.mocap.files import atomic_file, replacing, sweep_abandoned
from core.workspace.audit import record
from core.workspace.database import Database
from core.workspace.errors import NameRefused, WorkspaceError, plain_errors
from core.workspace.names import check_name, check_token, inside
from core.workspace.people import acting, require

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset

_CARD = "motionscape.json"  # beside the data: what the table knows, should the table be lost
_OPEN_AT_ONCE = 8
_ID = 16  # letters of an id; that of a version has those of its folder behind it
Fill = Callable[[Path, str], None]  # writes a data set of this name into this folder


@dataclass(frozen=True)
class DatasetInfo:
    """What the Library shows of a data set. ``seconds`` of motion; ``imported`` and ``trashed``: seconds since 1970.

    ``warnings`` and ``errors`` count files of the import report; ``id`` stays the same when the data set is renamed.
    """

    id: str
    name: str
    fingerprint: str
    folder: str
    clips: int
    frames: int
    seconds: float
    labels: int
    warnings: int
    errors: int
    imported: float
    trashed: float | None = None


class DatasetStore:
    """The data sets below one folder."""

    def __init__(self, folder: Path, bin_folder: Path, database: Database):
        self.folder, self._bin, self._database = folder, bin_folder, database
        self._opened: RecentCache[str, tuple[Dataset, int]] = RecentCache(_OPEN_AT_ONCE)
        if database.is_new:
            self._adopt()

    def list(self, *, trashed: bool = False) -> list[DatasetInfo]:
        """The data sets by name; or those in the trash, newest first."""
        order = (
            "trashed IS NOT NULL ORDER BY trashed DESC" if trashed else "trashed IS NULL ORDER BY name COLLATE NOCASE"
        )
        rows = self._database.rows(f"SELECT {_COLUMNS} FROM datasets WHERE {order}")
        return [info for info in (DatasetInfo(*row) for row in rows) if _may_see(info)]

    def info(self, name: str) -> DatasetInfo:
        """The data set called ``name``; raises WorkspaceError where there is none, naming those there are."""
        row = self._one("name = ? AND trashed IS NULL", str(name))
        if row is None or not _may_see(row):
            names = [info.name for info in self.list()]
            known = f"The datasets here are: {', '.join(names[:8])}" if names else "The workspace is empty"
            more = f" and {len(names) - 8} more." if len(names) > 8 else "."
            raise WorkspaceError(f"There is no dataset {str(name)[:80]!r}. {known}{more}")
        return row

    def with_fingerprint(self, fingerprint: str) -> DatasetInfo:
        """A data set with this content, also from the trash; raises WorkspaceError where there is none."""
        row = self._one("fingerprint = ? ORDER BY trashed IS NOT NULL", str(fingerprint))
        if row is None or not _may_see(row):
            raise WorkspaceError("The dataset was changed or removed since; start the analysis again.")
        return row

    def check_free(self, name: str) -> str:
        """``name`` in its final form; raises NameRefused where it cannot be used or another data set has it."""
        name = check_name(name)
        if self._one("name = ? AND trashed IS NULL", name):
            raise NameRefused(f"There is already a dataset {name!r}; choose another name or delete that one first.")
        return name

    def free_name(self, wanted: str) -> str:
        """``wanted``, with a number behind it where another data set has that name."""
        taken, base = {info.name for info in self.list()}, wanted[:90].rstrip(". ")
        return next(n for n in [wanted, *(f"{base} {i}" for i in range(2, len(taken) + 3))] if n not in taken)

    def open(self, info: DatasetInfo) -> Dataset:
        """The data set itself, its arrays memory-mapped; raises WorkspaceError where its files are damaged."""
        from core.mocap.storage import load_dataset, size_of_motion  # numba comes with it: only who opens data pays

        try:
            path = self._path(info.folder)
            dataset, size = self._opened.get_or_compute(info.folder, lambda: (load_dataset(path), size_of_motion(path)))
            if size_of_motion(path) != size:
                self._opened.discard(info.folder)
                raise RecordingError(path, "motion.npy has been cut off", "a whole dataset; import it again")
            return dataset
        except (OSError, RecordingError) as error:
            raise WorkspaceError(
                f"The stored dataset {info.name!r} cannot be opened, its files are damaged; import it again."
            ) from error

    def add(self, name: str, fill: Fill) -> DatasetInfo:
        """Stores under ``name`` what ``fill`` writes, whole or not at all. Raises NameRefused, WorkspaceError."""
        require("editor", to="add datasets")
        name = self.check_free(name)
        info = self._store(name, fill)
        try:
            with self._database.transaction(f"enter the dataset {name!r}") as table:
                _insert(table, info)
                record(table, "dataset added", name, f"{info.clips} clips")
        except WorkspaceError as error:
            shutil.rmtree(self._path(info.folder), ignore_errors=True)
            if isinstance(error.__cause__, sqlite3.IntegrityError):  # someone was faster
                self.check_free(name)
            raise
        return info

    def replace(self, info: DatasetInfo, fill: Fill) -> DatasetInfo:
        """Gives a data set new content in a new folder; what it was before goes into the trash (:meth:`revert`).

        Of one data set only the last such version is kept. Raises WorkspaceError, also where someone else has changed
        or deleted the data set meanwhile.
        """
        require("editor", info.id, to="change this dataset")
        new = replace(self._store(info.name, fill), id=info.id, imported=info.imported)
        old = replace(info, id=version_token(info), trashed=time.time())
        try:
            with self._database.transaction(f"change the dataset {info.name!r}") as table:
                row = table.execute(
                    "SELECT name FROM datasets WHERE id = ? AND folder = ? AND trashed IS NULL", (info.id, info.folder)
                ).fetchone()
                if row is None:
                    raise WorkspaceError(f"{info.name!r} was changed or deleted meanwhile; nothing was done.")
                new, old = replace(new, name=row["name"]), replace(old, name=row["name"])
                table.execute("DELETE FROM datasets WHERE id = ?", (info.id,))
                _insert(table, new)
                _insert(table, old)
                record(table, "dataset changed", new.name, f"{new.clips} clips, {new.labels} labels")
        except WorkspaceError:
            shutil.rmtree(self._path(new.folder), ignore_errors=True)
            raise
        self._write_card(new)
        self._write_card(old)
        self._delete("id GLOB ? AND id != ?", f"{info.id}?*", old.id)
        return new

    def last_version(self, info: DatasetInfo) -> str | None:
        """Token of what the data set was before its last change, for :meth:`revert`; None where that is not there."""
        row = self._one("id GLOB ? AND trashed IS NOT NULL", f"{info.id}?*")
        return row.id if row else None

    def revert(self, token: str) -> DatasetInfo:
        """Puts a version of a data set, in the trash since :meth:`replace`, into its place; the two change places.

        Raises WorkspaceError where the version, or the data set, is not there any more.
        """
        version = self._one("id = ? AND trashed IS NOT NULL", check_token(token, "version"))
        now = self._one("id = ? AND trashed IS NULL", token[:_ID])
        if version is None or now is None or not is_version(version):
            raise WorkspaceError("What it was before is no longer there.")
        require("editor", now.id, to="change this dataset")
        back = replace(version, id=now.id, name=now.name, trashed=None)
        gone = replace(now, id=version_token(now), trashed=time.time())
        with self._database.transaction(f"restore the dataset {now.name!r}") as table:
            table.execute("DELETE FROM datasets WHERE id IN (?, ?)", (version.id, now.id))
            _insert(table, back)
            _insert(table, gone)
            record(table, "dataset changed back", back.name, f"{back.clips} clips, {back.labels} labels")
        self._write_card(back)
        self._write_card(gone)
        return back

    def rename(self, name: str, new_name: str) -> DatasetInfo:
        """Renames a data set; raises NameRefused where the new name cannot be used or is taken."""
        info = self.info(name)
        require("editor", info.id, to="rename this dataset")
        new_name = check_name(new_name)
        if new_name == info.name:
            return info
        new_name = self.check_free(new_name)
        try:
            with self._database.transaction("rename the dataset") as table:
                table.execute("UPDATE datasets SET name = ? WHERE id = ?", (new_name, info.id))
                record(table, "dataset renamed", info.name, f"to {new_name}")
        except WorkspaceError as error:
            if isinstance(error.__cause__, sqlite3.IntegrityError):
                self.check_free(new_name)
            raise
        info = self.info(new_name)
        self._write_card(info)
        return info

    def trash(self, name: str) -> str:
        """Puts a data set into the trash; the token to restore it. Raises WorkspaceError where there is none."""
        info = self.info(name)
        require("editor", info.id, to="delete this dataset")
        self._set_trashed(info.id, time.time())
        return info.id

    def restore(self, token: str) -> DatasetInfo:
        """Takes a data set out of the trash; gets a number behind its name if that was taken meanwhile.

        Raises WorkspaceError where the trash has no such data set.
        """
        info = self._one("id = ? AND trashed IS NOT NULL", check_token(token, "trash token"))
        if info is None:
            raise WorkspaceError("This dataset is no longer in the trash.")
        require("editor", info.id, to="restore this dataset")
        fresh = secrets.token_hex(_ID // 2) if is_version(info) else info.id  # from now on a data set of its own
        self._set_trashed(info.id, None, self.free_name(info.name), fresh)
        return self.info_by_id(fresh)

    def info_by_id(self, dataset_id: str) -> DatasetInfo:
        """The data set with this id, also from the trash; raises WorkspaceError where there is none."""
        info = self._one("id = ?", str(dataset_id))
        if info is None:
            raise WorkspaceError("This dataset is no longer here.")
        return info

    def empty_trash(self) -> int:
        """Deletes for good what is in the trash; how many data sets that were. Raises WorkspaceError."""
        require("owner", to="empty the trash")
        gone = self._delete("trashed IS NOT NULL")
        for path in self._bin.iterdir():
            shutil.rmtree(path, ignore_errors=True)
        return gone

    def _delete(self, condition: str, *values: object) -> int:
        """Deletes those data sets of the trash for which ``condition`` holds; how many."""
        rows = self._database.rows(
            f"SELECT {_COLUMNS} FROM datasets WHERE trashed IS NOT NULL AND {condition}", *values
        )
        for info in (DatasetInfo(*row) for row in rows):
            with self._database.transaction("empty the trash") as table:
                removed = table.execute(
                    "DELETE FROM datasets WHERE id = ? AND trashed IS NOT NULL", (info.id,)
                ).rowcount
                if removed and not is_version(info):
                    record(table, "dataset deleted for good", info.name)
            if removed:
                self._discard(info)
        return len(rows)

    def _store(self, name: str, fill: Fill) -> DatasetInfo:
        from core.mocap.storage import load_dataset

        token = secrets.token_hex(8)
        with plain_errors(f"store the dataset {name!r}"):
            sweep_abandoned(self.folder)
            with replacing(self._path(token)) as folder:
                folder.mkdir(parents=True)
                fill(folder, name)
                info = _info(load_dataset(folder), name, token)
                (folder / _CARD).write_text(json.dumps(asdict(info)), encoding="utf-8")
        return info

    def _discard(self, info: DatasetInfo) -> None:
        self._opened.discard(info.folder)
        with suppress(OSError, NameRefused):  # first out of sight, then deleted: never half a data set among the others
            target = self._bin / info.folder
            self._path(info.folder).replace(target)
            shutil.rmtree(target, ignore_errors=True)

    def _set_trashed(self, dataset_id: str, when: float | None, name: str | None = None, new_id: str = "") -> None:
        with self._database.transaction("move the dataset to or from the trash") as table:
            table.execute(
                "UPDATE datasets SET trashed = ?, name = coalesce(?, name), id = ? WHERE id = ?",
                (when, name, new_id or dataset_id, dataset_id),
            )
            row = table.execute("SELECT name FROM datasets WHERE id = ?", (new_id or dataset_id,)).fetchone()
            record(table, "dataset restored" if when is None else "dataset deleted", row["name"] if row else dataset_id)
        self._write_card(self.info_by_id(new_id or dataset_id))

    def _write_card(self, info: DatasetInfo) -> None:
        with suppress(OSError, NameRefused):
            card = self._path(info.folder) / _CARD
            if card.parent.is_dir():  # else the data are lost, and a card alone would be no help
                with atomic_file(card) as file:
                    file.write(json.dumps(asdict(info)).encode())

    def _one(self, condition: str, *values: object) -> DatasetInfo | None:
        rows = self._database.rows(f"SELECT {_COLUMNS} FROM datasets WHERE {condition} LIMIT 1", *values)
        return DatasetInfo(*rows[0]) if rows else None

    def folder_of(self, info: DatasetInfo) -> Path:
        """Where the data of a data set lie; raises NameRefused where that is outside the workspace."""
        return self._path(info.folder)

    def _path(self, folder: str) -> Path:
        return inside(self.folder, check_token(folder, "dataset folder"))

    def _adopt(self) -> None:
        """Finds the data sets again after the table was lost."""
        with self._database.transaction("find the datasets") as table:
            for card in sorted(self.folder.glob(f"*/{_CARD}")):
                with suppress(OSError, ValueError, TypeError, sqlite3.IntegrityError):
                    _insert(table, _read_card(card))

    def adopt(self, folder: str) -> DatasetInfo | None:
        """Enters a data set of this folder that the table does not know; None where the folder holds none."""
        try:
            card = _read_card(self._path(folder) / _CARD)
            free = replace(card, name=self.free_name(card.name))
            with self._database.transaction(f"enter the dataset {free.name!r}") as table:
                _insert(table, free)
        except (OSError, ValueError, TypeError):
            return None
        self._write_card(free)
        return free


def _may_see(info: DatasetInfo) -> bool:
    """Whether who acts may see a data set: a guest sees those of the board whose link they have."""
    person = acting()
    return not person.is_guest or (info.trashed is None and info.name in person.datasets)


def version_token(info: DatasetInfo) -> str:
    """The id that this content of a data set gets in the trash once something else has taken its place."""
    return info.id[:_ID] + info.folder


def is_version(info: DatasetInfo) -> bool:
    """Whether it is an earlier version of another data set, rather than one of its own."""
    return len(info.id) > _ID


_FIELDS = tuple(DatasetInfo.__dataclass_fields__)
_COLUMNS = ", ".join(_FIELDS)


def _insert(table: sqlite3.Connection, info: DatasetInfo) -> None:
    marks = ", ".join("?" * len(_FIELDS))
    table.execute(f"INSERT INTO datasets ({_COLUMNS}) VALUES ({marks})", tuple(asdict(info).values()))


def _read_card(card: Path) -> DatasetInfo:
    """What a card says; raises OSError, TypeError, ValueError where it does not belong to its folder."""
    info = DatasetInfo(**json.loads(card.read_text(encoding="utf-8")))
    if card.parent.name != info.folder or check_name(info.name) != info.name:
        raise ValueError(f"{card} is of another dataset")
    return info


def _info(dataset: Dataset, name: str, folder: str) -> DatasetInfo:
    return DatasetInfo(
        id=secrets.token_hex(_ID // 2),
        name=name,
        fingerprint=dataset.fingerprint,
        folder=folder,
        clips=len(dataset.clips),
        frames=dataset.n_frames,
        seconds=dataset.seconds,
        labels=len(dataset.labels),
        warnings=dataset.report.count("warning"),
        errors=dataset.report.count("error"),
        imported=time.time(),
    )
