"""Writes bundles."""

from __future__ import annotations

import hashlib
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from core import analyses
from core.bundles.manifest import FORMAT, MANIFEST, is_drawn, plain
from core.bundles.said import said_of
from core.errors import MotionscapeError
from core.export import FeatureParameters, feature_table, write_features
from core.export.features import labelled
from core.methods import METHODS
from core.mocap.dataset import Dataset
from core.mocap.files import replacing
from core.mocap.storage import save_dataset
from core.progress import Report, silent
from core.workspace import Workspace

_CHUNK = 1 << 20
_DATE = (1980, 1, 1, 0, 0, 0)  # of all files: the same state gives the same bundle
_MOST_JOBS = 20_000


def write_bundle(
    workspace: Workspace, name: str, out: str | Path, *, recordings: bool = True, report: Report = silent
) -> dict[str, Any]:
    """Writes the bundle of the data set ``name`` and gives its manifest. Raises WorkspaceError, OSError, Cancelled."""
    dataset = workspace.open(name)
    with tempfile.TemporaryDirectory(prefix="bundle-", dir=workspace.path / "uploads") as folder:
        root = Path(folder)
        report("collecting", 0.0)
        if recordings:
            save_dataset(root / "dataset", dataset)
        else:
            table = feature_table(dataset, FeatureParameters(), report)
            write_features(root / "features.npz", labelled(table, dataset))
        files = {path.relative_to(root).as_posix(): path for path in sorted(root.rglob("*")) if path.is_file()}
        files |= {f"results/{path.name}": path for path in _result_files(workspace, dataset)}
        for part, content in said_of(workspace, dataset).items():
            files[f"{part}.json"] = root / f"{part}.json"
            files[f"{part}.json"].write_text(plain(content), encoding="utf-8")
        return _pack(Path(out), dataset, files, recordings, report)


def _pack(out: Path, dataset: Dataset, files: Mapping[str, Path], recordings: bool, report: Report) -> dict[str, Any]:
    listed = {}
    for entry, path in files.items():
        with path.open("rb") as file:
            listed[entry] = {"sha256": hashlib.file_digest(file, "sha256").hexdigest(), "bytes": path.stat().st_size}
    manifest = {
        "format": FORMAT,
        "dataset": {"name": dataset.name, "fingerprint": dataset.fingerprint, "clips": len(dataset.clips)},
        "recordings": recordings,
        "files": listed,
    }
    with replacing(out) as fresh, zipfile.ZipFile(fresh, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr(zipfile.ZipInfo(MANIFEST, _DATE), plain(manifest), zipfile.ZIP_DEFLATED)
        for k, (entry, path) in enumerate(files.items()):
            report("packing", k / len(files))
            info = zipfile.ZipInfo(entry, _DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            with path.open("rb") as source, packed.open(info, "w", force_zip64=True) as target:
                while chunk := source.read(_CHUNK):
                    target.write(chunk)
                    report("packing", k / len(files))
    return manifest


def _result_files(workspace: Workspace, dataset: Dataset) -> list[Path]:
    """The files of its results: of finished jobs, of the usual requests, and those that name the data set."""
    jobs = workspace.jobs.list(_MOST_JOBS)
    keys = {job.key for job in jobs if job.state == "done" and job.request.get("fingerprint") == dataset.fingerprint}
    for method in METHODS:
        try:
            keys.add(analyses.key(workspace, analyses.Request(dataset.name, method)))
        except MotionscapeError:
            continue  # one that cannot be asked for without settings
    keys |= {
        key
        for key in workspace.results.all_keys()
        if key not in keys and workspace.results.names(key, dataset.fingerprint)
    }
    found = (workspace.results.file(key) for key in sorted(keys))
    return [path for path in found if path is not None and not is_drawn(workspace.results.check(path).document)]
