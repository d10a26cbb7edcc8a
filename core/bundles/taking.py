"""Takes bundles over, once everything in them has been checked."""

from __future__ import annotations

import hashlib
import json
import tempfile
import zipfile
import zlib
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import IO, Any, NamedTuple

from core.bundles.manifest import FORMAT, MANIFEST, is_drawn
from core.bundles.said import say
from core.mocap.dataset import Dataset, clip_digest
from core.mocap.errors import RecordingError
from core.mocap.storage import load_dataset
from core.progress import Report, silent
from core.workspace import NameRefused, Workspace, WorkspaceError
from core.workspace.names import check_name, check_token

MOST_FILES, LARGEST_MANIFEST, LARGEST = 20_000, 20_000_000, 40_000_000_000
_CHUNK = 1 << 20


class Taken(NamedTuple):
    """What was taken over: the name of the data set, whether it is new, and how many results, notes, views, boards."""

    dataset: str
    new: bool
    results: int
    notes: int
    views: int
    boards: int


def take_bundle(workspace: Workspace, path: str | Path, name: str | None = None, report: Report = silent) -> Taken:
    """Takes a bundle over. name: of the data set, where it is to have another than in the bundle.

    Raises WorkspaceError, before anything is kept, for what is no bundle, damaged, too large or not safe.
    """
    path = Path(path)
    with tempfile.TemporaryDirectory(prefix="bundle-", dir=workspace.path / "uploads") as folder:
        root = Path(folder)
        manifest = _unpacked(path, root, report)
        fingerprint = str(manifest["dataset"]["fingerprint"])
        dataset = _checked_dataset(root / "dataset", fingerprint, report) if manifest["recordings"] else None
        said = {part: _list(root / f"{part}.json") for part in ("notes", "views", "boards")}
        if "properties.json" in manifest["files"]:  # older bundles have none
            said["properties"] = _list(root / "properties.json")
        results = {_key(file): file for file in sorted((root / "results").glob("*"))}
        for file in results.values():
            if is_drawn(workspace.results.check(file).document):
                raise WorkspaceError(f"{path.name} holds something that a bundle does not: a drawing, in {file.name}.")
        wanted = check_name(name or str(manifest["dataset"]["name"]))
        own, new = _enter(workspace, dataset, fingerprint, wanted, report)
        added = 0
        for k, (key, file) in enumerate(results.items()):
            report("results", k / len(results))
            if not workspace.results.has(key):
                workspace.results.adopt(key, file)
                added += 1
        counts = say(workspace, own, str(manifest["dataset"]["name"]), said)
        return Taken(own, new, added, *counts)


def _unpacked(path: Path, root: Path, report: Report) -> dict[str, Any]:
    """The manifest; its files lie in ``root``, each as large and with the hash that it says. Raises WorkspaceError."""
    try:
        with zipfile.ZipFile(path) as packed:
            manifest = _manifest(packed, path.name)
            files = manifest["files"]
            names = [info.filename for info in packed.infolist()]
            if sorted(names) != sorted([MANIFEST, *files]):
                strange = sorted(set(names).symmetric_difference([MANIFEST, *files]))[:1] or ["a file twice"]
                raise WorkspaceError(f"{path.name} and its list of files do not agree: {strange[0][:80]!r}.")
            for k, (entry, listed) in enumerate(files.items()):
                report("unpacking", k / max(len(files), 1))
                target = _place(root, entry, path.name)
                with packed.open(entry) as source, target.open("xb") as file:
                    found = _copied(source, file, int(listed["bytes"]))
                if found != listed["sha256"]:
                    raise WorkspaceError(f"{path.name} is damaged: {entry[:80]} is not what it was. Get it once more.")
        return manifest
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError) as error:
        raise WorkspaceError(f"{path.name} is no zip, or a damaged one. Get it once more.") from error
    except OSError as error:
        raise WorkspaceError(f"{path.name} cannot be read: {error.strerror or error}.") from error
    except (KeyError, TypeError, AttributeError, ValueError) as error:
        if isinstance(error, WorkspaceError):
            raise
        raise WorkspaceError(f"{path.name} is no bundle of Motionscape: its list of files is incomplete.") from error


def _manifest(packed: zipfile.ZipFile, name: str) -> dict[str, Any]:
    try:
        info = packed.getinfo(MANIFEST)
    except KeyError:
        raise WorkspaceError(f"{name} is no bundle of Motionscape: it has no {MANIFEST}.") from None
    if info.file_size > LARGEST_MANIFEST:
        raise WorkspaceError(f"{name} is no bundle of Motionscape: its list of files is too long.")
    with packed.open(info) as file:
        manifest = json.loads(file.read(LARGEST_MANIFEST + 1))
    if not isinstance(manifest, dict) or manifest.get("format") != FORMAT:
        found = manifest.get("format") if isinstance(manifest, dict) else type(manifest).__name__
        raise WorkspaceError(f"{name} is no bundle that this version reads: it is {str(found)[:60]!r}, not {FORMAT!r}.")
    str(manifest["dataset"]["fingerprint"]), str(manifest["dataset"]["name"]), bool(manifest["recordings"])  # are there
    files = manifest["files"]
    if len(files) > MOST_FILES or sum(int(listed["bytes"]) for listed in files.values()) > LARGEST:
        raise WorkspaceError(f"{name} is larger than a bundle may be.")
    return manifest


def _place(root: Path, entry: str, name: str) -> Path:
    """Where a file of a bundle goes: only what a bundle has, and nowhere else."""
    parts = entry.split("/")
    known = entry in ("dataset/dataset.json", "dataset/motion.npy", "features.npz")
    known = known or entry in ("notes.json", "views.json", "boards.json", "properties.json")
    if not known and not (len(parts) == 2 and parts[0] == "results" and Path(parts[1]).suffix in (".json", ".npz")):
        raise WorkspaceError(f"{name} holds something that a bundle does not: {entry[:80]!r}.")
    if parts[0] == "results":
        _key(Path(parts[1]))
    target = root.joinpath(*parts)
    target.parent.mkdir(exist_ok=True)
    return target


def _copied(source: IO[bytes], target: IO[bytes], size: int) -> str:
    """The SHA-256 of what was copied: no more than ``size`` bytes and one."""
    digest, left = hashlib.sha256(), size + 1
    while left and (chunk := source.read(min(_CHUNK, left))):
        digest.update(chunk)
        target.write(chunk)
        left -= len(chunk)
    return digest.hexdigest() if left == 1 else "of another length"


def _key(file: Path) -> str:
    try:
        return check_token(file.stem, "result key")
    except NameRefused as error:
        raise WorkspaceError(f"The bundle holds a result under {file.name[:80]!r}, which is no key.") from error


def _checked_dataset(folder: Path, fingerprint: str, report: Report) -> Dataset:
    """The data set in a folder, whose content is what the bundle says. Raises WorkspaceError."""
    try:
        dataset = load_dataset(folder)
    except RecordingError as error:
        raise WorkspaceError(f"The recordings of the bundle cannot be read: {error}") from error
    digests = []
    for k, clip in enumerate(dataset.clips):
        report("checking", k / len(dataset.clips))
        digests.append(clip_digest(clip))
    if tuple(digests) != dataset.digests or dataset.fingerprint != fingerprint:
        raise WorkspaceError("The recordings of the bundle are not those that its results were made from.")
    return dataset


def _enter(
    workspace: Workspace, dataset: Dataset | None, fingerprint: str, wanted: str, report: Report
) -> tuple[str, bool]:
    """The name of the data set with this content, added where it is not there, and whether it was added."""
    there = [info.name for info in workspace.datasets() if info.fingerprint == fingerprint]
    if there:
        return (wanted if wanted in there else there[0]), False
    if dataset is None:
        raise WorkspaceError(
            "This bundle holds features and results without recordings, and the recordings they were made from are not "
            "in this workspace. Import those first, or ask for a bundle with recordings."
        )
    name = workspace.free_name(wanted)
    workspace.add_dataset(name, replace(dataset, name=name), report)
    return name, True


def _list(path: Path) -> list[dict[str, Any]]:
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise WorkspaceError(f"{path.name} of the bundle cannot be read.") from error
    if not isinstance(content, list) or not all(isinstance(entry, dict) for entry in content):
        raise WorkspaceError(f"{path.name} of the bundle is no list.")
    return content


def describe(taken: Taken) -> Iterator[str]:
    """What was taken over, for people."""
    yield f"{taken.dataset}: {'added' if taken.new else 'was here already'}"
    yield f"{taken.results} results, {taken.notes} notes, {taken.views} saved views, {taken.boards} boards added"
