"""A workspace: one folder with data sets, results, uploads, the trash and the job table."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from core.progress import Report, silent
from core.workspace.database import Database
from core.workspace.datasets import DatasetInfo, DatasetStore
from core.workspace.errors import WorkspaceError, plain_errors
from core.workspace.jobs import JobTable
from core.workspace.names import clean_name
from core.workspace.results import ResultStore
from core.workspace.uploads import Uploads

if TYPE_CHECKING:
    from core.mocap.dataset import Dataset, ImportReport

TABLE = "workspace.sqlite"
Source = str | Path


class Workspace:
    """The workspace in the folder ``path``, which is made where it is missing (``create=False`` refuses instead).

    Safe to use from several threads and processes at once. Nothing outside the folder is read or written through names
    that come from people; only the sources of an import, which the caller chooses, lie elsewhere.
    Raises WorkspaceError where the folder cannot be used.
    """

    def __init__(self, path: Source, *, create: bool = True):
        self.path = Path(path).expanduser().absolute()
        if self.path.exists() and not self.path.is_dir():
            raise WorkspaceError(f"{self.path} is a file; a workspace is a folder.")
        if not create and not is_workspace(self.path):
            raise WorkspaceError(f"{self.path} is no workspace: it has no {TABLE}.")
        with plain_errors(f"use the workspace {self.path}"):
            for part in ("datasets", "results", "uploads", "trash", "logs"):
                (self.path / part).mkdir(parents=True, exist_ok=True)
        self._database = Database(self.path / TABLE)
        self._datasets = DatasetStore(self.path / "datasets", self.path / "trash", self._database)
        self.results = ResultStore(self.path / "results")
        self.uploads = Uploads(self.path / "uploads")
        self.jobs = JobTable(self._database)

    @property
    def logs(self) -> Path:
        """Folder of the log files: tracebacks stand here and nowhere else."""
        return self.path / "logs"

    def datasets(self) -> list[DatasetInfo]:
        """The data sets, by name; those in the trash are left out."""
        return self._datasets.list()

    def info(self, name: str) -> DatasetInfo:
        """What the table knows of the data set ``name``; raises WorkspaceError where there is none."""
        return self._datasets.info(name)

    def open(self, name: str) -> Dataset:
        """The data set ``name``, arrays memory-mapped; raises WorkspaceError where there is none or it is damaged."""
        info = self._datasets.info(name)
        return replace(self._datasets.open(info), name=info.name)

    def open_fingerprint(self, fingerprint: str) -> Dataset:
        """The data set with this content, whatever it is called now; raises WorkspaceError where there is none."""
        info = self._datasets.with_fingerprint(fingerprint)
        return replace(self._datasets.open(info), name=info.name)

    def report(self, name: str) -> ImportReport:
        """The import report of the data set ``name``; raises WorkspaceError where there is none."""
        return self.open(name).report

    def import_dataset(
        self,
        name: str,
        sources: Source | Sequence[Source],
        *,
        skeleton: Source | None = None,
        fps: float | None = None,
        clips: Sequence[str] | None = None,
        labels: Source | None = None,
        report: Report = silent,
    ) -> ImportReport:
        """Reads recordings (files, or folders searched recursively) and stores them as the data set ``name``.

        A bad file among good ones is reported, not fatal. ``fps``: frames per second of AMC files. The report is kept
        with the data set. Raises NameRefused, WorkspaceError where no file can be read, or Cancelled from ``report``.
        """
        name = self._datasets.check_free(name)
        dataset = _read(sources, name, skeleton=skeleton, fps=fps, clips=clips, labels=labels, report=report)
        return self.add_dataset(name, dataset, report)

    def import_upload(
        self,
        name: str,
        upload: str,
        *,
        skeleton: str = "",
        labels: str = "",
        fps: float | None = None,
        report: Report = silent,
    ) -> ImportReport:
        """Imports an upload as the data set ``name`` and then removes the upload.

        ``skeleton`` and ``labels`` name files of the upload; without ``labels`` any CSV file in it is read as labels.
        Raises as :meth:`import_dataset`, and NameRefused where a name leaves the upload.
        """
        folder = self.uploads.path(upload)
        if not labels and any(folder.rglob("*.csv")):
            labels = "."
        imported = self.import_dataset(
            name,
            folder,
            skeleton=self.uploads.file(upload, skeleton) if skeleton else None,
            labels=folder if labels == "." else self.uploads.file(upload, labels) if labels else None,
            fps=fps,
            report=report,
        )
        self.uploads.remove(upload)
        return imported

    def check_free(self, name: str) -> str:
        """``name`` in its final form; raises NameRefused where it cannot be used or is taken."""
        return self._datasets.check_free(name)

    def free_name(self, wanted: str) -> str:
        """A name for a new data set made from ``wanted`` (any text), with a number behind it where it is taken."""
        return self._datasets.free_name(clean_name(wanted, "recordings"))

    def add_dataset(self, name: str, dataset: Dataset, report: Report = silent) -> ImportReport:
        """Stores a data set that is in memory; raises NameRefused, WorkspaceError (no clips, disk full ...)."""
        if not dataset.clips:
            raise WorkspaceError(f"Nothing to store as {name!r}: {_why_empty(dataset)}")
        self._datasets.add(name, dataset, report)
        return dataset.report

    def rename(self, name: str, new_name: str) -> DatasetInfo:
        """Renames a data set; raises WorkspaceError where there is none, NameRefused for a bad or taken name."""
        return self._datasets.rename(name, new_name)

    def trash(self, name: str) -> str:
        """Puts a data set into the trash; the token for :meth:`restore`. Raises WorkspaceError where there is none."""
        return self._datasets.trash(name)

    def trashed(self) -> list[DatasetInfo]:
        """The data sets in the trash, newest first; their ``id`` is the token for :meth:`restore`."""
        return self._datasets.list(trashed=True)

    def restore(self, token: str) -> DatasetInfo:
        """Takes a data set out of the trash; raises WorkspaceError where it is not there any more."""
        return self._datasets.restore(token)

    def empty_trash(self) -> int:
        """Deletes what is in the trash for good; how many data sets. Raises WorkspaceError."""
        return self._datasets.empty_trash()

    def close(self) -> None:
        """Closes this thread's connection to the table."""
        self._database.close()


def is_workspace(path: Source) -> bool:
    """Whether the folder ``path`` holds a workspace."""
    return (Path(path).expanduser() / TABLE).is_file()


_OPEN: dict[Path, Workspace] = {}
_OPENING = threading.Lock()


def shared_workspace(path: Source) -> Workspace:
    """The process's one Workspace for ``path``, so that opened data sets are shared; raises WorkspaceError."""
    key = Path(path).expanduser().resolve()
    with _OPENING:
        if key not in _OPEN:
            _OPEN[key] = Workspace(key)
        return _OPEN[key]


def _read(sources: Source | Sequence[Source], name: str, **options: object) -> Dataset:
    from core.mocap.dataset import open_dataset  # numba comes with it: only who reads recordings pays

    paths = [sources] if isinstance(sources, str | Path) else list(sources)
    if not paths:
        raise WorkspaceError("Nothing to import: name at least one file or folder.")
    return open_dataset(paths[0] if len(paths) == 1 else paths, name=name, on_error="report", **options)


def _why_empty(dataset: Dataset) -> str:
    bad = [file for file in dataset.report.files if file.verdict == "error"]
    if not bad:
        return "there are no recordings (.bvh, .amc) in what was given."
    reasons = "; ".join(" ".join(file.messages) or str(file.path) for file in bad[:3])
    more = f"; and {len(bad) - 3} more" if len(bad) > 3 else ""
    return f"none of the {len(bad)} files can be read: {reasons}{more}"
