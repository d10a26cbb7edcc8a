"""Checks everything in a workspace and repairs what can be repaired; nothing whole is touched.

Stop the server before a repair of the job table: the old file is set aside and a new one takes its place.
"""

from __future__ import annotations

import shutil
import sqlite3
import time
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from core.mocap.clip import Clip
from core.mocap.dataset import clip_digest
from core.mocap.files import TEMPORARY, remove
from core.progress import Report, silent
from core.workspace.database import TABLES
from core.workspace.datasets import DatasetInfo, is_version
from core.workspace.documents import Documents
from core.workspace.errors import ResultDamaged, WorkspaceError
from core.workspace.workspace import TABLE, Workspace, is_workspace

LEFT_AFTER = 3600.0  # seconds; a temporary file that nobody has touched for so long has lost its writer
_REBUILT = ("datasets", "jobs")  # tables that are not copied from a damaged file: read from disk; of past work only
_LITTLE_ROOM = 1 << 28


@dataclass(frozen=True)
class Problem:
    """Something that is wrong in a workspace. done: how it was repaired; advice: what a person can do about it."""

    what: str
    advice: str = ""
    done: str = ""

    @property
    def words(self) -> str:
        """The problem as one line."""
        return ". ".join(filter(None, [self.what, f"Repaired: {self.done}" if self.done else self.advice])) + "."


def examine(path: str | Path, repair: bool = False, report: Report = silent) -> list[Problem]:
    """Everything that is wrong in the workspace at ``path``; with ``repair`` mended where that is possible.

    Raises WorkspaceError where there is no workspace, or it cannot be written to.
    """
    path = Path(path).expanduser().absolute()
    if not is_workspace(path):
        raise WorkspaceError(f"{path} is no workspace: it has no {TABLE}.")
    report("the job table", 0.0)
    problems = list(_table(path, repair))
    if problems and not problems[-1].done:
        return problems  # nothing else can be looked up
    workspace = Workspace(path, create=False)
    with closing(workspace):
        for k, (part, check) in enumerate(_CHECKS.items()):
            report(part, (k + 1) / (len(_CHECKS) + 1))
            problems += check(workspace, repair)
    report("done", 1.0)
    return problems


def _table(path: Path, repair: bool) -> Iterator[Problem]:
    file = path / TABLE
    fault = _fault_of_table(file)
    if fault is None:
        return
    if not repair:
        yield Problem(f"{TABLE} is damaged ({fault})", "Stop the server and run this again with --repair")
        return
    aside = file.with_name(f"{TABLE}.damaged-{time.strftime('%Y%m%d-%H%M%S')}")
    for suffix in ("-wal", "-shm", ""):
        with suppress(FileNotFoundError):
            file.with_name(file.name + suffix).rename(aside.with_name(aside.name + suffix))
    with closing(Workspace(path)) as fresh:  # finds the datasets again
        found, kept = len(fresh.datasets()) + len(fresh.trashed()), _copy_rows(aside, file)
    done = f"{found} datasets were found on disk, {kept} rows of other tables were kept; the old file is {aside.name}"
    yield Problem(f"{TABLE} was damaged ({fault})", done=done)


def _fault_of_table(file: Path) -> str | None:
    try:
        with closing(sqlite3.connect(file, timeout=10.0)) as table:
            words = str(table.execute("PRAGMA integrity_check(1)").fetchone()[0])
            for name in TABLES:  # a file that was cut may look whole to SQLite
                table.execute(f"SELECT count(*) FROM {name}").fetchone()
    except sqlite3.DatabaseError as error:
        return None if "no such table" in str(error) else str(error)
    return None if words == "ok" else words.splitlines()[0]


def _copy_rows(damaged: Path, fresh: Path) -> int:
    """Copies what can be read of the tables that only the file holds; how many rows that were."""
    copied = 0
    with closing(sqlite3.connect(damaged)) as old, closing(sqlite3.connect(fresh)) as new:
        for name in TABLES:
            for row in _readable_rows(old, name) if name not in _REBUILT else ():
                with suppress(sqlite3.DatabaseError):
                    marks = ", ".join("?" * len(row))
                    copied += new.execute(f"INSERT OR IGNORE INTO {name} VALUES ({marks})", row).rowcount
        new.commit()
    return copied


def _readable_rows(table: sqlite3.Connection, name: str) -> list[tuple[object, ...]]:
    """The rows of a table as far as they can be read: a damaged page ends the reading, so from both ends."""
    rows: dict[int, tuple[object, ...]] = {}
    for order in ("ASC", "DESC"):
        with suppress(sqlite3.DatabaseError):
            for row in table.execute(f"SELECT rowid, * FROM {name} ORDER BY rowid {order}"):
                rows[row[0]] = row[1:]
    return [rows[k] for k in sorted(rows)]


def _datasets(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    for info in workspace.datasets():
        try:
            damaged = _damaged_clips(workspace, info)
        except WorkspaceError:
            advice, done = "Import it again", ""
            if repair:
                workspace.trash(info.name)
                done = "it is in the trash; import it again"
            yield Problem(f"The dataset {info.name!r} cannot be opened, its files are damaged", advice, done)
            continue
        if damaged:
            words = f"{len(damaged)} of {info.clips} clips of {info.name!r} are not what was imported: {_some(damaged)}"
            yield Problem(words, "Import them again", _without(workspace, info, damaged) if repair else "")


def _damaged_clips(workspace: Workspace, info: DatasetInfo) -> list[str]:
    """The clips whose motion is not the one that was stored. Raises WorkspaceError where nothing can be read."""
    dataset = workspace.open(info.name)
    pairs = zip(dataset.clips, dataset.digests, strict=True)
    return [
        clip.name
        for clip, digest in pairs
        if clip_digest(clip) != digest or not all(np.isfinite(part).all() for part in _arrays(clip))
    ]


def _arrays(clip: Clip) -> list[np.ndarray]:
    return [clip.root_positions, clip.rotations, *clip.translations.values()]


def _without(workspace: Workspace, info: DatasetInfo, clips: list[str]) -> str:
    if len(clips) == info.clips:
        workspace.trash(info.name)
        return "it is in the trash; import it again"
    workspace.remove_clips(info.name, clips)
    return "they were removed from it; what it was before is in the trash until the next change"


def _folders(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    """Datasets that the table does not know, or knows and the disk has not."""
    known = {info.folder: info for info in (*workspace.datasets(), *workspace.trashed())}
    parts = workspace.path / "datasets"
    for folder in sorted(path for path in parts.iterdir() if path.is_dir() and not path.name.startswith(".")):
        if folder.name in known:
            continue
        done = ""
        if repair:
            info = workspace._datasets.adopt(folder.name)
            done = f"it is here again as {info.name!r}" if info else ""
        yield Problem(f"The folder datasets/{folder.name} is in no list", "Import its recordings again", done)
    for info in workspace.trashed():
        if not (parts / info.folder).is_dir() and not is_version(info):
            yield Problem(f"The dataset {info.name!r} in the trash has lost its files", "Empty the trash")


def _results(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    for key in workspace.results.all_keys():
        file = workspace.results.file(key)
        try:
            if file is not None:
                workspace.results.check(file)
        except ResultDamaged:
            if repair:
                workspace.results.remove(key)
            done = "it was removed and is computed again when it is asked for" if repair else ""
            yield Problem(f"The result {key} is damaged", "Run this with --repair; it is computed again", done)


def _leftovers(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    """What processes that were ended have left: temporary files, and results that were set aside."""
    patterns = (f"datasets/{TEMPORARY}*", f"results/*/{TEMPORARY}*", f"uploads/**/{TEMPORARY}*", "results/*/*.damaged")
    left = [path for pattern in patterns for path in workspace.path.glob(pattern) if _is_old(path)]
    if left:
        if repair:
            for path in left:
                remove(path)
        done = "they were removed" if repair else ""
        yield Problem(f"{len(left)} temporary or damaged files are left over", "Run this with --repair", done)


def _is_old(path: Path) -> bool:
    with suppress(OSError):
        return time.time() - path.lstat().st_mtime > LEFT_AFTER or path.suffix == ".damaged"
    return False


def _jobs(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    if gone := workspace.jobs.bury_dead():  # as everyone does who looks at the jobs
        yield Problem(f"The workers of {gone} running jobs are gone", done="these jobs can be started again")


def _documents(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    for word, store in (("view", workspace.views), ("board", workspace.boards)):
        for id in store.damaged():
            version = _restored(store, id) if repair else 0
            done = f"version {version} was restored" if version else ""
            yield Problem(f"The {word} {id} cannot be read", "Run this with --repair, or delete it in the app", done)


def _restored(store: Documents[Any], id: str) -> int:
    """Brings back the newest version that can be read; its number, 0 where none can."""
    for change in sorted(store.history(id), key=lambda change: -change.version):
        with suppress(WorkspaceError):
            store.restore(id, change.version, "doctor")
            return change.version
    return 0


def _room(workspace: Workspace, repair: bool) -> Iterator[Problem]:
    free = shutil.disk_usage(workspace.path).free
    if free < _LITTLE_ROOM:
        yield Problem(f"Only {free >> 20} MB are free on the disk of the workspace", "Free some space")


def _some(names: list[str]) -> str:
    return ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


_CHECKS: dict[str, Callable[[Workspace, bool], Iterator[Problem]]] = {
    "folders": _folders,
    "datasets": _datasets,
    "results": _results,
    "left-over files": _leftovers,
    "jobs": _jobs,
    "views and boards": _documents,
    "room": _room,
}
