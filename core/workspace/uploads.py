"""Uploaded files: each upload is a folder under a random token, until it is imported or given up."""

from __future__ import annotations

import re
import secrets
import shutil
import threading
import time
from collections.abc import Iterable
from contextlib import suppress
from pathlib import Path

from core.mocap.files import atomic_file
from core.workspace.errors import NameRefused, WorkspaceError, plain_errors
from core.workspace.names import check_token, clean_name, inside

MAX_FILES = 5000
MAX_BYTES = 4 * 1024**3  # of one upload
ABANDONED_AFTER = 3 * 24 * 3600.0
_MAX_DEPTH = 8


class Uploads:
    """The uploads of one workspace. Names come from strangers: they are cleaned and stay inside the upload's folder."""

    def __init__(self, folder: Path):
        self.folder = folder
        self._sizes: dict[str, tuple[int, int]] = {}  # by token; looked up once, then kept up to date
        self._lock = threading.Lock()

    def create(self) -> str:
        """A new, empty upload; its token."""
        token = secrets.token_hex(16)
        with plain_errors("start an upload"):
            self._sweep()
            (self.folder / token).mkdir(parents=True)
        return token

    def path(self, token: str) -> Path:
        """The folder of an upload; raises NameRefused for what is no token, WorkspaceError where it does not exist."""
        path = inside(self.folder, check_token(token, "upload"))
        if not path.is_dir():
            raise WorkspaceError("This upload is no longer here; upload the files again.")
        return path

    def file(self, token: str, name: str) -> Path:
        """A file of an upload by the name it was given; raises NameRefused, WorkspaceError where it is not there."""
        path = inside(self.path(token), *safe_parts(name))
        if not path.is_file():
            raise WorkspaceError(f"The upload has no file {path.name!r}.")
        return path

    def add(self, token: str, name: str, chunks: Iterable[bytes]) -> Path:
        """Writes one file of an upload from its chunks; ``name`` may have folders (``walks/a.bvh``).

        A file appears whole or not at all. Raises NameRefused, or WorkspaceError where the upload grows beyond
        MAX_FILES files or MAX_BYTES bytes, or the disk is full.
        """
        folder = self.path(token)
        target = inside(folder, *safe_parts(name))
        n_files, n_bytes = self.size(token)
        if n_files >= MAX_FILES:
            raise WorkspaceError(f"An upload takes at most {MAX_FILES} files; import these first.")
        room, written = MAX_BYTES - n_bytes, 0
        with plain_errors(f"store {target.name}"), atomic_file(target) as file:
            for chunk in chunks:
                written += len(chunk)
                if written > room:
                    raise WorkspaceError(f"An upload takes at most {MAX_BYTES / 1024**3:.0f} GB; import these first.")
                file.write(chunk)
        with self._lock:
            n_files, n_bytes = self._sizes.get(token, (0, 0))  # gone where it was removed meanwhile
            self._sizes[token] = n_files + 1, n_bytes + written
        return target

    def size(self, token: str) -> tuple[int, int]:
        """Number of files of an upload and their bytes; a file sent again counts again. Raises as :meth:`path`."""
        folder = self.path(token)
        with self._lock:
            if token not in self._sizes:
                sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
                self._sizes[token] = len(sizes), sum(sizes)
            return self._sizes[token]

    def remove(self, token: str) -> None:
        """Removes an upload and its files, if it is there. Raises NameRefused for what is no token."""
        shutil.rmtree(inside(self.folder, check_token(token, "upload")), ignore_errors=True)
        with self._lock:
            self._sizes.pop(token, None)

    def _sweep(self) -> None:
        for path in self.folder.iterdir() if self.folder.is_dir() else ():
            with suppress(OSError):
                if time.time() - path.stat().st_mtime > ABANDONED_AFTER:
                    shutil.rmtree(path)


def safe_parts(name: str) -> list[str]:
    """The folders and the file name of an uploaded file's name, cleaned; raises NameRefused for ``..`` and the like."""
    if not isinstance(name, str) or "\0" in name or len(name) > 1000:
        raise NameRefused("This file name cannot be used.")
    parts = re.split(r"[/\\]", name)
    if ".." in parts or not parts[0] or re.fullmatch(r"[A-Za-z]:.*", parts[0]):
        raise NameRefused("A file name must not be absolute or contain '..'.")
    cleaned = [clean_name(part) for part in parts if part not in ("", ".")]
    if not cleaned or len(cleaned) > _MAX_DEPTH:
        raise NameRefused(f"A file name needs at least one part and at most {_MAX_DEPTH}.")
    return cleaned
