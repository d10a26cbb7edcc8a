"""A workspace: one folder with data sets, results, uploads, the trash and the job table."""

from __future__ import annotations

import os
import threading
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from core.progress import Report, silent
from core.workspace.audit import Audit
from core.workspace.boards import Boards
from core.workspace.comments import Comments
from core.workspace.costs import Costs
from core.workspace.database import Database
from core.workspace.datasets import DatasetInfo, DatasetStore, Fill, version_token
from core.workspace.errors import WorkspaceError, plain_errors
from core.workspace.jobs import JobTable
from core.workspace.names import clean_name
from core.workspace.notes import Notes
from core.workspace.properties import PropertyStore
from core.workspace.ratings import Ratings
from core.workspace.readings import reading_of, recordings_of
from core.workspace.results import ResultStore
from core.workspace.uploads import Uploads
from core.workspace.users import Users
from core.workspace.views import Views

if TYPE_CHECKING:
    from core.editing.repairs import Repair
    from core.mocap.clip import Label
    from core.mocap.corrections import BodyCorrections
    from core.mocap.dataset import Dataset, ImportReport
    from core.mocap.reading import Change, Reading
    from core.workspace.importing import Recordings

TABLE = "workspace.sqlite"
Source = str | os.PathLike[str]


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
        self.costs = Costs(self._database)
        self.notes = Notes(self._database)
        self.ratings = Ratings(self._database)
        self.properties = PropertyStore(self._database)
        self.views = Views(self._database)
        self.boards = Boards(self._database)
        self.comments = Comments(self._database)
        self.users = Users(self._database)
        self.audit = Audit(self._database)

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
        unit: str | float | None = None,
        up: str | None = None,
        fps: float | None = None,
        body: Source | BodyCorrections | None = None,
        points: str | None = None,
        smooth: float | None = None,
        clips: Sequence[str] | None = None,
        labels: Source | None = None,
        report: Report = silent,
    ) -> ImportReport:
        """Reads recordings (files, or folders searched recursively) and stores them as the data set ``name``.

        A bad file among good ones is reported, not fatal. ``unit``, ``up``, ``fps``, ``body``: as in open_dataset; they
        are remembered with the clips, see :meth:`change_reading`. The report is kept with the data set. Raises
        NameRefused, WorkspaceError where no file can be read, ParameterError, FormatError (body corrections), or
        Cancelled from ``report``.
        """
        how = reading_of(unit, up, fps, body, points, smooth)
        what = recordings_of(sources, skeleton=skeleton, how=how, clips=clips, labels=labels)
        return self._add(name, lambda folder, name: _importing().store_recordings(folder, name, what, report))

    def add_files(
        self,
        name: str,
        sources: Source | Sequence[Source],
        *,
        skeleton: Source | None = None,
        unit: str | float | None = None,
        up: str | None = None,
        fps: float | None = None,
        body: Source | BodyCorrections | None = None,
        points: str | None = None,
        smooth: float | None = None,
        clips: Sequence[str] | None = None,
        labels: Source | None = None,
        replace_labels: bool = False,
        report: Report = silent,
    ) -> ImportReport:
        """Adds recordings, and the labels beside them, to the data set ``name``; :meth:`revert` undoes it.

        A clip whose name is taken gets a number behind it, one that is there already is left out.
        Corrections of bodies that the data set has count for what comes as well. ``replace_labels``: where labels
        come, those that are there go. Raises as :meth:`import_dataset`.
        """
        info = self.info(name)
        options = {
            "skeleton": skeleton,
            "how": reading_of(unit, up, fps, body, points, smooth),
            "clips": clips,
            "labels": labels,
        }
        what = recordings_of(sources, before=self.open(name), replace_labels=replace_labels, **options)
        return self._change(info, lambda folder, name: _importing().store_recordings(folder, name, what, report))

    def change_reading(
        self, name: str, change: Change, clips: Collection[str] | None = None, report: Report = silent
    ) -> ImportReport:
        """Changes unit, way up or frame rate of ``clips`` (all where None), or bodies, without importing again.

        Corrections of a body count for all clips of its rig. Labels stay with their frames; :meth:`revert` undoes it.
        Raises WorkspaceError for an unknown clip or where nothing changes, ParameterError for a correction that does
        not fit.
        """
        info, before = self.info(name), self.open(name)
        chosen = set(before.names if clips is None else clips)
        if unknown := sorted(chosen.difference(before.names)):
            raise WorkspaceError(f"There is no clip {unknown[0][:80]!r} in {name!r}.")
        return self._change(info, lambda folder, _: _importing().store_changed(folder, before, change, chosen, report))

    def repair(self, name: str, repairs: Mapping[str, Sequence[Repair]], report: Report = silent) -> ImportReport:
        """Repairs clips of the data set ``name``; ``repairs``: for each clip what is done, see core.editing.repairs.

        Labels move with their frames; :meth:`revert` undoes it. Raises WorkspaceError for an unknown clip or where
        there is nothing to do, ParameterError for a repair that cannot be made.
        """
        info, before = self.info(name), self.open(name)
        if unknown := sorted(repairs.keys() - set(before.names)):
            raise WorkspaceError(f"There is no clip {unknown[0][:80]!r} in {name!r}.")
        if not any(repairs.values()):
            raise WorkspaceError("There is nothing to repair.")
        return self._change(info, lambda folder, _: _importing().store_repaired(folder, before, repairs, report))

    def bodies(self, name: str) -> BodyCorrections:
        """Which joint of which rig of the data set ``name`` is which part of the body, one entry a rig.

        Raises WorkspaceError where there is no such data set.
        """
        from core.mocap.corrections import corrections_of

        return corrections_of(clip.skeleton for clip in self.open(name).clips)

    def add_labels(self, name: str, sources: Source | Sequence[Source], *, replace: bool = False) -> ImportReport:
        """Adds the rows of label files (CSV, or folders of them) that fit the clips of the data set ``name``.

        ``replace``: those that are there go. The report names the rows that do not fit; results stay valid, they belong
        to the motion. :meth:`revert` undoes it. Raises WorkspaceError where no row fits.
        """
        info, before = self.info(name), self.open(name)
        what = recordings_of(sources, before=before, replace_labels=replace)
        return self._relabel(info, *_importing().add_labels(before, what))

    def _relabel(self, info: DatasetInfo, labels: tuple[Label, ...], report: ImportReport) -> ImportReport:
        from core.mocap.storage import save_relabelled

        source = self._datasets.folder_of(info)
        return self._change(info, lambda folder, _: save_relabelled(folder, source, labels, report))

    def remove_clips(self, name: str, clips: Iterable[str], report: Report = silent) -> ImportReport:
        """Removes clips from the data set ``name``; :meth:`revert` undoes it.

        Raises WorkspaceError for an unknown clip, or all of them.
        """
        info, before, gone = self.info(name), self.open(name), set(clips)
        if unknown := sorted(gone.difference(before.names)):
            raise WorkspaceError(f"There is no clip {unknown[0][:80]!r} in {name!r}.")
        if gone.issuperset(before.names):
            raise WorkspaceError("These are all its clips; delete the dataset instead.")
        left = before.select(clip for clip in before.names if clip not in gone)
        files = tuple(file for file in before.report.files if file.clip not in gone)
        left = replace(left, report=replace(before.report, files=files))
        return self._change(info, lambda folder, _: _importing().store_dataset(folder, left, report))

    def add_clips(self, name: str, more: Dataset, report: Report = silent) -> ImportReport:
        """Adds clips that are in memory, with labels and report, to the data set ``name``; :meth:`revert` undoes it.

        Raises WorkspaceError where there is nothing to add or a clip of that name is there already.
        """
        info, before = self.info(name), self.open(name)
        if not more.clips:
            raise WorkspaceError("There are no clips to add.")
        if taken := sorted(set(more.names).intersection(before.names)):
            raise WorkspaceError(f"There is a clip {taken[0][:80]!r} in {name!r} already.")
        number = before.report.last_addition + 1
        files = (replace(file, addition=number) for file in more.report.files)
        both = replace(
            before,
            clips=(*before.clips, *more.clips),
            labels=(*before.labels, *more.labels),
            report=replace(before.report, files=(*before.report.files, *files)),
            digests=(*before.digests, *more.digests),
        )
        return self._change(info, lambda folder, _: _importing().store_dataset(folder, both, report))

    def version(self, name: str) -> str:
        """The token by which :meth:`revert` brings back what the data set ``name`` is now, after one change.

        Raises WorkspaceError where there is no such data set.
        """
        return version_token(self.info(name))

    def last_version(self, name: str) -> str | None:
        """The token that undoes the last change of the data set ``name``; None where there is nothing to undo.

        Raises WorkspaceError where there is no such data set.
        """
        return self._datasets.last_version(self.info(name))

    def revert(self, token: str) -> DatasetInfo:
        """Undoes the last change of a data set's content (:meth:`version`); its results are there again with it.

        Raises WorkspaceError where what it was before is no longer there.
        """
        return self._datasets.revert(token)

    def import_upload(
        self,
        name: str,
        upload: str,
        *,
        skeleton: str = "",
        labels: str = "",
        unit: str = "",
        up: str = "",
        fps: float | None = None,
        body: BodyCorrections | None = None,
        points: str = "",
        smooth: float | None = None,
        report: Report = silent,
    ) -> ImportReport:
        """Imports an upload as the data set ``name`` and then removes the upload.

        ``skeleton`` and ``labels`` name files of the upload; without them its only .asf serves all AMC files that have
        none, and its label files are found. Archives are unpacked. Raises as :meth:`import_dataset`, and NameRefused
        where a name leaves the upload.
        """
        self.check_free(name)
        what = self._unpacked(upload, skeleton, labels, reading_of(unit, up, fps, body, points, smooth), report)
        imported = self._add(name, lambda folder, name: _importing().store_recordings(folder, name, what, report))
        self.uploads.remove(upload)
        return imported

    def add_upload(
        self,
        name: str,
        upload: str,
        *,
        unit: str = "",
        up: str = "",
        fps: float | None = None,
        body: BodyCorrections | None = None,
        points: str = "",
        smooth: float | None = None,
        replace_labels: bool = False,
        report: Report = silent,
    ) -> ImportReport:
        """Adds an upload (recordings, label files or both) to the data set ``name`` and then removes the upload.

        Raises as :meth:`add_files` and :meth:`add_labels`.
        """
        info, before = self.info(name), self.open(name)
        what = self._unpacked(
            upload, "", "", reading_of(unit, up, fps, body, points, smooth), report, labels_alone=True
        )
        what = replace(what, before=before, replace_labels=replace_labels)
        if _importing().holds_recordings(what.sources[0]):
            added = self._change(info, lambda folder, name: _importing().store_recordings(folder, name, what, report))
        else:
            added = self._relabel(info, *_importing().add_labels(before, what))
        self.uploads.remove(upload)
        return added

    def _unpacked(
        self, upload: str, skeleton: str, labels: str, how: Reading, report: Report, labels_alone: bool = False
    ) -> Recordings:
        """What an upload holds once its archives are unpacked; raises WorkspaceError where no recording is in it."""
        from core.workspace.archives import unpack_archives

        folder = self.uploads.path(upload)
        with plain_errors("unpack the upload"):
            reports = unpack_archives(folder, report)
        if not labels_alone and not _importing().holds_recordings(folder):
            reasons = [message for file in reports if file.verdict != "ok" for message in file.messages]
            reasons += _importing().left_out_words(folder)
            raise WorkspaceError(
                " ".join(reasons) or "There is no recording among these files (BVH, or AMC with its ASF)."
            )
        given = self.uploads.file(upload, skeleton) if skeleton else _importing().only_skeleton(folder)
        chosen = self.uploads.file(upload, labels) if labels else None
        return recordings_of(folder, skeleton=given, how=how, labels=chosen, also=reports)

    def check_free(self, name: str) -> str:
        """``name`` in its final form; raises NameRefused where it cannot be used or is taken."""
        return self._datasets.check_free(name)

    def free_name(self, wanted: str) -> str:
        """A name for a new data set made from ``wanted`` (any text), with a number behind it where it is taken."""
        return self._datasets.free_name(clean_name(wanted, "recordings"))

    def add_dataset(self, name: str, dataset: Dataset, report: Report = silent) -> ImportReport:
        """Stores a data set that is in memory; raises NameRefused, WorkspaceError (no clips, disk full ...)."""
        return self._add(name, lambda folder, _: _importing().store_dataset(folder, dataset, report))

    def _add(self, name: str, fill: Fill) -> ImportReport:
        return self._datasets.open(self._datasets.add(name, fill)).report

    def _change(self, info: DatasetInfo, fill: Fill) -> ImportReport:
        return self._datasets.open(self._datasets.replace(info, fill)).report

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
        deleted = self._datasets.empty_trash()
        self.notes.forget_deleted()
        self.ratings.forget_deleted()
        self.properties.forget_deleted()
        return deleted

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


def _importing() -> ModuleType:
    """Reading and inspecting bring numba along, so they are imported when there is something to import."""
    from core.workspace import importing

    return importing
