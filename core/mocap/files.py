"""Files that appear whole or not at all, and those that lie in a folder."""

from __future__ import annotations

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


def files_below(folder: str | Path) -> Iterator[Path]:
    """All files of a folder and below, folder by folder in the order of their names; hidden ones are left out."""
    for parent, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name != "__MACOSX")
        yield from (Path(parent, name) for name in sorted(names) if not name.startswith("."))


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A name beside ``path`` to write a file or a folder at; it takes the place of ``path`` when the block ends well.

    Where the block raises, what was written is removed and ``path`` stays as it was. Raises OSError as writing does.
    """
    path = Path(path)
    fresh = path.with_name(f".{path.name[:100]}.{os.getpid()}-{secrets.token_hex(4)}.tmp")
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
    finally:
        for left in (fresh, old):
            if left.is_dir():
                shutil.rmtree(left, ignore_errors=True)
            else:
                left.unlink(missing_ok=True)
