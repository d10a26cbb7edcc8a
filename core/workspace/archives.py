"""Zip files of strangers: unpacked beside themselves, within limits, and never outside their folder.

What an archive says of itself is not believed: bytes are counted as they come out, names are cleaned like those of
uploads; links, and archives within archives, are left alone.
"""

from __future__ import annotations

import errno
import lzma
import shutil
import stat
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from core.mocap.files import files_below
from core.mocap.other_files import in_words, left_out_files
from core.mocap.readers import BESIDE, FORMATS
from core.mocap.reports import FileReport
from core.mocap.text import recording_format
from core.progress import Report
from core.workspace.errors import NameRefused, WorkspaceError
from core.workspace.names import inside
from core.workspace.uploads import MAX_BYTES, MAX_FILES, safe_parts

WANTED = (*FORMATS, *BESIDE)  # each with .gz as well
MAX_ENTRIES = 100_000  # listed in an archive, wanted or not
_FREE, _TIMES = (
    1 << 28,
    50,
)  # an archive may grow to 256 MB, or to 50 times its size; motion as text grows about fivefold
_CHUNK = 1 << 20
_SHOWN = 3
_DAMAGED = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError)


class Entry(NamedTuple):
    """A file of an archive and the folders and the name that it gets."""

    info: zipfile.ZipInfo
    parts: tuple[str, ...]


def unpack_archives(folder: Path, report: Report) -> tuple[FileReport, ...]:
    """Unpacks every ``.zip`` of an upload into a folder beside it and removes it; a report of each.

    Recordings, skeletons and CSV files are taken, everything else is left. Damaged files within an archive are named in
    its report. A damaged archive, or one that grows too large, is an "error" in its report and leaves nothing.
    Raises OSError (disk full), Cancelled from ``report``.
    """
    reports, room = [], MAX_BYTES
    for archive in [path for path in files_below(folder) if path.suffix.lower() == ".zip"]:
        target = _free_folder(archive)
        try:
            written, archive_report = _unpack(archive, target, room, report)
            room -= written
            archive.unlink()
        except WorkspaceError as error:
            shutil.rmtree(target, ignore_errors=True)
            archive_report = FileReport(archive.name, None, "error", (f"{archive.name}: {error}",))
        reports.append(archive_report)
    return tuple(reports)


def _unpack(archive: Path, target: Path, room: int, report: Report) -> tuple[int, FileReport]:
    """Bytes written, and what became of the files. Raises WorkspaceError: why the archive cannot be taken."""
    room, written = min(room, max(_FREE, _TIMES * archive.stat().st_size)), 0
    damaged: list[str] = []
    with _plain_faults(), zipfile.ZipFile(archive) as packed:
        entries, left = _choose(packed.infolist())
        for k, entry in enumerate(entries):
            report("Unpacking", k / len(entries))
            path = inside(target, *entry.parts)
            path.parent.mkdir(parents=True, exist_ok=True)
            try:
                with packed.open(entry.info) as source, path.open("xb") as file:
                    while chunk := source.read(_CHUNK):
                        written += len(chunk)
                        if written > room:
                            words = f"it grows beyond {room >> 20:,} MB; unpack it and add the recordings"
                            raise WorkspaceError(words)
                        file.write(chunk)
                        report("Unpacking", k / len(entries))
            except _DAMAGED:  # one file; the others may be whole
                path.unlink(missing_ok=True)
                damaged.append(entry.info.filename)
    whole = len(entries) - len(damaged)
    if not whole:
        raise WorkspaceError("the archive is damaged; pack the recordings again")
    left += [f"damaged in the archive and not taken: {_some(damaged)}"] if damaged else []
    count = f"{whole} files unpacked" if whole > 1 else "one file unpacked"
    doubtful = any(not message.endswith(" left out") for message in left)
    return written, FileReport(archive.name, None, "warning" if doubtful else "ok", (*left, count))


def _choose(infos: list[zipfile.ZipInfo]) -> tuple[list[Entry], list[str]]:
    """The files to unpack, and what is left in the archive although it might be missed; raises WorkspaceError."""
    if len(infos) > MAX_ENTRIES:
        raise WorkspaceError(f"it lists {len(infos):,} files; pack only the recordings")
    entries: list[Entry] = []
    taken: dict[str, int] = {}
    left: dict[str, list[str]] = {"links": [], "names that lead out of it": [], "archives within it": []}
    other: list[str] = []
    for info in infos:
        name = info.filename
        if info.is_dir() or any(part.startswith(".") or part == "__MACOSX" for part in name.split("/") if part != ".."):
            continue
        if name.lower().endswith(".zip"):
            left["archives within it"].append(name)
        elif recording_format(name)[1] not in WANTED:
            other.append(name)
        elif stat.S_ISLNK(info.external_attr >> 16):
            left["links"].append(name)
        elif (parts := _parts(name, taken)) is None:
            left["names that lead out of it"].append(name)
        else:
            entries.append(Entry(info, parts))
    messages = [f"left packed, {kind}: {_some(names)}" for kind, names in left.items() if names]
    not_read = left_out_files(other, WANTED)
    messages += [in_words(not_read)] if not_read else []
    if not entries:
        raise WorkspaceError("; ".join(["there is no recording, skeleton or CSV file in it", *messages]))
    if len(entries) > MAX_FILES:
        raise WorkspaceError(f"it holds {len(entries):,} recordings; an upload takes at most {MAX_FILES:,} files")
    if any(entry.info.flag_bits & 1 for entry in entries):
        raise WorkspaceError("it is locked with a password; unpack it and add the recordings")
    return entries, messages


def _parts(name: str, taken: dict[str, int]) -> tuple[str, ...] | None:
    """Where the file goes, in a numbered folder where that place is taken; None for a name that cannot be used."""
    try:
        parts = tuple(safe_parts(name))
    except NameRefused:
        return None
    place = "/".join(parts).casefold()
    number = taken.get(place, 1)  # the last one that was tried for this name
    free = parts
    while "/".join(free).casefold() in taken:
        number += 1
        free = (str(number), *parts)
    taken[place] = number
    taken.setdefault("/".join(free).casefold(), 1)
    return free


def _some(names: list[str]) -> str:
    shown = ", ".join("".join(c if c.isprintable() else "?" for c in name[:60]) for name in names[:_SHOWN])
    return shown + (f" and {len(names) - _SHOWN} more" if len(names) > _SHOWN else "")


def _free_folder(archive: Path) -> Path:
    """A folder named after the archive that is not there yet."""
    names = (archive.stem, *(f"{archive.stem} {k}" for k in range(2, MAX_FILES + 3)))
    return next(folder for name in names if not (folder := archive.with_name(name)).exists())


@contextmanager
def _plain_faults() -> Iterator[None]:
    """Faults of the archive inside the block as WorkspaceError."""
    try:
        yield
    except WorkspaceError:
        raise
    except UnicodeError as error:
        words = "the names of its files are not in UTF-8, although it says so; pack the recordings again"
        raise WorkspaceError(words) from error
    except (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, ValueError, OverflowError) as error:
        raise WorkspaceError("the archive is damaged; pack the recordings again") from error
    except OSError as error:
        if error.errno != errno.EINVAL:  # a full disk is no fault of the archive; a place before its beginning is
            raise
        raise WorkspaceError("the archive is damaged; pack the recordings again") from error
    except (NotImplementedError, RuntimeError) as error:  # methods and keys that the library does not know
        raise WorkspaceError("it is packed in a way we cannot read; pack it as a plain zip") from error
