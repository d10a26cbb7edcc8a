"""Files that appear whole or not at all, and those that lie in a folder."""

from __future__ import annotations

import os
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

TEMPORARY = ".tmp-"
ABANDONED_AFTER = 24 * 3600.0  # seconds; a temporary file this old has lost its writer


def files_below(folder: str | Path) -> Iterator[Path]:
    """All files of a folder and below, folder by folder in the order of their names; hidden ones are left out."""
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name != "__MACOSX")
        yield from (Path(parent, name) for name in sorted(names) if not name.startswith("."))


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A name beside ``path`` to write a file or a folder at; it takes the place of ``path`` when the block ends well.

    Where the block raises, what was written is removed and ``path`` stays as it was. Missing folders are made. A link
    is followed, and a device or a pipe (/dev/null, /dev/stdout) is written to as it is. Raises OSError as writing does,
    about ``path``.
    """
    given_name, path = str(path), Path(os.path.realpath(path))
    if path.exists() and not path.is_file() and not path.is_dir():
        yield path
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    fresh = path.with_name(f"{TEMPORARY}{secrets.token_hex(8)}")
    old = path.with_name(fresh.name + ".old")
    try:
        yield fresh
        if path.is_dir() and fresh.is_dir():  # a folder cannot be replaced in one step
            path.rename(old)
            try:
                fresh.rename(path)
            except OSError:
                old.rename(path)
                raise
        else:
            fresh.replace(path)
    except OSError as error:
        if error.filename == str(fresh):  # a name that nobody gave
            error.filename = given_name
        raise
    finally:
        for left in (fresh, old):
            remove(left)


@contextmanager
def atomic_file(path: str | Path) -> Iterator[BinaryIO]:
    """Opens a file for binary writing that is on the disk, at ``path``, only when the block has ended well.

    Raises OSError as usual (disk full, no permission); then nothing has changed at ``path``. See :func:`replacing`.
    """
    with replacing(path) as fresh, fresh.open("wb") as file:
        yield file
        file.flush()
        if fresh.is_file():  # not a device or a pipe
            os.fsync(file.fileno())


def sweep_abandoned(folder: Path, older_than: float = ABANDONED_AFTER) -> int:
    """Removes temporary files and folders in ``folder`` that no writer has touched for ``older_than`` seconds."""
    removed = 0
    for path in folder.glob(f"{TEMPORARY}*"):
        with suppress(OSError):
            if time.time() - path.stat().st_mtime > older_than:
                remove(path)
                removed += 1
    return removed


def remove(path: Path) -> None:
    """Removes a file, or a folder with all that is in it, as far as that is possible."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        with suppress(OSError):
            path.unlink(missing_ok=True)
