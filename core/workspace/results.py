"""Results on disk, each under the hash of the request that it answers: JSON, or npz where it has arrays."""

from __future__ import annotations

import json
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from core.mocap.files import atomic_file, sweep_abandoned
from core.workspace.errors import ResultDamaged, plain_errors
from core.workspace.names import check_token, inside

_DOCUMENT = "document"  # the npz member that holds the JSON text as bytes


class Result(NamedTuple):
    """A stored result: a JSON document and named arrays of any shape (numbers only, never pickles)."""

    document: dict[str, Any]
    arrays: dict[str, np.ndarray]


class ResultStore:
    """Results below one folder. Files appear whole or not at all."""

    def __init__(self, folder: Path):
        self.folder = folder

    def has(self, key: str) -> bool:
        """Whether there is a result for ``key``; raises NameRefused for what is no key."""
        return self._find(key) is not None

    def get(self, key: str) -> Result | None:
        """The result for ``key``, or None. A damaged file is set aside and raises ResultDamaged."""
        path = self._find(key)
        if path is None:
            return None
        try:
            return _read_npz(path) if path.suffix == ".npz" else Result(_read_json(path), {})
        except FileNotFoundError:
            return None
        except OSError as error:
            with plain_errors("read the stored result"):
                raise error
        except Exception as error:  # numpy and zipfile raise all kinds of errors on damaged files
            with suppress(OSError):
                path.replace(path.with_name(f"{path.name}.damaged"))
            raise ResultDamaged(
                "The stored result is damaged and has been set aside; run the analysis again."
            ) from error

    def put(self, key: str, document: dict[str, Any], arrays: Mapping[str, np.ndarray] | None = None) -> None:
        """Stores a result atomically. ``arrays`` may have any shape (n, ...); raises WorkspaceError (disk full ...)."""
        text = json.dumps(document, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
        arrays = dict(arrays or {})
        if _DOCUMENT in arrays or any(a.dtype.hasobject for a in arrays.values()):
            raise ValueError(f"arrays of a result hold numbers, and none is called {_DOCUMENT!r}")
        path = self._path(key, ".npz" if arrays else ".json")
        with plain_errors("store the result"):
            sweep_abandoned(path.parent)
            with atomic_file(path) as file:
                if arrays:
                    entries: dict[str, Any] = {_DOCUMENT: np.frombuffer(text, np.uint8), **arrays}
                    np.savez(file, **entries)
                else:
                    file.write(text)

    def all_keys(self) -> Iterator[str]:
        """The keys of all results, in order."""
        for path in sorted(self.folder.glob("??/*")):
            if path.suffix in (".json", ".npz") and path.name.startswith(path.parent.name):
                yield path.stem

    def names(self, key: str, text: str) -> bool:
        """Whether the document of a result holds a text, such as a fingerprint; arrays are not read."""
        path = self._find(key)
        try:
            if path is None or path.suffix == ".json":
                return path is not None and text.encode() in path.read_bytes()
            with zipfile.ZipFile(path) as members:
                return text.encode() in members.read(f"{_DOCUMENT}.npy")
        except (OSError, KeyError, zipfile.BadZipFile, zlib.error):
            return False

    def file(self, key: str) -> Path | None:
        """The file of the result for ``key``, to be copied; None where there is none. Raises NameRefused."""
        return self._find(key)

    def adopt(self, key: str, source: Path) -> None:
        """Takes over the file of a result from elsewhere as it is, once it has been read; raises as :meth:`check`,
        WorkspaceError where it cannot be stored."""
        self.check(source)
        with plain_errors("store the result"), atomic_file(self._path(key, source.suffix)) as file:
            file.write(source.read_bytes())

    @staticmethod
    def check(source: Path) -> Result:
        """What a file from elsewhere holds; raises ResultDamaged where that is no result. Pickles are never read."""
        try:
            found = _read_npz(source) if source.suffix == ".npz" else Result(_read_json(source), {})
            if not isinstance(found.document, dict) or any(a.dtype.hasobject for a in found.arrays.values()):
                raise ValueError("no result")
            return found
        except Exception as error:  # numpy and zipfile raise all kinds of errors on damaged files
            raise ResultDamaged(f"{source.name} is damaged, or no result.") from error

    def remove(self, key: str) -> None:
        """Forgets the result for ``key``, if any; raises WorkspaceError when it cannot."""
        with plain_errors("remove the stored result"):
            for suffix in (".json", ".npz"):
                self._path(key, suffix).unlink(missing_ok=True)

    def _path(self, key: str, suffix: str) -> Path:
        key = check_token(key, "result key")
        return inside(self.folder, key[:2], key + suffix)

    def _find(self, key: str) -> Path | None:
        paths = (self._path(key, suffix) for suffix in (".npz", ".json"))
        return next((path for path in paths if path.is_file()), None)


def _read_json(path: Path) -> dict[str, Any]:
    document = json.loads(path.read_bytes())
    if not isinstance(document, dict):
        raise ValueError("a result is a JSON object")
    return document


def _read_npz(path: Path) -> Result:
    with np.load(path, allow_pickle=False) as members:
        arrays = {name: members[name] for name in members.files}
    return Result(json.loads(arrays.pop(_DOCUMENT).tobytes()), arrays)
